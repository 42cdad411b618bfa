// SPDX-License-Identifier: Apache-2.0
#include "kinds/optimum.hpp"
#include "study/entries.hpp"

namespace twum::studies {
namespace {

DesignProblem asked(const YamlNode& study) {
  DesignProblem problem;
  if (study.find("maximize") != nullptr)
    problem.maximize(entries::word(study, "maximize", ""));
  else
    problem.minimize(entries::word(study, "minimize", ""));
  problem.limits = entries::constraints(study, "constraints");
  return problem;
}

// The best design under limits.
class OptimizeStudy : public OptimumStudy {
 public:
  explicit OptimizeStudy(const StudyFile& file) : OptimumStudy(file, asked(file.study)) {}
};

}  // namespace

std::unique_ptr<StudyKindRun> make_optimize(const StudyFile& file) {
  return std::make_unique<OptimizeStudy>(file);
}

}  // namespace twum::studies
