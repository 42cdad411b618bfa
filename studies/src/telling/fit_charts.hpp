// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/telling.hpp>

#include <string>
#include <vector>

/// The charts of a calibration; internal.
namespace twum::inline v0_1::studies::telling {

/// What a quantity is called: "torque" of "torque_at".
std::string quantity_words(const std::string& quantity);
/// "kinetic friction (left.csv)"
Phrase estimate_name(const CalibrateResult::Estimate& estimate);

/// Measured and fitted numbers of each kind with the band of the fit, and the circle of the admittance.
std::vector<Section> fit_sections(const CalibrateResult& answer, const StudyFile& study);
/// Of each estimate with a profile what holding it elsewhere costs.
std::vector<Section> profile_sections(const CalibrateResult& answer);
/// The residuals of each kind of data with more than one number.
std::vector<Section> residual_sections(const CalibrateResult& answer);

}  // namespace twum::inline v0_1::studies::telling
