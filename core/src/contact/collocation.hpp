// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/small_system.hpp"

namespace twum::inline v0_1::contact {

/// Collocation at the Radau points of a step, the last of which is its end: of order 2 N - 1 at the end, and stable however
/// stiff the equation is (Hairer and Wanner, Solving Ordinary Differential Equations II, IV.5).
struct Collocation {
  static constexpr std::size_t N = 5;
  using Row = std::array<double, N>;
  using Matrix = SquareMatrix<N>;

  Row place;  ///< of the points, in parts of the step
  Matrix
      integral;  ///< over the polynomial through values at the points, from the start to each of them
  Matrix
      rate;  ///< its inverse: from values to derivatives of the polynomial that is 0 at the start
  Row rate_of_one;  ///< sum of each row of `rate`
  Row highest;  ///< Legendre coefficient of degree N - 1 of the polynomial through values at the points
  Row slope_at_end;  ///< derivative of that polynomial at the end

  static constexpr std::size_t kLooks = 2 * N;
  /// Places that show the polynomial through values at the points: the start, the points, and the middles between them.
  std::array<double, kLooks> look;
  std::array<Row, kLooks> look_weights;  ///< weights_at() these

  /// Values at a place of the polynomial through those at the points, as weights.
  Row weights_at(double place) const;

  static const Collocation& points();

 private:
  Collocation();
};

}  // namespace twum::inline v0_1::contact
