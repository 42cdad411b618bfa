// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <array>

namespace twum::inline v0_1::core {

class Differentiator;

/// Derivatives in every parameter, with the others in use held, and in the speed.
struct Row {
  std::array<double, kParameterCount> in{};
  double in_speed{0};

  double& operator[](Parameter p) { return in[index_of(p)]; }
  double operator[](Parameter p) const { return in[index_of(p)]; }
};

/// What determines a wave that a drive holds: derivatives of a motor of given amplitude and frequency at a speed.
struct WaveRows {
  Row torque, voltage;
  Row lag;  ///< of R + i I (D2.4, D8.3)
  Smoothness smoothness{Smoothness::smooth};
};

/// @param speed  [rad/s], more than 0
/// @param modes  false: the torque alone
WaveRows wave_rows(const Motor& motor, double speed, bool modes, bool fixed_static_friction);
/// The same with derivatives that others use, too.
/// @param numbers  of the motor
WaveRows wave_rows(Differentiator& numbers, const Motor& motor, double speed, bool modes,
                   bool fixed_static_friction);

/// How amplitude and frequency of the wave move so that what it has to keep is kept (Y2.6).
struct WaveSlopes {
  Row amplitude, frequency;

  /// A row with the wave following.
  Row along_wave(Row row) const;
};

/// Both follow.
WaveSlopes keeping(const Row& one, const Row& other);
/// The amplitude follows; the frequency is given.
WaveSlopes keeping(const Row& one);

}  // namespace twum::inline v0_1::core
