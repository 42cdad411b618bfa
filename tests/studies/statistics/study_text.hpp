// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/scratch_folder.hpp"

#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <fstream>
#include <string>

namespace twum::test {

/// A study of examples/motors/elastic-layer.yaml, whose layer has neither inertia nor damping: on the
/// plateau its stall torque is exactly mu F_N r.
inline studies::StudyFile elastic_study(const std::string& entries) {
  const ScratchFolder folder;
  const std::string path = folder.path("study.yaml");
  std::ofstream(path) << "twum: 1\nmotor: " TWUM_SOURCE_DIR
                         "/examples/motors/elastic-layer.yaml\nstudy:\n"
                      << entries;
  return studies::read_study_file(path);
}

inline studies::StudyResult run(const std::string& entries, unsigned jobs = 2) {
  studies::RunOptions options;
  options.jobs = jobs;
  return studies::run_study(elastic_study(entries), options);
}

/// summary.json without its times.
inline std::string timeless_summary(studies::StudyResult result) {
  result.seconds = 0;
  result.started.clear();
  return studies::summary_json(result);
}

}  // namespace twum::test
