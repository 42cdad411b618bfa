// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/result_store.hpp>
#include <twum/optim/certificate.hpp>
#include <twum/studies/run_progress.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

class Executor;

/// Environment of a running study.
struct RunContext {
  ResultStore& store;
  Executor& executor;  ///< computes the rows
  /// on a request, finish the current evaluations and return the results so far
  std::stop_token stop;
  std::function<void(const RunProgress&)> progress;  ///< may be called from any thread, cheap
};

/// Cost of an evaluation, and the number that the budget allows.
struct Pace {
  double seconds;             ///< measured time of one evaluation with derivatives [s]
  std::uint64_t evaluations;  ///< at most
};

/// Answer of a study kind.
struct KindAnswer {
  OutcomeWord outcome;
  Answer answer;
};

/// One kind of study, made from a validated study file. Stores every evaluation as a row of columns(). On a store
/// that already holds rows, it continues from there and gives the same answer.
class StudyKindRun {
 public:
  virtual ~StudyKindRun() = default;
  StudyKindRun(const StudyKindRun&) = delete;
  StudyKindRun& operator=(const StudyKindRun&) = delete;

  /// The columns of its rows: first the variables, then what is computed.
  virtual std::vector<StoredColumn> columns() const = 0;
  /// How many of the columns are variables.
  virtual std::size_t variables() const = 0;
  virtual std::uint64_t seed() const { return 0; }
  /// The motor that is varied, if it is not that of the file.
  virtual std::optional<MotorDesign> own_motor() const { return {}; }
  /// How long the study may take; nothing if the number of evaluations is known beforehand.
  virtual std::optional<Pace> pace() const { return {}; }
  /// Reasons to doubt the answer, one sentence each without a full stop.
  virtual std::vector<std::string> notes() const { return {}; }
  /// Notes to show only before the run, likewise.
  virtual std::vector<std::string> notes_before() const { return {}; }
  /// Path of the entry that may be larger in a study than in the one of its stored rows, which then are its first; empty: none.
  virtual std::string_view grows_by() const { return {}; }
  /// @throws StoreError
  virtual KindAnswer run(RunContext& context) = 0;

  /// Computes one row, with values, status and detail, from the study and the row's variables (the first variables()
  /// of its values) only. run() gets its rows from here, on any thread or in another process (Executor), and `twum
  /// verify` compares them with the stored ones. If stage and index determine the variables (sweep, samples), those
  /// of the row are ignored. Columns without a value are NaN. Nothing if the row cannot be computed without other
  /// rows. Thread-safe; never throws for a design.
  virtual std::optional<StoredRow> recompute(const StoredRow& asked) const;
  /// The certificate of a design (its variables in their order, SI) as a solution of this study, for `twum verify`:
  /// feasibility and stationarity computed again. Nothing if this kind has no optimum.
  /// @param design  all values in the report of the design, including the variables
  virtual std::optional<optim::Certificate> certify(std::span<const double> variables,
                                                    std::span<const ParameterValue> design) const;

 protected:
  StudyKindRun() = default;
};

inline std::optional<StoredRow> StudyKindRun::recompute(const StoredRow& /*asked*/) const {
  return {};
}
inline std::optional<optim::Certificate> StudyKindRun::certify(
    std::span<const double> /*variables*/, std::span<const ParameterValue> /*design*/) const {
  return {};
}

/// The runner for a study file. It reads the files that the study names.
/// @throws FileError or InputError for errors in these files
std::unique_ptr<StudyKindRun> make_kind(const StudyFile& file);

}  // namespace twum::inline v0_1::studies
