// SPDX-License-Identifier: Apache-2.0
#include "results/search_words.hpp"

#include <twum/studies/text/number.hpp>
#include <twum/studies/text/text_table.hpp>
#include <twum/studies/units/engineering.hpp>

#include <algorithm>
#include <cmath>

namespace twum::studies {
namespace {

using Bound = CalibrateResult::Bound;

Json bound_json(Bound bound) {
  if (bound == Bound::none) return nullptr;
  return bound == Bound::min ? "min" : "max";
}

Json estimates_json(const CalibrateResult& result) {
  Json json = Json::object();
  for (const CalibrateResult::Estimate& e : result.estimates) {
    json[e.parameter.name] = {{"value", number_json(e.parameter.value)},
                              {"low", number_json(e.low)},
                              {"high", number_json(e.high)},
                              {"sd", number_json(e.deviation)},
                              {"at_bound", bound_json(e.bound)}};
  }
  return json;
}

Json correlation_json(const CalibrateResult& result) {
  Json json = Json::object();
  const std::size_t n = result.estimates.size();
  for (std::size_t i = 0; i < n; ++i) {
    Json row = Json::object();
    for (std::size_t j = 0; j < n; ++j)
      row[result.estimates[j].parameter.name] = number_json(result.correlation[i * n + j]);
    json[result.estimates[i].parameter.name] = std::move(row);
  }
  return json;
}

Json tests_json(const CalibrateResult& result) {
  Json json{{"exact", result.exact}, {"poor", result.poor()}};
  json["runs"] = nullptr;
  json["chi_square"] = nullptr;
  if (result.runs)
    json["runs"] = {
        {"count", result.runs->count}, {"runs", result.runs->runs}, {"p", result.runs->p}};
  if (result.chi_square)
    json["chi_square"] = {{"value", *result.chi_square},
                          {"degrees_of_freedom", result.degrees_of_freedom},
                          {"p", result.chi_square_p}};
  return json;
}

Json design_json(const CalibrateResult& result, const std::vector<double>& values) {
  if (values.empty()) return nullptr;
  Json json = Json::object();
  for (std::size_t j = 0; j < values.size(); ++j)
    json[result.estimates[j].parameter.name] = values[j];
  return json;
}

Json starts_json(const CalibrateResult& result) {
  Json json = Json::array();
  for (const CalibrateResult::Start& start : result.starts) {
    json.push_back({{"outcome", optim::to_string(start.outcome)},
                    {"word", start.word},
                    {"evaluations", start.evaluations},
                    {"residual_rms", number_json(start.residual_rms)},
                    {"design", design_json(result, start.values)}});
  }
  return json;
}

Json optima_json(const CalibrateResult& result) {
  Json json = Json::array();
  for (const CalibrateResult::Optimum& optimum : result.optima) {
    json.push_back({{"residual_rms", number_json(optimum.residual_rms)},
                    {"starts", optimum.starts},
                    {"design", design_json(result, optimum.values)}});
  }
  return json;
}

Json undetermined_json(const CalibrateResult& result) {
  Json json = Json::array();
  for (const CalibrateResult::Undetermined& set : result.undetermined)
    json.push_back({{"parameters", set.names}, {"undone_by", number_json(set.undone_by)}});
  return json;
}

Json data_json(const CalibrateResult& result) {
  Json json = Json::array();
  for (const CalibrateResult::Point& point : result.data) {
    json.push_back({{"speed", point.speed},
                    {"torque", point.torque},
                    {"weight", point.weight},
                    {"fitted", number_json(point.fitted)},
                    {"residual", number_json(point.residual)}});
  }
  return json;
}

Json units_json(const CalibrateResult& result) {
  Json json = Json::object();
  for (const CalibrateResult::Estimate& e : result.estimates)
    json[e.parameter.name] = e.parameter.unit;
  json["speed"] = "rad/s";
  for (const char* torque : {"torque", "fitted", "residual", "residual_rms", "residual_sd"})
    json[torque] = "N.m";
  return json;
}

std::string percent(double fraction) { return rounded_text(100 * fraction, 3) + " %"; }

std::string note(const CalibrateResult& result, const CalibrateResult::Estimate& e) {
  if (e.bound != Bound::none)
    return std::string("held by its ") + (e.bound == Bound::min ? "min" : "max");
  const bool free =
      std::any_of(result.undetermined.begin(), result.undetermined.end(), [&](const auto& set) {
        return std::find(set.names.begin(), set.names.end(), e.parameter.name) != set.names.end();
      });
  if (free) return "not determined";
  return e.low < e.min && e.high > e.max ? "wider than its range" : "";
}

// Value and interval in one unit, so that they can be compared at a glance.
std::string estimates_table(const CalibrateResult& result) {
  TextTable table;
  table.rows.push_back({"parameter", "value", "low", "high", "", ""});
  for (const CalibrateResult::Estimate& e : result.estimates) {
    const DisplayUnit unit = display_unit(e.parameter.value, e.parameter.unit);
    const bool interval = std::isfinite(e.low) && e.bound == Bound::none;
    const auto shown = [&](double value) { return rounded_text(value / unit.divisor, 5); };
    table.rows.push_back({e.parameter.name, shown(e.parameter.value), interval ? shown(e.low) : "-",
                          interval ? shown(e.high) : "-", unit.text, note(result, e)});
  }
  return aligned(table);
}

std::string undetermined_words(const CalibrateResult::Undetermined& set) {
  if (set.names.size() == 1)
    return "The data say nothing about " + set.names[0] + ": set it in the motor.\n";
  std::string text = enumeration(set.names) +
                     " only count together: the data do not tell them apart. Set one of them in "
                     "the motor.\n";
  if (!std::isfinite(set.undone_by)) return text;
  return text + "  (1 % more " + set.names[0] + " is undone by " +
         rounded_text(std::fabs(set.undone_by), 3) + " % " +
         (set.undone_by < 0 ? "less " : "more ") + set.names[1] + ")\n";
}

// Pairs that are determined, but hardly apart.
std::string correlation_words(const CalibrateResult& result) {
  constexpr double kStrong = 0.95;
  std::string text;
  const std::size_t n = result.estimates.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const double c = result.correlation[i * n + j];
      if (!(std::fabs(c) > kStrong)) continue;
      text += result.estimates[i].parameter.name + " and " + result.estimates[j].parameter.name +
              " are hard to tell apart: correlation " + rounded_text(c, 4) + "\n";
    }
  }
  return text;
}

std::string residual_words(const CalibrateResult& result) {
  std::string text = std::to_string(result.data.size()) + " points, residual rms " +
                     engineering(result.residual_rms, "N.m", 3);
  const auto largest = std::max_element(
      result.data.begin(), result.data.end(),
      [](const auto& a, const auto& b) { return std::fabs(a.residual) < std::fabs(b.residual); });
  text += ", largest " + engineering(largest->residual, "N.m", 3) + " at " +
          engineering(largest->speed, "rad/s", 4) + " (measured - fitted)\n";
  if (result.degrees_of_freedom == 0)
    text +=
        "As many points as parameters: there is nothing left to tell how good the estimates are.\n";
  if (result.exact) text += "The points lie on the curve to rounding.\n";
  return text;
}

std::string test_words(const CalibrateResult& result) {
  std::string text;
  if (result.chi_square) {
    text += "Scatter against the standard deviations given: chi-square " +
            rounded_text(*result.chi_square, 4) + " with " +
            std::to_string(result.degrees_of_freedom) +
            " degrees of freedom, p = " + rounded_text(result.chi_square_p, 2) + "\n";
  }
  if (result.runs) {
    text += "Signs of the residuals in order of speed: " + std::to_string(result.runs->runs) +
            " runs of " + std::to_string(result.runs->count) +
            ", p = " + rounded_text(result.runs->p, 2) + "\n";
  }
  if (result.poor())
    text +=
        "The fit is poor: the residuals are more than chance. The model lacks something, a "
        "parameter that was not estimated, or a point is wrong; the intervals mean little.\n";
  return text;
}

std::string starts_words(const CalibrateResult& result) {
  const std::size_t count = result.starts.size();
  const auto short_of =
      std::count_if(result.starts.begin(), result.starts.end(),
                    [](const auto& s) { return s.outcome != optim::Outcome::optimal; });
  std::string text;
  if (result.optima.size() == 1 && short_of == 0 && count > 1)
    text += "All " + std::to_string(count) + " starts ended in the same " +
            (result.undetermined.empty() ? "place.\n" : "valley.\n");
  if (result.optima.size() > 1) {
    text += std::to_string(count) + " starts ended in " + std::to_string(result.optima.size()) +
            " different places:\n";
    TextTable table;
    table.rows.push_back({"starts", "residual rms"});
    for (const auto& e : result.estimates) table.rows[0].push_back(e.parameter.name);
    for (const CalibrateResult::Optimum& optimum : result.optima) {
      table.rows.push_back(
          {std::to_string(optimum.starts), engineering(optimum.residual_rms, "N.m", 3)});
      for (std::size_t j = 0; j < optimum.values.size(); ++j)
        table.rows.back().push_back(
            engineering(optimum.values[j], result.estimates[j].parameter.unit));
    }
    text += aligned(table);
  }
  if (short_of > 0)
    text += std::to_string(short_of) + " of " + std::to_string(count) +
            " starts did not reach an optimum; summary.json says why.\n";
  return text;
}

}  // namespace

Json answer_json(const CalibrateResult& result) {
  return {{"estimates", estimates_json(result)},
          {"confidence", result.confidence},
          {"correlation", correlation_json(result)},
          {"residual_rms", number_json(result.residual_rms)},
          {"residual_sd", number_json(result.residual_deviation)},
          {"degrees_of_freedom", result.degrees_of_freedom},
          {"fit", tests_json(result)},
          {"undetermined", undetermined_json(result)},
          {"optima", optima_json(result)},
          {"starts", starts_json(result)},
          {"data", data_json(result)},
          {"units", units_json(result)}};
}

std::string answer_text(const CalibrateResult& result) {
  if (result.estimates.empty())
    return "No start could be evaluated: the motor has no torque at one of the speeds measured.\n";
  std::string text = "Estimates with intervals of " + percent(result.confidence) + "\n\n" +
                     estimates_table(result) + "\n";
  for (const auto& set : result.undetermined) text += undetermined_words(set);
  return text + correlation_words(result) + residual_words(result) + test_words(result) +
         starts_words(result);
}

}  // namespace twum::studies
