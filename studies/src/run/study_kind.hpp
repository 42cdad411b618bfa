// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/study_result.hpp>
#include <twum/studies/store/result_store.hpp>
#include <twum/studies/study/study_file.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace twum::studies {

/// How far a study is, for the terminal.
struct RunProgress {
  std::uint64_t done{0};   ///< evaluations
  std::uint64_t total{0};  ///< 0: not known beforehand
  std::string best;        ///< "peak_power 4.31 W"; empty if there is no best
};

/// What a kind works with.
struct RunContext {
  ResultStore& store;
  unsigned jobs{1};
  std::stop_token stop;  ///< a request: finish what is in flight, and return with what there is
  std::function<void(const RunProgress&)> progress;  ///< may be called from any thread, cheap
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
  virtual std::vector<Column> columns() const = 0;
  /// How many of the columns are variables.
  virtual std::size_t variables() const = 0;
  virtual std::uint64_t seed() const { return 0; }
  /// @throws StoreError
  virtual KindAnswer run(RunContext& context) = 0;

 protected:
  StudyKindRun() = default;
};

/// One maker for each kind. They read the study's entries and the files these name.
/// @throws FileError or InputError for what only a look at such a file shows
std::unique_ptr<StudyKindRun> make_curve(const StudyFile& file);
std::unique_ptr<StudyKindRun> make_sweep(const StudyFile& file);
std::unique_ptr<StudyKindRun> make_sensitivity(const StudyFile& file);
std::unique_ptr<StudyKindRun> make_optimize(const StudyFile& file);
std::unique_ptr<StudyKindRun> make_pareto(const StudyFile& file);
std::unique_ptr<StudyKindRun> make_size(const StudyFile& file);
std::unique_ptr<StudyKindRun> make_uncertainty(const StudyFile& file);
std::unique_ptr<StudyKindRun> make_calibrate(const StudyFile& file);

}  // namespace twum::studies
