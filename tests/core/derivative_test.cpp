// SPDX-License-Identifier: Apache-2.0
#include "support/deviations.hpp"
#include "support/expect_derivatives.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/metrics.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

// Every metric of the table against every parameter of the table: a new row of either is tested
// without anyone remembering.
namespace {

using namespace twum;
using namespace twum::test;

// Each metric at each kind of argument it takes, at points of ordinary use.
std::vector<MetricRequest> all_requests(const Motor& motor) {
  const double load = 0.4 * evaluate(motor, {Metric::stall_torque}).value;
  std::vector<MetricRequest> requests;
  for (const MetricInfo& row : metric_table()) {
    const bool either = row.argument == Argument::speed_or_torque;
    if (row.argument == Argument::none) requests.push_back({row.metric, Argument::none, 0});
    if (row.argument == Argument::speed || either) {
      requests.push_back({row.metric, Argument::speed, 0.8 * motor.crest_speed()});
    }
    if (row.argument == Argument::torque || either)
      requests.push_back({row.metric, Argument::torque, load});
  }
  return requests;
}

std::vector<double> values_at(const MotorDesign& design, Parameter parameter, double x,
                              const std::vector<MetricRequest>& requests) {
  std::vector<double> values;
  for (const MetricValue& value : evaluate(Motor(with(design, parameter, x)), requests))
    values.push_back(value.value);
  return values;
}

// Parameters that can be moved to both sides: not whole numbers, not at the border of their range.
bool movable(const MotorDesign& design, const ParameterInfo& row) {
  if (row.integer || !in_use(design, row.parameter) || get(design, row.parameter) == 0)
    return false;
  return row.parameter != Parameter::static_friction ||
         design.friction.static_ > 1.05 * design.friction.kinetic;
}

// mu_0 moves with mu, which with() sees to; on its own it is a parameter like any other.
MotorDesign design_of(Uniform& random, int index) {
  MotorDesign design = realistic_design(random);
  design.stator.modal_damping = random(20, 80);
  const bool threshold = index % 3 == 2;
  design.friction.static_ = design.friction.kinetic * (threshold ? 1.2 : 1.0);
  if (index % 4 == 1) design = damped(design);
  if (index % 4 == 2) design = elastic(design);
  if (index % 4 == 3) {  // constants given outright are parameters in use instead of their twins
    design.layer.given_shear_modulus = 0.9 * shear_modulus(design);
    design.layer.given_shear_viscosity = shear_viscosity(design);
    design.layer.given_inertia = inertia(design);
  }
  return design;
}

// Few slices, so that the zones of each show in the differences; nothing about the track is left at zero.
MotorDesign annulus_of(Uniform& random, int index) {
  MotorDesign design = design_of(random, index);
  const Stator& stator = design.stator;
  const double inner = stator.contact_radius - 0.5 * stator.contact_width;
  design.stator.radial_slices = 3 + index % 3;
  design.stator.radial_shape = {random(-1, 3), random(0.2, 0.8) * inner, {}};
  design.rotor.taper = random(-2, 2) * stator.amplitude / stator.contact_width;
  return design;
}

struct Tally {
  std::map<std::string, int> sharp;  // metric name -> comparisons at full sharpness
  int blunt{0};                      // differences too noisy or across a kink
  int again{0};                      // right by differences with other steps only
  int wrong{0};
  std::vector<std::string> examples;

  int total_sharp() const {
    int total = 0;
    for (const auto& [name, count] : sharp) total += count;
    return total;
  }
};

// Does an exact derivative agree with the differences? `unit` is |f / x|, what a relative change means.
bool agrees(double exact, const DifferenceQuotient& found, double unit) {
  return std::abs(exact - found.value) <=
         1e-7 * std::max(std::abs(found.value), unit) + 3 * found.error;
}

bool agrees_on_a_side(const MotorDesign& design, const ParameterInfo& row,
                      const MetricRequest& request, double exact, double unit) {
  const double x = get(design, row.parameter);
  const Functions one = [&](double at) { return values_at(design, row.parameter, at, {request}); };
  for (const int side : {-1, 1}) {
    if (agrees(exact, one_sided_differences(one, x, std::abs(x), side)[0], 10 * unit)) return true;
  }
  return false;
}

// What a metric is measured in where it is nearly zero. The ends of zones leave 1e-10 of the scale of powers
// (as in broken_law()), which is 1e-7 of a thousandth of it.
double least_size(const Motor& motor, Metric metric) {
  const double power = 1e-3 * power_scale(motor, 0);
  const Stator& stator = motor.design().stator;
  switch (metric) {
    case Metric::output_power_at:
    case Metric::stator_power_at:
    case Metric::friction_power_at:
    case Metric::layer_loss_at: return power;
    case Metric::wear_intensity_at:
      return power / (2 * std::numbers::pi * stator.contact_radius * stator.contact_width);
    default: return 0;
  }
}

void check_parameter(const MotorDesign& design, const ParameterInfo& row,
                     const std::vector<MetricRequest>& requests,
                     const std::vector<MetricDerivative>& exact, Tally& tally,
                     Deviation& deviation) {
  const double x = get(design, row.parameter);
  const Functions all = [&](double at) { return values_at(design, row.parameter, at, requests); };
  const auto differences = central_differences(all, x, std::abs(x));
  for (std::size_t k = 0; k < requests.size(); ++k) {
    if (exact[k].value.status != MetricStatus::ok || exact[k].smoothness == Smoothness::undefined)
      continue;
    const double unit =
        std::max(std::abs(exact[k].value.value), least_size(Motor(design), requests[k].metric)) /
        std::abs(x);
    const double gradient = exact[k].gradient[index_of(row.parameter)];
    const bool sharp =
        differences[k].error <= 1e-8 * std::max(unit, std::abs(differences[k].value));
    if (!sharp) {
      ++tally.blunt;
      continue;
    }
    const std::string name(info(requests[k].metric).name);
    ++tally.sharp[name];
    bool good = agrees(gradient, differences[k], unit);
    if (good)
      deviation.add(gradient, differences[k].value,
                    std::max({unit, std::abs(differences[k].value), 1e-300}));
    // Values at a load carry the error of its speed, and the scheme's idea of its own may by chance be too small:
    // seldom so with other steps again.
    if (!good) {
      good = agrees(gradient, central_differences(all, x, 0.37 * std::abs(x))[k], unit);
      tally.again += good;
    }
    if (!good && exact[k].smoothness == Smoothness::one_sided) {
      good = agrees_on_a_side(design, row, requests[k], gradient, unit);
    }
    if (good) continue;
    ++tally.wrong;
    if (tally.examples.size() < 12) {
      tally.examples.push_back(
          name + " by " + std::string(row.name) + " (" + to_string(exact[k].smoothness) +
          "): " + std::to_string(gradient * x) + " instead of " +
          std::to_string(differences[k].value * x) + " per unit of relative change");
    }
  }
}

// Exact derivatives of all requests by all parameters that can be moved.
void check_gradients(const MotorDesign& design, const std::vector<MetricRequest>& requests,
                     Tally& tally, Deviation& deviation) {
  const auto exact = differentiate(Motor(design), requests);
  for (const ParameterInfo& row : parameter_table()) {
    if (movable(design, row)) check_parameter(design, row, requests, exact, tally, deviation);
  }
}

template <typename DesignOf>
Tally check_designs(std::uint64_t seed, int count, DesignOf design_of) {
  Tally tally;
  Deviation deviation("metric derivatives against Richardson differences, relative", 1e-7);
  Uniform random(seed);
  for (int i = 0; i < count; ++i) {
    const MotorDesign design = design_of(random, i);
    check_gradients(design, all_requests(Motor(design)), tally, deviation);
  }
  return tally;
}

}  // namespace

TEST_CASE("differences with extrapolation find known derivatives", "[core][derivative][oracle]") {
  const Functions functions = [](double x) {
    return std::vector<double>{std::sin(3 * x) * std::exp(x), x < 1 ? x * x : 3 * x - 2};
  };
  const auto smooth = central_differences(functions, 0.7, 0.7)[0];
  const double exact = std::exp(0.7) * (std::sin(2.1) + 3 * std::cos(2.1));
  CHECK(std::abs(smooth.value - exact) <= 1e-10 * std::abs(exact));
  CHECK(std::abs(smooth.value - exact) <= 10 * smooth.error + 1e-11);
  // a kink has two one-sided derivatives, and shows in the error of the central one
  CHECK(one_sided_differences(functions, 1, 1, -1)[1].value == Approx(2).epsilon(1e-8));
  CHECK(one_sided_differences(functions, 1, 1, 1)[1].value == Approx(3).epsilon(1e-8));
}

TEST_CASE("values beside derivatives are the values to the bit", "[core][derivative][identity]") {
  Uniform random(9);
  for (int i = 0; i < 40; ++i) {
    const Motor motor(design_of(random, i));
    const auto requests = all_requests(motor);
    const auto plain = evaluate(motor, requests);
    const auto derived = differentiate(motor, requests);
    REQUIRE(derived.size() == plain.size());
    for (std::size_t k = 0; k < plain.size(); ++k) {
      CAPTURE(i, info(requests[k].metric).name);
      CHECK(derived[k].value.status == plain[k].status);
      const bool both_nan = std::isnan(derived[k].value.value) && std::isnan(plain[k].value);
      CHECK((both_nan || derived[k].value.value == plain[k].value));
    }
  }
}

namespace {

std::size_t metrics_without_modes() {
  return static_cast<std::size_t>(
      std::count_if(metric_table().begin(), metric_table().end(),
                    [](const MetricInfo& row) { return !row.needs_modes && !row.needs_geometry; }));
}

// No derivative is wrong, and nearly every metric that needs no modal data was compared.
void check_every_metric(const Tally& tally) {
  std::string sharp;
  for (const auto& [name, count] : tally.sharp) sharp += name + " " + std::to_string(count) + "  ";
  CAPTURE(sharp, tally.blunt, tally.again, tally.examples);
  CHECK(tally.wrong == 0);
  CHECK(tally.again <= tally.total_sharp() / 100);  // by chance, and seldom
  CHECK(tally.sharp.size() >= metrics_without_modes() - 2);
  CHECK(tally.total_sharp() > 1000);
}

}  // namespace

TEST_CASE("every metric's derivative by every parameter is that of differences",
          "[core][derivative][differential]") {
  // 1e-7 of |f / x| or of the derivative, plus three times the difference's own error estimate;
  // differences that know themselves worse than 1e-8 do not count.
  check_every_metric(check_designs(20250101, 8, design_of));
}

TEST_CASE(
    "an annulus has the derivatives of differences, shape and taper included (W2.3, W2.4, W4.1)",
    "[core][annulus][derivative][differential]") {
  check_every_metric(check_designs(20250102, 6, annulus_of));
}

TEST_CASE("a layer that still rings at the next entry has the derivatives of differences (E6.2)",
          "[core][derivative][differential]") {
  // Its state at entry depends on the one a turn before by factors near one, so the derivative of the
  // periodic state rests on that return map; in ordinary motors a turn forgets nearly everything.
  MotorDesign design = ring_motor();
  design.layer.loss_factor = 0.001;
  design.layer.given_inertia = 5e-4;
  const Motor motor(design);
  std::vector<MetricRequest> requests;
  for (const double share : {0.3, 0.9, 1.2}) {
    for (const Metric which : {Metric::torque_at, Metric::friction_power_at, Metric::layer_loss_at})
      requests.push_back({which, Argument::speed, share * motor.crest_speed()});
  }
  // and the second derivatives, by which a peak moves
  requests.push_back({Metric::speed_at_peak_power});
  Tally tally;
  Deviation deviation("derivatives of a ringing layer against Richardson differences, relative",
                      1e-7);
  check_gradients(design, requests, tally, deviation);
  CAPTURE(tally.total_sharp(), tally.blunt, tally.again, tally.examples);
  CHECK(tally.wrong == 0);
  CHECK(tally.again <= tally.total_sharp() / 100);  // by chance, and seldom
  CHECK(tally.total_sharp() >= 50);
  CHECK(tally.sharp["speed_at_peak_power"] >= 5);
  CHECK(deviation.holds());
}

TEST_CASE("derivatives of hundreds of designs are those of differences",
          "[.long][core][derivative][differential]") {
  const Tally tally = check_designs(7, 200, design_of);
  CAPTURE(tally.blunt, tally.again, tally.examples);
  CHECK(tally.wrong == 0);
  CHECK(tally.again <= tally.total_sharp() / 100);  // by chance, and seldom
  CHECK(tally.total_sharp() > 25'000);              // as many for each design as above
}

TEST_CASE("a parameter that is not in use has no derivative", "[core][derivative][identity]") {
  MotorDesign design = ring_motor();
  design.layer.given_shear_modulus = 1.1e9;
  const Motor motor(design);
  const auto requests = all_requests(motor);
  for (const MetricDerivative& found : differentiate(motor, requests)) {
    if (found.smoothness == Smoothness::undefined) continue;
    CHECK(found.gradient[index_of(Parameter::poisson_ratio)] == 0);
  }
}

TEST_CASE("stall torque of a plateau is flat in amplitude, thickness and modulus (C8.5)",
          "[core][derivative][closed_form]") {
  const Motor motor(ring_motor());
  const auto found = differentiate(motor, std::vector<MetricRequest>{{Metric::stall_torque}});
  REQUIRE(found.size() == 1);
  const double full = 0.2 * 160 * 0.0265;
  CHECK(found[0].smoothness == Smoothness::flat);
  for (const Parameter p :
       {Parameter::amplitude, Parameter::thickness, Parameter::youngs_modulus}) {
    // zero but for rounding of mu F_N r through the pressure's integral
    CHECK(std::abs(found[0].gradient[index_of(p)]) * get(motor.design(), p) <= 1e-12 * full);
  }
  CHECK(found[0].gradient[index_of(Parameter::preload)] == Approx(full / 160).epsilon(1e-12));
  CHECK(found[0].gradient[index_of(Parameter::kinetic_friction)] ==
        Approx(full / 0.2).epsilon(1e-12));
  CHECK(found[0].gradient[index_of(Parameter::contact_radius)] ==
        Approx(full / 0.0265).epsilon(1e-12));
}

TEST_CASE("static friction held fixed has its own derivative", "[core][derivative][identity]") {
  MotorDesign design = ring_motor();
  design.friction.static_ = 0.3;
  const Motor motor(design);
  const std::vector<MetricRequest> requests{{Metric::holding_torque}};
  const auto moving = differentiate(motor, requests, false);
  const auto fixed = differentiate(motor, requests, true);
  const auto mu = index_of(Parameter::kinetic_friction);
  const auto mu0 = index_of(Parameter::static_friction);
  // holding torque mu_0 F_N r: by mu it is ratio times F_N r if mu_0 moves along, else zero (T7.8)
  CHECK(moving[0].gradient[mu] == Approx(1.5 * 160 * 0.0265).epsilon(1e-14));
  CHECK(fixed[0].gradient[mu] == 0);
  CHECK(fixed[0].gradient[mu0] == Approx(160 * 0.0265).epsilon(1e-14));
}

TEST_CASE(
    "a maximum where the torque jumps up from its plateau has the derivatives of its limit (T7.16)",
    "[core][derivative][differential][limit]") {
  // Beyond the jump the torque moves like the square root of the distance; two distances give the limit.
  const auto limits = [](const MotorDesign& design) {
    constexpr double kDistance = 1e-9;
    const Motor motor(design);
    const double end = evaluate(motor, {Metric::plateau_speed}).value;
    const auto torque = [&](double distance) {
      return motor.operating_point(end * (1 + distance)).torque;
    };
    const double limit = 2 * torque(kDistance) - torque(4 * kDistance);
    return std::vector<double>{limit, limit * end};
  };
  const std::vector<MetricRequest> requests{{Metric::max_torque}, {Metric::peak_power}};
  Deviation deviation("derivatives of maxima at a jump against differences of the limit, relative",
                      1e-6);
  Uniform random(77);
  int compared[2] = {0, 0};
  for (int i = 0; i < 300; ++i) {
    MotorDesign design = realistic_design(random);
    if (design.friction.static_ < 1.1 * design.friction.kinetic) continue;
    const auto exact = differentiate(Motor(design), requests);
    const std::vector<double> at = limits(design);
    for (const Parameter p : {Parameter::amplitude, Parameter::preload, Parameter::youngs_modulus,
                              Parameter::thickness, Parameter::kinetic_friction}) {
      const double x = get(design, p);
      std::vector<DifferenceQuotient> found;
      for (std::size_t k = 0; k < 2; ++k) {
        // a maximum elsewhere has other derivatives
        const double value = exact[k].value.value;
        const bool here =
            exact[k].smoothness == Smoothness::one_sided && std::abs(value - at[k]) <= 1e-6 * value;
        if (!here) continue;
        if (found.empty()) {
          found = central_differences([&](double y) { return limits(with(design, p, y)); }, x, x);
        }
        const double unit = value / x;
        if (!(found[k].error <= 1e-6 * unit)) continue;
        ++compared[k];
        CAPTURE(i, info(requests[k].metric).name, x, found[k].error / unit);
        // The limit is good to 1e-11: its differences over steps of a percent to 1e-8 or so, as they say
        // themselves, and what the square root leaves of two distances is of their order.
        CHECK(deviation.add(exact[k].gradient[index_of(p)], found[k].value, unit) <=
              1e-7 + 3 * found[k].error / unit);
      }
    }
  }
  CHECK(compared[0] >= 200);
  CHECK(compared[1] >= 10);
  CHECK(deviation.holds());
}

TEST_CASE("gradients obey the law of a longer track, the number of waves included",
          "[core][derivative][scaling]") {
  // n, r and F_N times the same factor: the same wave, contact and load on every length of a longer track. Torques go
  // with the second power of the factor, speeds with the power -1, so by Euler's theorem on homogeneous functions
  // n f_n + r f_r + F_N f_(F_N) = k f.
  const std::pair<Metric, double> degrees[] = {
      {Metric::stall_torque, 2},         {Metric::max_torque, 2},
      {Metric::holding_torque, 2},       {Metric::no_load_speed, -1},
      {Metric::plateau_speed, -1},       {Metric::peak_power, 1},
      {Metric::speed_at_peak_power, -1}, {Metric::torque_at_peak_power, 2},
      {Metric::contact_half_length, 0},  {Metric::contact_ratio, 0},
      {Metric::max_pressure, 0},         {Metric::contact_efficiency_at_peak_power, 0}};
  Deviation deviation("gradients against Euler's theorem for a longer track, relative", 1e-8);
  Uniform random(31);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const MotorDesign design = design_of(random, i);
    const Motor motor(design);
    for (const auto& [metric, degree] : degrees) {
      const MetricDerivative found = differentiate(motor, std::vector{MetricRequest{metric}})[0];
      if (found.smoothness == Smoothness::undefined) continue;
      double sum = 0, size = std::abs(found.value.value);
      for (const Parameter p :
           {Parameter::wavelengths, Parameter::contact_radius, Parameter::preload}) {
        const double term = get(design, p) * found.gradient[index_of(p)];
        sum += term;
        size = std::max(size, std::abs(term));
      }
      CAPTURE(i, info(metric).name, to_string(found.smoothness));
      ++compared;
      // The terms cancel; each is good to some 1e-10, speeds of peaks through f' / f'' a little less.
      CHECK(deviation.add(sum, degree * found.value.value, size) <= 1e-8);
    }
  }
  CHECK(compared > 500);
  CHECK(deviation.holds());
}

TEST_CASE("derivatives of a point in speed are those of differences",
          "[core][derivative][differential]") {
  Deviation deviation("derivatives of points in speed against Richardson differences, relative",
                      1e-7);
  Uniform random(32);
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    const Motor motor(design_of(random, i));
    const double speed = motor.crest_speed() * random(-0.2, 1.3);
    const SpeedDerivative exact = differentiate_in_speed(motor, speed);
    if (exact.smoothness != Smoothness::smooth) continue;
    const auto numbers = [&](double at) {
      const OperatingPoint p = motor.operating_point(at);
      return std::vector<double>{p.torque,         p.output_power, p.stator_power,
                                 p.friction_power, p.layer_loss,   p.stick_fraction};
    };
    const double slopes[] = {exact.torque,         exact.output_power, exact.stator_power,
                             exact.friction_power, exact.layer_loss,   exact.stick_fraction};
    const std::vector<double> values = numbers(speed);
    const auto found = central_differences(numbers, speed, motor.crest_speed());
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double unit = std::max(std::abs(values[k] / speed), std::abs(found[k].value));
      if (!(found[k].error <= 1e-8 * unit)) continue;
      CAPTURE(i, k, speed / motor.crest_speed());
      ++compared;
      CHECK(deviation.add(slopes[k], found[k].value, unit) <= 1e-7);
    }
  }
  CHECK(compared > 100);
  CHECK(deviation.holds());
}

TEST_CASE("in full contact, too, derivatives are those of differences",
          "[core][derivative][differential]") {
  Tally tally;
  Deviation deviation("derivatives in full contact against Richardson differences, relative", 1e-7);
  Uniform random(34);
  for (int i = 0; i < 6; ++i) {
    MotorDesign design = design_of(random, i);
    design.preload = full_contact_load(design) * random(1.1, 1.6);
    const Motor motor(design);
    REQUIRE(motor.contact().full);
    std::vector<MetricRequest> requests;
    for (const Metric metric :
         {Metric::torque_at, Metric::stator_power_at, Metric::friction_power_at,
          Metric::layer_loss_at, Metric::stick_fraction_at}) {
      for (const double share : {0.4, 0.9})
        requests.push_back({metric, Argument::speed, share * motor.crest_speed()});
    }
    for (const Metric metric : {Metric::max_pressure, Metric::stall_torque, Metric::no_load_speed})
      requests.push_back({metric});
    check_gradients(design, requests, tally, deviation);
  }
  CAPTURE(tally.total_sharp(), tally.blunt, tally.again, tally.examples);
  CHECK(tally.wrong == 0);
  CHECK(tally.again <= tally.total_sharp() / 100);  // by chance, and seldom
  CHECK(tally.total_sharp() > 200);
  CHECK(deviation.holds());
}

TEST_CASE("the speed of a peak that cannot move has derivative zero", "[core][derivative][limit]") {
  // Without drive there is no power, at no speed.
  MotorDesign design = ring_motor();
  design.stator.amplitude = 0;
  const auto still = differentiate(
      Motor(design),
      std::vector{MetricRequest{Metric::peak_power}, MetricRequest{Metric::speed_at_peak_power}});
  CHECK(still[1].value.value == 0);
  CHECK(still[1].smoothness == Smoothness::flat);
  for (const double each : still[1].gradient) CHECK(each == 0);
}
