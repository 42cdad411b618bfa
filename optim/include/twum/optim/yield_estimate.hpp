// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace twum::optim {

/// A share known from independent products, with its interval of Clopper and Pearson, U5.2.
struct YieldEstimate {
  std::uint64_t good{0};      ///< products that keep the limits
  std::uint64_t products{0};  ///< products made
  double value{0.0};          ///< their ratio
  double low{0.0};            ///< ends of the interval, which covers the truth with at least 95 %
  double high{1.0};           ///< upper end
};

/// What a sample says of a wanted yield, U5.3.
enum class YieldVerdict : std::uint8_t {
  holds,                ///< the lower end of the interval reaches it
  not_distinguishable,  ///< it lies within the interval
  broken                ///< the upper end is below it
};

/// "holds", "not-distinguishable" or "broken"; static lifetime.
const char* to_string(YieldVerdict verdict);

/// The estimate of `good` among `products` > 0.
YieldEstimate yield_estimate(std::uint64_t good, std::uint64_t products);

/// The verdict on a wanted yield.
YieldVerdict verdict_on(const YieldEstimate& estimate, double wanted);

/// How many fresh products a verdict takes where a share `risk` may fail, U5.1.
std::uint64_t products_for(double risk);

/// The risk to aim at so that a design within it is likely to be seen to hold, U5.4.
double risk_to_aim_at(double risk, std::uint64_t products);

}  // namespace twum::optim
