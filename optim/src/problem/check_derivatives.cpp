// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/check_derivatives.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kStep = 1e-3;  // of the size of a variable
// Values of solvers and series carry about ten digits.
constexpr double kNoise = 1e-10;

double step_of(const Variable& v, double x) {
  return kStep * std::max(std::abs(x), 1e-3 * (v.upper - v.lower));
}

bool is_moved(const Variable& v, double step) { return !v.integer && v.upper - v.lower > 2 * step; }

class Checker {
 public:
  Checker(const Problem& problem, std::span<const double> design)
      : problem_(problem), design_(design.begin(), design.end()) {
    for (std::size_t j = 0; j < design_.size(); ++j) {
      const Variable& v = problem.variables[j];
      steps_.push_back(step_of(v, design_[j]));
      if (is_moved(v, steps_[j]))
        design_[j] = std::clamp(design_[j], v.lower + steps_[j], v.upper - steps_[j]);
    }
  }

  std::vector<DerivativeCheck> run() const {
    const Evaluation at = evaluated(design_, true);
    const std::size_t n = design_.size();
    if (at.jacobian.size() != n * problem_.responses())
      throw InputError("check_derivatives: the evaluator gave " +
                       std::to_string(at.jacobian.size()) + " derivatives where " +
                       std::to_string(n * problem_.responses()) + " were expected");
    std::vector<std::vector<DerivativeCheck>> columns(n);
    for (std::size_t j = 0; j < n; ++j) columns[j] = column(at, j);
    std::vector<DerivativeCheck> rows;
    for (std::size_t i = 0; i < problem_.responses(); ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (!columns[j].empty() && is_smooth(at, i, j)) rows.push_back(columns[j][i]);
    return rows;
  }

 private:
  Evaluation evaluated(const std::vector<double>& design, bool gradient) const {
    Evaluation e;
    try {
      e = problem_.evaluate(design, gradient);
    } catch (const EvaluationError& error) {
      e.failure = error.reason();
    }
    if (!e.ok()) throw InputError("check_derivatives: the design has no answer: " + e.failure);
    if (e.values.size() != problem_.responses())
      throw InputError("check_derivatives: the evaluator gave " + std::to_string(e.values.size()) +
                       " values for " + std::to_string(problem_.responses()) + " responses");
    return e;
  }

  // Central differences of all responses in one variable.
  std::vector<double> differences(std::size_t j, double step) const {
    std::vector<double> up = design_, down = design_;
    up[j] += step;
    down[j] -= step;
    std::vector<double> slopes = evaluated(up, false).values;
    const std::vector<double> below = evaluated(down, false).values;
    for (std::size_t i = 0; i < slopes.size(); ++i)
      slopes[i] = (slopes[i] - below[i]) / (up[j] - down[j]);
    return slopes;
  }

  // The error of a central difference falls with the square of the step: Richardson's extrapolation removes that term, and
  // what it removes bounds what is left of a smooth function.
  std::vector<DerivativeCheck> column(const Evaluation& at, std::size_t j) const {
    if (!is_moved(problem_.variables[j], steps_[j])) return {};
    const std::vector<double> wide = differences(j, steps_[j]);
    const std::vector<double> narrow = differences(j, 0.5 * steps_[j]);
    std::vector<DerivativeCheck> checks(wide.size());
    for (std::size_t i = 0; i < wide.size(); ++i) {
      DerivativeCheck& one = checks[i];
      const double removed = (narrow[i] - wide[i]) / 3;
      one.response = problem_.response_name(i);
      one.variable = problem_.variables[j].name;
      one.given = at.jacobian[i * design_.size() + j];
      one.difference = narrow[i] + removed;
      one.uncertainty = std::abs(removed) + kNoise * std::abs(at.values[i]) / steps_[j];
      // twice, because the bound holds to leading order only
      one.agrees = std::abs(one.given - one.difference) <=
                   2 * one.uncertainty + 1e-6 * std::abs(one.difference);
    }
    return checks;
  }

  bool is_smooth(const Evaluation& at, std::size_t response, std::size_t variable) const {
    return std::none_of(at.kinks.begin(), at.kinks.end(), [=](const KinkedEntry& kink) {
      return kink.response == response && kink.variable == variable;
    });
  }

  const Problem& problem_;
  std::vector<double> design_;
  std::vector<double> steps_;
};

}  // namespace

std::vector<DerivativeCheck> check_derivatives(const Problem& problem,
                                               std::span<const double> design) {
  validate(problem);
  if (design.size() != problem.variables.size())
    throw InputError("check_derivatives: the design has " + std::to_string(design.size()) +
                     " values for " + std::to_string(problem.variables.size()) + " variables");
  return Checker(problem, design).run();
}

}  // namespace twum::inline v0_1::optim
