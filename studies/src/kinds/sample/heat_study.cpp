// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/family_run.hpp"

#include <twum/base/no_value.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/engineering.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace twum::inline v0_1::studies {
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

HeatNetwork known_network(const MotorDesign& design) {
  if (!design.thermal)
    throw InputError("study: the motor has no temperatures; give 'thermal' in the motor file");
  if (const auto network = motor_network(design)) return *network;
  throw InputError("study: the motor does not carry the torque of thermal.one_node, " +
                   engineering(design.thermal->one_node->torque, "N.m") +
                   ", so that its conductance is not known; give a rise at another torque");
}

// A row for each time.
class HeatRun : public FamilyRun<HeatResult> {
 public:
  HeatRun(const HeatStudy& asked, const MotorDesign& base)
      : FamilyRun(asked.family, base, asked.points), asked_(asked) {
    for (const FamilyMotor& one : motors()) {
      known_network(one.design);
      require_load(asked_.load(), one.design);
    }
    constexpr double kSettled = 5;  // slowest time constants; 1 % of the rise is left
    time_ = asked.time.value_or(kSettled *
                                time_constants(known_network(motors().front().design)).back());
  }

 private:
  std::vector<StoredColumn> own_columns() const override {
    std::vector<StoredColumn> columns{{"time", "s"}};
    for (const HeatColumn& one : kHeatColumns) columns.push_back({one.name, one.unit});
    return columns;
  }

  HeatResult frame() const override {
    HeatResult result;
    result.load = asked_.load(), result.time = time_;
    return result;
  }

  bool has_answer(const Member& one) const override {
    return (one.steady && one.steady->status == "ok") || (one.cycle && one.cycle->status == "ok");
  }

  void add_numbers(const Member& one, StoredRow& row) const override {
    const std::vector<double> numbers = asked_.load() ? of_warm_up(one, row) : of_cycle(one, row);
    row.values.insert(row.values.end(), numbers.begin(), numbers.end());
  }

  // NaN behind the time from where the point is lost.
  std::vector<double> of_warm_up(const Member& one, StoredRow& row) const {
    const double time = even_times(time_, points())[row.index];
    const WarmUpPoint& point =
        one.warm_up[std::min<std::size_t>(row.index, one.warm_up.size() - 1)];
    row.status = to_string(point.status);
    return point.status == MetricStatus::ok ? heat_row(time, point.temperatures, point.losses)
                                            : lost(time);
  }

  std::vector<double> of_cycle(const Member& one, StoredRow& row) const {
    const auto& course = one.cycle->found.course;
    row.status = one.cycle->status;
    if (row.index < course.size())
      return heat_row(course[row.index].time, course[row.index].temperatures,
                      course[row.index].losses);
    return lost(even_times(period_of(one.cycle->phases), points())[row.index]);
  }

  static std::vector<double> lost(double time) {
    std::vector<double> numbers(1 + kHeatColumns.size(), kNoValue);
    numbers.front() = time;
    return numbers;
  }

  Member computed(const FamilyMotor& motor) const override {
    const MotorDesign& design = motor.design;
    Member one;
    one.ambient = design.thermal->ambient;
    one.network = known_network(design);
    one.time_constants = time_constants(one.network);
    one.limits = limits_of(*design.thermal);
    if (const auto load = asked_.load()) {
      one.steady = steady_of(design, *load);
      one.warm_up = warm_up(design, *load, even_times(time_, points()));
    }
    if (!design.operation.empty()) {
      const auto times = even_times(period_of(design.operation), points());
      one.cycle =
          HeatResult::Cycle{{}, design.operation, load_cycle(design, design.operation, times)};
      one.cycle->status = to_string(one.cycle->found.status);
    }
    return one;
  }

  HeatStudy asked_;
  double time_;  // of the warm-up [s]
};

}  // namespace

std::optional<LoadPoint> HeatStudy::load() const { return load_point(torque, speed); }

std::unique_ptr<StudyKindRun> HeatStudy::run(const StudyFile& file) const {
  return std::make_unique<HeatRun>(*this, file.motor.design);
}

}  // namespace twum::inline v0_1::studies
