// SPDX-License-Identifier: Apache-2.0
#include <twum/base/version.hpp>

#define TWUM_QUOTED(number) #number
#define TWUM_TEXT(major, minor, patch) \
  TWUM_QUOTED(major) "." TWUM_QUOTED(minor) "." TWUM_QUOTED(patch)

namespace twum::inline v0_1 {

const char* version() noexcept {
  return TWUM_TEXT(TWUM_VERSION_MAJOR, TWUM_VERSION_MINOR, TWUM_VERSION_PATCH);
}

const char base::TWUM_NAME_WITH_VERSION(TWUM_VERSION_MAJOR, TWUM_VERSION_MINOR) = 1;

}  // namespace twum::inline v0_1
