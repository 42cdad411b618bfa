// SPDX-License-Identifier: Apache-2.0
#include "kinds/rows/study_kind.hpp"

#include <twum/studies/study_file.hpp>

namespace twum::inline v0_1::studies {

std::unique_ptr<StudyKindRun> make_kind(const StudyFile& file) {
  return std::visit([&](const auto& asked) { return asked.run(file); }, file.asked);
}

}  // namespace twum::inline v0_1::studies
