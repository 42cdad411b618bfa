// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/study/pictures.hpp"

#include <vector>

namespace twum::cli {

/// The pictures of what is said about an answer: one for each chart, and one for each section's bars.
std::vector<Picture> told_pictures(const FinishedStudy& study);

}  // namespace twum::cli
