// SPDX-License-Identifier: Apache-2.0
#include "metrics/wear_quadrature.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using Kronrod = boost::math::quadrature::gauss_kronrod<double, 21>;
using Gauss = boost::math::quadrature::gauss<double, 10>;
using Gauss3 = boost::math::quadrature::gauss<double, 3>;

constexpr double kEnough = 1e-8;
constexpr int kHalvings = 4;

void add_to(std::vector<double>& sum, double weight, const std::vector<double>& numbers) {
  if (sum.empty()) sum.assign(numbers.size(), 0);
  for (std::size_t i = 0; i < numbers.size(); ++i) sum[i] += weight * numbers[i];
}

// Nodes of a rule from the middle outwards, on both sides.
template <typename Nodes, typename Use>
void for_nodes(const Nodes& nodes, double from, double to, Use use) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    use(i, middle + half * nodes[i]);
    if (nodes[i] != 0) use(i, middle - half * nodes[i]);
  }
}

DepthIntegral halved(const NumbersAt& numbers, double from, double to, int halvings) {
  const double half = 0.5 * (to - from);
  std::vector<double> sum;
  double by_gauss = 0;
  // Those of Gauss' rule are every second one of Kronrod's, from the second on.
  for_nodes(Kronrod::abscissa(), from, to, [&](std::size_t i, double depth) {
    const std::vector<double> found = numbers(depth);
    add_to(sum, half * Kronrod::weights()[i], found);
    if (i % 2 == 1) by_gauss += half * Gauss::weights()[i / 2] * found[0];
  });
  if (halvings == 0 || !(std::fabs(by_gauss - sum[0]) > kEnough * std::fabs(sum[0])))
    return {sum, true};
  DepthIntegral both = halved(numbers, from, from + half, halvings - 1);
  add_to(both.sums, 1, halved(numbers, from + half, to, halvings - 1).sums);
  return {both.sums, false};
}

}  // namespace

std::optional<SmoothDepthIntegral> SmoothDepthIntegral::of(const NumbersAt& numbers, double to) {
  SmoothDepthIntegral all(to);
  double by_gauss = 0, by_kronrod = 0;
  for_nodes(Kronrod::abscissa(), 0, to, [&](std::size_t i, double depth) {
    all.depths_.push_back(depth), all.numbers_.push_back(numbers(depth));
    const double first = all.numbers_.back()[0];
    by_kronrod += Kronrod::weights()[i] * first;
    if (i % 2 == 1) by_gauss += Gauss::weights()[i / 2] * first;
  });
  if (!(std::fabs(by_gauss - by_kronrod) <= kEnough * std::fabs(by_kronrod))) return {};
  for (const double depth : all.depths_) {
    double product = 1;  // in parts of a quarter of the length, so that it stays near 1
    for (const double other : all.depths_)
      if (other != depth) product *= 4 * (depth - other) / to;
    all.weights_.push_back(1 / product);
  }
  return all;
}

std::vector<double> SmoothDepthIntegral::at(double depth) const {
  std::vector<double> sum(numbers_.front().size());
  double weights = 0;
  for (std::size_t j = 0; j < depths_.size(); ++j) {
    if (depth == depths_[j]) return numbers_[j];
    const double weight = weights_[j] / (depth - depths_[j]);
    weights += weight;
    add_to(sum, weight, numbers_[j]);
  }
  for (double& one : sum) one /= weights;
  return sum;
}

std::vector<double> SmoothDepthIntegral::up_to(double depth) const {
  if (depth == 0) return std::vector<double>(numbers_.front().size());
  // more points than half of the polynomial's degree: exact
  return ten_points_over_depth([this](double u) { return at(u); }, 0, depth);
}

DepthIntegral integral_over_depth(const NumbersAt& numbers, double from, double to) {
  return halved(numbers, from, to, kHalvings);
}

namespace {

template <typename Rule>
std::vector<double> sum_by(const NumbersAt& numbers, double from, double to) {
  std::vector<double> sum;
  for_nodes(Rule::abscissa(), from, to, [&](std::size_t i, double depth) {
    add_to(sum, 0.5 * (to - from) * Rule::weights()[i], numbers(depth));
  });
  return sum;
}

}  // namespace

std::vector<double> ten_points_over_depth(const NumbersAt& numbers, double from, double to) {
  return sum_by<Gauss>(numbers, from, to);
}

std::vector<double> three_points_over_depth(const NumbersAt& numbers, double from, double to) {
  return sum_by<Gauss3>(numbers, from, to);
}

}  // namespace twum::inline v0_1::core
