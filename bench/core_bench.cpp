// SPDX-License-Identifier: Apache-2.0
// Times of the core: one operating point by regime and layer, curves, metrics, gradients.
#include "layers.hpp"
#include "support/test_motors.hpp"
#include "timing.hpp"

#include <benchmark/benchmark.h>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace twum;
using namespace twum::test;
using bench::seconds_per_call;

double no_load_speed(const Motor& motor) { return evaluate(motor, {Metric::no_load_speed}).value; }

void operating_point(benchmark::State& state, const MotorDesign& design, double share) {
  const Motor motor(design);
  const double speed = share * no_load_speed(motor);
  for (auto _ : state) benchmark::DoNotOptimize(motor.operating_point(speed));
  state.SetLabel(std::to_string(motor.zones(speed).size()) + " zones");
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void report(benchmark::State& state, const std::vector<double>& seconds) {
  state.counters["median_ns"] = 1e9 * quantile(seconds, 0.5);
  state.counters["p90_ns"] = 1e9 * quantile(seconds, 0.9);
  state.counters["p99_ns"] = 1e9 * quantile(seconds, 0.99);
  state.counters["max_ns"] = 1e9 * quantile(seconds, 1.0);
}

// Distribution over speeds 0 to 1.2 no-load.
void points_over_speed(benchmark::State& state, const MotorDesign& design) {
  const Motor motor(design);
  const double free = no_load_speed(motor);
  std::vector<double> seconds;
  for (auto _ : state) {
    seconds.clear();
    for (int i = 0; i <= 120; ++i) {
      const double speed = 0.01 * i * free;
      seconds.push_back(
          seconds_per_call([&] { benchmark::DoNotOptimize(motor.operating_point(speed)); }));
    }
  }
  report(state, seconds);
}

// Distribution over realistic designs, at any speed from -0.2 to 1.3 V0 / r.
void points_over_designs(benchmark::State& state) {
  std::vector<double> seconds;
  double failures = 0;
  for (auto _ : state) {
    Uniform random(2025);
    seconds.clear();
    failures = 0;
    for (int i = 0; i < 4000; ++i) {
      const Motor motor(realistic_design(random));
      const double speed = motor.crest_speed() * random(-0.2, 1.3);
      failures += motor.operating_point(speed).status != PointStatus::ok;
      seconds.push_back(
          seconds_per_call([&] { benchmark::DoNotOptimize(motor.operating_point(speed)); }, 20, 3));
    }
  }
  report(state, seconds);
  state.counters["without_answer"] = failures;
}

void light_damping(benchmark::State& state, double loss_factor) {
  MotorDesign design = ring_motor();
  design.layer.loss_factor = loss_factor;
  points_over_speed(state, design);
}

void make_motor(benchmark::State& state) {
  const MotorDesign design = ring_motor();
  for (auto _ : state) benchmark::DoNotOptimize(Motor(design));
}

void curve(benchmark::State& state) {
  const Motor motor(ring_motor());
  std::vector<double> speeds;
  for (int i = 0; i < 100; ++i) speeds.push_back(1.2 * no_load_speed(motor) * i / 99);
  for (auto _ : state) benchmark::DoNotOptimize(torque_speed_curve(motor, speeds));
}

// All metrics of theory section 7 that take no argument.
std::vector<MetricRequest> all_metrics() {
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table()) {
    if (row.argument == Argument::none) requests.push_back({row.metric, Argument::none, 0});
  }
  return requests;
}

MotorDesign damped_stator() {
  MotorDesign design = ring_motor();
  design.stator.modal_damping = 45;  // so that efficiency has a maximum
  return design;
}

void metrics(benchmark::State& state) {
  const Motor motor(damped_stator());
  const auto requests = all_metrics();
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(motor, requests));
}

void metric(benchmark::State& state, Metric which) {
  const Motor motor(damped_stator());
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(motor, MetricRequest{which}));
}

void metrics_with_gradient(benchmark::State& state) {
  const Motor motor(damped_stator());
  const auto requests = all_metrics();
  const double plain =
      seconds_per_call([&] { benchmark::DoNotOptimize(evaluate(motor, requests)); }, 50);
  for (auto _ : state) benchmark::DoNotOptimize(differentiate(motor, requests));
  const double with =
      seconds_per_call([&] { benchmark::DoNotOptimize(differentiate(motor, requests)); }, 50);
  state.counters["times_metrics_alone"] = with / plain;
}

void register_points() {
  // the regimes of theory section 6, as shares of the no-load speed
  const std::pair<const char*, double> regimes[] = {
      {"1 slip", 0.3}, {"2 slip stick slip", 0.85}, {"3 near no-load", 0.98}, {"4 braking", 1.4}};
  for (const bench::Layer& layer : bench::layers()) {
    for (const auto& [name, share] : regimes) {
      const std::string full = std::string("point/") + layer.name + "/regime " + name;
      benchmark::RegisterBenchmark(full.c_str(), operating_point, layer.design, share);
    }
    benchmark::RegisterBenchmark(
        (std::string("point over speeds 0..1.2 no-load/") + layer.name).c_str(), points_over_speed,
        layer.design)
        ->Iterations(1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_points();
  benchmark::RegisterBenchmark("point over realistic designs", points_over_designs)->Iterations(1);
  benchmark::RegisterBenchmark("point, loss factor 0.005, over speeds", light_damping, 0.005)
      ->Iterations(1);
  benchmark::RegisterBenchmark("point, loss factor 0.001, over speeds", light_damping, 0.001)
      ->Iterations(1);
  benchmark::RegisterBenchmark("motor from a design", make_motor);
  benchmark::RegisterBenchmark("curve of 100 points", curve);
  benchmark::RegisterBenchmark("all metrics", metrics)->Unit(benchmark::kMicrosecond);
  for (const MetricInfo& row : metric_table()) {
    if (row.argument != Argument::none) continue;
    benchmark::RegisterBenchmark(("metric/" + std::string(row.name)).c_str(), metric, row.metric)
        ->Unit(benchmark::kMicrosecond);
  }
  benchmark::RegisterBenchmark("all metrics with gradient in every parameter",
                               metrics_with_gradient)
      ->Unit(benchmark::kMicrosecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
