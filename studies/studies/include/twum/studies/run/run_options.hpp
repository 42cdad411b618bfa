// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/run_progress.hpp>
#include <twum/studies/results/study_result.hpp>
#include <twum/studies/study/study_file.hpp>

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace twum::studies {

class Processes;

/// How to run a study.
struct RunOptions {
  unsigned jobs{0};   ///< threads; 0: one for each processor. The result does not depend on it
  bool fresh{false};  ///< discard what the directory holds of this study and start anew
  Processes* processes{nullptr};  ///< in the first of several: the others that compute rows
  std::stop_token stop;           ///< a request ends the run, resumable, with what has been found
  std::function<void(const RunProgress&)> progress;  ///< told now and then how far the run is
};

/// Reads what a valid study file names besides its motor, such as measured points and earlier results.
/// @return what to know before one believes the answer, a sentence each without a full stop
/// @throws FileError or InputError for what is wrong there
std::vector<std::string> study_notes(const StudyFile& file);

/// Says how long a search may take if its budget would last more than a minute, and makes one evaluation to know. Empty for
/// other kinds and for quick motors.
/// @throws InputError for a wrong input
std::string pace_note(const StudyFile& file);

/// In memory: no directory, nothing kept. The same answer.
/// @throws FileError or InputError for a wrong input
StudyResult run_study(const StudyFile& file, const RunOptions& options = {});

}  // namespace twum::studies
