// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/contact_problem.hpp"

namespace twum::test {

/// How finely and how long the brute-force oracle integrates.
struct BruteForceOptions {
  int steps{2000};  ///< steps over the contact on the coarsest of the three grids; as many outside
  int max_laps{20000};  ///< laps until the state must repeat
};

/// Periodic state of the layer by time stepping: no closed form, no root finding.
///
/// Each step of length H obeys the balance of momentum in the mean,
///
///     M (z1 - z0) / H + C (z0 + z1) / 2 + G (y0 + y1) / 2 = tau,     y1 - y0 = H (z0 + z1) / 2,
///
/// (trapezoidal rule for y = eps, z = eps'; the terms of absent inertia or damping drop out), and
/// Coulomb's law decides tau by predicting and projecting: the traction that would make the layer stick
/// at the end of the step is kept if it lies within the cone, otherwise tau is the kinetic friction on
/// the cone. A layer that slips goes on slipping until its slip velocity changes sign (that is what
/// makes a static threshold above the kinetic one count). A step in which the mode changes is halved
/// again and again, down to 2^-14 of its length, so a change misplaces nothing by more than that.
///
/// Order: two in H wherever the modes keep their order under refinement. The grid has nodes at entry
/// and exit. Laps are marched from rest on the coarse grid until the state at entry repeats, then on
/// two grids of half and quarter the step, starting from the state before. Results are Richardson's
/// (4 f(H/4) - f(H/2)) / 3. The error estimate is 2 |f(H/4) - f(H/2)|, six times the error that the
/// extrapolation removes, if the three grids show the ratio 4 of a second-order scheme within a
/// quarter, else 4 |f(H/4) - f(H/2)|; plus 1e-12 of the scale for rounding and incomplete repetition.
/// (Events fall anywhere between grid points, which makes the error jump by its own size from grid to
/// grid; hence the factors.)
OracleResult brute_force(const MotorDesign& design, double speed,
                         const BruteForceOptions& options = {});

/// The same scheme on one grid of given size, without extrapolation: the yardstick of the benchmarks.
OracleResult fixed_grid(const MotorDesign& design, double speed, int steps, int max_laps = 20000);

}  // namespace twum::test
