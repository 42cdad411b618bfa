// SPDX-License-Identifier: Apache-2.0
// Times of held points of a motor with one slice: alone, by each control, and as a map of 60 speeds and 40 torques, line by line and
// point by point. For the ratio, the same amplitude by a search of one's own over operating points of motors with given amplitudes.
#include "driven_layers.hpp"

#include <benchmark/benchmark.h>

#include <twum/base/scalar_search.hpp>
#include <twum/core/held_point.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cmath>
#include <vector>

namespace {

using namespace twum;

constexpr double kTorque = 0.5, kSpeed = 9;

MotorDesign design_of(benchmark::State& state) {
  MotorDesign design = bench::driven_layer(state);
  design.stator.radial_slices = 1;
  return design;
}

void held(benchmark::State& state, DriveControl control) {
  const MotorDesign design = design_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(held_point(design, kTorque, kSpeed, control));
}
void held_by_amplitude(benchmark::State& state) { held(state, DriveControl::amplitude); }
void held_by_voltage(benchmark::State& state) { held(state, DriveControl::voltage); }
void held_by_frequency(benchmark::State& state) { held(state, DriveControl::frequency); }

// The alternative, with a bracket that happens to be good: Algorithm 748 over the amplitude.
void amplitude_by_operating_points(benchmark::State& state) {
  MotorDesign design = design_of(state);
  design.stator.voltage.reset();
  const auto missing = [&](double amplitude) {
    design.stator.amplitude = amplitude;
    return Motor(design).operating_point(kSpeed).torque - kTorque;
  };
  const double amplitude = held_point(design, kTorque, kSpeed, DriveControl::amplitude).amplitude;
  for (auto _ : state) {
    const double low = 0.8 * amplitude, high = 1.2 * amplitude;
    benchmark::DoNotOptimize(
        closed_in("the amplitude", missing, {low, high, missing(low), missing(high)}, 40));
  }
}

// What a map asks for: speeds up to the largest without load, torques up to what friction carries.
struct Grid {
  std::vector<double> speeds, torques;
};

Grid grid_of(const MotorDesign& design) {
  constexpr int kSpeeds = 60, kTorques = 40;
  const double fastest =
      evaluate(Motor(design), {Metric::held_speed_limit_at, Argument::torque, 0}).value;
  const double most = (1 - 1e-4) * largest_held_torque(design);
  Grid grid;
  for (int i = 1; i <= kSpeeds; ++i) grid.speeds.push_back(fastest * i / kSpeeds);
  for (int j = 0; j < kTorques; ++j) grid.torques.push_back(most * j / (kTorques - 1));
  return grid;
}

void map_line_by_line(benchmark::State& state) {
  const MotorDesign design = design_of(state);
  const Grid grid = grid_of(design);
  for (auto _ : state)
    for (const double speed : grid.speeds)
      benchmark::DoNotOptimize(held_points(design, grid.torques, speed));
}

void map_point_by_point(benchmark::State& state) {
  const MotorDesign design = design_of(state);
  const Grid grid = grid_of(design);
  for (auto _ : state)
    for (const double speed : grid.speeds)
      for (const double torque : grid.torques)
        benchmark::DoNotOptimize(held_point(design, torque, speed));
}

BENCHMARK(held_by_amplitude)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(held_by_voltage)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(held_by_frequency)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(amplitude_by_operating_points)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(map_line_by_line)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(map_point_by_point)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
