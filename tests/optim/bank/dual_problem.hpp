// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/dual.hpp>
#include <twum/optim/problem.hpp>

namespace twum::test {

/// An evaluator with an exact Jacobian from `f(x, out)`, where x points to the variables (at most
/// N) and out to the responses, both as Dual<double, N>.
template <int N, typename F>
optim::Evaluator dual_evaluator(std::size_t responses, F f) {
  return [responses, f](std::span<const double> design, bool) {
    using D = Dual<double, N>;
    std::vector<D> x;
    for (std::size_t j = 0; j < design.size(); ++j)
      x.push_back(D::variable(design[j], static_cast<int>(j)));
    std::vector<D> out(responses);
    f(x.data(), out.data());
    optim::Evaluation e;
    for (const D& r : out) {
      e.values.push_back(r.v);
      e.jacobian.insert(e.jacobian.end(), r.d, r.d + design.size());
    }
    return e;
  };
}

/// "x1" for ('x', 0).
inline std::string numbered(char letter, std::size_t index) {
  std::string name(1, letter);
  name += std::to_string(index + 1);
  return name;
}

/// n variables x1.. with common bounds and given starts.
inline std::vector<optim::Variable> box(std::size_t n, double lower, double upper,
                                        const std::vector<double>& start = {}) {
  std::vector<optim::Variable> v;
  for (std::size_t j = 0; j < n; ++j) {
    optim::Variable x;
    x.name = numbered('x', j);
    x.lower = lower;
    x.upper = upper;
    if (!start.empty()) x.start = start[j];
    v.push_back(x);
  }
  return v;
}

}  // namespace twum::test
