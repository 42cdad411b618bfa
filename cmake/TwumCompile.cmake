# SPDX-License-Identifier: Apache-2.0
# One flag set for the whole project; it never reaches a consumer of the package.
#
# -ffp-contract=off keeps a*b + c from being fused, so that the double path and the derivative path
# agree bit for bit and every build gives the same digits. -fno-math-errno lets square roots be one instruction; no
# value changes by it. -Wno-psabi: no function passes vectors to one that is compiled for another processor.
#
# Warnings are errors, and only for those who change the code (presets dev and ci): they take GCC a tenth of its time.
# -Wno-restrict because GCC 12 warns wrongly about "text" + std::string from -O2 on (GCC bug 105651), -Wno-use-after-free because it
# does so about Eigen's matrices in inlined loops. In a batch of sources one source's names are not another's concern: -Wno-shadow.
add_library(twum_compile INTERFACE)
target_compile_features(twum_compile INTERFACE cxx_std_20)
target_compile_options(twum_compile INTERFACE -ffp-contract=off -fno-math-errno -Wno-psabi)
if(TWUM_WARNINGS)
  target_compile_options(twum_compile INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-use-after-free>
    $<$<BOOL:${TWUM_UNITY}>:-Wno-shadow>)
endif()
if(TWUM_SANITIZE)
  target_compile_options(twum_compile INTERFACE -fsanitize=${TWUM_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(twum_compile INTERFACE -fsanitize=${TWUM_SANITIZE})
endif()
add_library(twum::compile ALIAS twum_compile)

# twum_fast(SOURCE...): a release takes -O3 for these, each compiled alone.
function(twum_fast)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "$<$<CONFIG:Release>:-O3>")
endfunction()

# twum_lanes(TARGET SOURCE FLAG...): a source for processors with wider vectors than all have; the program asks when it runs. It is
# compiled alone and always optimized, so that its flags reach no function that others might use (tests/core/check_lanes.py).
# Programs with a sanitizer run where they are built; they need no such care.
function(twum_lanes target source)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64)$")
    target_sources(${target} PRIVATE ${source})
    if(NOT TWUM_SANITIZE)
      list(PREPEND ARGN -O3)
    endif()
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${ARGN}")
  endif()
endfunction()

# Programs where the scripts and the docs expect them: BUILD/bin.
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
endif()
