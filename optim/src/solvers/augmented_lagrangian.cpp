// SPDX-License-Identifier: Apache-2.0
#include "solvers/augmented_lagrangian.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

// tau: required reduction of the violation from one minimum to the next
constexpr double kEnoughLess = 0.5;
constexpr double kGrowth = 10.0;  // gamma: growth of the penalty otherwise
// Scaled responses have slopes of about 1, so larger multipliers belong to no solution. Up to this penalty the
// Lagrangian keeps a few digits of the objective.
constexpr double kMostPenalty = 1e12;
constexpr double kMostMultiplier = 1e12;
constexpr int kMostSteps = 50;
constexpr int kMostStalled = 10;  // by then the penalty has grown by ten decades

}  // namespace

AugmentedLagrangian::AugmentedLagrangian(std::vector<OneSide> limits, double tolerance)
    : limits_(std::move(limits)), multipliers_(limits_.size(), 0.0), tolerance_(tolerance) {}

double AugmentedLagrangian::value(const NlpValue& v) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const double shifted = limits_[i].of(v) + multipliers_[i] / penalty_;
    if (limits_[i].equality || shifted > 0.0) sum += shifted * shifted;
  }
  return v.f + 0.5 * penalty_ * sum;
}

std::vector<double> AugmentedLagrangian::gradient(const NlpValue& v) const {
  std::vector<double> slope = v.df;
  const std::size_t n = slope.size();
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const OneSide& limit = limits_[i];
    const double force = penalty_ * limit.of(v) + multipliers_[i];
    if (!limit.equality && force <= 0.0) continue;
    for (std::size_t k = 0; k < n; ++k) slope[k] += force * limit.sign * v.dc[limit.row * n + k];
  }
  return slope;
}

// Violation of a limit, or of complementarity if the limit has slack.
double AugmentedLagrangian::violation(std::size_t i, double g) const {
  return std::abs(limits_[i].equality ? g : std::max(g, -multipliers_[i] / penalty_));
}

// Birgin & Martinez, (12.1): objective and penalty are of one size at the start.
void AugmentedLagrangian::begin(const NlpValue& start) {
  if (begun_) return;
  begun_ = true;
  double sum = 0.0;
  for (const OneSide& limit : limits_) {
    const double g = limit.of(start);
    if (limit.equality || g > 0.0) sum += g * g;
  }
  const double balanced = 2.0 * std::max(1.0, std::abs(start.f)) / sum;
  penalty_ = sum > 0.0 ? std::clamp(balanced, 1e-6, 10.0) : 10.0;
}

bool AugmentedLagrangian::advance(const NlpValue& minimum) {
  double worst = 0.0;
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const double g = limits_[i].of(minimum);
    worst = std::max(worst, violation(i, g));
    const double least = limits_[i].equality ? -kMostMultiplier : 0.0;
    multipliers_[i] = std::clamp(multipliers_[i] + penalty_ * g, least, kMostMultiplier);
  }
  stalled_ = worst < kEnoughLess * least_ ? 0 : stalled_ + 1;
  least_ = std::min(least_, worst);
  if (worst > kEnoughLess * before_) penalty_ = std::min(kGrowth * penalty_, kMostPenalty);
  before_ = worst;
  return worst > tolerance_ && stalled_ < kMostStalled;
}

RunReport minimize(AugmentedLagrangian& lagrangian, const InnerSearch& inner,
                   std::vector<double> z) {
  RunReport report;
  report.z = std::move(z);
  if (const NlpValue* start = inner.look(report.z)) lagrangian.begin(*start);
  int steps = 0;
  bool going = !inner.halted();
  while (going && steps < kMostSteps) {
    report = inner.minimize(std::move(report.z));
    ++steps;
    const NlpValue* minimum = inner.halted() ? nullptr : inner.look(report.z);
    going = minimum != nullptr && !inner.halted() && lagrangian.advance(*minimum);
  }
  report.word += " after " + std::to_string(steps) + " outer steps";
  return report;
}

}  // namespace twum::inline v0_1::optim
