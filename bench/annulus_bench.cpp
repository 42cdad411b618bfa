// SPDX-License-Identifier: Apache-2.0
// A contact with width beside one slice: points, all metrics, gradients, and what `auto` takes. Ratios count.
#include "support/test_motors.hpp"
#include "timing.hpp"

#include <benchmark/benchmark.h>

#include <twum/core/performance/metrics.hpp>
#include <twum/core/performance/motor.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace twum;

enum class Shape { level, rising };

MotorDesign ring(int slices, Shape shape) {
  MotorDesign design = test::ring_motor();
  design.stator.modal_damping = 45;  // so that efficiency has a maximum
  design.stator.radial_slices = slices;
  if (shape == Shape::rising) design.stator.radial_shape = {2, 13.25e-3, {}};
  return design;
}

std::vector<MetricRequest> all_metrics() {
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table())
    if (row.argument == Argument::none) requests.push_back({row.metric});
  return requests;
}

// Median over speeds 0 to 1.2 no-load.
double seconds_per_point(const Motor& motor) {
  const double free = evaluate(motor, {Metric::no_load_speed}).value;
  std::vector<double> seconds;
  for (int i = 0; i <= 60; ++i) {
    const double speed = 0.02 * i * free;
    seconds.push_back(bench::seconds_per_call(
        [&] { benchmark::DoNotOptimize(motor.operating_point(speed)); }, 30));
  }
  std::nth_element(seconds.begin(), seconds.begin() + 30, seconds.end());
  return seconds[30];
}

double seconds_per_evaluation(const Motor& motor) {
  const auto requests = all_metrics();
  return bench::seconds_per_call([&] { benchmark::DoNotOptimize(evaluate(motor, requests)); }, 10);
}

double seconds_per_gradient(const Motor& motor) {
  const auto requests = all_metrics();
  return bench::seconds_per_call([&] { benchmark::DoNotOptimize(differentiate(motor, requests)); },
                                 5);
}

void beside_one_slice(benchmark::State& state, Shape shape) {
  const Motor one(ring(1, Shape::level)), many(ring(static_cast<int>(state.range(0)), shape));
  for (auto _ : state) {
    const double point = seconds_per_point(many), metrics = seconds_per_evaluation(many);
    state.counters["point_us"] = 1e6 * point;
    state.counters["times_one_point"] = point / seconds_per_point(one);
    state.counters["metrics_us"] = 1e6 * metrics;
    state.counters["times_one_metrics"] = metrics / seconds_per_evaluation(one);
    state.counters["gradients_times_metrics"] = seconds_per_gradient(many) / metrics;
  }
}

void make_motor(benchmark::State& state, int slices, Shape shape) {
  const MotorDesign design = ring(slices, shape);
  for (auto _ : state) benchmark::DoNotOptimize(Motor(design));
  const Motor motor(design);
  state.counters["nodes"] = motor.radial_slices();
  state.counters["slices"] = static_cast<double>(motor.slice_radii().size());
}

}  // namespace

BENCHMARK_CAPTURE(beside_one_slice, level, Shape::level)
    ->Arg(4)
    ->Arg(8)
    ->Arg(16)
    ->Arg(32)
    ->Arg(64)
    ->Arg(128)
    ->Arg(kAutoSlices)
    ->Iterations(1);
BENCHMARK_CAPTURE(beside_one_slice, rising, Shape::rising)
    ->Arg(8)
    ->Arg(32)
    ->Arg(kAutoSlices)
    ->Iterations(1);
BENCHMARK_CAPTURE(make_motor, one, 1, Shape::level);
BENCHMARK_CAPTURE(make_motor, level_8, 8, Shape::level);
BENCHMARK_CAPTURE(make_motor, rising_8, 8, Shape::rising);
BENCHMARK_CAPTURE(make_motor, level_auto, kAutoSlices, Shape::level);
BENCHMARK_CAPTURE(make_motor, rising_auto, kAutoSlices, Shape::rising);

BENCHMARK_MAIN();
