// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/sample_rows.hpp"
#include "kinds/sensitivity/unit_box.hpp"

#include <memory>

namespace twum::inline v0_1::studies {

/// Base of the methods of a sensitivity study: entries, rows, and the common part of the answer.
class SensitivityRun : public StudyKindRun {
 public:
  std::vector<StoredColumn> columns() const override { return evaluator_.columns(); }
  std::size_t variables() const override { return box_.size(); }
  std::vector<std::string> notes() const override { return notes_; }

 protected:
  SensitivityRun(const SensitivityStudy& asked, const MotorDesign& motor);

  /// The answer without numbers.
  SensitivityResult frame(SensitivityMethod method) const;
  /// If too many samples of a metric failed, sets its note and returns true.
  static bool refused(MetricSensitivity& metric, const char* sample);
  /// "failed" if no metric has an answer because values are missing.
  static std::string outcome(const SensitivityResult& result, bool complete);

  MotorDesign base_;
  UnitBox box_;
  VariedParameters varied_;
  std::vector<MetricExpression> metrics_;
  RowEvaluator evaluator_;
  double confidence_;
  std::vector<std::string> notes_;
};

std::unique_ptr<StudyKindRun> make_local_sensitivity(const SensitivityStudy& asked,
                                                     const MotorDesign& motor);
std::unique_ptr<StudyKindRun> make_morris_sensitivity(const SensitivityStudy& asked,
                                                      const MotorDesign& motor);
std::unique_ptr<StudyKindRun> make_sobol_sensitivity(const SensitivityStudy& asked,
                                                     const MotorDesign& motor);

}  // namespace twum::inline v0_1::studies
