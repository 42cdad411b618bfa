// SPDX-License-Identifier: Apache-2.0
// When a calibration calls a fit a fit, and what it says where the points do not determine the motor (L2.3, L3.1).
#include "calibrate_support.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;

namespace {

// Three points of a 60 mm motor, as a bench notes them.
const char* const kThreePoints = "speed [rpm],torque [N.m]\n0,1.0\n100,0.5\n150,0\n";

// Torques of a motor at some speeds, in SI.
std::string torques_at(const MotorDesign& design, const std::vector<double>& rpm) {
  const Motor motor(design);
  std::string csv = "speed,torque\n";
  for (const double speed : rpm)
    csv += number(speed * kRpm) + "," + number(motor.operating_point(speed * kRpm).torque) + "\n";
  return csv;
}

std::vector<double> slow() { return {1, 2, 4, 6, 8, 10, 12}; }  // [rpm]: all of the contact slips
std::vector<double> all_speeds() {
  std::vector<double> rpm;
  for (int i = 1; i <= 28; ++i) rpm.push_back(5 * i);
  return rpm;
}

}  // namespace

TEST_CASE("three points do not make a fit, whatever is varied", "[studies][calibrate]") {
  const std::string friction = "kinetic_friction: {min: 0.05, max: 0.5}";
  const std::string modulus = "youngs_modulus: {min: 0.5 GPa, max: 20 GPa, scale: log}";
  const std::string wave = "amplitude: {min: 1 um, max: 2.2 um}";
  for (const std::string& variables :
       {friction, friction + ", " + modulus, friction + ", " + wave, modulus + ", " + wave,
        friction + ", " + modulus + ", " + wave, friction + ", preload: {min: 60 N, max: 300 N}"}) {
    CAPTURE(variables);
    Case one;
    one.variables = variables;
    one.more = "starts: 8";
    const Run run(one.file(kThreePoints));
    CHECK(run.answer.outcome != "fitted");
    CHECK(run.answer.outcome != "feasible");  // which ends with the exit status 0
    for (const auto& estimate : run.result().estimates) {
      if (!std::isfinite(estimate.low)) continue;
      CHECK(estimate.low >= estimate.min);
      CHECK(estimate.high <= estimate.max);
    }
  }
}

TEST_CASE("two motors that fit two points to rounding are both named", "[studies][calibrate]") {
  // Much friction under little preload or the other way round: beyond the plateau preload widens the
  // contact, so that the torque falls again.
  Case one;
  one.variables = "kinetic_friction: {min: 0.05, max: 1}, preload: {min: 10 N, max: 500 N}";
  one.more = "starts: 8";
  const Run run(one.file("speed [rpm],torque [N.m]\n100,0.757\n130,0.43\n"));
  CHECK(run.answer.outcome == "several");
  REQUIRE(run.result().equals() == 2);
  for (const auto& optimum : run.result().optima) {
    if (!optimum.fits_as_well) continue;
    const std::vector<ParameterValue> values{{Parameter::kinetic_friction, optimum.values[0]},
                                             {Parameter::preload, optimum.values[1]}};
    const MotorDesign design = with(one.design(), values);
    // Each is a motor with these torques, computed without the fit. The search ends where its steps are below
    // 1e-9 of the parameters; torques are of the order of 1 N m.
    CHECK(Motor(design).operating_point(100 * kRpm).torque == Approx(0.757).margin(1e-8));
    CHECK(Motor(design).operating_point(130 * kRpm).torque == Approx(0.43).margin(1e-8));
  }
  CHECK_THAT(run.text(), Contains("The data cannot distinguish 2 different motors"));
  CHECK_THAT(run.text(), Contains("fits equally well"));
}

TEST_CASE("combinations that the points cannot see are named, in ten cases",
          "[studies][calibrate][closed-form]") {
  // Of an elastic layer with G in proportion to E the torque depends on b E / h; while the whole contact slips it is
  // mu F r.
  struct Blind {
    std::vector<std::string> varied;
    bool plateau;
    std::set<std::string> names;
    const char* words;
  };
  const Blind cases[] = {
      {{"E", "h", "mu"},
       false,
       {"youngs_modulus", "thickness"},
       "with a thicker layer (thickness +10 %)"},
      {{"b", "h", "mu"},
       false,
       {"contact_width", "thickness"},
       "A wider contact (contact_width +10 %)"},
      {{"b", "E", "mu"},
       false,
       {"contact_width", "youngs_modulus"},
       "layer (youngs_modulus -10 %)"},
      {{"b", "E", "h"},
       false,
       {"contact_width", "youngs_modulus", "thickness"},
       "no measured number changes"},
      {{"mu", "F"}, true, {"kinetic_friction", "preload"}, "with less preload (preload -10 %)"},
      {{"mu", "r"}, true, {"kinetic_friction", "contact_radius"}, "with a smaller contact radius"},
      {{"F", "r"}, true, {"preload", "contact_radius"}, "with a smaller contact radius"},
      {{"mu", "F", "r"},
       true,
       {"kinetic_friction", "preload", "contact_radius"},
       "no measured number changes"},
      {{"mu", "d"}, false, {"modal_damping"}, "The data do not determine modal_damping"},
      {{"mu", "E"}, true, {"youngs_modulus"}, "The data do not determine youngs_modulus"},
  };
  const std::map<std::string, std::string> ranges{
      {"E", "youngs_modulus: {min: 1 GPa, max: 10 GPa}"},
      {"h", "thickness: {min: 0.1 mm, max: 1 mm}"},
      {"b", "contact_width: {min: 1 mm, max: 8 mm}"},
      {"mu", "kinetic_friction: {min: 0.05, max: 0.5}"},
      {"F", "preload: {min: 60 N, max: 300 N}"},
      {"r", "contact_radius: {min: 20 mm, max: 35 mm}"},
      {"d", "modal_damping: {min: 1 N.s/m, max: 99 N.s/m}"}};
  for (const Blind& blind : cases) {
    CAPTURE(blind.varied);
    Case one;
    one.motor = "elastic-layer";
    one.set = "{poisson_ratio: 0.35}";
    one.variables.clear();
    for (const std::string& name : blind.varied)
      one.variables += (one.variables.empty() ? "" : ", ") + ranges.at(name);
    const Run run(one.file(torques_at(one.design(), blind.plateau ? slow() : all_speeds())));
    CHECK(run.answer.outcome == "undetermined");
    std::set<std::string> named;
    for (const auto& set : run.result().undetermined)
      named.insert(set.names.begin(), set.names.end());
    CHECK(named == blind.names);
    CAPTURE(run.text());
    CHECK_THAT(run.text(), Contains(blind.words));
  }
}

TEST_CASE(
    "a parameter at the end of its range is not determined, though the curve follows the points",
    "[studies][calibrate]") {
  Case one;
  one.variables = "kinetic_friction: {min: 0.05, max: 0.5}, amplitude: {min: 1.61 um, max: 2.2 um}";
  // The wave is 1.6 um, less than the range has. About half of the sets of points show that no motor of the range follows them.
  int followed = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Run run(one.file(points_of(one.design(), 20e-3, seed)));
    CHECK(run.result().estimates[1].bound == CalibrateResult::Bound::min);
    if (run.result().poor()) continue;
    ++followed;
    CHECK(run.answer.outcome == "undetermined");
  }
  CHECK(followed > 0);
}

TEST_CASE(
    "a sine of 2 % on torques with a scatter of 1 % is found, and scatter alone is not (L4.1)",
    "[studies][calibrate][statistics]") {
  constexpr int kTrials = 60;
  constexpr double kScatter = 8.5e-3;  // [N m], of 0.85 N m
  Case one;
  const MotorDesign truth = with(one.design(), kTruth);
  int found = 0, alarms = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    for (const double sine : {0.0, 2 * kScatter}) {
      std::istringstream plain(points_of(truth, kScatter, static_cast<std::uint64_t>(trial) + 1));
      std::string csv, line;
      std::getline(plain, csv);
      csv += "\n";
      for (int i = 0; std::getline(plain, line); ++i) {
        const std::size_t comma = line.find(',');
        csv += line.substr(0, comma + 1) +
               number(std::stod(line.substr(comma + 1)) +
                      sine * std::sin(2 * std::numbers::pi * i / 27)) +
               "\n";
      }
      (sine > 0 ? found : alarms) += Run(one.file(csv)).result().neighbours->p < 0.01 ? 1 : 0;
    }
  }
  CAPTURE(found, alarms);
  // A simulation with the linearised motor finds 86 of 100 sines, and 1 false alarm in 100. Fewer than 38 or more than 6 of 60
  // have a chance below 1e-4.
  CHECK(found >= 38);
  CHECK(alarms <= 6);
}

namespace {

// A table with every measured number changed by up to 1e-13 of itself.
std::string nudged(const std::string& path, std::uint64_t seed) {
  std::ifstream from(path);
  optim::Random random(seed, 0, 0);
  std::string csv, line;
  bool header = true;
  while (std::getline(from, line)) {
    if (line.empty() || line[0] == '#' || header) {
      header = header && (line.empty() || line[0] == '#');
      csv += line + "\n";
      continue;
    }
    std::istringstream cells(line);
    std::string cell, row;
    while (std::getline(cells, cell, ','))
      row += (row.empty() ? "" : ",") +
             number(std::stod(cell) * (1 + 1e-13 * (2 * random.uniform() - 1)));
    csv += row + "\n";
  }
  return csv;
}

}  // namespace

TEST_CASE("rounding errors of the readings do not change a verdict", "[studies][calibrate]") {
  const std::string folder = TWUM_SOURCE_DIR "/examples/studies/";
  DesignVariable thickness{Parameter::thickness};
  thickness.min = 1e-4;
  thickness.max = 2e-3;
  thickness.scale = optim::Scale::log;
  for (const char* name : {"calibrate", "calibrate-data-sheet", "calibrate-data-sheet with h"}) {
    StudyFile file =
        read_study_file(folder + std::string(name).substr(0, std::string(name).find(' ')) + ".yaml",
                        std::vector<std::string>{"radial_slices=1"});
    auto& asked = std::get<CalibrateStudy>(file.asked);
    if (std::string(name).back() == 'h') asked.variables.push_back(thickness);
    const std::string data = folder + asked.data.front();
    const Run exact(file);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      CAPTURE(name, seed);
      const ScratchFolder scratch;
      std::ofstream(scratch.path(asked.data.front())) << nudged(data, seed);
      file.folder = scratch.folder();
      const Run run(file);
      CHECK(run.answer.outcome == exact.answer.outcome);
      CHECK(run.result().equals() == exact.result().equals());
      CHECK(run.result().undetermined.size() == exact.result().undetermined.size());
      for (std::size_t j = 0; j < run.result().estimates.size(); ++j) {
        const auto& a = run.result().estimates[j];
        const auto& b = exact.result().estimates[j];
        CAPTURE(a.parameter.name);
        // A search ends where steps are below 1e-9; the widths of intervals are found to 1e-3.
        CHECK(a.parameter.value == Approx(b.parameter.value).epsilon(1e-6));
        CHECK(a.low == Approx(b.low).epsilon(2e-3));
        CHECK(a.high == Approx(b.high).epsilon(2e-3));
      }
    }
  }
}
