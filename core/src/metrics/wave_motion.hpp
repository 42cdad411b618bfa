// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/metric_rows.hpp"
#include "model/scalars.hpp"

#include <cmath>
#include <numbers>

namespace twum::inline v0_1::core {

/// x with the directions of kDriveParameters added, with derivatives 0.
template <typename T>
Dual<T, kDesignDirections> widened(const Dual<T, kDirections>& x) {
  Dual<T, kDesignDirections> wide(0.0);
  wide.v = x.v;
  for (int i = 0; i < kDirections; ++i) wide.d[i] = x.d[i];
  return wide;
}

/// The modes of a design with each number as an independent variable; the damping is one of kModelParameters.
template <typename T>
StatorModes<Dual<T, kDesignDirections>> moving_modes(const StatorModes<double>& m,
                                                     const Dual<T, kDirections>& damping) {
  using W = Dual<T, kDesignDirections>;
  using P = Parameter;
  return converted<W>(m, [&](P parameter, double value) {
    return parameter == P::modal_damping ? widened(damping)
                                         : W::variable(T(value), drive_direction(parameter));
  });
}

/// The force of a voltage's peak on the forward wave, Theta u_f (D6.1) [N].
template <typename T>
Dual<T, kDesignDirections> moving_drive(const StatorModes<Dual<T, kDesignDirections>>& modes,
                                        double voltage) {
  using W = Dual<T, kDesignDirections>;
  return std::numbers::sqrt2 *
         (modes.force_factor * W::variable(T(voltage), drive_direction(Parameter::voltage)) *
          modes.unequal.share());
}

/// Derivatives of the amplitude under a drive, for which H(A) = Theta u_0 stays satisfied (D2.9).
template <typename T>
class WaveMotion {
 public:
  using W = Dual<T, kDesignDirections>;

  /// @param excess  H - Theta u_0, with the amplitude's own direction among those of kModelParameters
  explicit WaveMotion(const W& excess) {
    const T inverse = 1.0 / excess.d[kAmplitude];
    for (int i = 0; i < kDesignDirections; ++i) motion_[i] = -(excess.d[i] * inverse);
    motion_[kAmplitude] = T(0.0);
  }

  /// Total derivatives of x, with the amplitude following the drive.
  W of(W x) const {
    const T slope = x.d[kAmplitude];
    for (int i = 0; i < kDesignDirections; ++i) x.d[i] = x.d[i] + slope * motion_[i];
    x.d[kAmplitude] = T(0.0);
    return x;
  }
  /// dA / dOmega
  T in_speed() const { return motion_[kSpeedDirection]; }

 private:
  static constexpr int kAmplitude = static_cast<int>(model_index(Parameter::amplitude));
  T motion_[kDesignDirections];
};

/// The contact for a backward wave, with the directions of kDriveParameters added.
inline DisturbedContact<DesignDual> widened(const DisturbedContact<ModelDual>& contact) {
  DisturbedContact<DesignDual> wide{widened(contact.wave_rate), widened(contact.omega), {}};
  for (const DisturbedSlice<ModelDual>& s : contact.slices) {
    wide.slices.push_back({widened(s.stiffness),
                           widened(s.shape),
                           widened(s.half_angle),
                           widened(s.tilt),
                           widened(s.kinetic),
                           widened(s.shear),
                           widened(s.entry_rate),
                           {}});
    for (const DisturbedZone<ModelDual>& z : s.zones)
      wide.slices.back().zones.push_back(
          {z.state, z.after_slip, z.sign, widened(z.from), widened(z.to)});
  }
  return wide;
}

/// Arguments of wave_metric() from the numbers of a point.
template <typename T>
WavePoint<Dual<T, kDesignDirections>> wave_point(const DrivenMotor<Dual<T, kDirections>>& m,
                                                 const PointNumbers<Dual<T, kDirections>>& n,
                                                 const Dual<T, kDirections>& speed) {
  return {widened(m.mean.amplitude), widened(m.omega), widened(n.reactive_force),
          widened(n.stator_power), widened(n.torque * speed)};
}

}  // namespace twum::inline v0_1::core
