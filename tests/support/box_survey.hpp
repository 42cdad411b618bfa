// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/test_motors.hpp"

#include <twum/core/motor.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace twum::test {

/// Empty if an operating point keeps every law that needs no other program (numbers are finite or named
/// by a status, identity (T7.10), bound (C8.1), losses not negative), else the law it breaks.
/// @param slack  of the identity, of the scale of powers; a tenth of it for losses, a hundredth for the bound
std::string broken_law(const Motor& motor, const OperatingPoint& point, double slack = 1e-10);

/// What the status ok promises all over the ranges of parameters: identity to 1e-6 of the scale of powers.
inline constexpr double kPromised = 1e-6;

/// A point of the box that stood out.
struct NotablePoint {
  std::int64_t index;  ///< of the survey, from 0
  double value;        ///< what it stood out by
  BoxPoint box;
};

/// What was seen on many points of the box of theory section 10.
struct BoxSurvey {
  std::int64_t designs{0};                       ///< asked
  std::map<std::string, std::int64_t> statuses;  ///< status of the point -> how many
  std::map<std::string, std::int64_t> broken;    ///< broken law -> how many
  std::vector<std::string> examples;             ///< of broken laws, at most 20
  std::map<std::string, std::int64_t> metrics;   ///< status of a metric -> how many
  std::int64_t metrics_broken{0};                ///< a number beside a status, or none without
  double identity{0};                            ///< largest imbalance, of the scale of powers
  std::vector<NotablePoint> slowest;             ///< by processor time [s], slowest first
  std::vector<NotablePoint> strangest;           ///< by imbalance, largest first
  std::vector<NotablePoint> slowest_metrics;     ///< by processor time of all metrics [s]
};

struct BoxSurveyOptions {
  std::uint64_t seed{1};
  std::int64_t count{1000};
  /// Every so many points the metrics without argument are asked too; 0 for never.
  std::int64_t metrics_every{0};
};

/// Asks `count` random points of the box. Always the same points for a seed.
BoxSurvey survey_box(const BoxSurveyOptions& options);

/// Asks the ranges of `twum parameters`: every parameter at its ends and beside them, every pair of parameters at their
/// ends, and `count` designs with all parameters random, half of them logarithmic. Each at seven speeds and for all
/// metrics without argument, whose laws are that they are finite, torques within mu_0 F_N r, and efficiencies and shares
/// within 1.
BoxSurvey survey_ranges(std::uint64_t seed, std::int64_t count);

/// A point as an entry of tests/core/identity_cases.yaml.
std::string identity_case(const std::string& name, const BoxPoint& box);

}  // namespace twum::test
