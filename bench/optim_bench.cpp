// SPDX-License-Identifier: Apache-2.0
// Costs of the optimization layer. `optim_bench --fronts` prints the table of fronts instead:
// gradients, our NSGA-II and pagmo's on the same problems.
#include "optim/bank/fronts.hpp"
#include "optim/bank/hock_schittkowski.hpp"

#include <benchmark/benchmark.h>
#include <cstdio>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>

using namespace twum;
using namespace twum::optim;

namespace {

// Five variables and four constraints, all cheap: what remains is the solver and its wrapping.
Problem small_problem() {
  Problem p;
  for (const char* name : {"a", "b", "c", "d", "e"}) p.variables.push_back({name, 0.0, 2.0, 0.5});
  p.objectives = {{"f"}};
  p.constraints = {{"c1", -kInfinity, 3.0},
                   {"c2", -kInfinity, 2.0},
                   {"c3", 0.1, kInfinity},
                   {"c4", -kInfinity, 6.0}};
  p.evaluate = [](std::span<const double> x, bool) {
    Evaluation e;
    e.values.assign(5, 0.0);
    e.jacobian.assign(25, 0.0);
    for (std::size_t j = 0; j < 5; ++j) {
      const double target = 1.0 + 0.1 * static_cast<double>(j);
      e.values[0] += (x[j] - target) * (x[j] - target);
      e.jacobian[j] = 2.0 * (x[j] - target);
      e.values[1] += x[j];
      e.jacobian[5 + j] = 1.0;
      e.values[4] += x[j] * x[j];
      e.jacobian[20 + j] = 2.0 * x[j];
    }
    e.values[2] = x[0] * x[1] + x[2];
    e.jacobian[10] = x[1];
    e.jacobian[11] = x[0];
    e.jacobian[12] = 1.0;
    e.values[3] = x[3] * x[4];
    e.jacobian[18] = x[4];
    e.jacobian[19] = x[3];
    return e;
  };
  return p;
}

void solve_small(benchmark::State& state, const char* solver) {
  const Problem p = small_problem();
  SolveOptions options;
  options.solver = solver;
  std::size_t evaluations = 0;
  for (auto _ : state) {
    const Result r = solve(p, options);
    evaluations = r.counters.evaluations;
    if (r.outcome != Outcome::optimal) state.SkipWithError("not optimal");
  }
  state.counters["evaluations"] = static_cast<double>(evaluations);
}

void evaluate_small(benchmark::State& state) {
  const Problem p = small_problem();
  const std::vector<double> x(5, 0.7);
  for (auto _ : state) benchmark::DoNotOptimize(p.evaluate(x, true));
}

void ipopt_iteration(benchmark::State& state) {
  const auto& known = test::hock_schittkowski("HS71");
  SolveOptions options;
  options.solver = "ipopt";
  double iterations = 0.0;
  for (auto _ : state) {
    const Result r = solve(known.problem, options);
    int count = 0;
    const auto at = r.stages.front().word.find("after ");
    if (at != std::string::npos)
      std::sscanf(r.stages.front().word.c_str() + at, "after %d", &count);
    iterations += count;
  }
  state.counters["s_per_iteration"] =
      benchmark::Counter(iterations, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// A problem of ours as pagmo wants it.
struct PagmoProblem {
  Problem problem;
  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    return problem.evaluate(x, false).values;
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    pagmo::vector_double lower;
    pagmo::vector_double upper;
    for (const auto& v : problem.variables) {
      lower.push_back(v.lower);
      upper.push_back(v.upper);
    }
    return {lower, upper};
  }
  pagmo::vector_double::size_type get_nobj() const { return problem.objectives.size(); }
  template <typename Archive>
  void serialize(Archive&, unsigned) {}
};

double pagmo_hypervolume(const Problem& problem, const std::vector<double>& reference) {
  pagmo::population population(pagmo::problem(PagmoProblem{problem}), 100, 1U);
  const double mutation = 1.0 / static_cast<double>(problem.variables.size());  // as ours
  population =
      pagmo::algorithm(pagmo::nsga2(250, 0.9, 15.0, mutation, 20.0, 1U)).evolve(population);
  return hypervolume(population.get_f(), reference);
}

void row(const char* name, const Problem& problem, const std::vector<double>& reference,
         double best) {
  ParetoOptions gradients;
  gradients.reference = reference;
  gradients.solve.budget.evaluations = 200000;
  const Front ours = pareto_front(problem, gradients);
  Nsga2Options evolution;
  evolution.reference = reference;
  evolution.solve.budget.evaluations = 30000;
  const Front second = nsga2(problem, evolution);
  std::size_t certified = 0;
  for (const auto& p : ours.points) certified += p.certificate.passed ? 1U : 0U;
  std::printf("%-6s %11.6g %11.6g %6zu %4zu %4zu %7.3f  %11.6g %6zu %7.3f  ", name, best,
              ours.hypervolume, ours.counters.evaluations, ours.points.size(), certified,
              ours.seconds, second.hypervolume, second.counters.evaluations, second.seconds);
  if (problem.constraints.empty())
    std::printf("%11.6g\n", pagmo_hypervolume(problem, reference));
  else
    std::printf("%11s\n", "-");
}

void print_fronts() {
  std::printf(
      "name   best of 100   gradients  evals  pts cert       s      nsga2  evals       s        "
      "pagmo\n");
  for (const auto& known : test::known_fronts(1000))
    row(known.name.c_str(), known.problem, known.reference,
        test::best_hypervolume(known.front, 100, known.reference));
  row("DTLZ1", test::dtlz1(), {0.5, 0.5, 0.5}, 0.1041667);
  row("DTLZ2", test::dtlz2(), {1.1, 1.1, 1.1}, 0.807401);
}

}  // namespace

BENCHMARK(evaluate_small);
BENCHMARK_CAPTURE(solve_small, slsqp, "nlopt:slsqp")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve_small, automatic, "auto")->Unit(benchmark::kMicrosecond);
BENCHMARK(ipopt_iteration)->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "--fronts") {
    print_fronts();
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
