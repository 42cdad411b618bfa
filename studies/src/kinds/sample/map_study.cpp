// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/executor.hpp"
#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/family.hpp"

#include <twum/base/no_value.hpp>
#include <twum/base/ordered.hpp>
#include <twum/core/metrics.hpp>
#include <twum/motors/curve_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

struct MapColumn {
  const char* name;
  const char* unit;
  double (*value)(const HeldPoint&);
};

// What follows from the point that a drive holds, beside what curves tell of it. The last two a motor with modal data has.
constexpr std::array kHeld{
    MapColumn{"efficiency", "1", [](const HeldPoint& h) { return h.point.efficiency(); }},
    MapColumn{"amplitude", "m", [](const HeldPoint& h) { return h.amplitude; }},
    MapColumn{"held_by_control_only", "1",
              [](const HeldPoint& h) { return h.by_control_only ? 1.0 : 0.0; }},
    MapColumn{"drive_frequency", "Hz", [](const HeldPoint& h) { return h.frequency; }},
    MapColumn{"drive_voltage", "V", [](const HeldPoint& h) { return h.voltage; }}};
constexpr std::size_t kOfContact = 3;

// Columns of curves but for speed and torque, which a map asks for, and those above.
std::vector<CurveColumn> curve_columns_of(const MotorDesign& design) {
  std::vector<CurveColumn> columns = curve_columns(design);
  std::erase_if(columns, [](const CurveColumn& one) {
    const std::string_view name = one.name;
    return name == "speed" || name == "torque" || name == "amplitude" || name == "voltage";
  });
  return columns;
}

std::size_t place_of(const std::vector<StoredColumn>& columns, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(columns, name, &StoredColumn::name) -
                                  columns.begin());
}

// What is known of a point; the same for every motor of a family.
class MapColumns {
 public:
  MapColumns(const MotorDesign& design, std::optional<Metric> quantity)
      : curve_(curve_columns_of(design)) {
    const bool modal = has_modal_data(design);
    held_.assign(kHeld.begin(), modal ? kHeld.end() : kHeld.begin() + kOfContact);
    for (const MapColumn& one : held_) names_.push_back({one.name, one.unit});
    for (const CurveColumn& one : curve_) names_.push_back({one.name, one.unit});
    const char* whole = modal ? "overall_efficiency" : "efficiency";
    efficiency_ = shown_ = place_of(names_, whole);
    if (quantity) show(*quantity);
  }

  const std::vector<StoredColumn>& names() const { return names_; }
  std::size_t efficiency() const { return efficiency_; }
  std::size_t shown() const { return shown_; }

  // NaN where the drive does not hold the point.
  std::vector<double> values(const Motor& motor, double torque, double speed,
                             const HeldPoint& held) const {
    if (held.status != HeldStatus::ok) return std::vector<double>(names_.size(), kNoValue);
    std::vector<double> values;
    for (const MapColumn& one : held_) values.push_back(one.value(held));
    for (const CurveColumn& one : curve_) values.push_back(one.value(held.point));
    if (!extra_) return values;
    const MetricValue more = evaluate(motor, {*extra_, Argument::both, speed, torque});
    values.push_back(more.status == MetricStatus::ok ? more.value : kNoValue);
    return values;
  }

 private:
  // A metric that is none of the columns becomes one.
  void show(Metric metric) {
    const MetricInfo& row = info(metric);
    const std::string_view name = row.name.substr(0, row.name.rfind("_at"));
    shown_ = place_of(names_, name);
    if (shown_ < names_.size()) return;
    extra_ = metric;
    names_.push_back({std::string(name), std::string(row.unit)});
  }

  std::vector<MapColumn> held_;
  std::vector<CurveColumn> curve_;
  std::vector<StoredColumn> names_;
  std::size_t efficiency_{0}, shown_{0};
  std::optional<Metric> extra_;
};

struct MappedMotor {
  double value;  // of the family's parameter
  Motor motor;
};

// Torques of one speed, which are held one after the other; made when a row first asks for one of them.
struct MapPiece {
  std::once_flag made;
  std::vector<HeldPoint> held;
};

std::vector<MappedMotor> motors_of(const MapStudy& asked, const MotorDesign& base) {
  std::vector<MappedMotor> motors;
  for (const FamilyMotor& one : family_motors(asked.family, base))
    motors.push_back({one.value, Motor(one.design)});
  return motors;
}

double value_or_none(const MetricValue& value) {
  return value.status == MetricStatus::ok ? value.value : kNoValue;
}

double largest_torque(const Motor& motor, double speed) {
  return value_or_none(evaluate(motor, {Metric::held_torque_limit_at, Argument::speed, speed}));
}

double largest_speed(const Motor& motor) {
  return value_or_none(evaluate(motor, {Metric::held_speed_limit_at, Argument::torque, 0}));
}

// A stage for each motor, a row for each point.
class MapRun : public StudyKindRun {
 public:
  MapRun(const MapStudy& asked, const MotorDesign& base)
      : asked_(asked),
        motors_(motors_of(asked, base)),
        columns_(motors_.front().motor.design(), asked.quantity),
        pieces_(motors_.size() * asked.points.speeds * pieces_of_line()) {
    if (asked.family) family_ = family_column(asked.family->parameter);
  }

  std::vector<StoredColumn> columns() const override {
    std::vector<StoredColumn> columns;
    if (family_) columns.push_back(*family_);
    columns.push_back({"speed", "rad/s"});
    columns.push_back({"torque", "N.m"});
    columns.insert(columns.end(), columns_.names().begin(), columns_.names().end());
    return columns;
  }

  std::size_t variables() const override { return family_ ? 3 : 2; }

  KindAnswer run(RunContext& context) override {
    if (!ends_) ends_ = ends_found(context.executor.lanes(), context.stop);
    bool complete = ends_.has_value();
    for (std::size_t i = 0; complete && i < motors_.size(); ++i)
      complete = store_rows(context, i, count(), count() * i, count() * motors_.size());
    if (!complete) return {StudyOutcome::interrupted, without_members()};
    MapResult result = without_members();
    for (std::size_t i = 0; i < motors_.size(); ++i)
      result.members.push_back(member(context.store, i));
    const bool any = std::ranges::any_of(result.members, [](const MapResult::Member& one) {
      return std::ranges::any_of(
          one.points, [](const MapResult::Point& point) { return point.status == "ok"; });
    });
    return {any ? StudyOutcome::done : StudyOutcome::failed, std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage >= motors_.size() || asked.index >= count()) return {};
    StoredRow row{asked.stage, asked.index, {}, "ok", {}};
    const MappedMotor& one = motors_[row.stage];
    const std::uint64_t line = row.index / asked_.points.torques,
                        place = row.index % asked_.points.torques;
    const double speed = speed_of(line), torque = torque_of(place);
    const MapResult::Point point =
        point_of(one.motor, torque, speed, held_at(row.stage, line, place));
    if (family_) row.values.push_back(one.value);
    row.values.insert(row.values.end(), {speed, torque});
    row.values.insert(row.values.end(), point.values.begin(), point.values.end());
    row.status = point.status;
    return row;
  }

 private:
  struct Ends {
    double speed, torque;                             // of both axes
    std::vector<double> speeds;                       // largest one of each motor
    std::vector<std::vector<double>> largest_torque;  // of each motor at each speed
  };

  /// At the largest torque itself rounding decides, and a millionth below what friction carries there is no wave (Y2.1).
  static constexpr double kInside = 1 - 1e-5;

  std::uint64_t count() const { return asked_.points.speeds * asked_.points.torques; }

  double speed_of(std::uint64_t number) const {
    return ends().speed * static_cast<double>(number + 1) /
           static_cast<double>(asked_.points.speeds);
  }

  double torque_of(std::uint64_t number) const {
    return ends().torque * static_cast<double>(number) /
           static_cast<double>(asked_.points.torques - 1);
  }

  // A piece is short enough for a stop request to be seen, also where a point takes 15 ms.
  static constexpr std::uint64_t kPiece = 40;
  std::uint64_t pieces_of_line() const { return (asked_.points.torques + kPiece - 1) / kPiece; }

  // The same whichever thread asks first: a piece always begins at its first torque.
  const HeldPoint& held_at(std::uint64_t motor, std::uint64_t line, std::uint64_t place) const {
    const std::uint64_t speed = motor * asked_.points.speeds + line,
                        first = place / kPiece * kPiece;
    MapPiece& piece = pieces_[speed * pieces_of_line() + place / kPiece];
    std::call_once(piece.made, [&] {
      std::vector<double> torques;
      for (std::uint64_t j = first; j < std::min(first + kPiece, asked_.points.torques); ++j)
        torques.push_back(torque_of(j));
      piece.held = held_points(motors_[motor].motor.design(), torques, speed_of(line));
    });
    return piece.held[place - first];
  }

  // The ends that are not given contain what the drives of all motors hold.
  const Ends& ends() const {
    const std::lock_guard guard(mutex_);
    if (!ends_) ends_ = ends_found(1, {});
    return *ends_;
  }

  // Nothing if a stop was requested.
  std::optional<Ends> ends_found(unsigned jobs, const std::stop_token& stop) const {
    Ends ends{asked_.speed.value_or(0), asked_.torque.value_or(0), {}, {}};
    for (const MappedMotor& one : motors_) {
      ends.speeds.push_back(largest_speed(one.motor));
      if (!asked_.speed) ends.speed = std::fmax(ends.speed, ends.speeds.back());
    }
    if (!(ends.speed > 0))
      throw InputError(
          "study.speed: the drive holds no speed without load, so that the map has no "
          "upper end of its own; give one, such as 150 rpm");
    for (const MappedMotor& one : motors_) {
      std::vector<double>& torques = ends.largest_torque.emplace_back();
      const auto proceed = [&stop] { return !stop.stop_requested(); };
      const std::uint64_t speeds = asked_.points.speeds;
      const std::uint64_t made = run_indexed(
          {0, speeds, jobs, proceed},
          [&](std::uint64_t i) {
            return largest_torque(
                one.motor, ends.speed * static_cast<double>(i + 1) / static_cast<double>(speeds));
          },
          [&](std::uint64_t, const std::vector<double>& some) {
            torques.insert(torques.end(), some.begin(), some.end());
          });
      if (made < speeds) return {};
      if (!asked_.torque)
        for (const double torque : torques) ends.torque = std::fmax(ends.torque, torque);
    }
    if (!(ends.torque > 0))
      throw InputError(
          "study.torque: the drive holds no torque at these speeds, so that the map has "
          "no upper end of its own; give one, such as 1 N.m");
    if (!asked_.torque) ends.torque *= kInside;
    return ends;
  }

  MapResult::Point point_of(const Motor& motor, double torque, double speed,
                            const HeldPoint& held) const {
    return {speed, torque, to_string(held.status), columns_.values(motor, torque, speed, held)};
  }

  MapResult without_members() const {
    MapResult result;
    result.family = family_, result.columns = columns_.names();
    result.shown = columns_.shown(), result.efficiency = columns_.efficiency();
    if (ends_) result.speed = ends_->speed, result.torque = ends_->torque;
    result.speeds = asked_.points.speeds, result.torques = asked_.points.torques;
    return result;
  }

  MapResult::Member member(const ResultStore& store, std::size_t number) const {
    const auto& [value, motor] = motors_[number];
    MapResult::Member member{value, ends().speeds[number], {}, {}, {}};
    const auto first = static_cast<std::ptrdiff_t>(variables());
    store.read(number, [&](const StoredRow& row) {
      const auto at = row.values.begin() + first;
      member.points.push_back({at[-2], at[-1], row.status, {at, row.values.end()}});
    });
    for (std::uint64_t i = 0; i < asked_.points.speeds; ++i)
      member.envelope.push_back(corner_at(number, i));
    for (const DutyPoint& duty : asked_.duty) member.duty.push_back(duty_of(motor, duty));
    return member;
  }

  MapResult::Corner corner_at(std::size_t number, std::uint64_t i) const {
    const double speed = speed_of(i), torque = ends().largest_torque[number][i];
    MapResult::Corner corner{speed, torque, std::vector<double>(columns_.names().size(), kNoValue)};
    if (std::isnan(torque)) return corner;
    const Motor& motor = motors_[number].motor;
    const double inside = kInside * torque;
    corner.values =
        columns_.values(motor, inside, speed, held_point(motor.design(), inside, speed));
    return corner;
  }

  MapResult::Duty duty_of(const Motor& motor, const DutyPoint& duty) const {
    const HeldPoint held = held_point(motor.design(), duty.torque, duty.speed);
    return {point_of(motor, duty.torque, duty.speed, held),
            held.status == HeldStatus::ok ? kNoValue : held.needed,
            std::string(needed_unit(held.status)), largest_torque(motor, duty.speed) - duty.torque};
  }

  MapStudy asked_;
  std::vector<MappedMotor> motors_;
  MapColumns columns_;
  std::optional<StoredColumn> family_;
  mutable std::vector<MapPiece> pieces_;  // speed by speed, motor by motor
  mutable std::mutex mutex_;              // of what follows
  mutable std::optional<Ends> ends_;
};

}  // namespace

std::unique_ptr<StudyKindRun> MapStudy::run(const StudyFile& file) const {
  return std::make_unique<MapRun>(*this, file.motor.design);
}

}  // namespace twum::inline v0_1::studies
