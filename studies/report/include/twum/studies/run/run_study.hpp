// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/run/run_options.hpp>

#include <string>

namespace twum::studies {

/// Runs a study and keeps everything in a directory: study.yaml (resolved), results.db, results.csv,
/// summary.json, report.html, and motor files of what was found. A directory in which the same study
/// was interrupted is gone on with; one that holds a finished result of it answers from there.
/// The result is the same to the byte, times aside, for any number of threads and interruptions. Two
/// runs at once need two directories.
/// @throws FileError or InputError for a wrong input or a directory with another study;
///         StoreError if something cannot be written or read back.
StudyResult run_study(const StudyFile& file, const std::string& directory,
                      const RunOptions& options = {});

}  // namespace twum::studies
