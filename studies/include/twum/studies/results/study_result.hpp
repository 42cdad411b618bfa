// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/column.hpp>
#include <twum/studies/results/sample_results.hpp>
#include <twum/studies/results/search_results.hpp>
#include <twum/studies/study/study_file.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace twum::studies {

/// Where in the box of the variables evaluations failed for one reason.
struct FailureRegion {
  struct Range {
    Column variable;
    double low;   ///< smallest value at a failure, SI
    double high;  ///< largest
  };
  std::string reason;
  std::uint64_t count{0};
  std::vector<Range> where;  ///< every variable of the study
};

using Answer = std::variant<CurveResult, SweepResult, SensitivityResult, OptimizeResult,
                            ParetoResult, UncertaintyResult, CalibrateResult>;

/// What came out of a study. Size studies answer as optimize does.
struct StudyResult {
  std::string study;  ///< name: that of the file without extension
  StudyKind kind{StudyKind::curve};
  std::string motor;    ///< name of the motor
  std::string outcome;  ///< "optimal", "feasible", "infeasible", "budget", "failed" of a search;
                        ///< "done" or "failed" (nothing could be evaluated) of the others;
                        ///< "interrupted" if it was asked to stop
  std::uint64_t evaluations{0};
  std::map<std::string, std::uint64_t> failures;  ///< count by reason
  std::vector<FailureRegion> failure_regions;
  std::uint64_t seed{0};
  std::string started;  ///< date and time (UTC, ISO 8601) of the first run, if it was interrupted
  double seconds{0};    ///< of all runs together
  bool was_complete{false};  ///< the directory held this result already
  std::string hash;          ///< of the resolved study and the files it names
  Answer answer;
};

/// The text of summary.json: SI, flat names; the same to the byte, times aside, for any number of
/// threads and interruptions.
std::string summary_json(const StudyResult& result);

/// What a terminal shows at the end: engineering units and sentences, no colour.
std::string summary_text(const StudyResult& result);

}  // namespace twum::studies
