// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/study/curve_pictures.hpp"
#include "plot/study/pictures.hpp"

#include <vector>

/// The pictures of what a page has for a reader who points at it or chooses: curves, designs by the thousand.
namespace twum::cli {

std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::CurveResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::SweepResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::OptimizeResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::ParetoResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::CalibrateResult& answer);

/// Of other kinds a page has no more than their sections.
template <typename Answer>
std::vector<Picture> pictures_of(const FinishedStudy& /*study*/, const Answer& /*answer*/) {
  return {};
}

}  // namespace twum::cli
