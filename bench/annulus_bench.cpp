// SPDX-License-Identifier: Apache-2.0
// A contact with width beside one slice: points, all metrics, gradients, and what `auto` takes; slices in step beside slices one
// after the other. Ratios count.
#include "contact/lane_laps.hpp"
#include "model/motor_model.hpp"
#include "point/slice_count.hpp"
#include "support/test_motors.hpp"
#include "timing.hpp"

#include <benchmark/benchmark.h>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace twum;

enum class Shape { level, rising };

MotorDesign ring(int slices, Shape shape, double threshold = 1) {
  MotorDesign design = test::ring_motor();
  design.stator.modal_damping = 45;  // so that efficiency has a maximum
  design.stator.radial_slices = slices;
  if (shape == Shape::rising) design.stator.radial_shape = {2, 13.25e-3, {}};
  design.friction.threshold = threshold * design.friction.kinetic;
  return design;
}

std::vector<MetricRequest> all_metrics() {
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table())
    if (row.argument == Argument::none) requests.push_back({row.metric});
  return requests;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Of times that are taken in turns, because a machine changes its speed within a run: their medians.
struct Pair {
  double seconds, beside;

  double ratio() const { return seconds / beside; }
};

template <typename F, typename G>
Pair in_turns(int turns, F seconds, G beside) {
  std::vector<double> first, second;
  for (int i = 0; i < turns; ++i) first.push_back(seconds(i)), second.push_back(beside(i));
  return {median(first), median(second)};
}

// Over speeds 0 to 1.2 no-load.
auto points_of(const Motor& motor) {
  const double free = evaluate(motor, {Metric::no_load_speed}).value;
  return [&motor, free](int i) {
    const double speed = 0.02 * i * free;
    return bench::seconds_per_call([&] { benchmark::DoNotOptimize(motor.operating_point(speed)); },
                                   30);
  };
}

auto metrics_of(const Motor& motor) {
  return [&motor, requests = all_metrics()](int /*turn*/) {
    return bench::seconds_per_call([&] { benchmark::DoNotOptimize(evaluate(motor, requests)); }, 3);
  };
}

auto gradients_of(const Motor& motor) {
  return [&motor, requests = all_metrics()](int /*turn*/) {
    return bench::seconds_per_call(
        [&] { benchmark::DoNotOptimize(differentiate(motor, requests)); }, 3);
  };
}

void beside_one_slice(benchmark::State& state, Shape shape, double threshold) {
  const Motor one(ring(1, Shape::level, threshold)),
      many(ring(static_cast<int>(state.range(0)), shape, threshold));
  for (auto _ : state) {
    const Pair point = in_turns(61, points_of(many), points_of(one)),
               metrics = in_turns(5, metrics_of(many), metrics_of(one)),
               gradients = in_turns(5, gradients_of(many), metrics_of(many));
    state.counters["point_us"] = 1e6 * point.seconds;
    state.counters["times_one_point"] = point.ratio();
    state.counters["metrics_us"] = 1e6 * metrics.seconds;
    state.counters["times_one_metrics"] = metrics.ratio();
    state.counters["gradients_times_metrics"] = gradients.ratio();
  }
}

// A surface that also moves radially beside one that does not; gradients of a point beside its value.
void with_radial_motion(benchmark::State& state, bool inertial) {
  MotorDesign design = ring(static_cast<int>(state.range(0)), Shape::rising);
  if (!inertial) design.layer.density = design.layer.loss_factor = 0;
  MotorDesign moving = design;
  moving.stator.radial_motion = true;
  const Motor without(design), with_it(moving);
  const auto gradient = [&with_it, free = evaluate(without, {Metric::no_load_speed}).value](int i) {
    const std::vector<MetricRequest> request{{Metric::torque_at, Argument::speed, 0.02 * i * free}};
    return bench::seconds_per_call(
        [&] { benchmark::DoNotOptimize(differentiate(with_it, request)); }, 10);
  };
  for (auto _ : state) {
    const Pair point = in_turns(61, points_of(with_it), points_of(without)),
               gradients = in_turns(61, gradient, points_of(with_it));
    state.counters["point_us"] = 1e6 * point.seconds;
    state.counters["times_without"] = point.ratio();
    state.counters["gradient_times_point"] = gradients.ratio();
  }
}

// The laps of eight slices in step, in lanes of this width, beside the same laps one after the other; at a share of the
// no-load speed.
void in_step(benchmark::State& state, contact::LaneCode& code) {
  const auto codes = contact::lane_codes();
  if (std::find(codes.begin(), codes.end(), &code) == codes.end())
    return state.SkipWithError("not on this processor");
  const MotorDesign design = ring(contact::kLanes, Shape::level);
  const auto values = core::model_values(design);
  const auto motor =
      core::driven(core::motor_model(values, core::track_rule(design)), core::design_wave(values));
  const double share = 0.01 * static_cast<double>(state.range(0));
  const double speed = share * evaluate(Motor(design), {Metric::no_load_speed}).value;
  std::vector<contact::ContactNumbers<double>> contacts;
  for (const auto& slice : motor.slices())
    contacts.push_back(core::contact_numbers(motor, slice, speed));
  const contact::LayerMotion<double> layer(contacts[0].inertia, contacts[0].damping);
  std::vector<contact::Lap<double>> laps(contacts.size());
  std::vector<contact::LaneLap> lanes;
  for (std::size_t k = 0; k < laps.size(); ++k) lanes.push_back({&contacts[k], &laps[k]});
  const auto laps_in_step = [&] {
    std::fill(laps.begin(), laps.end(), contact::Lap<double>());
    contact::run_in_step(layer, lanes, code);
    benchmark::DoNotOptimize(laps);
  };
  const auto laps_alone = [&] {
    for (std::size_t k = 0; k < laps.size(); ++k)
      laps[k] = contact::run_lap(contacts[k], layer, contact::LapEntry<double>{{0, 0}});
    benchmark::DoNotOptimize(laps);
  };
  for (auto _ : state) {
    const double alone = bench::seconds_per_call(laps_alone, 200);
    state.counters["share_of_alone"] = bench::seconds_per_call(laps_in_step, 200) / alone;
    state.counters["alone_us"] = 1e6 * alone;
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

BENCHMARK_CAPTURE(beside_one_slice, level, Shape::level, 1)
    ->Arg(4)
    ->Arg(8)
    ->Arg(16)
    ->Arg(32)
    ->Arg(64)
    ->Arg(128)
    ->Arg(kAutoSlices)
    ->Iterations(1);
BENCHMARK_CAPTURE(beside_one_slice, rising, Shape::rising, 1)
    ->Arg(8)
    ->Arg(32)
    ->Arg(kAutoSlices)
    ->Iterations(1);
BENCHMARK_CAPTURE(beside_one_slice, threshold, Shape::level, 1.3)  // mu_0 / mu
    ->Arg(8)
    ->Arg(32)
    ->Arg(kAutoSlices)
    ->Iterations(1);
BENCHMARK_CAPTURE(with_radial_motion, elastic, false)->Arg(1)->Arg(8)->Iterations(1);
BENCHMARK_CAPTURE(with_radial_motion, inertial, true)->Arg(1)->Arg(8)->Iterations(1);
BENCHMARK_CAPTURE(in_step, two, contact::run_lanes_baseline)
    ->Arg(10)
    ->Arg(72)
    ->Arg(100)
    ->Iterations(1);
BENCHMARK_CAPTURE(in_step, four, contact::run_lanes_avx2)
    ->Arg(10)
    ->Arg(72)
    ->Arg(100)
    ->Iterations(1);
BENCHMARK_CAPTURE(in_step, eight, contact::run_lanes_avx512)
    ->Arg(10)
    ->Arg(72)
    ->Arg(100)
    ->Iterations(1);
BENCHMARK_CAPTURE(make_motor, one, 1, Shape::level);
BENCHMARK_CAPTURE(make_motor, level_8, 8, Shape::level);
BENCHMARK_CAPTURE(make_motor, rising_8, 8, Shape::rising);
BENCHMARK_CAPTURE(make_motor, level_auto, kAutoSlices, Shape::level);
BENCHMARK_CAPTURE(make_motor, rising_auto, kAutoSlices, Shape::rising);

BENCHMARK_MAIN();
