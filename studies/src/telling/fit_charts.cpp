// SPDX-License-Identifier: Apache-2.0
#include "telling/fit_charts.hpp"

#include "telling/goal_parts.hpp"
#include "telling/load_parts.hpp"

#include <twum/io/words.hpp>
#include <twum/motors/plain_name.hpp>
#include <twum/studies/fit_curves.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace twum::inline v0_1::studies::telling {
namespace {

using Reading = CalibrateResult::Point;
using Fitted = CalibrateResult::Estimate;
// Curves of one quantity over the same axis.
using CurveKind = std::vector<const FitCurve*>;

std::vector<CurveKind> by_kind(const std::vector<FitCurve>& curves) {
  std::vector<CurveKind> kinds;
  for (const FitCurve& curve : curves) {
    const auto known = std::ranges::find_if(kinds, [&](const CurveKind& kind) {
      return kind.front()->quantity == curve.quantity && kind.front()->over.name == curve.over.name;
    });
    if (known == kinds.end())
      kinds.push_back({&curve});
    else
      known->push_back(&curve);
  }
  return kinds;
}

// "bench.csv, preload 120 N": what tells a curve from the others of its kind.
std::string name_of(const FitCurve& curve) {
  std::string name = curve.file;
  for (const NamedValue& one : curve.set)
    name += (name.empty() ? "" : ", ") +
            written({name_part(one.name), " ", value_part(one.value, one.unit)}, Writing::read);
  return name.empty() ? "fit" : name;
}

// "fit" of torques at speeds, "fit speed_at" of speeds at torques, "fit no_load_speed preload" over a setting of the bench.
std::string chart_name(const FitCurve& curve) {
  if (curve.quantity == "torque_at") return "fit";
  const bool common = curve.over.name == "frequency" || curve.quantity.ends_with("_at");
  return "fit " + curve.quantity + (common ? "" : " " + curve.over.name);
}

// Numbers of a quantity as they are read: absolute temperatures in degrees.
struct Shown {
  std::string unit;
  double zero{0}, size{1};  // [SI]

  double number(double value) const { return (value - zero) / size; }
  std::vector<double> numbers(std::vector<double> values) const {
    for (double& one : values) one = number(one);
    return values;
  }
};

Shown shown_values(const std::string& quantity, const std::string& unit) {
  if (unit == "K" && is_temperature(quantity)) return {"degC", -in_celsius(0)};
  return {unit};
}

Shown shown_places(const CurveKind& kind) {
  const NamedValue& over = kind.front()->over;
  if (over.name != "time") return {over.unit};
  double last = 0;
  for (const FitCurve* curve : kind) last = std::max(last, curve->at.back());
  const TimeUnit unit = time_unit(last);
  return {unit.unit, 0, unit.seconds};
}

// Line, band and points of a curve; alone in the colours of a single fit.
void add_curve(Chart& chart, const CalibrateResult& answer, const FitCurve& curve, const Shown& x,
               const Shown& y, bool alone, const std::string& colour) {
  Series line{name_of(curve),
              Stroke::line,
              {"", x.numbers(curve.at)},
              {"", y.numbers(curve.value)},
              colour};
  if (std::ranges::any_of(curve.low, [](double low) { return std::isfinite(low); })) {
    line.low.values = y.numbers(curve.low), line.high.values = y.numbers(curve.high);
    line.band = written({share_part(answer.confidence), " band"}, Writing::read);
  }
  Series dots{"measured", Stroke::dots, {}, {}, alone ? "ink" : colour};
  for (const std::size_t i : curve.points) {
    dots.x.values.push_back(x.number(place_on(answer.data[i], curve.over)));
    dots.y.values.push_back(y.number(answer.data[i].value));
  }
  chart.series.push_back(std::move(line));
  chart.series.push_back(std::move(dots));
}

Section fit_section(const CalibrateResult& answer, const CurveKind& kind, bool named) {
  const FitCurve& first = *kind.front();
  const std::string quantity = quantity_words(first.quantity);
  Section section{{"Measured and fitted" + (named ? ": " + quantity : "")}};
  section.wide = !named;
  const bool from_zero =
      first.over.name == "speed" || first.over.name == "torque" || first.over.name == "time";
  const Shown x = shown_places(kind), y = shown_values(first.quantity, first.unit);
  Chart chart{chart_name(first),
              section.heading,
              {{name_part(first.over.name)}, x.unit, from_zero},
              {{quantity}, y.unit}};
  for (std::size_t i = 0; i < kind.size(); ++i)
    add_curve(chart, answer, *kind[i], x, y, kind.size() == 1, colour_of(i));
  section.charts = {chart};
  return section;
}

// The curve of a part of the admittance over frequency; null if that was not measured.
const FitCurve* part_of(const std::vector<FitCurve>& curves, const std::string& quantity) {
  const auto found = std::ranges::find_if(curves, [&](const FitCurve& curve) {
    return curve.quantity == quantity && curve.over.name == "frequency";
  });
  return found == curves.end() ? nullptr : &*found;
}

// The circle of the free stator: readings of both parts at one place of the data, and the fit where both are known.
std::vector<Section> circle(const CalibrateResult& answer, const std::vector<FitCurve>& curves) {
  const FitCurve* along = part_of(curves, "conductance");
  const FitCurve* up = part_of(curves, "susceptance");
  if (along == nullptr || up == nullptr) return {};
  Series dots{"measured", Stroke::dots, {}, {}, "ink"};
  std::multimap<std::string, double> up_at;
  for (const std::size_t j : up->points) up_at.emplace(answer.data[j].where, answer.data[j].value);
  for (const std::size_t i : along->points)
    for (auto [at, end] = up_at.equal_range(answer.data[i].where); at != end; ++at) {
      dots.x.values.push_back(answer.data[i].value);
      dots.y.values.push_back(at->second);
    }
  if (dots.x.values.empty()) return {};
  Chart chart{"circle", {"impedance circle"}, {{"conductance"}, "S"}, {{"susceptance"}, "S"}};
  if (along->at == up->at)
    chart.series.push_back({"fit", Stroke::path, {"", along->value}, {"", up->value}});
  chart.series.push_back(std::move(dots));
  chart.one_scale = true;
  Section section{
      {"Impedance circle"},
      {"Admittance of a phase of the free stator over frequency. Both axes have the same scale."}};
  section.wide = false;
  section.charts = {chart};
  return {section};
}

// The root of the rise along a profile: a cubic between its points with their slopes, straight beyond them. Slopes beyond
// three times that of the chord are limited to it, so that the cubic does not overshoot (Fritsch and Carlson 1980).
double along_profile(const std::vector<optim::ProfilePoint>& profile, double value) {
  const optim::ProfilePoint &first = profile.front(), &last = profile.back();
  if (value <= first.value) return first.z + first.slope * (value - first.value);
  if (value >= last.value) return last.z + last.slope * (value - last.value);
  std::size_t k = 0;
  while (value >= profile[k + 1].value) ++k;
  const optim::ProfilePoint &p = profile[k], &q = profile[k + 1];
  const double step = q.value - p.value, t = (value - p.value) / step, chord = (q.z - p.z) / step;
  const double sign = chord < 0 ? -1 : 1;
  const auto limited = [&](double slope) {
    return sign * std::clamp(sign * slope, 0.0, 3 * std::fabs(chord));
  };
  return (1 + 2 * t) * (1 - t) * (1 - t) * p.z + t * (1 - t) * (1 - t) * step * limited(p.slope) +
         t * t * (3 - 2 * t) * q.z + t * t * (t - 1) * step * limited(q.slope);
}

// Values from a little beyond both ends of a profile, within the range of the parameter; those of the interval among them.
std::vector<double> profile_grid(const Fitted& e) {
  constexpr int kPlaces = 120;
  const double low = e.profile.front().value, high = e.profile.back().value;
  const double room = 0.25 * (high - low);
  const double from = std::max(low - room, e.min), to = std::min(high + room, e.max);
  std::vector<double> grid;
  for (int i = 0; i <= kPlaces; ++i) grid.push_back(std::lerp(from, to, i / double{kPlaces}));
  for (const double end : {e.low, e.high})
    if (end > from && end < to) grid.push_back(end);
  std::ranges::sort(grid);
  return grid;
}

Section profile_section(const CalibrateResult& answer, const Fitted& e) {
  const std::vector<double> grid = profile_grid(e);
  const auto best =
      std::ranges::find_if(e.profile, [](const optim::ProfilePoint& p) { return p.z == 0; });
  Numbers rise, linear;
  for (const double value : grid) {
    rise.values.push_back(std::pow(along_profile(e.profile, value), 2));
    linear.values.push_back(std::pow(best->slope * (value - e.parameter.value), 2));
  }
  Section section{{"Profile of "},
                  {"Rise of the smallest sum of squares if this parameter is fixed at a value. It "
                   "is 1 at the ends of the ",
                   share_part(answer.confidence), " interval, marked by dashed lines."}};
  append(section.heading, estimate_name(e));
  section.wide = false;
  if (e.low < grid.front() || e.high > grid.back())
    append(section.note, {" The interval is wider than the profile: outside the profile other "
                          "motors fit the data."});
  Chart chart{"profile " + e.parameter.name,
              section.heading,
              {estimate_name(e), e.parameter.unit, false, grid.front(), grid.back()},
              {{"rise of the squares"}, "1", true, 0, 2.2},
              {{"profile", Stroke::line, {"", grid}, rise}}};
  // Where the Jacobian lacks rank there is no linearised interval.
  if (std::isfinite(e.deviation))
    chart.series.push_back({"linearised", Stroke::dashes, {"", grid}, linear, "soft"});
  for (const double end : {e.low, e.high})
    if (end >= grid.front() && end <= grid.back())
      chart.guides.push_back({end, {}, Guide::Kind::quantile});
  chart.guides.push_back({1, {}, Guide::Kind::level});
  section.charts = {chart};
  return section;
}

struct ReadAt {
  Phrase name;
  std::string unit;
  double at;
};

// Where a number was read: its speed, its load, its frequency, or else its place in the data.
ReadAt place_of(const Reading& point, std::size_t index) {
  if (point.after) return {{"time"}, "s", *point.after};
  if (point.argument == Argument::speed) return {{"speed"}, "rad/s", point.at};
  if (point.argument == Argument::torque) return {{"torque"}, "N.m", point.at};
  for (const NamedValue& one : point.set)
    if (one.name == "frequency") return {{name_part(one.name)}, one.unit, one.value};
  return {{"place in the data"}, "1", static_cast<double>(index + 1)};
}

Section residual_section(const CalibrateResult& answer, const std::string& quantity, bool alone) {
  const std::string words = quantity_words(quantity);
  Section section{{"Residuals" + (alone ? "" : " of the " + words)},
                  {"They should scatter about zero without a pattern."}};
  section.wide = false;
  Series dots{"", Stroke::dots};
  Chart chart{"residuals" + (quantity == "torque_at" ? "" : " " + quantity), section.heading};
  for (std::size_t i = 0; i < answer.data.size(); ++i) {
    const Reading& point = answer.data[i];
    if (point.quantity != quantity) continue;
    const ReadAt place = place_of(point, i);
    if (dots.x.values.empty()) {
      chart.x = {place.name, place.unit};
      chart.y = {{"measured - fitted"}, point.unit, true};
    }
    dots.x.values.push_back(place.at);
    dots.y.values.push_back(point.residual);
  }
  chart.series = {dots};
  chart.guides = {{0, {}, Guide::Kind::level}};
  section.charts = {chart};
  return section;
}

// Numbers of which the data have one each: what the fit misses of each, in parts of it.
Section single_section(const CalibrateResult& answer,
                       const std::map<std::string, std::size_t>& counts) {
  Section section{{"Residuals of single values"},
                  {"Numbers that occur once in the data, by their place in the list of points."}};
  section.wide = false;
  Series dots{"", Stroke::dots};
  Chart chart{"residuals of single values", section.heading};
  chart.x = {{"place in the data"}, "1"};
  chart.y = {{"measured - fitted"}, "%", true};
  for (std::size_t i = 0; i < answer.data.size(); ++i) {
    const Reading& point = answer.data[i];
    if (counts.at(point.quantity) > 1 || point.quantity == "torque_at" || point.value == 0)
      continue;
    dots.x.values.push_back(static_cast<double>(i + 1));
    dots.y.values.push_back(point.residual / std::fabs(point.value));
    chart.marks.push_back(
        {dots.x.values.back(), dots.y.values.back(), {quantity_words(point.quantity)}});
  }
  chart.series = {dots};
  chart.guides = {{0, {}, Guide::Kind::level}};
  section.charts = {chart};
  return section;
}

}  // namespace

std::string quantity_words(const std::string& quantity) {
  const std::string words = plain_name(quantity);
  return words.ends_with(" at") ? words.substr(0, words.size() - 3) : words;
}

Phrase estimate_name(const Fitted& e) {
  if (e.file.empty()) return {name_part(e.parameter.name)};
  return {name_part(e.parameter.name.substr(0, e.parameter.name.find(" ("))), " (" + e.file + ")"};
}

std::vector<Section> fit_sections(const CalibrateResult& answer, const StudyFile& study) {
  const std::vector<FitCurve> curves = fit_curves(study, answer);
  const std::vector<CurveKind> kinds = by_kind(curves);
  std::vector<Section> list;
  for (const CurveKind& kind : kinds) list.push_back(fit_section(answer, kind, kinds.size() > 1));
  std::ranges::move(circle(answer, curves), std::back_inserter(list));
  return list;
}

std::vector<Section> profile_sections(const CalibrateResult& answer) {
  std::vector<Section> list;
  for (const Fitted& e : answer.estimates)
    if (e.profile.size() > 1) list.push_back(profile_section(answer, e));
  return list;
}

std::vector<Section> residual_sections(const CalibrateResult& answer) {
  std::map<std::string, std::size_t> counts;
  for (const Reading& point : answer.data) ++counts[point.quantity];
  std::vector<Section> list;
  for (const auto& [quantity, count] : counts)
    if (quantity == "torque_at" || count > 1)
      list.push_back(residual_section(answer, quantity, counts.size() == 1));
  if (Section single = single_section(answer, counts); !single.charts[0].marks.empty())
    list.push_back(std::move(single));
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
