// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/motors/motor_limit.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace twum::inline v0_1::motors {

/// A statistic of the motors built to a design: "mean(peak_power)", "sd(no_load_speed)", "quantile(stall_torque, 5
/// %)", "probability(no_load_speed >= 100 rpm)", "yield".
struct StatisticRequest {
  /// Which statistic.
  enum class Kind : std::uint8_t { mean, sd, quantile, probability, yield };
  std::string text;                   ///< as typed, blanks trimmed
  Kind kind{Kind::yield};             ///< which
  MetricExpression metric{};          ///< of mean, sd and quantile
  double probability{0.5};            ///< of a quantile, in (0, 1)
  std::optional<MotorLimit> limit{};  ///< of a probability

  /// SI unit of its value.
  std::string unit() const;
};

/// A limit on a statistic, such as "yield >= 99 %".
struct StatisticLimit {
  std::string text;                                        ///< as typed, blanks trimmed
  StatisticRequest statistic;                              ///< what is limited
  double lower{-std::numeric_limits<double>::infinity()};  ///< SI
  double upper{std::numeric_limits<double>::infinity()};   ///< SI
};

/// True if a text begins like a statistic, whether it is valid or not.
bool is_statistic(std::string_view text);

/// Reads a statistic.
/// @throws ValueError with the position in the text, what was found and what would be right
StatisticRequest parse_statistic(std::string_view text);

/// Reads a limit on a statistic: a statistic, ">=" or "<=", and a quantity. A yield or probability has a lower limit between
/// 0 and 100 %.
/// @throws ValueError as parse_statistic()
StatisticLimit parse_statistic_limit(std::string_view text);

}  // namespace twum::inline v0_1::motors
