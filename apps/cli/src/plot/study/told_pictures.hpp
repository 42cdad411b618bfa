// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/chart.hpp"

#include <twum/io/result_store.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// A finished study, from which its pictures are made.
struct FinishedStudy {
  const studies::StudyFile& file;
  const studies::StudyResult& result;
  const studies::ResultStore& store;

  /// "study: what", the title of a picture.
  std::string title(const std::string& what) const { return result.study + ": " + what; }
};

/// The pictures of what is said about an answer: of its charts, of each section's bars, and of parallel coordinates.
std::vector<Picture> told_pictures(const FinishedStudy& study);

}  // namespace twum::inline v0_1::cli
