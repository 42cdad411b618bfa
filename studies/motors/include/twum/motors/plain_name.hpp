// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <string>

namespace twum::inline v0_1::motors {

/// The name of a parameter, metric or statistic in words: "peak power", "torque at 80 rpm", "contact layer
/// thickness", "5 % quantile of the stall torque". Formulas stay as they are.
std::string plain_name(const std::string& name);

/// A limit in words: "no-load speed ≥ 100 rpm".
std::string plain_limit(const std::string& text);

}  // namespace twum::inline v0_1::motors
