// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motion/motion.hpp>
#include <twum/studies/study.hpp>

#include <span>
#include <string_view>
#include <vector>

/// Names of what a motion has over time, and of the numbers that may be asked for; internal.
namespace twum::inline v0_1::studies {

/// A column of a motion behind its time.
struct MotionColumn {
  const char* name;
  const char* unit;
  double (*of)(const motion::MotionSample&);
  bool of_two_waves{false};  ///< of the oscillating engine only
};
/// All of them, in their order; static lifetime.
std::span<const MotionColumn> motion_columns();
/// The column of a name; null if there is none.
const MotionColumn* find_motion_column(std::string_view name);
/// The names of all, in their order.
std::vector<std::string_view> motion_column_names();

/// The measure that a text such as "time_to(speed, 90 %)" names. @throws ValueError
MotionMeasure motion_measure(std::string_view text);

}  // namespace twum::inline v0_1::studies
