// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "equations.hpp"

#include <twum/motion/linear_plant.hpp>

#include <Eigen/Core>

#include <complex>
#include <numbers>
#include <string>
#include <vector>

namespace twum::inline v0_1::motion {

/// States and inputs of a plant in their order; states of driver and height follow.
/// @{
enum : Eigen::Index { kA, kPhi, kOmega, kTheta, kPlantStates };
enum : Eigen::Index { kV, kF, kT, kPlantInputs };
/// @}

inline Eigen::Index as_index(std::size_t place) { return static_cast<Eigen::Index>(place); }

/// The steady state of a plant, SI.
struct PlantPoint {
  double amplitude, phase_lag, speed, voltage, frequency, load_torque;
  Equations::Electrical terminals;
  double omega() const { return 2 * std::numbers::pi * frequency; }
  Complex zeta() const { return std::polar(amplitude, -phase_lag); }
};

/// Outputs of a plant beside their rows of C and D (M7.2).
class PlantOutputs {
 public:
  using Row = Eigen::RowVectorXd;

  /// The states first.
  explicit PlantOutputs(const std::vector<Signal>& states);

  /// `phase_current`, of the drive or of the states of its circuit, rms [A].
  void add_current(const MotionModel& model, const PlantPoint& at, const StatePlaces& places);
  /// `sensor_voltage`, rms [V], and `sensor_phase` [rad] (D7.1).
  void add_sensor(const Sensor& sensor, const PlantPoint& at);

  std::vector<Signal> signals;
  std::vector<Row> c, d;

 private:
  struct Phasor;
  void add(Signal signal, const Row& in_states, const Row& in_inputs);
  template <typename Part>
  void add_real(Signal signal, const Phasor& p, Part part);
  void add_size(Signal signal, const Phasor& p);
  void add_lag(Signal signal, const Phasor& p);

  Eigen::Index count_;
};

}  // namespace twum::inline v0_1::motion
