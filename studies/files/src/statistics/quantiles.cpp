// SPDX-License-Identifier: Apache-2.0
#include "statistics/double_precision.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/statistics/quantiles.hpp>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstddef>

namespace twum::studies {
namespace {

using Binomial = boost::math::binomial_distribution<double, DoublePrecision>;

double interpolated(std::span<const double> sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  const double part = place - static_cast<double>(below);
  return part == 0 ? sorted[below] : sorted[below] + part * (sorted[below + 1] - sorted[below]);
}

// How many draws lie below the quantile is binomial. The smallest k with P(count <= k) >= level;
// Boost rounds real solutions, so the last steps are ours.
double count_reaching(const Binomial& below, double level) {
  double k = std::floor(boost::math::quantile(below, level));
  while (k > 0 && boost::math::cdf(below, k - 1) >= level) --k;
  while (k < below.trials() && boost::math::cdf(below, k) < level) ++k;
  return k;
}

}  // namespace

Estimate quantile_estimate(std::span<const double> sorted, double p, double confidence) {
  Estimate result;
  if (sorted.empty()) return result;
  result.value = interpolated(sorted, p);
  const auto n = static_cast<double>(sorted.size());
  const Binomial below(n, p);
  const double tail = (1 - confidence) / 2;
  // Order statistic r (counted from 1) lies above the quantile if fewer than r draws lie below it.
  // The lower end is the largest r with P(count < r) <= tail, the upper the smallest s with
  // P(count >= s) <= tail.
  const double reached = count_reaching(below, tail);
  const double r = boost::math::cdf(below, reached) <= tail ? reached + 1 : reached;
  const double s = count_reaching(below, 1 - tail) + 1;
  if (r >= 1) result.low = sorted[static_cast<std::size_t>(r) - 1];
  if (s <= n) result.high = sorted[static_cast<std::size_t>(s) - 1];
  return result;
}

Estimate proportion_estimate(std::uint64_t hits, std::uint64_t draws, double confidence) {
  TWUM_ASSERT(hits <= draws);
  if (draws == 0) return {};
  const auto k = static_cast<double>(hits);
  const auto n = static_cast<double>(draws);
  const double tail = (1 - confidence) / 2;
  return {k / n, Binomial::find_lower_bound_on_p(n, k, tail),
          Binomial::find_upper_bound_on_p(n, k, tail)};
}

double student_quantile(double freedom, double confidence) {
  return boost::math::quantile(
      boost::math::students_t_distribution<double, DoublePrecision>(freedom), (1 + confidence) / 2);
}

}  // namespace twum::studies
