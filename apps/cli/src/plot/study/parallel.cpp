// SPDX-License-Identifier: Apache-2.0
#include "plot/study/parallel.hpp"

#include "plot/crowd.hpp"
#include "plot/panel_scale.hpp"
#include "plot/style.hpp"

#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace twum::inline v0_1::cli {
namespace {

// Points of the page.
constexpr int kPageWidth = 720, kMarginLeft = 30, kMarginRight = 30, kTitleHeight = 46,
              kAxisHeight = 60, kMarginBelow = 20;

// An axis across the page, under the last one.
struct PlacedAxis {
  const telling::Parallel::Quantity& axis;
  Extent ends;
  studies::DisplayUnit unit;
  int y;  // above the lower edge of the page

  double across(double value) const {
    return kMarginLeft +
           (kPageWidth - kMarginLeft - kMarginRight) * (value - ends.low) / (ends.high - ends.low);
  }
};

// Values that differ by rounding only count as one value, drawn in the middle.
Extent ends_of(const std::vector<double>& values) {
  Extent ends;
  for (const double value : values) ends.add(value);
  if (!(ends.low <= ends.high)) return {0, 1};
  const double size = std::max(std::abs(ends.low), std::abs(ends.high));
  if (ends.high - ends.low > 1e-6 * size) return ends;
  const double room = 0.1 * (size > 0 ? size : 1);
  return {ends.low - room, ends.high + room};
}

std::vector<PlacedAxis> placed(const std::vector<telling::Parallel::Quantity>& axes, int height) {
  std::vector<PlacedAxis> list;
  for (const telling::Parallel::Quantity& axis : axes) {
    const Extent ends = ends_of(axis.values.values);
    const double largest = std::max(std::abs(ends.low), std::abs(ends.high));
    const int y =
        height - kTitleHeight - kAxisHeight / 2 - kAxisHeight * static_cast<int>(list.size());
    list.push_back({axis, ends, studies::display_unit(largest, axis.unit), y});
  }
  return list;
}

std::string label(const std::string& text, double x, int y, const char* side) {
  return "set label " + plot_text(text) + " at " + plot_number(x) + ", " + std::to_string(y) + " " +
         side + " font 'Arial,11' noenhanced front boxed\n";
}

// Its line, its name above the left end, and the values of both ends below them.
std::string axis_text(const PlacedAxis& a) {
  const std::string y = std::to_string(a.y);
  const std::string unit =
      a.unit.text.empty() ? "" : " [" + studies::printed_unit(a.unit.text) + "]";
  const auto number = [&](double value) {
    return studies::rounded_text(value / a.unit.divisor, 3);
  };
  return "set arrow from " + std::to_string(kMarginLeft) + ", " + y + " to " +
         std::to_string(kPageWidth - kMarginRight) + ", " + y +
         " nohead front linewidth 1.5 linecolor rgb '#444444'\n" +
         label(read(a.axis.name) + unit, kMarginLeft, a.y + 15, "left") +
         label(number(a.ends.low), kMarginLeft, a.y - 13, "left") +
         label(number(a.ends.high), kPageWidth - kMarginRight, a.y - 13, "right");
}

// The line of a design, and a gap behind it.
void add_line(std::vector<std::vector<double>>& points, const std::vector<PlacedAxis>& axes,
              std::size_t row) {
  for (const PlacedAxis& a : axes)
    points.push_back({a.across(a.axis.values.values[row]), static_cast<double>(a.y)});
  points.push_back({std::nan(""), std::nan("")});
}

// The more lines, the fainter is each.
std::string colour_of_lines(std::size_t count) {
  constexpr double kFull = 0.85, kLeast = 0.05, kFew = 60;
  const double share = std::clamp(
      kFull * kFew / static_cast<double>(std::max<std::size_t>(count, 1)), kLeast, kFull);
  char text[16];
  std::snprintf(text, sizeof text, "#%02X", static_cast<unsigned>(std::lround(255 * (1 - share))));
  return text + std::string(colour::kBlue).substr(1);
}

}  // namespace

Picture parallel_picture(const std::string& title, const telling::Parallel& told) {
  const int height = kTitleHeight + kAxisHeight * static_cast<int>(told.axes.size()) + kMarginBelow;
  const std::vector<PlacedAxis> places = placed(told.axes, height);
  const std::vector<std::size_t> rows =
      shown_rows(told.axes.front().values.values.size(), telling::kMostLines);
  std::vector<std::vector<double>> points;
  for (const std::size_t row : rows) add_line(points, places, row);
  std::string script = plot_style(plot_text(studies::printable(title, 68)), height) +
                       plot_data("d0", points) +
                       "set lmargin at screen 0\nset rmargin at screen 1\n"
                       "set bmargin at screen 0\nset tmargin at screen 1\n"
                       "unset border\nunset xtics\nunset ytics\nunset grid\n"
                       "set style textbox opaque noborder margins 0.3, 0.2\n";
  script += "set xrange [0:" + std::to_string(kPageWidth) +
            "]\nset yrange [0:" + std::to_string(height) + "]\n";
  for (const PlacedAxis& a : places) script += axis_text(a);
  return {told.name,
          {kPageWidth, height},
          script + "plot $d0 using 1:2 with lines linewidth 1.2 linecolor rgb '" +
              colour_of_lines(rows.size()) + "' title ''\n"};
}

}  // namespace twum::inline v0_1::cli
