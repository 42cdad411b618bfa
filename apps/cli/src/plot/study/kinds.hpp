// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/study/curve_pictures.hpp"
#include "plot/study/pictures.hpp"

#include <vector>

/// The pictures of each kind of answer; in the order of the page.
namespace twum::cli {

std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::CurveResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::SweepResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::SensitivityResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::OptimizeResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::ParetoResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::UncertaintyResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::CalibrateResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::FrequencyResult& answer);

/// What tolerances do to a search: how the limited metrics scatter, where the risk goes, what each tolerance and the yield cost.
void add_robust_pictures(std::vector<Picture>& pictures, const FinishedStudy& study,
                         const studies::OptimizeResult& answer);

}  // namespace twum::cli
