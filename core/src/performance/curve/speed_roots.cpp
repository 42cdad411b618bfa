// SPDX-License-Identifier: Apache-2.0
#include "performance/curve/speed_roots.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <utility>
#include <vector>

namespace twum::performance {

Bracket close_in(const std::function<double(double)>& f, const Bracket& ends) {
  const auto& [low, high, at_low, at_high] = ends;
  if (at_low == 0) return {low, low, 0, 0};
  if (at_high == 0) return {high, high, 0, 0};
  if (!((at_low < 0) != (at_high < 0)) || std::isnan(at_low) || std::isnan(at_high)) {
    throw SearchFailure{MetricStatus::unresolved};
  }
  std::vector<std::pair<double, double>> seen{{low, at_low}, {high, at_high}};
  const auto noted = [&](double x) { return seen.emplace_back(x, f(x)).second; };
  const auto value = [&seen](double x) {
    return std::find_if(seen.begin(), seen.end(), [x](const auto& s) { return s.first == x; })
        ->second;
  };
  boost::uintmax_t limit = 120;
  const auto found = boost::math::tools::toms748_solve(
      noted, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(51), limit);
  return {found.first, found.second, value(found.first), value(found.second)};
}

}  // namespace twum::performance
