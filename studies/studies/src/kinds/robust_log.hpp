// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/search_rows.hpp"

#include <twum/optim/robust.hpp>

namespace twum::studies {

/// A robust search with a memory, as SearchLog is of a plain one. A row has the design and its metrics, as those of a plain
/// search; its detail holds the round, the design with its reliability indices, and what the solver saw.
class RobustLog {
 public:
  /// Keeps references to both.
  /// @param chosen  numbers of the sets that the search holds, which follow the variables in a row
  /// @param search  which of the searches of the study it is: their rounds and stages are apart
  RobustLog(const DesignProblem& problem, std::vector<double> chosen, std::uint64_t search,
            RunContext& context);

  /// The options of a search with this memory.
  optim::RobustOptions options(const optim::SolveOptions& solve);

 private:
  // For RobustOptions::recall: answers from the store where it can.
  optim::Evaluation recall(std::uint64_t round, std::span<const double> y, bool gradient,
                           const optim::Evaluator& evaluate) const;
  // For RobustOptions::observer.
  void observe(std::uint64_t round, const optim::Observation& observation);
  static std::string key(std::uint64_t round, std::span<const double> y, bool gradient);

  RunContext& context_;
  std::size_t variables_;
  std::vector<double> chosen_;
  std::uint64_t search_;
  SearchRows rows_;
  MotorResponses motors_;
  std::unordered_map<std::string, optim::Evaluation> stored_;
  std::uint64_t done_;
};

}  // namespace twum::studies
