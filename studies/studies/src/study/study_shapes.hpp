// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/schema/shape.hpp>
#include <twum/studies/study/study.hpp>

/// The field lists of the kinds of study: from each follow reading, errors, defaults, schema, template,
/// reference page and the resolved text; internal.
namespace twum::studies::shapes {

Shape<CurveStudy> curve_study();
Shape<SweepStudy> sweep_study();
Shape<SensitivityStudy> sensitivity_study();
Shape<OptimizeStudy> optimize_study();
Shape<ParetoStudy> pareto_study();
Shape<SizeStudy> size_study();
Shape<UncertaintyStudy> uncertainty_study();
Shape<CalibrateStudy> calibrate_study();

}  // namespace twum::studies::shapes
