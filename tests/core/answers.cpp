// SPDX-License-Identifier: Apache-2.0
// Answers of the core on designs drawn from the box of theory section 10 and from realistic motors. Two builds that
// write the same numbers, each within its allowed difference, give the same answers.
//
//   twum_core_answers [DESIGNS]      300 by default
#include "support/answers.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <twum/core/metrics.hpp>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <limits>
#include <numbers>
#include <vector>

namespace {

using namespace twum;
using namespace twum::test;

constexpr int kSpeeds = 5;
// Designs of which one is asked all metrics, odd since every other is realistic.
constexpr int kMetricsEvery = 5;
constexpr int kGradientsEvery = 15;  // and one their gradients

// 1e-9 of the value; 1e-10 of the scale is what rounding may cost the laws (broken_law).
void put_number(double value, double scale) { test::put_number(value, 1e-9, 1e-10 * scale); }

void put_point(const Motor& motor, const OperatingPoint& point) {
  const double power = power_scale(motor, point.speed);
  put_status(point.status);
  put_number(point.torque, torque_scale(motor.design()));
  for (const double each :
       {point.output_power, point.stator_power, point.friction_power, point.layer_loss})
    put_number(each, power);
  put_number(point.stator_loss, 0);
  const auto& stator = motor.design().stator;
  put_number(point.wear_intensity,
             power / (2 * std::numbers::pi * stator.contact_radius * stator.contact_width));
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

// A field of a few samples, rounding of the largest of them in all.
template <typename Member>
void put_field(const std::vector<FieldSample>& samples, Member member) {
  double largest = 0;
  for (const FieldSample& sample : samples) largest = std::fmax(largest, std::abs(sample.*member));
  for (const FieldSample& sample : samples) put_number(sample.*member, largest);
}

void put_fields(const Motor& motor, double speed) {
  const std::vector<FieldSample> samples = motor.fields(speed, 16).samples;
  for (const auto member :
       {&FieldSample::phase, &FieldSample::pressure, &FieldSample::traction,
        &FieldSample::displacement, &FieldSample::stator_velocity, &FieldSample::layer_velocity})
    put_field(samples, member);
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

// A maximum at a jump is found between neighbouring numbers, beyond which torque moves like a square root:
// good to 1e-8, and to a hundred times that where a slope follows.
void put_searched(double value, double scale) { test::put_number(value, 1e-6, 1e-6 * scale); }

void put_metrics(const Motor& motor) {
  for (const MetricValue& each : evaluate(motor, requests(motor))) {
    put_status(each.status);
    put_searched(each.value, 0);
  }
}

void put_gradients(const Motor& motor) {
  for (const MetricDerivative& each : differentiate(motor, requests(motor))) {
    // Which of two equal maxima is taken, and so on which side a kink is, may be a matter of rounding.
    put_status(each.smoothness == Smoothness::undefined);
    for (const ParameterInfo& row : parameter_table()) {
      const double at = get(motor.design(), row.parameter);
      put_searched(each.gradient[index_of(row.parameter)],
                   at == 0 ? 0 : std::abs(each.value.value / at));
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
    MotorDesign design = i % 2 == 0 ? box.design : realistic_design(random);
    if (design.stator.modal_damping == 0) design.stator.modal_damping = 45;
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
