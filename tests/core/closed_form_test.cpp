// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/deviations.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

// Closed forms of theory section 8, each written here from the page and used nowhere in the core.
namespace {

using namespace twum;
using namespace twum::test;

// An elastic layer with given half contact angle and friction-compliance number at rest.
struct ElasticMotor {
  MotorDesign design;
  double phi;
  double at_rest;   // S at U = 0
  double coupling;  // kappa V0 / omega: S(V) = S0 (1 + coupling V)

  double compliance(double v) const { return at_rest * (1 + coupling * v); }  // S (C8.4)
  double full_torque() const {
    return design.friction.kinetic * design.preload * design.stator.contact_radius;
  }
  double share(const Motor& motor, double v) const {
    return motor.operating_point(v * motor.crest_speed()).torque / full_torque();
  }
};

double load_shape(double phi) { return std::sin(phi) - phi * std::cos(phi); }

ElasticMotor elastic_motor(double phi, double compliance) {
  ElasticMotor made{elastic(ring_motor()), phi, compliance, 0};
  MotorDesign& design = made.design;
  const auto& s = design.stator;
  const double wave_number = s.wavelengths / s.contact_radius;
  const double omega = 2 * kPi * s.frequency;
  design.layer.given_shear_modulus = design.friction.kinetic * design.layer.youngs_modulus /
                                     (compliance * wave_number * s.neutral_plane_distance);
  // sin t - t cos t loses digits for small t, where its series t^3/3 - t^5/30 serves
  const double shape = phi > 0.05 ? load_shape(phi) : phi * phi * phi / 3 * (1 - phi * phi / 10);
  design.preload = full_contact_load(design) / kPi * shape;
  made.coupling = wave_number * crest_speed_of(design) * s.contact_radius / omega;
  return made;
}

// NaN, which no comparison accepts, if the metric has no value.
double metric(const Motor& motor, Metric which) {
  return evaluate(motor, MetricRequest{which}).value;
}

// Speeds V = U / V0 from the implicit conditions of (C8.5) and (C8.7), S depending on V through W.
double plateau_end(const ElasticMotor& m) {
  const double s = m.at_rest * std::sin(m.phi);
  return (std::cos(m.phi) - s) / (1 + s * m.coupling);
}
double braking_begin(const ElasticMotor& m) {
  const double s0 = m.at_rest;
  const double k = s0 * m.coupling;
  // V^2 = 1 + S^2 with S = s0 + k V, from the first branch
  const double v =
      (s0 * k + std::sqrt(s0 * s0 * k * k + (1 - k * k) * (1 + s0 * s0))) / (1 - k * k);
  if (std::atan(m.compliance(v)) < m.phi) return v;
  return (std::cos(m.phi) + s0 * std::sin(m.phi)) / (1 - k * std::sin(m.phi));
}

}  // namespace

TEST_CASE("elastic layer drives with full friction up to the plateau speed (C8.5, T7.17)",
          "[core][point][closed_form]") {
  Deviation plateau("plateau torque of the elastic layer", 1e-10);
  Deviation speed("plateau speed of the elastic layer", 1e-10);
  for (const double phi : {1e-3, 0.1, 0.5, 1.0, 1.4}) {
    for (const double compliance : {0.01, 0.1, 0.5}) {
      const ElasticMotor m = elastic_motor(phi, compliance);
      const Motor motor(m.design);
      const double end = plateau_end(m);
      CAPTURE(phi, compliance, end);
      if (end <= 0) continue;
      for (const double v : {0.0, 0.5 * end, end - 1e-9})
        CHECK(plateau.add(m.share(motor, v), 1, 1) <= 1e-10);
      // beyond, torque falls: by a cubic, so go a good way
      CHECK(m.share(motor, end + 0.2 * (1 - end)) < 1 - 1e-6);
      // phi carries the rounding of the preload, 1e-15 relative, and of its inversion
      CHECK(speed.add(metric(motor, Metric::plateau_speed) / motor.crest_speed(), end, 1) <= 1e-10);
    }
  }
  CHECK(plateau.holds());
  CHECK(speed.holds());
}

TEST_CASE("elastic layer stalls below full friction once phi exceeds arccot S (C8.5, T7.12)",
          "[core][point][closed_form]") {
  Deviation full("stall torque of the elastic layer up to phi = arccot S", 1e-10);
  Deviation below("stall torque of the elastic layer lower beyond phi = arccot S", 0);
  for (const double compliance : {0.5, 1.0, 3.0}) {
    const double border = std::atan2(1.0, compliance);
    for (const double factor : {0.9, 1.1}) {
      const ElasticMotor m = elastic_motor(factor * border, compliance);
      const Motor motor(m.design);
      CAPTURE(compliance, factor);
      const double stall = metric(motor, Metric::stall_torque) / m.full_torque();
      if (factor < 1) CHECK(full.add(stall, 1, 1) <= 1e-10);
      if (factor > 1) CHECK(below.add(stall < 1 - 1e-6, true, 1) == 0);
      if (factor > 1) CHECK(metric(motor, Metric::plateau_speed) == 0);
    }
  }
  CHECK(full.holds());
  CHECK(below.holds());
}

TEST_CASE("elastic layer that sticks all through runs free at sin phi / phi (C8.6, T7.14)",
          "[core][point][closed_form]") {
  Deviation torque("torque of the elastic layer at its no-load speed", 1e-10);
  Deviation speed("no-load speed of the elastic layer", 1e-10);
  for (const double phi : {1e-2, 0.3, 1.0, 2.0, 3.0}) {
    for (const double surplus : {1.001, 1.5, 10.0}) {
      // S at the no-load speed must reach 1 / phi - cot phi; S at rest is a little lower
      const double v = std::sin(phi) / phi;
      const ElasticMotor m = elastic_motor(phi, surplus * (1 / phi - 1 / std::tan(phi)));
      const Motor motor(m.design);
      CAPTURE(phi, surplus);
      CHECK(torque.add(m.share(motor, v), 0, 1) <= 1e-10);
      CHECK(speed.add(metric(motor, Metric::no_load_speed) / motor.crest_speed(), v, v) <= 1e-10);
      const auto zones = motor.zones(v * motor.crest_speed());
      REQUIRE_FALSE(zones.empty());
      CHECK(zones[0].state == ZoneState::stick);
      // at exit tau and p vanish together, so rounding of V may let the last of it slip
      CHECK(zones[0].to > phi * (1 - 1e-5));
    }
  }
  CHECK(torque.holds());
  CHECK(speed.holds());
}

TEST_CASE("elastic layer brakes with full friction from the braking speed on (C8.7)",
          "[core][point][closed_form]") {
  Deviation braking("braking torque of the elastic layer", 1e-10);
  for (const double phi : {1e-2, 0.3, 1.0, 2.5}) {
    for (const double compliance : {0.02, 0.3, 1.5}) {
      const ElasticMotor m = elastic_motor(phi, compliance);
      const Motor motor(m.design);
      const double begin = braking_begin(m);
      CAPTURE(phi, compliance, begin);
      for (const double beyond : {1e-9, 1e-3, 0.3}) {
        CHECK(braking.add(m.share(motor, begin + beyond), -1, 1) <= 1e-10);
      }
      // Full braking is reached quadratically, with a curvature that falls with the width.
      CHECK(m.share(motor, begin - 0.05 * phi * compliance) > -1 + 1e-9);
    }
  }
  CHECK(braking.holds());
}

TEST_CASE("narrow contacts follow the brush-tyre law (C8.8)", "[core][point][limit]") {
  // The law drops terms of relative order phi (1/S + S) of q, and torque changes by at most 3 per q.
  // Besides, V is known to eps and q is 1 - V over S phi.
  Deviation law("brush-tyre law, in units of the terms it drops", 1);
  Deviation narrowest("brush-tyre law at phi = 1e-4, of mu F_N r", 2e-3);
  for (const double phi : {1e-2, 1e-3, 1e-4}) {
    for (const double compliance : {0.3, 1.0, 3.0}) {
      const ElasticMotor m = elastic_motor(phi, compliance);
      const Motor motor(m.design);
      const double tolerance = 3 * phi * (1 / compliance + compliance) + 1e-15 / (compliance * phi);
      for (const double q : {0.02, 0.2, 0.5, 0.8, 0.99}) {
        // 1 - V = q S(V) phi, solved for V
        const double v = (1 - q * m.at_rest * phi) / (1 + q * m.at_rest * m.coupling * phi);
        CAPTURE(phi, compliance, q);
        const double expected = 1 - std::pow(1 - q, 3);
        CHECK(law.add(m.share(motor, v), expected, tolerance) <= 1);
        // 3 phi (1/S + S) is 1.1e-3 at most
        if (phi == 1e-4) narrowest.add(m.share(motor, v), expected, 1);
      }
    }
  }
  CHECK(law.holds());
  CHECK(narrowest.holds());
}

TEST_CASE("stiff layers follow the rigid law (C8.2, C8.3)", "[core][point][limit]") {
  // Where v_rel passes zero at cos theta* = V, on either side of the crest, the layer sticks until tau has gone
  // from one cone to the other: 2 (cos theta* - c) = sin theta* delta^2 / (2 S). Over that width tau is off by
  // at most 2 mu p, of an integral of 2 g mu P; both sides together give the bound below.
  const double compliance = 1e-8;
  Deviation rigid("rigid limit at S = 1e-8, in units of the bound of order sqrt(S)", 1);
  Deviation rigid_free("no-load law of the rigid limit, of its right-hand side g / 2", 2e-3);
  for (const double phi : {0.2, 0.8, 1.6, 2.6}) {
    const ElasticMotor m = [&] {
      // a soft foundation keeps G = mu E / (S kappa a) inside its range
      ElasticMotor soft = elastic_motor(phi, compliance);
      MotorDesign& d = soft.design;
      const double factor = 1e-5;
      d.layer.youngs_modulus *= factor;
      d.layer.given_shear_modulus = *d.layer.given_shear_modulus * factor;
      d.preload *= factor;
      return soft;
    }();
    const Motor motor(m.design);
    const double c = std::cos(phi);
    const double g = load_shape(phi);
    for (const double v : {-0.2, 0.0, 0.3, 0.6, 0.9, 0.99, 1.2}) {
      CAPTURE(phi, v);
      const double star = std::acos(std::clamp(v, -1.0, 1.0));
      const double expected = v <= c ? 1 : v >= 1 ? -1 : (2 * (std::sin(star) - star * c) - g) / g;
      const double width =
          std::sqrt(4 * compliance * std::max(v - c, 0.0) / std::max(std::sin(star), 1e-3));
      const double bound = 2 * std::max(v - c, 0.0) * width / g + 10 * compliance / g + 1e-10;
      CHECK(rigid.add(m.share(motor, v), expected, bound) <= 1);
    }
    const double free = metric(motor, Metric::no_load_speed) / motor.crest_speed();
    const double star = std::acos(free);
    // the same bound, below 1e-3 of g for all of these
    CHECK(rigid_free.add(std::sin(star) - star * c, g / 2, g / 2) <= 2e-3);
  }
  CHECK(rigid.holds());
  CHECK(rigid_free.holds());
}

TEST_CASE("soft layers carry the torque of a contact that sticks all through (T4.2, T4.5)",
          "[core][point][limit]") {
  // Stuck from entry on, h W eps = V0 (sin theta + sin phi) - U (theta + phi) and tau = G eps. Near the exit,
  // where mu p falls below the largest such traction, the layer slips and carries between 0 and tau. The
  // pressure being concave, that is at most a share tau / (mu p(0)) of phi: the bound below.
  Deviation soft("soft limit, in units of the traction that slips at the exit", 1);
  for (const double phi : {0.3, 1.0, 1.5}) {
    for (const double compliance : {1e2, 1e4}) {
      const ElasticMotor m = elastic_motor(phi, compliance);
      const Motor motor(m.design);
      const auto& d = m.design;
      const double wave_number = d.stator.wavelengths / d.stator.contact_radius;
      const double peak = d.layer.youngs_modulus * d.stator.amplitude / d.layer.thickness;
      const double track =
          d.stator.contact_radius * d.stator.contact_radius * d.stator.contact_width;
      const double crest = crest_speed_of(d) * d.stator.contact_radius;
      for (const double v : {0.0, 0.5 * std::cos(phi)}) {
        const double passing = 2 * kPi * d.stator.frequency + wave_number * v * crest;
        const double stress = *d.layer.given_shear_modulus * crest / (d.layer.thickness * passing);
        const double stuck = 2 * track * stress * phi * (std::sin(phi) - v * phi);
        const double largest = 2 * stress * (std::sin(phi) - v * phi);
        const double width = phi * largest / (d.friction.kinetic * peak * (1 - std::cos(phi)));
        CAPTURE(phi, compliance, v, stuck / m.full_torque());
        // and rounding of a torque that is small beside mu F_N r
        const double bound = track * largest * width + 1e-14 * m.full_torque();
        CHECK(soft.add(m.share(motor, v) * m.full_torque(), stuck, bound) <= 1);
        // The bound means something: width / phi = 2 (sin phi - v phi) / (compliance (1 - cos phi)), which
        // is largest for phi = 0.3 at rest and compliance 100: 0.132.
        CHECK(bound <= 0.14 * stuck);
      }
    }
  }
  CHECK(soft.holds());
}

TEST_CASE("where the whole contact slips one way the torque is that of Coulomb (C8.1)",
          "[core][point][closed_form]") {
  Deviation coulomb("torque where the whole contact slips one way, of mu F_N r", 1e-12);
  Uniform random(77);
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    const Motor motor(realistic_design(random));
    const double speed = motor.crest_speed() * random(-0.3, 1.5);
    const auto zones = motor.zones(speed);
    if (zones.size() != 1 || zones[0].state == ZoneState::stick) continue;
    ++found;
    const auto& d = motor.design();
    const double expected = d.friction.kinetic * d.preload * d.stator.contact_radius *
                            (zones[0].state == ZoneState::slip_plus ? 1 : -1);
    // the pressure's integral against the preload: rounding of the half angle, amplified by 3
    CHECK(coulomb.add(motor.operating_point(speed).torque, expected, std::abs(expected)) <= 1e-12);
  }
  CHECK(found > 100);
  CHECK(coulomb.holds());
}

TEST_CASE("elastic torque is smooth in speed: slope and curvature vanish at the plateau's end",
          "[core][point][closed_form]") {
  const ElasticMotor m = elastic_motor(0.8, 0.2);
  const Motor motor(m.design);
  const double end = plateau_end(m);
  // 1 - T leaves like the cube of the distance: halving it divides by eight, to first order in it.
  const double far = 1 - m.share(motor, end + 2e-3);
  const double near = 1 - m.share(motor, end + 1e-3);
  Deviation cubic("elastic torque leaves the plateau as the cube, ratio 8 at twice the distance",
                  0.02);
  CHECK(cubic.add(far / near, 8, 8) <= 0.02);
  // and full braking is reached quadratically
  const double begin = braking_begin(m);
  const double wide = 1 + m.share(motor, begin - 2e-3);
  const double tight = 1 + m.share(motor, begin - 1e-3);
  Deviation square("elastic torque reaches full braking as the square, ratio 4", 0.05);
  CHECK(square.add(wide / tight, 4, 4) <= 0.05);
}
