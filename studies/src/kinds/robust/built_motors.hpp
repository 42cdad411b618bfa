// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/executor.hpp"

#include <twum/studies/robust_question.hpp>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace twum::studies {

/// The stage of rows that request the responses of a built motor. They are computed but not stored.
inline constexpr std::uint64_t kBuiltStage = ~std::uint64_t{0};

/// robust_problem() whose built motors are computed by the executor.
/// @param name  identifies the question for BuiltMotorRows
optim::RobustProblem shared_robust_problem(const RobustQuestion& question, std::vector<double> name,
                                           Executor& executor);

/// Computes the rows that such a problem requests. Thread-safe.
class BuiltMotorRows {
 public:
  /// @param question  makes the question for a name
  explicit BuiltMotorRows(std::function<RobustQuestion(const std::vector<double>&)> question)
      : question_(std::move(question)) {}

  StoredRow answer(const StoredRow& asked) const;

 private:
  using Problem = std::shared_ptr<const optim::RobustProblem>;
  Problem problem(const std::vector<double>& name) const;

  std::function<RobustQuestion(const std::vector<double>&)> question_;
  mutable std::mutex mutex_;  // guards what follows
  mutable std::map<std::vector<double>, Problem> problems_;
};

}  // namespace twum::studies
