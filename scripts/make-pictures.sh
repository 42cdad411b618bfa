#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Draws the pictures of the documentation anew, from the examples and the program as it is:
#
#   scripts/make-pictures.sh [TWUM]    default: build/release/bin/twum
#
# Needs gnuplot and, for the pictures of pages, chromium: scripts/install-deps.sh test.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
twum=${1:-$root/build/release/bin/twum}
pictures=$root/docs/pictures
ring=$root/examples/motors/ring-60.yaml
mkdir -p "$pictures"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$twum" curve "$ring" --plot "$pictures/curve.svg" >/dev/null
"$twum" map "$root/examples/motors/drive-60.yaml" --set radial_slices=1 --speed "250 rpm" --duty "0.5 N.m, 100 rpm" \
  --duty "0.2 N.m, 200 rpm" --plot "$pictures/map.svg" >/dev/null
"$twum" fields "$ring" --set radial_slices=1 --speed "133 rpm" --plot "$pictures/fields.svg" >/dev/null
for study in optimize-ring-60 pareto-power-wear sweep-sobol paper-figure-4 tolerances; do
  "$twum" run "$root/examples/studies/$study.yaml" -o "$scratch/$study" >/dev/null
done
"$twum" explore "$ring" -o "$scratch/designer.html" >/dev/null
python3 "$root/tests/report/take_pictures.py" "$scratch" "$pictures"
python3 "$root/tests/validation/torque_figures.py" "$twum"
