// SPDX-License-Identifier: Apache-2.0
#include "kinds/search/optimum.hpp"

namespace twum::inline v0_1::studies {
namespace {

// The best design under limits.
class OptimizeRun : public OptimumRun {
 public:
  OptimizeRun(const OptimizeStudy& asked, const StudyFile& file)
      : OptimumRun(file,
                   {{},
                    asked.variables,
                    {asked.objective},
                    asked.constraints,
                    asked.derived,
                    asked.choose},
                   built_motors_asked(asked, file), asked.solver, asked.start) {}
};

}  // namespace

std::unique_ptr<StudyKindRun> OptimizeStudy::run(const StudyFile& file) const {
  return std::make_unique<OptimizeRun>(*this, file);
}

}  // namespace twum::inline v0_1::studies
