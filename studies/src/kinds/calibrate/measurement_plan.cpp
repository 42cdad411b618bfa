// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibrate/measurement_plan.hpp"

#include "kinds/calibrate/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::size_t kLength = 10;  // measurements of a plan
constexpr int kGrid = 24;            // number of speeds or torques tried for a reading
// Part of the largest torque that a reading is planned at: a motor a little weaker than the fit stalls beyond it.
constexpr double kSafeTorque = 0.9;

// A number that may be measured next.
struct Candidate {
  MeasuredPoint point;
  std::vector<double>
      slope;  // of its weighted residual, by the parameters in parts of their ranges
};

// Covariance of the parameters relative to their ranges, from the ranges and the data; updated with each measurement.
class Knowledge {
 public:
  // Before any measurement each parameter is anywhere in its range: the variance of a uniform number.
  Knowledge(std::size_t parameters, double scatter) : n_(parameters), scatter_(scatter) {
    covariance_.assign(n_ * n_, 0.0);
    for (std::size_t j = 0; j < n_; ++j) covariance_[j * n_ + j] = 1.0 / 12;
  }

  // ln of the factor by which the squared volume of the region shrinks (L6.1).
  double gain(const std::vector<double>& slope) const {
    return std::log1p(variance_along(slope) / (scatter_ * scatter_));
  }

  // L6.2: C - C g g^T C / (s^2 + g^T C g).
  void add(const std::vector<double>& slope) {
    const std::vector<double> v = times(slope);
    const double below = scatter_ * scatter_ + variance_along(slope);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j) covariance_[i * n_ + j] -= v[i] * v[j] / below;
  }

  double width(std::size_t j) const { return std::sqrt(covariance_[j * n_ + j]); }
  double trace() const {
    double sum = 0;
    for (std::size_t j = 0; j < n_; ++j) sum += covariance_[j * n_ + j];
    return sum;
  }

 private:
  std::vector<double> times(const std::vector<double>& slope) const {
    std::vector<double> v(n_, 0.0);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j) v[i] += covariance_[i * n_ + j] * slope[j];
    return v;
  }
  double variance_along(const std::vector<double>& slope) const {
    const std::vector<double> v = times(slope);
    double sum = 0;
    for (std::size_t j = 0; j < n_; ++j) sum += slope[j] * v[j];
    return sum;
  }

  std::size_t n_;
  double scatter_;
  std::vector<double> covariance_;
};

class Planner {
 public:
  /// @param tables  names of those with values of their own; none if all have the same
  Planner(const MeasuredFit& fit, std::vector<double> values, double scatter,
          std::vector<std::string> tables = {})
      : fit_(fit),
        values_(std::move(values)),
        tables_(std::move(tables)),
        knowledge_(values_.size(), scatter) {}

  // Adds the points of the fit.
  void learn() {
    const optim::Residuals known = fit_.residuals(values_);
    for (std::size_t i = 0; i < known.values.size(); ++i)
      knowledge_.add(in_ranges(known.jacobian.data() + i * values_.size()));
  }

  std::vector<CalibrateResult::Planned> plan() {
    const std::vector<Candidate> candidates = all_candidates();
    std::vector<CalibrateResult::Planned> plan;
    if (candidates.empty()) return plan;
    const Knowledge first = knowledge_;
    double volume = 0;
    while (plan.size() < kLength) {
      const auto best = std::max_element(
          candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
            return knowledge_.gain(a.slope) < knowledge_.gain(b.slope);
          });
      volume += knowledge_.gain(best->slope);
      knowledge_.add(best->slope);
      plan.push_back(planned(*best, first, volume));
    }
    return plan;
  }

 private:
  // By a parameter in parts of its range, or of its logarithm's.
  std::vector<double> in_ranges(const double* slope) const {
    std::vector<double> scaled;
    for (std::size_t j = 0; j < values_.size(); ++j) {
      const DesignVariable& range = fit_.parameters()[j];
      scaled.push_back(slope[j] * (range.scale == optim::Scale::log
                                       ? values_[j] * std::log(range.max / range.min)
                                       : range.max - range.min));
    }
    return scaled;
  }

  CalibrateResult::Planned planned(const Candidate& one, const Knowledge& first,
                                   double volume) const {
    CalibrateResult::Planned planned;
    planned.point = point_of(one.point);
    if (!tables_.empty()) planned.file = tables_[one.point.table];
    planned.volume = std::exp(-0.5 * volume);
    planned.mean = std::sqrt(knowledge_.trace() / first.trace());
    for (std::size_t j = 0; j < values_.size(); ++j)
      planned.widths.push_back(knowledge_.width(j) / first.width(j));
    return planned;
  }

  // Tables with values of their own are different motors; the others are one.
  bool same_motor(const MeasuredPoint& a, const MeasuredPoint& b) const {
    return tables_.empty() || a.table == b.table;
  }

  // Candidates of the kinds measured on each motor, without those for which it has no value.
  std::vector<Candidate> all_candidates() const {
    std::vector<Candidate> list;
    std::vector<const MeasuredPoint*> kinds;
    for (const MeasuredPoint& point : fit_.points()) {
      const bool known = std::any_of(kinds.begin(), kinds.end(), [&](const MeasuredPoint* k) {
        return same_kind(k->reading, point.reading) && same_motor(*k, point);
      });
      if (known) continue;
      kinds.push_back(&point);
      for (const auto& set : settings(point))
        for (const Reading& reading : places(point)) add(point, reading, set, list);
    }
    return list;
  }

  void add(const MeasuredPoint& like, const Reading& reading,
           const std::vector<ParameterValue>& set, std::vector<Candidate>& list) const {
    MeasuredPoint point{reading, 0, weight_of(like), like.deviation, set, {}, {}, like.table};
    if ((!was_reached(like, point) && overheats(point)) || takes_a_life(point)) return;
    optim::Residuals found = fit_.asking({point}).residuals(values_);
    if (!found.failure.empty()) return;
    list.push_back({std::move(point), in_ranges(found.jacobian.data())});
  }

  // On a warm-up under the settings of one that was measured.
  static bool was_reached(const MeasuredPoint& like, const MeasuredPoint& point) {
    const auto* request = std::get_if<MetricRequest>(&point.reading);
    return request != nullptr && request->after &&
           plain_numbers(like.set) == plain_numbers(point.set);
  }

  // A steady temperature is not measured where the motor would become hotter than a part of it bears.
  bool overheats(const MeasuredPoint& point) const {
    const auto* request = std::get_if<MetricRequest>(&point.reading);
    if (request == nullptr || info(request->metric).unit != "K") return false;
    const MotorDesign design = with(fit_.motor_at(values_, point.table), point.set);
    MetricRequest margin = *request;
    margin.metric = Metric::temperature_margin_at;
    const MetricValue found = evaluate(Motor(design), margin);
    return found.status == MetricStatus::ok && found.value < 0;
  }

  // Nobody plans to wear a motor out. Depths after some hours are measured where it runs anyway.
  static bool takes_a_life(const MeasuredPoint& point) {
    const auto* request = std::get_if<MetricRequest>(&point.reading);
    return request != nullptr && info(request->metric).needs_wear &&
           request->metric != Metric::wear_rate_at;
  }

  // Mean weight of the points of its kind on its motor, assumed for a further point.
  double weight_of(const MeasuredPoint& like) const {
    double sum = 0;
    double count = 0;
    for (const MeasuredPoint& point : fit_.points()) {
      if (!same_kind(point.reading, like.reading) || !same_motor(point, like)) continue;
      sum += point.weight;
      ++count;
    }
    return sum / count;
  }

  // Speeds up to no load, or torques up to nine tenths of the largest; of the impedance the frequencies that were measured.
  std::vector<Reading> places(const MeasuredPoint& like) const {
    const Reading& reading = like.reading;
    const auto* request = std::get_if<MetricRequest>(&reading);
    if (request == nullptr || request->argument == Argument::none) return {reading};
    if (request->after) return times(like);
    const Metric end =
        request->argument == Argument::speed ? Metric::no_load_speed : Metric::max_torque;
    const MetricValue last =
        evaluate(Motor(fit_.motor_at(values_, like.table)), MetricRequest{end});
    const double most = last.value * (request->argument == Argument::torque ? kSafeTorque : 1);
    std::vector<Reading> list;
    for (int i = 0; i <= kGrid && last.status == MetricStatus::ok; ++i) {
      MetricRequest one = *request;
      one.at = most * i / kGrid;
      list.emplace_back(one);
    }
    return list;
  }

  // On a warm-up under a load that was measured: at any time up to the longest.
  std::vector<Reading> times(const MeasuredPoint& like) const {
    std::vector<Reading> list;
    std::map<std::pair<int, double>, double> longest;  // of each load, by its kind and number
    for (const MeasuredPoint& point : fit_.points())
      if (const auto* request = std::get_if<MetricRequest>(&point.reading);
          request != nullptr && request->after && same_motor(point, like)) {
        double& time = longest[{static_cast<int>(request->argument), request->at}];
        time = std::max(time, *request->after);
      }
    for (const auto& [load, time] : longest)
      for (int i = 1; i <= kGrid; ++i) {
        MetricRequest one = std::get<MetricRequest>(like.reading);
        one.argument = static_cast<Argument>(load.first), one.at = load.second;
        one.after = time * i / kGrid;
        list.emplace_back(one);
      }
    return list;
  }

  // Settings: the motor unchanged, with other preloads and voltages, and with the settings of the data.
  std::vector<std::vector<ParameterValue>> settings(const MeasuredPoint& like) const {
    if (std::holds_alternative<CircuitPart>(like.reading)) return frequencies(like);
    std::vector<std::vector<ParameterValue>> list{{}};
    for (const Parameter parameter : {Parameter::preload, Parameter::voltage}) {
      if (!in_use(fit_.motor(), parameter) || fit_.sets(parameter)) continue;
      for (const double factor : {0.75, 1.25})
        list.push_back({{parameter, factor * get(fit_.motor(), parameter)}});
    }
    std::set<std::vector<double>> known;
    for (const std::vector<ParameterValue>& set : list) known.insert(plain_numbers(set));
    for (const MeasuredPoint& point : fit_.points())
      if (same_motor(point, like) && known.insert(plain_numbers(point.set)).second)
        list.push_back(point.set);
    return list;
  }

  // Settings of the data for the free stator, which no preload or voltage changes; each with its frequency.
  std::vector<std::vector<ParameterValue>> frequencies(const MeasuredPoint& like) const {
    std::vector<std::vector<ParameterValue>> list;
    std::set<std::vector<double>> known;
    for (const MeasuredPoint& point : fit_.points()) {
      if (!std::holds_alternative<CircuitPart>(point.reading) || !same_motor(point, like)) continue;
      std::vector<ParameterValue> set = point.set;
      const bool given = std::any_of(set.begin(), set.end(), [](const ParameterValue& one) {
        return one.first == Parameter::frequency || one.first == Parameter::frequency_ratio;
      });
      if (!given && !fit_.sets(Parameter::frequency))
        set.emplace_back(Parameter::frequency, get(fit_.motor(), Parameter::frequency));
      if (known.insert(plain_numbers(set)).second) list.push_back(std::move(set));
    }
    return list;
  }

  const MeasuredFit& fit_;
  std::vector<double> values_;
  std::vector<std::string> tables_;
  Knowledge knowledge_;
};

}  // namespace

std::vector<CalibrateResult::Planned> measurement_plan(const MeasuredFit& fit,
                                                       const optim::LeastSquaresResult& best,
                                                       const std::vector<std::string>& tables) {
  const bool scatter = std::isfinite(best.scatter) && !fit.exact(best.scatter);
  if (!scatter) return {};
  std::vector<double> values;
  for (const optim::Estimate& e : best.estimates) values.push_back(e.value);
  Planner planner(fit, std::move(values), best.scatter,
                  fit.per_file() ? tables : std::vector<std::string>{});
  planner.learn();
  return planner.plan();
}

std::vector<MeasuredPoint> first_readings(const MotorDesign& motor) {
  std::vector<Metric> metrics{Metric::torque_at};
  if (in_use(motor, Parameter::voltage))
    metrics.insert(metrics.end(), {Metric::phase_current_at, Metric::electrical_power_at});
  std::vector<MeasuredPoint> points;
  const Motor at_work(motor);
  const MetricValue last = evaluate(at_work, MetricRequest{Metric::no_load_speed});
  for (const Metric metric : metrics) {
    double largest = 0;
    for (int i = 0; i <= kGrid; ++i) {
      const MetricValue one =
          evaluate(at_work, MetricRequest{metric, Argument::speed, last.value * i / kGrid});
      if (one.status == MetricStatus::ok) largest = std::max(largest, std::fabs(one.value));
    }
    const double deviation = kFirstDeviation * largest;
    if (largest > 0)
      points.push_back(
          {MetricRequest{metric, Argument::speed, 0}, 0, 1 / (deviation * deviation), deviation});
  }
  return points;
}

std::vector<CalibrateResult::Planned> first_plan(const MeasuredFit& readings,
                                                 std::vector<double> values) {
  return Planner(readings, std::move(values), 1).plan();
}

}  // namespace twum::inline v0_1::studies
