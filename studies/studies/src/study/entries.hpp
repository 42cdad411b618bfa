// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>
#include <twum/studies/metrics/constraint.hpp>
#include <twum/studies/metrics/expression.hpp>
#include <twum/studies/yaml/node.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// Values of entries of a study that is known to be right (read_study_file); internal.
namespace twum::studies::entries {

/// {min, max, scale, start} of one parameter, SI.
struct Range {
  Parameter parameter;
  double min;
  double max;
  bool log{false};
  double start{std::numeric_limits<double>::quiet_NaN()};  ///< NaN: not given
};

std::vector<Range> ranges(const YamlNode& study);

/// The list of metrics below `name`, empty if it is not there.
std::vector<MetricExpression> metrics(const YamlNode& study, std::string_view name = "metrics");
std::vector<Constraint> constraints(const YamlNode& study, std::string_view name);

std::uint64_t count(const YamlNode& study, std::string_view name, std::uint64_t fallback);
/// A quantity in the SI unit given.
double quantity(const YamlNode& study, std::string_view name, std::string_view unit,
                double fallback);
std::string word(const YamlNode& study, std::string_view name, std::string_view fallback);

}  // namespace twum::studies::entries
