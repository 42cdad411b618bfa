// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>
#include <twum/studies/statistics/distribution.hpp>
#include <twum/studies/yaml/node.hpp>

namespace twum::studies::entries {

/// Largest share of a distribution that may lie outside the admissible range of its parameter. More
/// than that would move mean and spread visibly away from those that were typed.
inline constexpr double kMostCutOff = 0.01;

/// {distribution: normal, mean: ..., sd: ...} and so on of one parameter, SI, cut off at the
/// parameter's admissible range. A draw of a parameter of whole numbers has to be rounded.
/// @throws ValueError if an entry is missing, or no value
Distribution distribution(const YamlNode& node, const ParameterInfo& parameter);

}  // namespace twum::studies::entries
