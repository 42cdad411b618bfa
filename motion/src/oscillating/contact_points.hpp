// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <cstddef>
#include <vector>

namespace twum::inline v0_1::motion {

/// The layer of a contact at one radius, in which every point has its own history.
struct LayerLaw {
  /// @throws InputError for a design with slices, with a taper, or with mu_0 > mu.
  explicit LayerLaw(const MotorDesign& design);

  double stiffness;  ///< E / h [Pa/m]
  double thickness;  ///< h [m]
  double shear;      ///< G [Pa]
  double viscosity;  ///< gamma [Pa s]
  double inertia;    ///< m [Pa s^2]
  double friction;   ///< mu
  double pressure;   ///< F_N / (2 pi r b), the mean pressure of the preload [Pa]

  /// True if the traction depends on the strain alone.
  bool is_elastic() const { return viscosity == 0 && inertia == 0; }
};

/// What stator and rotor do at the points within one step. Of an angle xi along the rotor the stator's face has the displacement
/// lift_cos cos(xi) + lift_sin sin(xi) at the end, and the velocity slide_cos cos(xi) + slide_sin sin(xi) along the track in the
/// middle.
struct PointsMove {
  double lift_cos, lift_sin;    ///< [m]
  double slide_cos, slide_sin;  ///< [m/s]
  double rotor;                 ///< r Omega [m/s]
  double duration;              ///< of the step [s]
};

/// Means over the points at the end of a step.
struct PointsMeans {
  double pressure{0}, pressure_cos{0}, pressure_sin{0};  ///< <p>, <p cos xi>, <p sin xi> [Pa]
  double traction{0}, traction_cos{0}, traction_sin{0};  ///< of tau on the rotor [Pa]
  double slip_work{0};  ///< of the friction within the step [J/m^2]
  /// Smallest of mu p - |tau| that the points would have if they stuck [Pa]; negative if any of them slips or is apart.
  double stick_margin{0};
};

/// Points of the rotor's face within a wavelength, with the layer's shear at each of them (M9.1).
class ContactPoints {
 public:
  /// Of a relaxed layer under the preload.
  ContactPoints(const LayerLaw& law, int count);

  /// Height of a rotor without axial inertia, which the pressure balances at every instant [m]; below 1 m, which is apart.
  double balanced_height(const PointsMove& move, double near) const;
  /// One step to a height of the rotor.
  PointsMeans step(const PointsMove& move, double height);

 private:
  PointsMeans elastic_step(const PointsMove& move, double height);
  PointsMeans viscous_step(const PointsMove& move, double height);

  LayerLaw law_;
  std::size_t count_;                           // even
  std::vector<double> cosine_, sine_;           // of xi
  std::vector<double> indentation_, traction_;  // q [m], tau [Pa]
  std::vector<double> strain_, strain_rate_;    // of a layer with viscosity or inertia
};

}  // namespace twum::inline v0_1::motion
