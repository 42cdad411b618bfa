// SPDX-License-Identifier: Apache-2.0
// `choose:`: sets of parameters of which a design has one.
#include "entries/resolved_study.hpp"
#include "search_support.hpp"
#include "support/motor_files.hpp"

#include <twum/optim/solve.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/verify_study.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using Catch::Contains;
using P = Parameter;
using test::ScratchFolder;
using test::Search;

namespace {

const std::string kRing = test::motor_path("ring-60");

// A study beside the files of its sets.
class Folder {
 public:
  Folder& set(const std::string& name, const std::string& text) {
    std::ofstream(scratch_.path(name)) << text;
    return *this;
  }
  std::string write(const std::string& study, const std::string& motor = kRing,
                    const std::string& name = "study.yaml") const {
    std::ofstream(scratch_.path(name))
        << "twum: 1\nmotor: " << motor << "\nstudy: " << study << "\n";
    return scratch_.path(name);
  }
  StudyFile read(const std::string& study) const { return read_study_file(write(study)); }
  std::string path(const std::string& name) const { return scratch_.path(name); }

 private:
  ScratchFolder scratch_;
};

// Two linings that differ in stiffness and friction.
Folder& linings(Folder& folder) {
  folder.set("hard.yaml",
             "name: hard\ncontact_layer: {youngs_modulus: 6 GPa, loss_factor: 0.02}\nfriction: "
             "{kinetic: 0.15, static: 0.15}\n");
  folder.set("soft.yaml",
             "contact_layer:\n  youngs_modulus: 2 GPa\n  loss_factor: 0.05\nfriction: {kinetic: "
             "0.3}\n");
  return folder;
}

constexpr const char* kRest =
    "variables: {amplitude: {min: 0.8 um, max: 2.2 um}, preload: {min: 60 N, max: 300 N}}, "
    "maximize: peak_power, constraints: [no_load_speed >= 100 rpm, wear_intensity_at(80 rpm) <= 5 "
    "kW/m^2], solver: {name: auto, starts: 3}}";

std::string content(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string refusal(const Folder& folder, const std::string& study) {
  try {
    folder.read(study);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

double goal_of(const Search& search) {
  return test::value(search.optimum().best.metrics, "peak_power");
}

DesignProblem friction_and_radius() {
  DesignProblem question{read_motor_file(kRing).design};
  question.vary(P::preload, 60, 300);
  question.choose("lining",
                  {{"low", "", {{P::kinetic_friction, 0.1}, {P::static_friction, 0.1}}},
                   {"high", "", {{P::kinetic_friction, 0.3}, {P::static_friction, 0.3}}}});
  question.choose("ring", {{"small", "", {{P::contact_radius, 0.02}}},
                           {"middle", "", {{P::contact_radius, 0.025}}},
                           {"large", "", {{P::contact_radius, 0.03}}}});
  return question;
}

}  // namespace

TEST_CASE("the best of a choice is the best of its sets, each solved alone", "[studies][choose]") {
  Folder folder;
  linings(folder);
  const Search both(folder.read(
      std::string("{kind: optimize, choose: {lining: [hard.yaml, soft.yaml]}, ") + kRest));
  // The same two motors by `set:`, without a choice.
  const Search hard(test::study_of(
      "ring-60",
      "{youngs_modulus: 6 GPa, loss_factor: 0.02, kinetic_friction: 0.15, static_friction: 0.15}",
      std::string("{kind: optimize, ") + kRest));
  const Search soft(
      test::study_of("ring-60", "{youngs_modulus: 2 GPa, loss_factor: 0.05, kinetic_friction: 0.3}",
                     std::string("{kind: optimize, ") + kRest));
  REQUIRE(hard.answer.outcome == "optimal");
  REQUIRE(soft.answer.outcome == "optimal");
  REQUIRE(both.answer.outcome == "optimal");
  REQUIRE(std::fabs(goal_of(hard) / goal_of(soft) - 1) > 0.01);  // one is clearly the better
  const bool first = goal_of(hard) > goal_of(soft);
  const Search& alone = first ? hard : soft;
  const DesignReport& best = both.optimum().best;
  REQUIRE(best.choice.size() == 1);
  CHECK(best.choice[0].choice == "lining");
  CHECK(best.choice[0].set == (first ? "hard.yaml" : "soft.yaml"));
  // A search ends within its tolerance of 1e-6 of the goal; the other has the same.
  CHECK(goal_of(both) == Approx(goal_of(alone)).epsilon(2e-6));
  // The parameters that the set gives are part of the design, as it gives them.
  CHECK(test::value(best.design, "youngs_modulus") == (first ? 6e9 : 2e9));
  CHECK(test::value(best.design, "loss_factor") == (first ? 0.02 : 0.05));
  CHECK(test::value(best.design, "kinetic_friction") == (first ? 0.15 : 0.3));
  CHECK(best.certificate.passed);
}

TEST_CASE("a set is in the motor before the variables change it", "[studies][choose]") {
  // The friction of the set, and mu_0 that keeps its ratio to it: ring-60 has 1.
  DesignProblem question{read_motor_file(kRing).design};
  question.vary(P::preload, 60, 300);
  question.derive(P::thickness, "1e-13 m/Pa * youngs_modulus");
  question.choose("lining", {{"a", "", {{P::kinetic_friction, 0.1}}},
                             {"b", "", {{P::kinetic_friction, 0.3}, {P::youngs_modulus, 2e9}}}});
  const MotorDesign motor = motor_of(question, std::vector<double>{100, 2});
  CHECK(get(motor, P::preload) == 100);
  CHECK(get(motor, P::kinetic_friction) == 0.3);
  CHECK(get(motor, P::static_friction) == Approx(0.3).epsilon(1e-15));
  CHECK(get(motor, P::thickness) == Approx(2e-4).epsilon(1e-15));  // what is derived reads the set
  CHECK(get(motor_of(question, std::vector<double>{100, 1}), P::youngs_modulus) == 3e9);
}

TEST_CASE("all combinations of several choices are solved, and the best is that of the closed form",
          "[studies][choose]") {
  // The holding torque is mu_0 F_N r: the largest of everything.
  DesignProblem question = friction_and_radius();
  question.maximize("holding_torque");
  std::set<std::pair<double, double>> seen;
  optim::SolveOptions options;
  options.starts = 1;
  options.observer = [&](const optim::Observation& one) {
    seen.insert({one.design[1], one.design[2]});
  };
  const optim::Result best = optim::solve(motor_problem(question), options);
  CHECK(best.outcome == optim::Outcome::optimal);
  CHECK(seen.size() == 6);
  const std::vector<const ParameterSet*> sets = chosen_sets(question, best.design);
  CHECK(sets[0]->name == "high");
  CHECK(sets[1]->name == "large");
  // At a bound, which a search meets to the last bit, up to the rounding of its scale.
  CHECK(best.evaluation.values[0] == Approx(0.3 * 300 * 0.03).epsilon(1e-12));
}

TEST_CASE("a response has the derivatives of its combination, and none by the choice",
          "[studies][choose]") {
  DesignProblem question = friction_and_radius();
  question.maximize("peak_power").limit("max_pressure <= 3 MPa");
  const optim::Problem problem = motor_problem(question);
  for (const double lining : {1.0, 2.0}) {
    for (const double ring : {1.0, 2.0, 3.0}) {
      DesignProblem alone{with(question.motor, std::vector<ParameterValue>{
                                                   {P::kinetic_friction, lining == 1 ? 0.1 : 0.3},
                                                   {P::static_friction, lining == 1 ? 0.1 : 0.3},
                                                   {P::contact_radius, 0.015 + 0.005 * ring}})};
      alone.vary(P::preload, 60, 300).maximize("peak_power").limit("max_pressure <= 3 MPa");
      const auto expected = motor_problem(alone).evaluate(std::vector<double>{160}, true);
      const auto found = problem.evaluate(std::vector<double>{160, lining, ring}, true);
      // The same motor up to the rounding of 0.015 + 0.005 ring.
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK(found.values[i] == Approx(expected.values[i]).epsilon(1e-9));
        CHECK(found.jacobian[3 * i] == Approx(expected.jacobian[i]).epsilon(1e-9));
        CHECK(found.jacobian[3 * i + 1] == 0);
        CHECK(found.jacobian[3 * i + 2] == 0);
      }
    }
  }
}

TEST_CASE("a choice goes together with whole numbers and derived parameters", "[studies][choose]") {
  Folder folder;
  linings(folder);
  const Search search(folder.read(
      "{kind: size, choose: {lining: [hard.yaml, {file: soft.yaml, name: Soft}]}, variables: "
      "{wavelengths: {min: 8, max: 9}, preload: {min: 60 N, max: 300 N}}, derived: {thickness: 0.2 "
      "* contact_width / 4}, duty: [{torque: 0.3 N.m, speed: 60 rpm}], solver: {name: auto, "
      "starts: "
      "1}}"));
  CHECK(search.answer.outcome == "optimal");
  const std::vector<StoredColumn> columns = search.kind->columns();
  REQUIRE(columns[2].name == "lining");
  CHECK(columns[2].words == std::vector<std::string>{"hard.yaml", "Soft"});
  CHECK(search.kind->variables() == 3);
  std::set<std::pair<double, double>> seen;
  for (const StoredRow& row : search.rows()) seen.insert({row.values[0], row.values[2]});
  CHECK(seen.size() == 4);
  CHECK(test::value(search.optimum().best.design, "thickness") == 0.2 * 4e-3 / 4);
  CHECK_THAT(search.text(), Contains("with lining and wavelengths held"));
}

TEST_CASE("static friction of a set stays above a kinetic one that is varied",
          "[studies][choose]") {
  // mu_0 varied, mu from the set: the search has to keep mu_0 >= mu of each set.
  DesignProblem question{read_motor_file(kRing).design};
  question.vary(P::static_friction, 0.15, 0.4).minimize("holding_torque");
  question.choose(
      "lining", {{"a", "", {{P::kinetic_friction, 0.1}}}, {"b", "", {{P::kinetic_friction, 0.3}}}});
  const optim::Problem problem = motor_problem(question);
  REQUIRE(problem.constraints.size() == 1);
  CHECK(problem.evaluate(std::vector<double>{0.2, 2}, false).values[1] == Approx(-0.1));
  CHECK(problem.evaluate(std::vector<double>{0.2, 1}, false).values[1] == Approx(0.1));
  const optim::Result best = optim::solve(problem, {});
  CHECK(best.design[1] == 1);
  CHECK(best.design[0] == Approx(0.15));
}

TEST_CASE("each point of a front has the set that is best there", "[studies][choose][pareto]") {
  Folder folder;
  folder.set("low.yaml", "friction: {kinetic: 0.1, static: 0.1}\n");
  folder.set("high.yaml", "friction: {kinetic: 0.3, static: 0.3}\n");
  const Search search(folder.read(
      "{kind: pareto, choose: {lining: [low.yaml, high.yaml]}, variables: {preload: {min: 60 N, "
      "max: "
      "300 N}, amplitude: {min: 1 um, max: 2 um}}, objectives: [{maximize: holding_torque}, "
      "{minimize: preload}], points: 5}"));
  CHECK(search.answer.outcome == "optimal");
  REQUIRE(search.front().front.size() == 5);
  // mu_0 F_N r: at each preload the larger friction has the larger torque.
  for (const ParetoResult::Point& point : search.front().front) {
    CHECK(point.report.choice[0].set == "high.yaml");
    CHECK(point.goals[0] == Approx(0.3 * 0.0265 * point.goals[1]).epsilon(1e-12));
  }
  CHECK_THAT(search.text(), Contains("lining is high.yaml at 5 of 5 points."));
  CHECK(search.kind_json()["front"][0]["choice"]["lining"] == "high.yaml");
}

TEST_CASE("where no combination will do, the causes name the nearest", "[studies][choose]") {
  Folder folder;
  folder.set("low.yaml", "friction: {kinetic: 0.1, static: 0.1}\n");
  folder.set("high.yaml", "friction: {kinetic: 0.3, static: 0.3}\n");
  const Search search(folder.read(
      "{kind: optimize, choose: {lining: [low.yaml, high.yaml]}, variables: {preload: {min: 60 N, "
      "max: 300 N}}, minimize: max_pressure, constraints: [holding_torque >= 3 N.m]}"));
  CHECK(search.answer.outcome == "infeasible");
  // The most there is: mu_0 F_N r = 0.3 * 300 N * 26.5 mm = 2.385 N.m.
  const Explanation& told = search.optimum().explanation;
  REQUIRE(told.choice.size() == 1);
  CHECK(told.choice[0].set == "high.yaml");
  REQUIRE(told.impossible.size() == 1);
  CHECK(told.impossible[0].best == Approx(2.385).epsilon(1e-9));
  CHECK(told.impossible[0].choice[0].set == "high.yaml");
  CHECK_THAT(search.text(), Contains("with lining high.yaml"));
  CHECK_THAT(search.text(), Contains("lining high.yaml comes nearest"));
  CHECK(search.kind_json()["relaxation"]["choice"]["lining"] == "high.yaml");
}

TEST_CASE("a result keeps the names of its sets, and verifies", "[studies][choose][run]") {
  Folder folder;
  linings(folder);
  const StudyFile file = read_study_file(folder.write(
      std::string("{kind: optimize, choose: {lining: [hard.yaml, soft.yaml]}, ") + kRest));
  const StudyResult result = run_study(file, folder.path("out"));
  const std::string table = content(folder.path("out/results.csv"));
  CHECK_THAT(table, Contains(",lining,"));
  CHECK_THAT(table, Contains(",hard.yaml,"));
  CHECK_THAT(table, Contains(",soft.yaml,"));
  const Verification found = verify_study(folder.path("out"));
  CHECK(found.complaints.empty());
  CHECK(found.certificates == 1);
  CHECK(found.rows_checked == found.rows);
  // The motor file is the motor of the answer, chosen parameters included.
  const MotorDesign best = read_motor_file(folder.path("out/best.yaml")).design;
  for (const NamedValue& value : std::get<OptimizeResult>(result.answer).best.design)
    CHECK(get(best, *find_parameter(value.name)) == value.value);
}

TEST_CASE("what the files of sets hold counts, not where they stand", "[studies][choose][run]") {
  Folder folder;
  linings(folder);
  const std::string study =
      std::string("{kind: optimize, choose: {lining: [hard.yaml, soft.yaml]}, ") + kRest;
  const StudyFile file = folder.read(study);
  run_study(file, folder.path("out"));
  const std::string hash = resolve(file).hash();
  // The study as it is kept names the files from there, and is the same study.
  CHECK(resolve(read_study_file(folder.path("out/study.yaml"))).hash() == hash);
  folder.set("soft.yaml", "friction: {kinetic: 0.31}\n");
  CHECK(resolve(folder.read(study)).hash() != hash);
  CHECK_THROWS_WITH(run_study(folder.read(study), folder.path("out")),
                    Contains("the content of a file that the study names"));
}

TEST_CASE("a choice that cannot be is refused at its place", "[studies][choose][error]") {
  Folder folder;
  linings(folder);
  folder.set("wrong.yaml", "contact_layer:\n  youngs_modulus: 3 N\n");
  folder.set("below.yaml", "friction: {static: 0.1}\n");
  folder.set("alternative.yaml", "contact_layer: {shear_modulus: 1 GPa}\n");
  const auto said = [&](const std::string& choose, const std::string& variables,
                        const std::string& more = "") {
    return refusal(folder, "{kind: optimize, choose: " + choose + ", variables: " + variables +
                               ", " + more + "maximize: peak_power}");
  };
  const std::string preload = "{preload: {min: 60 N, max: 300 N}}";
  CHECK(said("{lining: [hard.yaml]}", preload).empty());
  CHECK_THAT(said("{lining: [hard.yaml, soft.yaml]}", "{E: {min: 1 GPa, max: 2 GPa}}"),
             Contains("study.variables.E: youngs_modulus is varied, and 'hard.yaml' of 'lining' "
                      "gives it too; leave it out here, or in the files of 'lining'"));
  CHECK_THAT(said("{lining: [alternative.yaml]}", "{poisson_ratio: {min: 0.3, max: 0.4}}"),
             Contains("'alternative.yaml' of 'lining' gives shear_modulus, which cannot be given "
                      "together with it"));
  CHECK_THAT(said("{lining: [hard.yaml]}", preload, "derived: {loss_factor: \"0.1\"}, "),
             Contains("study.derived.loss_factor: loss_factor is derived, and 'hard.yaml'"));
  CHECK_THAT(said("{first: [hard.yaml], second: [soft.yaml]}", preload),
             Contains("study.choose.second[0]: youngs_modulus is given by 'hard.yaml' of 'first', "
                      "and 'soft.yaml' of 'second' gives it too"));
  CHECK_THAT(said("{thickness: [hard.yaml]}", preload),
             Contains("study.choose.thickness: 'thickness' is the name of a parameter"));
  CHECK_THAT(said("{lining: [hard.yaml, hard.yaml]}", preload),
             Contains("study.choose.lining[1]: 'hard.yaml' is given twice"));
  CHECK_THAT(
      said("{lining: [below.yaml]}", preload),
      Contains("study.choose.lining[0]: 'below.yaml' gives an invalid motor: static_friction"));
  // Errors in a file stand at their own line and column, those of the study beside them.
  const std::string both = said("{lining: [wrong.yaml, absent.yaml]}", preload);
  CHECK_THAT(both, Contains("wrong.yaml:2:19: contact_layer.youngs_modulus: '3 N' is a force [N]"));
  CHECK_THAT(both, Contains("study.choose.lining[1]: ") && Contains("absent.yaml: cannot be read"));
}

TEST_CASE("at most 64 combinations are accepted", "[studies][choose][error]") {
  DesignProblem question{read_motor_file(kRing).design};
  question.vary(P::preload, 60, 300).maximize("peak_power");
  for (const auto& [name, parameter] :
       {std::pair{"first", P::contact_radius}, {"second", P::thickness}}) {
    std::vector<ParameterSet> sets;
    for (int i = 0; i < 8; ++i)
      sets.push_back({std::to_string(i), "", {{parameter, get(question.motor, parameter)}}});
    question.choose(name, sets);
  }
  CHECK(choice_complaints(question).empty());
  question.choose("third", {{"x", "", {{P::preload, 1}}}, {"y", "", {{P::amplitude, 1e-6}}}});
  const std::vector<ChoiceComplaint> wrong = choice_complaints(question);
  REQUIRE(wrong.size() == 2);  // the preload is varied, and there are 128
  CHECK_THAT(wrong[1].found, Contains("128 combinations"));
  CHECK_THROWS_AS(motor_problem(question), InputError);
}

TEST_CASE("static friction varied beside a derived kinetic one is refused at its place",
          "[studies][derived][error]") {
  CHECK_THROWS_WITH(
      test::study_of(
          "ring-60", "",
          "{kind: optimize, variables: {static_friction: {min: 0.2, max: 0.4}}, derived: "
          "{kinetic_friction: 2 * loss_factor}, maximize: peak_power}"),
      Contains("study.derived.kinetic_friction: static_friction is varied and kinetic_friction "
               "derived; vary kinetic_friction and derive static_friction") &&
          Contains("note: varied here"));
}
