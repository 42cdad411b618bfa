# SPDX-License-Identifier: Apache-2.0
# TWUM_WITH_DESIGNER is on by itself where the tools are that compile the core for a page: Clang 14 with its linker, the C
# and C++ libraries of wasm32-wasi, and the compressor zopfli. scripts/install-deps.sh installs them.
find_program(TWUM_WASM_COMPILER NAMES clang++-14)
find_program(TWUM_ZOPFLI NAMES zopfli)

# Compiles and links a program: Clang links both libraries to each one.
function(twum_find_wasm_tools result)
  set(probe ${CMAKE_BINARY_DIR}/CMakeFiles/wasm_probe)
  file(WRITE ${probe}.cpp "#include <version>\nint main() {}\n")
  execute_process(
    COMMAND ${TWUM_WASM_COMPILER} --target=wasm32-wasi -std=c++20 -fno-exceptions ${probe}.cpp -o ${probe}.wasm
    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed)
    set(${result} OFF PARENT_SCOPE)
  else()
    set(${result} ON PARENT_SCOPE)
  endif()
endfunction()

set(can_build_designer OFF)
set(wanted ${PROJECT_IS_TOP_LEVEL})
if(TWUM_SANITIZE)
  set(wanted OFF)  # nothing of it runs in the page
endif()
if(wanted AND TWUM_WASM_COMPILER AND TWUM_ZOPFLI AND NOT DEFINED TWUM_WITH_DESIGNER)
  twum_find_wasm_tools(can_build_designer)
endif()
if(wanted AND NOT can_build_designer AND NOT DEFINED TWUM_WITH_DESIGNER)
  message(STATUS "Pages come without the designer: no Clang 14 for wasm32-wasi, or no zopfli (scripts/install-deps.sh installs it)")
endif()
option(TWUM_WITH_DESIGNER "Compile the core for the designer in pages (twum explore, reports)" ${can_build_designer})
if(TWUM_WITH_DESIGNER AND NOT (TWUM_WASM_COMPILER AND TWUM_ZOPFLI))
  message(FATAL_ERROR "TWUM_WITH_DESIGNER needs clang++-14, the libraries of wasm32-wasi, and zopfli; scripts/install-deps.sh installs them")
endif()
if(TWUM_WITH_DESIGNER)
  set(TWUM_DESIGNER_MODULE ${PROJECT_BINARY_DIR}/bindings/wasm/core.wasm.gz)
endif()
