// SPDX-License-Identifier: Apache-2.0
#include "plot/study/kinds.hpp"
#include "plot/style.hpp"

#include <twum/motors/plain_name.hpp>

#include <algorithm>
#include <cmath>

namespace twum::cli {
namespace {

// What bars stand for: a name, the bar, a second bar on it, an interval and a text.
struct Bar {
  std::string name;
  double value;
  double inner{kNoValue};
  double low{kNoValue};
  double high{kNoValue};
};

Bar bar_of(const std::string& name, const studies::SobolShares& effect) {
  return {name, effect.total.value, std::max(effect.first.value, 0.0), effect.total.low,
          effect.total.high};
}
Bar bar_of(const std::string& name, const studies::ElementaryEffect& effect) {
  return {name, effect.mu_star.value, kNoValue, effect.mu_star.low, effect.mu_star.high};
}
Bar bar_of(const std::string& name, const studies::LocalEffect& effect) {
  return {name, effect.elasticity};
}

std::vector<Bar> bars_of(const studies::SensitivityResult& answer,
                         const studies::MetricSensitivity& metric) {
  std::vector<Bar> bars;
  std::visit(
      [&](const auto& effects) {
        for (std::size_t i = 0; i < effects.size(); ++i)
          bars.push_back(bar_of(studies::plain_name(answer.variables[i].name), effects[i]));
      },
      metric.effects);
  std::erase_if(bars, [](const Bar& bar) { return !std::isfinite(bar.value); });
  // The vertical axis rises, so the largest comes last.
  std::stable_sort(bars.begin(), bars.end(), [](const Bar& a, const Bar& b) {
    return std::abs(a.value) < std::abs(b.value);
  });
  return bars;
}

struct Method {
  const char* title;
  const char* axis;
  const char* bar;
  std::string unit;
};

Method method_of(const std::string& name, const std::string& unit) {
  if (name == "sobol")
    return {"sources of its variance", "share of the variance", "with interactions", "%"};
  if (name == "morris") return {"change across each range", "change", "", unit};
  return {"change for 1 % more", "change [%]", "", "1"};
}

Picture effects(const FinishedStudy& study, const studies::SensitivityResult& answer,
                const studies::MetricSensitivity& metric) {
  const Method method = method_of(answer.method, metric.metric.unit);
  Panel panel{{method.axis, method.unit, true, 0.05}, {}, {}};
  Series outer{method.bar, Draw::boxes, answer.method == "sobol" ? "#8CC5E3" : colour::kBlue, {}};
  Series falls{"", Draw::boxes, colour::kVermilion, {}};
  Series inner{"alone", Draw::boxes, colour::kBlue, {}};
  Series intervals{"interval", Draw::intervals, "#000000", {}};
  const std::vector<Bar> bars = bars_of(answer, metric);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double at = static_cast<double>(i);
    const Bar& bar = bars[i];
    panel.y.words.push_back(bar.name);
    (bar.value < 0 ? falls : outer).rows.push_back({0, bar.value, at - 0.32, at + 0.32});
    if (std::isfinite(bar.inner)) inner.rows.push_back({0, bar.inner, at - 0.16, at + 0.16});
    if (std::isfinite(bar.high)) intervals.rows.push_back({bar.value, at, bar.low, bar.high});
  }
  panel.y.low = -0.6;
  panel.y.high = static_cast<double>(bars.size()) - 0.4;
  for (Series* series : {&outer, &falls, &inner, &intervals})
    if (!series->rows.empty()) panel.series.push_back(std::move(*series));
  return picture_of(
      "effects-" + file_word(metric.metric.name),
      {study.title(studies::plain_name(metric.metric.name) + ", " + method.title), {panel}});
}

}  // namespace

std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::SensitivityResult& answer) {
  std::vector<Picture> pictures;
  for (const studies::MetricSensitivity& metric : answer.metrics)
    if (!bars_of(answer, metric).empty()) pictures.push_back(effects(study, answer, metric));
  std::vector<NamedMotor> motors;
  add_motor(motors, "motor", study.result.design, {});
  add_curve_pictures(pictures, study.title("the motor"), motors);
  return pictures;
}

}  // namespace twum::cli
