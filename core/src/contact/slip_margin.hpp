// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/periodic_state.hpp"

namespace twum::inline v0_1::contact {

/// How far a contact that is made to slip and drive all through is from sticking somewhere.
struct SlipMargin {
  double value;              ///< smallest -v_rel s / V0 [units of P]; negative past the plateau
  double place;              ///< where, since entry [rad]
  bool exit;                 ///< at the exit edge
  bool slips;                ///< value > 0
  LayerState<double> entry;  ///< periodic state of the layer that always slips, at entry
};

/// The smallest margin over the contact, none overlooked: the search for the first zero of the curve
/// less the smallest value so far goes on until there is none.
SlipMargin slip_margin(const ContactNumbers<double>& numbers);

/// The margin at a given place, with derivatives. At an inner minimum the place may be held fixed.
template <typename S>
S slip_margin_at(const ContactNumbers<S>& numbers, const SlipMargin& margin);

}  // namespace twum::inline v0_1::contact
