// SPDX-License-Identifier: Apache-2.0
#include "plot/study/kinds.hpp"
#include "plot/style.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/motors/plain_name.hpp>
#include <twum/studies/fit_curves.hpp>

#include <algorithm>
#include <cmath>

namespace twum::cli {
namespace {

using studies::CalibrateResult;

using studies::FitCurve;

// "torque" of "torque_at"
std::string name_of(const std::string& quantity) {
  std::string name = studies::plain_name(quantity);
  if (name.ends_with(" at")) name.resize(name.size() - 3);
  return name;
}

// "bench.csv, preload 120 N": the words that distinguish a curve from the others of its kind.
std::string name_of(const FitCurve& curve) {
  std::string name = curve.file;
  for (const studies::NamedValue& one : curve.set)
    name += (name.empty() ? "" : ", ") + studies::plain_name(one.name) + " " +
            studies::printed_engineering(one.value, one.unit);
  return name.empty() ? "fitted" : name;
}

// Curves of one quantity over the same axis.
using FitCurves = std::vector<const FitCurve*>;

std::vector<FitCurves> by_kind(const std::vector<FitCurve>& curves) {
  std::vector<FitCurves> kinds;
  for (const FitCurve& curve : curves) {
    const auto known = std::find_if(kinds.begin(), kinds.end(), [&](const FitCurves& kind) {
      return kind.front()->quantity == curve.quantity && kind.front()->over.name == curve.over.name;
    });
    if (known == kinds.end())
      kinds.push_back({&curve});
    else
      known->push_back(&curve);
  }
  return kinds;
}

// "fit" of torques at speeds, "fit-speed_at" of speeds at torques, "fit-no_load_speed-preload" over a setting of the bench.
std::string picture_name(const FitCurve& curve) {
  if (curve.quantity == "torque_at") return "fit";
  const bool common = curve.over.name == "frequency" || curve.quantity.ends_with("_at");
  return "fit-" + curve.quantity + (common ? "" : "-" + curve.over.name);
}

// Band, line and points of a curve; alone in the colours of a single fit.
void add_curve(const CalibrateResult& answer, const FitCurve& curve, const std::string& colour,
               bool alone, Panel& panel) {
  Series band{alone ? studies::rounded_text(100 * answer.confidence, 4) + " % band of the fit" : "",
              Draw::band,
              colour,
              {}};
  Series line{name_of(curve), Draw::line, colour, {}};
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    const double value = curve.value[i];
    const double half = curve.half[i];
    line.rows.push_back({curve.at[i], value});
    if (std::isfinite(half)) band.rows.push_back({curve.at[i], value - half, value + half});
  }
  Series dots{alone ? "measured" : "", Draw::dots, alone ? "#000000" : colour, {}};
  for (const std::size_t i : curve.points)
    dots.rows.push_back({studies::place_on(answer.data[i], curve.over), answer.data[i].value});
  for (Series* series : {&band, &line, &dots})
    if (!series->rows.empty()) panel.series.push_back(std::move(*series));
}

Picture fit(const FinishedStudy& study, const CalibrateResult& answer, const FitCurves& kind) {
  const FitCurve& first = *kind.front();
  const bool from_zero = first.over.name == "speed" || first.over.name == "torque";
  Panel panel{{studies::plain_name(first.over.name), first.over.unit, from_zero, 0.03},
              {name_of(first.quantity), first.unit, false, 0.08},
              {}};
  for (std::size_t i = 0; i < kind.size(); ++i)
    add_curve(answer, *kind[i], kind.size() == 1 ? colour::kBlue : colour_of(i), kind.size() == 1,
              panel);
  const bool torque = first.quantity == "torque_at";
  const std::string what = torque ? "measured and fitted" : "measured and fitted " + panel.y.name;
  return picture_of(picture_name(first), {study.title(what), {panel}});
}

// The curve of a part of the admittance over frequency; null if that was not measured.
const FitCurve* part(const std::vector<FitCurve>& curves, const std::string& quantity) {
  const auto found = std::find_if(curves.begin(), curves.end(), [&](const FitCurve& curve) {
    return curve.quantity == quantity && curve.over.name == "frequency";
  });
  return found == curves.end() ? nullptr : &*found;
}

// The circle of the free stator: readings of both parts at one place of the data, and the fit where both are known.
void add_circle(std::vector<Picture>& pictures, const FinishedStudy& study,
                const CalibrateResult& answer, const std::vector<FitCurve>& curves) {
  const FitCurve* along = part(curves, "conductance");
  const FitCurve* up = part(curves, "susceptance");
  if (along == nullptr || up == nullptr) return;
  Series line{"fitted", Draw::line, colour::kBlue, {}};
  for (std::size_t i = 0; i < along->at.size() && along->at == up->at; ++i)
    line.rows.push_back({along->value[i], up->value[i]});
  Series dots{"measured", Draw::dots, "#000000", {}};
  for (const std::size_t i : along->points)
    for (const std::size_t j : up->points)
      if (answer.data[i].where == answer.data[j].where)
        dots.rows.push_back({answer.data[i].value, answer.data[j].value});
  Panel panel{{"conductance", "S", false, 0.08}, {"susceptance", "S", false, 0.08}, {}};
  panel.one_scale = true;
  for (Series* series : {&line, &dots})
    if (!series->rows.empty()) panel.series.push_back(std::move(*series));
  if (panel.series.empty()) return;
  pictures.push_back(picture_of("circle", {study.title("impedance circle"), {panel}}));
}

void add_fits(std::vector<Picture>& pictures, const FinishedStudy& study,
              const CalibrateResult& answer) {
  const std::vector<FitCurve> curves = studies::fit_curves(study.file, answer);
  for (const FitCurves& kind : by_kind(curves)) pictures.push_back(fit(study, answer, kind));
  add_circle(pictures, study, answer, curves);
}

Panel torque_residuals(const CalibrateResult& answer) {
  Panel panel{{"speed", "rad/s", false, 0.03},
              {"measured - fitted", "N.m", false, 0.12},
              {{"", Draw::dots, colour::kBlue, {}}}};
  for (const CalibrateResult::Point& point : answer.data)
    panel.series.front().rows.push_back({point.at, point.residual});
  return panel;
}

// Readings of several kinds have no common axis but their place in the table.
Panel reading_residuals(const CalibrateResult& answer) {
  const bool stated = std::all_of(answer.data.begin(), answer.data.end(),
                                  [](const CalibrateResult::Point& p) { return p.deviation > 0; });
  Panel panel{{"reading", "1", false, 0.03},
              {stated ? "residual in standard deviations" : "residual in parts of the reading",
               stated ? "1" : "%", false, 0.12},
              {}};
  std::vector<std::string> kinds;
  for (std::size_t i = 0; i < answer.data.size(); ++i) {
    const CalibrateResult::Point& point = answer.data[i];
    const auto place = std::find(kinds.begin(), kinds.end(), point.quantity);
    const auto kind = static_cast<std::size_t>(place - kinds.begin());
    if (place == kinds.end()) {
      kinds.push_back(point.quantity);
      panel.series.push_back({name_of(point.quantity), Draw::dots, colour_of(kind), {}});
    }
    panel.series[kind].rows.push_back(
        {static_cast<double>(i) + 1,
         point.residual / (stated ? point.deviation : std::abs(point.value))});
  }
  return panel;
}

Picture residuals(const FinishedStudy& study, const CalibrateResult& answer) {
  const bool torques = std::all_of(answer.data.begin(), answer.data.end(),
                                   [](const CalibrateResult::Point& p) { return p.torque(); });
  Panel panel = torques ? torque_residuals(answer) : reading_residuals(answer);
  panel.guides.push_back({0, false, "", "#666666"});
  return picture_of("residuals", {study.title("residuals"), {panel}});
}

}  // namespace

std::vector<Picture> pictures_of(const FinishedStudy& study, const CalibrateResult& answer) {
  std::vector<Picture> pictures;
  std::vector<NamedMotor> motors;
  if (answer.estimates.empty()) return pictures;
  const std::vector<std::string> files = answer.files();
  for (const std::string& file : files)
    add_motor(motors, file.empty() ? "fitted motor" : file, study.result.design,
              answer.motor_values(file));
  if (motors.empty()) return pictures;
  add_fits(pictures, study, answer);
  pictures.push_back(residuals(study, answer));
  add_curve_pictures(pictures, study.title("the fitted motor"), motors);
  return pictures;
}

}  // namespace twum::cli
