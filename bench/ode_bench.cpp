// SPDX-License-Identifier: Apache-2.0
// The core against general methods at the same accuracy, in the same run: two Runge-Kutta solvers of GSL
// with event location for damped and inertial layers, a fixed grid for the elastic one.
#include "support/brute_force.hpp"
#include "support/ode_solver.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"
#include "timing.hpp"

#include <benchmark/benchmark.h>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace twum;
using namespace twum::test;
using bench::seconds;

// Times `general` and puts the ratio to the core and the difference in torque beside it. The two take turns, so
// that a machine whose speed changes changes both.
template <typename General>
void against(benchmark::State& state, const MotorDesign& design, double share, General general) {
  constexpr int kPoints = 200;
  const Motor motor(design);
  const double speed = share * evaluate(motor, {Metric::no_load_speed}).value;
  OracleResult result;
  double best = HUGE_VAL, core = HUGE_VAL;
  for (auto _ : state) {
    const double once = seconds([&] { result = general(design, speed); });
    state.SetIterationTime(once);
    best = std::min(best, once);
    const double points = seconds([&] {
      for (int i = 0; i < kPoints; ++i) benchmark::DoNotOptimize(motor.operating_point(speed));
    });
    core = std::min(core, points / kPoints);
  }
  state.counters["core_ns"] = 1e9 * core;
  state.counters["times_slower"] = best / core;
  state.counters["laps"] = result.laps;
  state.counters["difference"] =
      std::abs(result.torque - motor.operating_point(speed).torque) / torque_scale(design);
}

// Each method at the loosest decade that makes its torque agree with the core's to 3e-14 of the scale in
// every row: a user has one tolerance for all points, as he does not know which of them are easy.
double tolerance_of(OdeMethod method) {
  return method == OdeMethod::prince_dormand_8_9 ? 1e-13 : 1e-15;
}

void ode(benchmark::State& state, const MotorDesign& design, double share, OdeMethod method) {
  OdeOptions options;
  options.method = method;
  options.tolerance = tolerance_of(method);
  against(state, design, share, [&options](const MotorDesign& d, double speed) {
    return ode_solver_run(d, speed, options);
  });
}

void register_ode(const std::string& what, const MotorDesign& design, double share) {
  const auto add = [&](const std::string& name, OdeMethod method) {
    benchmark::RegisterBenchmark((name + "/" + what).c_str(), ode, design, share, method)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  };
  add("Prince-Dormand 8(9)", OdeMethod::prince_dormand_8_9);
  add("Fehlberg 4(5)", OdeMethod::fehlberg_4_5);
}

void grid(benchmark::State& state, const MotorDesign& design, double share, int steps) {
  against(state, design, share,
          [steps](const MotorDesign& d, double speed) { return fixed_grid(d, speed, steps); });
}

}  // namespace

int main(int argc, char** argv) {
  for (const double share : {0.3, 0.85, 0.98, 1.4}) {
    const std::string at = "/" + std::to_string(share).substr(0, 4) + " no-load";
    register_ode("inertial" + at, ring_motor(), share);
    register_ode("damped" + at, damped(ring_motor()), share);
    // A second-order scheme needs this many steps for 1e-11 of the torque's scale.
    benchmark::RegisterBenchmark(("fixed grid/elastic" + at).c_str(), grid, elastic(ring_motor()),
                                 share, 300000)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  }
  MotorDesign light = ring_motor();
  light.layer.loss_factor = 0.005;
  register_ode("inertial with loss factor 0.005/0.85 no-load", light, 0.85);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
