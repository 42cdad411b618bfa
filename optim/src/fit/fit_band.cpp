// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/fit_band.hpp>

#include <twum/optim/solve.hpp>

#include <algorithm>
#include <cstddef>

namespace twum::inline v0_1::optim {
namespace {

// Some parts of a band's half width and of the rise of the squares: a picture shows a tenth of it.
constexpr double kAccurate = 1e-3;
constexpr std::size_t kMostEvaluations = 300;
// Of the rise: a search that stopped short there has no more than 5 % of the half width left.
constexpr double kOnTheEdge = 0.9;

double squares_of(const Residuals& residuals) {
  double sum = 0;
  for (const double r : residuals.values) sum += r * r;
  return sum;
}

// The prediction and how far the squares have risen in parts of what they may, with gradients: that of S is 2 J^T r.
class Region {
 public:
  Region(const ResidualFunction& residuals, const PredictionFunction& prediction, double least,
         double rise)
      : residuals_(residuals), prediction_(prediction), least_(least), rise_(rise) {}

  Evaluation operator()(std::span<const double> values, bool /*gradient*/) const {
    const Residuals found = residuals_(values);
    if (!found.failure.empty()) return {{}, {}, {}, found.failure};
    Prediction number = prediction_(values);
    if (number.gradient.empty()) return {{}, {}, {}, "no-prediction"};
    Evaluation e{{number.value, (squares_of(found) - least_) / rise_}, std::move(number.gradient)};
    const std::size_t n = values.size();
    for (std::size_t j = 0; j < n; ++j) {
      double slope = 0;
      for (std::size_t i = 0; i < found.values.size(); ++i)
        slope += 2 * found.values[i] * found.jacobian[i * n + j];
      e.jacobian.push_back(slope / rise_);
    }
    return e;
  }

 private:
  const ResidualFunction& residuals_;
  const PredictionFunction& prediction_;
  double least_, rise_;
};

// The end that a search from a start finds, and whether it is certified.
struct Found {
  std::vector<double> design;
  double value{0}, rise{0};
  bool certified{false};
};

std::optional<Found> search_from(std::span<const double> start, Problem problem) {
  for (std::size_t j = 0; j < start.size(); ++j) problem.variables[j].start = start[j];
  SolveOptions options;
  options.solver = "nlopt:slsqp";
  options.tolerance = kAccurate;
  options.budget.evaluations = kMostEvaluations;
  options.analyse_infeasible = options.polish = false;
  const Result result = solve(problem, options);
  const bool certified = result.outcome == Outcome::optimal;
  if (!certified && result.outcome != Outcome::feasible) return {};
  return Found{result.design, result.evaluation.values[0], result.evaluation.values[1], certified};
}

}  // namespace

std::optional<std::vector<double>> band_end(const std::vector<Variable>& parameters,
                                            const ResidualFunction& residuals,
                                            const PredictionFunction& prediction,
                                            std::span<const double> estimates, double rise,
                                            IntervalEnd end, std::span<const double> near) {
  const Residuals fit = residuals(estimates);
  if (!fit.failure.empty()) return {};
  const double sign = end == IntervalEnd::low ? -1 : 1;
  Problem problem{parameters};
  problem.objectives = {{"prediction", sign < 0 ? Sense::minimize : Sense::maximize}};
  problem.constraints = {{"rise of the squares", -kInfinity, 1.0, kAccurate}};
  problem.evaluate = Region(residuals, prediction, squares_of(fit), rise);
  std::optional<Found> best;
  for (const std::span<const double> start : {near, estimates}) {
    if (start.empty() || (best && best->certified)) continue;
    auto found = search_from(start, problem);
    if (found && (!best || sign * found->value > sign * best->value)) best = std::move(found);
  }
  if (!best || (!best->certified && best->rise < kOnTheEdge)) return {};
  return best->design;
}

}  // namespace twum::inline v0_1::optim
