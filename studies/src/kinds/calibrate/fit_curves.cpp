// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/fit_curves.hpp>

#include "kinds/calibrate/asked_fit.hpp"

#include <twum/optim/fit_band.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

// Places of a curve: enough for a smooth one; a number at a torque takes a search for the speed.
constexpr std::size_t kAtSpeed = 121;
constexpr std::size_t kAtTorque = 41;
// Room beyond the points.
constexpr double kBeyond = 0.04;

using Data = std::vector<CalibrateResult::Point>;

// The parameter that the bench varied most for a quantity; none if it has one value throughout.
std::optional<NamedValue> most_varied(const Data& data, const std::string& quantity) {
  std::map<std::string, std::set<double>> values;
  std::optional<NamedValue> most;
  std::size_t count = 1;
  for (const auto& point : data) {
    if (point.quantity != quantity) continue;
    for (const NamedValue& one : point.set) {
      auto& seen = values[one.name];
      seen.insert(one.value);
      if (seen.size() <= count) continue;
      count = seen.size();
      most = {one.name, one.unit, 0};
    }
  }
  return most;
}

bool same_set(const std::vector<NamedValue>& a, const std::vector<NamedValue>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const NamedValue& x, const NamedValue& y) {
                      return x.name == y.name && x.value == y.value;
                    });
}

bool is_end_of(const CalibrateResult::Point& point, const std::string& quantity) {
  return (point.quantity == "no_load_speed" && quantity == "speed_at") ||
         (point.quantity == "stall_torque" && quantity == "torque_at");
}

// What is read in a point of the data, at another speed or torque, or after another time.
decltype(MeasuredPoint::reading) reading_of(const CalibrateResult::Point& point, double at) {
  if (const auto metric = find_metric(point.quantity)) {
    MetricRequest request{*metric, point.argument, point.argument == Argument::none ? 0 : at};
    if (point.after) request.at = point.at, request.after = at;
    return request;
  }
  return *find_circuit_part(point.quantity);
}

class Curves {
 public:
  Curves(const StudyFile& study, const CalibrateResult& result)
      : result_(result),
        asked_(std::get<CalibrateStudy>(study.asked)),
        files_(result.files()),
        fit_(study.motor.design, fit_parameters(asked_), {}, asked_.derived) {
    for (const auto& e : result.estimates) values_.push_back(e.parameter.value);
    prepare_region();
  }

  std::vector<FitCurve> all() const {
    std::vector<FitCurve> curves;
    std::map<std::pair<std::string, int>, std::optional<NamedValue>> axes;
    for (std::size_t i = 0; i < result_.data.size(); ++i) {
      const CalibrateResult::Point& point = result_.data[i];
      const auto [known, fresh] =
          axes.try_emplace({point.quantity, static_cast<int>(point.argument)});
      if (fresh) known->second = axis_of(result_.data, point);
      sort_in(i, known->second, curves);
    }
    for (std::size_t i = 0; i < result_.data.size(); ++i) join_end(i, curves);
    for (FitCurve& curve : curves) draw(curve);
    return curves;
  }

 private:
  void sort_in(std::size_t number, const std::optional<NamedValue>& over,
               std::vector<FitCurve>& curves) const {
    const CalibrateResult::Point& point = result_.data[number];
    if (!over || std::isnan(place_on(point, *over))) return;
    FitCurve curve{point.quantity, point.unit, *over, {}, {}, {}, {}, {}, {}, {}};
    for (const NamedValue& one : point.set)
      if (one.name != over->name) curve.set.push_back(one);
    if (point.after) curve.set.push_back(load_of(point));
    if (files_.size() > 1) curve.file = table_of(point);
    auto known = std::find_if(curves.begin(), curves.end(), [&](const FitCurve& c) {
      return c.quantity == curve.quantity && c.over.name == curve.over.name &&
             same_set(c.set, curve.set) && c.file == curve.file;
    });
    if (known == curves.end()) known = curves.insert(curves.end(), std::move(curve));
    known->points.push_back(number);
  }

  // A speed without load is the end of a curve of speeds over torques, a torque at rest that of torques over speeds.
  void join_end(std::size_t number, std::vector<FitCurve>& curves) const {
    const CalibrateResult::Point& point = result_.data[number];
    for (FitCurve& curve : curves) {
      const bool its_table = curve.file.empty() || curve.file == table_of(point);
      if (is_end_of(point, curve.quantity) && its_table && same_set(point.set, curve.set)) {
        curve.points.push_back(number);
        return;
      }
    }
  }

  void draw(FitCurve& curve) const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::size_t i : curve.points) {
      const double at = place_on(result_.data[i], curve.over);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    const bool point = result_.data[curve.points.front()].argument != Argument::none;
    const double room = point ? 0 : kBeyond * (high - low);
    if (point) low = std::min(low, 0.0);
    const bool in_time = curve.over.name == "time";  // warm-ups are steep where they begin
    const std::size_t count = curve.over.name == "torque" ? kAtTorque : kAtSpeed;
    for (std::size_t k = 0; k < count; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(count - 1);
      curve.at.push_back(std::lerp(low - room, high + room, in_time ? share * share : share));
    }
    for (const Place& place : places_of(curve, values_)) {
      const double half =
          linear_ && !place.gradient.empty() ? half_width(place.gradient) : kNoValue;
      curve.value.push_back(place.value);
      curve.low.push_back(place.value - half), curve.high.push_back(place.value + half);
    }
    if (!linear_) add_band(curve);
  }

  // What a motor has at a place of a curve; NaN and no gradient where it has nothing.
  struct Place {
    double value{kNoValue};
    std::vector<double> gradient{};
  };

  // All places at once, which share their work; one by one if there is one without a value.
  std::vector<Place> places_of(const FitCurve& curve, const std::vector<double>& values) const {
    std::vector<MeasuredPoint> asked;
    for (const double at : curve.at) asked.push_back(reading(curve, at));
    if (std::vector<Place> all = places_of(asked, values); !all.empty()) return all;
    std::vector<Place> list;
    for (const MeasuredPoint& point : asked) {
      const std::vector<Place> alone = places_of({point}, values);
      list.push_back(alone.empty() ? Place{} : alone.front());
    }
    return list;
  }

  // Empty if one of them has no value. Residuals carry the root of a weight, which is 1.
  std::vector<Place> places_of(const std::vector<MeasuredPoint>& asked,
                               const std::vector<double>& values) const {
    const optim::Residuals found = fit_.asking(asked).residuals(values);
    if (!found.failure.empty()) return {};
    std::vector<Place> list;
    const auto n = static_cast<std::ptrdiff_t>(values.size());
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const auto row = found.jacobian.begin() + static_cast<std::ptrdiff_t>(k) * n;
      list.push_back({found.values[k], {row, row + n}});
    }
    return list;
  }

  // (L3.3): between the numbers of the motors at which the curve is lowest and highest at some places. Without all of them there is
  // no band.
  void add_band(FitCurve& curve) const {
    const std::vector<std::vector<double>> motors = farthest_motors(curve);
    if (motors.empty()) return;
    curve.low = curve.high = curve.value;
    for (const std::vector<double>& values : motors) {
      const std::vector<Place> places = places_of(curve, values);
      for (std::size_t k = 0; k < places.size(); ++k) {
        const double value = places[k].value;
        const bool none = std::isnan(value) || std::isnan(curve.low[k]);
        curve.low[k] = none ? kNoValue : std::min(curve.low[k], value);
        curve.high[k] = none ? kNoValue : std::max(curve.high[k], value);
      }
    }
  }

  // Each end of the band at some places; the next one begins where the last one was found.
  std::vector<std::vector<double>> farthest_motors(const FitCurve& curve) const {
    constexpr std::size_t kPlaces = 5;
    std::vector<std::vector<double>> motors;
    for (const optim::IntervalEnd end : {optim::IntervalEnd::low, optim::IntervalEnd::high}) {
      std::vector<double> near;
      for (std::size_t k = 0; k < kPlaces; ++k) {
        const double share = static_cast<double>(k) / (kPlaces - 1);
        const MeasuredFit fit =
            fit_.asking({reading(curve, std::lerp(curve.at.front(), curve.at.back(), share))});
        const auto prediction = [&](std::span<const double> values) {
          const optim::Residuals found = fit.residuals(values);
          return found.failure.empty() ? optim::Prediction{found.values.front(), found.jacobian}
                                       : optim::Prediction{};
        };
        auto found = optim::band_end(
            fit_.variables({}), [&](auto values) { return data_->residuals(values); }, prediction,
            values_, rise_, end, near);
        if (!found) return {};
        near = *found;
        motors.push_back(std::move(*found));
      }
    }
    return motors;
  }

  // Of the value 0 and the weight 1: its residual is what the motor has.
  MeasuredPoint reading(const FitCurve& curve, double at) const {
    const CalibrateResult::Point& like = result_.data[curve.points.front()];
    MeasuredPoint point;
    point.reading = reading_of(like, at);
    for (const NamedValue& one : like.set)
      point.set.emplace_back(*find_parameter(one.name),
                             one.name == curve.over.name ? at : one.value);
    point.table = static_cast<std::size_t>(std::find(files_.begin(), files_.end(), curve.file) -
                                           files_.begin());
    return point;
  }

  // (L2.4) Without an interval of every parameter there is no band.
  double half_width(const std::vector<double>& gradient) const {
    const std::size_t n = values_.size();
    double variance = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (gradient[i] * gradient[j] != 0)
          variance += gradient[i] * gradient[j] * result_.estimates[i].deviation *
                      result_.estimates[j].deviation * result_.correlation[i * n + j];
    return result_.student_t * std::sqrt(std::max(variance, 0.0));
  }

  // A measured number as the fit has it.
  MeasuredPoint measured(const CalibrateResult::Point& point) const {
    MeasuredPoint one;
    one.reading = reading_of(point, point.after.value_or(point.at));
    one.value = point.value, one.weight = point.weight, one.deviation = point.deviation;
    for (const NamedValue& set : point.set)
      one.set.emplace_back(*find_parameter(set.name), set.value);
    if (files_.size() > 1)
      one.table = static_cast<std::size_t>(
          std::find(files_.begin(), files_.end(), table_of(point)) - files_.begin());
    return one;
  }

  // Where an interval differs from the linearised one, the band needs the residuals (L3.3). Other losses than squares, and errors
  // or columns with a scatter of their own, have no such region.
  void prepare_region() {
    const bool profiled = std::any_of(result_.estimates.begin(), result_.estimates.end(),
                                      [](const auto& e) { return e.profiled; });
    const bool held =
        std::any_of(result_.estimates.begin(), result_.estimates.end(),
                    [](const auto& e) { return e.bound != CalibrateResult::Bound::none; });
    linear_ = !profiled || held || !result_.columns.empty() || result_.serial || result_.huber;
    if (linear_) return;
    std::vector<MeasuredPoint> points;
    for (const auto& point : result_.data) points.push_back(measured(point));
    data_ = fit_.asking(std::move(points));
    const double scatter = result_.stated ? data_->stated_deviation() : result_.residual_deviation;
    rise_ = std::pow(result_.student_t * scatter, 2);
  }

  const CalibrateResult& result_;
  const CalibrateStudy& asked_;
  std::vector<std::string> files_;
  MeasuredFit fit_;
  std::vector<double> values_;
  bool linear_{true};                // the intervals are those of (L2.1)
  std::optional<MeasuredFit> data_;  // where they are not
  double rise_{0};                   // (t s)^2 of (L3.1)
};

}  // namespace

std::string table_of(const CalibrateResult::Point& point) {
  return point.where.substr(0, point.where.rfind(':'));
}

NamedValue load_of(const CalibrateResult::Point& point) {
  if (point.argument == Argument::speed) return {"speed", "rad/s", point.at};
  return {"torque", "N.m", point.at};
}

std::optional<NamedValue> axis_of(const Data& data, const CalibrateResult::Point& point) {
  if (point.after) return NamedValue{"time", "s", 0};
  if (point.argument == Argument::speed) return NamedValue{"speed", "rad/s", 0};
  if (point.argument == Argument::torque) return NamedValue{"torque", "N.m", 0};
  return most_varied(data, point.quantity);
}

double place_on(const CalibrateResult::Point& point, const NamedValue& over) {
  if (point.after || over.name == "time")
    return over.name == "time" ? point.after.value_or(kNoValue) : kNoValue;
  if (point.argument != Argument::none) return point.at;
  if (over.name == "torque" || over.name == "speed") return 0;  // the end of a curve over it
  const auto found = std::find_if(point.set.begin(), point.set.end(),
                                  [&](const NamedValue& one) { return one.name == over.name; });
  return found == point.set.end() ? kNoValue : found->value;
}

std::vector<FitCurve> fit_curves(const StudyFile& study, const CalibrateResult& result) {
  if (result.estimates.empty() || result.unmeasured) return {};
  return Curves(study, result).all();
}

}  // namespace twum::inline v0_1::studies
