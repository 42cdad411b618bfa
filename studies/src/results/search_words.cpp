// SPDX-License-Identifier: Apache-2.0
#include "results/search_words.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies {
namespace {

// For several goals, the improvement of each per unit of relaxation while the others stay.
void add_gains(Json& json, double multiplier, const optim::Certificate& certificate) {
  if (certificate.prices.size() < 2) return;
  json["gains"] = Json::array();
  for (const double gain : gains(multiplier, certificate))
    json["gains"].push_back(number_json(gain));
}

const char* sense_word(bool at_least) { return at_least ? "at least" : "at most"; }

Json limit_json(const LimitState& state, const optim::Certificate& certificate) {
  Json json{{"text", state.text},
            {"metric", state.metric},
            {"unit", state.unit},
            {"sense", sense_word(state.at_least)},
            {"lower", number_json(state.lower)},
            {"upper", number_json(state.upper)},
            {"value", number_json(state.value)},
            {"limit", number_json(state.limit)},
            {"violation", number_json(state.violation)},
            {"tolerance", number_json(state.tolerance)},
            {"active", state.active},
            {"multiplier", number_json(state.multiplier)},
            {"gain_per_percent", number_json(state.gain_per_percent)}};
  if (state.implied) json["implied"] = true;
  if (state.active) add_gains(json, state.multiplier, certificate);
  return json;
}

Json bound_json(const BoundState& state, const optim::Certificate& certificate) {
  Json json{{"variable", state.variable.name},
            {"side", state.upper ? "upper" : "lower"},
            {"limit", number_json(state.limit)},
            {"multiplier", number_json(state.multiplier)},
            {"gain_per_percent", number_json(state.gain_per_percent)}};
  add_gains(json, state.multiplier, certificate);
  return json;
}

Json certificate_json(const optim::Certificate& certificate) {
  Json json{{"passed", certificate.passed},
            {"second_order", certificate.second_order},
            {"reason", certificate.reason},
            {"infeasibility", number_json(certificate.infeasibility)},
            {"stationarity", number_json(certificate.stationarity)},
            {"complementarity", number_json(certificate.complementarity)},
            {"gain", number_json(certificate.gain)},
            {"curvature", number_json(certificate.curvature)},
            {"weights", certificate.weights},
            {"prices", certificate.prices},
            {"findings", Json::array()}};
  for (const optim::Finding& finding : certificate.findings)
    json["findings"].push_back({{"kind", optim::to_string(finding.kind)},
                                {"text", finding.text},
                                {"names", finding.names}});
  return json;
}

}  // namespace

Json values_json(const std::vector<NamedValue>& values) {
  Json json = Json::object();
  for (const NamedValue& value : values) json[value.name] = number_json(value.value);
  return json;
}

void add_units(Json& units, const std::vector<NamedValue>& values) {
  for (const NamedValue& value : values) units[value.name] = value.unit;
}

Json choice_json(const std::vector<ChosenSet>& choice) {
  Json json = Json::object();
  for (const ChosenSet& one : choice) json[one.choice] = one.set;
  return json;
}

std::string choice_words(const std::vector<ChosenSet>& choice) {
  std::vector<std::string> words;
  for (const ChosenSet& one : choice) words.push_back(one.choice + " " + printable(one.set));
  return enumeration(words);
}

Json goal_json(const Goal& goal) {
  return {{"metric", goal.metric}, {"sense", goal.maximize ? "maximize" : "minimize"}};
}

std::vector<double> gains(double multiplier, const optim::Certificate& certificate) {
  constexpr double kNoWeight = 1e-9;  // of a sum of 1; rounding of the least squares solution
  std::vector<double> list;
  for (std::size_t k = 0; k < certificate.prices.size(); ++k)
    list.push_back(certificate.weights[k] > kNoWeight ? multiplier / certificate.prices[k]
                                                      : std::numeric_limits<double>::quiet_NaN());
  return list;
}

bool broken(const LimitState& limit) {
  if (std::isnan(limit.violation)) return true;
  const double tolerance =
      std::isnan(limit.tolerance)
          ? optim::SolveOptions().feasibility_tolerance * std::fabs(limit.limit)
          : limit.tolerance;
  return limit.violation > tolerance;
}

bool keeps_limits(const DesignReport& report) {
  return std::none_of(report.constraints.begin(), report.constraints.end(),
                      [](const LimitState& limit) { return broken(limit); });
}

Json limits_json(const DesignReport& report) {
  const optim::Certificate& certificate = report.certificate;
  Json json{{"constraints", Json::array()}, {"bounds", Json::array()}};
  for (const LimitState& state : report.constraints)
    json["constraints"].push_back(limit_json(state, certificate));
  for (const BoundState& state : report.bounds)
    json["bounds"].push_back(bound_json(state, certificate));
  json["certificate"] = certificate_json(certificate);
  return json;
}

Json report_json(const DesignReport& report) {
  Json json = Json::object();
  if (!report.choice.empty()) json["choice"] = choice_json(report.choice);
  json["design"] = values_json(report.design);
  json["metrics"] = values_json(report.metrics);
  if (!report.statistics.empty()) json["statistics"] = values_json(report.statistics);
  json.update(limits_json(report));
  return json;
}

Json relaxation_json(const Explanation& explanation) {
  Json json{{"conflict", explanation.conflict},
            {"limits", Json::array()},
            {"impossible", Json::array()},
            {"ranges", Json::array()}};
  for (const RelaxationState& state : explanation.limits)
    json["limits"].push_back({{"text", state.text},
                              {"metric", state.metric},
                              {"unit", state.unit},
                              {"sense", sense_word(state.at_least)},
                              {"limit", number_json(state.limit)},
                              {"amount", number_json(state.amount)},
                              {"amount_alone", number_json(state.amount_alone)}});
  for (const ImpossibleState& state : explanation.impossible)
    json["impossible"].push_back({{"text", state.text},
                                  {"unit", state.unit},
                                  {"sense", sense_word(state.at_least)},
                                  {"limit", number_json(state.limit)},
                                  {"best", number_json(state.best)},
                                  {"certified", state.certified},
                                  {"ends", state.ends}});
  for (const RangeState& end : explanation.ranges)
    json["ranges"].push_back({{"variable", end.variable.name},
                              {"side", end.upper ? "upper" : "lower"},
                              {"limit", number_json(end.limit)},
                              {"limit_alone", number_json(end.limit_alone)}});
  if (!explanation.choice.empty()) json["choice"] = choice_json(explanation.choice);
  for (std::size_t i = 0; i < explanation.impossible.size(); ++i)
    if (!explanation.impossible[i].choice.empty())
      json["impossible"][i]["choice"] = choice_json(explanation.impossible[i].choice);
  return json;
}

std::string enumeration(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " and ";
    text += names[i];
  }
  return text;
}

double goal_value(const DesignReport& report, const Goal& goal) {
  const double metric = value_of(report.metrics, goal.metric);
  return std::isnan(metric) ? value_of(report.statistics, goal.metric) : metric;
}

double value_of(const std::vector<NamedValue>& values, const std::string& name) {
  for (const NamedValue& value : values) {
    if (value.name == name) return value.value;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace twum::inline v0_1::studies
