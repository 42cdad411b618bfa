// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/chart.hpp"

#include <string>
#include <vector>

namespace twum::cli {

/// A quantity of all designs.
struct ParallelAxis {
  std::string name;
  std::string unit;            ///< SI
  std::vector<double> values;  ///< of each design; NaN where there is none
};

/// Parallel coordinates, as on the page of a narrow screen: an axis for each quantity, one below the other, and a line for
/// each of these rows.
Picture parallel_picture(const std::string& name, const std::string& title,
                         const std::vector<ParallelAxis>& axes,
                         const std::vector<std::size_t>& rows);

}  // namespace twum::cli
