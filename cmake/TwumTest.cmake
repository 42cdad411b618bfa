# SPDX-License-Identifier: Apache-2.0
# twum_test(NAME SOURCES ... [LIBRARIES ...] [RAPIDCHECK] [LABELS ...] [TIMEOUT SECONDS])
#
# Makes the Catch2 program NAME_tests and one ctest for each of its test cases, named "NAME.case".
#
#  - LIBRARIES  what it links besides Catch2 (with its main) and the project's compile flags.
#  - RAPIDCHECK links rapidcheck and its Catch2 glue; the seed is fixed, failures print it.
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
  cmake_parse_arguments(ARG "RAPIDCHECK" "TIMEOUT" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set(target ${name}_tests)
  add_executable(${target} ${ARG_SOURCES})
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
  if(TWUM_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE <catch2/catch.hpp>)
  endif()
  # -w NoTests: a name that matches nothing is a failure, not a silent pass.
  catch_discover_tests(${target}
    TEST_PREFIX "${name}."
    EXTRA_ARGS -w NoTests
    PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${name};${ARG_LABELS}" ENVIRONMENT "RC_PARAMS=seed=42")
  set_property(GLOBAL APPEND PROPERTY TWUM_TEST_PROGRAMS $<TARGET_FILE:${target}>)
endfunction()
