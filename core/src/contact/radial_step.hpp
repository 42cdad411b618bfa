// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/collocation.hpp"

#include <array>

namespace twum::inline v0_1::contact {

/// A step through a slip zone of a lap in the plane: what takes a lap beside it, or its derivatives, through the same zones without
/// a search.
struct RadialStep {
  int zone;       ///< its number in the lap, from 1
  double length;  ///< [rad]
  bool to_exit;   ///< it ends with the contact
  bool last;      ///< it ends with the zone, before the exit
  std::array<double, Collocation::N> angles;
};

}  // namespace twum::inline v0_1::contact
