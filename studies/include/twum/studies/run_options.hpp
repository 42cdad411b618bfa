// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/run_progress.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

class Processes;

/// Options of a run.
struct RunOptions {
  unsigned jobs{0};   ///< threads; 0: one for each processor. The result does not depend on it
  bool fresh{false};  ///< discard the stored results of this study in the directory and start again
  Processes* processes{nullptr};  ///< in the first of several processes: access to the others
  std::stop_token stop{};  ///< a request ends the run with the results so far; it can be resumed
  std::function<void(const RunProgress&)> progress{};  ///< called with the progress now and then
};

/// Reads the files that a valid study file names besides its motor, such as measured points and earlier results.
/// @return reasons to doubt the answer, one sentence each without a full stop
/// @throws FileError or InputError for errors in them
std::vector<std::string> study_notes(const StudyFile& file);

/// A sentence on how long a search may take, if its full budget needs more than a minute; costs one evaluation. Empty
/// for other kinds and for quick motors.
/// @throws InputError for a wrong input
std::string pace_note(const StudyFile& file);

/// Runs a study in memory, without a directory and without a file. The answer is the same; its `rows` hold the evaluations.
///
///     StudyResult curve = run_study({.motor = {"mine", design}, .asked = CurveStudy{}});
///     curve.rows->read([](const StoredRow& row) { use(row.values); });
/// @throws FileError or InputError for a wrong input, as validate()
StudyResult run_study(const StudyFile& file, const RunOptions& options = {});

}  // namespace twum::inline v0_1::studies
