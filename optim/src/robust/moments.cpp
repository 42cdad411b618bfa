// SPDX-License-Identifier: Apache-2.0
#include "robust/moments.hpp"

#include "robust/margin.hpp"
#include "robust/normal.hpp"

#include <twum/optim/scrambled_sobol.hpp>

#include <cmath>
#include <twum/base/error.hpp>

namespace twum::optim {
namespace {

constexpr std::uint64_t kMomentProducts = 256;
constexpr std::uint64_t kMomentReplicate = 1000;  // apart from the samples that correct
constexpr double kMostLost = 1e-3;                // beyond, the derivative of a mean would be wrong

// The response at each product, as a margin against 0.
std::vector<MarginPoint> responses(const RobustProblem& problem, std::size_t response,
                                   std::span<const double> x,
                                   const std::vector<std::vector<double>>& sample) {
  std::vector<MarginPoint> list;
  for (const auto& z : sample) list.push_back(margin_at(problem, {response, 1.0, 0.0}, x, z));
  return list;
}

}  // namespace

std::vector<std::vector<double>> moment_sample(const RobustProblem& problem, std::uint64_t seed) {
  const ScrambledSobol sobol(problem.inputs.size(), seed, kMomentReplicate);
  std::vector<std::vector<double>> sample;
  std::vector<double> u(sobol.dimension());
  for (std::uint64_t i = 0; i < kMomentProducts; ++i) {
    sobol.point(i, u);
    sample.emplace_back();
    for (const double c : u) sample.back().push_back(normal_quantile(c));
  }
  return sample;
}

// U2.1 and U2.2.
Moment moment(const RobustProblem& problem, const StatisticTarget& target,
              std::span<const double> x, const std::vector<std::vector<double>>& sample) {
  std::vector<MarginPoint> points = responses(problem, target.response, x, sample);
  Moment result;
  for (const MarginPoint& point : points)
    if (!point.failure.empty()) result.failure = point.failure;
  const auto asked = static_cast<double>(points.size());
  std::erase_if(points, [](const MarginPoint& point) { return !point.failure.empty(); });
  const auto count = static_cast<double>(points.size());
  if (asked - count > kMostLost * asked) return result;
  result.failure.clear();
  std::vector<double> mean_slope(x.size(), 0.0);
  double mean = 0.0;
  for (const MarginPoint& point : points) {
    mean += point.value / count;
    for (std::size_t k = 0; k < x.size(); ++k) mean_slope[k] += point.by_design[k] / count;
  }
  if (target.kind == Statistic::mean) return {mean, mean_slope, {}};
  double squares = 0.0;
  std::vector<double> slope(x.size(), 0.0);
  for (const MarginPoint& point : points) {
    const double deviation = point.value - mean;
    squares += deviation * deviation;
    for (std::size_t k = 0; k < x.size(); ++k)
      slope[k] += deviation * (point.by_design[k] - mean_slope[k]);
  }
  const double sd = std::sqrt(squares / (count - 1.0));
  for (double& s : slope) s = sd > 0.0 ? s / ((count - 1.0) * sd) : 0.0;
  return {sd, slope, {}};
}

}  // namespace twum::optim
