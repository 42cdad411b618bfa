// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/certificate.hpp>
#include <twum/studies/results/run_progress.hpp>
#include <twum/studies/results/study_result.hpp>
#include <twum/studies/store/result_store.hpp>
#include <twum/studies/study/study_file.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace twum::studies {

class Executor;

/// What a kind works with.
struct RunContext {
  ResultStore& store;
  Executor& executor;    ///< who computes its rows
  std::stop_token stop;  ///< a request: finish what is in flight, and return with what there is
  std::function<void(const RunProgress&)> progress;  ///< may be called from any thread, cheap
};

/// What an evaluation costs, and how many the budget allows.
struct Pace {
  double seconds;             ///< of one evaluation with derivatives, measured [s]
  std::uint64_t evaluations;  ///< at most
};

/// What a kind answers.
struct KindAnswer {
  std::string outcome;  ///< as StudyResult::outcome
  Answer answer;
};

/// One kind of study, made from a validated study file. Stores every evaluation as a row of
/// columns(); on a store that already holds rows it goes on from there and ends with the same answer.
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
  /// How long the kind may go on; nothing where what it evaluates is known beforehand.
  virtual std::optional<Pace> pace() const { return {}; }
  /// What to know before one believes the answer, a sentence each without a full stop.
  virtual std::vector<std::string> notes() const { return {}; }
  /// What to know before it runs, likewise; afterwards the answer speaks for itself.
  virtual std::vector<std::string> notes_before() const { return {}; }
  /// @throws StoreError
  virtual KindAnswer run(RunContext& context) = 0;

  /// A row by itself: values, status and detail, computed from the study and from the row's variables (the first
  /// variables() of its values). run() has its rows from here, on any thread or in another process (Executor), and
  /// `twum verify` compares them with those stored. Where stage and index alone decide the variables (sweep, samples) those
  /// of the row are not looked at. Looks at no other row and not at the other values. Columns without a value are NaN.
  /// Nothing: this row cannot be computed by itself.
  /// Constant, safe from any number of threads; never throws for a design.
  virtual std::optional<StoredRow> recompute(const StoredRow& asked) const;
  /// The certificate of a design (its variables in their order, SI) as a solution of this study, for
  /// `twum verify`: feasibility and stationarity measured again. Nothing: this kind has no optimum.
  /// @param design  all that the report says of the design, the variables included
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

/// The runner of what a file asks. It reads the files that the study names.
/// @throws FileError or InputError for what only a look at such a file shows
std::unique_ptr<StudyKindRun> make_kind(const StudyFile& file);

}  // namespace twum::studies
