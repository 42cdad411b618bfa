#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds twum and runs its main job: a study file in, the best motor under its limits out.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

study=examples/studies/optimize-ring-60.yaml

scripts/install-deps.sh
configure release -DTWUM_BUILD_TESTS=OFF -DTWUM_BUILD_BENCH=OFF >&2
cmake --build --preset release --target twum -j "$(jobs)" >&2

echo "\$ twum run $study"
build/release/bin/twum run "$study" -o build/demo/optimize-ring-60 --fresh
