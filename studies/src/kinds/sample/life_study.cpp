// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/family_run.hpp"
#include "kinds/sample/life_way.hpp"
#include "kinds/sample/wear_profile.hpp"

#include <twum/base/no_value.hpp>
#include <twum/core/life.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/engineering.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies {
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

// A row for each depth.
class LifeRun : public FamilyRun<LifeResult> {
 public:
  LifeRun(const LifeStudy& asked, const MotorDesign& base)
      : FamilyRun(asked.family, base, asked.points), asked_(asked) {
    for (const FamilyMotor& one : motors()) {
      if (!one.design.wear)
        throw InputError("study: the motor does not wear; give 'wear' in the motor file");
      require_load(asked_.load(), one.design);
      require_way_of_life(one.design, asked_.load());
    }
    told_ = told_metrics(asked_, motors().front().design);
  }

 private:
  std::vector<StoredColumn> own_columns() const override {
    std::vector<StoredColumn> columns{{"depth", "m"}};
    for (const WearColumn& one : kWearColumns) columns.push_back({one.name, one.unit});
    for (const StoredColumn& one : told_columns()) columns.push_back(one);
    return columns;
  }

  LifeResult frame() const override {
    LifeResult result;
    result.load = asked_.load(), result.columns = told_columns();
    return result;
  }

  // A motor that does not wear has a life without end; wear that localizes has a history.
  bool has_answer(const Member& one) const override {
    return one.life.status == MetricStatus::ok || is_endless(one.life.status) ||
           one.life.status == MetricStatus::wear_localizes;
  }

  void add_numbers(const Member& one, StoredRow& row) const override {
    const std::size_t columns = row.values.size() + own_columns().size();
    row.status = one.status;
    if (row.index < one.points.size()) {
      const LifeResult::Point& point = one.points[row.index];
      row.status = to_string(point.wear.status);
      row.values.push_back(point.wear.depth);
      for (const WearColumn& column : kWearColumns) row.values.push_back(column.value(point.wear));
      row.values.insert(row.values.end(), point.metrics.begin(), point.metrics.end());
    }
    row.values.resize(columns, kNoValue);
  }

  std::vector<StoredColumn> told_columns() const {
    std::vector<StoredColumn> columns;
    for (const MetricRequest& request : told_)
      columns.push_back({short_name(request), std::string(info(request.metric).unit)});
    return columns;
  }

  Member computed(const FamilyMotor& motor) const override {
    const MotorDesign& design = motor.design;
    const auto load = asked_.load();
    Member one;
    one.one_slice = design.stator.radial_slices == 1;
    const LifeWay way = way_of_life(design, load, points());
    one.life = way.life, one.free = way.free;
    one.status = to_string(one.life.status);
    one.limits = limits_of(design, one.life);
    if (way.points.empty()) return one;
    for (const WayPoint& point : way.points) one.points.push_back(point_of(point));
    set_margins(design, way.points, one);
    if (const auto told = told_load(asked_, design)) {
      one.profile_new = wear_profile(design, *told);
      one.profile_worn = wear_profile(way.points.back().motor, *told);
      one.stability = way.stability.value_or(wear_stability(design, *told));
      if (WornIn state = worn_in(design, *told); state.status == MetricStatus::ok)
        one.worn_in = std::move(state);
    }
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
    if (design.wear->preload_spring > 0)
      limits.push_back({"preload >= 0 N", life.end == EndOfLife::preload_gone});
    if (design.wear->specific_wear.value_or(0) > 0)
      limits.push_back({"thickness >= 0 m", life.end == EndOfLife::worn_through});
    return limits;
  }

  LifeResult::Point point_of(const WayPoint& on_way) const {
    LifeResult::Point point{on_way.wear, {}, {}};
    const Motor worn(on_way.motor);
    for (const MetricValue& found : evaluate(worn, told_))
      point.metrics.push_back(number_of(found));
    return point;
  }

  // Each margin over that of the new motor.
  static void set_margins(const MotorDesign& design, const std::vector<WayPoint>& way,
                          LifeResult::Member& one) {
    const std::vector<WearLimit>& until = design.wear->until;
    std::vector<double> first;
    for (std::size_t i = 0; i < way.size(); ++i) {
      LifeResult::Point& point = one.points[i];
      if (const auto depth = design.wear->depth_limit)
        point.margins.push_back(1 - way[i].deepest / *depth);
      const Motor worn(way[i].motor);
      for (std::size_t j = 0; j < until.size(); ++j) {
        const double left = margin_of(until[j], number_of(evaluate(worn, until[j].request)));
        if (first.size() <= j) first.push_back(left);
        point.margins.push_back(left / first[j]);
      }
      if (design.wear->preload_spring > 0)
        point.margins.push_back(point.wear.preload / design.preload);
      if (design.wear->specific_wear.value_or(0) > 0)
        point.margins.push_back(point.wear.thickness / design.layer.thickness);
    }
  }

  LifeStudy asked_;
  std::vector<MetricRequest> told_;
};

}  // namespace

std::optional<LoadPoint> LifeStudy::load() const { return load_point(torque, speed); }

std::unique_ptr<StudyKindRun> LifeStudy::run(const StudyFile& file) const {
  return std::make_unique<LifeRun>(*this, file.motor.design);
}

}  // namespace twum::inline v0_1::studies
