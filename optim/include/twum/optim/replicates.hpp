// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/estimate.hpp>

#include <span>

namespace twum::inline v0_1::optim {

/// Sums over one of several independent samples of the same size.
struct ReplicateSums {
  double above{0};  ///< numerator
  double below{0};  ///< denominator
};

/// The ratio of the sums over all replicates, with Student's interval from their scatter about it: the scatter of above - ratio
/// below. Exact for normal sums of one denominator, otherwise to first order in the scatter.
/// @param replicates  at least 2
/// @param confidence  between 0 and 1
IntervalEstimate ratio_of_replicates(std::span<const ReplicateSums> replicates, double confidence);

/// The difference of two such ratios over the same replicates, whose scatters are correlated.
IntervalEstimate difference_of_ratios(std::span<const ReplicateSums> more,
                                      std::span<const ReplicateSums> less, double confidence);

}  // namespace twum::inline v0_1::optim
