// SPDX-License-Identifier: Apache-2.0
#include "kinds/search/optimum.hpp"

namespace twum::studies {
namespace {

// The duty comes first among the limits.
std::vector<MotorLimit> limits_of(const SizeStudy& asked) {
  std::vector<MotorLimit> limits = asked.duty;
  limits.insert(limits.end(), asked.limits.begin(), asked.limits.end());
  return limits;
}

// Among the motors that carry the duty within the limits, finds the one with the best preferred metric.
class SizeRun : public OptimumRun {
 public:
  SizeRun(const SizeStudy& asked, const StudyFile& file)
      : OptimumRun(
            file,
            {{}, asked.variables, {asked.prefer}, limits_of(asked), asked.derived, asked.choose},
            {asked.tolerances, asked.statistics}, asked.solver, asked.start) {}
};

}  // namespace

std::unique_ptr<StudyKindRun> SizeStudy::run(const StudyFile& file) const {
  return std::make_unique<SizeRun>(*this, file);
}

}  // namespace twum::studies
