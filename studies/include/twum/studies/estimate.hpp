// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/estimate.hpp>
#include <twum/optim/sample_moments.hpp>
#include <twum/optim/sample_quantiles.hpp>

/// Estimates from samples, which searches under tolerances need too.
namespace twum::inline v0_1::studies {

/// As in results.
using Estimate = optim::IntervalEstimate;
using optim::Moments;
using optim::proportion_estimate;
using optim::quantile_estimate;

}  // namespace twum::inline v0_1::studies
