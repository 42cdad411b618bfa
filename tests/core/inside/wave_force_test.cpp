// SPDX-License-Identifier: Apache-2.0
#include "contact/zone_integrals.hpp"
#include "point/point_derivatives.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

// Simpson's rule over 2000 panels: it errs by (x / 2000)^4 / 180 of the fourth derivative, 1e-13 for zones up to pi.
template <typename F>
double simpson(const F& f, double a, double b) {
  constexpr int kPanels = 2000;
  const double h = (b - a) / (2 * kPanels);
  double sum = f(a) + f(b);
  for (int k = 1; k < 2 * kPanels; ++k) sum += (k % 2 ? 4 : 2) * f(a + k * h);
  return sum * h / 3;
}

Phase<double> phase(double theta) { return {theta, trig(theta)}; }

MotorDesign full_contact() {
  MotorDesign design;
  design.preload = 40'000;
  return design;
}

}  // namespace

TEST_CASE("zones of slip (D1.7) and stick (D1.8) add the integral of t sin theta",
          "[core][wave_force][quadrature]") {
  Dice dice(71);
  for (int i = 0; i < 200; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const double shrink = i % 2 ? 1 : 1e-3;  // small contacts lose digits where forms are careless
    const double a = shrink * dice.uniform(-1, 0.5) * n.half_angle,
                 b = a + shrink * dice.uniform(0.05, 0.5) * n.half_angle;
    const double sigma = i % 3 ? 1 : -1;
    const auto pressure = [&](double x) { return n.peak - 2 * std::pow(std::sin(x / 2), 2); };
    const double slip =
        simpson([&](double x) { return -sigma * n.kinetic * pressure(x) * std::sin(x); }, a, b);
    const Moments<double> m(phase(a), phase(b));
    // Rounding of sums of terms of the size of the integrand's largest value.
    const double slack = 4e-13 * (b - a) * std::max(std::fabs(a), std::fabs(b));
    CHECK(std::fabs(slip_integrals(n, sigma, m, phase(a), phase(b), {0, 0}).reactive_force -
                    slip) <= slack * (1 + n.peak));
    const Harmonic<double> t{dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1),
                             dice.uniform(-1, 1)};
    const double stick = simpson(
        [&](double x) {
          return (t.k0 + t.kb * x + t.kw * 2 * std::pow(std::sin(x / 2), 2) + t.ks * std::sin(x)) *
                 std::sin(x);
        },
        a, b);
    CHECK(std::fabs(stick_integrals(n, layer, t, phase(a), phase(b)).reactive_force - stick) <=
          4 * slack);
  }
}

TEST_CASE("the pressure's force grows with the amplitude as (C20.1) says",
          "[core][wave_force][derivative]") {
  using namespace core;
  const int amplitude = static_cast<int>(model_index(Parameter::amplitude));
  for (const double load : {0.9, 0.3, 0.02, 1e-3}) {
    MotorDesign design;
    design.preload = 10'000 * load;
    const DrivenMotor<ModelDual> m = differentiated_motor<ModelDual>(design);
    REQUIRE(!m.mean.contact.full);
    const double angle = m.mean.contact.half_angle.v, sine = std::sin(angle);
    const double full = m.r.v * m.b.v * m.youngs.v / m.thickness.v;  // K_c / pi
    // Both sides are differences that fall with theta_L^5 of terms of order one.
    CHECK(std::fabs(m.mean.pressure_force.d[amplitude] -
                    full * (angle + sine * std::cos(angle) - 2 * sine * sine / angle)) <=
          1e-14 * full / angle);
  }
}

TEST_CASE("the reactive force has the derivatives of its differences",
          "[core][wave_force][derivative]") {
  using namespace core;
  const auto force = [](const MotorDesign& design, double speed) {
    const ModelArray<double> p = model_values(design);
    const DrivenMotor<double> m = driven(motor_model(p), design_wave(p));
    return solve_point(m, speed).numbers.reactive_force;
  };
  for (const MotorDesign& design : {MotorDesign{}, full_contact()}) {
    const ModelArray<double> p = model_values(design);
    const DrivenMotor<double> m = driven(motor_model(p), design_wave(p));
    const double speed = 0.9 * m.mean.crest_velocity / m.r;
    const PointNumbers<ModelDual> n = solve_point(m, speed).differentiated(
        differentiated_motor<ModelDual>(design), speed_variable<ModelDual>(speed));
    const MotorDesign given = [&] {  // G, gamma and m outright: the model's own parameters
      MotorDesign d = design;
      d.layer.given_shear_modulus = shear_modulus(design);
      d.layer.given_shear_viscosity = shear_viscosity(design);
      d.layer.given_inertia = inertia(design);
      return d;
    }();
    for (const Parameter parameter :
         {Parameter::contact_radius, Parameter::frequency, Parameter::amplitude,
          Parameter::thickness, Parameter::youngs_modulus, Parameter::shear_modulus,
          Parameter::shear_viscosity, Parameter::inertia, Parameter::preload}) {
      const double x = get(given, parameter), d = 1e-5 * x;
      const double quotient = (force(with(given, parameter, x + d), speed) -
                               force(with(given, parameter, x - d), speed)) /
                              (2 * d);
      const double exact = n.reactive_force.d[model_index(parameter)];
      CAPTURE(info(parameter).name, design.preload);
      // Central differences over 1e-5: 1e-10 of the third derivative, which near the ends of zones is up to 1e4 times the
      // scale, and rounding 1e-16 / 1e-5.
      CHECK(std::fabs(exact - quotient) * x <= 1e-6 * std::fabs(n.reactive_force.v));
    }
    const double d = 1e-5 * speed;
    const double quotient = (force(design, speed + d) - force(design, speed - d)) / (2 * d);
    CHECK(std::fabs(n.reactive_force.d[kSpeedDirection] - quotient) * speed <=
          1e-6 * std::fabs(n.reactive_force.v));
  }
}
