// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/executor.hpp"
#include "support/file_text.hpp"
#include "support/motor_files.hpp"
#include "support/scratch_folder.hpp"

#include <twum/studies/study_file.hpp>

#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// Small studies and a kind that answers what the test wants, for tests of what stands round a study.
namespace twum::test {

using namespace twum::studies;

/// A study of motor_path(MOTOR), read from a file in a folder that stays.
inline StudyFile study_in(const ScratchFolder& folder, const std::string& study,
                          const std::string& motor = "elastic-layer",
                          const std::string& name = "study.yaml") {
  std::ofstream(folder.path(name))
      << "twum: 1\nmotor: " << motor_path(motor) << "\nstudy: " << study << "\n";
  return read_study_file(folder.path(name));
}

/// A kind of study whose rows, answer and certificates are what the test says.
struct ScriptedKind : StudyKindRun {
  std::vector<StoredColumn> all{{"preload", "N"}, {"stall_torque", "N.m"}};
  std::function<std::optional<StoredRow>(const StoredRow&)> again = [](const StoredRow&) {
    return std::nullopt;
  };
  std::function<std::optional<optim::Certificate>(std::span<const double>)> evidence =
      [](std::span<const double>) { return std::nullopt; };
  std::function<KindAnswer(RunContext&)> answer;

  std::vector<StoredColumn> columns() const override { return all; }
  std::size_t variables() const override { return 1; }
  KindAnswer run(RunContext& context) override { return answer(context); }
  std::optional<StoredRow> recompute(const StoredRow& stored) const override {
    return again(stored);
  }
  std::optional<optim::Certificate> certify(
      std::span<const double> variables,
      std::span<const ParameterValue> /*design*/) const override {
    return evidence(variables);
  }
};

}  // namespace twum::test
