// SPDX-License-Identifier: Apache-2.0
#include "motion/motion_motors.hpp"

#include "support/csv_rows.hpp"

#include <catch2/catch.hpp>

#include <complex>
#include <map>

// Speed loops against another program's, and their margins against a discrete simulation of their own.
namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;

// The loop of reference/motion/speed_loop.csv.
SpeedControl loop_of(const CsvRow& row) {
  SpeedControl control;
  control.reference = profile_of(row.word("reference"));
  control.sample_time = row["Ts"], control.delay = static_cast<int>(row["delay_samples"]);
  control.range = {row["f_min"], row["f_max"]}, control.start = row["f0"];
  control.gains = LoopGains{row["kp_Hz_per_rad_s"], row["ki_Hz_per_rad"]};
  return control;
}

TEST_CASE("closed loops of the speed are those of another program (M8.1)",
          "[motion][control][reference]") {
  std::map<std::string, std::vector<CsvRow>> loops;
  for (const CsvRow& row : csv_rows("motion/speed_loop.csv")) loops[row.word("J")].push_back(row);
  REQUIRE(loops.size() == 2);
  for (const auto& [inertia, rows] : loops)
    for (const auto engine : {MotionEngine::averaged, MotionEngine::oscillating}) {
      CAPTURE(inertia, engine == MotionEngine::oscillating);
      const CsvRow& first = rows.front();
      const MotorDesign d = elastic_60(first["J"], first["V_rms"]);
      const double half = first["Ts"] / 2;
      MotionTask task = steady_drive(d, rows.back()["t"] + 2 * half);
      task.engine = engine;
      // Its step of the load within the sample from 0.18 s takes hold with the next sample.
      task.load_torque = Profile({{0.181, 0}, {0.181, 0.3}});
      for (const CsvRow& row : rows)  // its frequency is that of the sample that begins
        task.output_times.insert(task.output_times.end(), {row["t"], row["t"] + half});
      const ControlledMotion m = simulate(d, task, loop_of(first));
      REQUIRE(m.motion.status == "ok");
      REQUIRE(m.motion.samples.size() == 2 * rows.size());
      const bool averaged = engine == MotionEngine::averaged;
      const std::string suffix = averaged ? "_averaged" : "_oscillating";
      for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(rows[i].word("t"));
        const MotionSample &at = m.motion.samples[2 * i], &held = m.motion.samples[2 * i + 1];
        // The averaged program has the same equations and five digits. The oscillating ones differ by their steps, and a little more
        // where the speed changes by 1 rad/s in a millisecond.
        const double allowed = averaged ? 2e-5 : rows[i]["t"] < 0.02 ? 0.04 : 0.015;
        CHECK(at.speed == Approx(rows[i]["Omega" + suffix]).margin(allowed));
        CHECK(held.frequency == Approx(rows[i]["frequency" + suffix]).margin(averaged ? 0.002 : 3));
      }
    }
}

TEST_CASE("gains of (M8.1) settle a step without ringing", "[motion][control][reference]") {
  struct Row {
    double inertia, earliest, latest, overshoot;  // [kg m^2, ms, ms, 1]
  };
  // 5 % after 14 to 15 ms, and after 11 ms with an overshoot of 2 %; there the gains are those of 41.2 kHz, 12.8 rad/s.
  for (const Row& row : {Row{1e-4, 13, 16, 0.001}, Row{1e-3, 9, 13, 0.03}}) {
    CAPTURE(row.inertia);
    const MotorDesign d = elastic_60(row.inertia);
    const double steady = 12.8449;  // of 41.2 kHz
    MotionTask task = steady_drive(d, 0.15);
    SpeedControl control;
    control.reference = Profile({{0, steady}, {0.05, steady}, {0.05, 1.05 * steady}});
    control.range = {39.7e3, 44.5e3}, control.start = 41.2e3;
    task.initial.steady = true;
    task.output_times = times_to(0.15, 15000);
    const ControlledMotion m = simulate(d, task, control);
    REQUIRE(m.motion.status == "ok");
    double settled = 0, largest = 0;
    const double goal = 1.05 * steady, step = 0.05 * steady;
    for (const MotionSample& s : m.motion.samples) {
      if (s.time < 0.05) continue;
      if (std::abs(s.speed - goal) > 0.05 * step) settled = 1e3 * (s.time - 0.05);
      largest = std::max(largest, s.speed - goal);
    }
    CHECK(settled > row.earliest);
    CHECK(settled < row.latest);
    CHECK(largest / step < row.overshoot);
  }
}

TEST_CASE("the gains are those of K and tau at the largest reference (M8.1)",
          "[motion][control][closed-form]") {
  const MotorDesign d = elastic_60(1e-4);
  MotionTask task = steady_drive(d, 0.002);
  SpeedControl control;
  control.reference = 12.8449;  // at 41.2 kHz without load
  control.range = {39.7e3, 44.5e3}, control.start = 43e3;
  const ControlledMotion m = simulate(d, task, control);
  CHECK(m.plant.output == Approx(41.2e3).epsilon(1e-5));
  CHECK(m.plant.gain == Approx(-6.6e-3).epsilon(0.01));  // to the digits given
  // lambda + theta_d = 6 ms
  CHECK(m.gains.integral == Approx(1 / (m.plant.gain * 6e-3)).epsilon(1e-12));
  CHECK(m.gains.proportional ==
        Approx(m.plant.time_constant / (m.plant.gain * 6e-3)).epsilon(1e-12));
}

// A loop of a linear plant in small steps of time, without a transform: x' = A x + B u, PI, delay, difference of angles. True if a
// disturbance dies out when gain and dead time are larger.
bool is_stable(const LinearPlant& plant, const SpeedControl& c, LoopGains gains, double factor) {
  gains.proportional *= factor, gains.integral *= factor;
  constexpr int kSteps = 400;  // Euler's method over a sample: poles of 1e4 / s in steps of 2.5 us
  std::vector<double> x(4, 0.0);
  std::vector<double> waiting(static_cast<std::size_t>(c.delay), 0.0);
  double integral = 0, angle = 0, early = 0, late = 0;
  x[2] = 1e-3 * plant.states[2].steady;
  for (int k = 0; k < 400; ++k) {
    const double speed = (x[3] - angle) / c.sample_time;
    angle = x[3];
    const double more = -gains.integral * c.sample_time * speed;
    waiting.push_back(integral - gains.proportional * speed + more);
    integral += more;
    const double u = waiting.front();
    waiting.erase(waiting.begin());
    for (int i = 0; i < kSteps; ++i) {
      std::vector<double> rate(4);
      for (std::size_t r = 0; r < 4; ++r) {
        rate[r] = plant.b[r][1] * u;
        for (std::size_t s = 0; s < 4; ++s) rate[r] += plant.a[r][s] * x[s];
      }
      for (std::size_t r = 0; r < 4; ++r) x[r] += rate[r] * c.sample_time / kSteps;
    }
    (k < 200 ? early : late) = std::max(k < 200 ? early : late, k > 100 ? std::abs(speed) : 0);
  }
  return late < early;
}

TEST_CASE("a gain margin is the factor that makes the loop unstable",
          "[motion][control][identity]") {
  for (const double inertia : {1e-4, 1e-3}) {
    for (const int delay : {0, 1, 3}) {
      CAPTURE(inertia, delay);
      const LinearPlant plant = linearize(elastic_60(inertia, 140, 41.2e3), 0);
      SpeedControl control;
      control.delay = delay;
      const LoopGains gains = loop_gains(loop_plant(plant, Actuator::frequency), 1e-3, delay);
      const LoopMargins margins = loop_margins(plant, control, gains);
      REQUIRE(std::isfinite(margins.gain));
      // Euler's steps shift the poles by 1e-2 at most.
      CHECK(is_stable(plant, control, gains, 0.97 * margins.gain));
      CHECK_FALSE(is_stable(plant, control, gains, 1.03 * margins.gain));
      // (M8.1) closes the loop at 1 / (lambda + theta_d) nearly, a lag of 90 degrees and that of the dead time.
      const double dead = (delay + 1) * 1e-3;
      CHECK(2 * std::numbers::pi * margins.crossover == Approx(1 / (3 * dead)).epsilon(0.35));
      CHECK(margins.phase > 45 * std::numbers::pi / 180);
    }
  }
}

TEST_CASE("a pure integrator in the loop has margins in closed form",
          "[motion][control][closed-form]") {
  // The fast motor at slow sampling is a static gain K: L(z) = k z^-delay (1 + 1/z) / 2 ... z / (z - 1) of the integral alone.
  const LinearPlant plant = linearize(elastic_60(1e-6, 140, 41.2e3), 0);
  SpeedControl control;
  control.sample_time = 0.1, control.delay = 1;
  const double gain = loop_plant(plant, Actuator::frequency).gain;
  const LoopGains gains{0, 0.2 / (gain * control.sample_time)};
  // L = 0.2 z^-1 / (z - 1): the speed of a sample is known at its end. |L| = 1: 2 sin(w / 2) = 0.2; a lag of 3 w / 2 and 90 degrees;
  // unstable with w = 60 degrees, at 2 sin 30 degrees = 1 = 0.2 g.
  const LoopMargins margins = loop_margins(plant, control, gains);
  const double crossover = 2 * std::asin(0.1);
  // Transients of the wave, 1 ms of a sample of 100 ms.
  CHECK(margins.gain == Approx(5).epsilon(0.02));
  CHECK(2 * std::numbers::pi * margins.crossover * control.sample_time ==
        Approx(crossover).epsilon(0.01));
  CHECK(margins.phase == Approx(std::numbers::pi / 2 - 1.5 * crossover).epsilon(0.02));
}

TEST_CASE("an encoder rounds the angle, and limits keep the output", "[motion][control]") {
  const MotorDesign d = elastic_60(1e-4);
  MotionTask task = steady_drive(d, 0.1);
  SpeedControl control;
  control.reference = 12.0, control.encoder = 4000;
  control.range = {41.0e3, 43.6e3}, control.start = 43.6e3, control.slew = 2e5;
  task.output_times = times_to(0.1, 2000);
  const ControlledMotion m = simulate(d, task, control);
  REQUIRE(m.motion.status == "ok");
  double before = control.start, mean = 0;
  for (const MotionSample& s : m.motion.samples) {
    CHECK(s.frequency >= 41.0e3);
    CHECK(s.frequency <= 43.6e3);
    CHECK(std::abs(s.frequency - before) <= 200 + 1e-6);  // 0.2 kHz a sample
    before = s.frequency;
    if (s.time > 0.05) mean += s.speed / 1000;
  }
  // A count of 1.57 mrad in a sample of a millisecond is 1.57 rad/s, but the loop counts none twice: over 50 ms it is 0.03.
  CHECK(mean == Approx(12).margin(0.05));
}

TEST_CASE("a loop of the voltage holds a speed, too", "[motion][control]") {
  const MotorDesign d = elastic_60(1e-4);
  MotionTask task = steady_drive(d, 0.1);
  SpeedControl control;
  control.actuator = Actuator::voltage;
  control.reference = 15.0;
  control.range = {100, 160}, control.start = 140;
  const ControlledMotion m = simulate(d, task, control);
  CHECK(m.gains.integral > 0);
  CHECK(m.motion.last.speed == Approx(15).epsilon(1e-4));
  CHECK(m.motion.last.voltage == Approx(m.plant.output).epsilon(1e-4));
}

// 2.5 counts of 4000: within them the loop rests, whatever the rounding of the encoder.
constexpr double kNear = 2.5 * 2 * std::numbers::pi / 4000;

TEST_CASE("a loop of the position takes time and energy of another program's (M8.2)",
          "[motion][control][reference]") {
  struct Row {
    double gain, time, energy;  // [1/s, ms, J]
  };
  // Both engines, and one with a rotor of 100 g: 55 ms and 0.26 J; 38 to 44 ms and 0.31 J.
  for (const Row& row : {Row{60, 55, 0.26}, Row{150, 40, 0.31}}) {
    for (const double mass : {-1.0, 0.0, 0.1}) {
      CAPTURE(row.gain, mass);
      MotorDesign d = elastic_60(1e-4);
      MotionTask task = steady_drive(d, 0.1);
      if (mass >= 0) {
        d.rotor.mass = mass, d.rotor.axial_damping = 1000;
        task.engine = MotionEngine::oscillating;
      }
      task.output_times = times_to(0.1, 2000);
      PositionControl control;
      control.reference = 0.5, control.gain = row.gain;
      control.range = {40.2e3, 43.6e3}, control.slew = 2e5;
      const Motion m = simulate(d, task, control);
      REQUIRE(m.status == "ok");
      double settled = 0, largest = 0;
      for (const MotionSample& s : m.samples) {
        if (std::abs(s.angle - 0.5) > kNear) settled = 1e3 * s.time;
        largest = std::max(largest, s.angle - 0.5);
      }
      CHECK(settled == Approx(row.time).epsilon(0.15));
      CHECK(m.last.energy == Approx(row.energy).epsilon(0.15));
      CHECK(largest < kNear);
      CHECK(m.last.off);
    }
  }
}

TEST_CASE("a loop of the position reverses, and coasts past its goal with a heavy load",
          "[motion][control]") {
  MotorDesign d = elastic_60(1e-4);
  MotionTask task = steady_drive(d, 0.2);
  PositionControl control;
  control.reference = Profile({{0, 0.3}, {0.1, 0.3}, {0.1, 0.1}});
  control.gain = 60, control.range = {40.2e3, 43.6e3}, control.slew = 2e5;
  task.output_times = times_to(0.2, 2000);
  const Motion m = simulate(d, task, control);
  REQUIRE(m.status == "ok");
  CHECK(count_of(m, MotionEventKind::swapped) > 0);
  CHECK(m.samples[990].angle == Approx(0.3).margin(kNear));
  CHECK(m.last.angle == Approx(0.1).margin(kNear));
  // With ten times the inertia it counts on more friction than it has while it coasts: 14 to 26 mrad beyond the goal.
  d = elastic_60(1e-3);
  d.rotor.mass = 0, task.engine = MotionEngine::oscillating;
  control.reference = 0.5;
  const Motion heavy = simulate(d, task, control);
  double largest = 0;
  for (const MotionSample& s : heavy.samples) largest = std::max(largest, s.angle - 0.5);
  CHECK(largest > 0.012);
  CHECK(largest < 0.03);
}

TEST_CASE("a gain schedule has the plant of each frequency", "[motion][control][reference]") {
  const auto rows =
      gain_schedule(elastic_60(1e-4), 0, Actuator::frequency, {40.2e3, 42e3}, 1e-3, 1);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].plant->gain == Approx(-21.8e-3).epsilon(0.003));  // to the digits given
  CHECK(rows[1].plant->gain == Approx(-3.5e-3).epsilon(0.015));
  const auto none = gain_schedule(elastic_60(1e-4), 2, Actuator::frequency, {44e3}, 1e-3, 1);
  CHECK_FALSE(none[0].plant.has_value());
}

TEST_CASE("a loop that is not admissible says what would be right", "[motion][control][input]") {
  using Catch::Contains;
  const MotorDesign motor = elastic_60(1e-4);
  const MotionTask task = steady_drive(motor, 0.01);
  SpeedControl right;
  right.reference = 12.0, right.range = {39.7e3, 44.5e3}, right.start = 43e3;
  const auto refused = [&](auto change, const char* words) {
    SpeedControl c = right;
    change(c);
    CHECK_THROWS_WITH(require_control(motor, task, c), Contains(words));
  };
  CHECK_NOTHROW(require_control(motor, task, right));
  refused([](SpeedControl& c) { c.sample_time = 0; }, "sample_time");
  refused([](SpeedControl& c) { c.sample_time = 1e-9; }, "a million samples");
  refused([](SpeedControl& c) { c.delay = -1; }, "delay");
  refused([](SpeedControl& c) { c.encoder = 0; }, "encoder");
  refused([](SpeedControl& c) { c.range = {44e3, 40e3}; }, "range");
  refused([](SpeedControl& c) { c.start = 46e3; }, "within its range");
  refused([](SpeedControl& c) { c.slew = 0; }, "slew");
  refused([](SpeedControl& c) { c.reference = -3.0; }, "0 or more");
  refused([](SpeedControl& c) { c.reference = 0.0; }, "must not be 0");
  refused([](SpeedControl& c) { c.reference = 60.0; }, "no output within");
  refused(
      [](SpeedControl& c) {
        c.range = {38.5e3, 44.5e3};
      },
      "narrower range");  // below the resonance
  refused([](SpeedControl& c) { c.gains = LoopGains{12, 25000}; }, "must be negative");
  PositionControl position;
  position.reference = 0.5, position.range = {40.2e3, 43.6e3};
  const auto position_refused = [&](auto change, const char* words) {
    PositionControl c = position;
    MotionTask t = task;
    change(c, t);
    CHECK_THROWS_WITH(require_control(motor, t, c), Contains(words));
  };
  CHECK_NOTHROW(require_control(motor, task, position));
  position_refused([](PositionControl& c, MotionTask&) { c.encoder = 0; }, "encoder");
  position_refused([](PositionControl& c, MotionTask&) { c.gain = -1; }, "gain");
  position_refused([](PositionControl& c, MotionTask&) { c.window = 0; }, "window");
  position_refused([](PositionControl& c, MotionTask&) { c.off_time = -1; }, "off_time");
  position_refused([](PositionControl& c, MotionTask&) { c.slew = -1; }, "slew");
  position_refused([](PositionControl&, MotionTask& t) { t.engine = MotionEngine::oscillating; },
                   "rotor_mass");
}

}  // namespace
