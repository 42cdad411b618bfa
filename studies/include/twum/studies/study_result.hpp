// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/column.hpp>
#include <twum/io/result_store.hpp>
#include <twum/motors/expression.hpp>
#include <twum/studies/sample_results.hpp>
#include <twum/studies/search_results.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_outcome.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace twum::inline v0_1::studies {

/// The region of the variables in which evaluations failed for one reason.
struct FailureRegion {
  /// Values of one variable at the failures.
  struct Range {
    StoredColumn variable;  ///< which one
    double low;             ///< smallest value at a failure, SI
    double high;            ///< largest
  };
  std::string reason;        ///< short, as in `failures`
  std::uint64_t count{0};    ///< how many
  std::vector<Range> where;  ///< every variable of the study
};

/// Answer of a study, by kind.
using Answer = std::variant<CurveResult, SweepResult, SensitivityResult, OptimizeResult,
                            ParetoResult, UncertaintyResult, CalibrateResult, FrequencyResult,
                            MapResult, HeatResult, LifeResult, MotionResult>;

/// Result of a study. A size study has the answer of optimize.
struct StudyResult {
  std::string study;                 ///< name: that of the file without extension
  StudyKind kind{StudyKind::curve};  ///< what it asked
  std::string motor;                 ///< name of the motor
  /// the motor that was varied: that of the file, or the design of the earlier study that `start:` names
  MotorDesign design{};
  OutcomeWord outcome;                            ///< how it ended
  std::uint64_t evaluations{0};                   ///< rows of the store
  std::map<std::string, std::uint64_t> failures;  ///< count by reason
  std::vector<FailureRegion> failure_regions;     ///< one for each reason
  std::uint64_t seed{0};                          ///< seed of all random choices
  std::string started;  ///< date and time (UTC, ISO 8601) of the first run, if it was interrupted
  double seconds{0};    ///< time of all runs together [s]
  bool was_complete{false};  ///< the directory held this result already
  std::string hash;          ///< hash of the resolved study and of the files that it names
  Answer answer;             ///< answer, by kind
  /// Reasons to doubt the model for the motors of the answer, a sentence each; see model_notes().
  std::vector<std::string> model_notes;
  /// Motor files of the answer in the directory: best.yaml, front/01.yaml, fitted.yaml.
  std::vector<std::string> motor_files;
  /// The evaluations of a run in memory: rows->read(...) visits them in their order, in SI. Null for a run in a directory,
  /// which keeps them in results.csv and results.db. Copies of the result share them.
  std::shared_ptr<const ResultStore> rows;
  /// Metrics of the program that the study asked for; see own_metrics().
  OwnMetrics own_metrics{};
};

/// The text of summary.json: SI, flat names. Except for times, the same byte for byte for any number of threads and
/// interruptions.
std::string summary_json(const StudyResult& result);

/// The text of results.csv for a run in memory: one line for each evaluation, columns "name [unit]" in SI, the status last.
/// @throws InputError if the result has no rows
std::string results_csv(const StudyResult& result);

/// The summary for a terminal: engineering units and sentences, no colour.
/// @param said  notes that were shown before and are left out
std::string summary_text(const StudyResult& result, std::span<const std::string> said = {});

/// The same as Markdown, for a report: symbols and units as books print them.
std::string summary_markdown(const StudyResult& result);

}  // namespace twum::inline v0_1::studies
