// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace twum::inline v0_1::motion {

/// The contact while the rotor turns to one side: values at amplitude j and speed ratio i stand at [i * amplitudes + j].
struct ContactTable {
  std::vector<double> torque;              ///< T on the rotor, in the direction of the wave [N m]
  std::vector<double> reactive_stiffness;  ///< Re F / A [N/m]
  std::vector<double> active_stiffness;    ///< Im F / A [N/m]
};

/// Numbers from which a motor can be followed in time without its contact being solved (M2.1, M2.2): those of wave, rotor and
/// load, and tables of T and F over A and r Omega / V0 at the design's frequency. SI units.
struct PlantTable {
  double modal_mass;           ///< m_s
  double modal_damping;        ///< d_s
  double modal_stiffness;      ///< k_s
  double force_factor;         ///< Theta
  double blocked_capacitance;  ///< C_0
  double loss_tangent;         ///< tan delta
  double rotor_inertia;        ///< J_r
  double load_inertia;         ///< J_L
  double load_damping;         ///< c_L
  double load_friction;        ///< T_c
  double off_resistance;       ///< R_off
  double voltage;              ///< of the design, rms [V]
  double frequency;            ///< of the design's drive [Hz]
  double opening_amplitude;    ///< A_1 (D1.5)
  double holding_torque;       ///< mu_0 F_N r (T7.8)
  double
      crest_per_amplitude;  ///< V0 / (r omega A) [1/m]: the crest's speed over r, of A = 1 m and omega = 1 rad/s

  /// Rising from 0; evenly spaced in asinh(A / A_1), so linearly where the contact is full and logarithmically far above [m].
  std::vector<double> amplitudes;
  /// v = r |Omega| / V0, rising from 0, the limit at rest; evenly spaced in v / (1 + v), so that half of them lie below 1. The
  /// last stands for all that are larger.
  std::vector<double> speed_ratios;
  ContactTable along;    ///< rotor turns as the wave drives it
  ContactTable against;  ///< rotor turns the other way
};

/// Size of a table, and who watches.
struct PlantTableOptions {
  std::size_t amplitudes{129};    ///< at least 2
  std::size_t speed_ratios{129};  ///< at least 2, for each side
  /// Largest amplitude [m]; 0 for twice that of the free wave at resonance under the design's voltage.
  double largest_amplitude{0};
  /// Told the share that is done after each row; false ends it. May be empty.
  std::function<bool(double)> go_on{};
};

/// The table of a motor under a voltage: some 33,000 contacts.
/// @return nothing if `go_on` ended it
/// @throws InputError for a motor with a given amplitude or a voltage of 0 V, a design without rotor_inertia, with unequal phases or with a spring on
///         the shaft, and where the contact has no answer.
std::optional<PlantTable> tabulate(const MotorDesign& design,
                                   const PlantTableOptions& options = {});

}  // namespace twum::inline v0_1::motion
