// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/hock_schittkowski.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

using namespace twum;
using namespace twum::optim;

namespace {

double worst_violation(const Problem& p, const Evaluation& e) {
  double worst = 0.0;
  for (std::size_t i = 0; i < p.constraints.size(); ++i) {
    const double value = e.values[p.objectives.size() + i];
    worst = std::max({worst, p.constraints[i].lower - value, value - p.constraints[i].upper});
  }
  return worst;
}

// The published optima carry ten digits; 1e-6 of 1 + |f| is what solvers are asked for.
void check_optimum(const test::KnownProblem& known, const Result& result) {
  INFO(known.name << " " << result.solver << " " << result.certificate.reason << " stationarity "
                  << result.certificate.stationarity << " evaluations "
                  << result.counters.evaluations);
  REQUIRE_FALSE(result.evaluation.values.empty());
  CAPTURE(result.evaluation.values[0], known.best, result.design);
  CHECK(std::abs(result.evaluation.values[0] - known.best) / (1.0 + std::abs(known.best)) < 1e-6);
  CHECK(worst_violation(known.problem, result.evaluation) < 1e-7);
  CHECK(result.outcome == Outcome::optimal);
  CHECK(result.certificate.passed);
}

}  // namespace

TEST_CASE("textbook problems are solved and certified by every gradient solver",
          "[optim][published][differential]") {
  const std::string solver = GENERATE("auto", "nlopt:slsqp", "nlopt:mma", "ipopt");
  if (solver == "ipopt" && !find_solver(solver).available) return;
  for (const auto& known : test::hock_schittkowski()) {
    if (solver == "nlopt:mma" && known.equalities) continue;  // it takes none by itself
    SolveOptions options;
    options.solver = solver;
    check_optimum(known, solve(known.problem, options));
  }
}

TEST_CASE("the certificate refuses the published start of HS93, where solvers stall",
          "[optim][certificate][published]") {
  const auto& known = test::hock_schittkowski("HS93");
  const Certificate c = certify(known.problem, start_design(known.problem));
  CHECK_FALSE(c.passed);
  CHECK(c.stationarity > 1e-3);  // a thousand times the tolerance: no matter of rounding
}
