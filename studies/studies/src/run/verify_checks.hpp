// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/study_kind.hpp"
#include "results/row_pass.hpp"

#include <twum/studies/run/verify_study.hpp>

#include <nlohmann/json.hpp>

/// The parts of verify_study(); each adds what it found. Internal.
namespace twum::studies {

/// Relative deviation up to which numbers count as equal: what another compiler's rounding may do to
/// results that this program repeats to the bit.
inline constexpr double kVerifyTolerance = 1e-12;

/// Adds a line about something that does not hold; the first twenty are kept.
void complain(Verification& found, const std::string& text);

/// Notes the deviation of two numbers, NaN being equal to NaN; false if they do not hold.
bool note_deviation(Verification& found, double there, double now);

/// Rows drawn at random, against StudyKindRun::recompute().
void verify_rows(const StudyKindRun& kind, const ResultStore& store, const VerifyOptions& options,
                 Verification& found);

/// Designs and certificates of a summary.
void verify_designs(const StudyFile& file, const StudyKindRun& kind,
                    const nlohmann::ordered_json& summary, Verification& found);

/// The answer of a summary, against what the kind makes of the stored rows; that answer.
KindAnswer verify_answer(StudyKindRun& kind, ResultStore& store,
                         const nlohmann::ordered_json& summary, Verification& found);

/// Everything else that a summary says of a study (evaluations, failures, notes, hash, ...), against what
/// is so now; not times and versions, which may differ.
void verify_record(const StudyResult& now, const nlohmann::ordered_json& summary,
                   Verification& found);

/// Of an interrupted study: that no row is missing of those that its summary counts.
void verify_interrupted(const ResultStore& store, const nlohmann::ordered_json& summary,
                        Verification& found);

/// The stored study, against the hash of the one that was run.
void verify_study_hash(const StudyFile& file, const nlohmann::ordered_json& summary,
                       Verification& found);

/// results.csv, against the stored rows.
/// @return the failures among the rows
FailureCount verify_table(const StudyKindRun& kind, const ResultStore& store,
                          const std::string& path, Verification& found);

/// The motor files, against the answer.
void verify_motor_files(const StudyFile& file, const StudyResult& result,
                        const std::string& directory, Verification& found);

}  // namespace twum::studies
