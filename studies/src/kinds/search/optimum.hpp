// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/robust/built_motors.hpp"
#include "kinds/search/search_study.hpp"

#include <twum/studies/robust_question.hpp>

namespace twum::inline v0_1::studies {

/// A search for one best design, shared by optimize and size.
class OptimumRun : public SearchRun {
 public:
  KindAnswer run(RunContext& context) override;
  std::vector<std::string> notes() const override;
  std::optional<StoredRow> recompute(const StoredRow& asked) const override;
  /// Under tolerances the certificate is that of the last round, which follows from the rows before it.
  std::optional<optim::Certificate> certify(std::span<const double> variables,
                                            std::span<const ParameterValue> design) const override;

 protected:
  OptimumRun(const StudyFile& file, DesignProblem asked, BuiltMotorsAsked built,
             optim::SolveOptions options, const std::string& start);

 private:
  optim::Result refined(optim::Result found, RunContext& context);
  OptimizeResult answer(const optim::Result& found) const;
  DesignProblem held(std::span<const double> design) const;
  RobustQuestion question_of(std::span<const double> design) const;
  RobustQuestion robust_question(const BuiltQuestion& of) const;
  std::vector<std::vector<double>> combinations_at(const std::vector<double>& design) const;

  // goal of the study; that of problem() is the goal of the search without tolerances
  DesignObjective goal_;
  BuiltMotorsAsked built_;
  BuiltMotorRows motors_;
};

}  // namespace twum::inline v0_1::studies
