// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/geometry.hpp>

#include <string>

namespace twum::inline v0_1::cli {

/// Commands of gnuplot for the cross-section of a stator to scale, with the names of its parts.
/// @param top, bottom  of the panel [share of the page, from below]
std::string section_panel(const stator::StatorGeometry& geometry, double contact_radius,
                          double contact_width, double top, double bottom);

}  // namespace twum::inline v0_1::cli
