// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/manoeuvres.hpp>

#include "free_life_metrics.hpp"
#include "manoeuvre_runs.hpp"
#include "plant_metrics.hpp"
#include "without_value.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/core/motor.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace twum::inline v0_1::motion {
namespace {

using M = Metric;

constexpr double kVoltageWithin = 1e-5;  // relative, of the dynamic start voltage
// Above the static start voltage, at which the dead wave ends.
constexpr double kAboveStatic = 1e-3;

// Between the static threshold, above which every step starts the motor, and the voltage below which it does not run.
double dynamic_start_voltage(const MotorDesign& design) {
  const Motor motor(design);
  const auto starts = [&](double voltage) {
    const MotorDesign tried = with(design, Parameter::voltage, voltage);
    return ManoeuvreRuns(tried, nullptr).starts();
  };
  double high = value_or_reason(twum::evaluate(motor, {M::start_voltage}));
  if (high == 0) return 0;
  high *= 1 + kAboveStatic;
  if (!starts(high)) throw WithoutValue{MetricStatus::does_not_start};
  double low = value_or_reason(twum::evaluate(motor, {M::hold_voltage}));
  while (high - low > kVoltageWithin * high) {
    const double middle = 0.5 * (low + high);
    (starts(middle) ? high : low) = middle;
  }
  return high;
}

// A move goes forward, and a burst has a period.
bool has_meaning(const MetricRequest& request) {
  switch (request.argument) {
    case Argument::angle: return request.at > 0;
    case Argument::periods: return request.at >= 1;
    default: return true;
  }
}

// Starts and stops by their torques, each run once for all metrics of it.
class Kept {
 public:
  Moving number(const ManoeuvreRuns& runs, const MetricRequest& request) {
    const double at = request.at;
    const auto start = [&]() -> const Start& {
      return once(starts_, at, [&] { return runs.start(at); });
    };
    const auto stop = [&]() -> const RunEnd& {
      return once(stops_, at, [&] { return runs.stop(at); });
    };
    switch (request.metric) {
      case M::start_time_at: return runs.start_time(start());
      case M::start_overshoot_at: return runs.start_overshoot(start());
      case M::stop_time_at: return runs.stop_time(stop());
      case M::stop_angle_at: return runs.stop_angle(stop());
      case M::move_energy: return runs.move_energy(at);
      default: return runs.burst_angle(at);
    }
  }

 private:
  template <typename Run, typename Find>
  static const Run& once(std::map<double, Run>& kept, double torque, Find find) {
    const auto place = kept.find(torque);
    return place != kept.end() ? place->second : kept.emplace(torque, find()).first->second;
  }

  std::map<double, Start> starts_;
  std::map<double, RunEnd> stops_;
};

class Answers final : public MotionMetrics {
 public:
  Answers(const MotorDesign& design, std::vector<Parameter> wanted)
      : design_(design), wanted_(std::move(wanted)), lives_(design) {}

  MetricValue evaluate(const MetricRequest& request) override {
    return answered([&] { return number(request); });
  }

  MetricDerivative differentiate(const MetricRequest& request, bool fixed) override {
    MetricDerivative found{evaluate(request), {}, Smoothness::undefined};
    found.gradient.fill(kNoValue);
    const bool exact = request.metric != M::dynamic_start_voltage && !is_of_life(request);
    if (found.value.status != MetricStatus::ok || !exact) return found;
    const auto gradient = [&] {
      return is_of_plant(request.metric) ? plant_gradient(design_, request)
                                         : gradient_of_runs(request, fixed);
    };
    const MetricValue status = answered([&] {
      found.gradient = gradient();
      leave_out_others(found.gradient);
      return found.value.value;
    });
    if (status.status == MetricStatus::ok) found.smoothness = smoothness(found);
    return found;
  }

 private:
  // A speed that rises to its steady value has no overshoot, and none beside the design.
  static Smoothness smoothness(const MetricDerivative& found) {
    const auto zero = [](double d) { return d == 0; };
    return std::ranges::all_of(found.gradient, zero) ? Smoothness::flat : Smoothness::smooth;
  }

  template <typename Ask>
  static MetricValue answered(Ask ask) {
    try {
      const double found = ask();
      return std::isfinite(found) ? MetricValue{found, MetricStatus::ok}
                                  : MetricValue{kNoValue, MetricStatus::inaccurate};
    } catch (const WithoutValue& without) {
      return {kNoValue, without.status};
    } catch (const EvaluationError&) {
      return {kNoValue, MetricStatus::unresolved};
    } catch (const InputError&) {  // no rotor, no voltage
      return {kNoValue, MetricStatus::undefined};
    }
  }

  double number(const MetricRequest& request) {
    if (is_of_life(request)) return lives_.number(request);
    if (!has_meaning(request)) throw WithoutValue{MetricStatus::undefined};
    if (is_of_plant(request.metric)) return plant_number(design_, request);
    if (request.metric == M::dynamic_start_voltage) return dynamic_start_voltage(design_);
    return plain_.number(ManoeuvreRuns(design_, nullptr), request).value;
  }

  // @throws WithoutValue if not all derivatives are finite
  std::array<double, kParameterCount> gradient_of_runs(const MetricRequest& request, bool fixed) {
    if (!slopes_ || fixed != fixed_) {
      slopes_.emplace(design_, fixed, wanted_);
      fixed_ = fixed, moving_ = {};
    }
    const Moving found = moving_.number(ManoeuvreRuns(design_, &*slopes_), request);
    std::array<double, kParameterCount> gradient{};
    for (std::size_t k = 0; k < found.slopes.size(); ++k) {
      if (!std::isfinite(found.slopes[k])) throw WithoutValue{MetricStatus::inaccurate};
      gradient[index_of(slopes_->columns()[k].parameter)] = found.slopes[k];
    }
    leave_out_driver(gradient);
    return gradient;
  }

  // The first ohm or henry of a driver makes states of the terminals, which then no longer step with the voltage: a motion without
  // them has no slope in it.
  void leave_out_driver(std::array<double, kParameterCount>& gradient) const {
    const Driver driver = design_.driver.value_or(Driver{});
    if (!design_.driver || driver.inductance != 0) return;
    gradient[index_of(Parameter::driver_inductance)] = kNoValue;
    if (driver.resistance == 0) gradient[index_of(Parameter::driver_resistance)] = kNoValue;
  }

  void leave_out_others(std::array<double, kParameterCount>& gradient) const {
    if (wanted_.empty()) return;
    for (std::size_t i = 0; i < kParameterCount; ++i)
      if (std::ranges::find(wanted_, static_cast<Parameter>(i)) == wanted_.end())
        gradient[i] = kNoValue;
  }

  const MotorDesign& design_;
  std::vector<Parameter> wanted_;
  std::optional<ModelSlopes> slopes_;
  bool fixed_{false};
  Kept plain_, moving_;
  FreeLives lives_;
};

}  // namespace

std::unique_ptr<MotionMetrics> motion_metrics(const MotorDesign& design) {
  return std::make_unique<Answers>(design, std::vector<Parameter>{});
}

std::unique_ptr<MotionMetrics> motion_metrics(const MotorDesign& design,
                                              std::vector<Parameter> wanted) {
  return std::make_unique<Answers>(design, std::move(wanted));
}

}  // namespace twum::inline v0_1::motion
