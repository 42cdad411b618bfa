// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "entries/motion_columns.hpp"

#include <twum/motion/motion.hpp>
#include <twum/studies/motion_result.hpp>
#include <twum/studies/study.hpp>

#include <optional>
#include <span>
#include <vector>

/// Numbers of motions that are asked for; internal.
namespace twum::inline v0_1::studies {

/// The times that a measure asks for; they have to be among the samples.
std::vector<double> times_of(const MotionMeasure& measure);

/// What percentages and overshoots refer to: the reference of a loop in the column that it controls, elsewhere the last value with
/// the drive on.
struct MeasureBase {
  double last_on{0};  ///< when the drive is switched off first, or the end [s]
  std::optional<MotionResult::Reference> reference{};  ///< of a loop, at that time
};

/// The numbers of a motion whose samples include times_of() of each measure.
std::vector<MotionResult::Measure> measured(const std::vector<MotionMeasure>& asked,
                                            const motion::Motion& motion, const MeasureBase& base);

/// Largest differences between two motions of the same times, as far as both have samples.
MotionResult::StepError step_error(std::span<const motion::MotionSample> fine,
                                   std::span<const motion::MotionSample> coarse);

}  // namespace twum::inline v0_1::studies
