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

namespace twum::inline v0_1::studies {
namespace {

// Enough points for a smooth curve of some 700 pixels.
constexpr std::size_t kCurvePoints = 161;

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
  const KnownMetrics known(result.own_metrics);
  const MotorDesign& base = result.design;
  Json summary = summary_value(result);
  if (summary.contains("map")) summary["map"].erase("points");  // they are the rows
  const Json rows = rows_json(store);
  const std::vector<telling::MotorCurve> curves = telling::motor_curves(result, kCurvePoints);
  const telling::Sources sources{&study, &store, &curves};
  const Json design = design_json(base);
  const std::string named = text + design.dump();
  Json data{
      {"summary", summary},
      {"names", names_json(rows["columns"])},
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
      {"contact", telling::charts_json(telling::contact_charts())},
      {"efficiencies", efficiencies_json()},
      {"designer", {{"motor", stated_motor_json(study.motor.name, base)}, {"units", units_json()}}},
      {"curves", curves_json(curves)},
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

}  // namespace twum::inline v0_1::studies
