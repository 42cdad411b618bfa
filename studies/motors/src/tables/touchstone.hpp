// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/measured_table.hpp"

#include <optional>

namespace twum::inline v0_1::motors {

/// A Touchstone file of one port (.s1p; version 1 or 2) as a table of frequency, conductance and susceptance of that port. Nothing for
/// another file: one of another ending without a line of options such as "# kHz S RI R 50".
/// @throws FileError with everything that is wrong in it
std::optional<MeasuredTable> touchstone_table(const Source& source);

}  // namespace twum::inline v0_1::motors
