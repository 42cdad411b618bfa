// SPDX-License-Identifier: Apache-2.0
#include "kinds/sensitivity/sensitivity_study.hpp"

#include "entries/tolerance_shape.hpp"

#include <algorithm>
#include <utility>

namespace twum::inline v0_1::studies {

SensitivityRun::SensitivityRun(const SensitivityStudy& asked, const MotorDesign& motor)
    : base_(motor),
      box_(asked.tolerances.empty() ? UnitBox(asked.variables) : UnitBox(asked.tolerances, motor)),
      varied_(base_, box_.parameters(), asked.derived),
      metrics_(with_derived(asked.metrics, asked.derived)),
      evaluator_(varied_, metrics_),
      confidence_(asked.confidence),
      notes_(shapes::tolerance_notes(asked.tolerances, motor)) {}

SensitivityResult SensitivityRun::frame(SensitivityMethod method) const {
  SensitivityResult result;
  result.method = method;
  result.confidence = confidence_;
  result.tolerances = box_.of_tolerances();
  const std::vector<StoredColumn> all = columns();
  const auto metrics = all.begin() + static_cast<std::ptrdiff_t>(variables());
  result.variables.assign(all.begin(), metrics);
  for (auto column = metrics; column != all.end(); ++column) {
    result.metrics.emplace_back();
    result.metrics.back().metric = *column;
  }
  return result;
}

bool SensitivityRun::refused(MetricSensitivity& metric, const char* sample) {
  // Dropped samples usually lie in one corner of the box, so the rest is no longer a sample of the box. A tenth of
  // them changes the shares of variance by about the width of usual intervals.
  constexpr double kMostDropped = 0.1;
  const auto dropped = static_cast<double>(metric.dropped);
  const auto all = static_cast<double>(metric.samples + metric.dropped);
  if (metric.samples > 0 && dropped <= kMostDropped * all) return false;
  if (all == 0) {
    metric.note = "nothing evaluated yet";
    return true;
  }
  metric.note = std::to_string(metric.dropped) + " of " +
                std::to_string(metric.samples + metric.dropped) + " " + sample +
                " have a motor without a value, so there are no indices; try smaller ranges";
  return true;
}

std::string SensitivityRun::outcome(const SensitivityResult& result, bool complete) {
  if (!complete) return "interrupted";
  const bool any = std::any_of(result.metrics.begin(), result.metrics.end(),
                               [](const MetricSensitivity& metric) { return metric.samples > 0; });
  return any ? "done" : "failed";
}

std::unique_ptr<StudyKindRun> SensitivityStudy::run(const StudyFile& file) const {
  const MotorDesign& motor = file.motor.design;
  switch (method) {
    case SensitivityMethod::local: return make_local_sensitivity(*this, motor);
    case SensitivityMethod::morris: return make_morris_sensitivity(*this, motor);
    case SensitivityMethod::sobol: break;
  }
  return make_sobol_sensitivity(*this, motor);
}

}  // namespace twum::inline v0_1::studies
