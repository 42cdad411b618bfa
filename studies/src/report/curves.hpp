// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/core/motor_design.hpp>

#include <map>
#include <string>
#include <vector>

/// Curves and fields that a report shows; internal.
namespace twum::studies {

/// Values of some parameters, by flat name [SI].
using DesignValues = std::map<std::string, double>;

/// The values that are numbers, by name.
DesignValues design_values(const std::vector<NamedValue>& values);

enum class Detail : unsigned char {
  torque,  ///< the torque alone
  fields,  ///< every quantity, and the fields in the contact
};

/// {"label", "design", "metrics", "speed": base64, ..., "one_slice_torque", "fields", "track"} of one motor; null if
/// the values are not those of a valid motor.
Json curve_json(const MotorDesign& base, const DesignValues& values, const std::string& label,
                Detail detail);

}  // namespace twum::studies
