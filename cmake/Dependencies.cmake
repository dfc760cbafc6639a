# Libraries: the system's package first, then a download pinned by commit, else one clear line.
include(FetchContent)
set(LT_GIT "https://github.com" CACHE STRING "where pinned sources are fetched from (a mirror, if offline)")

# The list of packages has one home, the table in ./learn: name, must or lib, package for apt ...
file(STRINGS "${LT_ROOT}/learn" LT_PACKAGES REGEX "^[a-z0-9]+ +(must|lib) ")
list(TRANSFORM LT_PACKAGES REPLACE "^[a-z0-9]+ +[a-z]+ +([^ ]+).*" "\\1")
list(JOIN LT_PACKAGES " " LT_PACKAGES)
set(LT_INSTALL_LINE "sudo apt-get install ${LT_PACKAGES}")

# lt_fetch(NAME REPOSITORY COMMIT): downloads a library, or stops with the line that installs it.
function(lt_fetch name repository commit)
  string(TOUPPER ${name} upper)
  find_package(Git QUIET)
  if(NOT FETCHCONTENT_SOURCE_DIR_${upper} AND NOT GIT_FOUND)
    message(FATAL_ERROR "${name} is not installed and git is not there to fetch it.\n"
      "  Debian/Ubuntu: ${LT_INSTALL_LINE}\n  elsewhere: ./learn doctor")
  endif()
  message(STATUS "${name}: not installed, fetching ${LT_GIT}/${repository}@${commit}")
  message(STATUS "  (if that fails: ${LT_INSTALL_LINE})")
  set(CMAKE_POLICY_VERSION_MINIMUM 3.5) # CMake 4 reads what older ones wrote only when told so
  FetchContent_Declare(${name} GIT_REPOSITORY ${LT_GIT}/${repository} GIT_TAG ${commit} SYSTEM)
  FetchContent_MakeAvailable(${name})
  set(${name}_SOURCE_DIR "${${name}_SOURCE_DIR}" PARENT_SCOPE)
  string(TOLOWER ${name} lower)
  set(${lower}_SOURCE_DIR "${${lower}_SOURCE_DIR}" PARENT_SCOPE)
endfunction()

find_package(Threads REQUIRED)

find_package(glm QUIET)
if(NOT glm_FOUND)
  lt_fetch(glm g-truc/glm 0af55ccecd98d4e5a8d1fad7de25ba429d60e863) # 1.0.1
endif()

# CLI11 and nlohmann/json: used in one translation unit each.
find_package(CLI11 QUIET)
if(NOT CLI11_FOUND)
  lt_fetch(CLI11 CLIUtils/CLI11 4160d259d961cd393fd8d67590a8c7d210207348) # v2.4.2
endif()
find_package(nlohmann_json QUIET)
if(NOT nlohmann_json_FOUND)
  lt_fetch(nlohmann_json nlohmann/json 9cca280a4d0ccf0c08f47a99aa71d1b0e52f8d03) # v3.11.3
endif()

# stb has no CMake package: find the header.
find_path(STB_INCLUDE_DIR stb_image_write.h PATH_SUFFIXES stb)
if(NOT STB_INCLUDE_DIR)
  lt_fetch(stb nothings/stb 31c1ad37456438565541f4919958214b6e762fb4)
  set(STB_INCLUDE_DIR "${stb_SOURCE_DIR}" CACHE PATH "folder of stb_image.h" FORCE)
endif()

if(LT_TESTS)
  # Catch2 3 wherever there is one, 2.13 (Debian 12) otherwise, else a download of 3.
  if(NOT FETCHCONTENT_SOURCE_DIR_CATCH2)
    find_package(Catch2 3 QUIET)
    if(NOT Catch2_FOUND)
      unset(Catch2_DIR CACHE)
      find_package(Catch2 2.13 QUIET)
    endif()
  endif()
  if(NOT Catch2_FOUND)
    lt_fetch(Catch2 catchorg/Catch2 fa43b77429ba76c462b1898d6cd2f2d7a9416b14) # v3.7.1
    list(APPEND CMAKE_MODULE_PATH ${catch2_SOURCE_DIR}/extras)
  endif()
  if(NOT TARGET Catch2::Catch2WithMain) # Catch2 2.13 as some systems package it: headers only
    file(WRITE ${CMAKE_BINARY_DIR}/catch_main.cpp
      "#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n")
    add_library(lt_catch_main STATIC ${CMAKE_BINARY_DIR}/catch_main.cpp)
    target_link_libraries(lt_catch_main PUBLIC Catch2::Catch2)
    add_library(Catch2::Catch2WithMain ALIAS lt_catch_main)
  endif()
  include(Catch)
endif()
