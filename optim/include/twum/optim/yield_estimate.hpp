// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace twum::inline v0_1::optim {

/// A yield estimated from independent products, with the confidence interval of Clopper and Pearson, U5.2.
struct YieldEstimate {
  std::uint64_t good{0};      ///< products that meet the limits
  std::uint64_t products{0};  ///< products made
  double value{0.0};          ///< their ratio
  /// lower end of the interval, which covers the true yield with a probability of at least 95 %
  double low{0.0};
  double high{1.0};  ///< upper end of the interval
};

/// Verdict of a sample on a wanted yield, U5.3.
enum class YieldVerdict : std::uint8_t {
  holds,                ///< the wanted yield is at most the lower end of the interval
  not_distinguishable,  ///< the wanted yield lies within the interval
  broken                ///< the wanted yield is above the upper end
};

/// "holds", "not-distinguishable" or "broken"; static lifetime.
const char* to_string(YieldVerdict verdict);

/// The estimate of `good` among `products` > 0.
YieldEstimate yield_estimate(std::uint64_t good, std::uint64_t products);

/// The verdict on a wanted yield.
YieldVerdict verdict_on(const YieldEstimate& estimate, double wanted);

/// Number of independent products needed for a verdict if a share `risk` may fail, U5.1.
std::uint64_t products_for(double risk);

/// The risk to aim at so that a sample of this size is likely to confirm the wanted risk, U5.4.
double risk_to_aim_at(double risk, std::uint64_t products);
/// The same where weighted products decide, U5.6.
double risk_to_aim_at_weighted(double risk);

}  // namespace twum::inline v0_1::optim
