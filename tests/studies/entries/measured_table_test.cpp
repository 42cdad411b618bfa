// SPDX-License-Identifier: Apache-2.0
// Files of instruments as tables of measurements, and what an impedance analyser reads.
#include "tables/measured_points.hpp"

#include <twum/base/error.hpp>
#include <twum/core/equivalent_circuit.hpp>
#include <twum/motors/motor_file.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using Catch::Matchers::Contains;
using Complex = std::complex<double>;

namespace {

MeasuredPoints read_as(const std::string& name, const std::string& text,
                       const std::vector<ColumnChoice>& choices = {}) {
  return read_measured_points(Source(name, text), choices);
}

// Conductance and susceptance of a Touchstone file with one point.
Complex admittance_read(const std::string& options, const std::string& point) {
  const MeasuredPoints table = read_as("z.s1p", "! made\n\n" + options + "\n" + point + "\n");
  REQUIRE(table.points.size() == 2);
  REQUIRE(name_of(table.points[0].reading) == "conductance");
  REQUIRE(name_of(table.points[1].reading) == "susceptance");
  return {table.points[0].value, table.points[1].value};
}

double distance(Complex a, Complex b) { return std::abs(a - b); }

std::vector<std::string> names_of(const MeasuredPoints& table) {
  std::vector<std::string> names;
  for (const MeasuredPoint& point : table.points) names.emplace_back(name_of(point.reading));
  return names;
}

double value_of(const MotorDesign& design, CircuitPart part) {
  return differentiate(design, part, false).value.value;
}

}  // namespace

TEST_CASE("reflections at known loads are their admittances", "[studies][calibrate]") {
  // Of the load itself nothing is reflected, of an open end everything; 1 / S of three times the load is 2.
  CHECK(distance(admittance_read("# HZ S RI R 50", "40000 0 0"), 0.02) < 1e-17);
  CHECK(distance(admittance_read("# HZ S RI R 75", "40000 1 0"), 0) < 1e-17);
  CHECK(distance(admittance_read("# hz s ma r 50", "40000 0.5 0"), 1 / 150.0) < 1e-17);
  CHECK(distance(admittance_read("# HZ S MA R 50", "40000 0.5 180"), 3 / 50.0) < 1e-16);
  // A capacitor of the susceptance 1/R turns the wave by 90 degrees; its size is 0 dB.
  CHECK(distance(admittance_read("# HZ S DB R 50", "40000 0 -90"), Complex(0, 0.02)) < 1e-17);
  CHECK(distance(admittance_read("# HZ S RI R 50", "40000 0 -1"), Complex(0, 0.02)) < 1e-17);
  CHECK(distance(admittance_read("# HZ Y RI R 50", "40000 1 2"), Complex(0.02, 0.04)) < 1e-17);
  CHECK(distance(admittance_read("# HZ Z RI R 1", "40000 0 -25"), Complex(0, 0.04)) < 1e-17);
  // Version 2 has lines in brackets, and Y and Z in S and ohm.
  CHECK(
      distance(
          admittance_read(
              "[Version] 2.0\n# HZ S RI R 50\n[Number of Ports] 1\n[Reference] 75\n[Network Data]",
              "40000 0 0\n[End]"),
          1 / 75.0) < 1e-17);
  CHECK(distance(admittance_read("[Version] 2.0\n# HZ Z RI", "40000 0 -25\n[End]"),
                 Complex(0, 0.04)) < 1e-17);
  // What the line of options leaves out: GHz, S, MA, 50 ohm.
  CHECK(distance(admittance_read("# ghz", "4e-5 0.5 0"), 1 / 150.0) < 1e-17);
}

TEST_CASE("frequencies of a Touchstone file are in its unit", "[studies][calibrate]") {
  for (const auto& [unit, point] : {std::pair("HZ", "40800 0 0"), std::pair("kHz", "40.8 0 0"),
                                    std::pair("MHz", "0.0408 0 0")}) {
    const MeasuredPoints table =
        read_as("z.s1p", "# " + std::string(unit) + " S RI R 50\n" + point + "\n");
    CHECK(table.points[0].set.at(0).first == Parameter::frequency);
    CHECK(table.points[0].set.at(0).second == Approx(40800).epsilon(1e-15));
  }
  // Another first word is a remark of a plain table.
  CHECK(names_of(read_as("t.csv", "# measured in MHz by hand\nspeed,torque\n1,2\n")) ==
        std::vector<std::string>{"torque_at"});
}

TEST_CASE("analysers' headings are read by the first whole pair", "[studies][calibrate]") {
  using Names = std::vector<std::string>;
  CHECK(names_of(read_as("z", "Freq (Hz),|Z| (ohm),Phase (deg),R,X\n1,2,3,4,5\n")) ==
        Names{"resistance", "reactance"});
  CHECK(names_of(read_as("z", "f,G,B\n1,2,3\n")) == Names{"conductance", "susceptance"});
  const MeasuredPoints table = read_as("z", "FREQUENCY [kHz];Z_mod [kOhm];Theta-deg\n40;1,5;-90\n");
  CHECK(names_of(table) == Names{"impedance", "impedance_phase"});
  CHECK(table.points[0].value == 1500);
  CHECK(table.points[1].value == Approx(-std::acos(0)).epsilon(1e-15));
  CHECK(table.points[0].set.at(0).second == 40000);
  CHECK(names_of(read_as("z", "Freq (HZ),Z(OHM),Phase (DEG)\n1,2,3\n")) ==
        Names{"impedance", "impedance_phase"});
  // Half a pair is none, and headings of ours are not guessed about.
  CHECK_THROWS_WITH(read_as("z", "Freq (Hz),Rs (ohm)\n1,2\n"),
                    Contains("no column with measured values"));
  CHECK(read_as("z", "frequency [Hz],conductance [S],B\n1,2,3\n").unused == Names{"B"});
}

TEST_CASE("what is missing in the headings is said in the words of the table",
          "[studies][calibrate][error]") {
  const auto complaint = [](const std::string& text) {
    try {
      read_as("t.csv", text);
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string("read");
  };
  CHECK_THAT(complaint("85,0.765\n95,0.76\n"), Contains("numbers where the headings should be"));
  CHECK_THAT(complaint("speed [rpm]   torque [N.m]\n85   0.765\n"),
             Contains("separate columns by commas, semicolons or tabs"));
  CHECK_THAT(complaint("Frequency [Hz],Cp [F],D\n1,2,3\n"),
             Contains("R and X, or G and B") && Contains("columns: {impedance: 'Cp [F]'}"));
}

TEST_CASE("columns that the study does not use may have equal headings", "[studies][calibrate]") {
  CHECK(read_as("t.csv", "speed,torque,remark,remark\n1,2,a,b\n").unused ==
        std::vector<std::string>{"remark", "remark"});
  CHECK_THROWS_WITH(read_as("t.csv", "speed,torque,torque\n1,2,2\n"),
                    Contains("the column is given twice"));
}

TEST_CASE("a file called .s1p is a Touchstone file or wrong", "[studies][calibrate][error]") {
  // Without a word the options are GHz S MA R 50; nothing is reflected of the load itself.
  const MeasuredPoints defaults = read_as("z.s1p", "#\n1e-6 0 0\n");
  CHECK(defaults.points[0].value == Approx(0.02).epsilon(1e-15));
  CHECK(defaults.points[0].set.at(0).second == Approx(1000).epsilon(1e-15));
  CHECK(names_of(read_as("t.csv", "#\nspeed,torque\n1,2\n")) ==
        std::vector<std::string>{"torque_at"});
  const auto refused = [](const std::string& name, const std::string& text,
                          const std::string& words) {
    CHECK_THROWS_WITH(read_as(name, text), Contains(words));
  };
  refused("z.s1p", "40000 0 0\n", "z.s1p:1:1: no line of options above the numbers");
  refused("Z.S1P", "! made\n# Hz T RI R 50\n1 0 0\n",
          "Z.S1P:2:1: options that a Touchstone file of one port does not have");
  refused("z.s1p", "# Hz S RI R 50\n1 0,5 0\n", "'0,5' has a decimal comma; write '0.5'");
  refused("z.s1p", "# Hz S RI R 50\n1 NaN 0\n", "'NaN' is not a number");
  refused("z.s2p", "# Hz S RI R 50\n1 0 0 0 0 0 0 0 0\n", "9 words in a line");
}

TEST_CASE("names of measured quantities have any case", "[studies][calibrate]") {
  const MeasuredPoints table =
      read_as("t.csv", "Speed (rpm),TORQUE [N.m],Torque_SD [N.m],Preload / N\n60,1,0.1,150\n");
  CHECK(names_of(table) == std::vector<std::string>{"torque_at"});
  CHECK(std::get<MetricRequest>(table.points[0].reading).at ==
        Approx(2 * std::acos(-1)).epsilon(1e-15));
  CHECK(table.points[0].deviation == 0.1);
  CHECK(table.points[0].set.at(0).second == 150);
  // A letter may mean something else in the other case.
  CHECK(read_as("t.csv", "speed,torque,N\n1,2,3\n").unused == std::vector<std::string>{"N"});
}

TEST_CASE("a phase without a unit is not guessed", "[studies][calibrate][error]") {
  const MeasuredPoints table = read_as("z", "Freq (Hz),|Z| (ohm),Phase\n1,2,0.5\n");
  CHECK(table.without_unit ==
        std::vector<std::string>{"impedance_phase [rad]"});  // told, in SI as everywhere
  try {
    read_as("z", "Freq (Hz),|Z| (ohm),Phase\n1,2,-88.2\n");
    FAIL("read");
  } catch (const FileError& error) {
    CHECK_THAT(error.what(),
               Contains("z:2:5: impedance_phase: '-88.2' without a unit is in radians"));
  }
}

TEST_CASE("resistance and reactance are the parts of the inverse admittance (D4.4)",
          "[studies][calibrate]") {
  MotorDesign design = read_motor_file(TWUM_TEST_DATA "/motors/drive-60.yaml").design;
  for (const double frequency : {38e3, 38.95e3, 39e3, 39.05e3, 40e3}) {
    design = with(design, Parameter::frequency, frequency);
    const Complex y(value_of(design, CircuitPart::conductance),
                    value_of(design, CircuitPart::susceptance));
    const Complex z(value_of(design, CircuitPart::resistance),
                    value_of(design, CircuitPart::reactance));
    CHECK(distance(y * z, 1) < 1e-15);  // a few roundings of 1e-16
    CHECK(std::abs(z) == Approx(value_of(design, CircuitPart::impedance)).epsilon(1e-14));
    CHECK(std::arg(z) == Approx(value_of(design, CircuitPart::impedance_phase)).epsilon(1e-14));
  }
}

TEST_CASE("derivatives of resistance and reactance are those of differences",
          "[studies][calibrate]") {
  MotorDesign design = read_motor_file(TWUM_TEST_DATA "/motors/drive-60.yaml").design;
  design = with(design, Parameter::frequency, 39.02e3);
  for (const CircuitPart part : {CircuitPart::resistance, CircuitPart::reactance}) {
    const MetricDerivative exact = differentiate(design, part, false);
    const double size = std::abs(exact.value.value);
    for (const Parameter parameter :
         {Parameter::resonance_frequency, Parameter::modal_mass, Parameter::force_factor,
          Parameter::blocked_capacitance, Parameter::loss_tangent, Parameter::frequency}) {
      const double value = get(design, parameter);
      const double step = 1e-6 * value;
      const double difference = (value_of(with(design, parameter, value + step), part) -
                                 value_of(with(design, parameter, value - step), part)) /
                                (2 * step);
      // The step is 1e-6 / (1 / Q) = 2e-4 of the width of the resonance, so that the third derivative leaves 1e-7; rounding
      // leaves 1e-16 of the value over the step, 1e-10 of value / parameter.
      const double scale = std::abs(exact.gradient[index_of(parameter)]) + 1e-3 * size / value;
      CHECK(std::abs(difference - exact.gradient[index_of(parameter)]) < 1e-6 * scale);
    }
  }
}

TEST_CASE("both parts of a complex number have errors of one size", "[studies][calibrate]") {
  CHECK(same_scale(CircuitPart::conductance, CircuitPart::susceptance));
  CHECK(same_scale(CircuitPart::reactance, CircuitPart::resistance));
  CHECK_FALSE(same_scale(CircuitPart::impedance, CircuitPart::impedance_phase));
  CHECK_FALSE(same_scale(CircuitPart::conductance, CircuitPart::resistance));
  CHECK_FALSE(same_kind(CircuitPart::conductance, CircuitPart::susceptance));
}
