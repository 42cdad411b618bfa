// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/motor_model.hpp"

#include <twum/core/operating_point.hpp>

#include <vector>

namespace twum::inline v0_1::core {

/// The contact at a radius of the track, of a motor whose point at this speed has an answer. For one slice it is that at the
/// mean radius.
/// @{

/// Zones from contact entry to exit; none where the wave does not reach the rotor.
std::vector<Zone> zones_at(const DrivenMotor<double>& motor, double speed, double radius);
/// Fields at equally spaced phases -pi .. pi.
std::vector<FieldSample> fields_at(const DrivenMotor<double>& motor, double speed, double radius,
                                   int samples);
/// @}

}  // namespace twum::inline v0_1::core
