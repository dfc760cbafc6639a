# The one bootstrap: included by the root, by every chapter that is configured alone, and by the
# exercises. It sets the compiler up, finds the libraries, adds common/ and defines lt_chapter().
include_guard(GLOBAL)

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH LT_ROOT)
set(LT_ROOT "${LT_ROOT}" CACHE INTERNAL "the repository's root")

option(LT_TESTS "Build the tests" ON)
option(LT_WERROR "Treat warnings as errors (CI does)" OFF)
option(LT_BENCHMARKS "Build the benchmarks (needs Google Benchmark)" OFF)
option(LT_NATIVE "Compile for this machine only (-march=native), for benchmarks" OFF)
set(LT_SANITIZE "" CACHE STRING "Sanitizers: address,undefined or thread or empty")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(LT_TESTS)
  enable_testing()
endif()

# Every target of ours links lt_options and nothing else sets flags.
add_library(lt_options INTERFACE)
add_library(lt::options ALIAS lt_options)
target_compile_features(lt_options INTERFACE cxx_std_20)
target_include_directories(lt_options INTERFACE "${LT_ROOT}" "${LT_ROOT}/chapters")
if(MSVC)
  target_compile_options(lt_options INTERFACE /W4 /permissive- /utf-8 /Zc:preprocessor)
  target_compile_definitions(lt_options INTERFACE _USE_MATH_DEFINES NOMINMAX
    _CRT_SECURE_NO_WARNINGS)
  # Arguments, environment and file names in UTF-8, as everywhere else (Windows 10 1903 and later).
  target_sources(lt_options INTERFACE
    $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:${LT_ROOT}/cmake/utf8.manifest>)
else()
  target_compile_options(lt_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow
    # Honest speed: no errno from sqrt, no trapping; results stay the same for every compiler.
    -fno-math-errno -fno-trapping-math -ffp-contract=off
    # g++ 12 warns of its own std::string operator+ (GCC bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
endif()
if(LT_WERROR)
  target_compile_options(lt_options INTERFACE $<IF:$<CXX_COMPILER_ID:MSVC>,/WX,-Werror>)
endif()
if(LT_NATIVE AND NOT MSVC)
  target_compile_options(lt_options INTERFACE -march=native)
endif()
if(LT_SANITIZE)
  target_compile_options(lt_options INTERFACE -fsanitize=${LT_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  target_link_options(lt_options INTERFACE -fsanitize=${LT_SANITIZE})
  # g++ sees uninitialised values in the checks that it adds itself.
  target_compile_options(lt_options INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

include(${LT_ROOT}/cmake/Dependencies.cmake)

# lt_catch_tests(TARGET LABEL name): registers each TEST_CASE of TARGET with CTest under a label.
function(lt_catch_tests target)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 60)
  endif()
  # A test executable that runs nothing must not count as a pass.
  catch_discover_tests(${target} TEST_PREFIX "${ARG_LABEL}: " DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT}
      FAIL_REGULAR_EXPRESSION "No tests? ran|No test cases matched")
endfunction()

add_subdirectory(${LT_ROOT}/common ${CMAKE_BINARY_DIR}/common)

# A renderer is a few large functions once all small ones are inlined. g++ stops before that, at
# limits that suit other programs; without them chapter 11's room takes a fifth less time. It costs
# a quarter more time to compile, so programs have it and tests do not.
function(lt_inline_more target)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:
    --param=large-function-growth=1000 --param=inline-unit-growth=300>)
endfunction()

# lt_chapter(NAME USES chapter...)
#   lt::NAME      the chapter's headers, with those of the chapters it stands on
#   NAME          its program, from main.cpp
#   NAME_tests    its tests, from tests/*.cpp
# A chapter that is only stood on (configured from another chapter) brings its headers alone.
function(lt_chapter name)
  cmake_parse_arguments(ARG "" "" "USES" ${ARGN})
  add_library(${name}_headers INTERFACE)
  add_library(lt::${name} ALIAS ${name}_headers)
  target_link_libraries(${name}_headers INTERFACE lt::common)
  foreach(used IN LISTS ARG_USES)
    if(NOT TARGET lt::${used})
      add_subdirectory(${LT_ROOT}/chapters/${used} ${CMAKE_BINARY_DIR}/chapters/${used})
    endif()
    target_link_libraries(${name}_headers INTERFACE lt::${used})
  endforeach()

  set(is_whole_course FALSE)
  if(CMAKE_SOURCE_DIR STREQUAL LT_ROOT)
    set(is_whole_course TRUE)
  endif()
  if(NOT is_whole_course AND NOT CMAKE_SOURCE_DIR STREQUAL CMAKE_CURRENT_SOURCE_DIR)
    return()
  endif()

  add_executable(${name} main.cpp)
  target_link_libraries(${name} PRIVATE lt::${name})
  lt_inline_more(${name})
  if(LT_TESTS)
    file(GLOB sources CONFIGURE_DEPENDS tests/*.cpp)
    add_executable(${name}_tests ${sources})
    target_link_libraries(${name}_tests PRIVATE lt::${name} lt::testkit)
    target_compile_definitions(${name}_tests PRIVATE LT_SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}")
    lt_catch_tests(${name}_tests LABEL ${name})
  endif()
endfunction()
