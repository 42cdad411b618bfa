// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/executor.hpp"

#include <twum/base/ordered.hpp>

namespace twum::inline v0_1::studies {

ThreadExecutor::ThreadExecutor(const StudyKindRun& kind, unsigned jobs)
    : kind_(kind), jobs_(job_count(jobs)) {}

std::vector<StoredRow> ThreadExecutor::rows(const std::vector<StoredRow>& asked,
                                            const std::function<bool()>& proceed) {
  std::vector<StoredRow> made;
  for (const StoredRow& one : asked) {
    if (!proceed()) break;
    made.push_back(kind_.recompute(one).value());
  }
  return made;
}

}  // namespace twum::inline v0_1::studies
