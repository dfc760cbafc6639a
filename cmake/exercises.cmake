# Exercises. In the learner's workspace (exercises/ configured alone) each one is a program made
# of its test and the learner's file. In the root build, which has the runner, each one is *proved*:
# its solution, another solution, its starter and every wrong answer (mutant) become programs, and
# `learn judge` tells CTest whether each ends as it must.
include_guard(GLOBAL)

set(LT_MY "${LT_ROOT}/my" CACHE PATH "where the learner's files live")
set(LT_EXERCISES "${LT_ROOT}/exercises" CACHE PATH
  "folders with exercise.json, two levels down")

option(LT_MUTANTS "Prove that each exercise names its wrong answers; they are many to compile" ON)

# One line that names the exercise, then stop.
function(lt_exercise_error folder message)
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${LT_ROOT}")
  message(FATAL_ERROR "${folder}: ${message}")
endfunction()

# lt_exercise_get(OUT FOLDER JSON key...): a value of exercise.json, or one line on what is wrong.
function(lt_exercise_get out folder json)
  string(JSON value ERROR_VARIABLE error GET "${json}" ${ARGN})
  if(error)
    lt_exercise_error("${folder}" "exercise.json: ${error}")
  endif()
  set(${out} "${value}" PARENT_SCOPE)
endfunction()

# A small program: test + the answer in SOURCE. The test object is compiled once for all answers.
function(lt_exercise_program target id folder source)
  add_executable(${target} "${source}")
  target_include_directories(${target} PRIVATE "${folder}")
  # A starter does not use the fields of its class yet. (A file's options come last: -Wall is first.)
  set_source_files_properties("${source}" PROPERTIES COMPILE_OPTIONS
    $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-unused-private-field>)
  target_link_libraries(${target} PRIVATE ex_${id}_test lt::testkit)
  lt_exercise_flags(${target})
endfunction()

# Quick to compile, hard on mistakes: a forgotten return is an error, a wild index stops the program.
function(lt_exercise_flags target)
  if(NOT MSVC)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> -UNDEBUG -Werror=return-type)
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  endif()
endfunction()

# lt_exercise(FOLDER): everything about the exercise that FOLDER/exercise.json describes.
function(lt_exercise folder)
  file(READ "${folder}/exercise.json" json)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/exercise.json")
  lt_exercise_get(id "${folder}" "${json}" id)
  lt_exercise_get(name "${folder}" "${json}" name)
  if(NOT id MATCHES "^[0-9][0-9]\\.[0-9]+$")
    lt_exercise_error("${folder}" "exercise.json: id is \"${id}\", not chapter.number as in 02.1")
  endif()
  if(TARGET ex_${id}_test)
    lt_exercise_error("${folder}" "exercise.json: id ${id} is taken by another exercise")
  endif()
  foreach(file IN ITEMS api.hpp starter.cpp test.cpp solution.cpp other.cpp README.md)
    if(NOT EXISTS "${folder}/${file}")
      lt_exercise_error("${folder}" "${file} is missing")
    endif()
  endforeach()

  add_library(ex_${id}_test OBJECT "${folder}/test.cpp")
  target_include_directories(ex_${id}_test PRIVATE "${folder}")
  target_link_libraries(ex_${id}_test PRIVATE lt::testkit)
  lt_exercise_flags(ex_${id}_test)

  if(TARGET learn)
    lt_prove_exercise("${folder}" "${json}" ${id} "${name}")
  else()
    lt_learner_exercise("${folder}" ${id} "${name}")
  endif()
endfunction()

# Half of the wait for a verdict is reading the same headers again: they are read once, for all
# exercises. (Proofs of right answers go without, so that each names the headers that it needs.)
function(lt_precompile target)
  if(NOT TARGET ex_headers)
    file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/headers.cpp" "")
    add_library(ex_headers OBJECT "${CMAKE_CURRENT_BINARY_DIR}/headers.cpp")
    target_link_libraries(ex_headers PRIVATE lt::testkit)
    lt_exercise_flags(ex_headers)
    target_precompile_headers(ex_headers PRIVATE <algorithm> <array> <cmath> <cstdint> <optional>
      <stdexcept> <string> <vector> <glm/glm.hpp>)
  endif()
  target_precompile_headers(${target} REUSE_FROM ex_headers)
endfunction()

# GNU's second linker, where there is one, takes half the time of its first.
include(CheckLinkerFlag)
function(lt_link_quickly target)
  if(MSVC)
    return()
  endif()
  check_linker_flag(CXX -fuse-ld=gold LT_HAS_GOLD)
  if(LT_HAS_GOLD)
    target_link_options(${target} PRIVATE -fuse-ld=gold)
  endif()
endfunction()

# The learner's program: my/ID-NAME.cpp if it is there, the untouched starter otherwise.
function(lt_learner_exercise folder id name)
  set(source "${folder}/starter.cpp")
  file(GLOB mine CONFIGURE_DEPENDS "${LT_MY}/${id}-*.cpp")
  if("${LT_MY}/${id}-${name}.cpp" IN_LIST mine)
    set(source "${LT_MY}/${id}-${name}.cpp")
  endif()
  lt_exercise_program(ex_${id} ${id} "${folder}" "${source}")
  lt_precompile(ex_${id})
  lt_link_quickly(ex_${id})
  add_test(NAME "${id} ${name}" COMMAND ex_${id})
  set_tests_properties("${id} ${name}" PROPERTIES LABELS ${id} TIMEOUT 10)
endfunction()

# The soundness programs of one exercise and the tests that judge them.
function(lt_prove_exercise folder json id name)
  # (Not with MSVC: it warns of conversions that the others find harmless.)
  set(warnings_are_errors $<$<NOT:$<CXX_COMPILER_ID:MSVC>>:-Werror>)
  foreach(answer IN ITEMS solution other starter)
    lt_exercise_program(ex_${id}_${answer} ${id} "${folder}" "${folder}/${answer}.cpp")
    target_compile_options(ex_${id}_${answer} PRIVATE ${warnings_are_errors})
  endforeach()
  lt_judge("${folder}" ${id} "${name}" solution "the solution passes")
  lt_judge("${folder}" ${id} "${name}" other "another right answer passes")
  lt_judge("${folder}" ${id} "${name}" starter "the starter fails because it is not written")
  lt_judge("${folder}" ${id} "${name}" solution "the solution passes for 200 seeds" --seeds 200)
  lt_judge("${folder}" ${id} "${name}" other "another right answer passes for 200 seeds" --seeds 200)

  if(NOT LT_MUTANTS)
    return()
  endif()
  string(JSON count ERROR_VARIABLE error LENGTH "${json}" mutants)
  if(error OR count LESS 2)
    lt_exercise_error("${folder}" "exercise.json: mutants must be a list of at least 2")
  endif()
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    lt_exercise_get(tag "${folder}" "${json}" mutants ${i} tag)
    lt_exercise_get(find "${folder}" "${json}" mutants ${i} find)
    lt_exercise_get(replace "${folder}" "${json}" mutants ${i} replace)
    lt_mutant("${folder}" ${id} "${tag}" "${find}" "${replace}")
    lt_judge("${folder}" ${id} "${name}" mutant_${tag} "the mutant ${tag} is named")
  endforeach()
endfunction()

# A wrong answer: solution.cpp with one place replaced. Written anew only when it changes.
function(lt_mutant folder id tag find replace)
  if(NOT tag MATCHES "^[a-z0-9-]+$" OR TARGET ex_${id}_mutant_${tag})
    lt_exercise_error("${folder}"
      "exercise.json: tag \"${tag}\" is not lower-case-with-dashes, or used twice")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/solution.cpp")
  file(READ "${folder}/solution.cpp" solution)
  string(FIND "${solution}" "${find}" first)
  string(FIND "${solution}" "${find}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    lt_exercise_error("${folder}"
      "mutant ${tag}: \"find\" must occur exactly once in solution.cpp: ${find}")
  endif()
  string(REPLACE "${find}" "${replace}" mutated "${solution}")
  set(file "${CMAKE_CURRENT_BINARY_DIR}/mutants/${id}-${tag}.cpp")
  set(old "")
  if(EXISTS "${file}")
    file(READ "${file}" old)
  endif()
  if(NOT mutated STREQUAL old)
    file(WRITE "${file}" "${mutated}")
  endif()
  lt_exercise_program(ex_${id}_mutant_${tag} ${id} "${folder}" "${file}")
  # A mistake may well be one that the compiler warns of: that must not stop CI.
  target_compile_options(ex_${id}_mutant_${tag} PRIVATE $<IF:$<CXX_COMPILER_ID:MSVC>,/w,-w>)
  # They are the most by far, and solution.cpp has shown that its headers suffice.
  lt_precompile(ex_${id}_mutant_${tag})
  lt_link_quickly(ex_${id}_mutant_${tag})
endfunction()

# lt_judge(FOLDER ID NAME ANSWER SENTENCE option...): one CTest test of one program.
function(lt_judge folder id name answer sentence)
  add_test(NAME "${id} ${name}: ${sentence}"
    COMMAND learn judge "${folder}" ${answer} $<TARGET_FILE:ex_${id}_${answer}> ${ARGN})
  set_tests_properties("${id} ${name}: ${sentence}" PROPERTIES LABELS exercises TIMEOUT 120)
  add_dependencies(exercise_programs ex_${id}_${answer})
endfunction()
