# How every target of sweepkit is compiled.
add_library(sweepkit_compile INTERFACE)
add_library(sweepkit::compile ALIAS sweepkit_compile)

target_compile_options(
  sweepkit_compile
  INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers -Wnon-virtual-dtor -Wold-style-cast
            -Woverloaded-virtual
            # Same input, same bytes on every machine: no fused multiply-add, no reordering (docs/architecture.md).
            -ffp-contract=off)
if(SWEEPKIT_WERROR)
  target_compile_options(sweepkit_compile INTERFACE -Werror)
endif()

# sweepkit_library(<name> <sources>...): the library sweepkit::<name> in the folder lib<name>.
function(sweepkit_library name)
  add_library(sweepkit_${name} STATIC ${ARGN})
  add_library(sweepkit::${name} ALIAS sweepkit_${name})
  set_target_properties(sweepkit_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(sweepkit_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
                                                     $<INSTALL_INTERFACE:include>)
  target_compile_features(sweepkit_${name} PUBLIC cxx_std_20)
  target_link_libraries(sweepkit_${name} PRIVATE $<BUILD_INTERFACE:sweepkit::compile>)
  sweepkit_install(${name})
endfunction()
