// SPDX-License-Identifier: Apache-2.0
#include "kinds/optimum.hpp"
#include "study/entries.hpp"

namespace twum::studies {
namespace {

// A motor carries a load at a speed if its torque there is at least as large. Unlike speed_at(load),
// the torque exists whether the motor will do or not.
std::string duty_limit(const YamlNode& duty) {
  return "torque_at(" + duty.find("speed")->scalar + ") >= " + duty.find("torque")->scalar;
}

DesignProblem asked(const YamlNode& study) {
  DesignProblem problem;
  problem.minimize(entries::word(study, "prefer", "max_pressure"));
  for (const YamlNode& duty : study.find("duty")->items) problem.limit(duty_limit(duty));
  for (Constraint& limit : entries::constraints(study, "limits"))
    problem.limits.push_back(std::move(limit));
  return problem;
}

// Of the motors that carry the duty within the limits, the one with the least of what is preferred.
class SizeStudy : public OptimumStudy {
 public:
  explicit SizeStudy(const StudyFile& file) : OptimumStudy(file, asked(file.study)) {}
};

}  // namespace

std::unique_ptr<StudyKindRun> make_size(const StudyFile& file) {
  return std::make_unique<SizeStudy>(file);
}

}  // namespace twum::studies
