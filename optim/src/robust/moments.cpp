// SPDX-License-Identifier: Apache-2.0
#include "robust/moments.hpp"

#include "robust/margin.hpp"

#include <twum/optim/distributions.hpp>
#include <twum/optim/scrambled_sobol.hpp>

#include <cmath>
#include <twum/base/error.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr std::uint64_t kMomentProducts = 256;
constexpr std::uint64_t kMomentReplicate = 1000;  // apart from the samples that correct

// The response at each product, as a margin against 0.
std::vector<MarginPoint> responses(const RobustProblem& problem, std::size_t response,
                                   std::span<const double> x,
                                   const std::vector<std::vector<double>>& sample) {
  std::vector<MarginPoint> list;
  for (const auto& z : sample)
    list.push_back(margin_at(problem, {response, 1.0, 0.0, false}, x, z));
  return list;
}

}  // namespace

std::vector<std::vector<double>> moment_sample(const RobustProblem& problem, std::uint64_t seed) {
  const ScrambledSobol sobol(drawn_numbers(problem), seed, kMomentReplicate);
  std::vector<std::vector<double>> sample;
  std::vector<double> u(sobol.dimension());
  for (std::uint64_t i = 0; i < kMomentProducts; ++i) {
    sobol.point(i, u);
    sample.emplace_back();
    for (const double c : u) sample.back().push_back(normal_quantile(c));
  }
  return sample;
}

// U2.1 and U2.2. A moment's derivative is a weighted sum of those of the products: of the mean with 1/N, of the standard
// deviation with (X_i - mean) / ((N - 1) sd), which add up to 0, so that the derivative of the mean drops out.
Moment moment(const RobustProblem& problem, const StatisticTarget& target,
              std::span<const double> x, const std::vector<std::vector<double>>& sample) {
  std::vector<MarginPoint> points = responses(problem, target.response, x, sample);
  Moment result{0.0, std::vector<double>(x.size(), 0.0),
                std::vector<double>(problem.inputs.size(), 0.0)};
  for (const MarginPoint& point : points)
    if (!point.failure.empty()) result.failure = point.failure;
  const auto asked = static_cast<double>(points.size());
  std::erase_if(points, [](const MarginPoint& point) { return !point.failure.empty(); });
  const auto count = static_cast<double>(points.size());
  if (asked - count > kMostLostOfAMean * asked) return result;
  result.failure.clear();
  const auto add = [&](const MarginPoint& point, double weight) {
    for (std::size_t k = 0; k < x.size(); ++k) result.by_design[k] += weight * point.by_design[k];
    for (std::size_t k = 0; k < problem.inputs.size(); ++k)
      result.by_spread[k] += weight * point.by_spread[k];
  };
  double mean = 0.0, squares = 0.0;
  for (const MarginPoint& point : points) mean += point.value / count;
  for (const MarginPoint& point : points) squares += (point.value - mean) * (point.value - mean);
  const double sd = std::sqrt(squares / (count - 1.0));
  const bool of_mean = target.kind == Statistic::mean;
  result.value = of_mean ? mean : sd;
  for (const MarginPoint& point : points) {
    if (of_mean)
      add(point, 1.0 / count);
    else if (sd > 0.0)
      add(point, (point.value - mean) / ((count - 1.0) * sd));
  }
  return result;
}

}  // namespace twum::inline v0_1::optim
