// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/study_kind.hpp"

#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Notes on a study as it was asked, by its kind and its motor.
std::vector<std::string> notes_of(const StudyFile& file, const StudyKindRun& kind);

}  // namespace twum::inline v0_1::studies
