// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/engineering.hpp>
#include <twum/motors/motor_file.hpp>

#include <array>
#include <numbers>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// Colours that stay apart for every kind of colour vision (Okabe and Ito), and in grey by lightness.
namespace colour {
inline constexpr const char* kBlue = "#0072B2";
inline constexpr const char* kVermilion = "#D55E00";
inline constexpr const char* kGreen = "#009E73";
inline constexpr const char* kOrange = "#E69F00";
inline constexpr const char* kGrey = "#666666";
inline constexpr const char* kPurple = "#CC79A7";
}  // namespace colour

inline constexpr double kDegree = std::numbers::pi / 180;  ///< [rad]

/// Largest magnitude in the columns of a plot, counted from 1; NaN are left out.
double largest(const std::vector<std::vector<double>>& rows, int from, int to);

/// Borders, tics, grid and key that all panels share, and the title of the whole picture.
/// @param title   already quoted by plot_text()
/// @param height  of the page [points]
std::string plot_style(const std::string& title, int height = 860);

/// A band about a point of a line that marks a part of the line. It does not reach below zero from above.
/// @param largest  value of the line
/// @returns its edges; NaN where the value is NaN
std::array<double, 2> band_about(double value, double largest);

/// The motor's name as a title, not too long for the page.
std::string motor_title(const studies::MotorFile& file);

/// Where a panel stands [share of the page, from below]; the last one carries the numbers of the
/// common horizontal axis.
std::string panel_place(double top, double bottom, bool last);

/// Labels the axes of a panel, as in "torque [N.m]".
std::string vertical_label(const std::string& quantity, const studies::DisplayUnit& unit);
std::string horizontal_label(const std::string& quantity, const studies::DisplayUnit& unit);

/// A column in the unit of its axis: "($2/1e-3)".
std::string in_unit(int column, const studies::DisplayUnit& unit);

}  // namespace twum::inline v0_1::cli
