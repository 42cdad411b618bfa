// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/statistics/estimate.hpp>

#include <cstdint>
#include <span>

namespace twum::studies {

/// The quantile of a probability p in (0, 1): between the two order statistics next to it, linearly
/// (Hyndman and Fan's seventh). The interval lies between two order statistics, covers with at least
/// its confidence whatever the distribution, and is NaN at an end where the draws do not reach.
/// @param sorted      independent draws, rising; NaN without any
/// @param confidence  between 0 and 1, as everywhere below
Estimate quantile_estimate(std::span<const double> sorted, double p, double confidence);

/// The probability of something that happened `hits` times in `draws` independent draws, with the
/// interval of Clopper and Pearson, which covers with at least its confidence for any number.
/// @param draws  0 gives NaN
Estimate proportion_estimate(std::uint64_t hits, std::uint64_t draws, double confidence);

/// Student's t with `freedom` > 0 degrees that a fraction (1 + confidence) / 2 of draws stays below.
double student_quantile(double freedom, double confidence);

}  // namespace twum::studies
