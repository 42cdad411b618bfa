// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/fit_curves.hpp>

#include "kinds/calibrate/asked_fit.hpp"
#include "results/profile_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace twum::studies {
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

class Curves {
 public:
  Curves(const StudyFile& study, const CalibrateResult& result)
      : result_(result),
        asked_(std::get<CalibrateStudy>(study.asked)),
        files_(result.files()),
        fit_(study.motor.design, fit_parameters(asked_), {}, asked_.derived) {
    for (const auto& e : result.estimates) values_.push_back(e.parameter.value);
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
    const std::size_t count = curve.over.name == "torque" ? kAtTorque : kAtSpeed;
    for (std::size_t k = 0; k < count; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(count - 1);
      add(std::lerp(low - room, high + room, share), curve);
    }
  }

  void add(double at, FitCurve& curve) const {
    const MeasuredFit fit = fit_.asking({reading(curve, at)});
    const optim::Residuals found = fit.residuals(values_);
    const bool ok = found.failure.empty();
    const Band band = ok ? band_of(fit, found) : Band{};
    curve.at.push_back(at);
    curve.value.push_back(ok ? found.values.front() : kNoValue);
    curve.low.push_back(band.low), curve.high.push_back(band.high);
  }

  // Of the value 0 and the weight 1: its residual is what the motor has.
  MeasuredPoint reading(const FitCurve& curve, double at) const {
    const CalibrateResult::Point& like = result_.data[curve.points.front()];
    MeasuredPoint point;
    if (const auto metric = find_metric(curve.quantity))
      point.reading =
          MetricRequest{*metric, like.argument, like.argument == Argument::none ? 0 : at};
    else
      point.reading = *find_circuit_part(curve.quantity);
    for (const NamedValue& one : like.set)
      point.set.emplace_back(*find_parameter(one.name),
                             one.name == curve.over.name ? at : one.value);
    point.table = static_cast<std::size_t>(std::find(files_.begin(), files_.end(), curve.file) -
                                           files_.begin());
    return point;
  }

  struct Band {
    double low{kNoValue}, high{kNoValue};
  };

  // (L3.3). There is no band without an interval of each parameter that counts, nor where the motor at an edge has no value.
  Band band_of(const MeasuredFit& fit, const optim::Residuals& here) const {
    const std::vector<double> parts = steepest_parts(here.jacobian);
    const double value = here.values.front();
    const double below = moved(fit, parts, -1), above = moved(fit, parts, 1);
    if (std::isnan(below) || std::isnan(above)) return {};
    return {std::min({value, below, above}), std::max({value, below, above})};
  }

  // z of (L3.3): parts of the half intervals by which the parameters move where the number rises most for their joint probability.
  std::vector<double> steepest_parts(const std::vector<double>& gradient) const {
    const std::size_t n = values_.size();
    std::vector<double> parts(n, 0.0);
    double variance = 0;
    for (std::size_t j = 0; j < n; ++j) {
      if (gradient[j] == 0) continue;
      const double slope = gradient[j] * result_.estimates[j].deviation;
      for (std::size_t i = 0; i < n; ++i) {
        if (gradient[i] == 0 && std::isnan(result_.estimates[i].deviation)) continue;  // stays
        const double part = result_.correlation[i * n + j] * slope;
        parts[i] += part;
        if (gradient[i] != 0) variance += gradient[i] * result_.estimates[i].deviation * part;
      }
    }
    if (variance == 0) return std::vector<double>(n, 0.0);
    for (double& part : parts) part = std::clamp(part / std::sqrt(variance), -1.0, 1.0);
    return parts;
  }

  // The number of a motor whose parameters have moved by these parts, to one side or the other.
  double moved(const MeasuredFit& fit, const std::vector<double>& parts, double side) const {
    std::vector<double> values = values_;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isnan(parts[i])) return kNoValue;
      values[i] = value_at_part(result_.estimates[i], side * parts[i]);
    }
    const optim::Residuals found = fit.residuals(values);
    return found.failure.empty() ? found.values.front() : kNoValue;
  }

  const CalibrateResult& result_;
  const CalibrateStudy& asked_;
  std::vector<std::string> files_;
  MeasuredFit fit_;
  std::vector<double> values_;
};

}  // namespace

std::string table_of(const CalibrateResult::Point& point) {
  return point.where.substr(0, point.where.rfind(':'));
}

std::optional<NamedValue> axis_of(const Data& data, const CalibrateResult::Point& point) {
  if (point.argument == Argument::speed) return NamedValue{"speed", "rad/s", 0};
  if (point.argument == Argument::torque) return NamedValue{"torque", "N.m", 0};
  return most_varied(data, point.quantity);
}

double place_on(const CalibrateResult::Point& point, const NamedValue& over) {
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

}  // namespace twum::studies
