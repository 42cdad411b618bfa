// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "answer_support.hpp"
#include "kinds/calibrate/calibration.hpp"
#include "kinds/rows/executor.hpp"
#include "support/motor_files.hpp"
#include "support/scratch_folder.hpp"

#include <twum/core/motor.hpp>
#include <twum/optim/random.hpp>
#include <twum/studies/study_file.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

/// Calibration studies of motors that are known, for the tests.
namespace twum::test {

using namespace twum::studies;

inline constexpr double kRpm = 2 * std::numbers::pi / 60;  // [rad/s]

inline const char* const kThree =
    "kinetic_friction: {min: 0.05, max: 0.5}, amplitude: {min: 1 um, max: 2.2 um}, "
    "youngs_modulus: {min: 0.5 GPa, max: 20 GPa, scale: log}";

// The motor that the points come from.
inline const std::vector<ParameterValue> kTruth{{Parameter::kinetic_friction, 0.23},
                                                {Parameter::amplitude, 1.52e-6},
                                                {Parameter::youngs_modulus, 2.2e9}};

// A study of motor_path(MOTOR) in a folder of its own, with its points.
struct Case {
  ScratchFolder folder;
  std::string motor{"ring-60"};
  std::string set;
  std::string variables{kThree};
  std::string more{"starts: 1"};

  StudyFile file(const std::string& csv) const {
    std::ofstream(folder.path("points.csv")) << csv;
    std::ofstream(folder.path("study.yaml"))
        << "twum: 1\nmotor: " << motor_path(motor) << "\n"
        << (set.empty() ? "" : "set: " + set + "\n")
        << "study: {kind: calibrate, data: points.csv, variables: {" << variables << "}, " << more
        << "}\n";
    return read_study_file(folder.path("study.yaml"));
  }
  MotorDesign design() const { return file("speed,torque\n").motor.design; }
};

inline std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

// Points of a motor every 5 rpm, from slipping all one way to beyond no-load, in SI.
inline std::string points_of(const MotorDesign& design, double noise = 0, std::uint64_t seed = 1) {
  const Motor motor(design);
  optim::Random random(seed, 0, 0);
  std::string csv = "speed,torque\n";
  for (int i = 1; i <= 28; ++i) {
    const double speed = 5 * i * kRpm;
    // Box and Muller; 1 - u is never 0.
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    const double normal = radius * std::cos(2 * std::numbers::pi * random.uniform());
    csv +=
        number(speed) + "," + number(motor.operating_point(speed).torque + noise * normal) + "\n";
  }
  return csv;
}

struct Run {
  std::unique_ptr<StudyKindRun> kind;
  std::unique_ptr<ResultStore> store;
  KindAnswer answer;

  explicit Run(const StudyFile& file, unsigned jobs = 1, const std::vector<StoredRow>& stored = {})
      : kind(make_kind(file)), store(std::make_unique<ResultStore>(":memory:", kind->columns())) {
    for (const StoredRow& row : stored) store->add(row);
    ThreadExecutor executor(*kind, jobs);
    RunContext context{*store, executor, {}, {}};
    answer = kind->run(context);
  }
  const CalibrateResult& result() const { return std::get<CalibrateResult>(answer.answer); }
  std::string json() const { return answer_json(result()).dump(); }
  std::string text() const {
    return headline_text(answer.answer, answer.outcome) + sections_text(answer.answer);
  }
  std::vector<StoredRow> rows() const {
    std::vector<StoredRow> rows;
    store->read([&](const StoredRow& row) { rows.push_back(row); });
    return rows;
  }
};

inline bool same_rows(const std::vector<StoredRow>& a, const std::vector<StoredRow>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].stage != b[i].stage || a[i].index != b[i].index || a[i].values != b[i].values ||
        a[i].status != b[i].status || a[i].detail != b[i].detail)
      return false;
  }
  return true;
}

}  // namespace twum::test
