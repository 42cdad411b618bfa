// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/told_panel.hpp"

#include <string>

namespace twum::inline v0_1::cli {

/// Parallel coordinates, as on the page of a narrow screen: an axis for each quantity, one below the other, and a line for
/// each design, or for a sample of many.
Picture parallel_picture(const std::string& title, const telling::Parallel& told);

}  // namespace twum::inline v0_1::cli
