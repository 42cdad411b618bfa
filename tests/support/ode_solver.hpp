// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/contact_problem.hpp"

namespace twum::test {

/// Explicit Runge-Kutta pairs of GSL: order of the step, and of its error estimate.
enum class OdeMethod : unsigned char {
  prince_dormand_8_9,
  fehlberg_4_5,  ///< the order of MATLAB's ode45
};

struct OdeOptions {
  OdeMethod method{OdeMethod::prince_dormand_8_9};
  double tolerance{1e-13};  ///< error per step of each component, relative to its scale
  double repeat{1e-12};     ///< the state at entry repeats to this, relative to its scale
  int max_laps{5000};
  /// Longest step [rad]. Events show as a change of sign between steps, so a slip velocity that only dips
  /// through zero within one is missed; a shorter step misses less.
  double max_step{0.1};
};

/// Periodic state of a damped or inertial layer by a general ODE solver with event location.
///
/// What an engineer without the closed forms would write: the layer equation (T4.1) and the four integrals
/// of torque and powers as one system for a Runge-Kutta method of GSL with step control; an event
/// (slip velocity changes sign, traction reaches the static threshold) inside a step is found as a
/// root by repeating the step with shorter lengths; laps are marched from rest until the state at
/// entry repeats.
///
/// Accuracy: the global error is about the tolerance times the number of steps of a lap (some
/// hundreds), amplified by no growth as the layer is damped: 1e-11 of the scales at 1e-13. The error
/// estimate is the difference to a run at 30 times the tolerance, plus 1e-12 of the scale.
/// @pre the layer has inertia or damping.
OracleResult ode_solver(const MotorDesign& design, double speed, const OdeOptions& options = {});

/// One run without the error estimate: what the benchmarks time.
OracleResult ode_solver_run(const MotorDesign& design, double speed,
                            const OdeOptions& options = {});

}  // namespace twum::test
