// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/run_options.hpp>

#include <string>

namespace twum::inline v0_1::studies {

/// Runs a study and keeps everything in a directory: study.yaml (resolved), results.db, results.csv, summary.json,
/// report.html, and motor files of the answer. If the directory holds the same study, interrupted, the run resumes;
/// if it holds the finished result, that is returned. Except for times, the files are the same byte for byte for any
/// number of threads and interruptions. Two runs at the same time need two directories.
/// @throws FileError or InputError for a wrong input or a directory with another study;
///         StoreError if something cannot be written or read back.
StudyResult run_study(const StudyFile& file, const std::string& directory,
                      const RunOptions& options = {});

}  // namespace twum::inline v0_1::studies
