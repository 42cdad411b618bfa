#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the Debian packages twum and libtwum-dev in build/package. What is passed on is built without
# Ipopt where GSL is linked (docs/decisions/licences.md); CMake arguments are handed through:
#
#   scripts/package.sh
#   scripts/package.sh -DTWUM_WITH_IPOPT=OFF
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

scripts/install-deps.sh
configure package "$@"
cmake --build --preset package -j "$(jobs)"
(cd build/package && cpack -G DEB)
ls -l build/package/*.deb
