// SPDX-License-Identifier: Apache-2.0
// Metrics of standard manoeuvres: against another program's numbers, whole motions, and differences of them.
#include "motion/motion_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;
using M = Metric;
using P = Parameter;

MetricRequest under(Metric metric, double torque) { return {metric, Argument::torque, torque}; }

MetricValue ask(const MotorDesign& design, const MetricRequest& request) {
  return evaluate(Motor(design), request);
}

double value(const MotorDesign& design, const MetricRequest& request) {
  const MetricValue found = ask(design, request);
  CAPTURE(info(request.metric).name);
  CHECK(std::string(to_string(found.status)) == "ok");
  return found.value;
}

// With everything that the equations take of a design.
MotorDesign full_motor() {
  MotorDesign d = elastic_60(2e-5);
  d.stator.loss_tangent = 0.01;
  d.layer.loss_factor = 0.05, d.layer.density = 1500;
  d.layer.given_inertia.reset(), d.layer.given_shear_viscosity.reset();
  d.load = ShaftLoad{.inertia = 1e-4, .damping = 2e-3, .friction = 0.03};
  d.driver = Driver{300};
  return d;
}

TEST_CASE("a rotor hops where another program says so (M4.5, C21.7)",
          "[motion][manoeuvres][reference]") {
  // An averaged program, and a direct integration, whose rates differ by 2 to 8 %.
  struct Hop {
    double inertia, mass, averaged, direct;
  };
  for (const Hop& hop :
       {Hop{7e-6, 0.1, 763, 744}, Hop{1e-4, 0.1, 1346, 1270}, Hop{1e-4, 0.3, 1518, 1482}}) {
    MotorDesign d = elastic_60(hop.inertia);
    d.rotor.mass = hop.mass;
    const double rate = value(d, under(M::bounce_rate_at, 0));
    CHECK(rate == Approx(hop.averaged).epsilon(5e-4));  // printed to four digits
    CHECK(rate == Approx(hop.direct).epsilon(0.08));
  }
}

// Whether something that a motion leaves out has grown in 20 ms of a start.
bool has_grown(const MotorDesign& d, MotionEventKind kind, std::vector<Interval> reversed = {}) {
  MotionTask task = steady_drive(d, 0.02);
  task.output_times = times_to(0.02, 2000);
  task.reversed = std::move(reversed);
  Motion motion = simulate(d, task);
  REQUIRE(motion.status == "ok");
  add_what_is_left_out(d, task, motion);
  CHECK(std::ranges::is_sorted(motion.events, {}, &MotionEvent::time));
  return std::ranges::count(motion.events, kind, &MotionEvent::kind) > 0;
}

TEST_CASE("a motion tells where what it leaves out has grown", "[motion][manoeuvres][reference]") {
  const auto motor = [](double inertia, double damping) {
    MotorDesign d = elastic_60(inertia);
    d.rotor.mass = 0.1, d.rotor.axial_damping = damping;
    return d;
  };
  // motion.md: a load of 1e-3 kg m^2 passes the squealing speeds slowly, G = 18; the bare rotor in 0.1 ms, G = 0.2.
  CHECK(has_grown(motor(1e-3, 300), MotionEventKind::squeals));
  CHECK_FALSE(has_grown(motor(7e-6, 300), MotionEventKind::squeals));
  // Near no-load an undamped rotor hops at a rate of 1,346 1/s; 270 N s/m are enough against it.
  CHECK(has_grown(motor(1e-4, 0), MotionEventKind::bounces));
  CHECK_FALSE(has_grown(motor(1e-4, 300), MotionEventKind::bounces));
  // Backward likewise.
  CHECK(has_grown(motor(1e-4, 0), MotionEventKind::bounces, {{0, 0.02}}));
  MotorDesign light = motor(1e-3, 0);
  light.rotor.mass.reset();
  CHECK_FALSE(has_grown(light, MotionEventKind::bounces));
}

TEST_CASE("a motion tells where it is too fast for a periodic contact (M7.1)",
          "[motion][manoeuvres]") {
  // d_s / 2 m_s is the rate of the wave: 800 / s with a quality factor of 153, and 12,250 / s with 10. W / 30 is 8,545 / s at rest.
  for (const auto& [quality, inertia, fast] :
       {std::tuple{153.0, 1e-4, false}, {153.0, 7e-6, false}, {10.0, 1e-6, true}}) {
    CAPTURE(quality, inertia);
    MotorDesign d = elastic_60(inertia, quality < 100 ? 800 : 140);
    d.stator.quality_factor = quality;
    CHECK(has_grown(d, MotionEventKind::too_fast) == fast);
  }
}

TEST_CASE("rates and gains are those of the linear plant", "[motion][manoeuvres]") {
  // Poles -1,760 +- 3,753 i and -382: motion.md's program.
  CHECK(value(elastic_60(1e-4), under(M::settling_rate_at, 0)) == Approx(1760).epsilon(5e-4));
  CHECK(value(elastic_60(1e-3), under(M::settling_rate_at, 0)) == Approx(382).epsilon(2e-3));
  const MotorDesign d = elastic_60(1e-4);
  // A gain is the slope of the steady speed, which the branch engine knows.
  const double df = 0.5, dv = 5e-3;
  const auto speed = [](const MotorDesign& of) { return value(of, under(M::speed_at, 0.2)); };
  CHECK(value(d, under(M::speed_per_frequency_at, 0.2)) ==
        Approx((speed(with(d, P::frequency, 40.8e3 + df)) -
                speed(with(d, P::frequency, 40.8e3 - df))) /
               (2 * df))
            .epsilon(1e-6));
  CHECK(value(d, under(M::speed_per_voltage_at, 0.2)) ==
        Approx((speed(with(d, P::voltage, 140 + dv)) - speed(with(d, P::voltage, 140 - dv))) /
               (2 * dv))
            .epsilon(1e-6));
}

TEST_CASE("times and angles are those of whole motions", "[motion][manoeuvres]") {
  const MotorDesign d = full_motor();
  const double torque = 0.15;
  const double t90 = value(d, under(M::start_time_at, torque));
  MotionTask task = steady_drive(d, 0.2);
  task.load_torque = torque;
  task.output_times = {t90, 0.2};
  const Motion start = simulate(d, task);
  REQUIRE(start.status == "ok");
  // The steady state of 0.2 s is that of the metric, friction and damping of the load included.
  CHECK(start.samples[0].speed == Approx(0.9 * start.last.speed).epsilon(1e-5));

  task.initial.steady = true;
  task.switched_off = {{0, 0.2}};
  const Motion stop = simulate(d, task);
  REQUIRE(stop.last.held);
  CHECK(value(d, under(M::stop_angle_at, torque)) == Approx(stop.last.angle).epsilon(1e-6));
  const auto held = std::ranges::find(stop.events, MotionEventKind::held, &MotionEvent::kind);
  REQUIRE(held != stop.events.end());
  CHECK(value(d, under(M::stop_time_at, torque)) == Approx(held->time).epsilon(1e-5));

  // The peak of a light rotor's speed, of samples 0.1 us apart: they miss it by the square of that.
  const MotorDesign light = elastic_60(7e-6);
  MotionTask quick = steady_drive(light, 2e-3);
  quick.output_times = times_to(2e-3, 20000);
  double fastest = 0;
  for (const MotionSample& s : simulate(light, quick).samples) fastest = std::max(fastest, s.speed);
  const double steady = value(light, under(M::speed_at, 0));
  CHECK(value(light, under(M::start_overshoot_at, 0)) ==
        Approx(fastest / steady - 1).epsilon(1e-4));
  // Between samples, too: a motion without any knows the peak.
  quick.output_times.clear();
  CHECK(simulate(light, quick).fastest == Approx(fastest).epsilon(1e-7));
  CHECK(value(elastic_60(1e-2), under(M::start_overshoot_at, 0)) == 0);
  CHECK(differentiate(Motor(elastic_60(1e-2)), under(M::start_overshoot_at, 0)).smoothness ==
        Smoothness::flat);
}

TEST_CASE("a longer move costs the power of the steady run", "[motion][manoeuvres]") {
  const MotorDesign d = elastic_60(1e-4);
  const auto energy = [&](double angle) {
    return value(d, {M::move_energy, Argument::angle, angle});
  };
  const double power = value(d, under(M::electrical_power_at, 0)),
               speed = value(d, under(M::speed_at, 0));
  // Start and stop are the same; the integration of each is good to 1e-6 of the whole.
  CHECK(energy(3) - energy(2) == Approx(power / speed).epsilon(1e-4));
}

TEST_CASE("the dynamic start voltage is where another program has it",
          "[motion][manoeuvres][reference]") {
  const auto voltage = [](double inertia) {
    return value(elastic_60(inertia), {M::dynamic_start_voltage});
  };
  CHECK(voltage(7e-6) == Approx(102.15).epsilon(1e-3));  // 2 omega as the divisor there
  CHECK(voltage(1e-4) == Approx(110.58).epsilon(1e-3));
  CHECK(voltage(1e-2) == Approx(111.85).epsilon(2e-3));  // the direct integration
}

TEST_CASE("a motor without a manoeuvre says why", "[motion][manoeuvres]") {
  const auto status = [](const MotorDesign& d, const MetricRequest& request) {
    return std::string(to_string(ask(d, request).status));
  };
  const MotorDesign d = elastic_60(1e-4);
  // Straight to a low frequency it stays on the dead wave (motion.md, section 5).
  CHECK(status(elastic_60(1e-4, 120, 40.4e3), under(M::start_time_at, 0)) == "does-not-start");
  // More than the holding torque of 1.036 N m pulls at the shaft.
  CHECK(status(d, under(M::stop_time_at, -1.2)) == "does-not-stop");
  CHECK(status(d, under(M::start_time_at, 5)) == "unreachable");
  CHECK(status(d, under(M::bounce_rate_at, 0)) == "undefined");
  CHECK(status(d, {M::move_energy, Argument::angle, 0}) == "undefined");
  CHECK(status(d, {M::burst_angle, Argument::periods, 0.5}) == "undefined");
  // Less than the holding torque is enough if the rotor keeps the wave going that takes friction away.
  CHECK(status(d, under(M::stop_time_at, -0.5)) == "does-not-stop");
  MotorDesign free = d;
  free.preload = 0;
  for (const Metric metric : {M::start_time_at, M::stop_time_at, M::settling_rate_at})
    CHECK(status(free, under(metric, 0)) == "undefined");
  MotorDesign still = d;
  still.rotor.inertia.reset();
  for (const MetricInfo& row : metric_table())
    if (row.needs_motion) CHECK(status(still, {row.metric, row.argument, 1}) == "undefined");
  MotorDesign given = d;
  given.stator.voltage.reset(), given.stator.amplitude = 1e-6;
  CHECK(status(given, under(M::start_time_at, 0)) == "ok");
  CHECK(status(given, under(M::stop_time_at, 0)) == "undefined");
}

// Differences of whole motions, of fourth order. Steps of 0.3 %: the motions' errors of 1e-6 then leave some 3e-4. The resonance is
// narrower than that.
double difference(const MotorDesign& d, const MetricRequest& request, Parameter parameter) {
  const bool narrow = parameter == P::frequency || parameter == P::resonance_frequency;
  const double q = get(d, parameter), h = (narrow ? 2e-4 : 3e-3) * q;
  const auto at = [&](double by) { return ask(with(d, parameter, q + by), request).value; };
  return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
}

TEST_CASE("derivatives of manoeuvres are those of whole motions (M10.1)", "[motion][manoeuvres]") {
  const MotorDesign d = full_motor();
  const MetricRequest asked[] = {under(M::start_time_at, 0.1),
                                 under(M::stop_time_at, 0.1),
                                 under(M::stop_angle_at, 0.1),
                                 {M::burst_angle, Argument::periods, 48}};
  const std::vector<MetricDerivative> found = differentiate(Motor(d), asked);
  for (const ParameterInfo& row : parameter_table()) {
    const bool compared = !row.integer && in_use(d, row.parameter) && get(d, row.parameter) != 0 &&
                          row.parameter != P::static_friction;  // none from below mu
    if (!compared) continue;
    for (std::size_t i = 0; i < std::size(asked); ++i) {
      CAPTURE(row.name, info(asked[i].metric).name);
      REQUIRE(found[i].smoothness == Smoothness::smooth);
      const double slope = difference(d, asked[i], row.parameter);
      // Resonance and drive move times by a hundred times their relative change: the largest share of the error of a step.
      const double size = found[i].value.value / get(d, row.parameter);
      CHECK(found[i].gradient[index_of(row.parameter)] ==
            Approx(slope).epsilon(1e-3).margin(1e-3 * std::fabs(size)));
    }
  }
}

TEST_CASE("derivatives of a stop are those of another program (M10.1)",
          "[motion][manoeuvres][reference]") {
  const MotorDesign d = elastic_60(1e-4, 135);
  const auto slope = [&](Metric metric) {
    return differentiate(Motor(d), under(metric, 0)).gradient[index_of(P::voltage)];
  };
  CHECK(slope(M::stop_angle_at) == Approx(0.22523e-3).epsilon(1e-4));
  CHECK(slope(M::stop_time_at) == Approx(13.96e-6).epsilon(8e-4));
}

TEST_CASE("derivatives may be asked in some parameters only", "[motion][manoeuvres]") {
  const MotorDesign d = elastic_60(1e-4);
  const MetricRequest request = under(M::start_time_at, 0.2);
  const std::vector<P> wanted{P::preload, P::kinetic_friction, P::youngs_modulus, P::voltage,
                              P::rotor_inertia};
  const auto all = motion_metrics(d)->differentiate(request, false);
  const auto some = motion_metrics(d, wanted)->differentiate(request, false);
  REQUIRE(all.value.status == MetricStatus::ok);
  CHECK(some.value.value == all.value.value);
  for (std::size_t i = 0; i < kParameterCount; ++i) {
    CAPTURE(info(static_cast<P>(i)).name);
    const bool asked = std::ranges::find(wanted, static_cast<P>(i)) != wanted.end();
    // Other steps, with sensitivities right to 1e-5 of their scale (M10.1).
    if (asked) CHECK(some.gradient[i] == Approx(all.gradient[i]).epsilon(1e-4));
    if (!asked) CHECK(std::isnan(some.gradient[i]));
  }
}

TEST_CASE("other manoeuvres have derivatives, too", "[motion][manoeuvres]") {
  MotorDesign d = elastic_60(7e-6);
  d.rotor.mass = 0.1;
  for (const MetricRequest& request :
       {under(M::start_overshoot_at, 0), under(M::settling_rate_at, 0), under(M::bounce_rate_at, 0),
        under(M::speed_per_frequency_at, 0), MetricRequest{M::move_energy, Argument::angle, 0.5}}) {
    CAPTURE(info(request.metric).name);
    const MetricDerivative found = differentiate(Motor(d), request);
    REQUIRE(found.smoothness == Smoothness::smooth);
    CHECK(found.value.value == value(d, request));
    for (const P parameter : {P::voltage, P::preload, P::rotor_inertia, P::quality_factor}) {
      CAPTURE(info(parameter).name);
      const double size = std::fabs(found.value.value / get(d, parameter));
      CHECK(found.gradient[index_of(parameter)] ==
            Approx(difference(d, request, parameter)).epsilon(2e-3).margin(2e-3 * size));
    }
  }
  CHECK(differentiate(Motor(d), {M::dynamic_start_voltage}).smoothness == Smoothness::undefined);
}

}  // namespace
