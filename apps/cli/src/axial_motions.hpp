// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motion/motion.hpp>

#include <array>

namespace twum::inline v0_1::cli {

/// Words of --axial.
inline constexpr std::array kAxialMotions{motion::AxialMotion::balanced,
                                          motion::AxialMotion::dynamic};

}  // namespace twum::inline v0_1::cli
