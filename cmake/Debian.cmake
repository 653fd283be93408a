# `cpack -G DEB` in the build folder: sweepkit, the program, and libsweepkit-dev, the libraries to link. dpkg-shlibdeps
# finds what the program and its image module link; what a static library asks of its user is said here.
set(CPACK_PACKAGE_NAME sweepkit)
set(CPACK_PACKAGE_VENDOR "the sweepkit authors")
set(CPACK_PACKAGE_CONTACT "the sweepkit authors <sweepkit@example.invalid>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME sweepkit)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "Carries a contour along a trajectory and writes the surface as textured glTF
or as a mesh file, or draws it by ray tracing with filtered textures.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsweepkit-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(linked libglm-dev libopenmesh-dev libhwy-dev libtinygltf-dev libmeshoptimizer-dev libpugixml-dev libcsv-dev libtbb-dev)
if(embree_FOUND)
  list(APPEND linked libembree-dev)
endif()
string(JOIN ", " linked ${linked})
# The image module, which libtexmap loads, comes with the program.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "sweepkit (= ${PROJECT_VERSION}), ${linked}")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "Static libraries, headers and the CMake package of sweepkit: sweeps of curves,
texture mapping and filtering, scenes and glTF, and the ray tracer.")
include(CPack)
