// SPDX-License-Identifier: Apache-2.0
#include "search_support.hpp"
#include "support/motor_files.hpp"

#include <twum/base/error.hpp>
#include <twum/io/value_error.hpp>
#include <twum/motors/varied_parameters.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using P = Parameter;

namespace {

MotorDesign ring() { return read_motor_file(test::motor_path("ring-60")).design; }

// Refused by the reader or by the rules together.
std::string refusal(std::vector<Parameter> varied,
                    const std::vector<std::pair<Parameter, const char*>>& rules) {
  try {
    std::vector<DerivedParameter> derived;
    for (const auto& [parameter, text] : rules) derived.push_back(parse_derived(parameter, text));
    const VariedParameters all(ring(), std::move(varied), std::move(derived));
    return "";
  } catch (const ValueError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a derived parameter follows from others, whatever the order of the rules",
          "[studies][derived]") {
  // b = 0.15 r, a = b / 2: written so that what is read comes last.
  const VariedParameters varied(ring(), {P::contact_radius},
                                {parse_derived(P::neutral_plane_distance, "contact_width / 2"),
                                 parse_derived(P::contact_width, "0.15 * contact_radius")});
  const MotorDesign motor = varied.motor(std::vector<double>{0.04});
  CHECK(get(motor, P::contact_width) == Approx(0.006).epsilon(1e-15));
  CHECK(get(motor, P::neutral_plane_distance) == Approx(0.003).epsilon(1e-15));
  CHECK(get(motor, P::preload) == get(ring(), P::preload));
}

TEST_CASE("a rule may read what follows from a derived parameter in the motor",
          "[studies][derived]") {
  // G follows from E; E is derived. G = E / (2 (1 + nu)) by hand.
  const VariedParameters varied(ring(), {P::preload},
                                {parse_derived(P::shear_viscosity, "shear_modulus * 1 ns"),
                                 parse_derived(P::youngs_modulus, "preload * 1e7 m^-2")});
  const MotorDesign motor = varied.motor(std::vector<double>{200});
  CHECK(get(motor, P::youngs_modulus) == Approx(2e9).epsilon(1e-15));
  CHECK(get(motor, P::shear_viscosity) == Approx(2e9 / (2 * 1.35) * 1e-9).epsilon(1e-14));
}

TEST_CASE("derived parameters that cannot be are refused", "[studies][derived][error]") {
  using Rule = std::pair<Parameter, const char*>;
  CHECK(refusal({P::preload}, {Rule{P::contact_width, "2 * contact_width"}}) ==
        "contact_width follows from itself: contact_width from contact_width; leave out one of "
        "these rules");
  CHECK(refusal({P::preload}, {Rule{P::contact_width, "2 * contact_radius"},
                               Rule{P::contact_radius, "thickness * 50"},
                               Rule{P::thickness, "contact_width / 40"}}) ==
        "contact_width follows from itself: contact_width from contact_radius, contact_radius "
        "from thickness, thickness from contact_width; leave out one of these rules");
  CHECK(refusal({P::contact_width}, {Rule{P::contact_width, "4 mm"}}) ==
        "contact_width is varied or derived already; leave out one of the two");
  CHECK(refusal({P::poisson_ratio}, {Rule{P::shear_modulus, "youngs_modulus / 3"}}) ==
        "shear_modulus and poisson_ratio exclude each other; leave out one of the two");
  CHECK(refusal({P::preload}, {Rule{P::contact_width, "2 * preload"}}) ==
        "'2 * preload' is a force [N]; expected a length [m] such as '4 mm'");
  CHECK(refusal({P::preload}, {Rule{P::preload, "2 N * stall_torque / 1 N.m"}}) ==
        "'stall_torque' is a metric; a derived parameter follows from parameters, such as '0.15 * "
        "contact_radius'");
}

TEST_CASE("a derived value that no motor has is a failure of that design by name",
          "[studies][derived][error]") {
  const auto reason = [](const char* rule, double preload) -> std::string {
    const VariedParameters varied(ring(), {P::preload}, {parse_derived(P::contact_width, rule)});
    try {
      varied.motor(std::vector<double>{preload});
      return "";
    } catch (const EvaluationError& error) {
      return error.reason();
    }
  };
  CHECK(reason("preload * 1 m/N", 160) == "contact_width: out-of-range");
  CHECK(reason("1 mm / sqrt((preload - 100 N) / 1 N)", 50) == "contact_width: undefined");
  CHECK(reason("1 mm / sqrt((preload - 100 N) / 1 N)", 101).empty());
}

TEST_CASE("gradients go through what is derived", "[studies][derived]") {
  DesignProblem question{ring(), {}, {}, {}};
  question.vary(P::contact_radius, 0.02, 0.04).vary(P::thickness, 1e-4, 1e-3);
  question.vary(P::kinetic_friction, 0.1, 0.4);
  question.derive(P::neutral_plane_distance, "contact_width * 0.7");
  question.derive(P::contact_width, "sqrt(contact_radius * thickness)");
  question.derive(P::youngs_modulus, "3 GPa * (thickness / 0.3 mm)^0.5");
  question.derive(P::static_friction, "kinetic_friction^0.9");
  question.maximize("peak_power / contact_width");
  question.limit("no_load_speed >= 100 rpm").limit("torque_at(60 rpm) >= 0.1 N.m");
  const optim::Problem problem = motor_problem(question);
  const std::vector<double> at{0.027, 2.5e-4, 0.23};
  const optim::Evaluation here = problem.evaluate(at, true);
  REQUIRE(here.ok());
  for (std::size_t i = 0; i < problem.responses(); ++i) {
    for (std::size_t j = 0; j < at.size(); ++j) {
      CAPTURE(i, j);
      const auto central = [&](double step) {
        std::vector<double> left = at, right = at;
        left[j] -= step;
        right[j] += step;
        return (problem.evaluate(right, false).values[i] -
                problem.evaluate(left, false).values[i]) /
               (2 * step);
      };
      const double step = 1e-4 * at[j];
      const double expected = (4 * central(step / 2) - central(step)) / 3;
      // Metrics are good to about 1e-11 with mu_0 > mu; over a step of 1e-4 that is 1e-7 of the value.
      CHECK(std::fabs(here.jacobian[i * at.size() + j] - expected) * at[j] <=
            1e-6 * std::fabs(here.values[i]));
    }
  }
}

TEST_CASE("a search keeps what is tied, and shows it in rows, report and motor file",
          "[studies][derived]") {
  const StudyFile file = test::study_of(
      "ring-60", "",
      "{kind: optimize, variables: {contact_radius: {min: 20 mm, max: 35 mm}, preload: {min: 60 N, "
      "max: 300 N}}, derived: {contact_width: 0.15 * contact_radius}, maximize: peak_power, "
      "constraints: [max_pressure <= 2 MPa]}");
  const test::Search search(file);
  CHECK(search.answer.outcome == "optimal");
  const std::vector<NamedValue>& best = search.optimum().best.design;
  CHECK(best.size() == 3);
  CHECK(test::value(best, "contact_width") == 0.15 * test::value(best, "contact_radius"));
  // Pressure is preload over area: wider is better, and so the limit binds.
  CHECK(search.optimum().best.constraints[0].active);
  for (const StoredRow& row : search.rows()) CHECK(row.values[2] == 0.15 * row.values[0]);
}

TEST_CASE("samples show what follows from their variables", "[studies][derived]") {
  const StudyFile file = test::study_of(
      "ring-60", "",
      "{kind: sweep, sampling: grid, variables: {contact_radius: [20 mm, 30 mm]}, derived: "
      "{contact_width: 0.1 * contact_radius}, metrics: [max_pressure]}");
  const test::Search sweep(file);
  CHECK(sweep.kind->columns().back().name == "contact_width");
  const std::vector<StoredRow> rows = sweep.rows();
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].values.back() == 0.1 * 0.02);
  CHECK(rows[1].values.back() == 0.1 * 0.03);
  // Of the same motor given outright.
  const std::vector<MetricExpression> pressure{parse_metric("max_pressure")};
  MetricValue expected;
  ExpressionEvaluator(pressure).evaluate(
      Motor(with(ring(), std::vector<ParameterValue>{{P::contact_radius, 0.03},
                                                     {P::contact_width, 0.1 * 0.03}})),
      std::span(&expected, 1));
  CHECK(rows[1].values[1] == expected.value);
}

TEST_CASE("a study whose rules go round is refused at its place", "[studies][derived][error]") {
  CHECK_THROWS_WITH(
      test::study_of("ring-60", "",
                     "{kind: sweep, sampling: grid, variables: {preload: [100 N]}, derived: "
                     "{contact_width: contact_radius / 5, contact_radius: contact_width * 5}, "
                     "metrics: [max_pressure]}"),
      Catch::Contains("study.derived: contact_width follows from itself: contact_width from "
                      "contact_radius, contact_radius from contact_width; leave out"));
}
