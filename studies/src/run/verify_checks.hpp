// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/study_kind.hpp"
#include "results/row_pass.hpp"

#include <twum/studies/verify_study.hpp>

#include <nlohmann/json.hpp>

/// The checks of verify_study(); each adds its findings. Internal.
namespace twum::inline v0_1::studies {

/// Relative deviation up to which numbers count as equal. This program repeats its results bit for bit; another
/// compiler may round differently.
inline constexpr double kVerifyTolerance = 1e-12;

/// Adds a line about a failed check; the first twenty are kept.
void complain(Verification& found, const std::string& text);

/// Records the deviation of two numbers, with NaN equal to NaN; false if it is too large.
bool note_deviation(Verification& found, double there, double now);

/// Compares random rows with StudyKindRun::recompute().
void verify_rows(const StudyKindRun& kind, const ResultStore& store, const VerifyOptions& options,
                 Verification& found);

/// Checks designs and certificates of a summary.
void verify_designs(const StudyFile& file, const StudyKindRun& kind,
                    const nlohmann::ordered_json& summary, const std::stop_token& stop,
                    Verification& found);

/// Compares the answer of a summary with the one that the kind derives from the stored rows, and returns the latter.
KindAnswer verify_answer(StudyKindRun& kind, ResultStore& store,
                         const nlohmann::ordered_json& summary, const std::stop_token& stop,
                         Verification& found);

/// Compares everything else in a summary (evaluations, failures, notes, hash, ...) with the new result, except times
/// and versions, which may differ.
void verify_record(const StudyResult& now, const nlohmann::ordered_json& summary,
                   Verification& found);

/// For an interrupted study, checks that no row counted in its summary is missing.
void verify_interrupted(const ResultStore& store, const nlohmann::ordered_json& summary,
                        Verification& found);

/// Compares the stored study with the hash of the one that was run.
void verify_study_hash(const StudyFile& file, const nlohmann::ordered_json& summary,
                       Verification& found);

/// Compares results.csv with the stored rows.
/// @return the failures among the rows
FailureCount verify_table(const StudyKindRun& kind, const ResultStore& store,
                          const std::string& path, Verification& found);

/// Compares the motor files with the answer.
void verify_motor_files(const StudyFile& file, const StudyResult& result,
                        const std::string& directory, Verification& found);

}  // namespace twum::inline v0_1::studies
