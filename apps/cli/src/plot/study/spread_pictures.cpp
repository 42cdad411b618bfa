// SPDX-License-Identifier: Apache-2.0
#include "plot/study/histogram.hpp"
#include "plot/study/kinds.hpp"
#include "plot/study/stored_rows.hpp"
#include "plot/style.hpp"

#include <twum/io/number.hpp>
#include <twum/motors/plain_name.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::cli {
namespace {

Window window_of(const studies::UncertaintyResult& answer, const std::string& metric) {
  Window window{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const studies::UncertaintyResult::Limit& limit : answer.limits) {
    if (limit.metric != metric) continue;
    window.lower = std::max(window.lower, limit.lower);
    window.upper = std::min(window.upper, limit.upper);
  }
  return window;
}

Series bars_between(const std::string& name, const std::string& colour, const Bins& bins,
                    const std::vector<std::size_t>& counts) {
  Series series{name, Draw::boxes, colour, {}};
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0)
      series.rows.push_back({bins.edge(i), bins.edge(i + 1), 0, static_cast<double>(counts[i])});
  return series;
}

// A limit is drawn unless it is far from all motors.
void add_limit_guides(Panel& panel, const Window& window, const Bins& bins) {
  const double last = bins.edge(bins.kept.size()), span = last - bins.first;
  for (const double limit : {window.lower, window.upper}) {
    if (!(limit > bins.first - span && limit < last + span)) continue;
    const std::string sign = limit == window.lower ? "≥ " : "≤ ";
    panel.guides.push_back({limit, true, sign + studies::printed_engineering(limit, panel.x.unit),
                            colour::kVermilion});
  }
}

Picture histogram_of(const FinishedStudy& study, const studies::UncertaintyResult& answer,
                     const studies::UncertaintyResult::Metric& metric,
                     const std::vector<double>& values) {
  const Window window = window_of(answer, metric.column.name);
  const Bins bins = counted_bins(values, window);
  Panel panel{axis_of(metric.column, 0.03), {"motors", "1", true, 0.25}, {}};
  const bool limited = std::isfinite(window.lower) || std::isfinite(window.upper);
  panel.series.push_back(
      bars_between(limited ? "keeps the limit" : "", colour::kBlue, bins, bins.kept));
  if (limited)
    panel.series.push_back(bars_between("breaks it", colour::kVermilion, bins, bins.failed));
  add_limit_guides(panel, window, bins);
  for (const studies::UncertaintyResult::Quantile& quantile : metric.quantiles)
    panel.guides.push_back({quantile.value.value, true,
                            studies::rounded_text(100 * quantile.probability, 4) + " %", "#444444",
                            true});
  return picture_of("histogram-" + file_word(metric.column.name),
                    {study.title("spread of " + studies::plain_name(metric.column.name)), {panel}});
}

}  // namespace

std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::UncertaintyResult& answer) {
  std::vector<Picture> pictures;
  for (const studies::UncertaintyResult::Metric& metric : answer.metrics) {
    std::vector<double> values = column_values(study.store, metric.column);
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (low != high && *low < *high)
      pictures.push_back(histogram_of(study, answer, metric, values));
  }
  std::vector<NamedMotor> motors;
  add_motor(motors, "motor", study.result.design, {});
  add_curve_pictures(pictures, study.title("the motor"), motors);
  return pictures;
}

}  // namespace twum::cli
