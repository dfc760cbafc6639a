# A chapter configures alone, builds only itself and what it stands on, and passes its tests.
#   cmake -D CHAPTER=ch02_ray_casting -D ROOT=. -D BUILD=build/alone [-D OPTIONS=...] -P tests/alone.cmake
cmake_minimum_required(VERSION 3.25)
set(run COMMAND_ERROR_IS_FATAL ANY)

file(REMOVE_RECURSE ${BUILD})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${ROOT}/chapters/${CHAPTER} -B ${BUILD} ${OPTIONS} ${run})
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --parallel 2 --config Release ${run})

# The programs of other chapters, and of the runner, are not its business.
file(GLOB_RECURSE programs RELATIVE ${BUILD} ${BUILD}/*_tests ${BUILD}/*_tests.exe ${BUILD}/learn
  ${BUILD}/ch??_* ${BUILD}/ch??_*.exe)
foreach(program IN LISTS programs)
  cmake_path(GET program STEM name)
  string(REGEX REPLACE "_tests$" "" name ${name})
  if(NOT program MATCHES "CMakeFiles|_deps|\\.cmake$|\\.txt$|\\.json$" AND NOT name STREQUAL CHAPTER)
    message(FATAL_ERROR "${CHAPTER} alone also built ${program}")
  endif()
endforeach()

execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${BUILD} --output-on-failure
  --no-tests=error --build-config Release ${run})
