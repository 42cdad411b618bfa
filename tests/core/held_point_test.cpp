// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/held_point.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include "support/driven_motors.hpp"
#include "support/metric_requests.hpp"
#include "support/plate_motors.hpp"

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace twum;

namespace {

// A row of a table with words in it.
class Case {
 public:
  explicit Case(std::map<std::string, std::string> cells) : cells_(std::move(cells)) {}
  const std::string& word(const std::string& name) const { return cells_.at(name); }
  double operator[](const std::string& name) const { return std::stod(cells_.at(name)); }
  bool has(const std::string& name) const {
    const auto found = cells_.find(name);
    return found != cells_.end() && !found->second.empty();
  }

 private:
  std::map<std::string, std::string> cells_;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line.substr(0, line.find('\r')));
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<Case> cases(const std::string& name) {
  std::ifstream file(std::string(TWUM_TEST_DATA "/reference/") + name);
  std::string line;
  REQUIRE(std::getline(file, line));
  const std::vector<std::string> names = cells_of(line);
  std::vector<Case> list;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cells_of(line);
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = i < cells.size() ? cells[i] : "";
    list.emplace_back(std::move(row));
  }
  return list;
}

MotorDesign design_of(const Case& c) {
  MotorDesign design;
  Stator& s = design.stator;
  s.wavelengths = c["wavelengths"], s.contact_radius = c["contact_radius"];
  s.contact_width = c["contact_width"], s.neutral_plane_distance = c["neutral_plane_distance"];
  s.resonance_frequency = c["resonance_frequency"], s.modal_mass = c["modal_mass"];
  s.modal_damping = c["modal_damping"], s.force_factor = c["force_factor"];
  s.blocked_capacitance = c["blocked_capacitance"], s.loss_tangent = c["loss_tangent"];
  // Where the frequency follows, the file's one only begins the search.
  s.frequency = c.has("frequency") ? c["frequency"] : 1.03 * c["resonance_frequency"];
  s.voltage = c.has("voltage") ? c["voltage"] : c["held_voltage_V"];
  design.layer.thickness = c["thickness"], design.layer.youngs_modulus = c["youngs_modulus"];
  design.layer.given_shear_modulus = c["shear_modulus"];
  design.layer.given_shear_viscosity = c["shear_viscosity"];
  design.layer.given_inertia = c["inertia"];
  design.friction = {c["kinetic_friction"], c["static_friction"]};
  design.preload = c["preload"];
  return design;
}

double apart(double found, double right) { return std::fabs(found - right) / std::fabs(right); }

// The second program prints sixteen digits of amplitude, frequency and voltage and is good to 1e-8 of them, with mu_0 > mu to
// 1e-7; to 1e-7 of powers and currents (tests/data/reference/README.md).
void check_wave(const Case& c, const HeldPoint& held, double tolerance) {
  CHECK(apart(held.amplitude, c["amplitude_m"]) <= tolerance);
  CHECK(apart(held.frequency, c["held_frequency_Hz"]) <= tolerance);
  CHECK(apart(held.voltage, c["held_voltage_V"]) <= tolerance);
  CHECK(apart(held.point.electrical_power, c["electrical_power_W"]) <= 10 * tolerance);
  CHECK(apart(held.point.phase_current, c["phase_current_A"]) <= 10 * tolerance);
  CHECK(std::fabs(held.point.phase_lag - c["phase_lag_rad"]) <= 1e-6);
  const double largest = c["kinetic_friction"] * c["preload"] * c["contact_radius"];
  CHECK(std::fabs(held.point.torque - c["load_torque_Nm"]) <= 1e-10 * largest);
}

}  // namespace

TEST_CASE("held points are those of a second program (Y2.1, Y2.2, Y2.3)",
          "[core][held][differential]") {
  int row = 1;
  for (const Case& c : cases("held.csv")) {
    CAPTURE(++row, c.word("kind"), c.word("control"), c.word("status"));
    const DriveControl control =
        c.word("control") == "voltage" ? DriveControl::voltage : DriveControl::frequency;
    const HeldPoint held = held_point(design_of(c), c["load_torque_Nm"], c["speed_rad_s"], control);
    CHECK(to_string(held.status) == c.word("status"));
    if (c.word("status") == "ok") {
      check_wave(c, held, c.word("kind") == "st" ? 1e-7 : 1e-8);
      CHECK(held.by_control_only == (c.word("stable_under_constant_torque") == "0"));
    }
    if (c.word("status") == "voltage-too-low")
      CHECK(apart(held.needed, c["voltage_needed_V"]) <= 1e-8);
    if (c.word("status") == "torque-out-of-reach" && c.word("kind") != "st")
      CHECK(apart(held.needed, c["plateau_torque_Nm"]) <= 1e-10);
  }
  CHECK(row == 155);
}

TEST_CASE("of several amplitudes that carry a torque the smallest is the answer (Y2.1)",
          "[core][held][differential]") {
  for (const Case& c : cases("held_ripple.csv")) {
    CAPTURE(c.word("all_roots_m"));
    const HeldPoint held =
        held_point(design_of(c), c["load_torque_Nm"], c["speed_rad_s"], DriveControl::frequency);
    REQUIRE(to_string(held.status) == c.word("status"));
    check_wave(c, held, 1e-8);
  }
}

TEST_CASE("a held wave put back carries its torque (Y2.1)", "[core][held][identity]") {
  const MotorDesign drive = test::driven_motor_with_layer();
  for (const double torque : {-1.0, -0.5, -0.1, 0.0, 0.3, 0.6}) {
    for (const double speed : {2.0, 8.0, 14.0}) {
      for (const DriveControl control :
           {DriveControl::amplitude, DriveControl::voltage, DriveControl::frequency}) {
        CAPTURE(torque, speed, static_cast<int>(control));
        const HeldPoint held = held_point(drive, torque, speed, control);
        if (held.status != HeldStatus::ok) continue;
        const OperatingPoint again = Motor(with_held_wave(drive, held)).operating_point(speed);
        // The amplitude is right to 1e-13, and the torque changes by some times its scale for one part of the amplitude.
        CHECK(std::fabs(again.torque - torque) <= 1e-11);
        CHECK(apart(again.voltage, held.voltage) <= 1e-11);
      }
    }
  }
}

TEST_CASE("metrics at a torque and a speed are those of the motor under the held wave (Y2.5)",
          "[core][held][identity]") {
  MotorDesign design = test::driven_motor_with_layer();
  for (const DriveControl control : {DriveControl::frequency, DriveControl::voltage}) {
    design.stator.control = control;
    const double torque = 0.5, speed = 9;
    const HeldPoint held = held_point(design, torque, speed);
    REQUIRE(held.status == HeldStatus::ok);
    const auto value = [&](Metric metric) {
      return evaluate(Motor(design), MetricRequest{metric, Argument::both, speed, torque}).value;
    };
    // Rounding alone: both are the same numbers of one contact.
    CHECK(value(Metric::drive_frequency_at) == Approx(held.frequency).epsilon(1e-12));
    CHECK(value(Metric::drive_voltage_at) == Approx(held.voltage).epsilon(1e-11));
    CHECK(value(Metric::amplitude_at) == Approx(held.amplitude).epsilon(1e-12));
    CHECK(value(Metric::output_power_at) == Approx(torque * speed).epsilon(1e-11));
    CHECK(value(Metric::electrical_power_at) == Approx(held.point.electrical_power).epsilon(1e-11));
    // The open-loop motor at the held setting runs at this speed under this load: it is stable there.
    REQUIRE_FALSE(held.by_control_only);
    MotorDesign open = with(design, Parameter::frequency, held.frequency);
    open = with(open, Parameter::voltage, held.voltage);
    CHECK(evaluate(Motor(open), MetricRequest{Metric::speed_at, Argument::torque, torque}).value ==
          Approx(speed).epsilon(1e-9));
  }
}

TEST_CASE("what the drive cannot hold has a status with the value that would do",
          "[core][held][error]") {
  MotorDesign design = test::driven_motor();
  const double largest = 0.23 * 170 * design.stator.contact_radius;
  CHECK(held_point(design, 1.01 * largest, 5).status == HeldStatus::torque_out_of_reach);
  CHECK(held_point(design, 1.01 * largest, 5).needed == Approx(largest).epsilon(1e-12));
  // A load that drives the rotor is braked by friction, and by no more.
  const HeldPoint driven = held_point(design, -1.01 * largest, 5);
  CHECK(driven.status == HeldStatus::torque_out_of_reach);
  CHECK(driven.needed == Approx(-largest).epsilon(1e-12));
  const MotorDesign slippery = with(design, Parameter::kinetic_friction, 0);
  CHECK(held_point(slippery, 0, 5).status == HeldStatus::torque_out_of_reach);
  const HeldPoint held = held_point(design, 0.5, 9);
  REQUIRE(held.status == HeldStatus::ok);
  design.stator.frequency_range = {1.001 * held.frequency, 1.1 * held.frequency};
  CHECK(held_point(design, 0.5, 9).status == HeldStatus::outside_frequency_range);
  CHECK(held_point(design, 0.5, 9).needed == held.frequency);
  design.stator.frequency_range = {0.9 * held.frequency, 1.001 * held.frequency};
  CHECK(held_point(design, 0.5, 9).status == HeldStatus::ok);
  design.stator.control = DriveControl::voltage;
  const HeldPoint by_voltage = held_point(design, 0.5, 9);
  REQUIRE(by_voltage.status == HeldStatus::ok);
  CHECK(held_point(with(design, Parameter::voltage, 0.999 * by_voltage.voltage), 0.5, 9).status ==
        HeldStatus::voltage_too_low);
  const MotorDesign ring = test::ring_motor();
  const HeldPoint by_amplitude = held_point(ring, 0.5, 1);
  REQUIRE(by_amplitude.status == HeldStatus::ok);
  const HeldPoint more =
      held_point(with(ring, Parameter::amplitude, 0.999 * by_amplitude.amplitude), 0.5, 1);
  CHECK(more.status == HeldStatus::amplitude_too_low);
  CHECK(more.needed == Approx(by_amplitude.amplitude).epsilon(1e-12));
  // torque_at and speed_at are what is given; a metric of the motor has no point.
  for (const Metric metric : {Metric::torque_at, Metric::speed_at, Metric::stall_torque})
    CHECK(evaluate(Motor(ring), MetricRequest{metric, Argument::both, 1, 0.5}).status ==
          MetricStatus::undefined);
}

TEST_CASE("derivatives of held metrics agree with differences of solving again (Y2.6)",
          "[core][held][derivative]") {
  std::vector<MetricRequest> asked;
  for (const MetricInfo& row : metric_table()) {
    const bool has = row.argument == Argument::both || row.argument == Argument::speed_or_torque;
    if (has && row.metric != Metric::squeal_rate_at && row.metric != Metric::sensor_voltage_at &&
        row.metric != Metric::sensor_phase_at && row.metric != Metric::backward_ratio_at)
      asked.push_back({row.metric, Argument::both, 9, 0.5});
  }
  REQUIRE(asked.size() >= 15);
  MotorDesign by_frequency = test::driven_motor_with_layer(), by_voltage = by_frequency;
  by_voltage.stator.control = DriveControl::voltage;
  MotorDesign by_ratio = by_voltage;
  by_ratio.stator.frequency_ratio =
      by_ratio.stator.frequency / *by_ratio.stator.resonance_frequency;
  MotorDesign elastic = test::driven_motor();
  for (const MotorDesign& design : {by_frequency, by_voltage, by_ratio, elastic}) {
    const auto check = test::against_differences(design, asked, 1e-4);
    CAPTURE(check.where, check.compared);
    // Richardson's extrapolation leaves the fourth power of the step times the curvature, and rounding 1e-11 / 1e-4.
    CHECK(check.worst <= 1e-6);
    CHECK(check.compared > 100);
  }
}

TEST_CASE(
    "the largest held speeds are those of a second program, and hold the largest torque there "
    "(Y4.1)",
    "[core][held][differential]") {
  int row = 1;
  for (const Case& c : cases("held_limits.csv")) {
    CAPTURE(++row, c.word("kind"));
    const Motor motor(design_of(c));
    const double torque = c["load_torque_Nm"], speed = c["held_speed_limit_rad_s"];
    const MetricValue found =
        evaluate(motor, MetricRequest{Metric::held_speed_limit_at, Argument::torque, torque});
    REQUIRE(found.status == MetricStatus::ok);
    CHECK(apart(found.value, speed) <= 1e-7);  // of the second program
    // The speed as a function of the torque, and back: both are searched to 2^-46 of their bracket. Where the speed changes least
    // with the torque that is some hundred times as much.
    const MetricValue back =
        evaluate(motor, MetricRequest{Metric::held_torque_limit_at, Argument::speed, found.value});
    CHECK(std::fabs(back.value - torque) <= 1e-10 * largest_held_torque(motor.design()));
    const HeldPoint least = least_voltage_point(motor.design(), torque, found.value);
    CHECK(apart(least.voltage, *motor.design().stator.voltage) <= 1e-10);
    CHECK(apart(least.amplitude, c["amplitude_m"]) <= 1e-6);
    CHECK(held_point(motor.design(), torque, 0.999 * speed).status == HeldStatus::ok);
    CHECK(held_point(motor.design(), torque, 1.001 * speed).status == HeldStatus::voltage_too_low);
  }
  CHECK(row == 29);
}

TEST_CASE("the envelope of each control is where its points end (Y4.1, Y4.2)",
          "[core][held][limit]") {
  MotorDesign by_frequency = test::driven_motor(), by_voltage = by_frequency;
  by_voltage.stator.control = DriveControl::voltage;
  MotorDesign in_range = by_frequency;
  const double f = held_point(by_frequency, 0.5, 9).frequency;
  in_range.stator.frequency_range = {f, 1.2 * f};
  for (const MotorDesign& design : {by_frequency, by_voltage, in_range, test::ring_motor()}) {
    const Motor motor(design);
    for (const double torque : {0.0, 0.3, 0.6}) {
      const MetricValue end =
          evaluate(motor, MetricRequest{Metric::held_speed_limit_at, Argument::torque, torque});
      CAPTURE(torque, to_string(end.status), end.value);
      REQUIRE(end.status == MetricStatus::ok);
      const HeldPoint inside = held_point(design, torque, (1 - 1e-6) * end.value);
      CHECK(inside.status == HeldStatus::ok);
      const HeldPoint outside = held_point(design, torque, (1 + 1e-6) * end.value);
      const bool lower_flank =
          outside.status == HeldStatus::ok && outside.point.phase_lag < M_PI / 2;
      CHECK((outside.status != HeldStatus::ok || lower_flank));
    }
    // The amplitude's envelope is the motor's own curve.
    if (!design.stator.voltage)
      CHECK(
          evaluate(motor, MetricRequest{Metric::held_torque_limit_at, Argument::speed, 3}).value ==
          Approx(motor.operating_point(3).torque).epsilon(1e-10));
  }
  // By frequency the range begins where 0.5 N.m at 9 rad/s are held.
  CHECK(evaluate(Motor(in_range), MetricRequest{Metric::held_speed_limit_at, Argument::torque, 0.5})
            .value == Approx(9).epsilon(1e-9));
}

TEST_CASE("the largest torque at a slow speed is what friction transmits", "[core][held][limit]") {
  const MotorDesign design = test::driven_motor();
  const double largest = 0.23 * 170 * design.stator.contact_radius;
  CHECK(largest_held_torque(design) == Approx(largest).epsilon(1e-14));
  const Motor motor(design);
  CHECK(evaluate(motor, MetricRequest{Metric::held_torque_limit_at, Argument::speed, 0.5}).value ==
        Approx(largest).epsilon(1e-14));
  CHECK(
      evaluate(motor, MetricRequest{Metric::pull_out_margin_at, Argument::both, 0.5, 0.4}).value ==
      Approx(largest - 0.4).epsilon(1e-12));
  CHECK(evaluate(motor, MetricRequest{Metric::torque_reserve_at, Argument::both, 9, 0.4}).value ==
        Approx(1 - 0.4 / largest).epsilon(1e-13));
  CHECK(
      evaluate(motor, MetricRequest{Metric::held_speed_limit_at, Argument::torque, 1.01 * largest})
          .status == MetricStatus::torque_out_of_reach);
}

TEST_CASE("derivatives of the envelope agree with differences of solving again (Y4.3)",
          "[core][held][derivative]") {
  const std::vector<MetricRequest> asked{{Metric::held_speed_limit_at, Argument::torque, 0.4},
                                         {Metric::held_torque_limit_at, Argument::speed, 15}};
  MotorDesign by_frequency = test::driven_motor_with_layer(), by_voltage = by_frequency;
  by_voltage.stator.control = DriveControl::voltage;
  MotorDesign by_ratio = by_voltage;
  by_ratio.stator.frequency_ratio =
      by_ratio.stator.frequency / *by_ratio.stator.resonance_frequency;
  MotorDesign in_range = test::driven_motor();
  const double f = held_point(in_range, 0.5, 9).frequency;
  in_range.stator.frequency_range = {f, 1.2 * f};
  for (const MotorDesign& design :
       {by_frequency, by_voltage, by_ratio, in_range, test::ring_motor()}) {
    const auto check = test::against_differences(design, asked, 1e-4);
    CAPTURE(check.where, check.compared);
    // The corner is searched to 2^-46 of its bracket, 1e-13 of the speed: 1e-9 in differences of 1e-4.
    CHECK(check.worst <= 1e-6);
    CHECK(check.compared >= 10);
  }
}

TEST_CASE("beyond the drive a metric is that of the wave that more voltage would hold (Y5.3)",
          "[core][held][limit]") {
  const MotorDesign strong = test::driven_motor();
  const double torque = 0.5, speed = 9;
  const double least = least_voltage_point(strong, torque, speed).voltage;
  const MotorDesign weak = with(strong, Parameter::voltage, 0.9 * least),
                    enough = with(strong, Parameter::voltage, (1 + 1e-6) * least);
  for (const Metric metric :
       {Metric::electrical_power_at, Metric::drive_frequency_at, Metric::amplitude_at}) {
    const MetricRequest request{metric, Argument::both, speed, torque};
    CHECK(evaluate(Motor(weak), request).status == MetricStatus::voltage_too_low);
    const double beyond = evaluate_beyond_drive(Motor(weak), request).value;
    // At the least voltage the held wave leaves R = 0 with the square root of what there is more: 1.4e-3.
    CHECK(evaluate(Motor(enough), request).value == Approx(beyond).epsilon(2e-3));
    CHECK(evaluate(Motor(strong), request).value ==
          evaluate_beyond_drive(Motor(strong), request).value);
  }
  CHECK(
      evaluate(Motor(weak), MetricRequest{Metric::drive_reserve_at, Argument::both, speed, torque})
          .value == Approx(-0.1).epsilon(1e-9));
  CHECK(evaluate(Motor(strong),
                 MetricRequest{Metric::drive_reserve_at, Argument::both, speed, torque})
            .value == Approx(*strong.stator.voltage / least - 1).epsilon(1e-12));
  const double largest = largest_held_torque(strong);
  const auto power = [&](double load) {
    return evaluate_beyond_drive(
        Motor(strong), MetricRequest{Metric::output_power_at, Argument::both, speed, load});
  };
  CHECK(power(1.2 * largest).value == Approx((1 - 1e-4) * largest * speed).epsilon(1e-12));
  CHECK(power(-1.2 * largest).value == Approx(-(1 - 1e-4) * largest * speed).epsilon(1e-12));
}

TEST_CASE(
    "a drive without voltage or amplitude, and a contact without friction or preload, hold nothing",
    "[core][held][limit]") {
  MotorDesign by_voltage = test::driven_motor();
  by_voltage.stator.control = DriveControl::voltage;
  const MetricRequest speed{Metric::held_speed_limit_at, Argument::torque, 0.5},
      torque{Metric::held_torque_limit_at, Argument::speed, 9},
      pressure{Metric::max_pressure_at, Argument::both, 9, 0.5},
      reserve{Metric::torque_reserve_at, Argument::both, 9, 0.5};
  for (const MotorDesign& design : {test::driven_motor(), by_voltage}) {
    const Motor still(with(design, Parameter::voltage, 0));
    for (const MetricRequest& request : {speed, torque, pressure})
      CHECK(evaluate(still, request).status == MetricStatus::voltage_too_low);
    CHECK(held_point(still.design(), 0.5, 9).status == HeldStatus::voltage_too_low);
    CHECK(held_point(still.design(), 0.5, 9).needed > 0);
  }
  const Motor still(with(test::ring_motor(), Parameter::amplitude, 0));
  for (const MetricRequest& request : {speed, torque, pressure})
    CHECK(evaluate(still, request).status == MetricStatus::amplitude_too_low);
  for (const Parameter p : {Parameter::preload, Parameter::kinetic_friction}) {
    const Motor free(with(test::driven_motor(), p, 0));
    for (const MetricRequest& request : {speed, torque, pressure, reserve})
      CHECK(evaluate(free, request).status == MetricStatus::torque_out_of_reach);
  }
}

TEST_CASE("derivatives of held metrics follow the geometry that gives the frequency (Y2.6, P5.1)",
          "[core][held][derivative][plate]") {
  MotorDesign design = test::plate_motor();
  design.stator.voltage = 200;
  for (const DriveControl control : {DriveControl::frequency, DriveControl::voltage}) {
    design.stator.control = control;
    const MetricRequest request{Metric::electrical_power_at, Argument::both, 6, 0.3};
    const MetricDerivative d = differentiate(Motor(design), request);
    CAPTURE(static_cast<int>(control), to_string(d.value.status));
    REQUIRE(d.value.status == MetricStatus::ok);
    for (const Parameter p : {Parameter::substrate_thickness, Parameter::ceramic_thickness,
                              Parameter::substrate_density, Parameter::frequency_ratio}) {
      const double x = get(design, p), h = 1e-4 * x;
      const auto at = [&](double value) {
        return evaluate(Motor(with(design, p, value)), request).value;
      };
      const double difference =
          (8 * (at(x + h) - at(x - h)) - (at(x + 2 * h) - at(x - 2 * h))) / (12 * h);
      CAPTURE(info(p).name);
      // The fourth power of the step times the curvature, and the plate's frequency, which is found to 1e-11, over the step.
      CHECK(std::fabs(d.gradient[index_of(p)] - difference) * x <=
            1e-5 * (d.value.value + std::fabs(difference * x)));
    }
  }
}

TEST_CASE("derivatives beyond the drive agree with differences (Y5.3)",
          "[core][held][derivative]") {
  const MotorDesign strong = test::driven_motor_with_layer();
  const double least = least_voltage_point(strong, 0.5, 9).voltage;
  MotorDesign weak = with(strong, Parameter::voltage, 0.9 * least);
  MotorDesign by_voltage = weak;
  by_voltage.stator.control = DriveControl::voltage;
  const double largest = largest_held_torque(strong);
  for (const MotorDesign& design : {weak, by_voltage, strong}) {
    for (const double torque : {0.5, 1.1 * largest}) {
      const MetricRequest request{Metric::electrical_power_at, Argument::both, 9, torque};
      const MetricDerivative d = differentiate_beyond_drive(Motor(design), request);
      REQUIRE(d.value.status == MetricStatus::ok);
      for (const Parameter p :
           {Parameter::preload, Parameter::kinetic_friction, Parameter::contact_radius,
            Parameter::thickness, Parameter::quality_factor, Parameter::modal_damping,
            Parameter::force_factor, Parameter::voltage}) {
        if (!in_use(design, p)) continue;
        const double x = get(design, p), h = 1e-5 * x;
        const auto at = [&](double value) {
          return evaluate_beyond_drive(Motor(with(design, p, value)), request).value;
        };
        const double difference =
            (8 * (at(x + h) - at(x - h)) - (at(x + 2 * h) - at(x - 2 * h))) / (12 * h);
        CAPTURE(info(p).name, torque);
        // Rounding of 1e-12 over a step of 1e-5; next to the largest torque the wave changes with the cube root of what is left of
        // it, which the fourth power of the step times that curvature leaves below.
        CHECK(std::fabs(d.gradient[index_of(p)] - difference) * x <= 1e-5 * d.value.value);
      }
    }
  }
}

TEST_CASE("what cannot be held is refused", "[core][held][error]") {
  const MotorDesign drive = test::driven_motor_with_layer();
  CHECK_THROWS_AS(held_point(drive, 0.5, 0, DriveControl::frequency), InputError);
  CHECK_THROWS_AS(held_point(drive, 0.5, -1, DriveControl::frequency), InputError);
  CHECK_THROWS_AS(held_point(drive, 0.5, HUGE_VAL, DriveControl::frequency), InputError);
  CHECK_THROWS_AS(held_point(drive, NAN, 1, DriveControl::frequency), InputError);
  const MotorDesign ring = test::ring_motor();
  CHECK_THROWS_AS(held_point(ring, 0.5, 1, DriveControl::frequency), InputError);
  CHECK_THROWS_AS(held_point(ring, 0.5, 1, DriveControl::voltage), InputError);
  CHECK(held_point(ring, 0.5, 1, DriveControl::amplitude).status == HeldStatus::ok);
}
