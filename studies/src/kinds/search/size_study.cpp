// SPDX-License-Identifier: Apache-2.0
#include "kinds/search/optimum.hpp"

#include <twum/studies/sizing.hpp>

namespace twum::inline v0_1::studies {
namespace {

// The duty comes first among the limits.
DesignProblem posed(const SizeStudy& asked) {
  DesignProblem problem{{},           asked.variables, {asked.prefer},
                        asked.limits, asked.derived,   asked.choose};
  if (asked.drive == DutyDrive::fixed) {
    problem.limits.insert(problem.limits.begin(), asked.duty.begin(), asked.duty.end());
    return problem;
  }
  std::vector<DutyPoint> duty;
  for (const MotorLimit& limit : asked.duty)
    duty.push_back({limit.lower, limit.metric.request()->at});
  return held_at(std::move(problem), duty);
}

// Among the motors that carry the duty within the limits, finds the one with the best preferred metric.
class SizeRun : public OptimumRun {
 public:
  SizeRun(const SizeStudy& asked, const StudyFile& file)
      : OptimumRun(file, posed(asked), built_motors_asked(asked, file), asked.solver, asked.start) {
  }
};

}  // namespace

std::unique_ptr<StudyKindRun> SizeStudy::run(const StudyFile& file) const {
  return std::make_unique<SizeRun>(*this, file);
}

}  // namespace twum::inline v0_1::studies
