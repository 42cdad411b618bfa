// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/deviations.hpp"
#include "support/driven_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/frequency_response.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// The response over the frequency against what is known of motors at one frequency, found by searches over the amplitude.
namespace {

using namespace twum;
using namespace twum::test;

constexpr RotorLoad kAtRest{Argument::speed, 0};

MotorDesign wide_motor() {
  MotorDesign design = with(driven_motor_with_layer(70), Parameter::radial_slices, 6);
  design.stator.radial_shape = {1.5, 0.01, {}};
  return design;
}

double value(const MotorDesign& design, Metric metric) {
  const MetricValue found = evaluate(Motor(design), {metric});
  REQUIRE(found.status == MetricStatus::ok);
  return found.value;
}

std::vector<double> reversed(std::vector<double> frequencies) {
  std::reverse(frequencies.begin(), frequencies.end());
  return frequencies;
}

}  // namespace

TEST_CASE("the response has the waves that each frequency has by itself (D5.1, D5.2)",
          "[core][driven][frequency]") {
  int several = 0;
  for (const MotorDesign& design : {driven_motor(65), driven_motor_with_layer(100), wide_motor()}) {
    for (const double speed : {0.0, 0.3, 6.0, 11.0}) {
      const FrequencyResponse response(design, {Argument::speed, speed});
      // Neither on a border of the range nor on a turn.
      for (const double share : {0.03, 0.21, 0.37, 0.52, 0.68, 0.83, 0.97}) {
        const double frequency = response.from() + share * (response.to() - response.from());
        const std::vector<ResponsePoint> found = response.at(frequency);
        const Motor there(with(design, Parameter::frequency, frequency));
        const std::vector<WaveState> waves = there.wave_states(speed);
        CAPTURE(speed, frequency, found.size());
        REQUIRE(found.size() == waves.size());
        several += waves.size() > 1;
        for (std::size_t i = 0; i < waves.size(); ++i) {
          // Newton's last step of 1e-8 leaves its square; the other search ends at 1e-14.
          CHECK(found[i].point.amplitude == Approx(waves[i].amplitude).epsilon(1e-10));
          CHECK(found[i].point.phase_lag == Approx(waves[i].phase_lag).epsilon(1e-8));
          CHECK(found[i].stable == waves[i].stable);
          CHECK(found[i].point.voltage == Approx(*design.stator.voltage).epsilon(1e-10));
        }
      }
    }
  }
  CHECK(several > 20);
}

TEST_CASE("the response at rest turns at the start and the pull-out frequency (D5.3)",
          "[core][driven][frequency]") {
  Deviation metrics("turns of the response at rest against start and pull-out frequency", 1e-11);
  for (const MotorDesign& design : {driven_motor(65), driven_motor_with_layer(90)}) {
    const FrequencyResponse response(design, kAtRest);
    std::vector<double> folds;
    for (const ResponseBranch& branch : response.branches())
      if (branch.last_end == BranchEndKind::fold) folds.push_back(branch.points.back().frequency);
    REQUIRE(folds.size() == 2);
    // An extremum's place is known to 1e-8, its value to rounding; the secants of (D3.4) end at 1e-13.
    for (const auto& [fold, metric] : {std::pair{folds[0], Metric::start_frequency},
                                       std::pair{folds[1], Metric::pull_out_frequency}})
      CHECK(metrics.add(fold, value(design, metric), fold) < 1e-11);
  }
  // Another program followed these at 0.3 rad/s, where the rotor's turning moves the start by 22 Hz.
  const FrequencyResponse turning(driven_motor(65), {Argument::speed, 0.3});
  const auto branches = turning.branches();
  REQUIRE(branches.size() == 3);
  Deviation other("start and pull-out of a frequency sweep against another program [Hz]", 0.5);
  CHECK(other.add(branches[0].points.back().frequency, 43649, 1) < 0.5);
  CHECK(other.add(branches[2].points.front().frequency, 40338, 1) < 0.5);
}

TEST_CASE("without load the flanks meet at the loaded resonance (D3.1, D5.1)",
          "[core][driven][frequency]") {
  const auto resonance_with_rotor = [](const MotorDesign& design, const ResponsePoint& p) {
    const double free = *design.stator.resonance_frequency,
                 stiffness = p.point.reactive_force / p.point.amplitude;
    return std::sqrt(free * free + stiffness / (4 * kPi * kPi * *design.stator.modal_mass));
  };
  for (const MotorDesign& design : {driven_motor(120), driven_motor_with_layer(80)}) {
    const FrequencyResponse response(design, {Argument::torque, 0});
    ResponsePoint largest{};
    for (const ResponseBranch& branch : response.branches())
      for (const ResponsePoint& p : branch.points)
        if (p.point.amplitude > largest.point.amplitude) largest = p;
    CHECK(largest.stable);
    // The phase moves with the root of the distance to the largest amplitude, known to 1e-14 of itself.
    CHECK(largest.point.phase_lag == Approx(kPi / 2).margin(1e-6));
    CHECK(resonance_with_rotor(design, largest) == Approx(largest.frequency).epsilon(1e-9));
    // At the drive's own frequency the metric takes the same wave.
    const ResponsePoint running = response.at(40.8e3).back();
    CHECK(running.point.speed == Approx(value(design, Metric::no_load_speed)).epsilon(1e-9));
    CHECK(resonance_with_rotor(design, running) ==
          Approx(value(design, Metric::loaded_resonance)).epsilon(1e-9));
  }
}

TEST_CASE("a torque and the speed that it gives are the same load (D5.4)",
          "[core][driven][frequency]") {
  for (const MotorDesign& design : {driven_motor(80), driven_motor_with_layer(120)}) {
    for (const double torque : {0.0, 0.3, 0.7}) {
      const FrequencyResponse response(design, {Argument::torque, torque});
      int stable = 0;
      for (const double frequency : spaced_frequencies(40.2e3, 43e3, 9)) {
        const Motor there(with(design, Parameter::frequency, frequency));
        for (const ResponsePoint& p : response.at(frequency)) {
          CAPTURE(torque, frequency, p.point.speed, p.point.amplitude);
          // The square of Newton's last step, over the slope of the curve: some 1 / V0.
          CHECK(p.point.torque == Approx(torque).margin(1e-9));
          if (!p.stable || p.point.speed <= 0) continue;
          ++stable;
          const std::vector<WaveState> waves = there.wave_states(p.point.speed);
          CHECK(std::any_of(waves.begin(), waves.end(), [&](const WaveState& w) {
            return w.stable && std::fabs(w.amplitude - p.point.amplitude) < 1e-9 * w.amplitude;
          }));
          // Along the running wave more speed gives less torque.
          const WaveState& running = waves.back();
          if (!running.running || running.amplitude > 1.001 * p.point.amplitude) continue;
          CHECK(there.operating_point(p.point.speed * 1.001).torque < torque);
        }
      }
      CHECK(stable >= 3);
    }
  }
}

TEST_CASE("a load turns the rotor back where the wave frees it, and friction holds it where not",
          "[core][driven][frequency]") {
  const FrequencyResponse response(driven_motor(65), {Argument::torque, 0.5});
  const ResponsePoint dead = response.at(42e3).front();
  CHECK(dead.point.speed < 0);
  CHECK(dead.point.torque == Approx(0.5).epsilon(1e-9));
  const ResponsePoint held =
      FrequencyResponse(driven_motor(65), {Argument::torque, 0.2}, std::pair{30e3, 50e3})
          .at(31e3)
          .front();
  CHECK(held.point.speed == 0);
  CHECK(held.point.torque == 0.2);
  CHECK(held.stable);
}

TEST_CASE("sweeps up and down close a hysteresis between their jumps (D5.3)",
          "[core][driven][frequency]") {
  Deviation closed("sweeps up and down agree outside the hysteresis", 0);
  for (const RotorLoad& load :
       {kAtRest, RotorLoad{Argument::torque, 0.0}, RotorLoad{Argument::torque, 0.5}}) {
    const FrequencyResponse response(driven_motor(65), load);
    const std::vector<double> frequencies = spaced_frequencies(response.from(), response.to(), 201);
    const FrequencySweep up = response.sweep(frequencies);
    FrequencySweep down = response.sweep(reversed(frequencies));
    std::reverse(down.points.begin(), down.points.end());
    REQUIRE(up.jumps.size() == 1);
    REQUIRE(down.jumps.size() == 1);
    const double start = up.jumps[0].from.frequency, pull_out = down.jumps[0].from.frequency;
    CHECK(pull_out < start);
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      CAPTURE(load.value, frequencies[i], start, pull_out);
      REQUIRE(up.points[i].has_value());
      REQUIRE(down.points[i].has_value());
      const double a = up.points[i]->point.amplitude, b = down.points[i]->point.amplitude;
      if (frequencies[i] > pull_out && frequencies[i] < start)
        CHECK(b > 1.5 * a);
      else
        CHECK(closed.add(a, b, 1) == 0);
    }
    // Each jump lands where the other sweep is.
    REQUIRE(up.jumps[0].to.has_value());
    REQUIRE(down.jumps[0].to.has_value());
    CHECK(up.jumps[0].to->point.amplitude ==
          Approx(response.at(start).back().point.amplitude).epsilon(1e-9));
    CHECK(down.jumps[0].to->point.amplitude ==
          Approx(response.at(pull_out).front().point.amplitude).epsilon(1e-9));
    const auto running = response.at(0.5 * (start + pull_out)).back();
    CHECK(response.pull_out_below(running).value() == pull_out);
  }
}

TEST_CASE("a sweep says where no steady wave is left", "[core][driven][frequency]") {
  // The dead wave under a turning rotor grows (D2.6).
  const FrequencyResponse response(driven_motor(65), {Argument::speed, 8});
  const FrequencySweep down = response.sweep(reversed(spaced_frequencies(40e3, 41e3, 11)));
  REQUIRE(down.jumps.size() == 1);
  CHECK(!down.jumps[0].to.has_value());
  CHECK(down.points.front().has_value());
  CHECK(!down.points.back().has_value());
}

TEST_CASE("a response that cannot be says why", "[core][driven][frequency]") {
  CHECK_THROWS_WITH(FrequencyResponse(ring_motor(), kAtRest), Catch::Contains("voltage"));
  CHECK_THROWS_AS(FrequencyResponse(driven_motor(),
                                    {Argument::torque, std::numeric_limits<double>::infinity()}),
                  InputError);
  CHECK_THROWS_AS(FrequencyResponse(driven_motor(), kAtRest, std::pair{41e3, 40e3}), InputError);
  const FrequencyResponse response(driven_motor(), kAtRest);
  CHECK_THROWS_AS(response.sweep(std::vector{40e3}), InputError);
  CHECK_THROWS_AS(response.sweep(std::vector{40e3, 41e3, 40e3}), InputError);
  CHECK(response.at(1e6).empty());
  // Without a voltage nothing moves, and no torque above mu F_N r is carried.
  CHECK(FrequencyResponse(driven_motor(0), kAtRest).branches().empty());
  CHECK(FrequencyResponse(driven_motor(), {Argument::torque, 5}).branches().empty());
}
