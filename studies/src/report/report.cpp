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
#include "stored/stored_study.hpp"
#include "telling/renderers.hpp"
#include "telling/tellings.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>

namespace twum::studies {
namespace {

void add(Json& curves, Json curve) {
  if (!curve.is_null()) curves.push_back(std::move(curve));
}

// The curves that the page of an answer shows.
struct AnswerCurves {
  const MotorDesign& base;
  std::string name;  // of the motor

  std::string member_name(const CurveResult& answer, const CurveResult::Member& member) const {
    using namespace telling;
    return answer.family ? written({name_part(answer.family->name), " ",
                                    value_part(member.value, answer.family->unit)},
                                   Writing::read)
                         : name;
  }

  Json operator()(const CurveResult& answer) const {
    Json curves = Json::array();
    for (const CurveResult::Member& member : answer.members) {
      const DesignValues values =
          answer.family ? DesignValues{{answer.family->name, member.value}} : DesignValues{};
      add(curves, curve_json(base, values, member_name(answer, member), Detail::fields));
    }
    return curves;
  }

  Json operator()(const ParetoResult& answer) const {
    Json curves = Json::array();
    for (const ParetoResult::Point& point : answer.front)
      curves.push_back(
          curve_json(base, design_values(point.report.design), "torque", Detail::torque));
    return curves;
  }

  Json operator()(const OptimizeResult& answer) const {
    Json curves = Json::array();
    add(curves, curve_json(base, design_values(answer.before_design), "before", Detail::fields));
    if (answer.found)
      add(curves,
          curve_json(base, design_values(answer.best.design), "best design", Detail::fields));
    return curves;
  }

  Json operator()(const CalibrateResult& answer) const {
    Json curves = Json::array();
    for (const std::string& file : answer.files())
      add(curves, curve_json(base, design_values(answer.motor_values(file)),
                             file.empty() ? "fitted motor" : file, Detail::fields));
    return curves;
  }

  // Studies of many motors show the curve of the study's motor.
  template <typename Other>
  Json operator()(const Other& /*answer*/) const {
    Json curves = Json::array();
    add(curves, curve_json(base, {}, name, Detail::fields));
    return curves;
  }
};

Json base_json(const MotorDesign& base) {
  Json json = Json::object();
  for (const ParameterInfo& row : parameter_table()) {
    if (is_given(base, row.parameter)) json[std::string(row.name)] = get(base, row.parameter);
  }
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

}  // namespace

std::string report_html(const StudyFile& study, const std::string& text, const StudyResult& result,
                        const ResultStore& store) {
  const MotorDesign& base = result.design;
  Json summary = summary_value(result);
  if (summary.contains("map")) summary["map"].erase("points");  // they are the rows
  const Json rows = rows_json(store);
  const telling::Sources sources{&study, &store};
  const Json limits = telling::curve_limits_json(result.answer);
  const Json design = base_json(base);
  const std::string named = text + design.dump();
  Json data{
      {"summary", summary},
      {"names", names_json(rows["columns"], limits)},
      {"limits", limits},
      {"headline", telling::headline_json(telling::headline(result))},
      {"sections", telling::sections_json(telling::sections(result, sources))},
      {"points", telling::points_json(result.answer, sources)},
      {"failures", failures_json(summary)},
      {"files", files_json(study, result)},
      {"study", text},
      {"motor", {{"name", study.motor.name}, {"design", design}}},
      {"parameters", parameters_json(named)},
      {"metrics", metrics_json(named)},
      {"reasons", reasons_json()},
      {"efficiencies", efficiencies_json()},
      {"designer", {{"motor", stated_motor_json(study.motor.name, base)}, {"units", units_json()}}},
      {"curves",
       std::visit(AnswerCurves{base, study.motor.name.empty() ? "motor" : study.motor.name},
                  result.answer)},
      {"rows", rows}};
  if (study.kind() == StudyKind::sweep) data["row_curves"] = row_curves_json(store, base);
  // The data are inserted last, so that no text in them is mistaken for a mark.
  std::string page = dressed(assets::page(), {assets::style(), assets::style_hash()},
                             {assets::script(), assets::script_hash()});
  page = filled(page, "/*UNITS*/", embedded(display_units_json(data)));
  page = filled(page, "/*CORE*/", base85(assets::core_module()));
  return filled(page, "/*DATA*/", embedded(data));
}

std::string report_markdown(const std::string& directory, const std::stop_token& stop) {
  StoredStudy stored(directory, stop);
  return telling::summary_markdown(stored.answer(), {&stored.file(), &stored.store()});
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
