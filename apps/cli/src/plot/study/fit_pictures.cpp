// SPDX-License-Identifier: Apache-2.0
#include "plot/study/kinds.hpp"
#include "plot/style.hpp"

#include <twum/core/performance/metrics.hpp>
#include <twum/studies/metrics/plain_name.hpp>
#include <twum/studies/text/number.hpp>

#include <algorithm>
#include <cmath>

namespace twum::cli {
namespace {

using studies::CalibrateResult;

constexpr int kFitPoints = 161;

// Measured torques of the motor as it is; other readings have no place on its curve.
bool on_the_curve(const CalibrateResult::Point& point) {
  return point.torque() && point.set.empty();
}

// Half width of the band of the fitted torque: the intervals of the estimates, carried to the torque by its derivatives.
double half_width(const CalibrateResult& answer, const MetricDerivative& torque) {
  const std::size_t count = answer.estimates.size();
  std::vector<double> moved(count, 0);  // torque for one standard deviation of each estimate
  bool any = false;
  for (std::size_t i = 0; i < count; ++i) {
    const auto parameter = find_parameter(answer.estimates[i].parameter.name);
    if (!parameter || !(answer.estimates[i].deviation > 0)) continue;
    moved[i] = torque.gradient[index_of(*parameter)] * answer.estimates[i].deviation;
    any = true;
  }
  double variance = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const double correlation = i == j ? 1 : answer.correlation[i * count + j];
      variance += moved[i] * moved[j] * (std::isfinite(correlation) ? correlation : 0);
    }
  }
  return any ? answer.student_t * std::sqrt(std::max(variance, 0.0)) : studies::kNoValue;
}

Picture fit(const FinishedStudy& study, const CalibrateResult& answer, const Motor& motor) {
  Series measured{"measured", Draw::dots, "#000000", {}};
  double first = 0, last = 0;
  for (const CalibrateResult::Point& point : answer.data) {
    if (!on_the_curve(point)) continue;
    measured.rows.push_back({point.at, point.value});
    first = std::min(first, point.at);
    last = std::max(last, point.at);
  }
  Series line{"fitted", Draw::line, colour::kBlue, {}};
  Series band{studies::rounded_text(100 * answer.confidence, 4) + " % band of the fit",
              Draw::band,
              colour::kBlue,
              {}};
  for (int i = 0; i < kFitPoints; ++i) {
    const double speed = std::lerp(first, last, static_cast<double>(i) / (kFitPoints - 1));
    const MetricRequest request{Metric::torque_at, Argument::speed, speed};
    const MetricDerivative torque = differentiate(motor, {&request, 1}).front();
    const double half = half_width(answer, torque);
    line.rows.push_back({speed, torque.value.value});
    if (std::isfinite(half))
      band.rows.push_back({speed, torque.value.value - half, torque.value.value + half});
  }
  Panel panel{{"speed", "rad/s", true, 0.03}, {"torque", "N.m", false, 0.08}, {}};
  for (Series* series : {&band, &line, &measured})
    if (!series->rows.empty()) panel.series.push_back(std::move(*series));
  return picture_of("fit", {study.title("measured and fitted"), {panel}});
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
      std::string name = studies::plain_name(point.quantity);
      if (name.ends_with(" at")) name.resize(name.size() - 3);
      panel.series.push_back({name, Draw::dots, colour_of(kind), {}});
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
    add_motor(motors, file.empty() ? "fitted motor" : file, study.file.motor.design,
              answer.motor_values(file));
  if (motors.empty()) return pictures;
  if (files.size() == 1 && std::any_of(answer.data.begin(), answer.data.end(), on_the_curve))
    pictures.push_back(fit(study, answer, motors.front().motor));
  pictures.push_back(residuals(study, answer));
  add_curve_pictures(pictures, study.title("the fitted motor"), motors);
  return pictures;
}

}  // namespace twum::cli
