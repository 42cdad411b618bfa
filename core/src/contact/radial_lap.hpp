// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lap.hpp"
#include "contact/plane_stick.hpp"
#include "contact/radial_step.hpp"

#include <span>

namespace twum::inline v0_1::contact {

/// A stick zone or a step through a slip zone, for drawing its fields.
struct RadialPiece {
  double from, to;
  ZoneState zone;            ///< slip by the side of its traction along the track
  PlaneWave<double> strain;  ///< of stick
  PlaneState<double>
      start;  ///< of a step: the layer where it begins, and its solution at the points of collocation
  std::array<double, Collocation::N> angles;
  std::array<Plane<double>, Collocation::N> rates;
};

/// The layer of such a lap at a phase, in units of P; its velocity is e' / s in units of V0.
struct RadialSample {
  Plane<double> strain, rate, traction;
};
RadialSample sample_of(const RadialPiece& piece, const ContactNumbers<double>& numbers,
                       double theta);

/// What a lap in the plane takes from another one, and leaves.
struct RadialSteps {
  std::span<const RadialStep>
      known;  ///< of a lap from nearby, a guess; of the same lap where S has derivatives
  core::Vector<RadialStep>* taken{nullptr};   ///< its steps are appended to it
  core::Vector<RadialPiece>* trace{nullptr};  ///< its pieces are appended to it
};

/// run_lap() where the surface also moves radially (R2.1): from contact entry through all zones and free flight to the next
/// entry. Slip has no closed form: see SlipStep. Means are good to about 1e-8 of mu_0 p, next to the birth of a zone to 1e-6.
template <typename S>
Lap<S> run_radial_lap(const ContactNumbers<S>& numbers, const LapEntry<S>& entry,
                      const RadialSteps& steps = {});

}  // namespace twum::inline v0_1::contact
