// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/distributions.hpp>
#include <twum/optim/sample_quantiles.hpp>

#include <cstddef>

namespace twum::inline v0_1::optim {
namespace {

double interpolated(std::span<const double> sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  const double part = place - static_cast<double>(below);
  const double low = sorted[below], high = sorted[below + 1];
  // Infinite values are times without an end.
  return part == 0 || low == high ? low : low + part * (high - low);
}

}  // namespace

IntervalEstimate quantile_estimate(std::span<const double> sorted, double p, double confidence) {
  IntervalEstimate result;
  if (sorted.empty()) return result;
  result.value = interpolated(sorted, p);
  const auto n = static_cast<double>(sorted.size());
  const double tail = (1 - confidence) / 2;
  // How many draws lie below the quantile is binomial. Order statistic r (counted from 1) lies above it if fewer than r do.
  // The lower end is the largest r with P(count < r) <= tail, the upper the smallest s with
  // P(count >= s) <= tail.
  const double reached = binomial_quantile(n, p, tail);
  const double r = binomial_cdf(n, p, reached) <= tail ? reached + 1 : reached;
  const double s = binomial_quantile(n, p, 1 - tail) + 1;
  if (r >= 1) result.low = sorted[static_cast<std::size_t>(r) - 1];
  if (s <= n) result.high = sorted[static_cast<std::size_t>(s) - 1];
  return result;
}

IntervalEstimate proportion_estimate(std::uint64_t hits, std::uint64_t draws, double confidence) {
  if (draws == 0) return {};
  const ProbabilityRange range = probability_range(hits, draws, (1 - confidence) / 2);
  return {static_cast<double>(hits) / static_cast<double>(draws), range.low, range.high};
}

}  // namespace twum::inline v0_1::optim
