// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/pareto_result.hpp>

#include <cstddef>
#include <vector>

namespace twum::inline v0_1::studies {

/// The best point of each goal; of a front that is not empty.
std::vector<std::size_t> ends_of(const ParetoResult& result);
/// The knee, see ParetoResult::knee.
std::size_t knee_of(const ParetoResult& result);

}  // namespace twum::inline v0_1::studies
