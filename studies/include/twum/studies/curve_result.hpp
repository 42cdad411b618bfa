// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/column.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Torque-speed curves of one motor, or of a family over one parameter. The points are the rows of
/// the store: stage is the member, index the point.
struct CurveResult {
  /// One curve.
  struct Member {
    double value{0};                  ///< of the family's parameter, SI; NaN for the motor alone
    std::vector<NamedValue> metrics;  ///< every metric without argument; NaN where it has no answer
    std::vector<std::string> statuses;  ///< of the metrics: "ok", or why there is none
    std::uint64_t points{0};            ///< number of its points
    std::uint64_t failed{0};            ///< points without an answer
    double last_speed{0};               ///< speed of its last point [rad/s]
  };
  std::optional<StoredColumn> family;  ///< the parameter; nothing for the motor alone
  std::vector<Member> members;         ///< in the order asked
};

}  // namespace twum::inline v0_1::studies
