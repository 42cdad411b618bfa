// SPDX-License-Identifier: Apache-2.0
// How the answers of optimize and size move with what they hold fixed (L5.2, L5.3).
#include "search_support.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

const Move* find_move(const OptimizeResult& result, const std::string& name) {
  const auto found = std::find_if(result.moves.begin(), result.moves.end(),
                                  [&](const Move& move) { return move.held.name == name; });
  return found == result.moves.end() ? nullptr : &*found;
}

std::string set_text(const std::string& name, double value, const std::string& unit) {
  char text[80];
  std::snprintf(text, sizeof text, "{%s: %.17g %s}", name.c_str(), value, unit.c_str());
  return text;
}

// The numbers that move: variables, then the goal.
std::vector<double> answer_of(const OptimizeResult& result) {
  std::vector<double> list;
  for (const NamedValue& one : result.moving) list.push_back(one.value);
  return list;
}

// Solves again with each of some parameters at four values about its own.
void check_moves(const std::string& motor, const std::string& study,
                 const std::vector<std::pair<std::string, std::string>>& held) {
  const Search search(study_of(motor, "", study));
  const OptimizeResult& result = search.optimum();
  REQUIRE(search.answer.outcome == "optimal");
  CHECK(result.unmoved.empty());
  for (const auto& each : held) {
    const std::string &name = each.first, &unit = each.second;
    const Move* move = find_move(result, name);
    REQUIRE(move != nullptr);
    const double h = 2e-3 * move->held.value;
    const auto at = [&](double factor) {
      const Search again(
          study_of(motor, set_text(name, move->held.value + factor * h, unit), study));
      return answer_of(again.optimum());
    };
    const auto a = at(-2), b = at(-1), c = at(1), d = at(2);
    REQUIRE(a.size() == move->slopes.size());
    for (std::size_t j = 0; j < a.size(); ++j) {
      CAPTURE(name, result.moving[j].name);
      // Four points: of the order of (2e-3)^4, and the searches' 1e-8 of the range over the step.
      const double slope = (8 * (c[j] - b[j]) - (d[j] - a[j])) / (12 * h);
      CHECK(move->slopes[j] == Approx(slope).epsilon(1e-5).margin(
                                   1e-5 * std::fabs(result.moving[j].value / move->held.value)));
    }
  }
}

}  // namespace

TEST_CASE("the preload for a duty moves as friction times radius says (L5.2)",
          "[studies][size][closed-form]") {
  // At 20 rpm the whole contact slips: F_N = T / (mu r).
  const Search s(study_of("elastic-layer", "",
                          "{kind: size, variables: {preload: {min: 40 N, max: 300 N}}, "
                          "duty: [{torque: 0.5 N.m, speed: 20 rpm}]}"));
  const OptimizeResult& result = s.optimum();
  const double preload = value(result.best.design, "preload");
  for (const char* name : {"kinetic_friction", "contact_radius"}) {
    const Move* move = find_move(result, name);
    REQUIRE(move != nullptr);
    CHECK_THAT(move->slopes[0], WithinRel(-preload / move->held.value, 1e-6));
  }
  CHECK_THAT(s.text(), Contains("Change of the answer if a fixed parameter is 1 % larger") &&
                           Contains("If contact_radius were 26.77 mm instead of 26.5 mm, preload "
                                    "would be 93.4 N instead of 94.34 N."));
  CHECK_THAT(s.json(), Contains("\"moves\":{\"") && !Contains("moves_missing"));
}

TEST_CASE("optima of motors move as solving again says (L5.2, L5.3)",
          "[studies][optimize][derivative]") {
  check_moves(
      "ring-60",
      "{kind: optimize, variables: {preload: {min: 60 N, max: 400 N}, amplitude: {min: 0.8 um, "
      "max: 2.2 um}}, maximize: efficiency_at(0.5 N.m), constraints: [no_load_speed >= 100 "
      "rpm], solver: {starts: 1, tolerance: 1e-10}}",
      {{"kinetic_friction", ""}, {"thickness", "m"}, {"frequency", "Hz"}});
  check_moves("drive-60",
              "{kind: size, variables: {preload: {min: 60 N, max: 400 N}, voltage: {min: 60 V, "
              "max: 300 V}}, "
              "duty: [{torque: 0.5 N.m, speed: 110 rpm}], prefer: electrical_power_at(0.5 N.m), "
              "solver: {starts: 1, tolerance: 1e-10}}",
              {{"kinetic_friction", ""}, {"force_factor", "N/V"}});
}

TEST_CASE("sets that were chosen and whole numbers stay as they are", "[studies][optimize]") {
  const Search s(example_study("choose-lining.yaml"));
  REQUIRE(s.answer.outcome == "optimal");
  CHECK(s.optimum().unmoved.empty());
  CHECK(find_move(s.optimum(), "density") != nullptr);  // what the set gives is held
  for (const NamedValue& one : s.optimum().moving) CHECK(one.name != "lining");
}

TEST_CASE("an optimum without a derivative says why", "[studies][optimize]") {
  // Plateau torque does not depend on the amplitude: the best design is a valley.
  const Search s(
      study_of("elastic-layer", "",
               "{kind: optimize, variables: {preload: {min: 60 N, max: 100 N}, amplitude: "
               "{min: 1 um, max: 2 um}}, maximize: torque_at(1 rpm), solver: {starts: 1}}"));
  CHECK(s.optimum().moves.empty());
  CHECK_FALSE(s.optimum().unmoved.empty());
  CHECK_THAT(s.text(), Contains("The change of the answer with a fixed parameter is unknown: "));
  CHECK_THAT(s.json(), Contains("\"moves_missing\":\""));
}
