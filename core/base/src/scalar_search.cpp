// SPDX-License-Identifier: Apache-2.0
#include <twum/base/scalar_search.hpp>

#include <twum/base/error.hpp>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <utility>
#include <vector>

namespace twum {
namespace {

bool changes_sign(const Bracket& b) {
  if (!std::isfinite(b.low) || !std::isfinite(b.high) || b.low > b.high) return false;
  if (std::isnan(b.at_low) || std::isnan(b.at_high)) return false;
  return b.at_low == 0 || b.at_high == 0 || (b.at_low < 0) != (b.at_high < 0);
}

[[noreturn]] void fail(std::string_view sought, const std::string& found) {
  throw EvaluationError("no-bracket", "no root found for " + std::string(sought) + ": " + found);
}

std::string words(const Bracket& b) {
  std::ostringstream text;
  text << "the values " << b.at_low << " and " << b.at_high << " at " << b.low << " and " << b.high
       << " do not enclose a change of sign";
  return text.str();
}

}  // namespace

double Bracket::nearest() const { return std::fabs(at_low) <= std::fabs(at_high) ? low : high; }

Bracket closed_in(std::string_view sought, const std::function<double(double)>& f,
                  const Bracket& ends, int bits) {
  if (!changes_sign(ends)) fail(sought, words(ends));
  const auto& [low, high, at_low, at_high] = ends;
  if (at_low == 0) return {low, low, 0, 0};
  if (at_high == 0) return {high, high, 0, 0};
  std::vector<std::pair<double, double>> seen{{low, at_low}, {high, at_high}};
  const auto noted = [&](double x) {
    const double y = f(x);
    if (std::isnan(y)) fail(sought, "the function has no value at " + std::to_string(x));
    return seen.emplace_back(x, y).second;
  };
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

LeastValue least_between(std::string_view sought, const std::function<double(double)>& f,
                         double low, double high, int bits) {
  if (!(std::isfinite(low) && std::isfinite(high) && low <= high))
    fail(sought, "the range from " + std::to_string(low) + " to " + std::to_string(high) +
                     " is not finite or reversed");
  const auto [place, value] = boost::math::tools::brent_find_minima(f, low, high, bits);
  return {place, value};
}

}  // namespace twum
