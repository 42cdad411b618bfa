// SPDX-License-Identifier: Apache-2.0
#include "free_life_metrics.hpp"

#include "without_value.hpp"

#include <twum/core/motor.hpp>

namespace twum::inline v0_1::motion {
namespace {

// The operation for `life` and for worn() without a load.
std::optional<LoadPoint> load_of(const MetricRequest& request) {
  const LoadPoint load =
      request.worn_at.value_or(LoadPoint{request.argument, request.at, request.torque});
  return load.argument == Argument::none ? std::nullopt : std::optional(load);
}

}  // namespace

const FreeLife& FreeLives::under(const std::optional<LoadPoint>& load) {
  for (const auto& [of, life] : lives_)
    if (of == load) return life;
  return lives_.emplace_back(load, free_life(design_, load)).second;
}

double FreeLives::number(const MetricRequest& request) {
  const FreeLife& life = under(load_of(request));
  if (life.status != MetricStatus::ok) throw WithoutValue{life.status};
  if (request.worn_at) {
    MetricRequest of_worn = request;
    of_worn.worn_at.reset();
    return value_or_reason(evaluate(Motor(worn_motor(design_, life.last.depths)), of_worn));
  }
  const bool turns =
      request.metric == Metric::life_revolutions || request.metric == Metric::life_revolutions_at;
  return turns ? life.last.revolutions : life.last.seconds;
}

}  // namespace twum::inline v0_1::motion
