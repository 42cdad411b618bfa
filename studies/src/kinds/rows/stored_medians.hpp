// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/result_store.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace twum::inline v0_1::studies {

/// The median of each column from `first_column` on over the rows of a stage, rows without a value
/// left out: exact, the lower one of two middle ones; NaN where there is no value. Reads the stage
/// four times, 16 bits of the numbers at a time; memory does not grow with the rows.
std::vector<double> stored_medians(const ResultStore& store, std::uint64_t stage,
                                   std::size_t first_column);

}  // namespace twum::inline v0_1::studies
