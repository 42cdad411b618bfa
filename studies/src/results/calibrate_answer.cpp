// SPDX-License-Identifier: Apache-2.0
#include "results/calibration_notes.hpp"
#include "results/calibration_words.hpp"
#include "results/moves_json.hpp"
#include "results/search_words.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

using Bound = CalibrateResult::Bound;

Json bound_json(Bound bound) {
  return bound == Bound::none ? Json(nullptr) : Json(end_word(bound));
}

bool undetermined(const CalibrateResult& result, const std::string& name) {
  return std::any_of(result.undetermined.begin(), result.undetermined.end(), [&](const auto& set) {
    return std::find(set.names.begin(), set.names.end(), name) != set.names.end();
  });
}

Json cut_off_json(const CalibrateResult::Estimate& e) {
  if (e.low_cut) return e.high_cut ? "both" : "low";
  return e.high_cut ? Json("high") : Json(nullptr);
}

Json profile_json(const CalibrateResult::Estimate& e) {
  Json json = Json::array();
  for (const optim::ProfilePoint& point : e.profile)
    json.push_back({{"value", point.value}, {"z", point.z}, {"slope", point.slope}});
  return json;
}

Json estimates_json(const CalibrateResult& result) {
  Json json = Json::object();
  for (const CalibrateResult::Estimate& e : result.estimates) {
    json[e.parameter.name] = {{"value", number_json(e.parameter.value)},
                              {"low", number_json(e.low)},
                              {"high", number_json(e.high)},
                              {"sd", number_json(e.deviation)},
                              {"at_bound", bound_json(e.bound)},
                              {"interval", e.profiled ? "profile" : "linear"},
                              {"cut_off", cut_off_json(e)},
                              {"remark", estimate_remark(result, e)}};
    if (!e.file.empty()) json[e.parameter.name]["file"] = e.file;
    if (!e.profile.empty()) json[e.parameter.name]["profile"] = profile_json(e);
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
  json["unfinished"] = result.unfinished.empty() ? Json(nullptr) : Json(result.unfinished);
  json["neighbours"] = nullptr;
  json["chi_square"] = nullptr;
  if (result.neighbours)
    json["neighbours"] = {{"quantity", result.neighbours_of.quantity},
                          {"over", result.neighbours_of.over},
                          {"count", result.neighbours->count},
                          {"correlation", result.neighbours->correlation},
                          {"p", result.neighbours->p}};
  if (result.serial)
    json["serial"] = {{"correlation", result.serial->correlation},
                      {"widening", result.serial->widening}};
  if (result.chi_square)
    json["chi_square"] = {{"value", *result.chi_square},
                          {"degrees_of_freedom", result.counting_freedom()},
                          {"p", result.chi_square_p}};
  if (result.worst_kind)
    json["worst_kind"] = {{"quantity", result.worst_kind->quantity},
                          {"chi_square", result.worst_kind->chi_square},
                          {"count", result.worst_kind->count},
                          {"p", result.worst_kind->p}};
  if (result.offset)
    json["offset"] = {{"quantity", result.offset->quantity}, {"table", result.offset->table},
                      {"count", result.offset->count},       {"offset", result.offset->offset},
                      {"unit", result.offset->unit},         {"p", result.offset->p}};
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
                    {"fits_as_well", optimum.fits_as_well},
                    {"same_valley", optimum.same_valley},
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

Json combinations_json(const CalibrateResult& result) {
  Json json = Json::array();
  for (const CalibrateResult::Combination& combination : result.combinations) {
    Json parts = Json::object();
    for (const auto& part : combination.parts) parts[part.name] = part.percent;
    json.push_back({{"words", combination_words(combination)},
                    {"percent", std::move(parts)},
                    {"effect", number_json(combination.effect)},
                    {"unseen", combination.unseen}});
  }
  return json;
}

Json plan_json(const CalibrateResult& result) {
  Json json = Json::array();
  for (const CalibrateResult::Planned& planned : result.plan) {
    Json one{{"quantity", planned.point.quantity}};
    if (planned.point.argument != Argument::none)
      one[planned.point.argument == Argument::speed ? "speed" : "torque"] = planned.point.at;
    if (planned.point.after) one["time"] = *planned.point.after;
    if (!planned.point.set.empty()) one["set"] = values_json(planned.point.set);
    if (!planned.file.empty()) one["file"] = planned.file;
    Json widths = Json::object();
    for (std::size_t j = 0; j < planned.widths.size(); ++j)
      widths[result.estimates[j].parameter.name] = planned.widths[j];
    one["widths"] = std::move(widths);
    one["volume"] = planned.volume;
    one["mean"] = planned.mean;
    json.push_back(std::move(one));
  }
  return json;
}

// A torque at a speed has entries of these names; other numbers have a value, and what it was read at, if anything.
Json point_json(const CalibrateResult::Point& point) {
  Json json = Json::object();
  if (point.argument != Argument::none)
    json[point.argument == Argument::speed ? "speed" : "torque"] = point.at;
  if (point.after) json["time"] = *point.after;
  json[point.torque() ? "torque" : "value"] = point.value;
  json["weight"] = point.weight;
  json["fitted"] = number_json(point.fitted);
  json["residual"] = number_json(point.residual);
  if (!point.torque()) json["quantity"] = point.quantity;
  if (!point.torque()) json["unit"] = point.unit;
  if (point.deviation > 0) json["sd"] = point.deviation;
  if (!point.set.empty()) json["set"] = values_json(point.set);
  if (!point.where.empty()) json["where"] = point.where;
  return json;
}

Json outliers_json(const CalibrateResult& result) {
  Json json = Json::array();
  for (const CalibrateResult::Outlier& one : result.outliers)
    json.push_back({{"point", one.point}, {"distance", number_json(one.distance)}, {"p", one.p}});
  return json;
}

Json data_json(const CalibrateResult& result) {
  Json json = Json::array();
  for (const CalibrateResult::Point& point : result.data) {
    json.push_back(point_json(point));
  }
  return json;
}

std::vector<NamedValue> estimated_values(const CalibrateResult& result) {
  std::vector<NamedValue> values;
  for (const CalibrateResult::Estimate& e : result.estimates) values.push_back(e.parameter);
  return values;
}

const char* scatter_word(const CalibrateResult& result) {
  if (!result.columns.empty()) return result.unmeasured ? "assumed" : "by-column";
  return result.stated ? "stated" : "estimated";
}

Json columns_json(const CalibrateResult& result) {
  Json json = Json::array();
  for (const CalibrateResult::ColumnScatter& one : result.columns)
    json.push_back({{"quantity", one.quantity},
                    {"unit", one.unit},
                    {"table", one.table},
                    {"count", one.count},
                    {"sd", one.deviation}});
  return json;
}

Json units_json(const CalibrateResult& result) {
  Json json = Json::object();
  for (const CalibrateResult::Estimate& e : result.estimates)
    json[e.parameter.name] = e.parameter.unit;
  add_units(json, result.derived);
  json["speed"] = "rad/s";
  json["torque"] = "N.m";
  for (const char* rms : {"fitted", "residual", "residual_rms", "residual_sd"})
    json[rms] = result.unit;
  for (const CalibrateResult::Point& point : result.data) add_units(json, point.set);
  return json;
}

}  // namespace

std::string estimate_remark(const CalibrateResult& result, const CalibrateResult::Estimate& e) {
  if (e.bound != Bound::none) return std::string("at its ") + end_word(e.bound);
  if (undetermined(result, e.parameter.name)) return "not determined";
  if (wider_than_range(e)) return "wider than its range";
  return CalibrateResult::of_use(e) ? "" : "hardly determined";
}

Json answer_json(const CalibrateResult& result) {
  Json json{{"estimates", estimates_json(result)},
            {"confidence", result.confidence},
            {"scatter", scatter_word(result)},
            {"loss", result.huber ? "huber" : "squares"},
            {"correlation", correlation_json(result)},
            {"residual_rms", number_json(result.residual_rms)},
            {"residual_sd", number_json(result.residual_deviation)},
            {"degrees_of_freedom", result.degrees_of_freedom},
            {"student_t", number_json(result.student_t)},
            {"fit", tests_json(result)},
            {"undetermined", undetermined_json(result)},
            {"combinations", combinations_json(result)},
            {"outliers", outliers_json(result)},
            {"optima", optima_json(result)},
            {"starts", starts_json(result)},
            {"notes", result.unmeasured ? std::vector<std::string>{} : calibration_notes(result)},
            {"moves", moves_json(estimated_values(result), result.moves)},
            {"plan", plan_json(result)},
            {"data", data_json(result)},
            {"units", units_json(result)}};
  if (result.folded) json["moves_missing"] = fold_words();
  if (!result.columns.empty()) json["columns"] = columns_json(result);
  if (!result.derived.empty()) json["derived"] = values_json(result.derived);
  return json;
}

}  // namespace twum::inline v0_1::studies
