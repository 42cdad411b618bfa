// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/executor.hpp"

#include <twum/studies/robust_question.hpp>

#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace twum::studies {

/// Identifies a robust question of a study: the integers and sets of a design make it.
struct BuiltQuestion {
  std::vector<double> design{};
  bool motor_before{false};  ///< about the motor before the search instead
  auto operator<=>(const BuiltQuestion&) const = default;
};

/// True if a row asks for the responses of a built motor.
bool is_of_built_motor(const StoredRow& asked);

/// robust_problem() whose built motors are computed by the executor.
/// @param of  the question, as BuiltMotorRows knows it
optim::RobustProblem shared_robust_problem(const RobustQuestion& question, BuiltQuestion of,
                                           Executor& executor);

/// Computes the rows that such a problem requests. Thread-safe.
class BuiltMotorRows {
 public:
  /// @param question  makes the question
  explicit BuiltMotorRows(std::function<RobustQuestion(const BuiltQuestion&)> question)
      : question_(std::move(question)) {}

  StoredRow answer(const StoredRow& asked) const;

 private:
  using Problem = std::shared_ptr<const optim::RobustProblem>;
  Problem problem(const BuiltQuestion& of) const;

  std::function<RobustQuestion(const BuiltQuestion&)> question_;
  mutable std::mutex mutex_;  // guards what follows
  mutable std::map<BuiltQuestion, Problem> problems_;
};

}  // namespace twum::studies
