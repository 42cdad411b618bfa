// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/column.hpp>

#include <vector>

namespace twum::inline v0_1::studies {

/// How an answer moves with a parameter that its study holds fixed (L5.1, L5.2).
struct Move {
  NamedValue held;  ///< which one, and its value, SI
  std::vector<double>
      slopes;  ///< derivatives by it of the numbers of the answer, SI; NaN: not determined
};

}  // namespace twum::inline v0_1::studies
