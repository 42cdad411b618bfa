// SPDX-License-Identifier: Apache-2.0
// Columns of measurements: those of a data sheet, and wrong ones.
#include "calibrate_support.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <utility>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;

namespace {

// "ok", or the message with the folder left out.
std::string complaint_about(const std::string& csv) {
  Case one;
  one.variables = "kinetic_friction: {min: 0.05, max: 0.5}";
  try {
    make_kind(one.file(csv));
    return "ok";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a data sheet's five numbers say what they determine", "[studies][calibrate]") {
  StudyFile sheet = read_study_file(TWUM_SOURCE_DIR "/examples/studies/calibrate-data-sheet.yaml");
  const Run four(sheet);
  CHECK(four.answer.outcome == "fitted");
  CHECK_THAT(four.text(), Contains("speed_at(500 mN.m)") && Contains("start_voltage"));
  CHECK_THAT(four.json(), Contains("\"quantity\":\"no_load_speed\""));
  // The line of the example that is a remark: the thickness acts as the modulus does.
  auto& asked = std::get<CalibrateStudy>(sheet.asked);
  DesignVariable thickness{Parameter::thickness};
  thickness.min = 1e-4;
  thickness.max = 2e-3;
  thickness.scale = optim::Scale::log;
  asked.variables.push_back(thickness);
  const Run five(sheet);
  CHECK(five.answer.outcome == "undetermined");
  CHECK(five.result().equals() == 1);  // one valley, not several motors
  CHECK_THAT(five.text(),
             Contains("The points determine only poorly youngs_modulus and thickness"));
  // Places whose sum of squares exceeds the least by less than 1.96^2 are in the interval of each parameter (L3.1).
  int places = 0;
  for (const CalibrateResult::Optimum& place : five.result().optima) {
    const double sum = place.residual_rms * place.residual_rms * 5;
    if (!place.same_valley || sum > 1.96 * 1.96) continue;
    ++places;
    for (std::size_t j = 0; j < place.values.size(); ++j) {
      const CalibrateResult::Estimate& e = five.result().estimates[j];
      CAPTURE(e.parameter.name, place.values[j]);
      CHECK((place.values[j] >= e.low && place.values[j] <= e.high));
    }
  }
  CHECK(places > 0);
}

TEST_CASE("depths worn after some hours determine the specific wear",
          "[studies][calibrate][life]") {
  Case one;
  one.motor = "drive-60";
  one.set = "{specific_wear: 3e-7 mm^3/(N.m), wear_depth_limit: 100 um, radial_slices: 1}";
  one.variables = "specific_wear: {min: 1e-7 mm^3/(N.m), max: 1e-5 mm^3/(N.m), scale: log}";
  // the hours that a motor of known wear takes to these depths
  constexpr double kKnown = 1e-15;
  MotorDesign known = one.design();
  known.wear->specific_wear = kKnown;
  std::string csv = "torque,wear_depth_limit,life_at,life_at_sd\n";
  for (const auto& [torque, depth] : {std::pair{0.5, 2.7e-6}, {0.5, 5e-6}, {0.8, 9e-6}}) {
    known.wear->depth_limit = depth;
    const MetricRequest life{Metric::life_at, Argument::torque, torque};
    csv += number(torque) + "," + number(depth) + "," + number(evaluate(Motor(known), life).value) +
           ",3600\n";
  }
  const Run run(one.file(csv));
  CHECK(run.answer.outcome == "fitted");
  // the hours are exact; the fit stops where a step gains less than 1e-8
  CHECK(std::fabs(run.result().estimates[0].parameter.value / kKnown - 1) <= 1e-6);
  // Nobody plans to wear a motor out.
  CHECK_THAT(run.text(), !Contains("The next measurements"));
}

TEST_CASE("at a fold, where the Jacobian lacks rank only there, the profiles give the intervals",
          "[studies][calibrate]") {
  // An error of the phase acts as a smaller force factor whatever its sign: at zero it has a column of zeros, where a fit
  // that starts there stays. A change of the error shows that it does act.
  StudyFile sheet = read_study_file(TWUM_SOURCE_DIR "/examples/studies/calibrate-data-sheet.yaml");
  sheet.motor.design.stator.imbalance = Imbalance{};
  auto& asked = std::get<CalibrateStudy>(sheet.asked);
  REQUIRE(asked.variables.front().parameter == Parameter::force_factor);
  asked.variables.front() = DesignVariable{Parameter::phase_error};
  asked.variables.front().min = -0.3;
  asked.variables.front().max = 0.3;
  asked.starts = 1;
  const Run run(sheet);
  CHECK(run.answer.outcome == "undetermined");
  CHECK(run.result().undetermined.empty());
  CHECK_THAT(run.text(), !Contains("act only in combination"));
  // Linear extrapolations from there say nothing.
  CHECK_THAT(run.text(), Contains("The change of the answer with a fixed parameter is unknown: the "
                                  "estimates are at a fold") &&
                             !Contains("1 % larger"));
  const auto json = nlohmann::json::parse(run.json());
  CHECK(json["moves_missing"].is_string());
  REQUIRE(json["moves"].contains("frequency"));
  for (const auto& [held, move] : json["moves"].items())
    for (const auto& [name, slope] : move["slopes"].items()) CHECK(slope.is_null());
  CHECK(json["correlation"]["phase_error"]["kinetic_friction"].is_null());
  for (const auto& estimate : run.result().estimates) {
    CAPTURE(estimate.parameter.name);
    REQUIRE(std::isfinite(estimate.low));
    REQUIRE(std::isfinite(estimate.high));
    CHECK(estimate.low < estimate.parameter.value);
    CHECK(estimate.high > estimate.parameter.value);
    CHECK(estimate.low >= estimate.min);
    CHECK(estimate.high <= estimate.max);
  }
}

TEST_CASE("wrong columns of measurements are refused with place and remedy",
          "[studies][calibrate][errors]") {
  using Pair = std::pair<const char*, const char*>;
  const Pair pairs[] = {
      {"no_load_speed [rpm]\n140\n", "ok"},
      {"speed [rpm],torque [N.m],no_load_speed [rpm]\n10,1,2\n",
       "points.csv:1:13: torque: no standard deviation, which data of several kinds need; add the "
       "column 'torque_sd'"},
      {"speed [rpm],torque,torque_sd,no_load_speed,no_load_speed_sd\n10,1,0.1,,\n20,,,15,1\n",
       "ok"},
      {"speed,torque,torque_sd,no_load_speed,no_load_speed_sd\n10,1,0.1,,\n20,,,15,\n",
       "points.csv:3:9: no_load_speed_sd: empty cell"},
      {"speed,torque,no_load_speed\n1,,\n",
       "points.csv:2:1: nothing was measured; leave out the line"},
      {"electrical_power_at\n1\n", "points.csv:1:1: no column 'speed'"},
      {"speed,speed_at\n1,1\n",
       "points.csv:1:7: speed_at: read at a torque that no column gives; leave out 'speed'"},
      {"speed_at\n1\n",
       "read at a torque that no column gives; expected a column such as 'torque [N.m]'"},
      {"speed,drive_frequency_at\n1,1\n",
       "points.csv:1:7: drive_frequency_at: belongs to a torque that the drive holds at a speed"},
      {"preload [N]\n1\n", "points.csv:1:1: no column with measured values"},
      {"no_load_speed,preload [mm]\n1,1\n", "points.csv:1:15: preload: 'mm' is a length"},
      {"no_load_speed,preload\n1,-5\n", "points.csv:2:3: preload: '-5'"},
      {"no_load_sped\n1\n", "unknown column 'no_load_sped'; did you mean 'no_load_speed'?"},
      {"no_load_speed,holding_torque,weight\n1,1,1\n",
       "weight: weights of several columns; give standard deviations"},
      {"speed,speed_sd,torque\n1,1,1\n", "speed_sd: 'speed' is set, not measured"},
      {"speed,torque,kinetic_friction\n1,1,0.2\n",
       "points.csv:1:14: kinetic_friction: set here, and estimated by the study; leave out the "
       "column"},
      {"speed,electrical_power_at\n1,1\n",
       "points.csv:1:7: electrical_power_at: the motor has no such value without modal data; give "
       "resonance_frequency, modal_mass, force_factor and quality_factor under 'stator'"},
      {"frequency [Hz],impedance [ohm]\n4e4,100\n",
       "points.csv:1:16: impedance: the motor has no such value without modal data"},
      {"frequency,impedance [mm]\n1,1\n", "impedance: 'mm' is a length"},
  };
  for (const auto& [csv, message] : pairs) {
    CAPTURE(csv);
    CHECK_THAT(complaint_about(csv), Contains(message));
  }
  Case one;
  one.variables = "kinetic_friction: {min: 0.05, max: 0.5}";
  one.more = "scatter: stated";
  CHECK_THROWS_WITH(
      make_kind(one.file("speed,torque\n1,1\n")),
      Contains("points.csv:1:7: torque: no standard deviation, which 'scatter: stated' "
               "needs; add the column 'torque_sd', or leave out 'scatter'"));
  one.more = "starts: 1";
  StudyFile two = one.file("speed,torque,torque_sd\n1,0.8,0.1\n");
  std::ofstream(one.folder.path("other.csv")) << "# bench 2\nspeed,torque\n2,0.8\n";
  std::get<CalibrateStudy>(two.asked).data = {"points.csv", "other.csv"};
  CHECK_THROWS_WITH(
      make_kind(two),
      Contains("other.csv:2:7: torque: no standard deviation, which data of tables of which some "
               "give them need; add the column 'torque_sd'"));
}
