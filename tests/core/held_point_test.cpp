// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/held_point.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include "support/driven_motors.hpp"

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
  for (const double torque : {-0.1, 0.0, 0.3, 0.6}) {
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
