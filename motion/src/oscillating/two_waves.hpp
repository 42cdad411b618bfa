// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model.hpp"
#include "oscillating/contact_points.hpp"

#include <array>

namespace twum::inline v0_1::motion {

/// A number for each of the two modes or phases, cosine first.
using Two = std::array<double, 2>;

/// What acts on a motor at one instant of the vibration.
struct ActingNow {
  Two voltage;         ///< of the inverter at the phases while the drive is on [V]
  bool off;            ///< the phases lie on off_resistance
  double load_torque;  ///< T_L [N m]
};

/// Modes, rotor and phases at one instant. SI units.
struct WavesState {
  Two displacement{}, velocity{};  ///< of the modes, w_c and w_s
  Two voltage{};                   ///< at the terminals of the phases
  Two current{};                   ///< through the inductance of the driver
  double angle{0}, speed{0};       ///< theta_r, Omega
  double height{0}, rise{0};       ///< of the rotor's face z, and its velocity
};

/// Work since the last time it was taken [J].
struct WavesWork {
  double drive{0};             ///< electrical, into both phases
  double contact{0};           ///< from the stator to the layer
  double friction{0};          ///< lost by slip
  double impulse{0};           ///< of the contact's torque on the rotor [N m s]
  double stick_margin{1e300};  ///< the smallest of PointsMeans [Pa]
};

/// Every vibration of both modes, of the rotor and of the points of its face (theory of motion, section 10). The whole ring repeats
/// one wavelength.
class TwoWaves {
 public:
  /// @param points  of the rotor's face within a wavelength, even
  TwoWaves(const MotorDesign& design, const MotionModel& model, int points);

  const WavesState& state() const { return state_; }
  /// Begins from a state, with a relaxed layer.
  void set_state(const WavesState& state) { state_ = state; }
  /// Layer and height of a rotor over which a wave of constant size runs with constant speed: the displacement after each step
  /// of a turn is given.
  void lead(const Two& displacement, double speed, double duration);

  /// Steps of the length that follow.
  void set_step(double duration);
  /// One step: half a kick by all forces, a free drift, half a kick by the forces there.
  void step(const ActingNow& before, const ActingNow& after);

  /// Torque of the contact on the rotor [N m].
  double torque() const { return torque_; }
  /// What was done since the last call.
  WavesWork take_work();
  /// The largest step that resolves the rotor's and the modes' oscillation on the contact [s].
  double longest_step() const;

 private:
  // x1 = xx x + xv v, v1 = vx x + vv v: a damped oscillator after one step.
  struct Drift {
    double xx, xv, vx, vv;
  };
  Drift drift_of(double stiffness) const;
  // One phase with its capacitance behind an inductance (index 0) and a resistance: x1 = left x + source (V, -Theta w') of
  // x = (I, u), exact for constant V and w'. Without an inductance I follows.
  struct Circuit {
    double left[2][2], source[2][2];
  };
  Circuit circuit_of() const;
  double work_through_resistance(std::size_t phase, double before, double way) const;
  void kick(const ActingNow& acting);
  void drift(const ActingNow& before, const ActingNow& acting);
  void lie_on_resistance(const Two& way);
  void feed(const Two& voltage, const Two& way);
  void move_contact(const Two& way, double duration);
  bool is_light() const { return rotor_mass_ == 0; }

  const MotionModel* model_;
  LayerLaw law_;
  ContactPoints points_;
  double wavelengths_, radius_, surface_;  // n, r, a kappa
  double area_;                            // 2 pi r b
  double rotor_mass_, axial_damping_;      // m_r, d_z
  Two stiffness_;                          // of the modes
  double conductance_;                     // of the loss of a phase, omega C_0 tan delta
  WavesState state_{};
  Two force_{};       // of the contact on the modes
  double torque_{0};  // on the rotor
  double pressure_;   // mean
  double duration_{0};
  std::array<Drift, 2> drifts_{};
  Circuit circuit_{};
  WavesWork work_{};
};

}  // namespace twum::inline v0_1::motion
