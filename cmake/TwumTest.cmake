# SPDX-License-Identifier: Apache-2.0
# twum_test(NAME SOURCES ... [LIBRARIES ...] [RAPIDCHECK] [LABELS ...] [TIMEOUT SECONDS] [COST SECONDS] [RECORDS])
#
# Makes the Catch2 program NAME_tests and one ctest for each of its test cases, named "NAME.case".
#
#  - SOURCES: the word BATCH among them begins a batch, whose sources TWUM_UNITY compiles as one: in half the time, as
#    they share their headers and templates. Two sources of a batch may not give different things the same name.
#  - LIBRARIES  what it links besides Catch2 (with its main) and the project's compile flags.
#  - RAPIDCHECK links rapidcheck and its Catch2 glue; the seed is fixed, failures print it.
#  - COST: seconds of its longest cases; ctest begins with what takes longest.
#  - RECORDS: what its cases record of deviations goes to ${TWUM_DEVIATIONS}, for house.validation.
#  - A test case tagged [.long] is hidden from ctest; scripts/test-long.sh runs it.
#  - `#include "support/x.hpp"` finds tests/support/x.hpp.
#  - The sources may use TWUM_SOURCE_DIR and TWUM_TEST_DATA (tests/data), both string literals.
find_package(Catch2 2.13 REQUIRED)
include(Catch)

# Tests use the system's Python: its NumPy and jsonschema are the packaged ones, whatever comes
# first on PATH.
find_program(TWUM_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(TWUM_PYTHON NAMES python3 REQUIRED)

function(twum_test name)
  cmake_parse_arguments(ARG "RAPIDCHECK;RECORDS" "TIMEOUT;COST" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  if(NOT ARG_COST)
    set(ARG_COST 0)
  endif()
  set(target ${name}_tests)
  twum_test_batches(sources ${ARG_SOURCES})
  add_executable(${target} ${sources})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${TWUM_UNITY} UNITY_BUILD_MODE GROUP)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${target} PRIVATE
    TWUM_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    TWUM_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} Catch2::Catch2WithMain twum::compile)
  if(ARG_RAPIDCHECK)
    find_package(rapidcheck REQUIRED)
    target_link_libraries(${target} PRIVATE rapidcheck rapidcheck_catch)
  endif()
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # -w NoTests: a name that matches nothing is a failure, not a silent pass.
  catch_discover_tests(${target} TEST_PREFIX "${name}." EXTRA_ARGS -w NoTests)
  set(labels ${name} ${ARG_LABELS})
  twum_case_properties(${target} "${labels}" ${ARG_TIMEOUT} ${ARG_COST} "${ARG_RECORDS}")
  set_property(GLOBAL APPEND PROPERTY TWUM_TEST_PROGRAMS $<TARGET_FILE:${target}>)
endfunction()

# The sources without the words BATCH; each one behind such a word belongs to its batch.
function(twum_test_batches result)
  set(sources "")
  set(batch 0)
  foreach(source ${ARGN})
    if(source STREQUAL BATCH)
      math(EXPR batch "${batch} + 1")
      continue()
    endif()
    list(APPEND sources ${source})
    if(batch)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${batch})
    endif()
  endforeach()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

# Properties of the cases of a program, which ctest sets once it knows them: those that catch_discover_tests passes on cannot be lists.
function(twum_case_properties target labels timeout cost records)
  set(environment "RC_PARAMS=seed=42")
  set(fixtures "")
  if(records)
    list(APPEND environment "TWUM_DEVIATIONS=${TWUM_DEVIATIONS}")
    set(fixtures "FIXTURES_REQUIRED no_deviations FIXTURES_SETUP deviations")
  endif()
  set(file ${CMAKE_CURRENT_BINARY_DIR}/${target}_properties.cmake)
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT [[
if(@target@_TESTS)
  set_tests_properties(${@target@_TESTS} PROPERTIES
    LABELS "@labels@" TIMEOUT @timeout@ COST @cost@ ENVIRONMENT "@environment@" @fixtures@)
endif()
]])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${file})
endfunction()
