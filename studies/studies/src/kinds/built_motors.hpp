// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/executor.hpp"

#include <twum/studies/problem/robust_question.hpp>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace twum::studies {

/// The stage of rows that ask for the responses of a built motor. They are computed, but never stored.
inline constexpr std::uint64_t kBuiltStage = ~std::uint64_t{0};

/// robust_problem(), the responses of its built motors computed by the executor.
/// @param name  what BuiltMotorRows knows the question by
optim::RobustProblem shared_robust_problem(const RobustQuestion& question, std::vector<double> name,
                                           Executor& executor);

/// The answers to the rows that such a problem asks for. Safe from any number of threads.
class BuiltMotorRows {
 public:
  /// @param question  makes the question of a name
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
