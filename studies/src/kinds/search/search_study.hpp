// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/design_report.hpp"
#include "kinds/rows/search_rows.hpp"
#include "kinds/rows/study_kind.hpp"

#include <twum/optim/options.hpp>

#include <map>
#include <mutex>
#include <optional>
#include <vector>

namespace twum::inline v0_1::studies {

/// Base of optimize, size and pareto: a question about a motor, a solver, a start.
class SearchRun : public StudyKindRun {
 public:
  std::vector<StoredColumn> columns() const override { return SearchRows(problem_).columns(); }
  std::size_t variables() const override {
    return problem_.variables.size() + problem_.choices.size();
  }
  std::uint64_t seed() const override { return options_.seed; }
  std::optional<Pace> pace() const override;
  std::optional<MotorDesign> own_motor() const override { return started_; }
  std::vector<std::string> notes() const override;
  std::vector<std::string> notes_before() const override;
  std::optional<StoredRow> recompute(const StoredRow& asked) const override;
  std::optional<optim::Certificate> certify(std::span<const double> variables,
                                            std::span<const ParameterValue> design) const override;

 protected:
  /// @param asked  the question without the motor, which is that of the file
  /// @param start  result directory to start from, as typed; empty: none
  SearchRun(const StudyFile& file, DesignProblem asked, optim::SolveOptions options,
            const std::string& start);

  /// The options with the entries that the run sets.
  optim::SolveOptions options(SearchLog& log, const RunContext& context) const;
  /// The same for a search that reports its evaluations itself.
  optim::SolveOptions options(const RunContext& context) const;
  /// A design's certificate with these goals and limits and the study's options; integer variables are fixed.
  optim::Certificate certificate(const DesignProblem& asked, std::span<const double> design) const;
  DesignReporter reporter() const { return {problem_, extra_parameters_}; }
  /// @name Number of slices of a motor whose file says `auto`, in a search that does not vary it. A number that
  ///         changes with the design would make steps that the certificate detects, so a search uses one number.
  /// @{
  bool counts_slices() const { return counts_slices_; }
  /// As Motor::radial_slices().
  int slices() const { return problem_.motor.stator.radial_slices; }
  /// The slices that the search begins with.
  void begin_with_slices(int slices);
  /// Sets the slices of all evaluations from now on.
  void use_slices(int slices);
  /// The slices of the evaluations of a stage.
  int slices_of(std::uint64_t stage) const;
  /// Nodes a panel that `auto` chooses for a design.
  int nodes_needed(std::span<const double> design) const;
  /// @}
  const DesignProblem& problem() const { return problem_; }
  const MotorDesign& before() const { return before_; }
  /// That of the search, unless it was asked to stop.
  static StudyOutcome outcome(optim::Outcome outcome, const RunContext& context);

 private:
  // Made at the first use, because it throws for a question that has no meaning.
  struct Answers {
    SearchRows rows;
    MotorResponses motors;
  };
  const Answers& answers(std::uint64_t stage) const;

  bool leaves_slices() const;
  DesignProblem asked_with(int slices) const;
  void start_from(const std::string& folder);
  bool is_chosen(Parameter parameter) const;

  DesignProblem problem_;
  MotorDesign before_;  // the motor of the file or of `start:`, its slices those of the search
  std::optional<MotorDesign> started_;  // the motor of `start:`
  std::string limits_entry_;            // entry with the limits in a study of this kind
  // parameters that are not variables: changed by the start, or the number of slices
  std::vector<Parameter> extra_parameters_;
  bool counts_slices_;
  int first_slices_;
  optim::SolveOptions options_;
  mutable std::mutex answers_mutex_;
  mutable std::map<int, Answers> answers_;  // by SearchStage::nodes
};

}  // namespace twum::inline v0_1::studies
