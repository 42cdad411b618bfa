// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/family.hpp"

#include <twum/io/engineering.hpp>
#include <twum/motors/frequency_points.hpp>

#include <algorithm>
#include <limits>
#include <mutex>
#include <tuple>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

constexpr double kNoFamily = std::numeric_limits<double>::quiet_NaN();

// One motor under one load.
struct SweptMotor {
  double value;  // of the family's parameter or load
  MotorDesign design;
  RotorLoad load;
};

// A slow sweep of one of them.
struct MemberSweep {
  double value;
  bool rising;
  std::vector<double> frequencies;
  FrequencySweep sweep;
};

bool over_loads(const FrequencyStudy& asked) { return asked.torque && asked.torque->size() > 1; }

RotorLoad load_of(const FrequencyStudy& asked) {
  if (asked.speed) return {Argument::speed, *asked.speed};
  return {Argument::torque, asked.torque ? asked.torque->front() : 0};
}

std::vector<SweptMotor> members_of(const FrequencyStudy& asked, const MotorDesign& base) {
  std::vector<SweptMotor> members;
  if (over_loads(asked))
    for (const double torque : *asked.torque)
      members.push_back({torque, base, {Argument::torque, torque}});
  if (!asked.family)
    return over_loads(asked) ? members : std::vector<SweptMotor>{{kNoFamily, base, load_of(asked)}};
  for (const double value : asked.family->values)
    members.push_back({value, family_motor(base, asked.family->parameter, value), load_of(asked)});
  return members;
}

// The range of the study; ends that are not given are set such that the range contains the response of every member.
std::pair<double, double> range_of(const FrequencyStudy& asked,
                                   const std::vector<SweptMotor>& members) {
  double from = std::numeric_limits<double>::infinity(), to = 0;
  for (const SweptMotor& each : members) {
    if (asked.from && asked.to) break;
    const FrequencyResponse whole(each.design, each.load);
    from = std::min(from, whole.from()), to = std::max(to, whole.to());
  }
  from = asked.from.value_or(from), to = asked.to.value_or(to);
  if (!(from < to))
    throw InputError("study: from = " + engineering(from, "Hz") +
                     " has to be below to = " + engineering(to, "Hz"));
  return {from, to};
}

// What is computed of one motor.
struct ComputedMember {
  FrequencyResult::Member result;
  std::vector<MemberSweep> sweeps;
};

// A stage for each sweep, a row for each frequency. The sweeps of a motor are computed together, when the first row of
// one of them is needed.
class FrequencyRun : public StudyKindRun {
 public:
  FrequencyRun(const FrequencyStudy& asked, const MotorDesign& base)
      : asked_(asked),
        motors_(members_of(asked, base)),
        family_(family_of(asked)),
        computed_(motors_.size()) {}

  std::vector<StoredColumn> columns() const override {
    std::vector<StoredColumn> columns;
    if (family_) columns.push_back(*family_);
    columns.push_back({"direction", "1"});
    for (const FrequencyColumn& column : frequency_columns())
      columns.push_back({column.name, column.unit});
    return columns;
  }

  std::size_t variables() const override { return family_ ? 3 : 2; }

  KindAnswer run(RunContext& context) override {
    FrequencyResult result = without_members();
    bool complete = true;
    for (std::size_t i = 0; complete && i < motors_.size(); ++i) {
      complete = begin(context, i * ways());
      if (!complete) break;
      result.members.push_back(member(i).result);
      for (std::size_t way = 0; complete && way < ways(); ++way) {
        const std::size_t stage = i * ways() + way;
        complete = store_rows(context, stage, asked_.points, asked_.points * stage, total());
      }
    }
    std::tie(result.from, result.to) = range();
    const bool any =
        std::any_of(result.members.begin(), result.members.end(),
                    [](const FrequencyResult::Member& m) { return !m.branches.empty(); });
    return {!complete ? StudyOutcome::interrupted
            : any     ? StudyOutcome::done
                      : StudyOutcome::failed,
            result};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage >= motors_.size() * ways() || asked.index >= asked_.points) return {};
    StoredRow row{asked.stage, asked.index, {}, "ok", {}};
    fill(row);
    return row;
  }

 private:
  static std::optional<StoredColumn> family_of(const FrequencyStudy& asked) {
    if (over_loads(asked)) return StoredColumn{"load_torque", "N.m"};
    if (!asked.family) return {};
    return family_column(asked.family->parameter);
  }

  // Sweeps of each motor.
  std::size_t ways() const { return asked_.direction == SweepDirection::both ? 2 : 1; }
  std::uint64_t total() const { return asked_.points * ways() * motors_.size(); }

  // Tells the progress before a stage. False if the run has to stop.
  bool begin(const RunContext& context, std::size_t stage) const {
    if (context.progress) context.progress({.done = asked_.points * stage, .total = total()});
    return !context.stop.stop_requested();
  }

  FrequencyResult without_members() const {
    FrequencyResult result;
    result.family = family_;
    result.load = load_of(asked_);
    if (over_loads(asked_)) result.load.value = kNoFamily;
    return result;
  }

  std::pair<double, double> range() const {
    const std::lock_guard guard(mutex_);
    if (!range_) range_ = range_of(asked_, motors_);
    return *range_;
  }

  const ComputedMember& member(std::size_t number) const {
    const auto ends = range();
    const std::lock_guard guard(mutex_);
    if (!computed_[number]) computed_[number] = computed(motors_[number], ends);
    return *computed_[number];
  }

  ComputedMember computed(const SweptMotor& each, std::pair<double, double> ends) const {
    const FrequencyResponse response(each.design, each.load, ends);
    ComputedMember member;
    member.result.value = each.value;
    member.result.frequency = drive_frequency(each.design);
    member.result.running = running_point(response, member.result.frequency);
    if (member.result.running)
      member.result.pull_out_below = response.pull_out_below(*member.result.running);
    member.result.branches = response.branches();
    for (const bool rising : {true, false}) {
      if (asked_.direction == (rising ? SweepDirection::down : SweepDirection::up)) continue;
      std::vector<double> frequencies = spaced_frequencies(ends.first, ends.second, asked_.points);
      if (!rising) std::reverse(frequencies.begin(), frequencies.end());
      FrequencySweep sweep = response.sweep(frequencies);
      for (const Jump& jump : sweep.jumps) member.result.jumps.push_back({rising, jump});
      member.sweeps.push_back({each.value, rising, std::move(frequencies), std::move(sweep)});
    }
    return member;
  }

  void fill(StoredRow& row) const {
    const MemberSweep& one = member(row.stage / ways()).sweeps[row.stage % ways()];
    const std::optional<ResponsePoint>& wave = one.sweep.points[row.index];
    row.values.clear();
    if (family_) row.values.push_back(one.value);
    row.values.push_back(one.rising ? 1 : -1);
    row.values.push_back(one.frequencies[row.index]);
    for (const FrequencyColumn& column : frequency_columns().subspan(1))
      row.values.push_back(wave ? column.value(*wave) : kNoFamily);
    row.status = to_string(wave ? MetricStatus::ok : MetricStatus::unstable_amplitude);
  }

  FrequencyStudy asked_;
  std::vector<SweptMotor> motors_;
  std::optional<StoredColumn> family_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::optional<std::pair<double, double>> range_;
  mutable std::vector<std::optional<ComputedMember>> computed_;
};

}  // namespace

std::unique_ptr<StudyKindRun> FrequencyStudy::run(const StudyFile& file) const {
  return std::make_unique<FrequencyRun>(*this, file.motor.design);
}

}  // namespace twum::inline v0_1::studies
