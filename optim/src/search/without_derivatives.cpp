// SPDX-License-Identifier: Apache-2.0
#include "search/without_derivatives.hpp"

#include "search/solve_continuous.hpp"
#include "solvers/optimizer.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <limits>

namespace twum::inline v0_1::optim {
namespace {

void require_fit(const Problem& problem, const SolveOptions& options) {
  if (options.solver == "auto" || find_optimizer(options.solver).info.gradient)
    throw InputError("solver '" + options.solver +
                     "' needs derivatives, which this problem does not give; name one that needs "
                     "none, such as 'nlopt:sbplx'");
  if (std::any_of(problem.variables.begin(), problem.variables.end(),
                  [](const Variable& v) { return v.integer; }))
    throw InputError("whole numbers need derivatives, which this problem does not give");
}

// Where a Jacobian is asked for, its entries are NaN, as of responses that have no derivative at a design.
Problem with_undefined_derivatives(const Problem& problem) {
  Problem filled = problem;
  filled.derivatives = true;
  filled.evaluate = [inner = problem.evaluate, n = problem.variables.size()](
                        std::span<const double> design, bool gradient) {
    Evaluation e = inner(design, false);
    e.kinks.clear();
    e.jacobian.assign(gradient && e.ok() ? e.values.size() * n : 0,
                      std::numeric_limits<double>::quiet_NaN());
    return e;
  };
  return filled;
}

}  // namespace

Result solve_without_derivatives(const Problem& problem, const SolveOptions& options,
                                 const Deadline& deadline) {
  require_fit(problem, options);
  SolveOptions own = options;
  own.polish = false;              // by Newton steps
  own.analyse_infeasible = false;  // by solvers that need derivatives
  Result result = solve_continuous(with_undefined_derivatives(problem), own, deadline);
  result.evaluation.jacobian.clear();
  result.evaluation.kinks.clear();
  result.certificate.passed = false;
  result.certificate.second_order = false;
  result.certificate.findings.clear();
  result.certificate.stationarity = std::numeric_limits<double>::quiet_NaN();
  result.certificate.complementarity = std::numeric_limits<double>::quiet_NaN();
  result.certificate.reason = "not measured: the problem gives no derivatives";
  if (result.outcome == Outcome::optimal) result.outcome = Outcome::feasible;
  return result;
}

}  // namespace twum::inline v0_1::optim
