// SPDX-License-Identifier: Apache-2.0
#include "kinds/optimum.hpp"

namespace twum::studies {
namespace {

// The best design under limits.
class OptimizeRun : public OptimumRun {
 public:
  OptimizeRun(const OptimizeStudy& asked, const StudyFile& file)
      : OptimumRun(file, {{}, asked.variables, {asked.objective}, asked.constraints}, asked.solver,
                   asked.start) {}
};

}  // namespace

std::unique_ptr<StudyKindRun> make_run(const OptimizeStudy& asked, const StudyFile& file) {
  return std::make_unique<OptimizeRun>(asked, file);
}

}  // namespace twum::studies
