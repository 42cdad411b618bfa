// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

namespace twum::test {

/// The contact of one motor at one rotor speed, as the oracles see it: the numbers of the differential
/// equation (T4.1) and nothing of its solution. Derived here anew from the plain design, so that a
/// wrong formula in the core is not shared.
struct ContactProblem {
  double half_angle;  ///< theta_L [rad]; pi in full contact
  bool full;
  double pressure_amplitude;  ///< E A / h [Pa]; the pressure is this times (cos theta - c)
  double edge_cosine;         ///< c [1]
  double inertia;             ///< M = m W^2 [Pa]
  double damping;             ///< C = gamma W [Pa]
  double stiffness;           ///< G [Pa]
  double kinetic;             ///< mu [1]
  double threshold;           ///< mu_0 [1]
  double rotor_velocity;      ///< U [m/s]
  double crest_velocity;      ///< V0 [m/s]
  double strain_velocity;  ///< h W: layer surface speed against the rotor for a unit of eps' [m/s]
  double track_area;       ///< 2 pi r b [m^2]
  double radius;           ///< r [m]
  double speed;            ///< Omega [rad/s]
  double power_scale;      ///< mu_0 F_N max(V0, |U|) [W] (T7.11)
  double torque_scale;     ///< mu_0 F_N r [N m] (T7.8)

  double pressure(double theta) const;                    ///< p [Pa]; only inside the contact
  double sticking_rate(double theta) const;               ///< eps' of a layer that sticks [1]
  double slip_velocity(double theta, double rate) const;  ///< v_rel for eps' = rate [m/s]
};

/// Result of an oracle, every number in SI units, with its own estimate of the error.
struct OracleResult {
  double torque{0};
  double stator_power{0};
  double friction_power{0};
  double layer_loss{0};
  double torque_error{0};  ///< estimate, [N m]
  double power_error{0};   ///< estimate for the worst of the three powers [W]
  int laps{0};
  bool converged{false};
};

ContactProblem contact_problem(const MotorDesign& design, double speed);

}  // namespace twum::test
