// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/search_rows.hpp"

#include <twum/optim/robust.hpp>

namespace twum::inline v0_1::studies {

/// Stores the evaluations of a robust search and answers from them, as SearchLog does for a plain search. A row has
/// the design and its metrics, as in a plain search. Its detail holds the round, the design with its reliability
/// indices, and the evaluation for the solver.
class RobustLog {
 public:
  /// Keeps references to both.
  /// @param chosen  numbers of the fixed sets, which follow the variables in a row
  /// @param search  index of this search in the study; searches have separate rounds and stages
  RobustLog(const DesignProblem& problem, std::vector<double> chosen, std::uint64_t search,
            RunContext& context);

  /// The options of a search with this log.
  optim::RobustOptions options(const optim::SolveOptions& solve);

 private:
  // For RobustOptions::recall: answers from the store where it can.
  optim::Evaluation recall(std::uint64_t round, std::span<const double> y, bool gradient,
                           const optim::Evaluator& evaluate) const;
  // For RobustOptions::observer.
  void observe(std::uint64_t round, const optim::Observation& observation);
  void report_progress(std::uint64_t round);
  std::uint64_t motors() const { return done_ + products_ + sample_; }
  static std::string key(std::uint64_t round, std::span<const double> y, bool gradient);

  RunContext& context_;
  std::size_t variables_;
  std::vector<double> chosen_;
  std::uint64_t search_;
  SearchRows rows_;
  MotorResponses motors_;
  std::unordered_map<std::string, optim::Evaluation> stored_;
  std::uint64_t done_;         // evaluations of a search
  std::uint64_t products_{0};  // motors of samples before the present one
  std::uint64_t sample_{0};    // of the present one
  std::uint64_t budget_{0};    // of a round
  std::uint64_t round_{0};     // the present one
  std::uint64_t in_round_{0};  // its evaluations
};

/// The progress while a sample is drawn.
/// @param done  motors of the study so far
/// @param made  of these, in the sample
/// @param most  motors that the sample may have
RunProgress progress_of_sample(std::uint64_t done, std::uint64_t made, std::uint64_t most);

}  // namespace twum::inline v0_1::studies
