#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Velocities, tractions and zones along one wave in the four regimes of figure 3 of the paper.
# Usage: figure-3.sh MOTOR DIR     (twum on the PATH, or its path in TWUM)
set -euo pipefail

twum=${TWUM:-twum}
motor=${1:?a motor file}
directory=${2:?a directory for the results}
mkdir -p "$directory"
radius=(--set radial_slices=1)  # all of the contact at the mean radius, as in the paper

no_load=$("$twum" curve "$motor" "${radius[@]}" --points 2 --format json |
  python3 -c 'import json, sys; print(json.load(sys.stdin)["metrics"]["no_load_speed"])')
for percent in 0 85 95 130; do
  speed=$(python3 -c "print($no_load * $percent / 100)")
  "$twum" fields "$motor" "${radius[@]}" --speed "$speed rad/s" --format csv -o "$directory/at-$percent-percent.csv"
  echo "$directory/at-$percent-percent.csv: $percent % of the no-load speed"
done
