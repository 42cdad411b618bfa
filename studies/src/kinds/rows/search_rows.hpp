// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/search_stage.hpp"
#include "kinds/rows/study_kind.hpp"
#include "problem/combinations.hpp"
#include "problem/motor_responses.hpp"

#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace twum::inline v0_1::studies {

/// An evaluation for a solver (responses, Jacobian, kinks) and whether derivatives were requested, as the detail of a
/// row.
std::string evaluation_bytes(const optim::Evaluation& evaluation, std::size_t variables,
                             bool gradient);
/// The evaluation in a row.
optim::Evaluation evaluation_of(const StoredRow& row);

/// Storage format of a search's evaluations. Each is one row with its variables, the numbers of its sets, and every
/// distinct metric of the question. A metric at a load that the motor cannot carry has no value. Such a row is not a
/// failure: the design is infeasible. The detail is evaluation_bytes().
class SearchRows {
 public:
  explicit SearchRows(const DesignProblem& problem);

  const std::vector<StoredColumn>& columns() const noexcept { return columns_; }
  StoredRow row(std::uint64_t stage, std::uint64_t index, std::span<const double> design,
                bool gradient, const optim::Evaluation& evaluation) const;
  /// The row that asks for an evaluation: StudyKindRun::recompute() answers it.
  static StoredRow question(std::span<const double> design, bool gradient, int nodes = 0);
  /// Whether a row answered, or asks for, derivatives as well: see key().
  bool asked_gradient(const StoredRow& row) const;

  /// Identifies a request to the evaluator: the bits of the design, and whether derivatives were requested.
  static std::string key(std::span<const double> design, bool gradient);

 private:
  void append_derived(std::span<const double> design, StoredRow& row) const;

  struct MetricColumn {
    /// An implied limit beyond which the metric has no value.
    struct End {
      std::size_t response;
      double least;
    };
    std::size_t response;
    std::vector<End> ends;
  };

  // One combination of the choices.
  struct Combination {
    DesignProblem problem;
    VariedParameters varied;
  };

  std::size_t variables_;  // choices among them
  DesignProblem problem_;
  std::vector<Combination> combinations_;  // for derived parameters
  std::vector<StoredColumn> columns_;
  std::vector<MetricColumn> metrics_;
};

/// Stores every evaluation of a search as a row, and answers from the stored rows. A search depends on its question
/// only, so a repeated search takes the same path through the stored rows and continues after them.
class SearchLog {
 public:
  /// Keeps references to both.
  /// @param nodes  as SearchStage::nodes
  SearchLog(const DesignProblem& problem, RunContext& context, int nodes = 0);

  /// motor_problem(), answering from the store where it can.
  const optim::Problem& problem() const noexcept { return answering_; }
  /// @param budget  evaluations that the search may take
  optim::Observer observer(std::uint64_t budget);

  /// The best feasible design of each solver run, the best first, without those near a better one; for a search with
  /// one goal.
  std::vector<std::vector<double>> valleys() const;

 private:
  struct RunsBest {
    double value;
    std::vector<double> design;
  };
  void note_run(const optim::Observation& observation);
  bool near(std::span<const double> a, std::span<const double> b) const;
  void observe(const optim::Observation& observation);
  void note_best(const optim::Observation& observation);
  bool feasible(const optim::Evaluation& evaluation) const;

  const DesignProblem& question_;
  RunContext& context_;
  SearchRows rows_;
  optim::Problem answering_;
  std::unordered_map<std::string, optim::Evaluation> stored_;
  std::map<std::uint64_t, RunsBest> runs_;  // by stage
  std::set<std::uint64_t> seen_;            // stages
  std::uint64_t budget_{0};
  std::uint64_t done_{0};
  double best_;
  std::string best_text_;
};

}  // namespace twum::inline v0_1::studies
