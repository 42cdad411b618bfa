// SPDX-License-Identifier: Apache-2.0
#include "results/move_words.hpp"
#include "results/robust_answer.hpp"
#include "results/search_words.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/text_table.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>

#include <cmath>
#include <map>

namespace twum::studies {
namespace {

Json stages_json(const OptimizeResult& result) {
  Json json = Json::array();
  for (const optim::StageReport& stage : result.stages)
    json.push_back({{"stage", stage.stage},
                    {"solver", stage.solver},
                    {"word", stage.word},
                    {"code", stage.code},
                    {"feasible", stage.feasible},
                    {"objective", number_json(stage.objective)},
                    {"evaluations", stage.evaluations}});
  for (std::size_t i = 0; i < result.slices_of_stages.size(); ++i)
    json[i]["slices"] = result.slices_of_stages[i];
  return json;
}

std::string cell(double value, const std::string& unit) {
  return std::isnan(value) ? "-" : engineering(value, unit);
}

std::string design_cell(const NamedValue& parameter, double value) {
  return std::isnan(value) ? "-" : parameter_text(parameter.name, value, parameter.unit);
}

// Sentences on integer variables, which are not part of the certificate.
std::string whole_end_words(const OptimizeResult& result, const std::string& name) {
  for (const BoundState& end : result.whole_ends) {
    if (end.variable.name == name) return end_words(end) + "; a wider range may have a better one";
  }
  return {};
}

std::string bound_words(const OptimizeResult& result, const std::string& name) {
  for (const BoundState& bound : result.best.bounds) {
    if (bound.variable.name != name) continue;
    if (bound.multiplier == 0) return end_words(bound);
    return end_words(bound) + "; " + goal_change_words(bound.gain_per_percent, result.goal) +
           " per 1 % more range";
  }
  return whole_end_words(result, name);
}

std::string design_table(const OptimizeResult& result) {
  TextTable table{{{"design", "before", "best", ""}}};
  for (const ChosenSet& one : result.best.choice)
    table.rows.push_back({one.choice, "-", printable(one.set), "chosen"});
  for (const NamedValue& value : result.best.design)
    table.rows.push_back({value.name,
                          design_cell(value, value_of(result.before_design, value.name)),
                          design_cell(value, value.value), bound_words(result, value.name)});
  return aligned(table);
}

std::string metric_table_text(const OptimizeResult& result) {
  TextTable table{{{"metric", "before", "best"}}};
  for (const NamedValue& value : result.best.metrics)
    table.rows.push_back({value.name, cell(value_of(result.before_metrics, value.name), value.unit),
                          cell(value.value, value.unit)});
  return aligned(table);
}

std::string state_words(const LimitState& limit) {
  if (std::isnan(limit.violation)) return "cannot be reached";
  if (broken(limit)) return "broken by " + engineering(limit.violation, limit.unit, 3);
  return limit.active ? "binds" : "holds";
}

// "30 mPa": what the limit tolerates. An upper end of it is as good as all digits.
std::string tolerance_words(const LimitState& limit) {
  return std::isnan(limit.tolerance) ? "" : engineering(limit.tolerance, limit.unit, 2);
}

std::string limit_table(const OptimizeResult& result) {
  if (result.best.constraints.empty()) return {};
  TextTable table{{{"limit", "best", "", "kept within", "per 1 % looser"}}};
  for (const LimitState& limit : result.best.constraints)
    table.rows.push_back(
        {limit.text, cell(limit.value, limit.unit), state_words(limit), tolerance_words(limit),
         limit.active && !broken(limit) ? goal_change_words(limit.gain_per_percent, result.goal)
                                        : ""});
  return "\n" + aligned(table);
}

// "8 x nlopt:slsqp (XTOL_REACHED)": solvers with their return codes, equal ones counted.
std::string solver_words(const OptimizeResult& result) {
  std::map<std::string, int> said;
  for (const optim::StageReport& stage : result.stages) {
    if (!stage.solver.empty()) ++said[stage.solver + " (" + stage.word + ")"];
  }
  std::string text;
  for (const auto& [word, count] : said)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " x " + word;
  return text.empty() ? text : "Solver runs: " + text + ".\n";
}

// Integer variables and choices, which the certificate holds fixed: "lining, wavelengths".
std::string whole_numbers(const OptimizeResult& result) {
  std::string names;
  for (const ChosenSet& one : result.best.choice) names += (names.empty() ? "" : ", ") + one.choice;
  for (const NamedValue& value : result.best.design)
    if (const auto p = find_parameter(value.name); p && info(*p).integer)
      names += (names.empty() ? "" : ", ") + value.name;
  return names;
}

std::string optimal_words(const OptimizeResult& result) {
  const std::string held = whole_numbers(result);
  const optim::Certificate& certificate = result.best.certificate;
  std::string text =
      certificate.second_order ? "Verified local optimum" : "Optimum to first order only";
  text += (held.empty() ? "" : " with " + held + " fixed") + ": no feasible change " +
          (held.empty() ? "" : "of the other variables ") + "improves it" +
          (certificate.second_order ? "" : " to first order") + " (stationarity " +
          rounded_text(certificate.stationarity, 2);
  if (!std::isnan(certificate.gain))
    text += ", a step could gain at most " +
            engineering(std::fabs(certificate.gain), result.goal.unit, 2);
  return text + ")";
}

std::string verdict(const OptimizeResult& result) {
  const optim::Certificate& certificate = result.best.certificate;
  std::string text = certificate.passed ? optimal_words(result)
                                        : "Not certified as an optimum: " + certificate.reason;
  if (!result.solver.empty()) text += "; found by " + result.solver;
  return text + ".\n";
}

// The result of the search for a better local optimum, which is not a proof.
std::string scan_words(const OptimizeResult& result) {
  const optim::Scan& scan = result.scan;
  if (scan.designs == 0) return {};
  const std::string sample = counted(scan.designs, "design") + " sampled over the whole range";
  const std::string limits = result.best.constraints.empty()
                                 ? ""
                                 : " (" + std::to_string(scan.feasible) + " keep the limits)";
  if (scan.better == 0) return "None of " + sample + limits + " is better.\n";
  const std::string some = std::to_string(scan.better) + " of " + sample + limits;
  const std::string before = engineering(scan.before, result.goal.unit);
  if (scan.replaced)
    return some + " were better than the " + before +
           " that the searches had ended at; a search from the best of them found this design.\n";
  return some +
         " are better, but the search from the best of them found no answer; raise "
         "max_evaluations, or start from that row of results.csv.\n";
}

Json scan_json(const optim::Scan& scan) {
  return {{"designs", scan.designs},
          {"feasible", scan.feasible},
          {"better", scan.better},
          {"replaced", scan.replaced},
          {"before", number_json(scan.before)}};
}

// Count of design variables among the numbers with derivatives; the goal comes last, if it is not one of them.
std::size_t chosen_count(const OptimizeResult& result) {
  const std::size_t count = result.moving.size();
  return count > 0 && result.moving.back().name == result.goal.metric ? count - 1 : count;
}

}  // namespace

Json answer_json(const OptimizeResult& result) {
  Json json{{"objective", goal_json(result.goal)}};
  json["best"] = result.found ? report_json(result.best) : Json(nullptr);
  if (!result.explanation.empty()) json["relaxation"] = relaxation_json(result.explanation);
  json["before"] = {{"design", values_json(result.before_design)},
                    {"metrics", values_json(result.before_metrics)}};
  if (!result.before_statistics.empty())
    json["before"]["statistics"] = values_json(result.before_statistics);
  if (result.robust) json["robust"] = robust_json(*result.robust);
  json["variables_without_influence"] = result.without_influence;
  json["moves"] = moves_json(result.moving, result.moves);
  if (!result.unmoved.empty()) json["moves_missing"] = result.unmoved;
  json["scan"] = scan_json(result.scan);
  json["solver"] = result.solver;
  json["stages"] = stages_json(result);
  json["units"] = Json::object();
  add_units(json["units"], result.before_design);
  add_units(json["units"], result.before_metrics);
  add_units(json["units"], result.best.statistics);
  return json;
}

std::string answer_text(const OptimizeResult& result) {
  if (!result.found) return {};
  const bool infeasible = !result.explanation.empty();
  std::string text;
  if (infeasible)
    text = relaxation_tables(result.explanation) + "The design with the smallest violation:\n\n";
  text += design_table(result) + limit_table(result) + "\n" + metric_table_text(result) + "\n";
  if (infeasible) return text + solver_words(result);
  text += verdict(result) + scan_words(result);
  if (!result.without_influence.empty())
    text += "Without influence at this design: " + enumeration(result.without_influence) + ".\n";
  text += finding_words(result.best.certificate) + solver_words(result) +
          moves_table(result.moving, result.moves, chosen_count(result), "best");
  if (!result.unmoved.empty())
    text += "How the optimum changes with a fixed parameter is unknown: " + result.unmoved + ".\n";
  return text;
}

}  // namespace twum::studies
