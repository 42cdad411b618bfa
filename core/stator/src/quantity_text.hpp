// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace twum::inline v0_1::stator {

/// A value for a message, lengths and pressures with a prefix: "21.5 mm", "80 GPa", "0.31".
/// @param unit  SI; "1" if dimensionless
std::string quantity_text(double value, std::string_view unit);

}  // namespace twum::inline v0_1::stator
