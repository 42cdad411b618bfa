// SPDX-License-Identifier: Apache-2.0
#include "core/curve_motors.hpp"
#include "support/expect_derivatives.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

// Maxima over speed (T7.16, T7.18) of motors whose curves have kinks, dips and several maxima, against scans.
namespace {

using namespace twum;
using namespace twum::test;

struct Best {
  double power{0}, efficiency{0}, torque{0};
};

Best best_of_scan(const Motor& motor, double free, int places) {
  Best best;
  for (int k = 1; k < places; ++k) {
    const OperatingPoint point = motor.operating_point(free * k / places);
    if (point.status != PointStatus::ok) continue;
    best.power = std::fmax(best.power, point.output_power);
    best.efficiency = std::fmax(best.efficiency, point.efficiency());
    best.torque = std::fmax(best.torque, point.torque);
  }
  return best;
}

// With mu_0 = mu powers are continuous: the speed of a maximum has its value, but for the root's own error at a kink:
// 1e-13 of V0 / r, times slopes of up to a thousand of the value.
void check_peaks(const MotorDesign& design, int places) {
  const Motor motor(design);
  // Asked together, as whoever designs a motor does, in the table's order.
  const std::vector<MetricRequest> requests{
      {Metric::no_load_speed},       {Metric::plateau_speed},  {Metric::peak_power},
      {Metric::speed_at_peak_power}, {Metric::max_efficiency}, {Metric::speed_at_max_efficiency}};
  const std::vector<MetricValue> found = evaluate(motor, requests);
  for (const MetricValue& each : found) REQUIRE(each.status == MetricStatus::ok);
  const double power = found[2].value, efficiency = found[4].value;
  const Best best = best_of_scan(motor, found[0].value, places);
  CAPTURE(power, best.power, efficiency, best.efficiency);
  CHECK(best.power > 0);
  CHECK(best.efficiency > 0);
  CHECK(power >= best.power * (1 - 1e-12));
  CHECK(efficiency >= best.efficiency * (1 - 1e-12));
  CHECK(motor.operating_point(found[3].value).output_power == Approx(power).epsilon(1e-10));
  CHECK(motor.operating_point(found[5].value).efficiency() == Approx(efficiency).epsilon(1e-10));
  CHECK(efficiency < 1);
}

// The largest value within 1e-9 of a speed; where it jumps there, beside the jump, found by halving to neighbouring
// numbers.
template <typename Value>
double supremum_near(double speed, Value value, int& jumps) {
  double better = speed * (1 - 1e-9), worse = speed * (1 + 1e-9);
  if (value(better) < value(worse)) std::swap(better, worse);
  double largest = std::fmax(value(better), value(speed));
  const double least = value(better) * (1 - 1e-4);
  if (value(worse) > least) return largest;
  ++jumps;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (better + worse), here = value(middle);
    (here > least ? better : worse) = middle;
    largest = std::fmax(largest, here);
  }
  return largest;
}

// Those of `wanted` among the motors that a seed gives.
template <typename Make>
std::vector<MotorDesign> motors_of(std::uint64_t seed, const std::set<int>& wanted, Make make) {
  Uniform random(seed);
  std::vector<MotorDesign> made;
  for (int i = 0; i <= *wanted.rbegin(); ++i) {
    const MotorDesign design = make(random, i);
    if (wanted.contains(i)) made.push_back(design);
  }
  return made;
}

MotorDesign any_box_motor(Uniform& random, int) { return box_motor(random); }

}  // namespace

TEST_CASE("power has no slope at the speed of a smooth peak (T7.16)", "[core][metrics][identity]") {
  Uniform random(31);
  int smooth = 0;
  for (int i = 0; i < 600; ++i) {
    const MotorDesign ring = realistic_design(random);
    const Motor motor(i % 3 == 0 ? ring : i % 3 == 1 ? damped(ring) : elastic(ring));
    const double speed = evaluate(motor, {Metric::speed_at_peak_power}).value;
    const SpeedDerivative here = differentiate_in_speed(motor, speed);
    const auto slope_at = [&](double share) {
      return differentiate_in_speed(motor, speed * share).output_power;
    };
    const double curvature = (slope_at(1 + 1e-6) - slope_at(1 - 1e-6)) / (2e-6 * speed);
    // A kink has slopes of either sign beside it, which no curvature explains.
    const double scale = here.point.output_power / (speed * speed);
    if (!(std::fabs(curvature) < 1e3 * scale)) continue;
    ++smooth;
    CAPTURE(i, speed, here.output_power, curvature);
    // The speed is asked for to 1e-13 of the crest speed; the slope itself is rounded to some 1e-14 of P / Omega.
    CHECK(std::fabs(here.output_power) <=
          1e-13 * motor.crest_speed() * std::fabs(curvature) + 1e-13 * scale * speed);
  }
  CHECK(smooth > 500);
}

TEST_CASE("the peaks of layers that ring on are those of a fine scan (T7.16, T7.18)",
          "[core][metrics][brute_force]") {
  // Maxima at a kink where the plateau ends, though a speed far from it is the best of few; maxima with a dip
  // behind them; maxima on either side of the best of few; layers that slip all through at nearly every speed.
  for (const MotorDesign& design : motors_of(5, {6, 109, 295}, ringing_motor))
    check_peaks(design, 2000);
  for (const MotorDesign& design : motors_of(11, {5, 7, 8, 15}, ringing_motor))
    check_peaks(design, 2000);
  // And one with two maxima of power of nearly the same height, of which the best of few speeds is beside the lower.
  for (const MotorDesign& design : motors_of(5, {125}, any_box_motor)) check_peaks(design, 2000);
  // And some of 12,600 whose highest maximum is neither beside the best of few speeds nor at the plateau's end, or
  // has a dip behind it.
  for (const auto& [seed, one] : {std::pair{11, 407}, {51, 614}, {41, 449}})
    for (const MotorDesign& design :
         motors_of(static_cast<std::uint64_t>(seed), {one}, any_box_motor))
      check_peaks(design, 2000);
}

TEST_CASE("the peaks of any layer that rings on are at least those of a scan (T7.16, T7.18)",
          "[core][metrics][brute_force]") {
  Uniform random(5);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    check_peaks(ringing_motor(random, i), 400);
  }
}

TEST_CASE("ripples of an undamped layer hide no peak (T7.16, T7.18)",
          "[core][metrics][brute_force]") {
  // The layer turns 3 to 60 times through its own oscillation within the contact, and as often power and efficiency
  // ripple over speed: at the twenty speeds where all layers are looked at first they may be far off their best. Beside
  // one of the maxima a speed does not converge.
  Uniform random(8);
  int asked = 0, rippled = 0;
  for (int i = 0; i < 48; ++i) {
    MotorDesign design = ring_motor();
    design.layer.loss_factor = 0;
    design.stator.modal_damping = 45;
    const double turns = random.logarithmic(3, 60);
    const double omega = 2 * std::numbers::pi * design.stator.frequency;
    const double length = 2 * Motor(design).contact().half_angle / (2 * std::numbers::pi);
    design.layer.given_inertia = shear_modulus(design) * std::pow(length / (turns * omega), 2);
    CAPTURE(i, turns);
    const Motor motor(design);
    const double free = evaluate(motor, MetricRequest{Metric::no_load_speed}).value;
    if (!(free > 0)) continue;  // one of the speeds on the way to it is not converged
    ++asked;
    check_peaks(design, 1500);
    const double peak = evaluate(motor, MetricRequest{Metric::peak_power}).value;
    double coarse = 0;
    for (int k = 1; k < 20; ++k)
      coarse = std::fmax(coarse, motor.operating_point(free * k / 20).output_power);
    rippled += coarse < 0.99 * peak;
  }
  CHECK(asked > 40);
  CHECK(rippled > 5);
}

TEST_CASE("the peaks of realistic motors are those of a fine scan (T7.16, T7.18)",
          "[core][metrics][brute_force]") {
  for (const std::uint64_t seed : {3U, 7U, 11U}) {
    Uniform random(seed);
    for (int i = 0; i < 60; ++i) {
      const MotorDesign design = holding_motor(random, i);
      CAPTURE(seed, i);
      if (i % 2 == 1) check_peaks(design, 600);
    }
  }
}

TEST_CASE("no jump of a torque that holds more than it slides hides a peak (T7.13, T7.16, T7.18)",
          "[core][metrics][brute_force]") {
  // Torque jumps up and falls again, within one and the same sequence of zones, between two of them, or at the birth
  // of a zone; or it has a smooth maximum before one that rises at the very end, where a zone dies.
  int jumps = 0;
  for (const auto& [seed, wanted] :
       {std::pair<std::uint64_t, std::set<int>>{1, {73, 126, 131, 501}},
        {2, {27, 32, 429, 464, 495}}}) {
    for (MotorDesign design : motors_of(seed, wanted, holding_motor)) {
      design.friction.threshold = 1.3 * design.friction.kinetic;
      const Motor motor(design);
      const auto value = [&motor](Metric metric) {
        const MetricValue found = evaluate(motor, MetricRequest{metric});
        REQUIRE(found.status == MetricStatus::ok);
        return found.value;
      };
      const double free = value(Metric::no_load_speed);
      const Best best = best_of_scan(motor, free, 3000);
      const double power = value(Metric::peak_power), efficiency = value(Metric::max_efficiency),
                   torque = value(Metric::max_torque);
      CAPTURE(seed, power, best.power, efficiency, best.efficiency, torque, best.torque);
      CHECK(power >= best.power * (1 - 1e-12));
      CHECK(efficiency >= best.efficiency * (1 - 1e-12));
      CHECK(torque >= best.torque * (1 - 1e-12));
      const double speeds[] = {value(Metric::speed_at_peak_power),
                               value(Metric::speed_at_max_efficiency)};
      CHECK(supremum_near(
                speeds[0], [&](double speed) { return motor.operating_point(speed).output_power; },
                jumps) == Approx(power).epsilon(1e-13));
      CHECK(supremum_near(
                speeds[1], [&](double speed) { return motor.operating_point(speed).efficiency(); },
                jumps) == Approx(efficiency).epsilon(1e-13));
    }
  }
  CHECK(jumps >= 6);
}

TEST_CASE(
    "a motor that runs free below a twentieth of the crest speed has its peaks there "
    "(C8.6, T7.16, T7.18)",
    "[core][metrics][closed_form]") {
  // A contact nearly round the wave that sticks all through: it runs free at V0 / r times sin phi / phi. Its stator
  // loses little.
  for (const double phi : {2.98, 2.985, 2.99, 3.00, 3.03, 3.06, 3.09}) {
    for (const double ratio : {1.0, 1.2}) {
      MotorDesign design = elastic_ring(phi, 10 * (1 / phi - 1 / std::tan(phi)));
      design.friction.threshold = ratio * design.friction.kinetic;
      design.stator.modal_damping = 0.4;
      const Motor motor(design);
      CAPTURE(phi, ratio);
      const double free = std::sin(phi) / phi * motor.crest_speed();
      // 1 / phi - cot phi times sin phi / phi: rounding of the preload is amplified by 1 / sin phi, a hundred at most.
      CHECK(ask(motor, Metric::no_load_speed).value == Approx(free).epsilon(1e-10));
      const Best best = best_of_scan(motor, free, 2000);
      const double power = ask(motor, Metric::peak_power).value,
                   efficiency = ask(motor, Metric::max_efficiency).value;
      // A scan of 2,000 speeds misses a kink by up to a step's worth, some 1e-3.
      CHECK(power >= best.power * (1 - 1e-12));
      CHECK(power <= best.power * (1 + 2e-3));
      CHECK(efficiency >= best.efficiency * (1 - 1e-12));
      CHECK(efficiency <= best.efficiency * (1 + 2e-3));
    }
  }
}

TEST_CASE("a peak of power at the plateau's end moves as mu F_N r times that end (T7.16, T7.17)",
          "[core][metrics][identity]") {
  for (const MotorDesign& design : motors_of(11, {5, 8}, ringing_motor)) {
    const Motor motor(design);
    const MetricDerivative power = differentiated(motor, {Metric::peak_power}),
                           end = differentiated(motor, {Metric::plateau_speed}),
                           stall = differentiated(motor, {Metric::stall_torque});
    REQUIRE(ask(motor, Metric::speed_at_peak_power).value == end.value.value);
    CHECK(power.value.value == Approx(stall.value.value * end.value.value).epsilon(1e-12));
    CHECK(power.smoothness == Smoothness::one_sided);
    for (const ParameterInfo& row : parameter_table()) {
      if (!in_use(design, row.parameter)) continue;
      const std::size_t j = index_of(row.parameter);
      const double expected =
          stall.gradient[j] * end.value.value + stall.value.value * end.gradient[j];
      const double x = get(design, row.parameter);
      CAPTURE(row.name, expected);
      // The product rule; rounding of terms that may cancel, in units of the value by the parameter.
      CHECK(std::abs(power.gradient[j] - expected) * x <=
            1e-10 * (power.value.value + std::abs(expected) * x));
    }
  }
}

TEST_CASE("an efficiency with its maximum at the plateau's end moves as differences say (T7.18)",
          "[core][metrics][differential]") {
  int compared = 0;
  for (const MotorDesign& design : motors_of(11, {5, 8}, ringing_motor)) {
    const Motor motor(design);
    REQUIRE(ask(motor, Metric::speed_at_max_efficiency).value ==
            ask(motor, Metric::plateau_speed).value);
    const MetricDerivative exact = differentiated(motor, {Metric::max_efficiency});
    CHECK(exact.smoothness == Smoothness::one_sided);
    for (const Parameter p : {Parameter::preload, Parameter::amplitude, Parameter::kinetic_friction,
                              Parameter::modal_damping, Parameter::inertia}) {
      const double x = get(design, p), unit = exact.value.value / x;
      const Functions best = [&](double at) {
        return std::vector<double>{ask(Motor(with(design, p, at)), Metric::max_efficiency).value};
      };
      // The maximum stays at the kink, along which it is smooth. On which side of it its rounded speed lies decides
      // on a zone as long as the root of eps, 1.5e-8, at entry or exit; slopes take some tens of that along.
      const DifferenceQuotient found = central_differences(best, x, x)[0];
      if (!(found.error <= 1e-7 * unit)) continue;
      CAPTURE(info(p).name, found.value / unit, found.error / unit);
      ++compared;
      CHECK(std::abs(exact.gradient[index_of(p)] - found.value) <= 1e-6 * unit + 3 * found.error);
    }
  }
  CHECK(compared >= 6);
}

TEST_CASE("a maximum that is no kink is not called one (T7.16)", "[core][metrics][differential]") {
  // A motor without a plateau, and ringing motors with their peak of power elsewhere than the plateau's end.
  std::vector<MotorDesign> designs = motors_of(11, {7, 15}, ringing_motor);
  designs.push_back(motors_of(11, {32}, any_box_motor).front());
  for (const MotorDesign& design : designs) {
    const Motor motor(design);
    const double speed = ask(motor, Metric::speed_at_peak_power).value;
    // Power is a parabola there: over twice the distance it falls four times as far. A kink would make it twice.
    // Over 1e-5 it falls by some 1e-10 of it, a hundred times what rounding leaves.
    const auto fall = [&](double share) {
      const auto power = [&](double at) { return motor.operating_point(at).output_power; };
      return 2 * power(speed) - power(speed * (1 + share)) - power(speed * (1 - share));
    };
    CHECK(fall(2e-5) / fall(1e-5) == Approx(4).epsilon(0.1));
    CHECK(differentiated(motor, {Metric::peak_power}).smoothness == Smoothness::smooth);
  }
}

TEST_CASE("metrics of motors on their plateau asked together are those asked alone",
          "[core][metrics][identity]") {
  std::vector<MotorDesign> designs = motors_of(5, {6, 109}, ringing_motor);
  for (const MotorDesign& design : motors_of(7, {15, 32, 33}, holding_motor))
    designs.push_back(design);
  for (const MotorDesign& design : designs) {
    const Motor motor(design);
    std::vector<MetricRequest> requests;
    for (const MetricInfo& row : metric_table())
      if (row.argument == Argument::none) requests.push_back({row.metric});
    const double stall = evaluate(motor, {Metric::stall_torque}).value;
    for (const double share : {0.1, 0.65, 0.75, 0.99, 1.01})
      requests.push_back({Metric::speed_at, Argument::torque, share * stall});
    const std::vector<MetricValue> together = evaluate(motor, requests);
    for (std::size_t k = 0; k < requests.size(); ++k) {
      const MetricValue alone = evaluate(Motor(design), requests[k]);
      CAPTURE(info(requests[k].metric).name);
      CHECK(together[k].status == alone.status);
      if (alone.status == MetricStatus::ok) CHECK(together[k].value == alone.value);
    }
  }
}
