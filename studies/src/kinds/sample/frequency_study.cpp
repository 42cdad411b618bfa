// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/sample_rows.hpp"

#include <twum/io/engineering.hpp>
#include <twum/motors/frequency_points.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace twum::studies {
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
  const ParameterInfo& row = info(asked.family->parameter);
  for (const double value : asked.family->values) {
    try {
      members.push_back({value, with(base, asked.family->parameter, value), load_of(asked)});
    } catch (const InputError& error) {
      throw InputError("study.family: " + std::string(row.name) + " = " +
                       engineering(value, row.unit) + " gives an invalid motor: " + error.what());
    }
  }
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

// A stage for each sweep, a row for each frequency. Sweeps take milliseconds, so they are computed beforehand.
class FrequencyRun : public StudyKindRun {
 public:
  FrequencyRun(const FrequencyStudy& asked, const MotorDesign& base) : points_(asked.points) {
    const std::vector<SweptMotor> members = members_of(asked, base);
    const auto [from, to] = range_of(asked, members);
    result_.family = family_of(asked);
    result_.load = load_of(asked);
    if (over_loads(asked)) result_.load.value = kNoFamily;
    result_.from = from, result_.to = to;
    for (const SweptMotor& each : members) add_member(asked, each);
  }

  std::vector<StoredColumn> columns() const override {
    std::vector<StoredColumn> columns;
    if (result_.family) columns.push_back(*result_.family);
    columns.push_back({"direction", "1"});
    for (const FrequencyColumn& column : frequency_columns())
      columns.push_back({column.name, column.unit});
    return columns;
  }

  std::size_t variables() const override { return result_.family ? 3 : 2; }

  KindAnswer run(RunContext& context) override {
    const std::uint64_t total = points_ * sweeps_.size();
    bool complete = true;
    for (std::size_t stage = 0; complete && stage < sweeps_.size(); ++stage)
      complete = store_rows(context, stage, points_, points_ * stage, total);
    const bool any =
        std::any_of(result_.members.begin(), result_.members.end(),
                    [](const FrequencyResult::Member& m) { return !m.branches.empty(); });
    return {!complete ? "interrupted" : any ? "done" : "failed", result_};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage >= sweeps_.size() || asked.index >= points_) return {};
    StoredRow row{asked.stage, asked.index, {}, "ok", {}};
    fill(row);
    return row;
  }

 private:
  static std::optional<StoredColumn> family_of(const FrequencyStudy& asked) {
    if (over_loads(asked)) return StoredColumn{"load_torque", "N.m"};
    if (!asked.family) return {};
    const ParameterInfo& row = info(asked.family->parameter);
    return StoredColumn{std::string(row.name), std::string(row.unit)};
  }

  void add_member(const FrequencyStudy& asked, const SweptMotor& each) {
    const FrequencyResponse response(each.design, each.load, std::pair{result_.from, result_.to});
    FrequencyResult::Member member;
    member.value = each.value;
    member.frequency = drive_frequency(each.design);
    member.running = running_point(response, member.frequency);
    if (member.running) member.pull_out_below = response.pull_out_below(*member.running);
    member.branches = response.branches();
    for (const bool rising : {true, false}) {
      if (asked.direction == (rising ? SweepDirection::down : SweepDirection::up)) continue;
      std::vector<double> frequencies = spaced_frequencies(result_.from, result_.to, points_);
      if (!rising) std::reverse(frequencies.begin(), frequencies.end());
      FrequencySweep sweep = response.sweep(frequencies);
      for (const Jump& jump : sweep.jumps) member.jumps.push_back({rising, jump});
      sweeps_.push_back({each.value, rising, std::move(frequencies), std::move(sweep)});
    }
    result_.members.push_back(std::move(member));
  }

  void fill(StoredRow& row) const {
    const MemberSweep& one = sweeps_[row.stage];
    const std::optional<ResponsePoint>& wave = one.sweep.points[row.index];
    row.values.clear();
    if (result_.family) row.values.push_back(one.value);
    row.values.push_back(one.rising ? 1 : -1);
    row.values.push_back(one.frequencies[row.index]);
    for (const FrequencyColumn& column : frequency_columns().subspan(1))
      row.values.push_back(wave ? column.value(*wave) : kNoFamily);
    row.status = to_string(wave ? MetricStatus::ok : MetricStatus::unstable_amplitude);
  }

  std::uint64_t points_;
  std::vector<MemberSweep> sweeps_;
  FrequencyResult result_;
};

}  // namespace

std::unique_ptr<StudyKindRun> FrequencyStudy::run(const StudyFile& file) const {
  return std::make_unique<FrequencyRun>(*this, file.motor.design);
}

}  // namespace twum::studies
