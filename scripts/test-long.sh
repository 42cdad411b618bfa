#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The slow tests. Each step is named; without arguments all of them run, one after the other, and the
# outcome of each goes into the table of docs/reliability.md.
#
#   scripts/test-long.sh                 everything
#   scripts/test-long.sh asan tsan       these steps
#
# Exits with an error if a step failed.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

all_steps=(cases properties validation kill no-ipopt asan tsan valgrind clang fuzz package lint)

build() {  # PRESET [CMAKE ARGUMENT...]
  configure "$@" && cmake --build --preset "$1" -j "$(jobs)"
}

all_tests() {  # BUILD FOLDER
  ctest --test-dir "$1" --output-on-failure --no-tests=error -j "$(jobs)"
}

# Test cases tagged [.long].
step_cases() {
  build ci && while read -r program; do
    "$program" "[long]" || return 1
  done <build/ci/test_programs.txt
}

# Every test program with ten times the property cases and a seed of its own, which is printed.
step_properties() {
  local seed=${TWUM_SEED:-$(date +%s)}
  echo "TWUM_SEED=$seed"
  build ci && while read -r program; do
    RC_PARAMS="seed=$seed max_success=1000" "$program" || return 1
  done <build/ci/test_programs.txt
}

# Every number of docs/validation.md, those of slow cases included.
step_validation() {
  build ci && tests/validation/validation_page.py build/ci/tests/bin/core_tests --all
}

# Kills each example study at 50 random moments; its results must be those of a run in peace.
step_kill() {
  build ci && python3 tests/cli/kill_study.py build/ci/bin/twum examples/studies/*.yaml --count 50
}

# A build that may be passed on.
step_no-ipopt() {
  configure ci -B build/no-ipopt -DTWUM_WITH_IPOPT=OFF && cmake --build build/no-ipopt -j "$(jobs)" &&
    ! ldd build/no-ipopt/bin/twum | grep -i ipopt && all_tests build/no-ipopt
}

step_asan() {
  build asan && UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 all_tests build/asan
}

step_tsan() {
  build tsan && all_tests build/tsan
}

step_valgrind() {
  build dev && for arguments in \
    "curve examples/motors/ring-60.yaml" \
    "curve examples/motors/ring-60.yaml --format json" \
    "check examples/motors/ring-60.yaml" \
    "schema motor" "metrics" "parameters"; do
    # shellcheck disable=SC2086
    valgrind --quiet --leak-check=full --error-exitcode=99 build/dev/bin/twum $arguments >/dev/null || return 1
    echo "valgrind twum $arguments: no errors"
  done
}

step_clang() {
  configure dev -B build/clang -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14 &&
    cmake --build build/clang -j "$(jobs)" && all_tests build/clang
}

# Each fuzzer for TWUM_FUZZ_SECONDS (300); what they find new stays in build/fuzz/corpus.
step_fuzz() {
  local name seeds corpus
  configure dev -B build/fuzz -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14 \
    -DTWUM_BUILD_FUZZERS=ON -DTWUM_BUILD_PYTHON=OFF &&
    cmake --build build/fuzz --target fuzzers -j "$(jobs)" || return 1
  for name in motor study table points units metrics; do
    seeds=(tests/fuzz/corpus/"$name")
    [[ $name != motor ]] || seeds+=(examples/motors tests/data/motor_errors)
    [[ $name != study ]] || seeds+=(examples/studies tests/data/study_errors)
    corpus=build/fuzz/corpus/$name
    mkdir -p "$corpus"
    echo "fuzz $name"
    build/fuzz/tests/bin/"fuzz_$name" "$corpus" "${seeds[@]}" -dict=tests/fuzz/readers.dict -timeout=20 \
      -rss_limit_mb=2048 -print_final_stats=1 -artifact_prefix="build/fuzz/$name-" \
      -max_total_time="${TWUM_FUZZ_SECONDS:-300}" || return 1
  done
}

# The Debian package in a clean chroot; as root.
step_package() {
  scripts/package.sh && python3 tests/package/chroot_test.py build/package
}

step_lint() {
  scripts/lint.sh --tidy
}

steps=("$@")
((${#steps[@]})) || steps=("${all_steps[@]}")
for step in "${steps[@]}"; do
  if ! declare -F "step_$step" >/dev/null; then
    echo "test-long.sh: no step '$step'; there are: ${all_steps[*]}" >&2
    exit 2
  fi
done

scripts/install-deps.sh long
mkdir -p build/test-long
failed=()
for step in "${steps[@]}"; do
  log=build/test-long/$step.log
  echo "=== $step (log: $log)"
  start=$SECONDS
  # In a subshell without errexit: a step's && chains decide.
  if (set +e; "step_$step") >"$log" 2>&1; then outcome=passed; else outcome=failed; fi
  [[ $outcome == passed ]] || { failed+=("$step"); tail -n 30 "$log"; }
  python3 tests/house/record_result.py "$step" "$outcome" $((SECONDS - start)) "$log"
done

if ((${#failed[@]})); then
  echo "failed: ${failed[*]}"
  exit 1
fi
echo "all steps passed: ${steps[*]}"
