// SPDX-License-Identifier: Apache-2.0
#include "kinds/sensitivity/metric_gradients.hpp"
#include "kinds/sensitivity/sensitivity_study.hpp"

#include <twum/base/error.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

// Exact derivatives at one motor: one row, whose detail holds the gradients and their smoothness.
class LocalSensitivity : public SensitivityRun {
 public:
  LocalSensitivity(const SensitivityStudy& asked, const MotorDesign& motor)
      : SensitivityRun(asked, motor), gradients_(metrics_, varied_) {
    for (const DesignVariable& range : box_.ranges())
      motor_.push_back(std::isnan(range.start) ? get(base_, range.parameter) : range.start);
  }

  std::optional<MotorDesign> own_motor() const override {
    try {
      return varied_.motor(motor_);
    } catch (const Error&) {  // the row says why there is no such motor
      return {};
    }
  }

  KindAnswer run(RunContext& context) override {
    const bool complete = store_rows(context, 0, 1);
    SensitivityResult result = frame(SensitivityMethod::local);
    result.motor = motor_;
    context.store.read(0, [&](const StoredRow& row) { answer(row, result); });
    for (MetricSensitivity& metric : result.metrics) {
      if (metric.samples + metric.dropped > 0) continue;
      metric.value = metric.sd = kNoValue;
      refused(metric, "motors");
    }
    std::string word = outcome(result, complete);
    return {std::move(word), std::move(result)};
  }

  std::optional<StoredRow> recompute(const StoredRow& asked) const override {
    if (asked.stage != 0 || asked.index != 0) return {};
    StoredRow row;
    fill(row);
    return row;
  }

 private:
  void fill(StoredRow& row) const {
    evaluator_.evaluate(motor_, row);
    std::vector<double> numbers;
    try {
      for (const auto& gradient : gradients_.at(motor_)) {
        numbers.push_back(static_cast<double>(gradient.smoothness));
        numbers.insert(numbers.end(), gradient.values.begin(), gradient.values.end());
      }
    } catch (const std::exception&) {
      return;  // the row's status says why there is no such motor
    }
    row.detail = packed(numbers);
  }

  void answer(const StoredRow& row, SensitivityResult& result) const {
    const std::vector<double> numbers = unpacked(row.detail);
    const std::size_t stride = variables() + 1;
    for (std::size_t i = 0; i < metrics_.size(); ++i) {
      MetricSensitivity& metric = result.metrics[i];
      metric.value = row.values[variables() + i];
      metric.sd = kNoValue;
      if (std::isnan(metric.value) || numbers.size() != stride * metrics_.size()) {
        metric.dropped = 1;
        metric.note = "no value at this motor (" + row.status + ")";
        continue;
      }
      metric.samples = 1;
      const double* part = &numbers[i * stride];
      metric.smoothness = static_cast<Smoothness>(static_cast<int>(part[0]));
      MetricSensitivity::Local effects;
      double variance = 0;  // to first order
      for (std::size_t j = 0; j < variables(); ++j) {
        const double slope = part[1 + j], spread = std::fabs(slope) * box_.sd(j);
        effects.push_back(
            {slope, metric.value == 0 ? kNoValue : slope * motor_[j] / metric.value, spread});
        variance += spread * spread;
      }
      metric.sd = std::sqrt(variance);
      metric.effects = std::move(effects);
    }
  }

  MetricGradients gradients_;
  std::vector<double> motor_;
};

}  // namespace

std::unique_ptr<StudyKindRun> make_local_sensitivity(const SensitivityStudy& asked,
                                                     const MotorDesign& motor) {
  return std::make_unique<LocalSensitivity>(asked, motor);
}

}  // namespace twum::inline v0_1::studies
