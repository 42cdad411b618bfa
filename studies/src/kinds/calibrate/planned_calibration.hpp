// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/rows/study_kind.hpp"

#include <twum/studies/study.hpp>
#include <twum/studies/study_file.hpp>

#include <memory>

namespace twum::inline v0_1::studies {

/// A calibration without data: the plan of the first measurements, from the motor and the ranges alone (L6.1, L6.2).
/// @throws InputError for a motor that nothing can be read of
std::unique_ptr<StudyKindRun> planned_calibration(const CalibrateStudy& asked,
                                                  const MotorDesign& motor);

}  // namespace twum::inline v0_1::studies
