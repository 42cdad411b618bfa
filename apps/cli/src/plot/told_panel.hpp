// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/chart.hpp"

#include <twum/studies/telling.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

namespace telling = studies::telling;

/// What the library says is on a chart, as a panel.
Panel panel_of(const telling::Chart& chart);

/// Charts as panels, over one axis if they share it.
/// @param columns  of a matrix; 0: below each other
Chart told_chart(const std::string& title, const std::vector<telling::Chart>& charts,
                 std::size_t columns = 0);

/// A phrase as one reads it.
std::string read(const telling::Phrase& phrase);

}  // namespace twum::inline v0_1::cli
