// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/telling.hpp>

#include <vector>

/// Pairs of what was drawn and computed, motor by motor; internal.
namespace twum::inline v0_1::studies::telling {

/// A matrix of scatter plots: at most six quantities, the metrics and the variables that go with them most closely, of at most 200
/// motors. None with fewer than two quantities that scatter.
std::vector<Section> scatter_sections(const UncertaintyResult& answer, const ResultStore& rows);

}  // namespace twum::inline v0_1::studies::telling
