// SPDX-License-Identifier: Apache-2.0
#include <twum/core/zone.hpp>

namespace twum::inline v0_1 {

const char* to_string(ZoneState state) noexcept {
  return state == ZoneState::stick ? "stick" : state == ZoneState::slip_plus ? "slip+" : "slip-";
}

}  // namespace twum::inline v0_1
