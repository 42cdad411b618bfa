// SPDX-License-Identifier: Apache-2.0
// Questions about a motor and their answers.
#include "conversions.hpp"
#include "interruptible.hpp"
#include "own_metric.hpp"
#include "parts.hpp"
#include "problem_state.hpp"

#include <twum/base/error.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/parameter_set.hpp>
#include <twum/motors/settings.hpp>
#include <twum/studies/sizing.hpp>

#include <array>
#include <memory>

namespace twum::inline v0_1::python {
namespace {

using namespace py::literals;
using studies::DesignAnswer;
using studies::DesignProblem;

using Class = py::class_<PyProblem, std::shared_ptr<PyProblem>>;

PyProblem& vary(PyProblem& self, const std::string& name, const py::object& min,
                const py::object& max, const std::string& scale, const py::object& start) {
  constexpr std::array<std::string_view, 2> kScales{"linear", "log"};
  if (scale != kScales[0] && scale != kScales[1])
    throw InputError("scale: " + studies::quoted(scale) + "; " +
                     studies::did_you_mean(scale, kScales));
  const Parameter parameter = studies::parse_parameter(name);
  studies::DesignVariable variable;
  variable.parameter = parameter;
  variable.min = to_parameter_value(parameter, min);
  variable.max = to_parameter_value(parameter, max);
  if (scale == kScales[1]) variable.scale = optim::Scale::log;
  if (!start.is_none()) variable.start = to_parameter_value(parameter, start);
  self.problem.variables.push_back(variable);
  return self;
}

PyProblem& derive(PyProblem& self, const std::string& name, const std::string& expression) {
  self.problem.derive(studies::parse_parameter(name), expression);
  return self;
}

// A set as a file, or as the parameters themselves.
studies::ParameterSet to_set(const std::string& name, const py::handle& given) {
  if (py::isinstance<py::dict>(given))
    return {name, {}, to_parameter_values(py::cast<py::dict>(given))};
  const auto path = to_text("path of a set", py::str(given));
  return {name, path, studies::read_parameter_set(studies::read_source(path))};
}

PyProblem& choose(PyProblem& self, const std::string& name, const py::object& sets) {
  std::vector<studies::ParameterSet> list;
  if (py::isinstance<py::dict>(sets)) {
    for (const auto& [set, given] : py::cast<py::dict>(sets))
      list.push_back(to_set(py::cast<std::string>(set), given));
  } else if (py::isinstance<py::str>(sets)) {
    throw py::type_error(
        "sets: expected a list of paths, or a dict from names to paths or parameters");
  } else {
    for (const py::handle& path : sets) list.push_back(to_set(py::str(path), path));
  }
  self.problem.choose(name, std::move(list));
  return self;
}

// --- options from keywords

template <typename T>
void take(const py::dict& from, const char* name, T& to) {
  if (!from.contains(name)) return;
  try {
    to = py::cast<T>(from[name]);
  } catch (const py::cast_error&) {
    throw py::type_error(std::string(name) + ": not of the right type");
  }
  from.attr("pop")(name);
}

// Takes `stop` and `progress` out of the keywords.
Watch watch_of(const py::kwargs& keywords) {
  py::object stop = py::none(), progress = py::none();
  take(keywords, "stop", stop);
  take(keywords, "progress", progress);
  return {std::move(stop), std::move(progress)};
}

optim::SolveOptions solve_options(py::dict from) {
  optim::SolveOptions options;
  take(from, "solver", options.solver);
  take(from, "starts", options.starts);
  take(from, "scan", options.scan);
  take(from, "tolerance", options.tolerance);
  take(from, "seed", options.seed);
  take(from, "max_evaluations", options.budget.evaluations);
  take(from, "max_seconds", options.budget.seconds);
  take(from, "jobs", options.jobs);
  for (const auto& [key, value] : from) {
    constexpr std::array<std::string_view, 10> kNames{
        "solver",          "starts",      "scan", "tolerance", "seed",
        "max_evaluations", "max_seconds", "jobs", "stop",      "progress"};
    const auto name = to_text("name", key);
    throw InputError("unknown option " + studies::quoted(name) + "; " +
                     studies::did_you_mean(name, kNames));
  }
  return options;
}

// --- answers as objects

py::dict named_values(const DesignProblem& problem, std::span<const double> design) {
  py::dict values;
  for (std::size_t j = 0; j < problem.variables.size() && j < design.size(); ++j)
    values[to_py(info(problem.variables[j].parameter).name)] = design[j];
  return values;
}

py::dict chosen_names(const DesignProblem& problem, std::span<const double> design) {
  py::dict names;
  if (design.empty()) return names;
  const auto sets = chosen_sets(problem, design);
  for (std::size_t i = 0; i < sets.size(); ++i)
    names[py::str(problem.choices[i].name)] = sets[i]->name;
  return names;
}

py::dict certificate_dict(const optim::Certificate& certificate) {
  const py::list findings =
      list_of(certificate.findings, [](const optim::Finding& finding) { return finding.text; });
  return py::dict("passed"_a = certificate.passed, "infeasibility"_a = certificate.infeasibility,
                  "stationarity"_a = certificate.stationarity,
                  "complementarity"_a = certificate.complementarity,
                  "curvature"_a = certificate.curvature, "gain"_a = certificate.gain,
                  "second_order"_a = certificate.second_order, "findings"_a = findings,
                  "reason"_a = certificate.reason);
}

py::list limits_list(const optim::Certificate& certificate) {
  return list_of(certificate.limits, [](const optim::Activity& one) {
    return py::dict(
        "text"_a = one.name, "bound"_a = one.is_bound, "value"_a = one.value, "limit"_a = one.limit,
        "violation"_a = one.violation, "tolerance"_a = one.tolerance, "active"_a = one.active,
        "multiplier"_a = one.multiplier, "unit"_a = one.unit, "price_unit"_a = one.price_unit);
  });
}

py::list relaxation_list(const optim::Infeasibility& infeasibility) {
  return list_of(infeasibility.relaxations, [](const optim::Relaxation& one) {
    return py::dict("text"_a = one.name, "limit"_a = one.limit, "amount"_a = one.amount,
                    "amount_alone"_a = one.amount_alone);
  });
}

py::list impossible_list(const optim::Infeasibility& infeasibility) {
  return list_of(infeasibility.impossible, [](const optim::Impossible& one) {
    return py::dict("text"_a = one.name, "limit"_a = one.limit, "best"_a = one.best,
                    "certified"_a = one.certified, "ends"_a = one.ends);
  });
}

py::list ranges_list(const optim::Infeasibility& infeasibility) {
  return list_of(infeasibility.ranges, [](const optim::RangeEnd& end) {
    return py::dict("variable"_a = end.variable, "side"_a = to_string(end.side),
                    "limit"_a = end.limit, "limit_alone"_a = end.limit_alone);
  });
}

py::dict objective_dict(const DesignProblem& problem, const optim::Evaluation& evaluation) {
  py::dict values;
  for (std::size_t k = 0; k < problem.objectives.size() && k < evaluation.values.size(); ++k)
    values[py::str(problem.objectives[k].metric.text)] = evaluation.values[k];
  return values;
}

py::dict scan_dict(const optim::Scan& scan) {
  return py::dict("designs"_a = scan.designs, "feasible"_a = scan.feasible,
                  "better"_a = scan.better, "replaced"_a = scan.replaced, "before"_a = scan.before);
}

// What one search found.
py::object optimum(const PyProblem& self, const DesignAnswer& answer) {
  const optim::Result& search = answer.search;
  return attribute_of_results("Optimum")(
      "outcome"_a = to_string(search.outcome), "motor"_a = PyMotor{self.name, Motor(answer.motor)},
      "design"_a = named_values(self.problem, search.design),
      "choice"_a = chosen_names(self.problem, search.design),
      "objective"_a = objective_dict(self.problem, search.evaluation),
      "limits"_a = limits_list(search.certificate),
      "certificate"_a = certificate_dict(search.certificate),
      "relaxation"_a = relaxation_list(search.infeasibility),
      "impossible"_a = impossible_list(search.infeasibility),
      "ranges"_a = ranges_list(search.infeasibility), "scan"_a = scan_dict(search.scan),
      "solver"_a = search.solver, "evaluations"_a = search.counters.evaluations,
      "failures"_a = search.counters.failures);
}

// A point of a front, which has no search of its own.
py::object optimum(const PyProblem& self, const MotorDesign& motor,
                   const optim::FrontPoint& point) {
  const optim::Certificate& certificate = point.certificate;
  return attribute_of_results("Optimum")(
      "outcome"_a = certificate.passed ? "optimal" : "feasible",
      "motor"_a = PyMotor{self.name, Motor(motor)},
      "design"_a = named_values(self.problem, point.design),
      "choice"_a = chosen_names(self.problem, point.design),
      "objective"_a = objective_dict(self.problem, point.evaluation),
      "limits"_a = limits_list(certificate), "certificate"_a = certificate_dict(certificate),
      "relaxation"_a = py::list(), "impossible"_a = py::list(), "ranges"_a = py::list(),
      "scan"_a = py::dict(), "solver"_a = "", "evaluations"_a = 0, "failures"_a = py::dict());
}

// "<twum.DesignProblem of 'ring-60': varies preload, maximizes peak_power, limit max_pressure <= 3 MPa>"
std::string problem_text(const PyProblem& self) {
  const DesignProblem& problem = self.problem;
  std::vector<std::string> parts;
  for (const studies::DesignVariable& one : problem.variables)
    parts.push_back("varies " + std::string(info(one.parameter).name));
  for (const studies::DerivedParameter& one : problem.derived)
    parts.push_back("derives " + std::string(info(one.parameter).name));
  for (const studies::DesignChoice& one : problem.choices) parts.push_back("chooses " + one.name);
  for (const studies::DesignObjective& one : problem.objectives)
    parts.push_back((one.maximize ? "maximizes " : "minimizes ") + one.metric.text);
  for (const studies::MotorLimit& one : problem.limits) parts.push_back("limit " + one.text);
  std::string text = "<twum.DesignProblem";
  if (!self.name.empty()) text += " of " + studies::quoted(self.name);
  for (const std::string& part : parts) text += (&part == parts.data() ? ": " : ", ") + part;
  return text + ">";
}

// --- what is asked

// Runs search(options), which a stop, Ctrl-C or an exception of `progress` ends.
template <typename Search>
auto watched(RunningCall& call, const py::kwargs& keywords, Search search) {
  Watch watch = watch_of(keywords);
  optim::SolveOptions options = solve_options(keywords);
  options.observer = [&](const optim::Observation&) { watch.count(1); };
  return run_interruptible(
      call,
      [&](std::stop_token stop) {
        options.stop = stop;
        return search(options);
      },
      [&] { watch.poll(call); });
}

py::object solve_problem(const PyProblem& self, const py::kwargs& keywords) {
  RunningCall call;
  return optimum(self, watched(call, keywords, [&](const optim::SolveOptions& options) {
                   return solve(self.problem, options);
                 }));
}

py::list front_of(const PyProblem& self, std::size_t points, const py::kwargs& keywords) {
  RunningCall call;
  const studies::DesignFront front =
      watched(call, keywords, [&](const optim::SolveOptions& options) {
        optim::ParetoOptions all;
        all.solve = options;
        all.points = points;
        return solve_front(self.problem, all);
      });
  py::list list;
  for (std::size_t i = 0; i < front.motors.size(); ++i)
    list.append(optimum(self, front.motors[i], front.search.points[i]));
  return list;
}

std::vector<studies::DutyPoint> to_duty(const py::object& duty) {
  const auto point = [](const py::handle& one) {
    const auto pair = py::cast<py::sequence>(one);
    if (pair.size() != 2)
      throw InputError("duty: expected (torque, speed), such as ('0.5 N.m', '100 rpm')");
    if (py::isinstance<py::str>(pair[0]) && py::isinstance<py::str>(pair[1]))
      return studies::duty_point(to_text("duty: torque", pair[0]), to_text("duty: speed", pair[1]));
    return studies::DutyPoint{to_quantity("duty: torque", pair[0], "N.m", "0.5 N.m"),
                              to_quantity("duty: speed", pair[1], "rad/s", "100 rpm")};
  };
  if (py::isinstance<py::tuple>(duty)) return {point(duty)};
  std::vector<studies::DutyPoint> points;
  for (const py::handle& one : duty) points.push_back(point(one));
  return points;
}

studies::DutyDrive to_drive(const std::string& word) {
  constexpr std::array<std::string_view, 2> kDrives{"fixed", "follows"};
  if (word == kDrives[0]) return studies::DutyDrive::fixed;
  if (word == kDrives[1]) return studies::DutyDrive::follows;
  throw InputError("drive: " + studies::quoted(word) + "; " + studies::did_you_mean(word, kDrives));
}

py::object size_motor(const PyProblem& self, const py::object& duty, const std::string& drive_word,
                      const py::kwargs& keywords) {
  RunningCall call;
  const std::vector<studies::DutyPoint> points = to_duty(duty);
  const studies::DutyDrive drive = to_drive(drive_word);
  PyProblem sized = self;
  if (sized.problem.objectives.empty()) sized.problem.minimize("max_pressure");
  return optimum(sized, watched(call, keywords, [&](const optim::SolveOptions& options) {
                   return size(sized.problem, points, options, drive);
                 }));
}

// --- metrics that functions compute

// The functions that go with a metric that one computes; none of them goes with a text.
void require_none(const char* what, const py::object& function, const py::object& gradient) {
  if (!function.is_none() || !gradient.is_none())
    throw py::type_error(std::string(what) + ": only of a metric that a function computes");
}

PyProblem& want(PyProblem& self, bool maximize, const py::object& metric, const py::object& name,
                const py::object& gradient, const std::string& unit) {
  if (PyCallable_Check(metric.ptr()) != 0) {
    studies::OwnMetric own = to_own_metric(metric, name, gradient, unit, self.name);
    maximize ? self.problem.maximize(std::move(own)) : self.problem.minimize(std::move(own));
    return self;
  }
  require_none("name and gradient", name, gradient);
  const std::string text = to_text("metric", metric);
  maximize ? self.problem.maximize(text) : self.problem.minimize(text);
  self.problem.objectives.back().metric.text = text;  // as typed, a key of Optimum.objective
  return self;
}

PyProblem& limit(PyProblem& self, const std::string& text, const py::object& function, double lower,
                 double upper, const py::object& gradient, const std::string& unit) {
  if (function.is_none()) {
    require_none("gradient", function, gradient);
    self.problem.limit(text);
  } else {
    self.problem.limit(to_own_metric(function, py::str(text), gradient, unit, self.name), lower,
                       upper);
  }
  return self;
}

void add_goals(Class& problem) {
  for (const bool maximize : {true, false})
    problem.def(
        maximize ? "maximize" : "minimize",
        [maximize](PyProblem& self, const py::object& metric, const py::object& name,
                   const py::object& gradient, const std::string& unit) -> PyProblem& {
          return want(self, maximize, metric, name, gradient, unit);
        },
        py::arg("metric"), py::kw_only(), py::arg("name") = py::none(),
        py::arg("gradient") = py::none(), py::arg("unit") = "1",
        maximize ? "maximize(self, metric, *, name=None, gradient=None, unit='1')\n--\n\nWants a "
                   "metric to be large: a text, or a function as of limit()."
                 : "minimize(self, metric, *, name=None, gradient=None, unit='1')\n--\n\nWants a "
                   "metric to be small: a text, or a function as of limit().");
  problem.def(
      "limit", &limit, py::arg("text"), py::arg("function") = py::none(),
      py::arg("lower") = -optim::kInfinity, py::arg("upper") = optim::kInfinity, py::kw_only(),
      py::arg("gradient") = py::none(), py::arg("unit") = "1",
      "limit(self, text, function=None, lower=-inf, upper=inf, *, gradient=None, unit='1')\n--\n\n"
      "Asks for something such as 'max_pressure <= 10 MPa', or keeps function(motor), a number "
      "with\nthe name `text`, between lower and upper. gradient(motor) is a dict from names of "
      "parameters\nto derivatives, in which those that are missing are 0. Without it, solve() "
      "needs "
      "a solver\nwithout gradients. Both functions are called on other threads.");
}

// --- what is asked of a problem

void add_asking(Class& problem) {
  problem.def(
      "solve", &solve_problem,
      "solve(self, **options)\n--\n\nThe best design, an Optimum: measured again and certified, "
      "whatever a solver said.\n\nOptions: solver='auto', starts=8, scan=512, tolerance=1e-6, "
      "seed=1, "
      "max_evaluations=20000,\nmax_seconds, jobs=1,\nstop, such as a threading.Event, which ends "
      "it with the best so "
      "far;\nprogress, told the evaluations as progress(done, 0, '').\nCtrl-C ends it. Other "
      "Python threads run meanwhile.");
  problem.def("front", &front_of, py::arg("points") = 50,
              "front(self, points=50, **options)\n--\n\nThe trade-off between two or three "
              "objectives: a list "
              "of Optimum in order of the\nfirst. Options are those of solve().");
  problem.def(
      "size", &size_motor, py::arg("duty"), py::kw_only(), py::arg("drive") = "fixed",
      "size(self, duty, *, drive='fixed', **options)\n--\n\nA motor for a duty, (torque, speed) or "
      "a list of such "
      "pairs: "
      "of those within the limits\nwhose torque at each speed is at least the load, the one with "
      "the "
      "best objective, or\nthe least max_pressure if there is none. With drive='follows' the drive "
      "holds each point, and "
      "limits\nhold at each. Options are those of solve().");
}

}  // namespace

void add_problem(py::module_& module) {
  Class problem(
      module, "DesignProblem",
      "DesignProblem(motor)\n--\n\nA question about a motor: what may be changed, what is wanted, "
      "what "
      "must hold.\n\n    problem = twum.DesignProblem(motor)\n    problem.vary('preload', '60 N', "
      "'300 "
      "N')\n    problem.maximize('peak_power').limit('no_load_speed >= 100 rpm')\n    best = "
      "problem.solve()");
  problem.def(py::init([](const PyMotor& motor) {
                return PyProblem{motor.name, DesignProblem{motor.motor.design(), {}, {}, {}}};
              }),
              py::arg("motor"));
  problem.def("vary", &vary, py::arg("parameter"), py::arg("min"), py::arg("max"), py::kw_only(),
              py::arg("scale") = "linear", py::arg("start") = py::none(),
              "vary(self, parameter, min, max, *, scale='linear', start=None)\n--\n\nLets a "
              "parameter change "
              "within bounds, SI or with units; scale 'log' spreads it by ratio.");
  problem.def("derive", &derive, py::arg("parameter"), py::arg("expression"),
              "derive(self, parameter, expression)\n--\n\nTies a parameter to others: "
              "derive('contact_width', '0.15 * contact_radius').");
  problem.def(
      "choose", &choose, py::arg("name"), py::arg("sets"),
      "choose(self, name, sets)\n--\n\nLets the design have one of several sets of parameters that "
      "belong together: a list of files,\nor a dict from names to files or to dicts of parameters. "
      "Every combination of several choices is solved.");
  add_goals(problem);
  problem.def("__repr__", &problem_text);
  add_asking(problem);
  add_pickling(problem, problem_state, problem_from);
}

}  // namespace twum::inline v0_1::python
