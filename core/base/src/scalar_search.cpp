// SPDX-License-Identifier: Apache-2.0
#include <twum/base/scalar_search.hpp>

#include <twum/base/error.hpp>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

namespace twum::inline v0_1 {
namespace {

constexpr std::size_t kMostCalls = 120;
constexpr double kLarge = 1e100;  // quotients of differences in the interpolation stay finite

bool changes_sign(const Bracket& b) {
  if (!std::isfinite(b.low) || !std::isfinite(b.high) || b.low > b.high) return false;
  if (std::isnan(b.at_low) || std::isnan(b.at_high)) return false;
  return b.at_low == 0 || b.at_high == 0 || (b.at_low < 0) != (b.at_high < 0);
}

[[noreturn]] void fail(std::string_view sought, const std::string& found) {
  throw EvaluationError("no-bracket", "no root found for " + std::string(sought) + ": " + found);
}

// Without a stream: that of numbers is an eighth of the module for pages.
template <class... Numbers>
std::string words(const char* format, Numbers... numbers) {
  char text[160];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

}  // namespace

double Bracket::nearest() const { return std::fabs(at_low) <= std::fabs(at_high) ? low : high; }

Bracket closed_in(std::string_view sought, FunctionRef<double(double)> f, const Bracket& ends,
                  int bits) {
  if (!changes_sign(ends))
    fail(sought, words("the values %.6g and %.6g at %.6g and %.6g do not enclose a change of sign",
                       ends.at_low, ends.at_high, ends.low, ends.high));
  const auto& [low, high, at_low, at_high] = ends;
  if (at_low == 0) return {low, low, 0, 0};
  if (at_high == 0) return {high, high, 0, 0};
  // Infinite values tell the side only, and so do those beyond kLarge.
  const auto finite = [](double y) { return std::clamp(y, -kLarge, kLarge); };
  std::array<std::pair<double, double>, kMostCalls + 2> seen{{{low, at_low}, {high, at_high}}};
  std::size_t count = 2;
  const auto noted = [&](double x) {
    const double y = f(x);
    if (std::isnan(y)) fail(sought, words("the function has no value at %.6g", x));
    seen.at(count++) = {x, y};
    return finite(y);
  };
  const auto value = [&seen](double x) {
    return std::find_if(seen.begin(), seen.end(), [x](const auto& s) { return s.first == x; })
        ->second;
  };
  std::uintmax_t most = kMostCalls;
  const auto [a, b] = boost::math::tools::toms748_solve(
      noted, low, high, finite(at_low), finite(at_high),
      boost::math::tools::eps_tolerance<double>(static_cast<unsigned>(bits)), most);
  return {a, b, value(a), value(b)};
}

LeastValue least_between(std::string_view sought, FunctionRef<double(double)> f, double low,
                         double high, int bits) {
  if (!(std::isfinite(low) && std::isfinite(high) && low <= high))
    fail(sought, words("the range from %.6g to %.6g is not finite or reversed", low, high));
  const auto [place, value] = boost::math::tools::brent_find_minima(f, low, high, bits);
  return {place, value};
}

double zero_or_last_value(std::string_view sought, FunctionRef<double(double)> f, double good,
                          double bad, int bits) {
  double at_bad = f(bad);
  while (std::isnan(at_bad) && bad - good > 1e-12 * bad) {
    const double middle = 0.5 * (good + bad), there = f(middle);
    if (there >= 0)
      good = middle;
    else
      bad = middle, at_bad = there;
  }
  if (std::isnan(at_bad)) return good;
  const double at_good = f(good);
  if (!(at_good > 0)) return good;  // rounding leaves so much of a value that was 0
  return closed_in(sought, f, Bracket{good, bad, at_good, at_bad}, bits).nearest();
}

}  // namespace twum::inline v0_1
