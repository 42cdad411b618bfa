// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/text_table.hpp>
#include <twum/io/words.hpp>

namespace twum::studies {
namespace {

Json design_json(const SweepResult& result, const SweepResult::Design& design) {
  if (design.variables.empty()) return nullptr;
  Json json{{"row", design.index}, {"design", Json::object()}, {"metrics", Json::object()}};
  for (std::size_t i = 0; i < result.variables.size(); ++i)
    json["design"][result.variables[i].name] = number_json(design.variables[i]);
  for (const std::size_t i : result.derived)
    json["design"][result.metrics[i].column.name] = number_json(design.metrics[i]);
  for (std::size_t i = 0; i < result.metrics.size(); ++i)
    json["metrics"][result.metrics[i].column.name] = number_json(design.metrics[i]);
  return json;
}

// "amplitude 1.6 um, preload 160 N"
std::string design_text(const SweepResult& result, const SweepResult::Design& design) {
  std::string text;
  for (std::size_t i = 0; i < design.variables.size(); ++i) {
    text += (text.empty() ? "" : ", ") + result.variables[i].name + " " +
            engineering(design.variables[i], result.variables[i].unit);
  }
  return text;
}

std::string spread_table(const SweepResult& result) {
  TextTable table{{{"metric", "lowest", "median", "highest"}}};
  for (const SweepResult::Metric& metric : result.metrics) {
    const auto cell = [&](double value) {
      return metric.count > 0 ? engineering(value, metric.column.unit) : std::string("-");
    };
    table.rows.push_back(
        {metric.column.name, cell(metric.min), cell(metric.median), cell(metric.max)});
  }
  return aligned(table);
}

std::string ends_table(const SweepResult& result) {
  TextTable table;
  for (const SweepResult::Metric& metric : result.metrics) {
    const std::string& name = metric.column.name;
    if (metric.count == 0) {
      table.rows.push_back({name, "", "no design has a value"});
    } else if (metric.min == metric.max) {
      table.rows.push_back({name, "", "the same in all designs"});
    } else {
      table.rows.push_back({name, "lowest at", design_text(result, metric.lowest)});
      table.rows.push_back({"", "highest at", design_text(result, metric.highest)});
    }
  }
  return aligned(table);
}

}  // namespace

Json answer_json(const SweepResult& result) {
  Json json{{"sampling", result.sampling}, {"designs", result.designs},
            {"stored", result.stored},     {"failed", result.failed},
            {"units", Json::object()},     {"metrics", Json::object()}};
  for (const StoredColumn& column : result.variables) json["units"][column.name] = column.unit;
  for (const SweepResult::Metric& metric : result.metrics) {
    json["units"][metric.column.name] = metric.column.unit;
    json["metrics"][metric.column.name] = {{"count", metric.count},
                                           {"min", number_json(metric.min)},
                                           {"median", number_json(metric.median)},
                                           {"max", number_json(metric.max)},
                                           {"lowest", design_json(result, metric.lowest)},
                                           {"highest", design_json(result, metric.highest)}};
  }
  return json;
}

std::string answer_text(const SweepResult& result) {
  if (result.stored == 0) return {};
  std::string text =
      (result.stored < result.designs ? std::to_string(result.stored) + " of " : "") +
      counted(result.designs, "design") + " (" + result.sampling + ")";
  if (result.failed > 0) text += ", " + std::to_string(result.failed) + " failed or incomplete";
  return text + "\n\n" + spread_table(result) + "\n" + ends_table(result);
}

}  // namespace twum::studies
