// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/family.hpp"

#include <twum/base/no_value.hpp>
#include <twum/core/metrics.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numeric>
#include <utility>

namespace twum::studies {
namespace {

// Columns of a row behind its time.
struct HeatColumn {
  const char* name;
  const char* unit;
};
constexpr std::array kHeatColumns{
    HeatColumn{"stator_temperature", "K"},  HeatColumn{"rotor_temperature", "K"},
    HeatColumn{"housing_temperature", "K"}, HeatColumn{"contact_temperature", "K"},
    HeatColumn{"lining_temperature", "K"},  HeatColumn{"friction_loss", "W"},
    HeatColumn{"layer_loss", "W"},          HeatColumn{"stator_loss", "W"},
    HeatColumn{"dielectric_loss", "W"}};

std::vector<double> heat_row(double time, const PartTemperatures& t, const HeatLosses& p) {
  return {time,     t.stator,   t.rotor, t.housing, t.contact,
          t.lining, p.friction, p.layer, p.stator,  p.dielectric};
}

struct HeatedMotor {
  double value;  // of the family's parameter
  MotorDesign design;
};

std::vector<HeatedMotor> heated_motors(const HeatStudy& asked, const MotorDesign& base) {
  if (!asked.family) return {{kNoValue, base}};
  std::vector<HeatedMotor> motors;
  for (const double value : asked.family->values)
    motors.push_back({value, family_motor(base, asked.family->parameter, value)});
  return motors;
}

HeatNetwork network_of_motor(const MotorDesign& design) {
  if (!design.thermal->one_node) return heat_network(design);
  const double torque = design.thermal->one_node->torque;
  const std::array requests{MetricRequest{Metric::friction_power_at, Argument::torque, torque},
                            MetricRequest{Metric::layer_loss_at, Argument::torque, torque},
                            MetricRequest{Metric::stator_loss_at, Argument::torque, torque},
                            MetricRequest{Metric::dielectric_loss_at, Argument::torque, torque}};
  const auto found = evaluate(Motor(design), requests);
  const auto value = [&](std::size_t i) {
    return found[i].status == MetricStatus::ok ? found[i].value : 0;
  };
  return heat_network(design, {value(0), value(1), value(2), value(3)});
}

std::array<std::optional<double>, 4> limits_of(const Thermal& thermal) {
  return {thermal.stator.temperature_limit, thermal.rotor.temperature_limit,
          thermal.housing.temperature_limit, thermal.contact_temperature_limit};
}

// What a user looks at first of a motor that has warmed.
std::vector<HeatResult::Change> changes_of(const Motor& motor, const LoadPoint& load) {
  constexpr std::array kLooked{Metric::speed_at,
                               Metric::torque_at,
                               Metric::output_power_at,
                               Metric::electrical_power_at,
                               Metric::overall_efficiency_at,
                               Metric::amplitude_at,
                               Metric::drive_frequency_at,
                               Metric::phase_current_at};
  std::vector<MetricRequest> requests;
  for (const Metric metric : kLooked) {
    const MetricInfo& row = info(metric);
    const bool follows = metric == Metric::drive_frequency_at && load.argument != Argument::both;
    const bool given = (metric == Metric::speed_at && load.argument != Argument::torque) ||
                       (metric == Metric::torque_at && load.argument != Argument::speed);
    if (follows || given || (row.needs_modes && !has_modal_data(motor.design()))) continue;
    requests.push_back({metric, load.argument, load.at, load.torque, {}});
  }
  const std::size_t count = requests.size();
  for (std::size_t i = 0; i < count; ++i) {
    requests.push_back(requests[i]);
    requests.back().warm_at = load;
  }
  const auto found = evaluate(motor, requests);
  const auto number = [&](std::size_t i) {
    return found[i].status == MetricStatus::ok ? found[i].value : kNoValue;
  };
  std::vector<HeatResult::Change> changes;
  for (std::size_t i = 0; i < count; ++i) {
    const MetricInfo& row = info(requests[i].metric);
    changes.push_back({std::string(row.name), std::string(row.unit), number(i), number(count + i)});
  }
  return changes;
}

// With more points before the temperature at which the load is lost: an unstable state may stand close to it.
std::vector<HeatBalance> up_to_the_loss(const MotorDesign& design, const LoadPoint& load,
                                        std::vector<HeatBalance> balance) {
  constexpr int kHalvings = 12;
  const auto is_lost = [](const HeatBalance& one) { return one.status != MetricStatus::ok; };
  auto lost = std::ranges::find_if(balance, is_lost);
  for (int i = 0; i < kHalvings && lost != balance.begin() && lost != balance.end(); ++i) {
    const double middle = 0.5 * ((lost - 1)->temperature + lost->temperature);
    const HeatBalance there = heat_balance(design, load, {middle}).front();
    lost = balance.insert(lost, there);
    if (!is_lost(there)) ++lost;
  }
  return balance;
}

// Over the stator's temperature, from ambient to well beyond the hottest limit and the steady state.
std::vector<HeatBalance> balance_of(const MotorDesign& design, const LoadPoint& load,
                                    const SteadyHeat& steady) {
  constexpr std::size_t kPoints = 61;
  double top = design.thermal->ambient + 100;
  for (const auto& limit : limits_of(*design.thermal)) top = std::max(top, limit.value_or(0));
  if (steady.status == MetricStatus::ok)
    top = std::max(top, 2 * steady.temperatures.stator - design.thermal->ambient);
  std::vector<double> temperatures;
  for (std::size_t i = 0; i < kPoints; ++i)
    temperatures.push_back(design.thermal->ambient + (top - design.thermal->ambient) *
                                                         static_cast<double>(i) /
                                                         static_cast<double>(kPoints - 1));
  return up_to_the_loss(design, load, heat_balance(design, load, temperatures));
}

// Where losses and the heat that leaves cross, Newton's method finds the state.
std::vector<HeatResult::State> states_of(const MotorDesign& design, const LoadPoint& load,
                                         const std::vector<HeatBalance>& balance) {
  std::vector<HeatResult::State> states;
  for (std::size_t i = 0; i + 1 < balance.size(); ++i) {
    const HeatBalance &a = balance[i], &b = balance[i + 1];
    if (a.status != MetricStatus::ok || b.status != MetricStatus::ok ||
        (a.losses > a.leaving) == (b.losses > b.leaving))
      continue;
    const double share = (a.losses - a.leaving) / (a.losses - a.leaving - b.losses + b.leaving);
    const SteadyHeat found =
        steady_heat_near(design, load, std::lerp(a.temperature, b.temperature, share));
    if (found.status != MetricStatus::ok && found.status != MetricStatus::thermally_unstable)
      continue;
    states.push_back({found.status == MetricStatus::ok, found.temperatures, found.gain});
  }
  return states;
}

HeatResult::Steady steady_of(const MotorDesign& design, const LoadPoint& load) {
  const Motor motor(design);
  const SteadyHeat found = steady_heat(motor.design(), load);
  HeatResult::Steady steady;
  steady.status = to_string(found.status);
  steady.temperatures = found.temperatures, steady.losses = found.losses;
  steady.gain = found.gain, steady.time_constant = found.time_constant;
  steady.lost_after = found.lost_after;
  const auto ask = [&](Metric metric) {
    return evaluate(motor, {metric, load.argument, load.at, load.torque, {}});
  };
  const MetricValue on_time = ask(Metric::on_time_at), share = ask(Metric::duty_limit_at);
  steady.on_time_status = to_string(on_time.status), steady.on_time = on_time.value;
  steady.duty_limit_status = to_string(share.status), steady.duty_limit = share.value;
  steady.balance = balance_of(motor.design(), load, found);
  steady.states = states_of(motor.design(), load, steady.balance);
  steady.changes = changes_of(motor, load);
  return steady;
}

double period_of(const std::vector<LoadPhase>& phases) {
  return std::accumulate(phases.begin(), phases.end(), 0.0,
                         [](double sum, const LoadPhase& phase) { return sum + phase.time; });
}

std::vector<double> even_times(double end, std::uint64_t points) {
  std::vector<double> times;
  for (std::uint64_t i = 0; i < points; ++i)
    times.push_back(end * static_cast<double>(i) / static_cast<double>(points - 1));
  return times;
}

// A stage for each motor, a row for each time. All of a motor is computed when the first of its rows is needed.
class HeatRun : public StudyKindRun {
 public:
  HeatRun(const HeatStudy& asked, const MotorDesign& base)
      : asked_(asked), motors_(heated_motors(asked, base)), computed_(motors_.size()) {
    for (const HeatedMotor& one : motors_) {
      if (!one.design.thermal)
        throw InputError("study: the motor has no temperatures; give 'thermal' in the motor file");
      if (!asked_.load() && one.design.operation.empty())
        throw InputError(
            "study: nothing loads the motor; give a torque, a speed, or both, or 'operation' in "
            "the motor file");
    }
    if (asked.family) family_ = family_column(asked.family->parameter);
  }

  std::vector<StoredColumn> columns() const override {
    std::vector<StoredColumn> columns;
    if (family_) columns.push_back(*family_);
    columns.push_back({"time", "s"});
    for (const HeatColumn& one : kHeatColumns) columns.push_back({one.name, one.unit});
    return columns;
  }

  std::size_t variables() const override { return family_ ? 2 : 1; }

  KindAnswer run(RunContext& context) override {
    HeatResult result;
    result.family = family_, result.load = asked_.load();
    bool complete = true;
    for (std::size_t i = 0; complete && i < motors_.size(); ++i) {
      if (context.stop.stop_requested()) return {StudyOutcome::interrupted, result};
      result.members.push_back(member(i));
      complete =
          store_rows(context, i, asked_.points, asked_.points * i, asked_.points * motors_.size());
    }
    result.time = end_of_time(result.members.front());
    const bool any = std::ranges::any_of(result.members, [](const HeatResult::Member& one) {
      return (one.steady && one.steady->status == "ok") || (one.cycle && one.cycle->status == "ok");
    });
    return {!complete ? StudyOutcome::interrupted
            : any     ? StudyOutcome::done
                      : StudyOutcome::failed,
            std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage >= motors_.size() || asked.index >= asked_.points) return {};
    const HeatResult::Member& one = member(asked.stage);
    StoredRow row{asked.stage, asked.index, {}, "ok", {}};
    if (family_) row.values.push_back(one.value);
    const std::vector<double> numbers = asked_.load() ? of_warm_up(one, row) : of_cycle(one, row);
    row.values.insert(row.values.end(), numbers.begin(), numbers.end());
    return row;
  }

 private:
  double end_of_time(const HeatResult::Member& one) const {
    return asked_.time.value_or(5 * one.time_constants.back());
  }

  // NaN behind the time from where the point is lost.
  std::vector<double> of_warm_up(const HeatResult::Member& one, StoredRow& row) const {
    const double time = even_times(end_of_time(one), asked_.points)[row.index];
    if (row.index < one.warm_up.size()) {
      const WarmUpPoint& point = one.warm_up[row.index];
      row.status = to_string(point.status);
      if (point.status == MetricStatus::ok) return heat_row(time, point.temperatures, point.losses);
    } else if (!one.warm_up.empty()) {
      row.status = to_string(one.warm_up.back().status);
    }
    return lost(time);
  }

  std::vector<double> of_cycle(const HeatResult::Member& one, StoredRow& row) const {
    const auto& course = one.cycle->found.course;
    row.status = one.cycle->status;
    if (row.index < course.size())
      return heat_row(course[row.index].time, course[row.index].temperatures,
                      course[row.index].losses);
    return lost(even_times(period_of(one.cycle->phases), asked_.points)[row.index]);
  }

  static std::vector<double> lost(double time) {
    std::vector<double> numbers(1 + kHeatColumns.size(), kNoValue);
    numbers.front() = time;
    return numbers;
  }

  const HeatResult::Member& member(std::size_t number) const {
    const std::lock_guard guard(mutex_);
    if (!computed_[number]) computed_[number] = computed(motors_[number]);
    return *computed_[number];
  }

  HeatResult::Member computed(const HeatedMotor& motor) const {
    const MotorDesign& design = motor.design;
    HeatResult::Member one;
    one.value = motor.value, one.ambient = design.thermal->ambient;
    one.network = network_of_motor(design);
    one.time_constants = time_constants(one.network);
    one.limits = limits_of(*design.thermal);
    if (const auto load = asked_.load()) {
      one.steady = steady_of(design, *load);
      one.warm_up = warm_up(design, *load, even_times(end_of_time(one), asked_.points));
    }
    if (!design.operation.empty()) {
      const auto times = even_times(period_of(design.operation), asked_.points);
      one.cycle =
          HeatResult::Cycle{{}, design.operation, load_cycle(design, design.operation, times)};
      one.cycle->status = to_string(one.cycle->found.status);
    }
    return one;
  }

  HeatStudy asked_;
  std::vector<HeatedMotor> motors_;
  std::optional<StoredColumn> family_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::vector<std::optional<HeatResult::Member>> computed_;
};

}  // namespace

std::optional<LoadPoint> HeatStudy::load() const { return load_point(torque, speed); }

std::unique_ptr<StudyKindRun> HeatStudy::run(const StudyFile& file) const {
  return std::make_unique<HeatRun>(*this, file.motor.design);
}

}  // namespace twum::studies
