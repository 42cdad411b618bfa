// SPDX-License-Identifier: Apache-2.0
#include "plot/study/kinds.hpp"
#include "plot/study/parallel.hpp"
#include "plot/study/stored_rows.hpp"
#include "plot/style.hpp"

#include <twum/motors/plain_name.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

namespace twum::cli {
namespace {

using studies::DesignReport;
using studies::NamedValue;

// Which rows keep every limit that is a column of the store.
std::vector<bool> rows_that_keep(const FinishedStudy& study, const DesignReport& best,
                                 std::size_t count) {
  std::vector<bool> keeps(count, true);
  for (const studies::LimitState& limit : best.constraints) {
    const auto column = column_of(study.store, limit.metric);
    if (!column) continue;
    const std::vector<double> values = column_values(study.store, *column);
    // Rounding may put the answer itself beyond a limit. That much does not count as a violation.
    const double room =
        std::max(1e-6 * std::abs(limit.limit), broken(limit) ? 0.0 : limit.violation);
    for (std::size_t i = 0; i < count; ++i)
      keeps[i] = keeps[i] && values[i] >= limit.lower - room && values[i] <= limit.upper + room;
  }
  return keeps;
}

struct Shown {
  double low, high;
};

// The range in which the search went on: that of the motors that keep the limits, the worst tenth of them aside, or
// of the middle half of all if fewer than ten keep them; with the best so far.
Shown search_range(const std::vector<double>& values, const std::vector<bool>& keeps,
                   const std::vector<double>& record, bool maximize) {
  std::vector<double> kept, all, ends;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    all.push_back(values[i]);
    if (keeps[i]) kept.push_back(values[i]);
    if (std::isfinite(record[i])) ends.push_back(record[i]);
  }
  std::sort(all.begin(), all.end());
  std::sort(kept.begin(), kept.end());
  if (kept.size() < 10) {
    ends.insert(ends.end(), kept.begin(), kept.end());
    ends.insert(ends.end(), {all[all.size() / 4], all[3 * all.size() / 4]});
  } else {
    const std::size_t tenth = kept.size() / 10;
    ends.push_back(kept[maximize ? tenth : kept.size() - 1 - tenth]);
  }
  const auto [low, high] = std::minmax_element(ends.begin(), ends.end());
  const double pad = 0.09 * (*high > *low ? *high - *low : std::abs(*high));
  return {*low - pad, *high + pad};
}

void add_history(std::vector<Picture>& pictures, const FinishedStudy& study,
                 const studies::OptimizeResult& answer) {
  const auto column = column_of(study.store, answer.goal.metric);
  if (!column) return;
  const std::vector<double> values = column_values(study.store, *column);
  const std::vector<bool> keeps = rows_that_keep(study, answer.best, values.size());
  Series outside{"breaks a limit", Draw::dots, "#BBBBBB", {}};
  Series inside{"keeps every limit", Draw::dots, colour::kGreen, {}};
  Series best{"best so far", Draw::steps, colour::kBlue, {}};
  std::vector<double> record(values.size(), kNoValue);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double before = i > 0 ? record[i - 1] : kNoValue;
    const bool better = keeps[i] && std::isfinite(values[i]) &&
                        !(answer.goal.maximize ? values[i] <= before : values[i] >= before);
    record[i] = better ? values[i] : before;
  }
  if (std::none_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) return;
  const auto [low, high] = search_range(values, keeps, record, answer.goal.maximize);
  std::size_t beyond = 0;
  for (const std::size_t i : shown_rows(values.size())) {
    const double number = static_cast<double>(i) + 1;
    beyond += values[i] < low || values[i] > high ? 1 : 0;
    const double at = std::isfinite(values[i]) ? std::clamp(values[i], low, high) : values[i];
    (keeps[i] ? inside : outside).rows.push_back({number, at});
    best.rows.push_back({number, record[i]});
  }
  const std::string edge =
      beyond == 0 ? "" : "; " + std::to_string(beyond) + " beyond the axis stand at its edge";
  // Limits hold without tolerances here, so the best of these motors is not the best under tolerances.
  std::vector<Series> shown{outside, inside};
  if (answer.robust)
    shown.back().name += " without tolerances";
  else
    shown.push_back(best);
  pictures.push_back(picture_of(
      "search", {study.title("how the search went"),
                 {{{"evaluation" + edge, "1"},
                   {studies::plain_name(answer.goal.metric), answer.goal.unit, false, 0, low, high},
                   shown}}}));
}

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

// What a point is on its front, such as "largest peak power, knee"; empty for the others.
std::string role_of(const studies::ParetoResult& answer, std::size_t point) {
  std::string role;
  for (std::size_t k = 0; k < answer.ends.size(); ++k) {
    if (answer.ends[k] != point) continue;
    role += (role.empty() ? "" : ", ") +
            std::string(answer.goals[k].maximize ? "largest " : "smallest ") +
            studies::plain_name(answer.goals[k].metric);
  }
  if (answer.has_knee() && answer.knee == point) role += role.empty() ? "knee" : ", knee";
  return role;
}

void add_front(std::vector<Picture>& pictures, const FinishedStudy& study,
               const studies::ParetoResult& answer, std::size_t k, std::size_t l) {
  const auto axis = [&](std::size_t goal) {
    return Axis{studies::plain_name(answer.goals[goal].metric), answer.goals[goal].unit, false,
                0.08};
  };
  Panel panel{axis(k), axis(l), {{"", Draw::dots, colour::kBlue, {}}}};
  for (std::size_t i = 0; i < answer.front.size(); ++i) {
    const std::vector<double>& goals = answer.front[i].goals;
    panel.series.front().rows.push_back({goals[k], goals[l]});
    if (const std::string role = role_of(answer, i); !role.empty())
      panel.marks.push_back({goals[k], goals[l], role});
  }
  const std::string pair =
      answer.goals.size() == 2 ? "" : "-" + std::to_string(k + 1) + "-" + std::to_string(l + 1);
  pictures.push_back(picture_of("front" + pair, {study.title("the trade"), {panel}}));
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
  add_history(pictures, study, answer);
  return pictures;
}

std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::ParetoResult& answer) {
  std::vector<Picture> pictures;
  if (answer.front.empty()) return pictures;
  for (std::size_t k = 0; k < answer.goals.size(); ++k)
    for (std::size_t l = k + 1; l < answer.goals.size(); ++l)
      add_front(pictures, study, answer, k, l);
  add_along(pictures, study, answer);
  pictures.push_back(every_quantity_of(study, answer));
  std::set<std::size_t> shown(answer.ends.begin(), answer.ends.end());
  if (answer.has_knee()) shown.insert(answer.knee);
  std::vector<NamedMotor> motors;
  for (const std::size_t i : shown)
    add_motor(motors, role_of(answer, i), study.result.design, answer.front[i].report.design);
  add_curve_pictures(pictures, study.title("motors of the front"), motors,
                     limits_of(study.file.asked));
  return pictures;
}

}  // namespace twum::cli
