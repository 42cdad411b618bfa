// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/motor_model.hpp"

#include <twum/core/performance/motor.hpp>

namespace twum::performance {

/// Zones of the periodic state; empty if there is none.
std::vector<Zone> zones(const MotorModel<double>& model, double speed);

/// Fields at equally spaced phases -pi .. pi; empty if there is no periodic state.
std::vector<FieldSample> sample_fields(const MotorModel<double>& model, double speed, int samples);

}  // namespace twum::performance
