// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample_rows.hpp"

#include <twum/studies/motor/frequency_points.hpp>
#include <twum/studies/units/engineering.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace twum::studies {
namespace {

constexpr double kNoFamily = std::numeric_limits<double>::quiet_NaN();

// A slow sweep of one member.
struct MemberSweep {
  double value;  // of the family's parameter
  bool rising;
  std::vector<double> frequencies;
  FrequencySweep sweep;
};

std::vector<std::pair<double, MotorDesign>> members_of(const FrequencyStudy& asked,
                                                       const MotorDesign& base) {
  std::vector<std::pair<double, MotorDesign>> members;
  if (!asked.family) return {{kNoFamily, base}};
  const ParameterInfo& row = info(asked.family->parameter);
  for (const double value : asked.family->values) {
    try {
      members.emplace_back(value, with(base, asked.family->parameter, value));
    } catch (const InputError& error) {
      throw InputError("study.family: " + std::string(row.name) + " = " +
                       engineering(value, row.unit) + " makes no motor: " + error.what());
    }
  }
  return members;
}

RotorLoad load_of(const FrequencyStudy& asked) {
  if (asked.speed) return {Argument::speed, *asked.speed};
  return {Argument::torque, asked.torque.value_or(0)};
}

// The range asked for, open ends filled in so that they take in the response of every member.
std::pair<double, double> range_of(const FrequencyStudy& asked,
                                   const std::vector<std::pair<double, MotorDesign>>& members) {
  double from = std::numeric_limits<double>::infinity(), to = 0;
  for (const auto& [value, design] : members) {
    if (asked.from && asked.to) break;
    const FrequencyResponse whole(design, load_of(asked));
    from = std::min(from, whole.from()), to = std::max(to, whole.to());
  }
  from = asked.from.value_or(from), to = asked.to.value_or(to);
  if (!(from < to))
    throw InputError("study: from = " + engineering(from, "Hz") +
                     " has to be below to = " + engineering(to, "Hz"));
  return {from, to};
}

// A stage for each sweep, a row for each frequency. Sweeps are milliseconds: they are made beforehand.
class FrequencyRun : public StudyKindRun {
 public:
  FrequencyRun(const FrequencyStudy& asked, const MotorDesign& base) : points_(asked.points) {
    if (asked.family) family_ = asked.family->parameter;
    const auto members = members_of(asked, base);
    const auto [from, to] = range_of(asked, members);
    if (family_) result_.family = family_column();
    result_.load = load_of(asked);
    result_.from = from, result_.to = to;
    for (const auto& [value, design] : members) add_member(asked, value, design);
  }

  std::vector<Column> columns() const override {
    std::vector<Column> columns;
    if (family_) columns.push_back(family_column());
    columns.push_back({"direction", "1"});
    for (const FrequencyColumn& column : frequency_columns())
      columns.push_back({column.name, column.unit});
    return columns;
  }

  std::size_t variables() const override { return family_ ? 3 : 2; }

  KindAnswer run(RunContext& context) override {
    const std::uint64_t total = points_ * sweeps_.size();
    bool complete = true;
    for (std::size_t stage = 0; complete && stage < sweeps_.size(); ++stage)
      complete = store_rows(
          context, stage, points_, [&](std::uint64_t, Row& row) { fill(row); }, points_ * stage,
          total);
    const bool any =
        std::any_of(result_.members.begin(), result_.members.end(),
                    [](const FrequencyResult::Member& m) { return !m.branches.empty(); });
    return {!complete ? "interrupted" : any ? "done" : "failed", result_};
  }

  std::optional<Row> recompute(const Row& stored) const override {
    if (stored.stage >= sweeps_.size() || stored.index >= points_) return {};
    Row row{stored.stage, stored.index, {}, "ok", {}};
    fill(row);
    return row;
  }

 private:
  Column family_column() const {
    const ParameterInfo& row = info(*family_);
    return {std::string(row.name), std::string(row.unit)};
  }

  void add_member(const FrequencyStudy& asked, double value, const MotorDesign& design) {
    const FrequencyResponse response(design, load_of(asked), std::pair{result_.from, result_.to});
    FrequencyResult::Member member;
    member.value = value;
    member.frequency = drive_frequency(design);
    member.running = running_point(response, member.frequency);
    if (member.running) member.pull_out_below = response.pull_out_below(*member.running);
    member.branches = response.branches();
    for (const bool rising : {true, false}) {
      if (asked.direction == (rising ? SweepDirection::down : SweepDirection::up)) continue;
      std::vector<double> frequencies = spaced_frequencies(result_.from, result_.to, points_);
      if (!rising) std::reverse(frequencies.begin(), frequencies.end());
      FrequencySweep sweep = response.sweep(frequencies);
      for (const Jump& jump : sweep.jumps) member.jumps.push_back({rising, jump});
      sweeps_.push_back({value, rising, std::move(frequencies), std::move(sweep)});
    }
    result_.members.push_back(std::move(member));
  }

  void fill(Row& row) const {
    const MemberSweep& one = sweeps_[row.stage];
    const std::optional<ResponsePoint>& wave = one.sweep.points[row.index];
    row.values.clear();
    if (family_) row.values.push_back(one.value);
    row.values.push_back(one.rising ? 1 : -1);
    row.values.push_back(one.frequencies[row.index]);
    for (const FrequencyColumn& column : frequency_columns().subspan(1))
      row.values.push_back(wave ? column.value(*wave) : kNoFamily);
    row.status = to_string(wave ? MetricStatus::ok : MetricStatus::unstable_amplitude);
  }

  std::optional<Parameter> family_;
  std::uint64_t points_;
  std::vector<MemberSweep> sweeps_;
  FrequencyResult result_;
};

}  // namespace

std::unique_ptr<StudyKindRun> FrequencyStudy::run(const StudyFile& file) const {
  return std::make_unique<FrequencyRun>(*this, file.motor.design);
}

}  // namespace twum::studies
