// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/stator_modes.hpp"
#include "point/point.hpp"

#include <twum/core/operating_point.hpp>

#include <optional>

namespace twum::inline v0_1::core {

/// What a solved point says of the motor, its terminals where the modes are known (T7.1 to T7.9, D4.1 to D4.3).
/// @param modes  null if they are not known
OperatingPoint operating_point_of(const DrivenMotor<double>& motor, const SolvedPoint& solved,
                                  double speed, const StatorModes<double>* modes);

/// The backward wave beside a solved point (D6.5 to D6.8).
BackwardWave backward_wave_of(const DrivenMotor<double>& motor, const SolvedPoint& solved,
                              double speed, const StatorModes<double>* modes,
                              const std::optional<double>& rotor_mass);

}  // namespace twum::inline v0_1::core
