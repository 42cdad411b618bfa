// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::inline v0_1 {

/// State of the contact over an interval of the wave; theory section 4.
enum class ZoneState : signed char {
  slip_minus = -1,  ///< v_rel > 0: the layer is faster than the stator and is braked
  stick = 0,        ///< v_rel = 0
  slip_plus = +1    ///< v_rel < 0: the stator is faster and drives
};

/// "slip-", "stick" or "slip+"; static lifetime.
const char* to_string(ZoneState state) noexcept;

/// One stick or slip zone.
struct Zone {
  ZoneState state;  ///< what the contact does there
  double from;      ///< phase at which it begins [rad]
  double to;        ///< phase at which it ends [rad], from < to
};

}  // namespace twum::inline v0_1
