// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/executor.hpp"
#include "results/answers.hpp"
#include "run/verify_checks.hpp"

#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/motors/expression.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace twum::inline v0_1::studies {
namespace {

double number_of(const Json& json) {
  return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string shown(const Json& json) { return json.dump(); }

// Checks every object in a summary that has a design and metrics.
class DesignCheck {
 public:
  DesignCheck(const StudyFile& file, const StudyKindRun& kind, const std::stop_token& stop,
              Verification& found)
      : file_(file), kind_(kind), stop_(stop), found_(found) {}

  void look(const Json& json, const std::string& path) {
    if (json.is_array()) {
      for (std::size_t i = 0; i < json.size(); ++i)
        look(json[i], path + "[" + std::to_string(i) + "]");
    }
    if (!json.is_object()) return;
    if (json.contains("design") && json.contains("metrics")) {
      check(json["design"], json["metrics"], path);
      if (json.contains("certificate")) certify(json, path);
      return;
    }
    for (const auto& [key, value] : json.items())
      look(value, path.empty() ? key : path + "." + key);
  }

  // The members of a family have their parameter where others have a design.
  void look_at_curves(const Json& summary) {
    const std::string name =
        summary.contains("family") ? summary["family"].value("parameter", "") : "";
    const Json& curves = summary["curves"];
    for (std::size_t i = 0; i < curves.size(); ++i) {
      Json design = Json::object();
      if (!name.empty()) design[name] = curves[i].value(name, Json(nullptr));
      check(design, curves[i].value("metrics", Json::object()),
            "curves[" + std::to_string(i) + "]");
    }
  }

 private:
  void check(const Json& design, const Json& metrics, const std::string& path) {
    if (stop_.stop_requested()) throw Interrupted();
    ++found_.designs;
    std::vector<MetricExpression> expressions;
    try {
      const Motor motor(with(file_.motor.design, parameters_of(design)));
      for (const auto& [name, ignored] : metrics.items()) expressions.push_back(parse_metric(name));
      std::vector<MetricValue> values(expressions.size());
      ExpressionEvaluator(expressions).evaluate(motor, values);
      for (std::size_t i = 0; i < values.size(); ++i)
        compare(expressions[i], values[i], metrics, path);
    } catch (const Interrupted&) {
      throw;
    } catch (const Error& error) {  // a name or value that the summary should not have
      complain(found_, "summary.json: " + path + ": " + error.what());
    }
  }

  void compare(const MetricExpression& expression, const MetricValue& now, const Json& metrics,
               const std::string& path) {
    const double value =
        now.status == MetricStatus::ok ? now.value : std::numeric_limits<double>::quiet_NaN();
    const Json& there = metrics[expression.text];
    if (note_deviation(found_, number_of(there), value)) return;
    complain(found_, "summary.json: " + path + ".metrics." + expression.text + " is " +
                         shown(there) + " there, " + shown(number_json(value)) + " now");
  }

  static std::vector<ParameterValue> parameters_of(const Json& design) {
    std::vector<ParameterValue> values;
    for (const auto& [name, value] : design.items()) {
      const auto parameter = find_parameter(name);
      if (!parameter) throw InputError("'" + name + "' is not a parameter");
      values.emplace_back(*parameter, number_of(value));
    }
    return values;
  }

  // The value of a variable of a report, or the number of the set that it names; nothing if it has none.
  static std::optional<double> variable_of(const Json& report, const StoredColumn& column) {
    if (column.words.empty()) {
      if (!report["design"].contains(column.name)) return {};
      return number_of(report["design"][column.name]);
    }
    const Json choice = report.value("choice", Json::object());
    const auto word =
        std::find(column.words.begin(), column.words.end(), choice.value(column.name, ""));
    if (word == column.words.end()) return {};
    return static_cast<double>(word - column.words.begin()) + 1;
  }

  void certify(const Json& report, const std::string& path) {
    const Json& there = report["certificate"];
    const bool passed = there.is_object() && there.value("passed", false);
    if (!passed) return;  // the summary claims no optimum
    std::vector<double> variables;
    const std::vector<StoredColumn> columns = kind_.columns();
    for (std::size_t i = 0; i < kind_.variables(); ++i) {
      const std::optional<double> value = variable_of(report, columns[i]);
      if (!value) return;
      variables.push_back(*value);
    }
    const std::optional<optim::Certificate> now =
        kind_.certify(variables, parameters_of(report["design"]));
    if (!now) return;
    ++found_.certificates;
    if (!now->passed && !on_a_hollow_front(*now))
      complain(found_, "summary.json: " + path + ": certified there, but now: " + now->reason);
  }

  // On a concave part of a front, points are not minima of a weighted sum. Their certificate requires feasibility and
  // stationarity only. certify() tests the curvature last.
  static bool on_a_hollow_front(const optim::Certificate& now) {
    return now.weights.size() > 1 && now.reason == "stationary, but not a minimum";
  }

  const StudyFile& file_;
  const StudyKindRun& kind_;
  const std::stop_token& stop_;
  Verification& found_;
};

// Compares all numbers and words of both, and checks that both have the same structure.
void compare_trees(const Json& there, const Json& now, const std::string& path,
                   Verification& found) {
  if (there.is_object() && now.is_object()) {
    for (const auto& [key, value] : now.items())
      compare_trees(there.contains(key) ? there[key] : Json("(missing)"), value,
                    path.empty() ? key : path + "." + key, found);
    for (const auto& [key, value] : there.items()) {
      if (path.empty() || now.contains(key)) continue;  // a summary has entries besides the answer
      complain(found, "summary.json: " + path + "." + key + " is " + shown(value) +
                          " there, but does not follow from the rows");
    }
  } else if (there.is_array() && now.is_array() && there.size() == now.size()) {
    for (std::size_t i = 0; i < now.size(); ++i)
      compare_trees(there[i], now[i], path + "[" + std::to_string(i) + "]", found);
  } else {
    const bool numbers = there.is_number() && now.is_number();
    if (numbers ? note_deviation(found, number_of(there), number_of(now)) : there == now) return;
    complain(found, "summary.json: " + path + " is " + shown(there) +
                        " there, but follows from the rows as " + shown(now));
  }
}

// Certificates under tolerances are those of rounds. Deriving the answer again has recomputed them on the last
// round's problem and has drawn the motors of each verdict again.
std::uint64_t certified_anew(const Answer& answer) {
  std::uint64_t count = 0;
  if (const auto* optimum = std::get_if<OptimizeResult>(&answer))
    count += optimum->robust && optimum->best.certificate.passed ? 1 : 0;
  if (const auto* front = std::get_if<ParetoResult>(&answer))
    for (const ParetoResult::Point& point : front->front)
      count += !point.yields.empty() && point.report.certificate.passed ? 1 : 0;
  return count;
}

}  // namespace

void verify_designs(const StudyFile& file, const StudyKindRun& kind, const Json& summary,
                    const std::stop_token& stop, Verification& found) {
  DesignCheck check(file, kind, stop, found);
  check.look(summary, "");
  if (summary.contains("curves")) check.look_at_curves(summary);
}

KindAnswer verify_answer(StudyKindRun& kind, ResultStore& store, const Json& summary,
                         const std::stop_token& stop, Verification& found) {
  const std::uint64_t before = store.rows();
  ThreadExecutor executor(kind);
  RunContext context{store, executor, stop, {}};
  KindAnswer answer = kind.run(context);
  if (stop.stop_requested()) throw Interrupted();
  store.flush();
  found.answer_checked = true;
  found.certificates += certified_anew(answer.answer);
  if (store.rows() != before) {
    complain(found, "results.db: " + std::to_string(store.rows() - before) +
                        " rows of the study are missing");
  }
  if (answer.outcome != summary.value("outcome", "")) {
    complain(found, "summary.json: outcome is '" + summary.value("outcome", "") +
                        "' there, but follows from the rows as '" + answer.outcome.c_str() + "'");
  }
  const Json now = std::visit([](const auto& one) { return answer_json(one); }, answer.answer);
  // Through a text, so that numbers are compared as they are in the file.
  compare_trees(summary, Json::parse(now.dump()), "", found);
  return answer;
}

void verify_interrupted(const ResultStore& store, const Json& summary, Verification& found) {
  // More rows are not an error: a run that resumed and was killed has not written a new summary.
  const double told = number_of(summary.value("evaluations", Json(nullptr)));
  if (static_cast<double>(store.rows()) >= told) return;
  complain(found, "results.db: holds " + std::to_string(store.rows()) +
                      " rows, but summary.json says " + shown(summary["evaluations"]) +
                      " evaluations");
}

void verify_record(const StudyResult& now, const Json& summary, Verification& found) {
  const Json record = Json::parse(summary_json(now));
  for (const char* name :
       {"kind", "motor", "evaluations", "failures", "failure_regions", "seed", "model_notes"}) {
    compare_trees(summary.contains(name) ? summary[name] : Json("(missing)"), record[name], name,
                  found);
  }
}

}  // namespace twum::inline v0_1::studies
