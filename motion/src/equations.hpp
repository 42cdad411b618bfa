// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact.hpp"
#include "integrator.hpp"
#include "model_slopes.hpp"
#include "state_places.hpp"
#include "stretches.hpp"

#include <optional>
#include <span>

namespace twum::inline v0_1::motion {

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

/// (M2.1) and (M2.2) in one stretch and mode, with (M3.1) behind a series branch and (M4.5) for a rotor with an axial mass.
class Equations final : public OdeSystem {
 public:
  /// @param slopes  of the model, for parameter_slopes()
  explicit Equations(const MotionModel& model, const ModelSlopes* slopes = nullptr,
                     AxialMotion axial = AxialMotion::balanced)
      : model_(&model), slopes_(slopes), contact_(model), places_(model, axial) {}

  void set_stretch(const Stretch& stretch) { stretch_ = stretch; }
  void set_mode(Mode mode) { mode_ = mode; }
  const Mode& mode() const { return mode_; }
  const Stretch& stretch() const { return stretch_; }
  const MotionModel& model() const { return *model_; }
  const Contact& contact() const { return contact_; }
  const StatePlaces& places() const { return places_; }
  /// True while the terminals have states of their own: behind a series branch with the drive on.
  bool has_circuit() const { return places_.voltage != StatePlaces::kNone && !stretch_.off; }

  bool rates(double time, std::span<const double> y, std::span<double> dy) override;
  bool jacobian(double time, std::span<const double> y, std::span<double> jacobian) override;
  bool parameter_slopes(double time, std::span<const double> y, std::span<double> slopes) override;
  bool events(double time, std::span<const double> y, std::span<double> values) override;
  bool rings() const override { return places_.count > kBaseStates; }

  double amplitude(double time, std::span<const double> y) const;
  /// Torque of the load and its spring, without friction [N m].
  double load(double time, double angle) const;
  /// Contact at the speed of the mode; its torque has the direction of the rotor.
  ContactForces forces(double time, std::span<const double> y);
  HoldingLimits holding_limits(double time, std::span<const double> y);
  /// Peak voltages at the terminals of a phase and of the inverter, and the current [V, A]. While the drive is off there is no
  /// inverter, and the terminals stand for it.
  struct Electrical {
    Complex voltage, current, source;
    double power() const { return (source * std::conj(current)).real(); }  ///< of both phases
  };
  Electrical electrical(double time, std::span<const double> y) const;
  /// u and I that belong to the wave of a state in the long run (M3.2).
  Electrical settled_circuit(double time, std::span<const double> y) const;
  /// Puts u and I into a state.
  void set_circuit(std::span<double> y, Complex voltage, Complex current) const;

 private:
  Complex capacitive_admittance(double time) const;
  /// F / A, and its and the torque's derivatives in amplitude, speed and height.
  struct ContactDerivatives {
    Complex stiffness, stiffness_per_amplitude, stiffness_per_speed, stiffness_per_height;
    double torque_per_amplitude, torque_per_speed, torque_per_height;
  };
  /// Entries of the Jacobian by row and column.
  struct Entries {
    std::span<double> values;
    std::size_t count;
    double& operator()(std::size_t of, std::size_t in) const { return values[in * count + of]; }
    void put(std::size_t of, std::size_t in, Complex slope) const {
      (*this)(of, in) = slope.real(), (*this)(of + 1, in) = slope.imag();
    }
  };
  std::optional<ContactDerivatives> contact_derivatives(double time, std::span<const double> y);
  void add_wave(const Entries& entry, double time, std::span<const double> y,
                const ContactDerivatives& contact) const;
  void add_circuit(const Entries& entry, double time) const;
  void add_rotor(const Entries& entry, std::span<const double> y,
                 const ContactDerivatives& contact) const;
  void add_height(const Entries& entry, double time, std::span<const double> y) const;
  double height(std::span<const double> y) const;
  ContactForces forces_at(double time, double amplitude, double speed, double height);
  double omega(double time) const;
  double contact_speed(double speed) const;
  double power_slope(double time, const Electrical& at, Complex dzeta) const;
  struct WaveRate;
  WaveRate wave_rate(double time, std::span<const double> y, Complex contact_stiffness) const;
  /// u' and I' (M3.1).
  struct CircuitRate {
    Complex voltage, current;
  };
  CircuitRate circuit_rate(double time, std::span<const double> y, Complex wave) const;
  CircuitRate circuit_slope(double time, std::span<const double> y, Complex wave, Complex dwave,
                            const ModelSlope& q) const;
  Complex source(double time) const;

  Complex wave_slope(double time, std::span<const double> y, const ContactGradients& contact,
                     const ModelSlope& q) const;
  double power_slope(double time, std::span<const double> y, const ModelSlope& q) const;
  Complex off_voltage_slope(double omega, const ModelSlope& q) const;

  const MotionModel* model_;
  const ModelSlopes* slopes_;
  Contact contact_;
  StatePlaces places_;
  Stretch stretch_{};
  Mode mode_{true, 1};
};

}  // namespace twum::inline v0_1::motion
