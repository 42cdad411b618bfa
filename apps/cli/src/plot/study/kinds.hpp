// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/study/curve_pictures.hpp"
#include "plot/study/pictures.hpp"

#include <vector>

/// The pictures of each kind of answer besides those of its sections, in the order of the page.
namespace twum::cli {

std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::CurveResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::SweepResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::OptimizeResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::ParetoResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::UncertaintyResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::CalibrateResult& answer);
std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::FrequencyResult& answer);

/// The motor of the study, for a kind that draws no motors of its own.
template <typename Answer>
std::vector<Picture> pictures_of(const FinishedStudy& study, const Answer& /*answer*/) {
  std::vector<Picture> pictures;
  std::vector<NamedMotor> motors;
  add_motor(motors, "motor", study.result.design, {});
  add_curve_pictures(pictures, study.title("the motor"), motors);
  return pictures;
}

}  // namespace twum::cli
