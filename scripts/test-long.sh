#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The slow tests. Each step is named; without arguments all of them run, one after the other, and the
# outcome of each goes into the table of docs/reliability/repeat.md.
#
#   scripts/test-long.sh                 everything
#   scripts/test-long.sh asan tsan       these steps
#
# Exits with an error if a step failed.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

all_steps=(cases properties kind kill stop damage openturns no-ipopt no-gsl mpi slurm shared asan tsan valgrind coverage clang fuzz package pip lint)

build() {  # PRESET [CMAKE ARGUMENT...]
  configure "$@" && cmake --build --preset "$1" -j "$(jobs)"
}

all_tests() {  # BUILD FOLDER [CTEST ARGUMENT...]
  ctest --test-dir "$1" --output-on-failure --no-tests=error -j "$(jobs)" "${@:2}"
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

# A kind of study is added as CONTRIBUTING.md says, and answers everywhere.
step_kind() {
  build ci && python3 tests/exercise/new_kind_test.py build/ci
}

# Kills each example study at 50 random moments; its results must be those of an uninterrupted run.
step_kill() {
  build ci && python3 tests/cli/kill_study.py build/ci/bin/twum examples/studies/*.yaml --count 50
}

# Random searches by every solver: each must end by itself, and within a second after a signal.
step_stop() {
  build ci && python3 tests/cli/stop_study.py build/ci/bin/twum --count 400 --seed "${TWUM_SEED:-1}" --keep build/stop
}

# 300 random damages to the stored evaluations of each of three studies: refused, or the same answer.
step_damage() {
  build ci && python3 tests/cli/damage_survey.py build/ci/bin/twum \
    examples/studies/{sensitivity-sobol,pareto-driven,tolerances}.yaml --count 300
}

# Shares of failures and Sobol indices against OpenTURNS, where it is installed.
step_openturns() {
  build ci && /usr/bin/python3 tests/cli/openturns_oracle.py build/ci/bin/twum
}

# A build that may be passed on, for one process.
step_no-ipopt() {
  configure ci -B build/no-ipopt -DTWUM_WITH_IPOPT=OFF -DTWUM_WITH_MPI=OFF && cmake --build build/no-ipopt -j "$(jobs)" &&
    ! ldd build/no-ipopt/bin/twum | grep -i ipopt && all_tests build/no-ipopt
}

step_no-gsl() {
  configure ci -B build/no-gsl -DTWUM_WITH_GSL=OFF && cmake --build build/no-gsl -j "$(jobs)" &&
    ! ldd build/no-gsl/bin/twum | grep -i gsl && all_tests build/no-gsl
}

# Several processes give the bytes of one: each example study, and a few of them with a process killed at 20 random moments.
step_mpi() {
  build ci && python3 tests/cli/mpi_study.py build/ci/bin/twum examples/studies/*.yaml &&
    python3 tests/cli/kill_study.py build/ci/bin/twum --processes 3 --jobs 1 --count 20 \
      examples/studies/{calibrate,optimize-ring-60-ipopt,pareto-driven,sensitivity-sobol,tolerances-driven}.yaml
}

# The script of the examples in a Slurm of one node; as root.
step_slurm() {
  build ci && python3 tests/cli/slurm_test.py build/ci/bin/twum
}

# Libraries, program, Python module and other people's programs with shared libraries.
step_shared() {
  configure ci -B build/shared -DBUILD_SHARED_LIBS=ON && cmake --build build/shared -j "$(jobs)" &&
    readelf -d build/shared/bin/twum | grep -q libtwum_studies && all_tests build/shared -L 'package|python|cli'
}

step_asan() {
  build asan && UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 all_tests build/asan
}

step_tsan() {
  build tsan && all_tests build/tsan
}

small_study() {  # KIND ENTRY...
  printf 'twum: 1\nmotor: %s\nstudy:\n  kind: %s\n' "$PWD/tests/data/motors/ring-60.yaml" "$1"
  printf '  variables:\n    preload: {min: 120 N, max: 200 N}\n    amplitude: {min: 1.2 um, max: 1.8 um}\n'
  printf '  %s\n' "${@:2}"
}

# The command line on small tasks. Leaks are errors, but not possible ones: UDUNITS keeps its units in trees of the C
# library, which hide a bit in their pointers.
step_valgrind() {
  build ci || return 1
  local scratch=build/valgrind
  rm -rf "$scratch" && mkdir -p "$scratch" || return 1
  printf 'preload,amplitude [um]\n160,1.6\n120,1.2\nx,1\n' >"$scratch/designs.csv"
  small_study sweep "sampling: lhs" "samples: 4" "metrics: [stall_torque, no_load_speed]" >"$scratch/sweep.yaml"
  small_study optimize "maximize: stall_torque" "solver: {starts: 2, seed: 1}" >"$scratch/optimize.yaml"
  small_study pareto "objectives: [{maximize: stall_torque}, {maximize: no_load_speed}]" "points: 3" >"$scratch/pareto.yaml"
  while read -r arguments; do
    # shellcheck disable=SC2086
    valgrind --quiet --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
      --error-exitcode=99 build/ci/bin/twum $arguments >/dev/null || return 1
    echo "valgrind twum $arguments: no errors"
  done <<COMMANDS
check examples/motors/ring-60.yaml
curve examples/motors/ring-60.yaml
curve examples/motors/ring-60.yaml --format json
metrics
fields examples/motors/ring-60.yaml --speed 20rpm
evaluate examples/motors/ring-60.yaml --designs $scratch/designs.csv --metrics stall_torque
check $scratch/sweep.yaml
run $scratch/sweep.yaml -o $scratch/sweep
run $scratch/optimize.yaml -o $scratch/optimize
run $scratch/pareto.yaml -o $scratch/pareto
report $scratch/sweep
verify $scratch/optimize
schema motor
schema study
parameters
COMMANDS
}

# Lines and branches of each layer that the tests reach; fails below 95 % of lines or 85 % of branches.
# Branches that only an exception takes, or that the compiler made, are not counted.
step_coverage() {
  build coverage || return 1
  find build/coverage -name '*.gcda' -delete
  all_tests build/coverage -LE package || return 1  # programs of others do not link what counts lines
  coverage_table build/coverage
}

coverage_table() {  # BUILD FOLDER
  local layer failed=0
  gcovr --root . --object-directory "$1" --filter 'core/' --filter 'motion/' --filter 'solid/' --filter 'optim/' --filter 'studies/' \
    --exclude-throw-branches --exclude-unreachable-branches -j "$(jobs)" --json "$1/coverage.json" \
    "$1"/core "$1"/motion "$1"/solid "$1"/optim "$1"/studies "$1"/tests || return 1
  for layer in core motion solid optim studies; do
    echo "coverage of $layer"
    gcovr --root . --add-tracefile "$1/coverage.json" --filter "$layer/" --exclude-throw-branches \
      --exclude-unreachable-branches --txt --print-summary --fail-under-line 95 --fail-under-branch 85 || failed=1
  done
  return "$failed"
}

step_clang() {
  configure ci -B build/clang -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14 \
    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG" && cmake --build build/clang -j "$(jobs)" && all_tests build/clang
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

# The wheel, built from nothing.
step_pip() {
  /usr/bin/python3 tests/package/pip_test.py
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
