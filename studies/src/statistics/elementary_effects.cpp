// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/random.hpp>
#include <twum/studies/elementary_effects.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::uint64_t kStream = 0x30881;  // apart from the other random numbers of a seed

}  // namespace

void MorrisDesign::point(std::uint64_t trajectory, std::size_t member,
                         std::span<double> unit) const {
  TWUM_ASSERT(unit.size() == variables_ && member <= variables_);
  optim::Random random(seed_, kStream, trajectory);
  std::vector<std::uint64_t> level(variables_);
  for (std::uint64_t& l : level) l = random.below(4);
  std::vector<std::size_t> order(variables_);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t j = variables_; j > 1; --j) std::swap(order[j - 1], order[random.below(j)]);
  // Two levels up or down, whichever stays inside.
  for (std::size_t k = 0; k < member; ++k) level[order[k]] ^= 2U;
  for (std::size_t j = 0; j < variables_; ++j) unit[j] = static_cast<double>(level[j]) / 3;
}

void ElementaryEffects::add(std::span<const double> points, std::span<const double> values) {
  const std::size_t variables = effects_.size();
  TWUM_ASSERT(values.size() == variables + 1 && points.size() == variables * values.size());
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
    ++dropped_;
    return;
  }
  ++trajectories_;
  for (std::size_t k = 0; k < variables; ++k) {
    const auto before = points.subspan(k * variables, variables);
    const auto after = points.subspan((k + 1) * variables, variables);
    const auto moved = std::mismatch(before.begin(), before.end(), after.begin());
    TWUM_ASSERT(moved.first != before.end());
    const auto j = static_cast<std::size_t>(moved.first - before.begin());
    const double effect = (values[k + 1] - values[k]) / (*moved.second - *moved.first);
    effects_[j].add(effect);
    magnitudes_[j].add(std::abs(effect));
  }
}

std::vector<ElementaryEffect> ElementaryEffects::effects(double confidence) const {
  std::vector<ElementaryEffect> result;
  for (std::size_t j = 0; j < effects_.size(); ++j) {
    const Estimate mean = effects_[j].mean_estimate(confidence);
    result.push_back({mean.value, magnitudes_[j].mean_estimate(confidence),
                      effects_[j].sd_estimate(confidence)});
  }
  return result;
}

}  // namespace twum::inline v0_1::studies
