// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/report/report.hpp>

#include "report/assets.hpp"
#include "report/curves.hpp"
#include "report/rows.hpp"
#include "run/result_folder.hpp"

#include <twum/base/error.hpp>
#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/studies/metrics/reasons.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace twum::studies {
namespace {

Json parse_summary(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("kind"))
    throw InputError("the summary of the result cannot be read: it is no summary.json");
  return json;
}

Json parameters_json() {
  Json json = Json::object();
  for (const ParameterInfo& row : parameter_table())
    json[std::string(row.name)] = {{"symbol", row.symbol},
                                   {"unit", row.unit},
                                   {"text", row.text},
                                   {"integer", row.integer},
                                   {"part", row.file_entry.substr(0, row.file_entry.find('.'))}};
  return json;
}

Json metrics_json() {
  Json json = Json::object();
  for (const MetricInfo& row : metric_table())
    json[std::string(row.name)] = {{"unit", row.unit}, {"text", row.text}};
  return json;
}

Json reasons_json() {
  Json json = Json::object();
  for (const Reason& reason : reasons()) json[to_string(reason.status)] = reason.meaning;
  return json;
}

// The object at the end of a path of names; empty if there is none.
Json part(const Json& json, std::initializer_list<const char*> names) {
  const Json* at = &json;
  for (const char* name : names) {
    if (!at->is_object() || !at->contains(name)) return Json::object();
    at = &(*at)[name];
  }
  return at->is_object() || at->is_array() ? *at : Json::object();
}

void add(Json& curves, Json curve) {
  if (!curve.is_null()) curves.push_back(std::move(curve));
}

Json family_curves(const Json& summary, const MotorDesign& base) {
  Json curves = Json::array();
  const std::string parameter = summary.contains("family")
                                    ? summary["family"].value("parameter", std::string())
                                    : std::string();
  for (const Json& member : part(summary, {"curves"})) {
    DesignValues values;
    if (!parameter.empty() && member.contains(parameter) && member[parameter].is_number())
      values[parameter] = member[parameter].get<double>();
    add(curves, curve_json(base, values, parameter, Detail::fields));
  }
  return curves;
}

Json front_curves(const Json& summary, const MotorDesign& base) {
  Json curves = Json::array();
  for (const Json& point : part(summary, {"front"}))
    curves.push_back(
        curve_json(base, design_values(part(point, {"design"})), "front", Detail::curve));
  return curves;
}

Json search_curves(const Json& summary, const MotorDesign& base) {
  Json curves = Json::array();
  add(curves, curve_json(base, design_values(part(summary, {"before", "design"})), "before",
                         Detail::fields));
  const Json best = part(summary, {"best", "design"});
  if (!best.empty()) add(curves, curve_json(base, design_values(best), "best", Detail::fields));
  return curves;
}

DesignValues estimates(const Json& summary) {
  DesignValues values;
  const Json found = part(summary, {"estimates"});
  for (const auto& [name, estimate] : found.items()) {
    if (estimate.contains("value") && estimate["value"].is_number())
      values[name] = estimate["value"].get<double>();
  }
  const Json derived = part(summary, {"derived"});
  for (const auto& [name, value] : derived.items())
    if (value.is_number()) values[name] = value.get<double>();
  return values;
}

Json fit_json(const Json& summary, const MotorDesign& base) {
  const DesignValues values = estimates(summary);
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  double first = 0;
  double last = 0;
  for (const Json& point : part(summary, {"data"})) {
    first = std::min(first, point.value("speed", 0.0));
    last = std::max(last, point.value("speed", 0.0));
  }
  return names.empty() ? Json(nullptr) : slopes_json(base, values, names, first, last);
}

Json curves_json(StudyKind kind, const Json& summary, const MotorDesign& base) {
  switch (kind) {
    case StudyKind::curve: return family_curves(summary, base);
    case StudyKind::pareto: return front_curves(summary, base);
    case StudyKind::optimize:
    case StudyKind::size: return search_curves(summary, base);
    case StudyKind::calibrate: {
      Json curves = Json::array();
      add(curves, curve_json(base, estimates(summary), "fitted", Detail::fields));
      return curves;
    }
    default: break;
  }
  Json curves = Json::array();
  add(curves, curve_json(base, {}, "motor", Detail::fields));
  return curves;
}

Json base_json(const MotorDesign& base) {
  Json json = Json::object();
  for (const ParameterInfo& row : parameter_table()) {
    if (in_use(base, row.parameter)) json[std::string(row.name)] = get(base, row.parameter);
  }
  return json;
}

// What a search was free to choose from, SI.
Json ranges_json(const StudyFile& study) {
  Json json = Json::object();
  std::visit(
      [&]<typename S>(const S& asked) {
        if constexpr (requires { asked.solver; }) {
          for (const DesignVariable& range : asked.variables)
            json[std::string(info(range.parameter).name)] = {{"min", range.min},
                                                             {"max", range.max}};
        }
      },
      study.asked);
  return json;
}

// JSON that may stand inside an HTML script element, whatever the names in it are.
std::string embedded(const Json& json) {
  std::string text;
  for (const char letter : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (letter == '<')
      text += "\\u003c";
    else
      text += letter;
  }
  return text;
}

std::string filled(std::string_view page, std::string_view mark, std::string_view content) {
  const std::size_t at = page.find(mark);
  TWUM_ASSERT(at != std::string_view::npos);
  return std::string(page.substr(0, at)) + std::string(content) +
         std::string(page.substr(at + mark.size()));
}

std::string content_of(const std::string& path, const std::string& directory) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file)
    throw InputError(directory + ": holds no result of a study: " +
                     std::filesystem::path(path).filename().string() + " cannot be read");
  return text.str();
}

}  // namespace

std::string report_html(const StudyFile& study, const std::string& text, const std::string& summary,
                        const ResultStore& store) {
  const Json result = parse_summary(summary);
  const MotorDesign& base = study.motor.design;
  Json data{{"summary", result},
            {"study", text},
            {"motor", {{"name", study.motor.name}, {"design", base_json(base)}}},
            {"parameters", parameters_json()},
            {"metrics", metrics_json()},
            {"reasons", reasons_json()},
            {"ranges", ranges_json(study)},
            {"curves", curves_json(study.kind(), result, base)},
            {"rows", rows_json(store)}};
  if (study.kind() == StudyKind::sweep) data["row_curves"] = row_curves_json(store, base);
  if (study.kind() == StudyKind::calibrate) data["fit"] = fit_json(result, base);
  // The data go in last: nothing in them is taken for a mark.
  std::string page = filled(assets::page(), "/*STYLE*/", assets::style());
  page = filled(page, "/*SCRIPT*/", assets::script());
  return filled(page, "/*DATA*/", embedded(data));
}

std::string write_report(const std::string& directory) {
  const auto file = [&](std::string_view name) {
    return (std::filesystem::path(directory) / name).string();
  };
  const std::string summary = content_of(file(ResultFolder::kSummary), directory);
  const std::string text = content_of(file(ResultFolder::kStudy), directory);
  const StudyFile study = read_study_file(file(ResultFolder::kStudy));
  const ResultStore store(file(ResultFolder::kDatabase));
  ResultFolder folder(directory);
  folder.write(ResultFolder::kReport, report_html(study, text, summary, store));
  folder.check_in_place();
  return file(ResultFolder::kReport);
}

}  // namespace twum::studies
