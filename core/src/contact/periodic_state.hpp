// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lap.hpp"
#include "contact/radial_step.hpp"
#include "contact/return_map.hpp"

namespace twum::inline v0_1::contact {

enum class PeriodicStatus : unsigned char {
  ok,
  no_periodic_state,
  not_converged,
  resonance,
  unresolved
};

/// Where a search for a periodic state begins.
struct LapGuess : LapEntry<double> {
  LapGuess() = default;
  LapGuess(const LapEntry<double>& entry, const ZoneSequence& ends = {})
      : LapEntry<double>(entry), zones(ends) {}

  ZoneSequence zones;    ///< where the zones of its lap nearly end; none where that is not known
  bool followed{false};  ///< laps through these zones have led here: one lap verifies the state
  /// Laps from rest lead through the zones of this state: with mu_0 > mu the search may begin here only if that is known.
  bool decided{false};
};

/// The state that repeats itself from turn to turn.
struct PeriodicState {
  LapEntry<double> entry{{0, 0}, false, ZoneState::stick};  ///< layer at contact entry
  Lap<double> lap;                                          ///< the turn that starts there
  PeriodicStatus status{};
  bool remembers{false};  ///< false: the layer enters at rest whatever happened before
  int laps{0};    ///< turns it took to find, followed ones and those with derivatives included
  long zones{0};  ///< of all these turns: what the search cost
  core::Vector<RadialStep> steps{};  ///< of the turn, where the surface moves radially
};

/// Finds the periodic state that laps from rest lead to (theory section 10).
///
/// With mu_0 = mu the lap never increases the energy of a difference of states, because Coulomb's law
/// is monotone (E6.1): the periodic state of a damped layer is unique, and secants over laps that follow known
/// zones (E6.4, E6.5) or Newton's method on the two-state return map (E6.2) go there in a few laps, of
/// which the last is always searched in full. With mu_0 > mu they take over only when the sequence of zones has
/// settled, must keep it, and must end in an attracting state.
///
/// @param guess     state at entry of a neighbouring point, where the search may begin if the periodic
///                  state is unique or decided; null: at rest. A layer that enters at rest takes only the ends of its zones
///                  from it.
/// @param accuracy  how well the state has to come back with mu_0 = mu and damping, in units of its largest
///                  possible size; 0: to rounding
PeriodicState find_periodic_state(const ContactNumbers<double>& numbers,
                                  const LayerMotion<double>& layer, const LapGuess* guess = nullptr,
                                  double accuracy = 0);

/// How a periodic state moves, and how a turn that begins near it differs from one that begins in it: to first order.
struct StateSlopes {
  Matrix2 resolvent{1, 0, 0,
                    1};  ///< (I - J)^-1: leads from the gap of a turn to the periodic state (E6.2)
  LayerState<double> in_speed{0, 0}, in_amplitude{0, 0};  ///< of the state at entry
  /// The means of the stator's power and of the reactive force in the state at entry.
  LayerState<double> of_power{0, 0}, of_force{0, 0};
};

/// Means over a turn with their derivatives in speed and amplitude.
struct MovingMeans {
  ContactMeans<MotionDual> means;
  StateSlopes slopes;
};
MovingMeans moving_means(const ContactNumbers<MotionDual>& numbers, const PeriodicState& state,
                         Means means);

/// Means over a turn with their derivatives: the periodic state in S by the implicit function theorem. With second derivatives
/// those of the wave.
template <typename S>
ContactMeans<S> periodic_means(const ContactNumbers<S>& numbers,
                               const ContactNumbers<double>& values, const PeriodicState& state);

}  // namespace twum::inline v0_1::contact
