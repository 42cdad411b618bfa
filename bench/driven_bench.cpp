// SPDX-License-Identifier: Apache-2.0
// Times of a driven motor with one slice and with eight: a point on the branch it follows, its metrics and their gradients. For
// the ratio, an integration in time of its two modes until the wave has settled to 1e-4.
#include "driven_layers.hpp"
#include "support/two_modes.hpp"

#include <benchmark/benchmark.h>

#include <twum/core/frequency_response.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace twum;

MotorDesign design_of(benchmark::State& state) {
  MotorDesign design = bench::driven_layer(state);
  design.stator.radial_slices = static_cast<int>(state.range(1));
  return design;
}

std::vector<MetricRequest> all_metrics() {
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table())
    if (row.argument == Argument::none) requests.push_back({row.metric});
  return requests;
}

void make_motor(benchmark::State& state) {
  const MotorDesign design = design_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(Motor(design));
}

void point_at_given_amplitude(benchmark::State& state) {
  MotorDesign design = design_of(state);
  design.stator.voltage.reset();
  design.stator.amplitude = 1.7e-6;
  const Motor motor(design);
  double speed = 0;
  for (auto _ : state) {
    speed = std::fmod(speed + 0.618 * 14, 14.0);
    benchmark::DoNotOptimize(motor.operating_point(speed));
  }
}

void point_on_the_branch(benchmark::State& state) {
  const Motor motor(design_of(state));
  double speed = 0;
  for (auto _ : state) {
    speed = std::fmod(speed + 0.618 * 14, 14.0);
    benchmark::DoNotOptimize(motor.operating_point(speed));
  }
}

void waves_at_a_speed(benchmark::State& state) {
  const Motor motor(design_of(state));
  for (auto _ : state) benchmark::DoNotOptimize(motor.wave_states(5));
}

// The motor is made anew each time: its branch is a part of the work.
void metrics_of_a_design(benchmark::State& state) {
  const MotorDesign design = design_of(state);
  const std::vector<MetricRequest> requests = all_metrics();
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(Motor(design), requests));
}

void gradients_of_a_design(benchmark::State& state) {
  const MotorDesign design = design_of(state);
  const std::vector<MetricRequest> requests = all_metrics();
  for (auto _ : state) benchmark::DoNotOptimize(differentiate(Motor(design), requests));
}

void integration_in_time(benchmark::State& state) {
  constexpr double kSettled = 1e-4;
  constexpr double kSpeed = 8;
  const MotorDesign design = test::driven_motor();
  const double amplitude = Motor(design).operating_point(kSpeed).amplitude;
  int periods = 0;
  for (auto _ : state) {
    test::TwoModes modes(design, kSpeed);
    modes.set_wave(0.8 * amplitude, 2.5);
    double before = 0, now = 1;
    for (periods = 0; std::fabs(now - before) > kSettled * now && periods < 2000; periods += 20) {
      before = now;
      modes.run(20);
      now = std::abs(modes.wave());
    }
  }
  state.SetLabel(std::to_string(periods) + " periods");
}

constexpr double kVoltages[] = {60, 80, 100, 120, 140};
constexpr std::size_t kFrequencies = 200;

// A family of five voltages at 200 frequencies each, swept up and down under a load.
void frequency_sweeps(benchmark::State& state, const RotorLoad& load) {
  MotorDesign design = design_of(state);
  for (auto _ : state) {
    for (const double voltage : kVoltages) {
      design.stator.voltage = voltage;
      const FrequencyResponse response(design, load);
      std::vector<double> frequencies =
          spaced_frequencies(response.from(), response.to(), kFrequencies);
      benchmark::DoNotOptimize(response.sweep(frequencies));
      std::reverse(frequencies.begin(), frequencies.end());
      benchmark::DoNotOptimize(response.sweep(frequencies));
    }
  }
}

void sweeps_under_torque(benchmark::State& state) {
  frequency_sweeps(state, {Argument::torque, 0.3});
}
void sweeps_at_a_speed(benchmark::State& state) { frequency_sweeps(state, {Argument::speed, 5}); }

// The alternative: all waves of a frequency by itself, searched for over the amplitude. For every tenth of the frequencies, since
// it takes that long.
void each_frequency_by_itself(benchmark::State& state) {
  MotorDesign design = design_of(state);
  for (auto _ : state) {
    for (const double voltage : kVoltages) {
      design.stator.voltage = voltage;
      const FrequencyResponse response(design, {Argument::speed, 5});
      for (const double frequency :
           spaced_frequencies(response.from(), response.to(), kFrequencies / 10)) {
        design.stator.frequency = frequency;
        benchmark::DoNotOptimize(Motor(design).wave_states(5));
      }
      design.stator.frequency = design_of(state).stator.frequency;
    }
  }
}

BENCHMARK(make_motor)->ArgsProduct({{0, 1}, {1, 8}})->Unit(benchmark::kMicrosecond);
BENCHMARK(point_at_given_amplitude)->ArgsProduct({{0, 1}, {1, 8}})->Unit(benchmark::kMicrosecond);
BENCHMARK(point_on_the_branch)->ArgsProduct({{0, 1}, {1, 8}})->Unit(benchmark::kMicrosecond);
BENCHMARK(waves_at_a_speed)->ArgsProduct({{0, 1}, {1}})->Unit(benchmark::kMicrosecond);
BENCHMARK(metrics_of_a_design)->ArgsProduct({{0, 1}, {1, 8}})->Unit(benchmark::kMicrosecond);
BENCHMARK(gradients_of_a_design)->ArgsProduct({{0, 1}, {1, 8}})->Unit(benchmark::kMicrosecond);
// Where slices jump: their number given, and `auto`.
BENCHMARK(metrics_of_a_design)
    ->ArgsProduct({{2}, {8, 32, kAutoSlices}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(gradients_of_a_design)->ArgsProduct({{2}, {kAutoSlices}})->Unit(benchmark::kMillisecond);
BENCHMARK(sweeps_under_torque)->ArgsProduct({{0, 1}, {1, 8}})->Unit(benchmark::kMillisecond);
BENCHMARK(sweeps_at_a_speed)->ArgsProduct({{0, 1}, {1, 8}})->Unit(benchmark::kMillisecond);
BENCHMARK(each_frequency_by_itself)->ArgsProduct({{0, 1}, {1}})->Unit(benchmark::kMillisecond);
BENCHMARK(integration_in_time)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
