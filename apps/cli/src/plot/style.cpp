// SPDX-License-Identifier: Apache-2.0
#include "plot/style.hpp"

#include "plot/gnuplot.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::cli {
namespace {

// Letters that fill the width of the page in the large font, with room to spare.
constexpr std::size_t kLongTitle = 62;

std::string with_unit(const std::string& quantity, const studies::DisplayUnit& unit) {
  return plot_text(unit.text.empty() ? quantity
                                     : quantity + " [" + studies::printed_unit(unit.text) + "]");
}

}  // namespace

double largest(const std::vector<std::vector<double>>& rows, int from, int to) {
  double size = 0;
  for (const std::vector<double>& row : rows) {
    for (int column = from; column <= to; ++column) {
      const double value = std::abs(row[static_cast<std::size_t>(column - 1)]);
      if (std::isfinite(value)) size = std::max(size, value);
    }
  }
  return size;
}

std::string plot_style(const std::string& title, int height) {
  return "set border 3 linewidth 1 linecolor rgb '#444444'\n"
         "set tics nomirror out scale 0.5\n"
         "set grid ytics linetype 1 linewidth 0.5 linecolor rgb '#dddddd'\n"
         "set key at graph 0, graph 1.02 left bottom horizontal Left reverse samplen 2.2 "
         "noenhanced\n"
         "set label 99 " +
         title + " at screen 0.03, screen " + plot_number(1 - 24.0 / height) +
         " left font 'Arial," + (title.size() > kLongTitle ? "12" : "15") + "' noenhanced\n";
}

std::array<double, 2> band_about(double value, double largest) {
  const double half = 0.02 * largest;
  return {value >= 0 ? std::max(value - half, 0.0) : value - half, value + half};
}

std::string motor_title(const studies::MotorFile& file) {
  return file.name.empty() ? "motor" : studies::printable(file.name, 48);
}

std::string panel_place(double top, double bottom, bool last) {
  return "set lmargin at screen 0.115\nset rmargin at screen 0.97\nset tmargin at screen " +
         plot_number(top) + "\nset bmargin at screen " + plot_number(bottom) + "\n" +
         (last ? "set format x '%g'\n" : "set format x ''\nunset xlabel\n");
}

std::string vertical_label(const std::string& quantity, const studies::DisplayUnit& unit) {
  // As a label at a fixed place: the labels of all panels then stand below each other.
  return "set label 98 " + with_unit(quantity, unit) +
         " at screen 0.019, graph 0.5 center rotate noenhanced\n";
}

std::string horizontal_label(const std::string& quantity, const studies::DisplayUnit& unit) {
  return "set xlabel " + with_unit(quantity, unit) + " noenhanced\n";
}

std::string in_unit(int column, const studies::DisplayUnit& unit) {
  return "($" + std::to_string(column) + "/" + plot_number(unit.divisor) + ")";
}

}  // namespace twum::inline v0_1::cli
