// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/study_kind.hpp"

#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/expression.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace twum::inline v0_1::studies {

/// Computes and stores the missing rows of a stage of `count` rows, in order, on all lanes of the executor. Stage and
/// index determine a row. Memory does not grow with the rows. `offset` is added to the progress shown, out of
/// `total`.
/// @return true if the stage is complete, false if the run was asked to stop
bool store_rows(RunContext& context, std::uint64_t stage, std::uint64_t count,
                std::uint64_t offset = 0, std::uint64_t total = 0);

/// The same for rows of stage 0 whose variables `ask` gives.
bool store_rows(RunContext& context, std::uint64_t count,
                const std::function<StoredRow(std::uint64_t index)>& ask);

/// Metrics of a motor with some parameters replaced, as a row: variables first, then metrics; a design
/// or metric without an answer has NaN and a status such as "stall_torque: no-periodic-state".
/// Constant, safe from any number of threads.
class RowEvaluator {
 public:
  RowEvaluator(VariedParameters varied, std::vector<MetricExpression> metrics);
  /// Columns of the rows.
  std::vector<StoredColumn> columns() const;
  /// Sets row.values and row.status.
  void evaluate(std::span<const double> variables, StoredRow& row) const;

 private:
  VariedParameters varied_;
  std::vector<MetricExpression> metrics_;
  ExpressionEvaluator evaluator_;
};

}  // namespace twum::inline v0_1::studies
