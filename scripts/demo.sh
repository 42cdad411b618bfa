#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds twum and runs its main job: a motor file in, a torque-speed curve with its metrics out.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

motor=examples/motors/ring-60.yaml

scripts/install-deps.sh
configure release -DTWUM_BUILD_TESTS=OFF -DTWUM_BUILD_BENCH=OFF >&2
cmake --build --preset release --target twum -j "$(jobs)" >&2

echo "\$ twum curve $motor"
build/release/bin/twum curve "$motor"
