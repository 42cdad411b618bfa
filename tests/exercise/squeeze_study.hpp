// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the exercise adds to study.hpp.

/// The holding torque of a motor over its preload.
struct SqueezeStudy {
  static constexpr std::string_view kName{"squeeze"};  ///< as in `kind:`
  static constexpr std::string_view kTitle{
      "holding torque over the preload"};  ///< what it asks for
  static Shape<SqueezeStudy> shape();      ///< its field list
  /// Its runner; see kinds/study_kind.hpp.
  std::unique_ptr<StudyKindRun> run(const StudyFile& file) const;

  std::uint64_t points{5};  ///< from half the preload of the motor to twice as much, at least 2
};
