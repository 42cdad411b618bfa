// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lap.hpp"

#include <optional>

namespace twum::inline v0_1::contact {

/// The place in the laps of two nearly equal contacts from which on they differ by more than a little (W4.5): with mu_0 > mu a zone
/// may begin with a length at once, and all that follows jumps. The laps begin at rest, or in the periodic state that only one of
/// the two contacts has.
struct Jump {
  enum class Kind : unsigned char {
    in_slip,   ///< v_rel touches zero inside a slip zone
    in_stick,  ///< the traction touches its threshold inside a stick zone
    at_start,  ///< it is at its threshold where a zone begins
    at_entry   ///< it rises from the edge of the contact as fast as that of slip
  };
  Kind kind;
  int turn;                        ///< number of whole turns before it
  int zone;                        ///< number of zones before it, in its turn
  double side;                     ///< sign of v_rel, or of the traction at its threshold
  double place;                    ///< phase near it [rad]
  LapEntry<double> entry{{0, 0}};  ///< where the first turn begins
  int beside{0};  ///< contact that has the state at entry: the first (-1), the second (1), both (0)
};

/// Nothing if the zones of all turns agree, or differ only by zones that begin with no length, or first differ after 200 turns.
std::optional<Jump> jump_between(const ContactNumbers<double>& a, const ContactNumbers<double>& b);

/// The margin g of (W4.5): the least |v_rel| or the least of mu_0 p - |t| near the jump's place, with its sign. It is zero for the
/// contact at the jump, and has opposite signs on the two sides of it. Smooth. Tractions in units of P, rates as E1.3 has them.
template <typename S>
S jump_margin(const ContactNumbers<S>& numbers, const Jump& jump);

}  // namespace twum::inline v0_1::contact
