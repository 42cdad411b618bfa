// SPDX-License-Identifier: Apache-2.0
#include <twum/base/version.hpp>

namespace twum {

const char* version() noexcept { return TWUM_VERSION; }

}  // namespace twum
