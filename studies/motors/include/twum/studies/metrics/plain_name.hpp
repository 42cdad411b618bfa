// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace twum::studies {

/// A parameter, metric or statistic as one reads it: "peak power", "torque at 80 rpm", "contact layer thickness", "5 % quantile
/// of the stall torque". Formulas stay as they are.
std::string plain_name(const std::string& name);

/// A limit as one reads it: "no-load speed ≥ 100 rpm".
std::string plain_limit(const std::string& text);

}  // namespace twum::studies
