// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lap.hpp"

#include <optional>

namespace twum::contact {

/// Where two contacts that hardly differ part, on their way from rest or because the periodic state of one has ended. With
/// mu_0 > mu a zone may begin with a length, and all that follows jumps.
struct Jump {
  enum class Kind : unsigned char {
    in_slip,   ///< v_rel touches zero inside a slip zone
    in_stick,  ///< the traction touches its threshold inside a stick zone
    at_start,  ///< it is at its threshold where a zone begins
    at_entry   ///< it rises from the edge of the contact as fast as that of slip
  };
  Kind kind;
  int turn;                        ///< turns before
  int zone;                        ///< zones before, in the turn
  double side;                     ///< sign of v_rel, or of the traction at its threshold
  double place;                    ///< phase, near which the touching is [rad]
  LapEntry<double> entry{{0, 0}};  ///< of the first turn: rest, or a periodic state
  int beside{
      0};  ///< the margin has an answer on the side of the first contact (-1), of the second (1), on both (0)
};

/// Nothing if they go through the same zones, or part only after very many turns.
std::optional<Jump> jump_between(const ContactNumbers<double>& a, const ContactNumbers<double>& b);

/// What a contact that parts at a jump from its neighbours has left to the touching: it vanishes at the jump, and what lies on
/// both sides has unlike signs. Smooth. Units of P.
template <typename S>
S jump_margin(const ContactNumbers<S>& numbers, const Jump& jump);

}  // namespace twum::contact
