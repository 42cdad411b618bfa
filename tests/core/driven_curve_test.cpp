// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/core/frequency_response.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <string>

// Motors whose curve of waves over the speed or the frequency has close folds, islands, jumps, or begins above rest. The values
// are those of another program, which states the digits given here.
namespace {

using namespace twum;

// "0.5 mm": the files have SI units but for these.
double si_number(const YAML::Node& node) {
  const auto text = node.as<std::string>();
  std::size_t end = 0;
  const double value = std::stod(text, &end);
  const std::string unit = end < text.size() ? text.substr(end + 1) : "";
  if (unit == "mm") return value * 1e-3;
  if (unit == "kHz") return value * 1e3;
  if (unit == "g") return value * 1e-3;
  if (unit == "nF") return value * 1e-9;
  if (unit == "GPa") return value * 1e9;
  return value;
}

MotorDesign motor_of(const std::string& name) {
  const YAML::Node motor =
      YAML::LoadFile(std::string(TWUM_TEST_DATA "/driven/") + name + ".yaml")["motor"];
  MotorDesign design;
  design.layer = {};
  const auto set = [&](const YAML::Node& group, const char* key, auto& member) {
    if (group[key]) member = si_number(group[key]);
  };
  const YAML::Node stator = motor["stator"], layer = motor["contact_layer"],
                   friction = motor["friction"];
  Stator& s = design.stator;
  set(stator, "wavelengths", s.wavelengths);
  set(stator, "contact_radius", s.contact_radius);
  set(stator, "contact_width", s.contact_width);
  set(stator, "neutral_plane_distance", s.neutral_plane_distance);
  set(stator, "frequency", s.frequency);
  set(stator, "voltage", s.voltage);
  set(stator, "resonance_frequency", s.resonance_frequency);
  set(stator, "modal_mass", s.modal_mass);
  set(stator, "modal_damping", s.modal_damping);
  set(stator, "quality_factor", s.quality_factor);
  set(stator, "force_factor", s.force_factor);
  set(stator, "blocked_capacitance", s.blocked_capacitance);
  set(stator, "loss_tangent", s.loss_tangent);
  set(layer, "thickness", design.layer.thickness);
  set(layer, "youngs_modulus", design.layer.youngs_modulus);
  set(layer, "poisson_ratio", design.layer.poisson_ratio);
  set(layer, "density", design.layer.density);
  set(layer, "loss_factor", design.layer.loss_factor);
  set(layer, "shear_modulus", design.layer.given_shear_modulus);
  set(layer, "shear_viscosity", design.layer.given_shear_viscosity);
  set(layer, "inertia", design.layer.given_inertia);
  set(friction, "kinetic", design.friction.kinetic);
  design.friction.threshold = design.friction.kinetic;
  set(friction, "static", design.friction.threshold);
  set(motor, "preload", design.preload);
  return design;
}

double metric_of(const MotorDesign& design, Metric metric) {
  const MetricValue found = evaluate(Motor(design), {metric});
  CAPTURE(info(metric).name, to_string(found.status));
  CHECK(found.status == MetricStatus::ok);
  return found.value;
}

}  // namespace

TEST_CASE("a motor with mu_0 > mu runs where its wave at rest has no periodic state",
          "[core][driven][reference]") {
  CHECK(Motor(motor_of("st86")).operating_point(2.193).torque == Approx(1.0839).margin(6e-5));
  CHECK(Motor(motor_of("st8-6")).operating_point(2.2).torque == Approx(0.8551).margin(6e-5));
}

TEST_CASE("a branch with close folds ends at the last of them", "[core][driven][reference]") {
  MotorDesign ring = motor_of("drive-60");
  ring.stator.voltage = 36.46;
  CHECK(metric_of(ring, Metric::pull_out_torque) == Approx(0.0746).margin(6e-5));
  ring.stator.voltage = 39;
  CHECK(metric_of(ring, Metric::pull_out_torque) == Approx(0.0914).margin(6e-5));
  CHECK(metric_of(motor_of("el397"), Metric::pull_out_torque) == Approx(-0.1600).margin(6e-5));
  CHECK(Motor(motor_of("el397")).first_speed() == Approx(6.7506).margin(6e-5));
  CHECK(metric_of(motor_of("da8-8"), Metric::pull_out_torque) == Approx(-0.687).margin(6e-4));
  CHECK(Motor(motor_of("da8-8")).first_speed() == Approx(4.0352).margin(6e-5));
  CHECK(metric_of(motor_of("el176"), Metric::pull_out_torque) == Approx(-0.1127).margin(6e-5));
}

TEST_CASE("a start frequency starts the motor at its voltage (D3.4)", "[core][driven][identity]") {
  MotorDesign motor = motor_of("da36");
  const double start = metric_of(motor, Metric::start_frequency);
  CHECK(start == Approx(52902.416).margin(6e-4));
  motor.stator.frequency = start;
  // Newton's method leaves 1e-9 of the distance to the resonance.
  CHECK(metric_of(motor, Metric::start_voltage) == Approx(*motor.stator.voltage).epsilon(1e-8));
}

TEST_CASE("a motor that begins to drive above its first speed has a no-load speed",
          "[core][driven][reference]") {
  const MotorDesign motor = motor_of("el7");
  CHECK(metric_of(motor, Metric::no_load_speed) == Approx(2.469).margin(6e-4));
  CHECK(metric_of(motor, Metric::peak_power) > 0);
}

TEST_CASE("below the hold voltage the wave that drives is the running one",
          "[core][driven][reference]") {
  // A speed at which the dead wave brakes with 0.018 N m.
  const Motor motor(motor_of("el112"));
  CHECK(motor.operating_point(0.8).torque == Approx(0.0303).margin(6e-5));
  CHECK(motor.operating_point(0).status == PointStatus::pulled_out);
}

TEST_CASE("a jump of the force holds a wave (D3.2)", "[core][driven][reference]") {
  // Where the force jumps depends on which of two states of the layer another program follows, by a tenth of a per cent.
  CHECK(metric_of(motor_of("st20"), Metric::hold_voltage) == Approx(53.426).epsilon(1e-3));
}

TEST_CASE("islands of waves below the hold voltage are found, at a speed and over the frequency",
          "[core][driven][reference]") {
  struct Island {
    const char* motor;
    double amplitude, speed;
  };
  for (const Island& island :
       {Island{"missed-41", 0.43697e-6, 3.50208}, Island{"missed-156", 0.15511e-6, 1.02777},
        Island{"missed-205", 0.13202e-6, 0.60230}}) {
    CAPTURE(island.motor);
    const MotorDesign design = motor_of(island.motor);
    const OperatingPoint p = Motor(design).operating_point(island.speed);
    REQUIRE(p.status == PointStatus::ok);
    CHECK(p.amplitude == Approx(island.amplitude).margin(6e-12));
    // The wave carries no torque at a speed that is given to six digits.
    CHECK(metric_of(design, Metric::no_load_speed) == Approx(island.speed).epsilon(1e-5));
    bool there = false;
    const FrequencyResponse response(design, {Argument::speed, island.speed});
    for (const ResponsePoint& other : response.at(design.stator.frequency))
      there |= std::fabs(other.point.amplitude / p.amplitude - 1) < 1e-9;
    CHECK(there);
  }
}
