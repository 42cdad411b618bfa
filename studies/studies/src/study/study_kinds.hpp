// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/schema/shape.hpp>
#include <twum/studies/study/study.hpp>

namespace twum::studies {

/// How a study of one kind stands in a file; static lifetime.
const Shape<Study>& study_shape(StudyKind kind);

}  // namespace twum::studies
