#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the Debian packages twum and libtwum-dev in build/package, without GSL so that they may be passed on
# (docs/decisions/licences.md). CMake arguments are handed through:
#
#   scripts/package.sh
#   scripts/package.sh -DTWUM_WITH_IPOPT=OFF
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

scripts/install-deps.sh
configure package -DTWUM_WITH_GSL=OFF "$@"
cmake --build --preset package -j "$(jobs)"
(cd build/package && cpack -G DEB)
ls -l build/package/*.deb
