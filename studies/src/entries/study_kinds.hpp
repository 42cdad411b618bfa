// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "entries/entry_shapes.hpp"

#include <twum/io/shape.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/study.hpp>

#include <string>
#include <variant>
#include <vector>

namespace twum::inline v0_1::studies {

/// Shape of a study of one kind in a file; static lifetime.
const Shape<Study>& study_shape(StudyKind kind);

/// Content of a study file before the motor that it names is read.
struct StudyText {
  std::variant<std::string, MotorFile> motor;  ///< a path, or the motor itself
  std::vector<shapes::Override> set;
  Study study;
};

/// Shape of a study file; static lifetime.
const Shape<StudyText>& study_file_shape();
/// The same of studies of one kind: the shapes of all take longer to make than many a study runs.
Shape<StudyText> study_file_shape(StudyKind kind);

}  // namespace twum::inline v0_1::studies
