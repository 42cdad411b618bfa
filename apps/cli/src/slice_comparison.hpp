// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "json_parts.hpp"

#include <twum/motors/expression.hpp>

#include <string>
#include <vector>

namespace twum::cli {

/// Metrics of a motor with all of its contact at the mean radius, and with the width of the track.
struct SliceComparison {
  std::vector<studies::MetricExpression> metrics;
  std::vector<MetricValue> one_slice;
  std::vector<MetricValue> track;
  int slices;  ///< as Motor::radial_slices()
};

/// @param design  if it has one slice, the track gets the number that `auto` takes
SliceComparison compare_slices(const MotorDesign& design);

/// Metrics in rows: one slice, the track, and the relative change from the one to the other.
std::string comparison_text(const SliceComparison& comparison);

/// {"slices": number of each panel, "one_slice": {metric: SI value}, "track": {metric: SI value}}
Json comparison_json(const SliceComparison& comparison);

}  // namespace twum::cli
