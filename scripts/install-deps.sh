#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian 12 packages that twum needs, and only those that are missing.
#
#   scripts/install-deps.sh          to build twum and run it
#   scripts/install-deps.sh test     the same and what scripts/test.sh needs
#   scripts/install-deps.sh long     the same and what scripts/test-long.sh needs
#   scripts/install-deps.sh --list [test|long]   prints the packages instead
#
# Runs as root, or through sudo. Says nothing when everything is there.
set -euo pipefail

# tests/house/check_scripts.py checks that no other script installs anything.
build_packages=(
  # tools
  g++ cmake ninja-build pkg-config ccache python3
  # linked into twum
  libeigen3-dev libspectra-dev libgsl-dev libnlopt-dev libnlopt-cxx-dev coinor-libipopt-dev libyaml-cpp-dev
  libudunits2-dev libcli11-dev nlohmann-json3-dev libfmt-dev libsqlite3-dev libboost-dev libzip-dev
  # several processes
  libopenmpi-dev openmpi-bin
  # the Python module
  pybind11-dev python3-dev python3-numpy python3-setuptools python3-wheel python3-venv
  # the core for pages
  clang-14 lld-14 wasi-libc libc++-14-dev-wasm32 libc++abi-14-dev-wasm32 libclang-rt-14-dev-wasm32 zopfli
  # started by twum for plots
  gnuplot-nox
)
test_packages=(
  catch2 librapidcheck-dev libbenchmark-dev
  # turns the clock in tests of the command line
  faketime
  # independent checks, in tests and bench only
  libsundials-dev python3-jsonschema
  # the Python module's plots, types and examples
  python3-matplotlib python3-pandas python3-scipy python3-mypy python3-distributed
  # readers of the man page and the completions
  man-db fish zsh
  # the report page in a real browser
  chromium
  # the description of an FMU
  libxml2-utils
  # the stator as a solid, which twum starts
  calculix-ccx
  # house checks
  codespell doxygen
)
long_packages=(
  # pagmo is a cross-check of fronts
  libpagmo-dev debootstrap valgrind gcovr libclang-rt-14-dev clang-format-14 clang-tidy-14
  # checks the scripts of the report page
  node-typescript
  # a cluster of one node
  slurm-wlm munge
)

list_only=false
if [[ ${1:-} == --list ]]; then
  list_only=true
  shift
fi
case ${1:-build} in
  build) packages=("${build_packages[@]}") ;;
  test) packages=("${build_packages[@]}" "${test_packages[@]}") ;;
  long) packages=("${build_packages[@]}" "${test_packages[@]}" "${long_packages[@]}") ;;
  *)
    echo "install-deps.sh: unknown argument '$1'; use nothing, 'test' or 'long'" >&2
    exit 2
    ;;
esac
if $list_only; then
  printf '%s\n' "${packages[@]}"
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) || status=absent
  [[ $status == installed ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "install-deps.sh: needs root, or sudo, to install: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]}" >&2
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
# A package source that has nothing to do with these packages may fail; the install then decides.
"${apt[@]}" update >&2 || echo "install-deps.sh: apt-get update had errors; trying to install anyway" >&2
"${apt[@]}" install -y --no-install-recommends "${missing[@]}" >&2
