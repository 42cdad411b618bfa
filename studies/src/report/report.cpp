// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/report.hpp>

#include "kinds/sample/found_motors.hpp"
#include "report/assets.hpp"
#include "report/curves.hpp"
#include "report/encode.hpp"
#include "report/names.hpp"
#include "report/page_parts.hpp"
#include "report/rows.hpp"
#include "report/tables.hpp"
#include "results/answers.hpp"
#include "results/search_words.hpp"
#include "results/standings.hpp"
#include "stored/stored_study.hpp"
#include "telling/renderers.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>
#include <twum/optim/solvers.hpp>
#include <twum/studies/fit_curves.hpp>

#include <algorithm>

namespace twum::studies {
namespace {

void add(Json& curves, Json curve) {
  if (!curve.is_null()) curves.push_back(std::move(curve));
}

// The curves that the page of an answer shows.
struct AnswerCurves {
  const MotorDesign& base;

  Json operator()(const CurveResult& answer) const {
    Json curves = Json::array();
    for (const CurveResult::Member& member : answer.members) {
      const std::string name = answer.family ? answer.family->name : "";
      const DesignValues values =
          answer.family ? DesignValues{{name, member.value}} : DesignValues{};
      add(curves, curve_json(base, values, name, Detail::fields));
    }
    return curves;
  }

  Json operator()(const ParetoResult& answer) const {
    Json curves = Json::array();
    for (const ParetoResult::Point& point : answer.front)
      curves.push_back(
          curve_json(base, design_values(point.report.design), "front", Detail::curve));
    return curves;
  }

  Json operator()(const OptimizeResult& answer) const {
    Json curves = Json::array();
    add(curves, curve_json(base, design_values(answer.before_design), "before", Detail::fields));
    if (answer.found)
      add(curves, curve_json(base, design_values(answer.best.design), "best", Detail::fields));
    return curves;
  }

  Json operator()(const CalibrateResult& answer) const {
    Json curves = Json::array();
    for (const std::string& file : answer.files())
      add(curves, curve_json(base, design_values(answer.motor_values(file)),
                             file.empty() ? "fitted" : file, Detail::fields));
    return curves;
  }

  // Studies of many motors show the curve of the study's motor.
  template <typename Other>
  Json operator()(const Other& /*answer*/) const {
    Json curves = Json::array();
    add(curves, curve_json(base, {}, "motor", Detail::fields));
    return curves;
  }
};

Json fit_json(const StudyFile& study, const CalibrateResult& answer) {
  Json json = Json::array();
  for (const FitCurve& curve : fit_curves(study, answer))
    json.push_back({{"quantity", curve.quantity},
                    {"unit", curve.unit},
                    {"over", {{"name", curve.over.name}, {"unit", curve.over.unit}}},
                    {"set", values_json(curve.set)},
                    {"file", curve.file},
                    {"at", base64(curve.at)},
                    {"value", base64(curve.value)},
                    {"half", base64(curve.half)},
                    {"points", curve.points}});
  return json;
}

Json base_json(const MotorDesign& base) {
  Json json = Json::object();
  for (const ParameterInfo& row : parameter_table()) {
    if (is_given(base, row.parameter)) json[std::string(row.name)] = get(base, row.parameter);
  }
  return json;
}

// The ranges of a search's variables, SI.
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

// Motor files of the answer, in the order of its points; empty if a design is not a valid motor.
Json files_json(const StudyFile& study, const StudyResult& result) {
  Json json = Json::array();
  try {
    for (const FoundMotor& found : found_motors(study, result))
      json.push_back({{"file", found.file}, {"text", found_motor_text(found, result)}});
  } catch (const InputError&) {
    return Json::array();
  }
  return json;
}

Json global_solvers_json() {
  Json json = Json::array();
  for (const optim::SolverInfo& solver : optim::solvers())
    if (solver.global) json.push_back(solver.name);
  return json;
}

}  // namespace

std::string report_html(const StudyFile& study, const std::string& text, const StudyResult& result,
                        const ResultStore& store) {
  const MotorDesign& base = result.design;
  const Json summary = summary_value(result);
  const Json rows = rows_json(store);
  Json data{
      {"summary", summary},
      {"names", names_json(summary, rows["columns"])},
      {"standings", standings_json(result.answer)},
      {"headline", telling::headline_json(telling::headline(result))},
      {"sections", telling::sections_json(telling::sections(result))},
      {"points", telling::points_json(result.answer)},
      {"failures", failures_json(summary)},
      {"files", files_json(study, result)},
      {"global_solvers", global_solvers_json()},
      {"study", text},
      {"motor", {{"name", study.motor.name}, {"design", base_json(base)}}},
      {"parameters", parameters_json()},
      {"metrics", metrics_json()},
      {"reasons", reasons_json()},
      {"designer", {{"motor", stated_motor_json(study.motor.name, base)}, {"units", units_json()}}},
      {"ranges", ranges_json(study)},
      {"curves", std::visit(AnswerCurves{base}, result.answer)},
      {"rows", rows}};
  if (study.kind() == StudyKind::sweep) data["row_curves"] = row_curves_json(store, base);
  if (const auto* fit = std::get_if<CalibrateResult>(&result.answer))
    data["fit"] = fit_json(study, *fit);
  // The data are inserted last, so that no text in them is mistaken for a mark.
  std::string page = dressed(assets::page(), {assets::style(), assets::style_hash()},
                             {assets::script(), assets::script_hash()});
  page = filled(page, "/*UNITS*/", embedded(display_units_json(data)));
  page = filled(page, "/*CORE*/", base64(assets::core_module()));
  return filled(page, "/*DATA*/", embedded(data));
}

std::string report_markdown(const std::string& directory, const std::stop_token& stop) {
  return summary_markdown(StoredStudy(directory, stop).answer());
}

std::string write_report(const std::string& directory, const std::stop_token& stop) {
  StoredStudy stored(directory, stop);
  const StudyResult result = stored.answer();
  ResultFolder& folder = stored.folder();
  folder.write(ResultFolder::kReport,
               report_html(stored.file(), stored.text(), result, stored.store()));
  folder.check_in_place();
  return folder.file(ResultFolder::kReport);
}

}  // namespace twum::studies
