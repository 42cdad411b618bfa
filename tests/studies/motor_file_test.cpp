// SPDX-License-Identifier: Apache-2.0
#include "support/motor_files.hpp"
#include "support/scratch_folder.hpp"

#include <twum/core/motor.hpp>
#include <twum/io/publish.hpp>
#include <twum/io/units.hpp>
#include <twum/motors/motor_file.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>

using namespace twum;
using namespace twum::studies;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string ring_60() {
  return read_source(TWUM_SOURCE_DIR "/examples/motors/ring-60.yaml").text();
}

MotorDesign read(const std::string& text) { return read_motor(Source("m.yaml", text)).design; }

void check_equal(const MotorDesign& a, const MotorDesign& b) {
  for (const ParameterInfo& row : parameter_table()) {
    CAPTURE(row.name);
    const double left = get(a, row.parameter), right = get(b, row.parameter);
    CHECK((left == right || (std::isnan(left) && std::isnan(right))));  // NaN: it has no value
    CHECK(in_use(a, row.parameter) == in_use(b, row.parameter));
  }
}

}  // namespace

TEST_CASE("ring-60 is read to the last digit", "[studies][motor]") {
  MotorDesign expected;  // the same motor, as the core's default
  expected.stator.modal_damping = 45;
  expected.stator.radial_slices = kAutoSlices;
  const MotorFile motor = read_motor_file(TWUM_SOURCE_DIR "/examples/motors/ring-60.yaml");
  CHECK(motor.name == "ring-60");
  check_equal(motor.design, expected);
}

TEST_CASE("the motors of tests are those of the examples with one slice", "[studies][motor]") {
  for (const std::string name : {"ring-60", "drive-60"}) {
    CAPTURE(name);
    const MotorFile narrow = read_motor_file(test::motor_path(name));
    CHECK(narrow.name == name);
    CHECK(narrow.design.stator.radial_slices == 1);
    check_equal(with(narrow.design, Parameter::radial_slices, kAutoSlices),
                read_motor_file(TWUM_SOURCE_DIR "/examples/motors/" + name + ".yaml").design);
  }
}

TEST_CASE("line ends and a byte order mark make no difference", "[studies][motor]") {
  const twum::test::ScratchFolder folder;
  const std::string file = folder.path("twum bom µ.yaml");
  {
    std::FILE* out = std::fopen(file.c_str(), "wb");
    const std::string text = "\xEF\xBB\xBF" + replaced(ring_60(), "\n", "\r\n");
    std::fwrite(text.data(), 1, text.size(), out);
    std::fclose(out);
  }
  check_equal(read_motor_file(file).design, read(ring_60()));
}

TEST_CASE("what may be left out has its stated default", "[studies][motor]") {
  std::string text = replaced(ring_60(), "    static: 0.2 ", "    # ");
  text = replaced(text, "    modal_damping: 45 N.s/m ", "    # ");
  text = replaced(text, "kinetic: 0.2", "kinetic: 0.3");
  const MotorDesign design = read(text);
  CHECK(design.friction.threshold == 0.3);
  CHECK(design.stator.modal_damping == 0);
  CHECK(read(replaced(text, "kinetic: 0.3", "kinetic: 0")).friction.threshold == 0);
}

TEST_CASE("alternatives may be given outright, zero included", "[studies][motor]") {
  std::string text = replaced(ring_60(), "poisson_ratio: 0.35 ", "shear_modulus: 1 GPa ");
  text = replaced(text, "density: 1800 kg/m^3", "inertia: 0 Pa.s^2");
  const MotorDesign design = read(replaced(text, "loss_factor: 0.05", "shear_viscosity: 0 Pa.s"));
  CHECK(shear_modulus(design) == 1e9);
  CHECK(inertia(design) == 0);
  CHECK(shear_viscosity(design) == 0);
}

TEST_CASE("a motor that is written reads back the same", "[studies][motor]") {
  MotorFile motor = read_motor_file(TWUM_SOURCE_DIR "/examples/motors/ring-60.yaml");
  motor.name = "a \"name\": with \\ and µ";
  motor.design = with(motor.design, Parameter::shear_modulus, 1.0 / 3 * 1e9);
  motor.design = with(motor.design, Parameter::static_friction, 0.1 + 0.2);
  const MotorFile again = read_motor(Source("m.yaml", motor_text(motor)));
  CHECK(again.name == motor.name);
  check_equal(again.design, motor.design);
}

namespace {

// An admissible value near the one that the table shows as an example.
double random_value(const ParameterInfo& row, std::mt19937& dice) {
  const double example = parse_quantity(row.example, {row.unit, row.example});
  const double value = example * std::exp(std::uniform_real_distribution<>(-0.3, 0.3)(dice));
  if (row.integer) return std::round(value);
  return std::clamp(value, row.min, row.max);
}

// A motor with about half of all parameters given at random: those that exclude each other replace each other.
MotorDesign random_design(const MotorDesign& base, std::mt19937& dice) {
  MotorDesign design = base;
  for (const ParameterInfo& row : parameter_table()) {
    if (dice() % 2 == 0) continue;
    try {
      design = with(design, row.parameter, random_value(row, dice));
    } catch (const InputError&) {  // it does not fit the others
    }
  }
  return design;
}

}  // namespace

TEST_CASE("what was given is written, whether it is in use or not, and reads back to the bit",
          "[studies][motor][identity]") {
  std::mt19937 dice(17);
  int tapered = 0;
  for (const std::string name : {"ring-60", "drive-60", "plate-30"}) {
    const MotorDesign base =
        read_motor_file(TWUM_SOURCE_DIR "/examples/motors/" + name + ".yaml").design;
    for (int i = 0; i < 200; ++i) {
      MotorDesign design = random_design(base, dice);
      if (dice() % 2 == 0) design = with(design, Parameter::radial_slices, 1);
      if (!complaints(design).empty()) continue;
      const std::string text = motor_text({"m", design});
      const MotorDesign again = read(text);
      CAPTURE(name, i, text);
      check_equal(again, design);
      CHECK(motor_text({"m", again}) == text);
      tapered += design.stator.radial_slices == 1 && design.rotor.taper != 0 ? 1 : 0;
    }
  }
  CHECK(tapered > 20);  // the case that a track of one slice does not use
}

TEST_CASE("an equivalent circuit stands for the modal data (D4.4)", "[studies][motor]") {
  const std::string modal = read_source(TWUM_SOURCE_DIR "/examples/motors/drive-60.yaml").text();
  // By (D4.4) of the example's 25 g, 39 kHz, Q = 153, 0.55 N/V, with 17 digits.
  const MotorDesign expected = read(modal);
  const double turn = 2 * std::acos(-1.0), resonance = turn * 39e3, mass = 0.025;
  char circuit[300];
  std::snprintf(
      circuit, sizeof circuit,
      "equivalent_circuit: {motional_resistance: %.17g ohm, motional_inductance: %.17g H, "
      "motional_capacitance: %.17g F, blocked_capacitance: 8.5 nF, force_factor: 0.55 N/V}",
      resonance * mass / 153 / (0.55 * 0.55), mass / (0.55 * 0.55),
      0.55 * 0.55 / (mass * resonance * resonance));
  std::string text = replaced(modal, "resonance_frequency: 39 kHz ", std::string(circuit) + " ");
  for (const char* other : {"modal_mass: 25 g ", "quality_factor: 153", "force_factor: 0.55 N/V ",
                            "blocked_capacitance: 8.5 nF "})
    text = replaced(text, std::string("\n    ") + other, "\n    # ");
  const MotorDesign design = read(text);
  for (const ParameterInfo& row : parameter_table()) {
    CAPTURE(row.name);
    CHECK(in_use(design, row.parameter) == in_use(expected, row.parameter));
    const double value = get(expected, row.parameter);
    // Ten roundings at most.
    if (!std::isnan(value))
      CHECK(get(design, row.parameter) == Approx(value).epsilon(2e-15).margin(0));
  }
  // What is written is the modal data, which read back the same.
  check_equal(read(motor_text({"a motor", design})), design);
}

TEST_CASE("the file that init writes is valid", "[studies][motor]") {
  const MotorDesign design = read(yaml_template(motor_file_shape().schema, "# a comment\n"));
  CHECK_NOTHROW(Motor(design));
}

TEST_CASE("all example motors can be read and built", "[studies][motor]") {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(TWUM_SOURCE_DIR "/examples/motors")) {
    CAPTURE(entry.path());
    CHECK_NOTHROW(Motor(read_motor_file(entry.path().string()).design));
    ++count;
  }
  CHECK(count >= 3);
}

TEST_CASE("a file that cannot be read says why", "[studies][motor][error]") {
  CHECK_THROWS_WITH(read_motor_file("no such file.yaml"),
                    "no such file.yaml: cannot be read: No such file or directory");
  CHECK_THROWS_WITH(read_motor_file(TWUM_SOURCE_DIR),
                    Catch::EndsWith("cannot be read: it is a directory"));
  CHECK_THROWS_WITH(read_motor_file("/dev/zero"),
                    "/dev/zero: cannot be read: it is larger than 4 MiB");
}

TEST_CASE("a motor from its geometry is written and read as the same motor", "[studies][motor]") {
  MotorFile motor = read_motor_file(TWUM_SOURCE_DIR "/examples/motors/plate-60.yaml");
  REQUIRE(motor.design.stator.geometry.has_value());
  CHECK(motor.design.stator.geometry->ceramic.d31 == -125e-12);  // of the material apc-840
  check_equal(read(motor_text(motor)), motor.design);
  CHECK(*read(motor_text(motor)).stator.geometry == *motor.design.stator.geometry);
  // Without what may be left out, and with electrodes of their own.
  stator::StatorGeometry& g = *motor.design.stator.geometry;
  g.web.reset(), g.teeth.reset(), g.glue.thickness = 0;
  g.electrodes.inner_radius = 0.0225;
  g.support = stator::InnerEdge::free;
  check_equal(read(motor_text(motor)), motor.design);
  CHECK(*read(motor_text(motor)).stator.geometry == g);
}
