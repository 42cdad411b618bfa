// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/executor.hpp"
#include "kinds/sample/measured_parts.hpp"

#include <twum/studies/robust_question.hpp>

#include <twum/base/error.hpp>

#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace twum::inline v0_1::studies {

/// How the built motors of a search scatter, and the limits on their statistics; empty if every motor equals the design.
struct BuiltMotorsAsked {
  std::vector<Tolerance> tolerances{};
  std::vector<StatisticLimit> statistics{};
  std::vector<ToleranceCorrelation> correlations{};
  PartsTable table{};

  bool scatter() const { return !tolerances.empty() || !table.parts.rows.empty(); }
  /// The question about the motors built to a design.
  RobustQuestion question(DesignProblem design) const {
    return {std::move(design), tolerances, statistics, correlations, table.parts};
  }
};

/// @throws InputError for a table of parts that cannot be read, or that has a column for what the search changes
template <typename S>
BuiltMotorsAsked built_motors_asked(const S& asked, const StudyFile& file) {
  BuiltMotorsAsked built{asked.tolerances, asked.statistics, asked.correlations,
                         read_parts(asked.parts, file.folder, file.motor.design)};
  const auto apart = [&](const auto& list, const char* entry) {
    for (const auto& one : list) check_apart(built.table, one.parameter, entry);
  };
  for (const Parameter parameter : built.table.parts.parameters)
    if (info(parameter).integer)
      throw InputError(
          "study.parts: the column " + std::string(info(parameter).name) +
          " holds whole numbers, which cannot scatter in a search; leave it out, or use "
          "an uncertainty study");
  apart(asked.variables, "variables");
  apart(asked.tolerances, "tolerances");
  apart(asked.derived, "derived");
  for (const DesignChoice& choice : asked.choose)
    for (const ParameterSet& set : choice.sets)
      for (const auto& [parameter, value] : set.values)
        check_apart(built.table, parameter, "choose." + choice.name);
  return built;
}

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

}  // namespace twum::inline v0_1::studies
