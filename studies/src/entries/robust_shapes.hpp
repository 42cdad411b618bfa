// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "entries/tolerance_shape.hpp"

#include <twum/motors/statistic.hpp>

#include <optional>
#include <vector>

namespace twum::inline v0_1::studies::shapes {

/// A limit of a search: on the motor, or on a statistic of the built motors.
struct StudyLimit {
  std::optional<MotorLimit> plain;
  std::optional<StatisticLimit> statistic;
};

/// Limits, those on statistics among them.
Shape<std::vector<StudyLimit>> study_limits();

/// The entry for the limits of a study S, which has `statistics` for those on statistics.
template <typename S>
Field<S> limits_field(const char* name, std::vector<MotorLimit> S::*member) {
  const Shape<std::vector<StudyLimit>> shape = study_limits();
  Field<S> field = optional<S>(name, constraints(), member, "none");
  field.entry.schema = shape.schema;
  field.read = [read = shape.read, member](S& into, const YamlNode& node, const Spot& spot,
                                           Diagnostics& diagnostics) {
    std::vector<StudyLimit> limits;
    const bool right = read(limits, node, spot, diagnostics);
    for (StudyLimit& limit : limits) {
      if (limit.plain) (into.*member).push_back(std::move(*limit.plain));
      if (limit.statistic) into.statistics.push_back(std::move(*limit.statistic));
    }
    return right;
  };
  field.write = [write = shape.write, member](const S& from) {
    std::vector<StudyLimit> limits;
    for (const MotorLimit& limit : from.*member) limits.push_back({limit, {}});
    for (const StatisticLimit& limit : from.statistics) limits.push_back({{}, limit});
    return limits.empty() ? std::nullopt : std::optional<YamlNode>(write(limits));
  };
  return field;
}

/// The entry `tolerances` of a study S.
template <typename S>
Field<S> tolerances_field() {
  return hidden(optional<S>("tolerances", tolerances("how built motors differ from the design"),
                            &S::tolerances, "every motor equals the design"));
}

template <typename S>
Field<S> correlations_field() {
  return hidden(optional<S>("correlations", correlations(), &S::correlations, "none"));
}

/// The entry `parts` of a study S, a table of measured parts.
template <typename S>
Field<S> parts_field() {
  return hidden(optional<S>(
      "parts",
      path("table of measured parts: one row for each part, one column for each measured "
           "parameter, and optionally 'weight'; each motor takes one whole row",
           "parts.csv"),
      &S::parts, "none"));
}

/// Adds errors for tolerances that a search cannot use, for statistics without tolerances, and for tolerances without
/// statistics.
void check_statistics(const std::vector<Tolerance>& tolerances,
                      const std::vector<StatisticLimit>& statistics, const Given& given,
                      Diagnostics& diagnostics);

}  // namespace twum::inline v0_1::studies::shapes
