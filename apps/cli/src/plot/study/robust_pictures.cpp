// SPDX-License-Identifier: Apache-2.0
#include "plot/study/kinds.hpp"
#include "plot/style.hpp"

#include <twum/motors/motor_limit.hpp>
#include <twum/motors/plain_name.hpp>

#include <algorithm>
#include <cmath>

namespace twum::cli {
namespace {

using studies::RobustDensity;
using studies::RobustReport;

struct NamedShare {
  std::string name;
  double value;
};

// Sorted bars, the largest on top.
Panel sorted_bars(std::vector<NamedShare> bars, const std::string& axis, const std::string& unit) {
  std::stable_sort(bars.begin(), bars.end(),
                   [](const NamedShare& a, const NamedShare& b) { return a.value < b.value; });
  Panel panel{{axis, unit, true, 0.05}, {}, {{"", Draw::boxes, colour::kBlue, {}}}};
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double at = static_cast<double>(i);
    panel.y.words.push_back(bars[i].name);
    panel.series.front().rows.push_back({0, bars[i].value, at - 0.32, at + 0.32});
  }
  panel.y.low = -0.6;
  panel.y.high = static_cast<double>(bars.size()) - 0.4;
  return panel;
}

Picture density_of(const FinishedStudy& study, const RobustReport& report,
                   const RobustDensity& density) {
  const auto edge = [&](std::size_t i) {
    return density.first + static_cast<double>(i) * density.width;
  };
  Series kept{"keeps the limit", Draw::boxes, colour::kBlue, {}};
  Series failed{"breaks it", Draw::boxes, colour::kVermilion, {}};
  const bool nominal = std::isfinite(report.nominal_objective);
  Series other{
      nominal ? "optimum without tolerances" : "the motor as it was", Draw::line, "#000000", {}};
  for (std::size_t i = 0; i < density.motors.size(); ++i) {
    const double middle = edge(i) + density.width / 2;
    const bool fails = middle < density.lower || middle > density.upper;
    if (density.motors[i] > 0)
      (fails ? failed : kept).rows.push_back({edge(i), edge(i + 1), 0, density.motors[i]});
    other.rows.push_back({edge(i), density.nominal[i]});
    other.rows.push_back({edge(i + 1), density.nominal[i]});
  }
  Panel panel{{studies::plain_name(density.metric), density.unit},
              {"motors per bin", "%", true, 0.2},
              {kept, failed, other}};
  const double last = edge(density.motors.size()), span = last - density.first;
  for (const double limit : {density.lower, density.upper}) {
    // A limit is drawn unless it is far from all motors.
    if (limit > density.first - span && limit < last + span)
      panel.guides.push_back({limit, true,
                              (limit == density.lower ? "≥ " : "≤ ") +
                                  studies::printed_engineering(limit, density.unit),
                              colour::kVermilion});
  }
  return picture_of("density-" + file_word(density.metric),
                    {study.title("spread of " + studies::plain_name(density.metric)), {panel}});
}

// "stall torque ≥ 800 mN·m"; a limit with two sides as it is typed.
std::string limit_words(const studies::RobustLimit& one) {
  const studies::MotorLimit limit = studies::parse_limit(one.text);
  if (!limit.sides.empty()) return studies::plain_limit(one.text);
  return studies::plain_name(limit.metric.text) + (one.at_least ? " ≥ " : " ≤ ") +
         studies::printed_engineering(one.at_least ? limit.lower : limit.upper,
                                      limit.metric.unit());
}

Picture risk(const FinishedStudy& study, const RobustReport& report) {
  std::vector<NamedShare> bars;
  for (const studies::RobustLimit& limit : report.limits)
    bars.push_back({limit_words(limit), limit.share});
  return picture_of("risk", {study.title("which limits the failing motors break"),
                             {sorted_bars(std::move(bars), "of the failing motors", "%")}});
}

Picture costs(const FinishedStudy& study, const RobustReport& report, const studies::Goal& goal) {
  std::vector<NamedShare> bars;
  for (const studies::RobustTolerance& tolerance : report.tolerances)
    if (std::isfinite(tolerance.gain))
      bars.push_back({studies::plain_name(tolerance.name), std::abs(tolerance.gain)});
  return picture_of("tolerances",
                    {study.title("what each tolerance costs"),
                     {sorted_bars(std::move(bars),
                                  studies::plain_name(goal.metric) + " gained if it is 1 % tighter",
                                  goal.unit)}});
}

Picture yield_price(const FinishedStudy& study, const RobustReport& report,
                    const studies::Goal& goal) {
  Series line{"", Draw::line, colour::kBlue, {}}, dots{"", Draw::dots, colour::kBlue, {}};
  for (const optim::YieldPrice& price : report.prices_of_yields)
    line.rows.push_back({price.yield, price.objective});
  dots.rows = line.rows;
  Panel panel{{"yield", "%", false, 0.03},
              {studies::plain_name(goal.metric), goal.unit, false, 0.12},
              {line, dots}};
  if (std::isnan(report.largest_yield) && !report.yields.empty() && std::isfinite(report.objective))
    panel.marks.push_back({report.yields.front().target, report.objective, "this design"});
  return picture_of("yield", {study.title("what the yield costs"), {panel}});
}

}  // namespace

void add_robust_pictures(std::vector<Picture>& pictures, const FinishedStudy& study,
                         const studies::OptimizeResult& answer) {
  const RobustReport& report = *answer.robust;
  for (const RobustDensity& density : report.densities)
    pictures.push_back(density_of(study, report, density));
  if (!report.limits.empty()) pictures.push_back(risk(study, report));
  if (!report.tolerances.empty()) pictures.push_back(costs(study, report, answer.goal));
  if (report.prices_of_yields.size() > 1)
    pictures.push_back(yield_price(study, report, answer.goal));
}

}  // namespace twum::cli
