// SPDX-License-Identifier: Apache-2.0
// Answers of the core on designs drawn from the box of theory section 10 and from realistic motors, for
// scripts/mutate.py: does a change that no test noticed alter an answer, or only the way there? Writes pairs
// of doubles, value and allowed difference, to standard output: always the same ones for the same core.
//
//   twum_answers [DESIGNS]      300 by default
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <twum/core/performance/metrics.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

namespace {

using namespace twum;
using namespace twum::test;

constexpr int kSpeeds = 5;
constexpr int kMetricsEvery = 12;    // designs of which one is asked all metrics
constexpr int kGradientsEvery = 36;  // and one their gradients

void put(double value, double allowed) {
  const double pair[2]{value, allowed};
  std::fwrite(pair, sizeof(double), 2, stdout);
}

// 1e-9 of the value; 1e-10 of the scale is what rounding may cost the laws (broken_law).
void put_number(double value, double scale) { put(value, 1e-9 * std::abs(value) + 1e-10 * scale); }

// What a search finds: a speed at which something is largest is known to half the digits of what it is
// largest of, so 1e-7 of the value and 1e-9 of the scale.
void put_searched(double value, double scale) { put(value, 1e-7 * std::abs(value) + 1e-9 * scale); }

template <typename Status>
void put_status(Status status) {
  put(static_cast<double>(status), 0);
}

double rubbed_area(const Motor& motor) {
  const auto& stator = motor.design().stator;
  return 2 * std::numbers::pi * stator.contact_radius * stator.contact_width;
}

void put_point(const Motor& motor, const OperatingPoint& point) {
  const double power = power_scale(motor, point.speed);
  put_status(point.status);
  put_number(point.torque, torque_scale(motor.design()));
  for (const double each :
       {point.output_power, point.stator_power, point.friction_power, point.layer_loss})
    put_number(each, power);
  put_number(point.stator_loss, 0);
  put_number(point.wear_intensity, power / rubbed_area(motor));
  put_number(point.stick_fraction, 1);
}

void put_zones(const Motor& motor, double speed) {
  for (const Zone& zone : motor.zones(speed)) {
    put_status(zone.state);
    put_number(zone.from, 1);
    put_number(zone.to, 1);
  }
}

void put_slopes(const Motor& motor, double speed) {
  const SpeedDerivative slopes = differentiate_in_speed(motor, speed);
  const double unit = torque_scale(motor.design());
  put_status(slopes.smoothness);
  put_number(slopes.torque, unit / motor.crest_speed());
  for (const double each :
       {slopes.output_power, slopes.stator_power, slopes.friction_power, slopes.layer_loss})
    put_number(each, unit);
  put_number(slopes.stick_fraction, 1 / motor.crest_speed());
}

void put_fields(const Motor& motor, double speed) {
  const ContactFields fields = motor.fields(speed, 16);
  for (const FieldSample& sample : fields.samples) {
    for (const double each : {sample.phase, sample.pressure, sample.traction, sample.displacement,
                              sample.stator_velocity, sample.layer_velocity})
      put_number(each, 0);
  }
}

std::vector<MetricRequest> requests(const Motor& motor) {
  std::vector<MetricRequest> all;
  for (const MetricInfo& row : metric_table()) {
    const bool load = row.argument == Argument::torque;
    all.push_back({row.metric,
                   row.argument == Argument::none ? Argument::none
                   : load                         ? Argument::torque
                                                  : Argument::speed,
                   load ? 0.3 * motor.holding_torque() : 0.4 * motor.crest_speed()});
  }
  return all;
}

// How large a number of this unit may be.
double scale_of(std::string_view unit, const Motor& motor) {
  const double power = power_scale(motor, 0);
  if (unit == "1") return 1;
  if (unit == "N.m") return torque_scale(motor.design());
  if (unit == "rad/s") return motor.crest_speed();
  if (unit == "W") return power;
  if (unit == "W/m^2") return power / rubbed_area(motor);
  return 0;
}

void put_metrics(const Motor& motor) {
  const auto all = requests(motor);
  const auto found = evaluate(motor, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    put_status(found[i].status);
    put_searched(found[i].value, scale_of(info(all[i].metric).unit, motor));
  }
}

void put_gradients(const Motor& motor) {
  const auto all = requests(motor);
  const auto found = differentiate(motor, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double scale = scale_of(info(all[i].metric).unit, motor);
    put_status(found[i].smoothness);
    for (const ParameterInfo& row : parameter_table()) {
      const double at = std::abs(get(motor.design(), row.parameter));
      put_searched(found[i].gradient[index_of(row.parameter)], at == 0 ? 0 : scale / at);
    }
  }
}

void put_design(int i, const MotorDesign& design, const double* speeds) {
  const Motor motor(design);
  put_number(motor.contact().half_angle, 0);
  put_number(motor.holding_torque(), 0);
  for (int j = 0; j < kSpeeds; ++j) {
    put_point(motor, motor.operating_point(speeds[j]));
    put_zones(motor, speeds[j]);
  }
  put_slopes(motor, speeds[i % kSpeeds]);
  if (i % kMetricsEvery == 0) put_metrics(motor), put_fields(motor, speeds[1]);
  if (i % kGradientsEvery == 0) put_gradients(motor);
}

// Every other design is realistic; a speed of the box is kept with its design.
void put_all(int count) {
  Uniform random(7);
  for (int i = 0; i < count; ++i) {
    const BoxPoint box = random_box_point(random);
    const MotorDesign design = i % 2 == 0 ? box.design : realistic_design(random);
    const double crest = crest_speed_of(design);
    double speeds[kSpeeds]{0, random(0.05, 0.95) * crest, random(0.05, 0.95) * crest,
                           random(1, 1.3) * crest, random(-0.1, 0) * crest};
    if (i % 2 == 0) speeds[2] = box.speed;
    try {
      put_design(i, design, speeds);
    } catch (const std::exception&) {
      put(std::numeric_limits<double>::infinity(), 0);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  put_all(count > 1 ? std::atoi(arguments[1]) : 300);
  return 0;
}
