# SPDX-License-Identifier: Apache-2.0
# One flag set for the whole project; it never reaches a consumer of the package.
#
# -ffp-contract=off keeps a*b + c from being fused, so that the double path and the derivative path
# agree bit for bit and every build gives the same digits. -fno-math-errno lets square roots be one instruction; no
# value changes by it. -Wno-psabi: no function passes vectors to one that is compiled for another processor.
#
# Warnings are errors, and only for those who change the code (presets dev and ci): they take GCC a tenth of its time.
# -Wno-restrict because GCC 12 warns wrongly about "text" + std::string from -O2 on (GCC bug 105651). In a batch of
# sources one source's names are not another's concern: -Wno-shadow.
#
# A batch of sources (TWUM_UNITY) needs a gigabyte in any case; collecting garbage less often, GCC is a tenth faster on it.
add_library(twum_compile INTERFACE)
target_compile_features(twum_compile INTERFACE cxx_std_20)
target_compile_options(twum_compile INTERFACE -ffp-contract=off -fno-math-errno -Wno-psabi)
if(TWUM_WARNINGS)
  target_compile_options(twum_compile INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<BOOL:${TWUM_UNITY}>:-Wno-shadow>)
endif()
if(TWUM_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(twum_compile INTERFACE
    "SHELL:--param ggc-min-expand=300" "SHELL:--param ggc-min-heapsize=4000000")
endif()
if(TWUM_SANITIZE)
  target_compile_options(twum_compile INTERFACE -fsanitize=${TWUM_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(twum_compile INTERFACE -fsanitize=${TWUM_SANITIZE})
endif()
add_library(twum::compile ALIAS twum_compile)

# twum_optimized(TARGET hot|duals|warm|mild|cold): how fully a release optimizes, whatever its preset asks of the rest.
#   hot    points, where GCC inlines all that it can
#   duals  derivatives: GCC 12 vectorizes the short loops of dual numbers only from -O3 on. They are four times as much code, and
#          run as fast with the limits of inlining that -O2 has, in two thirds of the time to compile
#   warm   what searches among points: with -O3 metrics would be 1.5 % faster, and a quarter longer to compile
#   mild   what each row of a study passes through: searches, formulas, the store. The plate as well: with -O2 it would be 5 %
#          faster, and no faster with derivatives
#   cold   what runs once for each study or page: half of what has to be compiled, a fifth quicker with -Og than with -O1
set(level_of_hot -O3)
set(level_of_duals -O3)
set(level_of_warm -O2)
set(level_of_mild -O1)
set(level_of_cold -Og)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC would stop when a source has grown by 40 %, and a batch of sources reaches that: points of elastic layers took 5 % longer.
  list(APPEND level_of_hot --param=inline-unit-growth=200 --param=max-inline-insns-auto=45
    --param=max-inline-insns-single=400 --param=inline-min-speedup=5)
  list(APPEND level_of_duals --param=inline-unit-growth=200 --param=max-inline-insns-auto=15
    --param=max-inline-insns-single=70)
endif()
foreach(part hot duals warm mild cold)
  set(level_of_${part} "$<$<CONFIG:Release>:${level_of_${part}}>")
endforeach()
function(twum_optimized target part)
  target_compile_options(${target} PRIVATE "${level_of_${part}}")
endfunction()

# twum_lanes(TARGET SOURCE FLAG...): a source for processors with wider vectors than all have; the program asks when it runs. It is
# compiled alone and always optimized, so that its flags reach no function that others might use (tests/core/check_lanes.py).
function(twum_lanes target source)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64)$")
    target_sources(${target} PRIVATE ${source})
    set_source_files_properties(${source} PROPERTIES
      COMPILE_OPTIONS "-O3;${ARGN}" SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# Programs where the scripts and the docs expect them: BUILD/bin.
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
endif()
