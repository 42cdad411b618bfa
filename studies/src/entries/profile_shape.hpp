// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/shape.hpp>
#include <twum/motion/motion.hpp>

#include <string>
#include <vector>

/// Numbers and intervals over time in study files; internal.
namespace twum::inline v0_1::studies::shapes {

/// A value at all times, or rows [time, value].
Shape<motion::Profile> profile(std::string text, std::string unit, std::string example);

/// [begin, end], or more of such pairs in one list; intervals of rising times.
Shape<std::vector<motion::Interval>> intervals(std::string text);

}  // namespace twum::inline v0_1::studies::shapes
