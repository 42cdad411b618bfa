#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds everything and runs all tests but the slow ones. Ends with ctest's summary; exits with an
# error if a test fails or none ran. Slow tests: scripts/test-long.sh.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

scripts/install-deps.sh test
configure ci
cmake --build --preset ci -j "$(jobs)"
ctest --test-dir build/ci --output-on-failure --no-tests=error -j "$(jobs)"
