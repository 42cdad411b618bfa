// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/family.hpp"

#include <algorithm>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace twum::inline v0_1::studies {

/// A run with a stage for each motor of a family and a row for each of its points. All of a motor is computed when the first of its
/// rows is needed.
/// @tparam Result  has `family`, `members`, and a Member with `value`
template <typename Result>
class FamilyRun : public StudyKindRun {
 public:
  using Member = typename Result::Member;

  std::size_t variables() const final { return family_ ? 2 : 1; }

  std::vector<StoredColumn> columns() const final {
    std::vector<StoredColumn> columns = own_columns();
    if (family_) columns.insert(columns.begin(), *family_);
    return columns;
  }

  KindAnswer run(RunContext& context) final {
    stop_ = context.stop, progress_ = context.progress;
    Result result = frame();
    result.family = family_;
    bool complete = true;
    for (std::size_t i = 0; complete && i < motors_.size(); ++i) {
      if (context.stop.stop_requested()) return {StudyOutcome::interrupted, std::move(result)};
      result.members.push_back(member(i));
      complete = !asked_to_stop() &&
                 store_rows(context, i, points_, points_ * i, points_ * motors_.size());
    }
    const bool any =
        std::ranges::any_of(result.members, [&](const Member& one) { return has_answer(one); });
    return {!complete ? StudyOutcome::interrupted
            : any     ? StudyOutcome::done
                      : StudyOutcome::failed,
            std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const final {
    if (asked.stage >= motors_.size() || asked.index >= points_) return {};
    StoredRow row{asked.stage, asked.index, {}, "ok", {}};
    if (family_) row.values.push_back(motors_[row.stage].value);
    add_numbers(member(row.stage), row);
    return row;
  }

 protected:
  FamilyRun(const std::optional<CurveStudy::Family>& family, const MotorDesign& base,
            std::uint64_t points)
      : motors_(family_motors(family, base)), points_(points), computed_(motors_.size()) {
    if (family) family_ = family_column(family->parameter);
  }

  /// A long computation of one motor ends where this is true; the rows of the motor are then not stored.
  bool asked_to_stop() const { return stop_.stop_requested(); }

  /// Tells the share of a motor that takes long; to be called from computed().
  void tell(double share) const {
    const double done = static_cast<double>(points_) * (static_cast<double>(present_) + share);
    if (progress_)
      progress_({.done = static_cast<std::uint64_t>(done), .total = points_ * motors_.size()});
  }

  const std::vector<FamilyMotor>& motors() const { return motors_; }
  std::uint64_t points() const { return points_; }

 private:
  /// Columns but for the family's, the one variable first.
  virtual std::vector<StoredColumn> own_columns() const = 0;
  /// The answer without its motors.
  virtual Result frame() const = 0;
  virtual Member computed(const FamilyMotor& motor) const = 0;
  /// Numbers of own_columns() and the status of a point.
  virtual void add_numbers(const Member& member, StoredRow& row) const = 0;
  virtual bool has_answer(const Member& member) const = 0;

  const Member& member(std::size_t number) const {
    const std::lock_guard guard(mutex_);
    if (!computed_[number]) {
      present_ = number;
      computed_[number] = computed(motors_[number]);
      computed_[number]->value = motors_[number].value;
    }
    return *computed_[number];
  }

  std::vector<FamilyMotor> motors_;
  std::uint64_t points_;
  std::optional<StoredColumn> family_;
  std::stop_token stop_;
  std::function<void(const RunProgress&)> progress_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::size_t present_{0};
  mutable std::vector<std::optional<Member>> computed_;
};

}  // namespace twum::inline v0_1::studies
