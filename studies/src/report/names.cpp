// SPDX-License-Identifier: Apache-2.0
#include "report/names.hpp"

#include <twum/io/value_error.hpp>
#include <twum/motors/reasons.hpp>
#include <twum/motors/statistic.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace twum::studies {
namespace {

const char* statistic_word(StatisticRequest::Kind kind) {
  switch (kind) {
    case StatisticRequest::Kind::mean: return "mean";
    case StatisticRequest::Kind::sd: return "sd";
    case StatisticRequest::Kind::quantile: return "quantile";
    case StatisticRequest::Kind::probability: return "probability";
    case StatisticRequest::Kind::yield: return "yield";
  }
  return "yield";
}

Json statistic_name(const StatisticRequest& statistic) {
  Json json{{"statistic", statistic_word(statistic.kind)}};
  if (!statistic.metric.text.empty()) json["of"] = statistic.metric.text;
  if (statistic.limit) json["of"] = statistic.limit->text;
  if (statistic.kind == StatisticRequest::Kind::quantile)
    json["probability"] = statistic.probability;
  return json;
}

Json metric_name(const MetricExpression& expression) {
  const MetricRequest* request = expression.request();
  if (request == nullptr || request->argument == Argument::none) return nullptr;
  if (request->argument == Argument::both)
    return {{"metric", info(request->metric).name},
            {"argument", "both"},
            {"at", request->at},
            {"torque", request->torque}};
  return {{"metric", info(request->metric).name},
          {"argument", request->argument == Argument::speed ? "speed" : "torque"},
          {"at", request->at}};
}

Json limit_name(const MotorLimit& limit) {
  Json json{{"of", limit.metric.text}, {"unit", limit.metric.unit()}};
  json["lower"] = number_json(limit.lower);
  json["upper"] = number_json(limit.upper);
  if (limit.sides.empty()) return json;
  json["sides"] = Json::array();
  for (const MetricExpression& side : limit.sides) json["sides"].push_back(side.text);
  return json;
}

bool is_limit(std::string_view text) { return text.find_first_of("<>=") != std::string_view::npos; }

// Collects the names, those within names too.
class Names {
 public:
  // Every text below an entry that holds names.
  void look(const Json& json) {
    for (const auto& [key, value] : json.items()) {
      if (value.is_string() && (key == "text" || key == "metric")) add(value);
      if (key == "conflict")
        for (const Json& text : value) add(text);
      if (key == "metrics" || key == "statistics" || key == "units" || key == "indices")
        for (const auto& [name, unused] : value.items()) add(name);
      if (value.is_structured()) look(value);
    }
  }

  void add(const std::string& text) {
    if (names_.contains(text)) return;
    try {
      add_read(text);
    } catch (const ValueError&) {
      return;  // such as a column of words, which is shown unchanged
    }
  }

  Json take() { return std::move(names_); }

 private:
  void add_read(const std::string& text) {
    if (is_statistic(text) && !is_outer_limit(text)) {
      const StatisticRequest statistic = parse_statistic(text);
      names_[text] = statistic_name(statistic);
      if (names_[text].contains("of")) add(names_[text]["of"].get<std::string>());
    } else if (is_statistic(text)) {
      const StatisticLimit limit = parse_statistic_limit(text);
      names_[text] = {{"of", limit.statistic.text},
                      {"unit", limit.statistic.unit()},
                      {"lower", number_json(limit.lower)},
                      {"upper", number_json(limit.upper)}};
      add(limit.statistic.text);
    } else if (is_limit(text)) {
      const MotorLimit limit = parse_limit(text);
      names_[text] = limit_name(limit);
      add(limit.metric.text);
      for (const MetricExpression& side : limit.sides) add(side.text);
    } else if (Json name = metric_name(parse_metric(text)); !name.is_null()) {
      names_[text] = std::move(name);
    }
  }

  // "probability(no_load_speed >= 100 rpm)" has its limit inside.
  static bool is_outer_limit(const std::string& text) {
    const std::size_t end = text.rfind(')');
    return is_limit(end == std::string::npos ? text : text.substr(end));
  }

  Json names_ = Json::object();
};

const Reason* find_reason(std::string_view word) {
  const auto found = std::ranges::find_if(
      reasons(), [&](const Reason& reason) { return to_string(reason.status) == word; });
  return found == reasons().end() ? nullptr : &*found;
}

// The meaning of each word in "speed_at(0.9 N.m): unreachable; stall_torque: undefined", each once.
std::string meaning_of(std::string_view reason) {
  std::vector<const Reason*> told;
  for (std::size_t from = 0; from < reason.size();) {
    const std::size_t end = std::min(reason.find("; ", from), reason.size());
    const std::string_view one = reason.substr(from, end - from);
    const std::size_t colon = one.rfind(": ");
    const Reason* known = find_reason(colon == one.npos ? one : one.substr(colon + 2));
    if (known != nullptr && std::ranges::find(told, known) == told.end()) told.push_back(known);
    from = end + 2;
  }
  std::string text;
  for (const Reason* known : told) text += (text.empty() ? "" : "; ") + std::string(known->meaning);
  return text;
}

}  // namespace

Json names_json(const Json& summary, const Json& columns) {
  Names names;
  names.look(summary);
  for (const Json& column : columns) names.add(column["name"]);
  return names.take();
}

Json failures_json(const Json& summary) {
  Json json = Json::object();
  for (const Json& region : summary["failure_regions"]) {
    const std::string reason = region["reason"];
    json[reason] = meaning_of(reason);
  }
  return json;
}

}  // namespace twum::studies
