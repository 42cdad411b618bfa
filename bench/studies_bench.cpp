// SPDX-License-Identifier: Apache-2.0
// Costs of searches over a motor: one evaluation, one local optimum, one front. The question is that of
// examples/studies/optimize-ring-60.yaml.
#include <benchmark/benchmark.h>
#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>
#include <twum/studies/motor_problem.hpp>

using namespace twum;
using namespace twum::studies;

namespace {

DesignProblem ring_60() {
  DesignProblem problem;  // the default motor is ring-60
  problem.motor.stator.modal_damping = 45;
  problem.vary(Parameter::amplitude, 0.8e-6, 2.2e-6).vary(Parameter::preload, 60, 300);
  problem.vary(Parameter::thickness, 1e-4, 1e-3, optim::Scale::log);
  problem.vary(Parameter::youngs_modulus, 0.5e9, 20e9, optim::Scale::log);
  problem.vary(Parameter::kinetic_friction, 0.1, 0.35);
  problem.limit("no_load_speed >= 100 rpm").limit("stall_torque >= 0.8 N.m");
  problem.limit("max_pressure <= 10 MPa");
  return problem;
}

optim::Problem most_power() {
  DesignProblem problem = ring_60();
  problem.maximize("peak_power").limit("wear_intensity_at(80 rpm) <= 5 kW/m^2");
  return motor_problem(problem);
}

void evaluate_question(benchmark::State& state, bool gradient) {
  const optim::Problem problem = most_power();
  const std::vector<double> start = optim::start_design(problem);
  for (auto _ : state) benchmark::DoNotOptimize(problem.evaluate(start, gradient));
}

void local_optimum(benchmark::State& state, const char* solver) {
  const optim::Problem problem = most_power();
  optim::SolveOptions options;
  options.solver = solver;
  options.starts = 1;
  std::size_t evaluations = 0;
  for (auto _ : state) {
    const optim::Result result = optim::solve(problem, options);
    evaluations = result.counters.evaluations;
    if (result.outcome != optim::Outcome::optimal) state.SkipWithError("not optimal");
  }
  state.counters["evaluations"] = static_cast<double>(evaluations);
}

void front(benchmark::State& state, const char* first, const char* second, bool maximize_second) {
  DesignProblem question = ring_60();
  question.maximize(first);
  maximize_second ? question.maximize(second) : question.minimize(second);
  const optim::Problem problem = motor_problem(question);
  optim::ParetoOptions options;
  options.solve.jobs = 2;
  std::size_t certified = 0;
  std::size_t evaluations = 0;
  for (auto _ : state) {
    const optim::Front found = optim::pareto_front(problem, options);
    evaluations = found.counters.evaluations;
    certified = 0;
    for (const optim::FrontPoint& point : found.points) certified += point.certificate.passed;
  }
  state.counters["certified"] = static_cast<double>(certified);
  state.counters["evaluations"] = static_cast<double>(evaluations);
}

}  // namespace

BENCHMARK_CAPTURE(evaluate_question, values, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(evaluate_question, gradients, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(local_optimum, nlopt_slsqp, "nlopt:slsqp")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(local_optimum, nlopt_mma, "nlopt:mma")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(local_optimum, ipopt, "ipopt")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(front, torque_speed_100, "stall_torque", "no_load_speed", true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(front, power_wear_100, "peak_power", "wear_intensity_at(80 rpm)", false)
    ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
