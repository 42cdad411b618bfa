// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// A motor that a study has found.
struct FoundMotor {
  std::string file;  ///< path of its motor file in the result directory
  std::string what;  ///< "best design", "point 3 of 20"
  MotorFile motor;
};

/// Motor file of a point of a front: "front/07.yaml" of 12, "front/007.yaml" of 120.
/// @param number  of the point, from 1
std::string front_file(std::size_t number, std::size_t count);

/// Motor file of one of several motors that fit equally well: "optima/02.yaml".
std::string optimum_file(std::size_t number);

/// The best design, the points of a front, or the fitted motor; empty for a study that was interrupted or found no
/// answer.
std::vector<FoundMotor> found_motors(const StudyFile& file, const StudyResult& result);

/// Text of its motor file.
std::string found_motor_text(const FoundMotor& found, const StudyResult& result);

/// model_notes() of the motors found, or of the motor of the study, one sentence each; of several motors, the most
/// severe note on each topic.
std::vector<std::string> notes_on(const StudyFile& file, const StudyResult& result);

}  // namespace twum::inline v0_1::studies
