// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/run/run_study.hpp>

#include "run/kept_study.hpp"

#include <twum/studies/report/report.hpp>

namespace twum::studies {

StudyResult run_study(const StudyFile& file, const std::string& directory,
                      const RunOptions& options) {
  return keep_study(file, directory, options, report_html);
}

}  // namespace twum::studies
