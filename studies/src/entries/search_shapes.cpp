// SPDX-License-Identifier: Apache-2.0
// Studies that search: optimum, front, sizing, calibration.
#include "entries/choice_shape.hpp"
#include "entries/columns_shape.hpp"
#include "entries/entry_shapes.hpp"
#include "entries/repeats.hpp"
#include "entries/robust_shapes.hpp"
#include "entries/solver_entry.hpp"

#include <twum/base/no_value.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>
#include <twum/optim/least_squares.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

namespace twum::inline v0_1::studies {

using namespace shapes;

namespace {

// Lines for templates.
constexpr const char* kEstimates =
    "kinetic_friction: {min: 0.05, max: 0.5}\n"
    "youngs_modulus: {min: 0.5 GPa, max: 20 GPa, scale: log}";

template <typename T>
Field<T> variables_field(const char* text) {
  return required<T>("variables", variables(text, kRanges), &T::variables);
}

// `auto`, and with it the options of a fresh study.
template <typename T>
Field<T> solver_field() {
  Field<T> field = standard<T>("solver", solver_shape(T{}.solver), &T::solver);
  field.has_standard = false;
  field.entry.fallback = T{}.solver.solver;
  field.entry.standards = {{scalar_node(T{}.solver.solver)}};
  return field;
}

template <typename T>
Field<T> start_field() {
  return hidden(optional<T>("start", folder(), &T::start, "the motor as it is"));
}

template <typename T>
bool check_search(T& /*study*/, const Given& given, Diagnostics& diagnostics) {
  check_repeats(given, diagnostics);
  check_solver(given, diagnostics);
  return true;
}

template <typename T>
bool check_robust_search(T& study, const Given& given, Diagnostics& diagnostics) {
  check_search(study, given, diagnostics);
  check_statistics(study.tolerances, study.statistics, given, diagnostics);
  check_correlations(study.tolerances, study.correlations, given, "tolerances", diagnostics);
  return true;
}

// A front under tolerances needs gradients, so integer variables and choices are not possible.
void check_robust_front(const ParetoStudy& study, const Given& given, Diagnostics& diagnostics) {
  if (study.tolerances.empty() && study.parts.empty()) return;
  if (study.solver.solver == kNsga2)
    diagnostics.add(given.find("solver")->mark, given.path("solver"),
                    quoted(kNsga2) + " together with tolerances",
                    "leave it out: a front under tolerances needs gradients");
  if (const YamlNode* choose = given.find("choose"))
    diagnostics.add(choose->mark, given.path("choose"),
                    "a front under tolerances cannot contain a choice",
                    "make one study for each set, or an optimize study");
  const YamlNode* variables = given.find("variables");
  for (const YamlEntry& entry :
       variables == nullptr ? std::vector<YamlEntry>{} : variables->entries) {
    const auto parameter = find_parameter(entry.key);
    if (parameter && info(*parameter).integer)
      diagnostics.add(entry.key_mark, given.path("variables") + "." + entry.key,
                      "a front under tolerances cannot vary a whole number",
                      "set it in the motor, and make one study for each value");
  }
}

// Two goals of a front have to be different.
bool check_front(ParetoStudy& study, const Given& given, Diagnostics& diagnostics) {
  if (const YamlNode* list = given.find("objectives")) {
    Repeats repeats(given.path("objectives"), "the objectives of a front must differ", diagnostics);
    for (const YamlNode& objective : list->items) {
      const YamlNode* goal = objective.find("maximize");
      if (goal == nullptr) goal = objective.find("minimize");
      if (goal == nullptr) continue;
      repeats.see(*goal, goal->scalar);
    }
  }
  check_robust_front(study, given, diagnostics);
  return check_robust_search(study, given, diagnostics);
}

struct Objective {
  DesignObjective goal;
};

Shape<DesignObjective> objective() {
  return shape_as<DesignObjective, Objective>(
      mapping<Objective>("one objective", goal(&Objective::goal)),
      [](Objective one) { return std::move(one.goal); },
      [](const DesignObjective& goal) { return Objective{goal}; });
}

// A motor carries a load at a speed if its torque there is at least the load. Unlike speed_at(load), the torque also
// exists for motors that cannot carry the load.
Shape<MotorLimit> duty_limit() {
  return shape_as<MotorLimit, DutyPoint>(
      duty_point(), [](const DutyPoint& duty) { return parse_limit(duty.text); },
      [](const MotorLimit& limit) {
        const auto request = limit.metric.request();
        const bool duty = request && request->metric == Metric::torque_at;
        return DutyPoint{limit.lower, duty ? request->at : kNoValue, {}};
      });
}

// Refuses integer variables, because a fit needs derivatives.
bool refuse_whole_numbers(CalibrateStudy& /*study*/, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* variables = given.find("variables");
  if (variables == nullptr) return true;
  for (const YamlEntry& entry : variables->entries) {
    const auto parameter = find_parameter(entry.key);
    if (parameter && info(*parameter).integer)
      diagnostics.add(entry.key_mark, given.path("variables") + "." + entry.key,
                      "only whole numbers, which a fit cannot estimate",
                      "set it in the motor, and make one study for each value");
  }
  return true;
}

// One file, or a list of files.
Shape<std::vector<std::string>> data_files() {
  const Shape<std::string> file = path(
      "table with columns such as speed [unit] and torque [unit]. A column may be any metric by "
      "its name; conductance, susceptance, resistance, reactance, impedance or impedance_phase of "
      "the free stator; or a parameter that was set. A metric of a point is read at the speed of "
      "its row, or in a table without speed at the torque. Optional: torque_sd [unit] and others "
      "of this kind (standard deviation s; the weight is 1/s^2, and the scatter is tested against "
      "it), or weight (factor of the squared residual; only ratios matter)",
      "points.csv");
  const auto one = shape_as<std::vector<std::string>, std::string>(
      file, [](std::string name) { return std::vector<std::string>{std::move(name)}; },
      [](const std::vector<std::string>& names) { return names.front(); });
  Shape<std::vector<std::string>> shape = one_of<std::vector<std::string>>(
      "table of measurements, or a list of tables", {one, list("tables of measurements", file)},
      [](const std::vector<std::string>& names) { return names.size() == 1 ? 0U : 1U; });
  shape.schema.example = file.schema.example;
  return shape;
}

// Values for each table need several tables with different names, and no derived parameters.
void check_per_file(const CalibrateStudy& study, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* node = given.find("per_file");
  if (node == nullptr) return;
  const auto wrong = [&](std::string found, std::string expected) {
    diagnostics.add(node->mark, given.path("per_file"), std::move(found), std::move(expected));
  };
  for (const Parameter parameter : study.per_file) {
    const auto varied = parameters_of(study.variables);
    const std::string name(info(parameter).name);
    if (std::find(varied.begin(), varied.end(), parameter) == varied.end())
      wrong(name + " is not estimated", "expected a parameter that stands in 'variables'");
    if (std::count(study.per_file.begin(), study.per_file.end(), parameter) > 1)
      wrong(name + " is named twice", "name each parameter once");
  }
  std::set<std::string> names;
  for (const std::string& path : study.data)
    names.insert(std::filesystem::path(path).filename().string());
  if (study.data.size() < 2 || names.size() < study.data.size())
    wrong(study.data.size() < 2 ? "fewer than two tables in 'data'"
                                : "equal names of tables in 'data'",
          "expected two tables or more, each with a name of its own");
  if (!study.derived.empty())
    wrong("given together with 'derived'",
          "leave out one of them: a derived parameter has one value");
}

// One path twice; another path to the same file shows when the tables are read.
void check_tables(const Given& given, Diagnostics& diagnostics) {
  const YamlNode* data = given.right("data");
  if (data == nullptr) return;
  Repeats repeats(given.path("data"), "its points would count twice; leave one of them out",
                  diagnostics);
  for (const YamlNode& table : data->items)
    repeats.see(table, std::filesystem::path(table.scalar).lexically_normal().string());
}

bool check_fit(CalibrateStudy& study, const Given& given, Diagnostics& diagnostics) {
  const optim::SolverInfo& solver =
      optim::least_squares_solvers()[static_cast<std::size_t>(study.solver)];
  if (!solver.available)
    diagnostics.add(given.find("solver")->mark, given.path("solver"),
                    "'" + solver.name + "' cannot be used: " + solver.description,
                    "one of those that 'twum solvers' lists as available");
  if (study.loss == FitLoss::huber && study.scatter == Scatter::by_column)
    diagnostics.add(given.find("loss")->mark, given.path("loss"),
                    "'huber' together with 'scatter: by-column'",
                    "one of them: the scatter of a column is estimated from squares");
  check_tables(given, diagnostics);
  check_per_file(study, given, diagnostics);
  return refuse_whole_numbers(study, given, diagnostics);
}

Shape<std::vector<Parameter>> own_per_file() {
  return list("parameters of 'variables' that have a value of their own in each table of 'data'",
              text_of<Parameter>(
                  "parameter by name", "kinetic_friction", parse_parameter,
                  [](const Parameter& parameter) { return std::string(info(parameter).name); }));
}

}  // namespace

Shape<OptimizeStudy> OptimizeStudy::shape() {
  using S = OptimizeStudy;
  Fields<S> fields{kind_field<S>(), variables_field<S>("what may be changed"), derived_field<S>(),
                   choose_field<S>()};
  fields.push_back(goal(&S::objective));
  fields.push_back(limits_field("constraints", &S::constraints));
  fields.push_back(tolerances_field<S>());
  fields.push_back(correlations_field<S>());
  fields.push_back(parts_field<S>());
  fields.push_back(solver_field<S>());
  fields.push_back(start_field<S>());
  return mapping<S>("best design under constraints", fields, check_robust_search<S>);
}

Shape<ParetoStudy> ParetoStudy::shape() {
  using S = ParetoStudy;
  auto objectives = list("two or three objectives", objective(), 2, 3);
  objectives.schema.sample = "- maximize: stall_torque\n- maximize: no_load_speed";
  return mapping<S>("trade-off front of two or three metrics",
                    {kind_field<S>(), variables_field<S>("what may be changed"), derived_field<S>(),
                     choose_field<S>(), required<S>("objectives", objectives, &S::objectives),
                     limits_field("constraints", &S::constraints), tolerances_field<S>(),
                     correlations_field<S>(), parts_field<S>(),
                     standard<S>("points", count("points of the front", "50", 2, 1e5), &S::points),
                     solver_field<S>(), start_field<S>()},
                    check_front);
}

// At rest friction holds a load without a wave, and no drive follows.
bool check_size(SizeStudy& study, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* duty = given.right("duty");
  for (std::size_t i = 0;
       study.drive == DutyDrive::follows && duty != nullptr && i < study.duty.size(); ++i)
    if (const YamlNode* speed = duty->items[i].find("speed");
        !(study.duty[i].metric.request()->at > 0))
      diagnostics.add(speed->mark, given.path("duty") + "[" + std::to_string(i) + "].speed",
                      quoted(speed->scalar) + " together with 'drive: follows'",
                      "expected a speed of more than 0 rpm");
  return check_robust_search(study, given, diagnostics);
}

Shape<SizeStudy> SizeStudy::shape() {
  using S = SizeStudy;
  auto duty = list("operating points the motor must reach", duty_limit());
  duty.schema.sample = "- {torque: 0.5 N.m, speed: 100 rpm}";
  return mapping<S>(
      "a motor that reaches a duty",
      {kind_field<S>(), variables_field<S>("what may be changed"), derived_field<S>(),
       choose_field<S>(), required<S>("duty", duty, &S::duty),
       standard<S>("drive",
                   word<DutyDrive>("how the drive reaches the points of the duty: with one fixed "
                                   "setting, or adjusted to each point",
                                   {DutyDrive::fixed, DutyDrive::follows}),
                   &S::drive),
       limits_field("limits", &S::limits), tolerances_field<S>(), correlations_field<S>(),
       parts_field<S>(),
       standard<S>("prefer",
                   wanted("metric that is minimized among the motors that reach the duty", false,
                          "max_pressure"),
                   &S::prefer),
       solver_field<S>(), start_field<S>()},
      check_size);
}

Shape<CalibrateStudy> CalibrateStudy::shape() {
  using S = CalibrateStudy;
  return mapping<S>(
      "parameters from measurements",
      {kind_field<S>(),
       optional<S>("data", data_files(), &S::data,
                   "none: the study plans the first ten measurements"),
       hidden(optional<S>("columns", shapes::columns(), &S::columns, "as in the headings")),
       required<S>("variables", shapes::variables("what is estimated", kEstimates), &S::variables),
       hidden(
           optional<S>("per_file", own_per_file(), &S::per_file, "none: one value for all tables")),
       derived_field<S>(),
       standard<S>("confidence", fraction("level of the confidence intervals", "0.95"),
                   &S::confidence),
       standard<S>(
           "scatter",
           word<Scatter>(
               "source of the width of the confidence intervals: the scatter of all residuals, the "
               "standard deviations in the data, or the scatter of each column of each table",
               {Scatter::estimated, Scatter::stated, Scatter::by_column}),
           &S::scatter),
       standard<S>("loss",
                   word<FitLoss>("loss function: squares of the residuals, or Huber's loss, which "
                                 "is linear for large residuals and so less sensitive to outliers",
                                 {FitLoss::squares, FitLoss::huber}),
                   &S::loss),
       standard<S>("starts", count("number of local fits from different starts", "8", 1, 10000),
                   &S::starts),
       standard<S>(
           "solver",
           word<FitSolver>("solver of each fit; gsl:lm is the independent implementation of GSL",
                           {FitSolver::own, FitSolver::gsl}),
           &S::solver),
       standard<S>("seed", shapes::seed(), &S::seed)},
      check_fit);
}

const char* to_string(FitSolver value) noexcept {
  return value == FitSolver::gsl ? optim::kGslFit : optim::kOwnFit;
}

const char* to_string(FitLoss value) noexcept {
  switch (value) {
    case FitLoss::squares: return "squares";
    case FitLoss::huber: return "huber";
  }
  return "unknown";
}

const char* to_string(Scatter value) noexcept {
  switch (value) {
    case Scatter::estimated: return "estimated";
    case Scatter::stated: return "stated";
    case Scatter::by_column: return "by-column";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::studies
