// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/estimate.hpp>

#include <cstdint>
#include <span>

namespace twum::inline v0_1::optim {

/// The p-quantile, p in (0, 1), interpolated linearly between two order statistics (type 7 of Hyndman and Fan). The
/// ends of the interval are order statistics, so it has at least its confidence for every distribution. An end is NaN
/// if there are too few draws.
/// @param sorted      independent draws, rising; NaN without any
/// @param confidence  between 0 and 1
IntervalEstimate quantile_estimate(std::span<const double> sorted, double p, double confidence);

/// The probability of an event that occurred `hits` times in `draws` independent draws, with the interval of Clopper
/// and Pearson, which has at least its confidence for any number of draws.
/// @param draws  0 gives NaN
IntervalEstimate proportion_estimate(std::uint64_t hits, std::uint64_t draws, double confidence);

}  // namespace twum::inline v0_1::optim
