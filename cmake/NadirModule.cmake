# One target per folder. A folder sees only the folders that it links: each has an include root of
# its own that holds nothing but a link to itself, so that `#include "sim/..."` inside core/ does
# not compile.
#
#   nadir_module(radiometry LINKS core spectral geometry PRIVATE embree)
#
# PLAIN: never a unity build: two of its sources define one name, see nadir_unity().
function(nadir_module name)
  cmake_parse_arguments(ARG "PLAIN" "" "LINKS;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  set(include_root "${PROJECT_BINARY_DIR}/include/${name}")
  file(MAKE_DIRECTORY "${include_root}")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/${name}" "${include_root}/${name}" SYMBOLIC)

  if(sources)
    add_library(nadir_${name} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(nadir_${name} PRIVATE nadir_compiler ${ARG_PRIVATE})
    if(NOT ARG_PLAIN)
      nadir_unity(nadir_${name})
    endif()
  else()
    add_library(nadir_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(nadir::${name} ALIAS nadir_${name})
  set_target_properties(nadir_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(nadir_${name} ${scope} cxx_std_20)
  target_include_directories(nadir_${name} ${scope}
    "$<BUILD_INTERFACE:${include_root}>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/nadir>")
  list(TRANSFORM ARG_LINKS PREPEND "nadir_")
  target_link_libraries(nadir_${name} ${scope} ${ARG_LINKS})
  set_property(GLOBAL APPEND PROPERTY NADIR_MODULES ${name})
endfunction()

# One test program per folder of tests/: nadir_tests(core LINKS core). UNITY: its sources open the
# same namespaces and define no name twice, see nadir_unity().
function(nadir_tests name)
  cmake_parse_arguments(ARG "UNITY" "" "LINKS;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/${name}/*_test.cpp")
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${sources})
  if(ARG_UNITY)
    nadir_unity(test_${name})
  endif()
  # Tests drive the library; optimising them would only take time.
  set_target_properties(test_${name} PROPERTIES NADIR_BARE ON NADIR_LIGHT ON
    RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
  list(TRANSFORM ARG_LINKS PREPEND "nadir_")
  target_link_libraries(test_${name} PRIVATE
    nadir_compiler nadir_test_support ${ARG_LINKS} ${ARG_PRIVATE})
  target_compile_definitions(test_${name} PRIVATE
    NADIR_SOURCE_DIR="${PROJECT_SOURCE_DIR}" NADIR_COMMAND="$<TARGET_FILE_DIR:test_${name}>/../nadir")
  catch_discover_tests(test_${name} TEST_PREFIX "${name}: " PROPERTIES LABELS ${name})
endfunction()
