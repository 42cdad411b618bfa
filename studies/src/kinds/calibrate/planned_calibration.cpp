// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibrate/planned_calibration.hpp"

#include "kinds/calibrate/calibration.hpp"
#include "kinds/calibrate/measurement_plan.hpp"

#include <twum/base/error.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

std::vector<MeasuredPoint> readings_of(const MotorDesign& motor) {
  std::vector<MeasuredPoint> readings = first_readings(motor);
  if (readings.empty())
    throw InputError(
        "no torque of the motor can be evaluated, so that no measurement can be planned; "
        "'twum curve' says why");
  return readings;
}

class PlanRun final : public StudyKindRun {
 public:
  PlanRun(const CalibrateStudy& asked, const MotorDesign& motor)
      : readings_(motor, {asked.variables.begin(), asked.variables.end()}, readings_of(motor),
                  asked.derived),
        seed_(asked.seed) {}

  std::vector<StoredColumn> columns() const override {
    std::vector<StoredColumn> columns;
    for (const DesignVariable& range : readings_.parameters()) {
      const ParameterInfo& row = info(range.parameter);
      columns.push_back({std::string(row.name), std::string(row.unit)});
    }
    return columns;
  }
  std::size_t variables() const override { return readings_.parameters().size(); }
  std::uint64_t seed() const override { return seed_; }

  KindAnswer run(RunContext& /*context*/) override {
    CalibrateResult result;
    result.unmeasured = true;
    result.unit = readings_.unit();
    std::vector<double> values;
    for (const optim::Variable& variable : readings_.variables({}))
      values.push_back(value_of(variable));
    for (std::size_t j = 0; j < values.size(); ++j)
      result.estimates.push_back(range_of(readings_.parameters()[j], values[j]));
    result.correlation.assign(values.size() * values.size(),
                              std::numeric_limits<double>::quiet_NaN());
    result.derived = readings_.derived(values);
    result.plan = first_plan(readings_, values);
    for (const MeasuredPoint& one : readings_.points())
      result.columns.push_back({std::string(name_of(one.reading)),
                                std::string(unit_of(one.reading)),
                                {},
                                0,
                                one.deviation});
    return {result.plan.empty() ? StudyOutcome::failed : StudyOutcome::done, std::move(result)};
  }

 private:
  // Where a fit would start.
  static double value_of(const optim::Variable& variable) {
    if (!std::isnan(variable.start)) return variable.start;
    return variable.scale == optim::Scale::log ? std::sqrt(variable.lower * variable.upper)
                                               : 0.5 * (variable.lower + variable.upper);
  }

  static CalibrateResult::Estimate range_of(const DesignVariable& range, double value) {
    const ParameterInfo& row = info(range.parameter);
    CalibrateResult::Estimate estimate;
    estimate.parameter = {std::string(row.name), std::string(row.unit), value};
    estimate.low = estimate.min = range.min;
    estimate.high = estimate.max = range.max;
    estimate.scale = range.scale;
    estimate.low_cut = estimate.high_cut = true;
    return estimate;
  }

  MeasuredFit readings_;
  std::uint64_t seed_;
};

}  // namespace

std::unique_ptr<StudyKindRun> planned_calibration(const CalibrateStudy& asked,
                                                  const MotorDesign& motor) {
  return std::make_unique<PlanRun>(asked, motor);
}

}  // namespace twum::inline v0_1::studies
