// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "study/entry_shapes.hpp"

#include <twum/studies/motor/motor_file.hpp>
#include <twum/studies/schema/shape.hpp>
#include <twum/studies/study/study.hpp>

#include <string>
#include <variant>
#include <vector>

namespace twum::studies {

/// How a study of one kind stands in a file; static lifetime.
const Shape<Study>& study_shape(StudyKind kind);

/// What a study file says, before the motor that it names is read.
struct StudyText {
  std::variant<std::string, MotorFile> motor;  ///< a path, or the motor itself
  std::vector<shapes::Override> set;
  Study study;
};

/// How a study file is read; static lifetime.
const Shape<StudyText>& study_file_shape();

}  // namespace twum::studies
