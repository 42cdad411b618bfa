// SPDX-License-Identifier: Apache-2.0
#include <twum/base/gauss_rule.hpp>

#include <boost/math/special_functions/legendre.hpp>

#include <map>

namespace twum::inline v0_1 {
namespace {

GaussRule made(int nodes) {
  GaussRule rule;
  // Boost gives the zeros that are not negative, in rising order.
  const std::vector<double> zeros = boost::math::legendre_p_zeros<double>(nodes);
  const auto node = [nodes](double x) {
    const double slope = boost::math::legendre_p_prime(nodes, x);
    return GaussRule::Node{0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)};
  };
  for (auto x = zeros.rbegin(); x != zeros.rend(); ++x)
    if (*x > 0) rule.nodes.push_back(node(-*x));
  for (const double x : zeros) rule.nodes.push_back(node(x));
  return rule;
}

}  // namespace

const GaussRule& gauss_rule(int nodes) {
  thread_local std::map<int, GaussRule> rules;
  const auto [place, fresh] = rules.try_emplace(nodes);
  if (fresh) place->second = made(nodes);
  return place->second;
}

}  // namespace twum::inline v0_1
