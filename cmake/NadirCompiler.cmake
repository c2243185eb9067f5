# Language level, warnings and sanitizers, shared by every target.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET default)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}")

find_program(NADIR_CCACHE ccache)
if(NADIR_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${NADIR_CCACHE}")
endif()

add_library(nadir_compiler INTERFACE)
target_compile_options(nadir_compiler INTERFACE -Wall -Wextra -Wpedantic -Wconversion)
# Of several sources that are compiled as one, each would shadow what the others call their own;
set(unity "$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>")
target_compile_options(nadir_compiler INTERFACE $<$<NOT:${unity}>:-Wshadow>)
# and g++ takes a source that another includes for a header, whose types with members from an
# anonymous namespace would differ from one source to the next.
target_compile_options(nadir_compiler INTERFACE
  $<$<AND:${unity},$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>)
# g++ 12 reports strings of braced temporaries as uninitialised (GCC bug 105562), and strings that
# are put together as overlapping themselves (105651); the sanitizers and clang-tidy watch for real
# ones.
target_compile_options(nadir_compiler INTERFACE
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-restrict>")
if(NADIR_WERROR)
  target_compile_options(nadir_compiler INTERFACE -Werror)
endif()
# Physics is compiled for exact IEEE results: no fast-math, and no contraction, so that the same
# bytes come out of every x86-64 machine. -O3 vectorises the spectral loops.
# Nobody reads errno after a square root, and loops with one vectorise without it.
# Targets with NADIR_LIGHT are not worth the time that this takes.
set(light "$<BOOL:$<TARGET_PROPERTY:NADIR_LIGHT>>")
target_compile_options(nadir_compiler INTERFACE
  -ffp-contract=off -fno-math-errno $<$<CONFIG:Release>:$<IF:${light},-O1,-O3>>)
if(NADIR_SANITIZE)
  # Instrumented, sources that run once take twice as long to compile with any optimisation as with
  # none. (Compile options come after the flags of the build type.)
  target_compile_options(nadir_compiler INTERFACE $<${light}:-O0>)
  # Targets with NADIR_BARE (the tests) are linked with the sanitizers, but not instrumented: it is
  # the library that they watch, and instrumented macros of Catch take most of the time to compile.
  set(bare "$<BOOL:$<TARGET_PROPERTY:NADIR_BARE>>")
  target_compile_options(nadir_compiler INTERFACE
    "$<$<NOT:${bare}>:-fsanitize=address,undefined;-fno-sanitize-recover=all>"
    -fno-omit-frame-pointer)
  target_link_options(nadir_compiler INTERFACE -fsanitize=address,undefined)
endif()
if(NADIR_SANITIZE_THREAD)
  # cmake/tsan/README.md says why oneTBB has stand-ins; Embree builds its scenes on one thread.
  target_include_directories(nadir_compiler BEFORE INTERFACE
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/cmake/tsan>")
  target_compile_definitions(nadir_compiler INTERFACE NADIR_ONE_THREAD_OF_EMBREE)
  target_compile_options(nadir_compiler INTERFACE
    $<${light}:-O0> -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(nadir_compiler INTERFACE -fsanitize=thread)
endif()

# Sources of a target some at a time as one (eight if nothing else is said): headers and templates,
# most of the time of a build, are then read once for all of them. For builds from scratch; the plain
# build shows that every source includes what it needs. Sources with options of their own stay alone.
# Targets with names that two sources define are left out.
function(nadir_unity target)
  set(batch 8)
  if(ARGC GREATER 1)
    set(batch ${ARGV1})
  endif()
  if(NADIR_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
  endif()
endfunction()

# Through a precompiled header g++ 12 warns of array bounds and overflows inside std::string where
# there is nothing to warn of (without one it does not); clang and the sanitizers watch for real ones.
function(nadir_precompiled_for_gnu target)
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>")
endfunction()
