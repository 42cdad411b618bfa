// SPDX-License-Identifier: Apache-2.0
#include "file/wear_shape.hpp"

#include <twum/core/metrics.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/motor_limit.hpp>

namespace twum::inline v0_1::motors {
namespace {

WearLimit parse_wear_limit(std::string_view text) {
  const MotorLimit limit = parse_limit(text);
  const MetricRequest* request = limit.metric.request();
  const bool about_life =
      request != nullptr && (info(request->metric).needs_wear || request->worn_at);
  if (request == nullptr || about_life)
    throw ValueError(quoted(trimmed(text)) +
                         (about_life ? " is about the life itself" : " is no limit of one metric"),
                     "expected a metric of the worn motor and a number, such as "
                     "'start_voltage <= 120 V'");
  return {*request, limit.lower, limit.upper, limit.text};
}

}  // namespace

const Shape<std::vector<WearLimit>>& until_shape() {
  static const Shape<std::vector<WearLimit>> shape = [] {
    auto limits = list("limits that end the life of the worn motor",
                       text_of<WearLimit>("a limit", "start_voltage <= 120 V", parse_wear_limit,
                                          [](const WearLimit& limit) { return limit.text; }));
    limits.schema.example = "[start_voltage <= 120 V, speed_at(0.5 N.m) >= 100 rpm]";
    return limits;
  }();
  return shape;
}

Shape<WearProfile> wear_profile_shape() {
  return word<WearProfile>(
      "whether the track wears evenly, or each radius by its own pressure and slip (free)",
      {WearProfile::even, WearProfile::free});
}

}  // namespace twum::inline v0_1::motors
