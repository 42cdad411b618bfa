// SPDX-License-Identifier: Apache-2.0
#include "contact/radial_lap.hpp"

#include <cmath>

namespace twum::inline v0_1::contact {

RadialSample sample_of(const RadialPiece& piece, const ContactNumbers<double>& n, double theta) {
  const Trig<double> at = trig(theta);
  if (piece.zone == ZoneState::stick) {
    const Plane<double> strain = piece.strain.at(theta, at);
    return {strain, piece.strain.slope(at), carried_traction(n, piece.strain).at(theta, at)};
  }
  const Collocation& c = Collocation::points();
  const double length = piece.to - piece.from, place = (theta - piece.from) / length;
  const Collocation::Row here = c.weights_at(place);
  RadialSample sample{piece.start.e, {0, 0}, {0, 0}};
  double angle = 0;
  for (std::size_t i = 0; i < Collocation::N; ++i) {
    angle += here[i] * piece.angles[i];
    sample.rate = sample.rate + here[i] * piece.rates[i];
    // The polynomial's integral is one of degree N, which the points integrate exactly over a part of the step.
    const Collocation::Row part = c.weights_at(place * c.place[i]);
    for (std::size_t j = 0; j < Collocation::N; ++j)
      sample.strain =
          sample.strain +
          (length * place * c.integral[Collocation::N - 1][i] * part[j]) * piece.rates[j];
  }
  const double size = n.kinetic * std::fmax(n.peak - at.versine, 0.0);
  sample.traction = {size * std::cos(angle), size * std::sin(angle)};
  return sample;
}

}  // namespace twum::inline v0_1::contact
