// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "json_parts.hpp"

#include <twum/motors/expression.hpp>

#include <array>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// Metrics of a motor by two models of its contact.
struct ModelComparison {
  std::string heading;
  std::array<std::string, 2> names;  ///< of the two models, as columns
  std::vector<studies::MetricExpression> metrics;
  std::array<std::vector<MetricValue>, 2> values;
  int slices;  ///< of the second model, as Motor::radial_slices()
};

/// All of the contact at the mean radius, and the width of the track.
/// @param design  if it has one slice, the track gets the number that `auto` takes
ModelComparison compare_slices(const MotorDesign& design);

/// A surface that moves along the track only, and one that moves radially, too.
/// @throws InputError if the design has no radial shape
ModelComparison compare_radial(const MotorDesign& design);

/// Metrics in rows: both models, and the relative change from the one to the other.
std::string comparison_text(const ModelComparison& comparison);

/// {"slices": number of each panel, first name: {metric: SI value}, second name: {metric: SI value}}
Json comparison_json(const ModelComparison& comparison);

}  // namespace twum::inline v0_1::cli
