// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/motion/motion.hpp>

#include <complex>
#include <string>
#include <vector>

namespace twum::inline v0_1::motion {

/// A state, an input or an output of a linear plant.
struct Signal {
  std::string name;  ///< such as "phase_lag"
  std::string unit;  ///< SI
  double steady{0};  ///< value in the steady state
};

/// A motor near a steady running state: x' = A (x - x0) + B (u - u0), y - y0 = C (x - x0) + D (u - u0), rows by rows. SI units.
struct LinearPlant {
  using Matrix = std::vector<std::vector<double>>;  ///< rows of equal length

  /// amplitude, phase_lag, speed, angle; terminal_voltage_real, terminal_voltage_imaginary, phase_current_real and
  /// phase_current_imaginary behind a driver's circuit; height and rise of an axial motion
  std::vector<Signal> states;
  std::vector<Signal> inputs;  ///< voltage (rms), frequency, load_torque
  std::vector<Signal>
      outputs;  ///< the states, phase_current (rms), and of a motor with a sensor its voltage (rms) and lag
  Matrix a;  ///< A, states by states
  Matrix b;  ///< B, states by inputs
  Matrix c;  ///< C, outputs by states
  Matrix d;  ///< D, outputs by inputs
  /// Eigenvalues of A without the angle, which integrates the speed; the slowest first [1/s]. Those of a driver's circuit that rings
  /// as fast as the stator vibrates, of which an averaged motor knows nothing, come last.
  std::vector<std::complex<double>> poles;
  /// Steady change of each output but the angle over that of each input: -C A^-1 B + D.
  Matrix gains;
};

/// The plant of a motor under its voltage and frequency that carries a load torque (M7.1, M7.2). The derivatives of the contact
/// are exact. Behind a driver with an inductance or a resistance the voltage of the terminals and the current through the inductance
/// are states, in the frame of the inverter's voltage, as peak values (M3.1).
/// @param axial        dynamic: two states more, height and rise of the rotor (M4.5); needs rotor_mass
/// @param load_torque  [N m], in addition to the friction of the design's load
/// @throws InputError for a motor with a given amplitude, a design without rotor_inertia or with a spring on the shaft, and where
///         the motor does not carry the torque
LinearPlant linearize(const MotorDesign& design, double load_torque,
                      AxialMotion axial = AxialMotion::balanced);

/// Growth rate of hops of the rotor (M4.5): the largest real part of the axial pair of poles of wave, speed and axial motion at
/// the same steady state [1/s]. Positive: the rotor hops.
/// @throws InputError as linearize(), and for a design without rotor_mass or with one of 0 kg
double bounce_rate(const MotorDesign& design, double load_torque);

}  // namespace twum::inline v0_1::motion
