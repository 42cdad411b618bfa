// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "answer_support.hpp"
#include "kinds/rows/executor.hpp"
#include "support/motor_files.hpp"
#include "support/scratch_folder.hpp"

#include <twum/studies/study_file.hpp>

#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace twum::test {

using namespace twum::studies;

inline StudyFile example_study(const std::string& name,
                               const std::vector<std::string>& settings = {}) {
  return read_study_file(TWUM_SOURCE_DIR "/examples/studies/" + name, settings);
}

/// The same with one slice, where a test computes thousands of motors.
inline StudyFile narrow_example(const std::string& name) {
  return example_study(name, {"radial_slices=1"});
}

/// A study of motor_path(MOTOR); `set` and `study` are YAML flow mappings.
inline StudyFile study_of(const std::string& motor, const std::string& set,
                          const std::string& study) {
  const ScratchFolder folder;
  const std::string path = folder.path("study.yaml");
  std::ofstream(path) << "twum: 1\nmotor: " << motor_path(motor) << "\n"
                      << (set.empty() ? "" : "set: " + set + "\n") << "study: " << study << "\n";
  return read_study_file(path);
}

inline std::unique_ptr<StudyKindRun> make_search(const StudyFile& file) { return make_kind(file); }

/// A search in memory, with everything it left.
struct Search {
  std::unique_ptr<StudyKindRun> kind;
  std::unique_ptr<ResultStore> store;
  KindAnswer answer;

  explicit Search(const StudyFile& file, unsigned jobs = 1,
                  const std::vector<StoredRow>& stored = {}, std::stop_token stop = {})
      : kind(make_search(file)), store(std::make_unique<ResultStore>(":memory:", kind->columns())) {
    for (const StoredRow& row : stored) store->add(row);
    ThreadExecutor executor(*kind, jobs);
    RunContext context{*store, executor, stop, {}};
    answer = kind->run(context);
  }

  const OptimizeResult& optimum() const { return std::get<OptimizeResult>(answer.answer); }
  const ParetoResult& front() const { return std::get<ParetoResult>(answer.answer); }
  std::string json() const { return kind_json().dump(); }
  Json kind_json() const {
    if (const auto* front = std::get_if<ParetoResult>(&answer.answer)) return answer_json(*front);
    return answer_json(optimum());
  }
  std::string text() const {
    return headline_text(answer.answer, answer.outcome) + sections_text(answer.answer);
  }
  std::vector<StoredRow> rows() const {
    std::vector<StoredRow> rows;
    store->read([&](const StoredRow& row) { rows.push_back(row); });
    return rows;
  }
};

inline double value(const std::vector<NamedValue>& values, const std::string& name) {
  for (const NamedValue& v : values) {
    if (v.name == name) return v.value;
  }
  throw std::runtime_error("no value named " + name);
}

inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i] == b[i] || (a[i] != a[i] && b[i] != b[i]))) return false;
  }
  return true;
}

inline bool same_rows(const std::vector<StoredRow>& a, const std::vector<StoredRow>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].stage != b[i].stage || a[i].index != b[i].index || a[i].status != b[i].status ||
        a[i].detail != b[i].detail || !same_bits(a[i].values, b[i].values))
      return false;
  }
  return true;
}

/// The elastic layer in closed form, from the definitions alone: contact angle phi as parameter (T3.2),
/// plateau torque mu F_N r (C8.5) and no-load speed at V = sin(phi) / phi (C8.6).
struct ElasticLayer {
  MotorDesign motor;

  double wave_number() const { return motor.stator.wavelengths / motor.stator.contact_radius; }
  double omega() const { return 2 * 3.14159265358979323846 * motor.stator.frequency; }
  /// F_N of a contact angle.
  double preload(double phi) const { return load_unit() * (std::sin(phi) - phi * std::cos(phi)); }
  double preload_slope(double phi) const { return load_unit() * phi * std::sin(phi); }
  double load_unit() const {
    return 2 * motor.stator.wavelengths * motor.stator.contact_width * motor.layer.youngs_modulus *
           motor.stator.amplitude / (motor.layer.thickness * wave_number());
  }
  /// V0 / r
  double crest_speed() const {
    return wave_number() * motor.stator.neutral_plane_distance * omega() * motor.stator.amplitude /
           motor.stator.contact_radius;
  }
  double no_load(double phi) const { return crest_speed() * std::sin(phi) / phi; }
  double no_load_slope(double phi) const {
    return crest_speed() * (phi * std::cos(phi) - std::sin(phi)) / (phi * phi);
  }
  double plateau_torque(double preload) const {
    return motor.friction.kinetic * preload * motor.stator.contact_radius;
  }
  /// The angle at which the no-load speed is this; it falls with the angle.
  double angle_of_no_load(double speed) const {
    return bisect([&](double phi) { return speed - no_load(phi); });
  }
  double angle_of_preload(double force) const {
    return bisect([&](double phi) { return preload(phi) - force; });
  }
  /// Where f, rising, is zero in (0, pi), to the last bit.
  template <typename F>
  static double bisect(F f) {
    double low = 1e-3;
    double high = 3;
    for (int i = 0; i < 200; ++i) {
      const double mid = 0.5 * (low + high);
      (f(mid) < 0 ? low : high) = mid;
    }
    return low;
  }
};

}  // namespace twum::test
