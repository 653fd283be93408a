# What `cmake --install` puts where. The program and its image module are the component `program`; the libraries, their
# public headers and the CMake package are `development`. The image module lies in lib/sweepkit whatever the
# system calls its folder of libraries: the program looks for it from its own place.
set(SWEEPKIT_PACKAGE_FOLDER lib/cmake/sweepkit)
include(CMakePackageConfigHelpers)

# sweepkit_install(<name>): the library sweepkit::<name> with its public headers, and a file of targets of its own, so
# that who links one library needs the packages of that one alone.
function(sweepkit_install name)
  install(TARGETS sweepkit_${name} EXPORT sweepkit-${name} ARCHIVE DESTINATION lib COMPONENT development)
  install(EXPORT sweepkit-${name} NAMESPACE sweepkit:: DESTINATION ${SWEEPKIT_PACKAGE_FOLDER} COMPONENT development)
  install(DIRECTORY include/sweepkit DESTINATION include COMPONENT development)
endfunction()

# What find_package(sweepkit) reads, and what goes with the program.
function(sweepkit_install_package)
  set(SWEEPKIT_HAS_EMBREE ${embree_FOUND})
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/sweepkit-config.cmake.in ${PROJECT_BINARY_DIR}/sweepkit-config.cmake
                                INSTALL_DESTINATION ${SWEEPKIT_PACKAGE_FOLDER} NO_SET_AND_CHECK_MACRO)
  # 0.x promises nothing from one minor version to the next.
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/sweepkit-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(
    FILES ${PROJECT_BINARY_DIR}/sweepkit-config.cmake ${PROJECT_BINARY_DIR}/sweepkit-config-version.cmake
          ${PROJECT_SOURCE_DIR}/cmake/FindCSV.cmake
    DESTINATION ${SWEEPKIT_PACKAGE_FOLDER}
    COMPONENT development)
  install(TARGETS sweepkit RUNTIME DESTINATION bin COMPONENT program)
  sweepkit_install_notices()
endfunction()

# The licence, and the notices of the packages whose code is compiled in, as the building system has them.
function(sweepkit_install_notices)
  file(READ ${PROJECT_SOURCE_DIR}/LICENSE SWEEPKIT_LICENSE)
  # As Debian has it: the text alone, indented, a dot for an empty line.
  string(REGEX REPLACE "^MIT License\n\nCopyright [^\n]*\n\n|\n$" "" SWEEPKIT_LICENSE "${SWEEPKIT_LICENSE}")
  string(REPLACE "\n" "\n " SWEEPKIT_LICENSE "${SWEEPKIT_LICENSE}")
  string(REPLACE "\n \n" "\n .\n" SWEEPKIT_LICENSE "${SWEEPKIT_LICENSE}")
  configure_file(${PROJECT_SOURCE_DIR}/packaging/copyright.in ${PROJECT_BINARY_DIR}/copyright @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION share/doc/sweepkit COMPONENT program)
  install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION share/doc/libsweepkit-dev COMPONENT development)
  foreach(package IN ITEMS nlohmann-json3-dev libpugixml-dev libglm-dev libcli11-dev libopenmesh-dev libxxhash-dev libhwy-dev
                           libtbb-dev libsvgpp-dev libboost-dev)
    if(EXISTS /usr/share/doc/${package}/copyright)
      install(FILES /usr/share/doc/${package}/copyright DESTINATION share/doc/sweepkit/notices RENAME ${package} COMPONENT program)
    endif()
  endforeach()
endfunction()
