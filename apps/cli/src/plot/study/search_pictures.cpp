// SPDX-License-Identifier: Apache-2.0
#include "plot/study/kinds.hpp"
#include "plot/study/parallel.hpp"
#include "plot/study/stored_rows.hpp"
#include "plot/style.hpp"

#include <twum/motors/plain_name.hpp>
#include <twum/studies/telling.hpp>

#include <cmath>
#include <cstddef>
#include <set>

namespace twum::cli {
namespace {

using studies::NamedValue;

std::vector<studies::MotorLimit> limits_of(const studies::Study& asked) {
  if (const auto* search = std::get_if<studies::OptimizeStudy>(&asked)) return search->constraints;
  if (const auto* search = std::get_if<studies::ParetoStudy>(&asked)) return search->constraints;
  const auto* size = std::get_if<studies::SizeStudy>(&asked);
  if (size == nullptr) return {};
  std::vector<studies::MotorLimit> limits = size->duty;
  limits.insert(limits.end(), size->limits.begin(), size->limits.end());
  return limits;
}

double value_of(const std::vector<NamedValue>& values, const std::string& name) {
  for (const NamedValue& one : values)
    if (one.name == name) return one.value;
  return kNoValue;
}

// Goals of the points of a front, and their designs.
Picture every_quantity_of(const FinishedStudy& study, const studies::ParetoResult& answer) {
  std::vector<ParallelAxis> axes;
  for (std::size_t k = 0; k < answer.goals.size(); ++k) {
    axes.push_back({studies::plain_name(answer.goals[k].metric), answer.goals[k].unit, {}});
    for (const studies::ParetoResult::Point& point : answer.front)
      axes.back().values.push_back(point.goals[k]);
  }
  for (const NamedValue& variable : answer.front.front().report.design) {
    axes.push_back({studies::plain_name(variable.name), variable.unit, {}});
    for (const studies::ParetoResult::Point& point : answer.front)
      axes.back().values.push_back(value_of(point.report.design, variable.name));
  }
  return parallel_picture("parallel", study.title("every quantity at once"), axes,
                          shown_rows(answer.front.size()));
}

// The variables of the designs over the first goal.
void add_along(std::vector<Picture>& pictures, const FinishedStudy& study,
               const studies::ParetoResult& answer) {
  Chart chart{study.title("along the front"), {}, true};
  for (const NamedValue& variable : answer.front.front().report.design) {
    Panel panel{{studies::plain_name(answer.goals[0].metric), answer.goals[0].unit, false, 0.03},
                {studies::plain_name(variable.name), variable.unit, false, 0.1},
                {{"", Draw::dots, colour::kBlue, {}}}};
    for (const studies::ParetoResult::Point& point : answer.front)
      panel.series.front().rows.push_back(
          {point.goals[0], value_of(point.report.design, variable.name)});
    chart.panels.push_back(std::move(panel));
  }
  if (!chart.panels.empty()) pictures.push_back(picture_of("along-the-front", chart));
}

}  // namespace

std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::OptimizeResult& answer) {
  std::vector<Picture> pictures;
  if (!answer.found) return pictures;
  std::vector<NamedMotor> motors;
  add_motor(motors, "before", study.result.design, answer.before_design);
  add_motor(motors, "best design", study.result.design, answer.best.design);
  add_curve_pictures(pictures, study.title("before and after"), motors,
                     limits_of(study.file.asked));
  return pictures;
}

std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::ParetoResult& answer) {
  std::vector<Picture> pictures;
  if (answer.front.empty()) return pictures;
  add_along(pictures, study, answer);
  pictures.push_back(every_quantity_of(study, answer));
  std::set<std::size_t> shown(answer.ends.begin(), answer.ends.end());
  if (answer.has_knee()) shown.insert(answer.knee);
  std::vector<NamedMotor> motors;
  for (const std::size_t i : shown)
    add_motor(motors,
              studies::telling::written(studies::telling::role_phrase(answer, i),
                                        studies::telling::Writing::read),
              study.result.design, answer.front[i].report.design);
  add_curve_pictures(pictures, study.title("motors of the front"), motors,
                     limits_of(study.file.asked));
  return pictures;
}

}  // namespace twum::cli
