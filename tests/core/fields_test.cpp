// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/contact_problem.hpp"
#include "support/deviations.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

// Fields along one wave against the laws they must obey at every phase.
namespace {

using namespace twum;
using namespace twum::test;

struct Probe {
  const char* name;
  MotorDesign design;
  std::vector<double> speeds;  // in units of V0 / r
};

MotorDesign with_threshold(MotorDesign design, double ratio) {
  design.friction.threshold = ratio * design.friction.kinetic;
  return design;
}

// Full contact and soft in shear: at rest the layer follows the wave all round.
MotorDesign locked_motor() {
  MotorDesign design = damped(ring_motor());
  design.layer.given_shear_modulus = 1e7;
  return at_load(design, 8);
}

std::vector<Probe> probes() {
  const std::vector<double> speeds{0.0, 0.8, 0.93, 1.1};
  return {{"inertial", ring_motor(), speeds},
          {"damped", damped(ring_motor()), speeds},
          {"elastic", elastic(ring_motor()), speeds},
          {"inertial, threshold", with_threshold(at_load(ring_motor(), 0.3), 1.5), speeds},
          {"damped, threshold", with_threshold(at_load(damped(ring_motor()), 0.3), 1.5), speeds},
          {"elastic, threshold", with_threshold(at_load(elastic(ring_motor()), 0.15), 1.5), speeds},
          {"full contact", at_load(ring_motor(), 1.5), {0.1, 0.5, 1.1}}};
}

template <typename Check>
void for_each_probe(int samples, Check check) {
  for (const Probe& probe : probes()) {
    const Motor motor(probe.design);
    for (const double share : probe.speeds) {
      const double speed = share * motor.crest_speed();
      CAPTURE(probe.name, share);
      const ContactFields fields = motor.fields(speed, samples);
      REQUIRE(fields.point.status == PointStatus::ok);
      REQUIRE(fields.samples.size() == static_cast<std::size_t>(samples));
      check(motor, fields);
    }
  }
}

const Zone* zone_at(const std::vector<Zone>& zones, double phase) {
  for (const Zone& zone : zones) {
    if (phase > zone.from && phase < zone.to) return &zone;
  }
  return nullptr;
}

// The trapezoidal rule over the wave, from -pi to pi inclusive.
template <typename Integrand>
double mean(const ContactFields& fields, Integrand integrand) {
  double sum = (integrand(fields.samples.front()) + integrand(fields.samples.back())) / 2;
  for (std::size_t i = 1; i + 1 < fields.samples.size(); ++i) sum += integrand(fields.samples[i]);
  return sum / static_cast<double>(fields.samples.size() - 1);
}

}  // namespace

TEST_CASE("samples are equally spaced over one wave, both ends included",
          "[core][fields][identity]") {
  for_each_probe(100, [](const Motor&, const ContactFields& fields) {
    const double step = fields.samples[1].phase - fields.samples[0].phase;
    for (std::size_t i = 1; i < fields.samples.size(); ++i) {
      CHECK(fields.samples[i].phase - fields.samples[i - 1].phase == Approx(step).epsilon(1e-12));
    }
    CHECK(fields.samples.front().phase == -kPi);
    CHECK(fields.samples.back().phase == Approx(kPi).epsilon(1e-15));
  });
}

TEST_CASE("the point of the fields is the operating point", "[core][fields][identity]") {
  for_each_probe(16, [](const Motor& motor, const ContactFields& fields) {
    const auto point = motor.operating_point(fields.point.speed);
    CHECK(fields.point.torque == point.torque);
    CHECK(fields.point.friction_power == point.friction_power);
    CHECK(fields.zones.size() == motor.zones(fields.point.speed).size());
  });
}

TEST_CASE(
    "the fields' mean traction gives the torque, and their power the powers (T4.5, T7.2, T7.3)",
    "[core][fields][quadrature]") {
  constexpr int kSamples = 400000;
  Deviation torque("torque by quadrature of the fields, in units of the quadrature's error bound",
                   1);
  Deviation powers("powers by quadrature of the fields, in units of the quadrature's error bound",
                   1);
  for_each_probe(kSamples, [&](const Motor& motor, const ContactFields& fields) {
    const ContactProblem problem = contact_problem(motor.design(), fields.point.speed);
    const double wave = problem.track_area;
    // Each zone border may hide a jump of tau of up to 2 mu_0 p_max in one of the N intervals, which
    // the rule then misjudges by at most half the jump; smooth parts err by 1/N^2.
    const double borders = static_cast<double>(fields.zones.size()) + 2;
    const double peak = problem.threshold * motor.contact().max_pressure * wave;
    const double bound = borders * peak / kSamples;
    const double velocity = std::max(problem.crest_velocity, std::abs(problem.rotor_velocity));
    const double traction = wave * mean(fields, [](const FieldSample& s) { return s.traction; });
    torque.add(traction * problem.radius, fields.point.torque, bound * problem.radius);
    const double in =
        wave * mean(fields, [](const FieldSample& s) { return s.traction * s.stator_velocity; });
    powers.add(in, fields.point.stator_power, bound * velocity);
    const double slip = wave * mean(fields, [](const FieldSample& s) {
                          return -s.traction * (s.layer_velocity - s.stator_velocity);
                        });
    const bool snaps = problem.damping == 0 && problem.threshold > problem.kinetic;
    // the work of a snap is no integral; without damping it is what remains
    if (!snaps) powers.add(slip, fields.point.friction_power, 3 * bound * velocity);
    if (snaps) CHECK(slip <= fields.point.friction_power + 3 * bound * velocity);
    const double loss = wave * mean(fields, [&](const FieldSample& s) {
                          const double rate =
                              (s.layer_velocity - problem.rotor_velocity) / problem.strain_velocity;
                          return problem.damping * problem.strain_velocity * rate * rate;
                        });
    powers.add(loss, fields.point.layer_loss, 3 * bound * velocity);
  });
  CHECK(torque.holds());
  CHECK(powers.holds());
}

TEST_CASE("Coulomb's law holds at every phase (T4.2, T4.3)", "[core][fields][identity]") {
  Deviation law("Coulomb's law at the fields' samples", 1e-9);
  for_each_probe(5000, [&](const Motor& motor, const ContactFields& fields) {
    const auto& friction = motor.design().friction;
    const double peak = motor.contact().max_pressure;
    const double velocity = std::max(motor.crest_speed(), std::abs(fields.point.speed)) *
                            motor.design().stator.contact_radius;
    for (const FieldSample& s : fields.samples) {
      const Zone* zone = zone_at(fields.zones, s.phase);
      if (zone == nullptr) continue;
      // Tractions and velocities are sums of terms of the scale used here; borders are roots, known
      // to 1e-14 of a radian, across which tau changes by slopes of up to 1e4.
      const double slip = s.layer_velocity - s.stator_velocity;
      if (zone->state == ZoneState::stick) {
        law.add(slip, 0, velocity);
        law.add(std::max(std::abs(s.traction), friction.threshold * s.pressure),
                friction.threshold * s.pressure, peak);
      } else {
        const double sign = static_cast<double>(zone->state);
        law.add(s.traction, sign * friction.kinetic * s.pressure, peak);
        law.add(std::max(sign * slip, 0.0), 0, velocity);  // slip+ has v_rel < 0
      }
    }
  });
  CHECK(law.holds());
}

TEST_CASE("outside the contact nothing touches and nothing pulls", "[core][fields][identity]") {
  for_each_probe(1000, [](const Motor& motor, const ContactFields& fields) {
    if (motor.contact().full) return;
    int outside = 0;
    for (const FieldSample& s : fields.samples) {
      if (std::abs(s.phase) <= motor.contact().half_angle * (1 + 1e-12)) continue;
      ++outside;
      CHECK(s.pressure == 0);
      CHECK(s.traction == 0);
    }
    CHECK(outside > 0);
  });
}

TEST_CASE("pressure and stator velocity are those of the wave (T2.2, T3.1, T3.3)",
          "[core][fields][closed_form]") {
  for_each_probe(500, [](const Motor& motor, const ContactFields& fields) {
    const ContactProblem problem = contact_problem(motor.design(), fields.point.speed);
    const double peak = problem.pressure(0);
    for (const FieldSample& s : fields.samples) {
      const bool inside = problem.full || std::abs(s.phase) < problem.half_angle;
      // a few eps of terms of the scale
      CHECK(std::abs(s.pressure - (inside ? problem.pressure(s.phase) : 0.0)) <= 1e-13 * peak);
      CHECK(std::abs(s.stator_velocity - problem.crest_velocity * std::cos(s.phase)) <=
            1e-14 * problem.crest_velocity);
    }
  });
}

TEST_CASE("displacement obeys the layer's equation by finite differences (T2.3, T4.1)",
          "[core][fields][quadrature]") {
  constexpr int kSamples = 20000;
  Deviation equation("layer equation by finite differences", 1e-6);
  Deviation velocity("layer velocity by finite differences", 1e-7);
  for_each_probe(kSamples, [&](const Motor& motor, const ContactFields& fields) {
    const ContactProblem problem = contact_problem(motor.design(), fields.point.speed);
    const double h = motor.design().layer.thickness;
    const double d = 2 * kPi / (kSamples - 1);
    const double stress = problem.threshold * problem.pressure(0);
    const double speed = std::max(problem.crest_velocity, std::abs(problem.rotor_velocity));
    const auto& s = fields.samples;
    for (std::size_t i = 3; i + 3 < s.size(); ++i) {
      const Zone* zone = zone_at(fields.zones, s[i].phase);
      // all five points in one zone, or all outside
      if (zone_at(fields.zones, s[i - 3].phase) != zone ||
          zone_at(fields.zones, s[i + 3].phase) != zone)
        continue;
      const auto q = [&](std::size_t k) { return s[k].displacement / h; };
      const double first = (8 * (q(i + 1) - q(i - 1)) - (q(i + 2) - q(i - 2))) / (12 * d);
      const double second =
          (16 * (q(i + 1) + q(i - 1)) - (q(i + 2) + q(i - 2)) - 30 * q(i)) / (12 * d * d);
      // Truncation (w d)^4 / 30 of a layer w = 14 times faster than the wave, d = 3e-4: 1e-11. Right
      // after an event of a damped layer w = G / C = 20, the same. Rounding of eps' strain / d^2:
      // 16 eps M / (G d^2) = 2e-10 of the stress. Both are far below the tolerances, which allow for layers
      // that relax a hundred times faster.
      velocity.add(problem.rotor_velocity + problem.strain_velocity * first, s[i].layer_velocity,
                   speed);
      const double tau =
          problem.inertia * second + problem.damping * first + problem.stiffness * q(i);
      equation.add(tau, s[i].traction, stress);
    }
  });
  CHECK(equation.holds());
  CHECK(velocity.holds());
}

TEST_CASE(
    "displacement is continuous where damping or inertia keep it so, periodic included (T2.3)",
    "[core][fields][identity]") {
  constexpr int kSamples = 20000;
  for_each_probe(kSamples, [](const Motor& motor, const ContactFields& fields) {
    const ContactProblem problem = contact_problem(motor.design(), fields.point.speed);
    if (problem.damping == 0) return;
    // Between neighbours it changes by (v_r - U) / W times the step at most, plus half as much
    // again for a velocity that jumps in between.
    const double step = 2 * kPi / (kSamples - 1);
    const double rate = problem.strain_velocity / motor.design().layer.thickness;  // W
    double fastest = 0;
    for (const auto& s : fields.samples) {
      fastest = std::max(fastest, std::abs(s.layer_velocity - problem.rotor_velocity));
    }
    for (std::size_t i = 0; i < fields.samples.size(); ++i) {
      const auto& next = fields.samples[(i + 1) % fields.samples.size()];
      REQUIRE(std::abs(next.displacement - fields.samples[i].displacement) <=
              2 * fastest / rate * step + 1e-18);
    }
  });
}

TEST_CASE("a layer that is locked at rest sticks all round", "[core][fields][limit]") {
  const Motor motor(locked_motor());
  REQUIRE(motor.locks_at_rest());
  constexpr int kSamples = 101;
  const ContactFields fields = motor.fields(0.0, kSamples);
  REQUIRE(fields.zones.size() == 1);
  CHECK(fields.zones[0].state == ZoneState::stick);
  CHECK(fields.zones[0].from == Approx(-kPi).epsilon(1e-15));
  CHECK(fields.zones[0].to == Approx(kPi).epsilon(1e-15));
  const ContactProblem problem = contact_problem(motor.design(), 0.0);
  const auto& s = fields.samples;
  const double d = 2 * kPi / (kSamples - 1);
  const double stress = problem.threshold * problem.pressure(0);
  for (std::size_t i = 0; i < s.size(); ++i) {
    CHECK(s[i].layer_velocity == s[i].stator_velocity);
    CHECK(std::abs(s[i].traction) <= problem.threshold * s[i].pressure * (1 + 1e-12));
    if (i < 2 || i + 2 >= s.size()) continue;
    const auto q = [&](std::size_t k) {
      return s[k].displacement / motor.design().layer.thickness;
    };
    const double first = (8 * (q(i + 1) - q(i - 1)) - (q(i + 2) - q(i - 2))) / (12 * d);
    const double second =
        (16 * (q(i + 1) + q(i - 1)) - (q(i + 2) + q(i - 2)) - 30 * q(i)) / (12 * d * d);
    // A sine wave: truncation d^4 / 30 = 5e-7 of its terms, rounding far below.
    CHECK(std::abs(problem.strain_velocity * first - s[i].layer_velocity) <=
          1e-6 * problem.crest_velocity);
    CHECK(std::abs(problem.inertia * second + problem.damping * first + problem.stiffness * q(i) -
                   s[i].traction) <= 1e-6 * stress);
  }
  // The rule over a whole wave is exact for a sine.
  const double traction = mean(fields, [](const FieldSample& sample) { return sample.traction; });
  CHECK(std::abs(traction * problem.track_area * problem.radius - fields.point.torque) <=
        1e-12 * stress * problem.track_area * problem.radius);
}

TEST_CASE("fields of full contact close: both ends are one place", "[core][fields][identity]") {
  Uniform random(91);
  for (int i = 0; i < 30; ++i) {
    MotorDesign design = realistic_design(random);
    if (i % 3 == 1) design = damped(design);
    if (i % 3 == 2) design = elastic(design);
    design.friction.threshold = design.friction.kinetic;  // no snap there
    design.preload = full_contact_load(design) * random(1.1, 3);
    const Motor motor(design);
    const double speed = random(0.1, 1.2) * motor.crest_speed();
    if (motor.operating_point(speed).status != PointStatus::ok) continue;
    const std::vector<FieldSample> samples = motor.fields(speed, 64).samples;
    const FieldSample &first = samples.front(), &last = samples.back();
    const double stress = design.friction.kinetic * motor.contact().max_pressure;
    const double velocity = design.stator.contact_radius * (motor.crest_speed() + speed);
    CAPTURE(i, design.preload, speed);
    // What the search for the periodic state leaves, in units of the largest traction.
    CHECK(std::abs(first.traction - last.traction) <= 1e-11 * stress);
    CHECK(std::abs(first.displacement - last.displacement) <=
          1e-11 * stress * design.layer.thickness / shear_modulus(design));
    if (i % 3 !=
        2) {  // an elastic layer's velocity is a slope of the traction, which may jump with a zone
      CHECK(std::abs(first.layer_velocity - last.layer_velocity) <= 1e-9 * velocity);
    }
  }
}

TEST_CASE("a layer that rings on in free flight comes to the next entry as it is there",
          "[core][fields][identity]") {
  MotorDesign design = ring_motor();
  design.layer.given_inertia = 5e-4;
  for (const double loss : {0.001, 0.01, 0.03}) {
    design.layer.loss_factor = loss;
    const Motor motor(design);
    const double entry = -motor.contact().half_angle;
    REQUIRE(entry > -3.0);
    const int count = 20'001;
    const std::vector<FieldSample> samples = motor.fields(0.8 * motor.crest_speed(), count).samples;
    double largest = 0;
    for (const FieldSample& s : samples) largest = std::max(largest, std::abs(s.displacement));
    const FieldSample &first = samples.front(), &last = samples.back();
    CAPTURE(loss, first.displacement / largest);
    CHECK(std::abs(first.displacement) > 1e-6 * largest);  // it does ring
    CHECK(std::abs(first.displacement - last.displacement) <= 1e-11 * largest);
    // From one sample to the next, the entry between them, it moves no further than its velocity leads: by
    // 2 pi / count times a few natural frequencies of the layer in units of the wave's.
    const auto after = std::find_if(samples.begin(), samples.end(),
                                    [&](const FieldSample& s) { return s.phase > entry; });
    REQUIRE(after != samples.begin());
    CHECK(std::abs(after->displacement - std::prev(after)->displacement) <= 0.05 * largest);
  }
}
