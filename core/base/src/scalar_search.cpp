// SPDX-License-Identifier: Apache-2.0
#include <twum/base/scalar_search.hpp>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace twum {

double Bracket::nearest() const { return std::fabs(at_low) <= std::fabs(at_high) ? low : high; }

Bracket closed_in(const std::function<double(double)>& f, const Bracket& ends, int bits) {
  const auto& [low, high, at_low, at_high] = ends;
  if (at_low == 0) return {low, low, 0, 0};
  if (at_high == 0) return {high, high, 0, 0};
  std::vector<std::pair<double, double>> seen{{low, at_low}, {high, at_high}};
  const auto noted = [&](double x) { return seen.emplace_back(x, f(x)).second; };
  const auto value = [&seen](double x) {
    return std::find_if(seen.begin(), seen.end(), [x](const auto& s) { return s.first == x; })
        ->second;
  };
  std::uintmax_t most = 120;
  const auto [a, b] = boost::math::tools::toms748_solve(
      noted, low, high, at_low, at_high,
      boost::math::tools::eps_tolerance<double>(static_cast<unsigned>(bits)), most);
  return {a, b, value(a), value(b)};
}

LeastValue least_between(const std::function<double(double)>& f, double low, double high,
                         int bits) {
  const auto [place, value] = boost::math::tools::brent_find_minima(f, low, high, bits);
  return {place, value};
}

}  // namespace twum
