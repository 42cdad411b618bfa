// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/contact_problem.hpp"
#include "support/deviations.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/motor.hpp>
#include <twum/core/normal_contact.hpp>

#include <cmath>

namespace {

using namespace twum;
using namespace twum::test;

// sin t - t cos t from its power series in long double; converges for all t <= pi, and 40 terms leave
// nothing of it. The largest term at pi is about 5, so no more than one digit of 19 is lost.
long double load_of(long double t) {
  long double power = t * t * t;
  long double factorial = 6;
  long double sum = 0;
  for (int k = 1; k <= 40; ++k) {
    sum += (k % 2 == 1 ? 1 : -1) * power * static_cast<long double>(2 * k) / factorial;
    power *= t * t;
    factorial *= static_cast<long double>((2 * k + 2) * (2 * k + 3));
  }
  return sum;
}

// Simpson's rule over the contact on the pressure the fields report.
double preload_by_quadrature(const Motor& motor) {
  const ContactProblem problem = contact_problem(motor.design(), 0);
  const NormalContact<double>& contact = motor.contact();
  const double half = contact.half_angle;
  const int panels = 2000;
  double sum = 0;
  for (int i = 0; i <= panels; ++i) {
    const double theta = half * (2.0 * i / panels - 1);
    const double pressure =
        contact.full ? contact.pressure_amplitude * (std::cos(theta) - contact.edge_cosine)
                     : 2 * contact.pressure_amplitude * std::sin((half + theta) / 2) *
                           std::sin((half - theta) / 2);
    sum += (i == 0 || i == panels ? 1 : i % 2 == 1 ? 4 : 2) * pressure;
  }
  return problem.track_area / (2 * kPi) * sum * 2 * half / panels / 3;
}

}  // namespace

TEST_CASE("the half angle is found to full relative accuracy from 1e-12 to pi (T3.2)",
          "[core][contact][closed_form]") {
  Deviation angle("half contact angle against its series", 4e-15);
  for (int i = 0; i <= 2000; ++i) {
    const double exact = std::min(1e-12 * std::pow(kPi * 1e12, i / 2000.0), 3.1415);
    const auto load = static_cast<double>(load_of(exact));
    // d(log t) / d(log load) is 1/3 for small angles and below 1 up to pi, where the slope
    // t sin t vanishes: there an error of eps in load moves t by eps load / (t sin t), which is the
    // second term. A few eps of the solver itself are in the first.
    const double tolerance = 4e-15 + 4e-16 * load / (exact * exact * std::sin(exact));
    CAPTURE(exact);
    CHECK(std::abs(contact_half_angle(load) - exact) / exact <= tolerance);
    if (exact < 3) angle.add(contact_half_angle(load), exact, exact);
  }
  CHECK(angle.holds());
  CHECK(contact_half_angle(0) == 0);
  CHECK(contact_half_angle(std::nextafter(kPi, 0)) <= kPi);
}

TEST_CASE("contact pressure adds up to the preload (T3.1, T3.2, T3.3)",
          "[core][contact][quadrature]") {
  Deviation deviation("preload by quadrature", 1e-11);
  for (const double load : {1e-18, 1e-9, 1e-3, 0.1, 0.5, 0.99, 1.01, 1.5, 10.0}) {
    MotorDesign design = ring_motor();
    design.preload = load * full_contact_load(design);
    const Motor motor(design);
    CAPTURE(load);
    CHECK(motor.contact().full == (load >= 1.0));
    // Simpson with 2000 panels errs by (2 theta_L / 2000)^4 / 180, below 6e-13 of the load; the
    // amplitude and angle carry a few eps.
    CHECK(deviation.add(preload_by_quadrature(motor), design.preload, design.preload) <= 1e-11);
  }
  CHECK(deviation.holds());
}

TEST_CASE("contact length, ratio and pressure follow from the half angle (T3.4)",
          "[core][contact][identity]") {
  Uniform random(5);
  for (int i = 0; i < 200; ++i) {
    const MotorDesign design = random_box_point(random).design;
    const auto problem = contact_problem(design, 0);
    const auto contact = Motor(design).contact();
    const double wave_number = design.stator.wavelengths / design.stator.contact_radius;
    CAPTURE(i, problem.half_angle);
    CHECK(contact.full == problem.full);
    CHECK(contact.half_angle == Approx(problem.half_angle).epsilon(1e-13));
    CHECK(contact.half_length == Approx(problem.half_angle / wave_number).epsilon(1e-13));
    CHECK(contact.ratio == Approx(problem.half_angle / (2 * kPi)).epsilon(1e-13));
    CHECK(contact.max_pressure == Approx(problem.pressure(0)).epsilon(1e-12));
  }
}

TEST_CASE("partial contact passes into full contact without a step (T3.3)",
          "[core][contact][limit]") {
  MotorDesign design = ring_motor();
  const double limit = full_contact_load(design);
  // The load's slope theta_L sin theta_L vanishes at pi: a load short of the limit by a share d leaves theta_L
  // short of pi by sqrt(2 d), 4.5e-5, and the pressure at the crest, P (1 - c), of its value by d/2.
  design.preload = limit * (1 - 1e-9);
  const auto below = Motor(design).contact();
  design.preload = limit * (1 + 1e-9);
  const auto above = Motor(design).contact();
  CHECK_FALSE(below.full);
  CHECK(above.full);
  Deviation angle("step of the half angle where contact becomes full, of sqrt(2 d)", 1.01);
  Deviation pressure("step of the pressure where contact becomes full", 4e-9);
  CHECK(angle.add(above.half_angle, below.half_angle, std::sqrt(2e-9)) <= 1.01);
  CHECK(pressure.add(above.max_pressure / below.max_pressure, 1, 1) <= 4e-9);
}
