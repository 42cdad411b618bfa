// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/sample_rows.hpp"
#include "kinds/sample/family.hpp"

#include <twum/base/no_value.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/motors/expression.hpp>

#include <utility>

namespace twum::inline v0_1::studies {
namespace {

// One motor of the family.
struct CurveMember {
  double value;  // of the family's parameter, NaN for the motor alone
  Motor motor;
  double last_speed;  // of its curve [rad/s]
};

// Torque-speed curves: a stage for each member, a row for each speed.
class CurveRun : public StudyKindRun {
 public:
  CurveRun(const CurveStudy& asked, const MotorDesign& motor) : points_(asked.points) {
    if (!asked.family) {
      add_member(kNoValue, Motor(motor));
      return;
    }
    family_ = asked.family->parameter;
    for (const double value : asked.family->values)
      add_member(value, Motor(family_motor(motor, *family_, value)));
    // In a family over voltage or amplitude, the value already has a column.
    std::erase_if(columns_,
                  [&](const CurveColumn& one) { return one.name == info(*family_).name; });
  }

  std::vector<StoredColumn> columns() const override {
    std::vector<StoredColumn> columns;
    if (family_) columns.push_back(family_column(*family_));
    for (const CurveColumn& column : columns_) columns.push_back({column.name, column.unit});
    return columns;
  }

  std::size_t variables() const override { return family_ ? 2 : 1; }

  KindAnswer run(RunContext& context) override {
    const std::uint64_t total = points_ * members_.size();
    bool complete = true;
    std::uint64_t before = 0;
    for (std::size_t stage = 0; complete && stage < members_.size(); ++stage) {
      complete = store_rows(context, stage, points_, before, total);
      before += points_;
    }
    return answer(context.store, complete);
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage >= members_.size()) return {};
    if (asked.index >= points_) return {};
    StoredRow row{asked.stage, asked.index, {}, "ok", {}};
    fill(row);
    return row;
  }

 private:
  // Uses the columns of the member that has the most.
  void add_member(double value, Motor motor) {
    std::vector<CurveColumn> columns = curve_columns(motor.design());
    if (columns.size() > columns_.size()) columns_ = std::move(columns);
    const double last_speed = last_curve_speed(motor);
    members_.push_back({value, std::move(motor), last_speed});
  }

  void fill(StoredRow& row) const {
    const CurveMember& member = members_[row.stage];
    const OperatingPoint point =
        member.motor.operating_point(curve_speed(member.last_speed, row.index, points_));
    row.values.clear();
    if (family_) row.values.push_back(member.value);
    for (const CurveColumn& column : columns_) row.values.push_back(column.value(point));
    row.status = to_string(point.status);
  }

  KindAnswer answer(const ResultStore& store, bool complete) const {
    CurveResult result;
    if (family_) result.family = family_column(*family_);
    bool any = false;
    for (std::size_t stage = 0; stage < members_.size(); ++stage) {
      result.members.push_back(member_answer(store, stage));
      any = any || result.members.back().failed < result.members.back().points;
    }
    return {!complete ? StudyOutcome::interrupted
            : any     ? StudyOutcome::done
                      : StudyOutcome::failed,
            std::move(result)};
  }

  CurveResult::Member member_answer(const ResultStore& store, std::size_t stage) const {
    const CurveMember& member = members_[stage];
    CurveResult::Member answer;
    answer.value = member.value;
    answer.last_speed = curve_speed(member.last_speed, points_ - 1, points_);
    store.read(stage, [&](const StoredRow& row) {
      ++answer.points;
      answer.failed += row.status == "ok" ? 0 : 1;
    });
    const std::vector<MetricExpression> metrics = plain_metrics(member.motor.design());
    std::vector<MetricValue> values(metrics.size());
    ExpressionEvaluator(metrics).evaluate(member.motor, values);
    for (std::size_t i = 0; i < metrics.size(); ++i) {
      answer.metrics.push_back({metrics[i].text, std::string(metrics[i].unit()),
                                values[i].status == MetricStatus::ok ? values[i].value : kNoValue});
      answer.statuses.emplace_back(to_string(values[i].status));
    }
    return answer;
  }

  std::optional<Parameter> family_;
  std::uint64_t points_;
  std::vector<CurveColumn> columns_;
  std::vector<CurveMember> members_;
};

}  // namespace

std::unique_ptr<StudyKindRun> CurveStudy::run(const StudyFile& file) const {
  return std::make_unique<CurveRun>(*this, file.motor.design);
}

}  // namespace twum::inline v0_1::studies
