// SPDX-License-Identifier: Apache-2.0
#include "support/constants.hpp"
#include "support/deviations.hpp"
#include "support/driven_motors.hpp"
#include "support/two_modes.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>

// Backward waves, forced and free, against an integration in time of the two modes, and against closed forms.
namespace {

using namespace twum;
using namespace twum::test;

MetricValue at_speed(const MotorDesign& design, Metric metric, double speed) {
  return evaluate(Motor(design), {metric, Argument::speed, speed});
}

double value(const MotorDesign& design, Metric metric, double speed) {
  const MetricValue found = at_speed(design, metric, speed);
  REQUIRE(found.status == MetricStatus::ok);
  return found.value;
}

// Growth of a small backward wave beside the steady forward one [1/s].
double growth_seen(const MotorDesign& design, double speed) {
  constexpr int kBetween = 24, kLooked = 8;  // periods
  const OperatingPoint p = Motor(design).operating_point(speed);
  TwoModes modes(design, speed);
  modes.damp_backward_waves(400);  // while the forward wave settles
  modes.set_wave(p.amplitude, p.phase_lag);
  modes.run(250);
  modes.damp_backward_waves(0);
  modes.add_backward_wave(0.01 * p.amplitude);
  modes.run(kLooked);
  const double before = modes.any_backward();
  modes.run(kBetween);
  modes.run(kLooked);
  return std::log(modes.any_backward() / before) * design.stator.frequency / (kBetween + kLooked);
}

MotorDesign with_imbalance(const Imbalance& imbalance, double rotor_mass) {
  MotorDesign design = driven_motor();
  design.stator.imbalance = imbalance;
  if (rotor_mass > 0) design.rotor.mass = rotor_mass;
  return design;
}

// The same contact under a given wave, of a stator of which nothing is known.
MotorDesign without_modal_data(MotorDesign design, double amplitude) {
  Stator& s = design.stator;
  s.amplitude = amplitude, s.blocked_capacitance = s.loss_tangent = 0;
  s.voltage.reset(), s.modal_mass.reset(), s.resonance_frequency.reset(), s.force_factor.reset();
  return design;
}

TwoModes settled(const MotorDesign& design, double speed) {
  const OperatingPoint p = Motor(design).operating_point(speed);
  TwoModes modes(design, speed);
  modes.set_wave(p.amplitude, p.phase_lag);
  modes.run(400);
  modes.run(50);  // the mean of these
  return modes;
}

}  // namespace

TEST_CASE(
    "free backward waves of two modes grow where the squeal rate is positive (D6.2 to D6.4, D6.7)",
    "[core][driven][backward][brute_force]") {
  int growing = 0;
  Deviation signs("sign of the squeal rate against free waves of two modes", 0);
  for (const double mass : {0.0, 0.1}) {
    for (const double speed : {2.0, 4.0, 6.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0}) {
      MotorDesign design = driven_motor();
      if (mass > 0) design.rotor.mass = mass;
      const double rate = value(design, Metric::squeal_rate_at, speed);
      const double seen = growth_seen(design, speed);
      CAPTURE(mass, speed, rate, seen);
      CHECK(signs.add(rate > 0, seen > 0, 1) == 0);
      // Averaging leaves the ratio of the rates to the beat's frequency, 2 pi 80 kHz, times some ten; waves of 1 % are no
      // longer small where zones come and go, at the ends of the curve; the integration's own error is 1e-3 of omega d_s.
      if (speed < 14) CHECK(seen == Approx(rate).epsilon(0.05).margin(40));
      growing += rate > 0;
    }
  }
  CHECK(growing == 6);
}

TEST_CASE("unequal phases and modes force the backward wave of two modes (D6.1, D6.5)",
          "[core][driven][backward][brute_force]") {
  struct Case {
    Imbalance imbalance;
    double mass, tolerance;
  };
  // What averaging and the first order leave: 0.6 % with a rotor that follows at once, 4 % with one that hardly does.
  const Case cases[] = {{{1.05, 0, 0}, 0, 6e-3},   {{1, 0.05, 0}, 0, 6e-3},
                        {{1, 0, 5e-4}, 0, 6e-3},   {{0.95, -0.03, 5e-4}, 0, 6e-3},
                        {{1.05, 0, 0}, 0.1, 4e-2}, {{1, 0.05, 0}, 0.1, 4e-2},
                        {{1, 0, 5e-4}, 0.1, 4e-2}, {{0.97, 0.04, -3e-4}, 0.4, 4e-2}};
  Deviation light("forced backward wave, light rotor, against two modes", 6e-3),
      heavy("forced backward wave, heavy rotor, against two modes", 4e-2);
  for (const Case& c : cases) {
    const MotorDesign design = with_imbalance(c.imbalance, c.mass);
    const TwoModes modes = settled(design, 11);
    const OperatingPoint p = Motor(design).operating_point(11);
    CAPTURE(c.imbalance.voltage_ratio, c.imbalance.phase_error, c.imbalance.mode_splitting, c.mass);
    const double seen = modes.forced_backward() / std::abs(modes.wave());
    CHECK(
        (c.mass > 0 ? heavy : light).add(value(design, Metric::backward_ratio_at, 11), seen, seen) <
        c.tolerance);
    // Of the forward wave the second order is left, (2 %)^2.
    CHECK(std::abs(modes.wave()) == Approx(p.amplitude).epsilon(2e-3));
  }
}

TEST_CASE("a motor driven the other way is the mirrored motor", "[core][driven][brute_force]") {
  // The second phase with its sign turned, the rotor at the opposite speed. Both begin at rest, and their places mirror each
  // other, so that they differ by rounding alone, which the steady state forgets.
  Deviation mirror("mirrored drive of two modes, amplitude and torque", 1e-9),
      model("mirrored two modes against the model", 2e-3);
  constexpr double kSpeed = 11;
  const MotorDesign design = driven_motor(140);  // starts by itself
  MotorDesign mirrored = design;
  mirrored.stator.imbalance = Imbalance{1, kPi, 0};
  TwoModes forward(design, kSpeed), backward(mirrored, -kSpeed);
  for (TwoModes* modes : {&forward, &backward}) modes->run(400), modes->run(20);
  const double amplitude = std::abs(forward.wave());
  CHECK(mirror.add(backward.forced_backward(), amplitude, amplitude) < 1e-9);
  CHECK(mirror.add(-backward.torque(), forward.torque(), std::fabs(forward.torque())) < 1e-9);
  // The integration errs by 1e-3 of the drive's force.
  const OperatingPoint p = Motor(design).operating_point(kSpeed);
  CHECK(model.add(backward.forced_backward(), p.amplitude, p.amplitude) < 2e-3);
  CHECK(model.add(-backward.torque(), p.torque, Motor(design).holding_torque()) < 2e-3);
}

TEST_CASE("each phase has its own current (D6.6)", "[core][driven][backward][identity]") {
  // Both phases together take the power of the terminals, each half of Re u conj(I); here by their sizes alone: without
  // imbalance both are the larger one, and with a larger voltage the first has more of the capacitance's share.
  const Motor equal(driven_motor());
  const BackwardWave none = equal.backward_wave(11);
  CHECK(none.ratio == 0);
  CHECK(none.standing_wave_ratio == 1);
  const double current = equal.operating_point(11).phase_current;
  CHECK(none.first_current == Approx(current).epsilon(1e-12));
  CHECK(none.second_current == Approx(current).epsilon(1e-12));
  for (const double ratio : {0.9, 1.1}) {
    const Motor motor(with_imbalance({ratio, 0, 0}, 0));
    const BackwardWave wave = motor.backward_wave(11);
    CHECK((wave.second_current > wave.first_current) == (ratio > 1));
    CHECK(std::fmax(wave.first_current, wave.second_current) ==
          Approx(motor.operating_point(11).phase_current).epsilon(1e-12));
    CHECK(wave.standing_wave_ratio == Approx((1 + wave.ratio) / (1 - wave.ratio)).epsilon(1e-15));
    CHECK(wave.ratio ==
          Approx(value(motor.design(), Metric::backward_ratio_at, 11)).epsilon(1e-12));
  }
}

TEST_CASE("the damping that friction feeds decides over squeal (D6.8)",
          "[core][driven][backward][identity]") {
  for (const double mass : {0.0, 0.1}) {
    MotorDesign design = driven_motor();
    if (mass > 0) design.rotor.mass = mass;
    for (const double speed : {2.0, 4.0, 8.0, 11.0}) {
      const Motor motor(design);
      const BackwardWave wave = motor.backward_wave(speed);
      CHECK(wave.squeal_rate ==
            Approx(value(design, Metric::squeal_rate_at, speed)).epsilon(1e-12));
      // A stator with just this damping neither damps nor feeds the wave. The amplitude is held, so that only the damping moves.
      MotorDesign held = design;
      held.stator.amplitude = motor.operating_point(speed).amplitude;
      held.stator.voltage.reset();
      if (!(wave.fed_damping > 0)) continue;
      held.stator.modal_damping = wave.fed_damping;
      CHECK(std::fabs(Motor(held).backward_wave(speed).squeal_rate) <
            1e-9 * wave.fed_damping / *design.stator.modal_mass);
      // Without modal mass the wave is taken at the frequency of the drive, here 2 to 5 % above its own.
      const BackwardWave bare =
          Motor(without_modal_data(design, held.stator.amplitude)).backward_wave(speed);
      CHECK(bare.fed_damping == Approx(wave.fed_damping).epsilon(0.1));
      CHECK(std::isnan(bare.squeal_rate));
    }
  }
}

TEST_CASE("the current of unequal phases is that of the faster mode (D6.6)",
          "[core][driven][backward][brute_force]") {
  for (const Imbalance& imbalance : {Imbalance{1.05, 0.03, 0}, Imbalance{0.96, 0, 6e-4}}) {
    MotorDesign design = with_imbalance(imbalance, 0);
    design.stator.blocked_capacitance =
        0;  // then the current is charge per displacement times velocity
    const TwoModes modes = settled(design, 11);
    const double larger = std::max(modes.cosine_velocity(), modes.sine_velocity());
    CHECK(value(design, Metric::phase_current_at, 11) ==
          Approx(*design.stator.force_factor * larger).epsilon(2e-3));
    CHECK(std::fabs(modes.cosine_velocity() - modes.sine_velocity()) > 0.01 * larger);
  }
}

TEST_CASE("where all slips forward the squeal rate has a closed form (D6.7)",
          "[core][driven][backward][identity]") {
  // Holds for every layer.
  for (const MotorDesign& light : {driven_motor(), driven_motor_with_layer(110)}) {
    for (const double mass : {0.0, 0.1, 1e6}) {
      MotorDesign design = light;
      if (mass > 0) design.rotor.mass = mass;
      const Motor motor(design);
      const Stator& s = design.stator;
      const double angle = motor.contact().half_angle, sine = std::sin(angle);
      const double foundation = design.layer.youngs_modulus / design.layer.thickness;
      const double full = kPi * s.contact_radius * s.contact_width * foundation;
      const double axial = 2 * s.contact_radius * s.contact_width * angle * foundation;
      const double slope = s.neutral_plane_distance * s.wavelengths / s.contact_radius;
      const double stator = std::pow(2 * kPi * *s.resonance_frequency, 2) * *s.modal_mass;
      const auto stiffness_at = [&](double omega) {
        const double beat = 2 * kPi * s.frequency + omega;
        const double follows = mass > 0 ? axial / (axial - mass * beat * beat) : 1;
        return full / kPi * (angle - follows * sine * sine / angle);
      };
      double omega = 2 * kPi * s.frequency, stiffness = 0;
      for (int i = 0; i < 60; ++i) {
        stiffness = stiffness_at(omega);
        omega = std::sqrt((stator + stiffness) / *s.modal_mass);
      }
      const double fed = slope * design.friction.kinetic * stiffness / omega;
      // Both are sums of a few terms; the iterations end at rounding.
      const double plateau = evaluate(motor, {Metric::plateau_speed}).value;
      REQUIRE(plateau > 0);
      CHECK(value(design, Metric::squeal_rate_at, 0.5 * plateau) ==
            Approx((fed - s.modal_damping) / (2 * *s.modal_mass)).epsilon(1e-9));
      // Without modal data at the frequency of the drive.
      const double driven = 2 * kPi * s.frequency;
      const MotorDesign bare =
          without_modal_data(design, motor.operating_point(0.5 * plateau).amplitude);
      CHECK(Motor(bare).backward_wave(0.5 * plateau).fed_damping ==
            Approx(slope * design.friction.kinetic * stiffness_at(driven) / driven).epsilon(1e-9));
    }
  }
}

TEST_CASE("the phases may change their names (D6.1, D6.5)", "[core][driven][backward][identity]") {
  // Seen from a quarter of a wave farther and a quarter of a period later the second phase is the first.
  const MotorDesign one = with_imbalance({1.06, 0.04, 3e-4}, 0.1);
  MotorDesign other = with_imbalance({1 / 1.06, -0.04, -3e-4}, 0.1);
  *other.stator.voltage = 1.06 * *one.stator.voltage;
  const double speed = 11;
  for (const Metric metric : {Metric::amplitude_at, Metric::torque_at, Metric::backward_ratio_at,
                              Metric::phase_current_at, Metric::electrical_power_at,
                              Metric::power_factor_at, Metric::squeal_rate_at})
    CHECK(value(one, metric, speed) == Approx(value(other, metric, speed)).epsilon(1e-9));
}

TEST_CASE("a narrow track of many slices answers a backward wave as one slice (D6.2, D6.4)",
          "[core][driven][backward][limit]") {
  MotorDesign one = unequal_motor();
  // Kept stiffness and load: the track is 40 times narrower, the layer 40 times thinner.
  one.stator.contact_width /= 40;
  one.layer.thickness /= 40;
  const MotorDesign many = with(one, Parameter::radial_slices, 4);
  for (const double speed : {2.0, 11.0}) {
    // Radii differ by b / r = 4e-3, and the sums are even in the distance from the middle.
    CHECK(value(many, Metric::squeal_rate_at, speed) ==
          Approx(value(one, Metric::squeal_rate_at, speed)).epsilon(1e-3));
    CHECK(value(many, Metric::backward_ratio_at, speed) ==
          Approx(value(one, Metric::backward_ratio_at, speed)).epsilon(1e-3));
  }
}

TEST_CASE("a backward wave that is not known has a status", "[core][driven][backward][edge]") {
  const MotorDesign lossy = unequal_motor(driven_motor_with_layer());
  for (const Metric metric :
       {Metric::squeal_rate_at, Metric::backward_ratio_at, Metric::phase_current_at})
    CHECK(at_speed(lossy, metric, 11).status == MetricStatus::backward_wave_unknown);
  const OperatingPoint p = Motor(lossy).operating_point(11);
  CHECK(p.status == PointStatus::ok);
  CHECK(std::isnan(p.phase_current));
  CHECK(std::isfinite(p.electrical_power));
  // On the plateau it is known for every layer, and equal phases need not know it.
  CHECK(at_speed(lossy, Metric::backward_ratio_at, 1).status == MetricStatus::ok);
  CHECK(value(driven_motor_with_layer(), Metric::backward_ratio_at, 11) == 0);
  CHECK(at_speed(ring_motor(), Metric::squeal_rate_at, 1).status == MetricStatus::undefined);
}

TEST_CASE("a sensor follows the wave's charge into its load (D7.1)",
          "[core][driven][sensor][limit]") {
  MotorDesign design = driven_motor();
  Sensor sensor{0.03, 0.5e-9, 0.2e-9, {}, 0.4};
  design.stator.sensor = sensor;
  const OperatingPoint p = Motor(design).operating_point(9);
  const double omega = 2 * kPi * design.stator.frequency, rms = std::sqrt(0.5);
  // Open: charge over capacitance, against the wave there.
  CHECK(value(design, Metric::sensor_voltage_at, 9) ==
        Approx(rms * 0.03 * p.amplitude / 0.7e-9).epsilon(1e-12));
  CHECK(std::remainder(value(design, Metric::sensor_phase_at, 9) - (p.phase_lag + 0.4 + kPi),
                       2 * kPi) == Approx(0).margin(1e-12));
  // Of the other sign, and half a wave farther.
  design.stator.sensor->force_factor = -0.03;
  CHECK(std::remainder(value(design, Metric::sensor_phase_at, 9) - (p.phase_lag + 0.4), 2 * kPi) ==
        Approx(0).margin(1e-12));
  // Into a small resistance the charge flows as it comes: a quarter of a turn earlier.
  sensor.load_resistance = 1e-3;
  design.stator.sensor = sensor;
  CHECK(value(design, Metric::sensor_voltage_at, 9) ==
        Approx(rms * 0.03 * p.amplitude * omega * 1e-3).epsilon(1e-12));
  // omega R C is 2e-7.
  CHECK(std::remainder(value(design, Metric::sensor_phase_at, 9) - (p.phase_lag + 0.4 + kPi / 2),
                       2 * kPi) == Approx(0).margin(1e-6));
  CHECK(at_speed(driven_motor(), Metric::sensor_voltage_at, 9).status == MetricStatus::undefined);
  CHECK_THROWS_AS(with(driven_motor(), Parameter::sensor_position, 1.0), InputError);
}
