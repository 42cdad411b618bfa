// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/distributions.hpp>
#include <twum/studies/quantiles.hpp>

#include <cstddef>

namespace twum::studies {
namespace {

double interpolated(std::span<const double> sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  const double part = place - static_cast<double>(below);
  return part == 0 ? sorted[below] : sorted[below] + part * (sorted[below + 1] - sorted[below]);
}

}  // namespace

Estimate quantile_estimate(std::span<const double> sorted, double p, double confidence) {
  Estimate result;
  if (sorted.empty()) return result;
  result.value = interpolated(sorted, p);
  const auto n = static_cast<double>(sorted.size());
  const double tail = (1 - confidence) / 2;
  // How many draws lie below the quantile is binomial. Order statistic r (counted from 1) lies above it if fewer than r do.
  // The lower end is the largest r with P(count < r) <= tail, the upper the smallest s with
  // P(count >= s) <= tail.
  const double reached = optim::binomial_quantile(n, p, tail);
  const double r = optim::binomial_cdf(n, p, reached) <= tail ? reached + 1 : reached;
  const double s = optim::binomial_quantile(n, p, 1 - tail) + 1;
  if (r >= 1) result.low = sorted[static_cast<std::size_t>(r) - 1];
  if (s <= n) result.high = sorted[static_cast<std::size_t>(s) - 1];
  return result;
}

Estimate proportion_estimate(std::uint64_t hits, std::uint64_t draws, double confidence) {
  if (draws == 0) return {};
  const optim::ProbabilityRange range = optim::probability_range(hits, draws, (1 - confidence) / 2);
  return {static_cast<double>(hits) / static_cast<double>(draws), range.low, range.high};
}

}  // namespace twum::studies
