// SPDX-License-Identifier: Apache-2.0
// What ends before it began, and what a solver prints.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <unistd.h>
#include <cstdio>
#include <stop_token>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;

Problem bowl(bool integer, std::size_t objectives) {
  Problem p;
  p.variables = test::box(2, -3.0, 5.0, {2.0, 1.0});
  p.variables[0].integer = integer;
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({test::numbered('f', k)});
  p.evaluate = test::dual_evaluator<2>(objectives, [=](const D* x, D* r) {
    for (std::size_t k = 0; k < objectives; ++k) {
      const double centre = static_cast<double>(k);
      r[k] = (x[0] - centre) * (x[0] - centre) + x[1] * x[1];
    }
  });
  return p;
}

// Bytes that the process writes to standard output meanwhile.
template <typename Action>
long printed_by(Action action) {
  std::FILE* const file = std::tmpfile();
  REQUIRE(file != nullptr);
  std::fflush(stdout);
  const int kept = dup(STDOUT_FILENO);
  dup2(fileno(file), STDOUT_FILENO);
  action();
  std::fflush(stdout);
  dup2(kept, STDOUT_FILENO);
  close(kept);
  std::fseek(file, 0, SEEK_END);
  const long size = std::ftell(file);
  std::fclose(file);
  return size;
}

}  // namespace

TEST_CASE("what is stopped before its first call has not failed", "[optim][budget]") {
  std::stop_source source;
  source.request_stop();
  SolveOptions options;
  options.stop = source.get_token();
  for (const bool integer : {false, true}) {
    const Result r = solve(bowl(integer, 1), options);
    CAPTURE(integer);
    CHECK(r.outcome == Outcome::budget);
    CHECK(r.stop == StopReason::requested);
    CHECK(r.counters.evaluations == 0);
    CHECK(r.certificate.reason != "no design could be evaluated");
  }
  ParetoOptions front_options;
  front_options.solve = options;
  const Front front = pareto_front(bowl(false, 2), front_options);
  CHECK(front.outcome == Outcome::budget);
  CHECK(front.stop == StopReason::requested);
}

TEST_CASE("Ipopt prints what its print_level asks for, and nothing otherwise", "[optim][ipopt]") {
  if (!find_solver("ipopt").available) return;
  SolveOptions options;
  options.solver = "ipopt";
  CHECK(printed_by([&] { solve(bowl(false, 1), options); }) == 0);
  options.solver_options = {{"print_level", "5"}};
  CHECK(printed_by([&] { solve(bowl(false, 1), options); }) > 100);
}
