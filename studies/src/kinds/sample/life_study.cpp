// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/family.hpp"

#include <twum/base/no_value.hpp>
#include <twum/core/life.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/engineering.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <utility>

namespace twum::studies {
namespace {

struct WearColumn {
  const char* name;
  const char* unit;
  double (*value)(const WearPoint&);
};
constexpr std::array kWearColumns{
    WearColumn{"time", "s", [](const WearPoint& p) { return p.seconds; }},
    WearColumn{"revolutions", "1", [](const WearPoint& p) { return p.revolutions; }},
    WearColumn{"wear_rate", "m/s", [](const WearPoint& p) { return p.rate; }},
    WearColumn{"thickness", "m", [](const WearPoint& p) { return p.thickness; }},
    WearColumn{"preload", "N", [](const WearPoint& p) { return p.preload; }},
    WearColumn{"contact_temperature", "K",
               [](const WearPoint& p) { return p.contact_temperature; }}};

struct LivingMotor {
  double value;  // of the family's parameter
  MotorDesign design;
};

std::vector<LivingMotor> living_motors(const LifeStudy& asked, const MotorDesign& base) {
  if (!asked.family) return {{kNoValue, base}};
  std::vector<LivingMotor> motors;
  for (const double value : asked.family->values)
    motors.push_back({value, family_motor(base, asked.family->parameter, value)});
  return motors;
}

// The load whose speed or torque is told along a life: that asked for, or the first of the operation.
std::optional<LoadPoint> told_load(const LifeStudy& asked, const MotorDesign& design) {
  if (const auto load = asked.load()) return load;
  for (const LoadPhase& phase : design.operation)
    if (phase.load) return phase.load;
  return {};
}

// What is told of the worn motor besides its wear.
std::vector<MetricRequest> told_metrics(const LifeStudy& asked, const MotorDesign& design) {
  std::vector<MetricRequest> list;
  if (const auto load = told_load(asked, design)) {
    if (load->argument == Argument::torque)
      list.push_back({Metric::speed_at, Argument::torque, load->at});
    if (load->argument == Argument::speed)
      list.push_back({Metric::torque_at, Argument::speed, load->at});
    list.push_back({design.stator.voltage ? Metric::electrical_power_at : Metric::stator_power_at,
                    load->argument,
                    load->at,
                    load->torque,
                    {}});
  }
  list.push_back({Metric::holding_torque});
  if (design.stator.voltage) list.push_back({Metric::start_voltage});
  return list;
}

std::string short_name(const MetricRequest& request) {
  const std::string_view name = info(request.metric).name;
  return std::string(request.argument == Argument::none ? name : name.substr(0, name.rfind("_at")));
}

double number_of(const MetricValue& found) {
  return found.status == MetricStatus::ok ? found.value : kNoValue;
}

double margin_of(const WearLimit& limit, double value) {
  return std::fmin(value - limit.lower, limit.upper - value);
}

// A stage for each motor, a row for each depth. All of a motor is computed when the first of its rows is needed.
class LifeRun : public StudyKindRun {
 public:
  LifeRun(const LifeStudy& asked, const MotorDesign& base)
      : asked_(asked), motors_(living_motors(asked, base)), computed_(motors_.size()) {
    for (const LivingMotor& one : motors_) {
      if (!one.design.wear)
        throw InputError("study: the motor does not wear; give 'wear' in the motor file");
      if (!asked_.load() && one.design.operation.empty())
        throw InputError(
            "study: nothing loads the motor; give a torque, a speed, or both, or 'operation' in "
            "the motor file");
    }
    told_ = told_metrics(asked_, motors_.front().design);
    if (asked.family) family_ = family_column(asked.family->parameter);
  }

  std::vector<StoredColumn> columns() const override {
    std::vector<StoredColumn> columns;
    if (family_) columns.push_back(*family_);
    columns.push_back({"depth", "m"});
    for (const WearColumn& one : kWearColumns) columns.push_back({one.name, one.unit});
    for (const StoredColumn& one : told_columns()) columns.push_back(one);
    return columns;
  }

  std::size_t variables() const override { return family_ ? 2 : 1; }

  KindAnswer run(RunContext& context) override {
    LifeResult result;
    result.family = family_, result.load = asked_.load(), result.columns = told_columns();
    bool complete = true;
    for (std::size_t i = 0; complete && i < motors_.size(); ++i) {
      if (context.stop.stop_requested()) return {StudyOutcome::interrupted, result};
      result.members.push_back(member(i));
      complete =
          store_rows(context, i, asked_.points, asked_.points * i, asked_.points * motors_.size());
    }
    const bool any = std::ranges::any_of(
        result.members, [](const LifeResult::Member& one) { return one.status == "ok"; });
    return {!complete ? StudyOutcome::interrupted
            : any     ? StudyOutcome::done
                      : StudyOutcome::failed,
            std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage >= motors_.size() || asked.index >= asked_.points) return {};
    const LifeResult::Member& one = member(asked.stage);
    StoredRow row{asked.stage, asked.index, {}, one.status, {}};
    if (family_) row.values.push_back(one.value);
    if (asked.index < one.points.size()) {
      const LifeResult::Point& point = one.points[asked.index];
      row.status = to_string(point.wear.status);
      row.values.push_back(point.wear.depth);
      for (const WearColumn& column : kWearColumns) row.values.push_back(column.value(point.wear));
      row.values.insert(row.values.end(), point.metrics.begin(), point.metrics.end());
    } else {
      row.values.resize(columns().size(), kNoValue);
    }
    return row;
  }

 private:
  std::vector<StoredColumn> told_columns() const {
    std::vector<StoredColumn> columns;
    for (const MetricRequest& request : told_)
      columns.push_back({short_name(request), std::string(info(request.metric).unit)});
    return columns;
  }

  const LifeResult::Member& member(std::size_t number) const {
    const std::lock_guard guard(mutex_);
    if (!computed_[number]) computed_[number] = computed(motors_[number]);
    return *computed_[number];
  }

  LifeResult::Member computed(const LivingMotor& motor) const {
    const MotorDesign& design = motor.design;
    const auto load = asked_.load();
    LifeResult::Member one;
    one.value = motor.value;
    one.one_slice = design.stator.radial_slices == 1;
    one.life = load ? life(design, *load) : life(design);
    one.status = to_string(one.life.status);
    one.limits = limits_of(design, one.life);
    if (one.life.status != MetricStatus::ok) return one;
    std::vector<double> depths;
    for (std::uint64_t i = 0; i < asked_.points; ++i)
      depths.push_back(one.life.depth * static_cast<double>(i) /
                       static_cast<double>(asked_.points - 1));
    for (const WearPoint& wear : wear_course(design, load, depths))
      one.points.push_back(point_of(design, wear));
    set_margins(design, one);
    return one;
  }

  static std::vector<LifeResult::Limit> limits_of(const MotorDesign& design, const Life& life) {
    std::vector<LifeResult::Limit> limits;
    if (const auto depth = design.wear->depth_limit)
      limits.push_back(
          {"depth <= " + engineering(*depth, "m"), life.end == EndOfLife::depth_limit});
    for (std::size_t i = 0; i < design.wear->until.size(); ++i)
      limits.push_back(
          {design.wear->until[i].text, life.end == EndOfLife::limit && life.limit == i});
    return limits;
  }

  LifeResult::Point point_of(const MotorDesign& design, const WearPoint& wear) const {
    LifeResult::Point point{wear, {}, {}};
    const Motor worn(worn_motor(design, wear.depth));
    for (const MetricValue& found : evaluate(worn, told_))
      point.metrics.push_back(number_of(found));
    return point;
  }

  // Each margin over that of the new motor.
  static void set_margins(const MotorDesign& design, LifeResult::Member& one) {
    const std::vector<WearLimit>& until = design.wear->until;
    std::vector<double> first;
    for (LifeResult::Point& point : one.points) {
      if (const auto depth = design.wear->depth_limit)
        point.margins.push_back(1 - point.wear.depth / *depth);
      const Motor worn(worn_motor(design, point.wear.depth));
      for (std::size_t j = 0; j < until.size(); ++j) {
        const double left = margin_of(until[j], number_of(evaluate(worn, until[j].request)));
        if (first.size() <= j) first.push_back(left);
        point.margins.push_back(left / first[j]);
      }
    }
  }

  LifeStudy asked_;
  std::vector<LivingMotor> motors_;
  std::vector<MetricRequest> told_;
  std::optional<StoredColumn> family_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::vector<std::optional<LifeResult::Member>> computed_;
};

}  // namespace

std::optional<LoadPoint> LifeStudy::load() const { return load_point(torque, speed); }

std::unique_ptr<StudyKindRun> LifeStudy::run(const StudyFile& file) const {
  return std::make_unique<LifeRun>(*this, file.motor.design);
}

}  // namespace twum::studies
