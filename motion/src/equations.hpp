// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact.hpp"
#include "integrator.hpp"
#include "model_slopes.hpp"
#include "stretches.hpp"

#include <array>
#include <optional>
#include <span>

namespace twum::motion {

/// States of a motion: zeta = A e^(-i phi) in Cartesian parts, Omega, theta_r, the electrical energy, and the angle by which zeta
/// has turned while the drive is off. Then only A counts for all else; a zeta that stood for its phase, too, would turn
/// thousands of times a second. Of a motor with a given amplitude zeta stays zero.
enum StateIndex : std::size_t { kReal, kImaginary, kSpeed, kAngle, kEnergy, kTurn, kStateCount };
using States = std::array<double, kStateCount>;

/// Which way the rotor may move.
struct Mode {
  bool held;
  double side;  ///< sign of the speed where it is not held, 1 or -1
  bool operator==(const Mode&) const = default;
};

/// Limits of the torque that the contact carries at rest (M4.1).
struct HoldingLimits {
  double forward;   ///< T(0+), torque on a rotor that begins to turn forward
  double backward;  ///< T(0-)
  bool known;       ///< false where the contact has no answer
};

/// (M2.1) and (M2.2) in one stretch and mode.
class Equations final : public OdeSystem {
 public:
  /// @param slopes  of the model, for parameter_slopes()
  explicit Equations(const MotionModel& model, const ModelSlopes* slopes = nullptr)
      : model_(&model), slopes_(slopes), contact_(model) {}

  void set_stretch(const Stretch& stretch) { stretch_ = stretch; }
  void set_mode(Mode mode) { mode_ = mode; }
  const Mode& mode() const { return mode_; }
  const Stretch& stretch() const { return stretch_; }
  const MotionModel& model() const { return *model_; }
  const Contact& contact() const { return contact_; }

  bool rates(double time, std::span<const double> y, std::span<double> dy) override;
  bool jacobian(double time, std::span<const double> y, std::span<double> jacobian) override;
  bool parameter_slopes(double time, std::span<const double> y, std::span<double> slopes) override;
  bool events(double time, std::span<const double> y, std::span<double> values) override;

  double amplitude(double time, std::span<const double> y) const;
  /// Torque of the load and its spring, without friction [N m].
  double load(double time, double angle) const;
  /// Contact at the speed of the mode; its torque has the direction of the rotor.
  ContactForces forces(double time, std::span<const double> y);
  HoldingLimits holding_limits(double time, std::span<const double> y);
  /// Peak voltage at the terminals of a phase, and its current [V, A].
  struct Electrical {
    Complex voltage, current;
    double power() const { return (voltage * std::conj(current)).real(); }  ///< of both phases
  };
  Electrical electrical(double time, std::span<const double> y) const;

 private:
  Complex capacitive_admittance(double time) const;
  /// F / A, and its and the torque's derivatives in amplitude and speed.
  struct ContactDerivatives {
    Complex stiffness, stiffness_per_amplitude, stiffness_per_speed;
    double torque_per_amplitude, torque_per_speed;
  };
  /// Entries of the Jacobian by row and column.
  struct Entries {
    std::span<double> values;
    double& operator()(std::size_t of, std::size_t in) const {
      return values[in * kStateCount + of];
    }
  };
  std::optional<ContactDerivatives> contact_derivatives(double time, std::span<const double> y);
  void add_wave(const Entries& entry, double time, std::span<const double> y,
                const ContactDerivatives& contact) const;
  void add_rotor(const Entries& entry, std::span<const double> y,
                 const ContactDerivatives& contact) const;
  ContactForces forces_at(double time, double amplitude, double speed);
  double omega(double time) const;
  double contact_speed(double speed) const;
  double power_slope(double time, const Electrical& at, Complex dzeta) const;
  struct WaveRate;
  WaveRate wave_rate(double time, Complex contact_stiffness) const;

  Complex wave_slope(double time, std::span<const double> y, const ContactGradients& contact,
                     const ModelSlope& q) const;
  double power_slope(double time, std::span<const double> y, const ModelSlope& q) const;
  Complex off_voltage_slope(double omega, const ModelSlope& q) const;

  const MotionModel* model_;
  const ModelSlopes* slopes_;
  Contact contact_;
  Stretch stretch_{};
  Mode mode_{true, 1};
};

}  // namespace twum::motion
