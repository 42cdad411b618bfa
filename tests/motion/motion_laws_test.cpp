// SPDX-License-Identifier: Apache-2.0
#include "motion/motion_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;
using Event = MotionEventKind;

// The steady wave of the branch engine at the speed and with the amplitude at which a motion ended.
void check_ends_in_stable_wave(const MotorDesign& d, const Motion& m, double load) {
  REQUIRE(m.status == "ok");
  REQUIRE_FALSE(m.last.held);
  const Motor motor(d);
  const std::vector<WaveState> waves = motor.wave_states(m.last.speed);
  const auto same = std::ranges::find_if(waves, [&](const WaveState& wave) {
    return std::abs(wave.amplitude - m.last.amplitude) < 1e-6 * wave.amplitude;
  });
  REQUIRE(same != waves.end());
  CHECK(same->stable);
  // All transients are gone but for 1e-6 of the largest torque.
  CHECK(m.last.torque == Approx(load).margin(1e-6 * largest_torque(d)));
}

TEST_CASE("a motion under a constant drive ends in a stable wave of the branch engine or held",
          "[motion][identity]") {
  for (const double load : {0.0, 0.4, -0.2}) {
    for (const double voltage : {140.0, 108.0, 60.0}) {
      CAPTURE(load, voltage);
      const MotorDesign d = elastic_60(1e-4, voltage);
      MotionTask task = steady_drive(d, 0.2);
      task.load_torque = load;
      const Motion m = simulate(d, task);
      REQUIRE(m.status == "ok");
      if (!m.last.held) {
        check_ends_in_stable_wave(d, m, load);
        continue;
      }
      // The dead wave at rest holds the load.
      CHECK(m.last.speed == 0);
      const Motor motor(d);
      const OperatingConditions rest{1e-12, m.last.amplitude, 40.8e3};
      CHECK(motor.operating_point(rest).torque < load);
      CHECK(m.last.torque == load);
    }
  }
}

TEST_CASE("a start with a layer with inertia and damping over an annulus ends on the curve",
          "[motion][identity]") {
  MotorDesign d = elastic_60(1e-4);
  d.layer.given_inertia.reset();
  d.layer.given_shear_viscosity.reset();
  d.stator.radial_slices = GENERATE(4, kAutoSlices);
  MotionTask task = steady_drive(d, 0.06);
  task.load_torque = 0.3;
  const Motion m = simulate(d, task);
  REQUIRE(m.status == "ok");
  const Motor motor(d);
  const MetricValue speed = evaluate(motor, {Metric::speed_at, Argument::torque, 0.3});
  // 1e-6: to which `auto` takes its torque; without it the tolerance of the integration.
  CHECK(m.last.speed == Approx(speed.value).epsilon(2e-6));
}

// A motor whose surface also moves radially, by a ratio of exponent / n (R1.1).
MotorDesign tilting(double exponent, int slices) {
  MotorDesign d = elastic_60(7e-6);
  d.stator.radial_shape.exponent = exponent;
  d.stator.radial_slices = slices;
  d.stator.radial_motion = true;
  return d;
}

TEST_CASE("a motor whose surface also moves radially starts to the speed of its curve, and stops",
          "[motion][identity]") {
  const MotorDesign d = tilting(4, GENERATE(1, 4));
  MotionTask task = steady_drive(d, 0.03);
  task.load_torque = 0.3;
  const Motion m = simulate(d, task);
  REQUIRE(m.status == "ok");
  const MetricValue speed = evaluate(Motor(d), {Metric::speed_at, Argument::torque, 0.3});
  // The tolerance of the integration.
  CHECK(m.last.speed == Approx(speed.value).epsilon(2e-6));
  MotionTask stop = steady_drive(d, 0.01);
  stop.initial.steady = true;
  stop.switched_off = {{0, 0.01}};
  const Motion stopped = simulate(d, stop);
  REQUIRE(stopped.status == "ok");
  CHECK(stopped.last.held);
  CHECK(time_of(stopped, Event::held) > 0);
}

TEST_CASE("a motion of a surface that hardly moves radially is that without (R1.1)",
          "[motion][limit]") {
  const auto end = [](const MotorDesign& d) { return simulate(d, steady_drive(d, 0.002)).last; };
  MotorDesign without = tilting(1e-3, 1);
  without.stator.radial_motion = false;
  const MotionSample still = end(without), slight = end(tilting(1e-3, 1));
  // Every number goes with the square of q = 1e-3 / 9, and the line to the torque at rest is off by 1e-6; what the tolerance of
  // 1e-8 a step leaves after some hundred steps.
  CHECK(slight.speed == Approx(still.speed).epsilon(3e-6));
  CHECK(slight.amplitude == Approx(still.amplitude).epsilon(3e-6));
}

// What (C21.5) misses over a motion, and what the drive has turned over [J].
struct WaveEnergy {
  double missed{0}, turnover{0};
};

WaveEnergy wave_energy(const MotorDesign& d, const MotionTask& task) {
  const Motor motor(d);
  const double ms = *d.stator.modal_mass, ds = modal_damping(d),
               omega = 2 * std::numbers::pi * 40.8e3, force = 0.55 * std::numbers::sqrt2 * 140;
  const double ks = ms * std::pow(2 * std::numbers::pi * 39e3, 2);
  const Motion m = simulate(d, task);
  REQUIRE(m.status == "ok");
  const auto& s = m.samples;
  const auto square = [&](std::size_t k) { return s[k].amplitude * s[k].amplitude; };
  const double dt = s[1].time - s[0].time;
  WaveEnergy found;
  for (std::size_t k = 2; k + 2 < s.size(); ++k) {
    const double a = s[k].amplitude, size = std::max(a, 1e-12);
    const double stiffness =
        ks + motor.operating_point({s[k].speed, size, 40.8e3}).reactive_force / size;
    const double factor = ms * omega * (omega + std::sqrt(stiffness / ms)) / 2;
    const double drive = s[k].off ? 0 : force * omega * a * std::sin(s[k].phase_lag);
    // Differences of the fourth order: of 50 ns over changes of 20 us they leave 1e-10.
    const double rate =
        (square(k - 2) - 8 * square(k - 1) + 8 * square(k + 1) - square(k + 2)) / (12 * dt);
    found.missed += (factor * rate - drive + ds * omega * omega * a * a + s[k].stator_power) * dt;
    found.turnover += std::abs(drive) * dt;
  }
  return found;
}

TEST_CASE("the wave's energy is what it takes and does not pass on (C21.5)", "[motion][identity]") {
  const MotorDesign d = elastic_60(1e-4);
  MotionTask start = steady_drive(d, 0.004);
  start.output_times = times_to(start.duration, 80000);
  const WaveEnergy driven = wave_energy(d, start);
  CHECK(driven.turnover > 0.01);
  CHECK(std::abs(driven.missed) < 1e-6 * driven.turnover);
  MotionTask stop = steady_drive(d, 0.002);
  stop.initial.steady = true;
  stop.switched_off = {{0, stop.duration}};
  stop.output_times = times_to(stop.duration, 40000);
  CHECK(std::abs(wave_energy(d, stop).missed) < 1e-6 * driven.turnover);
}

TEST_CASE("the electrical energy is the integral of the power", "[motion][identity]") {
  const MotorDesign d = elastic_60(1e-4);
  MotionTask task = steady_drive(d, 0.004);
  task.output_times = times_to(0.004, 40000);
  const Motion m = simulate(d, task);
  double energy = 0;  // by Simpson's rule
  for (std::size_t k = 2; k < m.samples.size(); k += 2)
    energy += (m.samples[k - 2].electrical_power + 4 * m.samples[k - 1].electrical_power +
               m.samples[k].electrical_power) *
              (m.samples[k].time - m.samples[k - 2].time) / 6;
  CHECK(m.last.energy == Approx(energy).epsilon(1e-6));
}

TEST_CASE("a rotor without a wave stops under friction alone (C21.1)", "[motion][closed-form]") {
  const double inertia = 1e-4, speed = 16, load = 0.3;
  const MotorDesign d = elastic_60(inertia);
  MotionTask task = steady_drive(d, 0.02);
  task.initial.speed = speed;
  task.load_torque = load;
  task.switched_off = {{0, 0.02}};
  const Motion m = simulate(d, task);
  REQUIRE(m.status == "ok");
  const double time = inertia * speed / (largest_torque(d) + load);
  CHECK(m.last.held);
  // Both follow parabolas in time, which the integrator has without an error but that of its tolerance.
  CHECK(time_of(m, Event::held) == Approx(time).epsilon(1.5e-7));
  CHECK(m.last.angle == Approx(time * speed / 2).epsilon(1.5e-7));
  CHECK(m.last.torque == load);
}

TEST_CASE("a free wave decays by the stator's damping and that of the resistor (C21.6)",
          "[motion][closed-form]") {
  const double omega = 2 * std::numbers::pi * 40.8e3, free = 2 * std::numbers::pi * 39e3;
  const double mass = 0.025, theta = 0.55, capacitance = 8.5e-9, amplitude = 1e-6, time = 2e-3;
  for (const double resistance : {0.0, 459.0, 2000.0, 1e12}) {
    CAPTURE(resistance);
    MotorDesign d = elastic_60(1e-4);
    d.preload = 0;
    d.driver = Driver{resistance};
    MotionTask task = steady_drive(d, time);
    task.initial.amplitude = amplitude;
    task.tolerance = 1e-9;  // a thousandth of what is asked for, in some hundred steps
    task.switched_off = {{0, time}};
    const Motion m = simulate(d, task);
    const double damping =
        modal_damping(d) +
        theta * theta * resistance / (1 + std::pow(omega * capacitance * resistance, 2));
    // (M2.1) is linear without contact and voltage.
    CHECK(m.last.amplitude ==
          Approx(amplitude * std::exp(-damping * omega * time / (mass * (omega + free))))
              .epsilon(1e-6));
    // What leaves the terminals is the resistor's share of the energy m_s omega (omega + omega_b) A^2 / 2.
    const double lost = 0.5 * mass * omega * (omega + free) *
                        (amplitude * amplitude - std::pow(m.last.amplitude, 2));
    CHECK(-m.last.energy ==
          Approx(lost * (1 - modal_damping(d) / damping)).epsilon(1e-6).margin(1e-12));
  }
}

TEST_CASE("a stator without rotor reaches the amplitude of its resonance curve (M2.1)",
          "[motion][closed-form]") {
  MotorDesign d = elastic_60(1e-4);
  d.preload = 0;
  const Motion m = simulate(d, steady_drive(d, 0.03));
  REQUIRE(m.status == "ok");
  const double omega = 2 * std::numbers::pi * 40.8e3, free = 2 * std::numbers::pi * 39e3;
  const double amplitude =
      0.55 * std::numbers::sqrt2 * 140 /
      std::hypot(0.025 * (free * free - omega * omega), omega * modal_damping(d));
  // 30 ms are 24 time constants 2 m_s / d_s.
  CHECK(m.last.amplitude == Approx(amplitude).epsilon(1e-6));
  CHECK(m.last.speed == Approx(0).margin(1e-8));
}

TEST_CASE("the wave releases the rotor where the hold of (M4.2) is used up",
          "[motion][closed-form]") {
  const MotorDesign d = elastic_60(1e-4);
  const double opening = contact_opens_at(d), hold = largest_torque(d);
  const double kappa = d.stator.wavelengths / d.stator.contact_radius;
  const double s =
      shear_modulus(d) * kappa * d.stator.neutral_plane_distance / d.layer.youngs_modulus;
  const double lock = opening * 0.23 / std::hypot(0.23, s);
  for (const double load : {0.0, 0.4 * hold, -0.7 * hold}) {
    CAPTURE(load);
    MotionTask task = steady_drive(d, 0.001);
    task.load_torque = load;
    const Motion m = simulate(d, task);
    REQUIRE(m.events.front().kind == Event::released);
    // A load against the wave is released backward, one with it forward: (M4.2) knows both by |load|.
    CHECK(m.events.front().amplitude == Approx(lock * (1 - std::abs(load) / hold)).epsilon(1e-7));
  }
}

// The load's dry friction holds, too.
TEST_CASE("friction of the load adds to what the contact holds (M4.1)", "[motion][closed-form]") {
  MotorDesign d = elastic_60(1e-4);
  d.load = ShaftLoad{.friction = 0.1};
  const double hold = largest_torque(d);
  MotionTask task = steady_drive(d, 0.05);
  task.voltage = 0.0;
  task.load_torque = Profile({{0, 0}, {0.05, 1.5 * hold}});
  const Motion m = simulate(d, task);
  REQUIRE(m.events.front().kind == Event::released);
  CHECK(m.events.front().time ==
        Approx(0.05 * (hold + 0.1) / (1.5 * hold)).epsilon(3e-7));  // T7.8 at A_1 / 1e7
  CHECK(m.last.speed < 0);

  // Running, it is a torque against the motion.
  MotionTask running = steady_drive(d, 0.08);
  MotorDesign frictionless = d;
  frictionless.load.reset();
  MotionTask loaded = running;
  loaded.load_torque = 0.1;
  CHECK(simulate(d, running).last.speed ==
        Approx(simulate(frictionless, loaded).last.speed).epsilon(1e-6));
}

TEST_CASE("a spring comes to rest where it balances the torque at rest", "[motion][identity]") {
  MotorDesign d = elastic_60(1e-4);
  d.load = ShaftLoad{.damping = 0.05, .stiffness = 20, .neutral = 0.01};
  const Motion m = simulate(d, steady_drive(d, 0.2));
  REQUIRE(m.status == "ok");
  const double torque = Motor(d).operating_point({1e-12, m.last.amplitude, 40.8e3}).torque;
  CHECK(20 * (m.last.angle - 0.01) == Approx(torque).epsilon(1e-6));
}

TEST_CASE("at a constant amplitude the speed rises as the brush law says (C21.2, C21.3, C21.4)",
          "[motion][closed-form]") {
  for (const double preload : {0.2, 2.0}) {
    MotorDesign d = elastic_60(1e-2);
    d.stator.voltage.reset();
    d.stator.amplitude = 2e-6;
    d.preload = preload;
    const Motor motor(d);
    const double phi = motor.contact().half_angle, omega = 2 * std::numbers::pi * 40.8e3;
    CAPTURE(phi);
    const double s = 0.23 * d.layer.youngs_modulus * omega /
                     (shear_modulus(d) * d.stator.wavelengths / d.stator.contact_radius *
                      d.stator.neutral_plane_distance * omega);  // (C8.4) at W = omega
    const double crest = motor.crest_speed(), torque = largest_torque(d), inertia = 1e-2;
    const double plateau = inertia * crest * (1 - s * phi) / torque;
    const double rate = torque / (inertia * crest * s * phi);
    const auto integral = [](double x) {
      return -std::log(1 - x) / 3 + std::log(1 + x + x * x) / 6 +
             std::atan((2 * x + 1) / std::numbers::sqrt3) / std::numbers::sqrt3;
    };
    const double expected = plateau + (integral(0.5) - integral(0)) / rate;
    const double half = crest * (1 - s * phi / 2);

    MotionTask task = steady_drive(d, 1.2 * expected);
    task.output_times = times_to(task.duration, 20000);
    const Motion m = simulate(d, task);
    REQUIRE(m.status == "ok");
    const auto above =
        std::ranges::find_if(m.samples, [=](const auto& one) { return one.speed > half; });
    REQUIRE(above != m.samples.end());
    // The law is the limit of small phi: its error is phi^2 / 20. A sample is 6e-5 of the time.
    CHECK(above->time == Approx(expected).epsilon(phi * phi / 15 + 1.2 / 20000));
  }
}

TEST_CASE("mirrored inputs mirror the motion", "[motion][identity]") {
  const MotorDesign d = elastic_60(1e-4);
  MotionTask task = steady_drive(d, 0.02);
  task.load_torque = Profile({{0, 0.1}, {0.01, 0.3}});
  task.switched_off = {{0.015, 0.02}};
  MotionTask mirrored = task;
  mirrored.load_torque = Profile({{0, -0.1}, {0.01, -0.3}});
  mirrored.reversed = {{0, 0.02}};
  const Motion m = simulate(d, task), n = simulate(d, mirrored);
  CHECK(n.last.speed == -m.last.speed);
  CHECK(n.last.angle == -m.last.angle);
  CHECK(n.last.amplitude == m.last.amplitude);
  CHECK(n.last.held == m.last.held);
  REQUIRE(n.events.size() == m.events.size());
  for (std::size_t i = 0; i < n.events.size(); ++i) CHECK(n.events[i].time == m.events[i].time);
}

TEST_CASE("half the tolerance changes a motion by less than a millionth", "[motion][identity]") {
  const MotorDesign d = elastic_60(GENERATE(7e-6, 1e-4, 1e-3));
  MotionTask task = steady_drive(d, 0.03);
  task.load_torque = Profile({{0.01, 0}, {0.01, 0.2}});
  task.switched_off = {{0.02, 0.03}};
  const Motion coarse = simulate(d, task);
  task.tolerance /= 2;
  const Motion fine = simulate(d, task);
  CHECK(coarse.last.angle == Approx(fine.last.angle).epsilon(1e-6));
  CHECK(coarse.last.energy == Approx(fine.last.energy).epsilon(1e-6));
  REQUIRE(coarse.events.size() == fine.events.size());
  for (std::size_t i = 0; i < fine.events.size(); ++i) {
    // A torque is the slope of the integrator's polynomial, which is less accurate than its values.
    const double allowed = fine.events[i].kind == Event::overruns ? 1e-4 : 1e-6;
    // A margin for the first steps, which the absolute tolerance decides.
    CHECK(coarse.events[i].time == Approx(fine.events[i].time).epsilon(allowed).margin(1e-9));
  }
}

TEST_CASE("a motion scales with stresses and with time (C8.9, C8.10)", "[motion][scaling]") {
  const double c = 3;
  const MotorDesign d = elastic_60(1e-4);
  MotionTask task = steady_drive(d, 0.02);
  task.switched_off = {{0.008, 0.02}};
  const Motion m = simulate(d, task);
  REQUIRE(m.last.held);

  MotorDesign stiff = d;  // forces, masses and inertia c times as large
  stiff.layer.youngs_modulus *= c, stiff.preload *= c;
  *stiff.stator.modal_mass *= c, *stiff.stator.force_factor *= c, *stiff.rotor.inertia *= c;
  const Motion n = simulate(stiff, task);
  // Steps are chosen by the same relative errors: rounding alone differs, and what it changes of steps.
  CHECK(n.last.angle == Approx(m.last.angle).epsilon(1e-6));
  CHECK(n.last.energy == Approx(c * m.last.energy).epsilon(1e-6));

  MotorDesign fast = d;  // all c times as quick under the same forces
  fast.stator.frequency *= c, *fast.stator.resonance_frequency *= c;
  *fast.stator.modal_mass /= c * c, *fast.rotor.inertia /= c * c;
  MotionTask quick = steady_drive(fast, 0.02 / c);
  quick.switched_off = {{0.008 / c, 0.02 / c}};
  const Motion q = simulate(fast, quick);
  CHECK(q.last.angle == Approx(m.last.angle).epsilon(1e-6));
  CHECK(c * time_of(q, Event::held) == Approx(time_of(m, Event::held)).epsilon(1e-6));
}

TEST_CASE("a start of 30 ms takes at most 1,200 contacts", "[motion][cost]") {
  const MotorDesign d = elastic_60(GENERATE(7e-6, 1e-4, 1e-3));
  const Motion m = simulate(d, steady_drive(d, 0.03));
  CHECK(m.contacts <= 1200);
}

}  // namespace
