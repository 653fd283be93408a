# Every package that sweepkit stands on; scripts/setup installs them on Debian 12.
find_package(glm REQUIRED)
find_package(OpenMesh REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenImageIO REQUIRED)
find_package(TBB REQUIRED)
find_package(hwy REQUIRED)
find_package(CLI11 REQUIRED)
find_package(pugixml REQUIRED)
find_package(Boost REQUIRED)
find_package(embree 3 QUIET)

# svgpp is headers on Boost, without a CMake package of its own.
find_path(SVGPP_INCLUDE_DIR svgpp/parser/path_data.hpp REQUIRED)
add_library(svgpp::svgpp INTERFACE IMPORTED)
target_include_directories(svgpp::svgpp SYSTEM INTERFACE ${SVGPP_INCLUDE_DIR})
target_link_libraries(svgpp::svgpp INTERFACE Boost::headers)

# libcsv brings no package file of its own; who links the installed sweepkit::scene finds it by the same module.
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
find_package(CSV REQUIRED)

# Debian's OpenImageIO names an include folder (opencv4) that its packages do not bring: keep those that exist.
get_target_property(folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
set(existing)
foreach(folder IN LISTS folders)
  if(EXISTS "${folder}")
    list(APPEND existing "${folder}")
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${existing}")

# xxHash is used by its header alone, without a CMake package of its own.
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
add_library(xxhash::header INTERFACE IMPORTED)
target_include_directories(xxhash::header SYSTEM INTERFACE ${XXHASH_INCLUDE_DIR})
target_compile_definitions(xxhash::header INTERFACE XXH_INLINE_ALL)

# Duktape brings no CMake package; the program alone draws with it.
find_path(DUKTAPE_INCLUDE_DIR duktape.h REQUIRED)
find_library(DUKTAPE_LIBRARY duktape REQUIRED)
add_library(duktape::duktape UNKNOWN IMPORTED)
set_target_properties(duktape::duktape PROPERTIES IMPORTED_LOCATION ${DUKTAPE_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${DUKTAPE_INCLUDE_DIR})
