// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace twum::inline v0_1::optim {

/// Distribution of an input about the design's value.
enum class Law : std::uint8_t {
  normal,
  lognormal,
  uniform,
  triangular,
  given  ///< by RandomInput::transform, whatever the design's value
};
/// Its name; static lifetime.
const char* to_string(Law value) noexcept;

/// Value of an input in a built product, and its derivatives, U1.5, U1.7.
struct BuiltValue {
  double value{0.0};      ///< P = T(x, z)
  double by_design{0.0};  ///< dP/dx
  double by_normal{0.0};  ///< dP/dz, U1.6
  double by_spread{0.0};  ///< s dP/ds, where s is the spread; for a triangle both widths are scaled
};

/// An input that varies from product to product: P = T(x, z), where x is the design's value and z a standard normal
/// number, U1.1 to U1.4. Inputs are independent of each other, or correlated by their normal numbers (Correlation).
struct RandomInput {
  std::string name{};    ///< unique among the inputs
  Law law{Law::normal};  ///< shape of the distribution
  double spread{0.0};    ///< > 0: standard deviation, half range, or width below the mode
  double above{0.0};     ///< triangular only: width above the mode
  bool relative{true};   ///< the widths are shares of x, which must then be positive
  /// position of the design variable that scatters; none: `value` scatters
  std::optional<std::size_t> variable{};
  double value{0.0};  ///< x of an input that is not a design variable
  /// Law::given: P = T(z) and dP/dz > 0 at a standard normal z; its other derivatives are 0
  std::function<BuiltValue(double z)> transform{};

  /// The built value. Smooth in x and z; |z| is cut off at 8.2, where a tail holds 1e-16.
  BuiltValue at(double design, double z) const;
};

}  // namespace twum::inline v0_1::optim
