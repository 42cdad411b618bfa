// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optim/bank/dual_problem.hpp"
#include "optim/bank/textbook.hpp"

#include <cmath>

namespace twum::test {

using T20 = Dual<double, 20>;

inline T20 sq(const T20& x) { return x * x; }
inline T20 cube(const T20& x) { return x * x * x; }
inline T20 fourth(const T20& x) { return sq(sq(x)); }

inline T20 chained(const T20& x, double value, double slope) {
  T20 r(value);
  for (int i = 0; i < 20; ++i) r.d[i] = slope * x.d[i];
  return r;
}
inline T20 ln(const T20& x) { return chained(x, std::log(x.v), 1.0 / x.v); }
inline T20 expo(const T20& x) { return chained(x, std::exp(x.v), std::exp(x.v)); }
inline T20 sine(const T20& x) { return chained(x, std::sin(x.v), std::cos(x.v)); }
inline T20 cosine(const T20& x) { return chained(x, std::cos(x.v), -std::sin(x.v)); }
inline T20 root(const T20& x) { return chained(x, std::sqrt(x.v), 0.5 / std::sqrt(x.v)); }
inline T20 power(const T20& x, double p) {
  return chained(x, std::pow(x.v, p), p * std::pow(x.v, p - 1.0));
}

/// Range and start of one variable.
struct Range {
  double lower;
  double upper;
  double start;
};

inline constexpr double kFree = std::numeric_limits<double>::infinity();
inline Range anywhere(double start) { return {-kFree, kFree, start}; }
inline Range at_least(double lower, double start) { return {lower, kFree, start}; }
inline std::vector<Range> times(std::size_t n, Range r) { return std::vector<Range>(n, r); }

/// Constraints are written as in the book: `inequalities` of the form c >= 0, then equalities.
struct TextbookBuilder {
  std::vector<Textbook> all;

  template <typename F>
  void add(const std::string& name, double best, const std::vector<Range>& ranges,
           std::size_t inequalities, std::size_t equalities, F f) {
    optim::Problem p;
    for (std::size_t j = 0; j < ranges.size(); ++j)
      p.variables.push_back({numbered('x', j), ranges[j].lower, ranges[j].upper, ranges[j].start});
    p.objectives = {{"f", optim::Sense::minimize}};
    for (std::size_t i = 0; i < inequalities + equalities; ++i)
      p.constraints.push_back({numbered('c', i), 0.0, i < inequalities ? optim::kInfinity : 0.0});
    p.evaluate = dual_evaluator<20>(1 + inequalities + equalities, f);
    all.push_back({name, std::move(p), best});
  }
};

void add_hs_1_to_24(TextbookBuilder& b);
void add_hs_26_to_56(TextbookBuilder& b);
void add_hs_60_to_83(TextbookBuilder& b);
void add_hs_86_to_113(TextbookBuilder& b);
void add_cec_2006(TextbookBuilder& b);

}  // namespace twum::test
