// SPDX-License-Identifier: Apache-2.0
#include "core/every_derivative.hpp"
#include "support/deviations.hpp"
#include "support/expect_derivatives.hpp"
#include "support/metric_requests.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::test;

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
      std::count_if(metric_table().begin(), metric_table().end(), [](const MetricInfo& row) {
        return !row.needs_modes && !row.needs_geometry && !row.needs_thermal && !row.needs_wear &&
               !row.needs_motion && row.argument != Argument::both && !is_of_envelope(row.metric);
      }));
}

// No derivative is wrong, and nearly every metric that needs no modal data was compared.
void check_every_metric(const Tally& tally) {
  std::string sharp;
  for (const auto& [name, count] : tally.sharp) sharp += name + " " + std::to_string(count) + "  ";
  CAPTURE(sharp, tally.blunt, tally.again, tally.examples);
  CHECK(tally.wrong == 0);
  CHECK(tally.again <= tally.total_sharp() / 100);  // by chance, and seldom
  CHECK(tally.sharp.size() >= metrics_without_modes() - 1);
  CHECK(tally.total_sharp() > 1000);
}

// The same for some metrics of one design, the speed at peak power among them.
// @param name  of the row of docs/validation.md
void check_some_metrics(const MotorDesign& design, const std::vector<MetricRequest>& requests,
                        const char* name) {
  Tally tally;
  Deviation deviation(name, 1e-7);
  check_gradients(design, requests, tally, deviation);
  CAPTURE(tally.total_sharp(), tally.blunt, tally.again, tally.examples);
  CHECK(tally.wrong == 0);
  CHECK(tally.again <= tally.total_sharp() / 100);  // by chance, and seldom
  CHECK(tally.total_sharp() >= 50);
  CHECK(tally.sharp["speed_at_peak_power"] >= 5);
  CHECK(deviation.holds());
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

namespace {

// Torques beside their derivatives.
void check_torques(const MotorDesign& design) {
  const Motor motor(design);
  std::vector<MetricRequest> requests;
  for (const double share : {0.3, 0.65, 0.8, 0.95, 1.2})
    requests.push_back({Metric::torque_at, Argument::speed, share * motor.crest_speed()});
  const auto found = differentiate(motor, requests);
  for (const Parameter parameter : {Parameter::amplitude, Parameter::preload, Parameter::thickness,
                                    Parameter::kinetic_friction, Parameter::contact_width}) {
    const double x = get(design, parameter), step = 1e-4 * x;
    const auto high = values_at(design, parameter, x + step, requests),
               low = values_at(design, parameter, x - step, requests);
    for (std::size_t i = 0; i < requests.size(); ++i) {
      const double slope = (high[i] - low[i]) / (2 * step);
      CAPTURE(info(parameter).name, i, slope);
      CHECK(std::abs(found[i].gradient[index_of(parameter)] - slope) <=
            1e-5 * torque_scale(design) / x);
    }
  }
}

}  // namespace

// Where the search for a split takes one step more the torque steps by 1e-9 of its scale (W4.4): 5e-6 of it over
// the difference of 2e-4. The
// third derivatives that a central difference leaves are of order 1e2 of the scale: 1e-8 times that.
TEST_CASE("a track that is split where zones begin has the derivatives of differences (W4.4)",
          "[core][annulus][derivative][differential]") {
  MotorDesign design = ring_motor();
  design.stator.radial_slices = -12;
  check_torques(design);
}

// A jump of 1 % of the scale that moves by a tenth of the track per relative change of a parameter adds 1e-3 to a derivative, a
// hundred times the tolerance: a split that stood still would be seen.
TEST_CASE("a track that is split where its slices jump has the derivatives of differences (W4.5)",
          "[core][annulus][derivative][differential]") {
  const MotorDesign ring = ring_motor();
  MotorDesign ringing = ring;  // comes back with a hundredth of its motion
  ringing.layer.thickness = 0.5e-3, ringing.layer.youngs_modulus = 0.9e9;
  for (MotorDesign design : {ring, elastic(ring), damped(ring), ringing}) {
    design.friction.threshold = 1.3 * design.friction.kinetic;
    design.stator.radial_slices = -12;
    check_torques(design);
  }
}

// Maxima take second derivatives. They are smooth, where those of a number of slices lie beside jumps.
TEST_CASE("the metrics of a track with mu_0 > mu have the derivatives of differences (W4.5)",
          "[core][annulus][derivative][differential]") {
  MotorDesign design = ring_motor();
  design.stator.modal_damping = 45;
  design.friction.threshold = 1.3 * design.friction.kinetic;
  design.stator.radial_slices = -10;
  const std::vector<MetricRequest> requests{{Metric::no_load_speed},  {Metric::max_torque},
                                            {Metric::peak_power},     {Metric::speed_at_peak_power},
                                            {Metric::max_efficiency}, {Metric::plateau_speed}};
  for (const MetricDerivative& found : differentiate(Motor(design), requests))
    CHECK(found.smoothness == Smoothness::smooth);
  check_some_metrics(design, requests,
                     "derivatives of a track that jumps against Richardson differences, relative");
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
  check_some_metrics(design, requests,
                     "derivatives of a ringing layer against Richardson differences, relative");
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
  design.friction.threshold = 0.3;
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
