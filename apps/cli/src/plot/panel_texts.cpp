// SPDX-License-Identifier: Apache-2.0
#include "plot/panel_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace twum::inline v0_1::cli {
namespace {

// Size of the letters [points of the page].
constexpr double kLetterWidth = 6.9, kLetterHeight = 14;
// Room about a text on a line, as letters are reckoned roughly.
constexpr double kMargin = 5;

// Direction from a point to its text.
struct Side {
  int across, up;  // 1: to the right, above; -1: to the left, below; 0: centred
};

// A rectangle of the panel [points of the page].
struct Box {
  double left, right, low, high;

  bool holds(double x, double y) const { return x > left && x < right && y > low && y < high; }
  bool meets(const Box& o) const {
    return left < o.right && o.left < right && low < o.high && o.low < high;
  }
};

Box box_of(const PointMark& mark, const Scaled& s, Side side) {
  const double width = kLetterWidth * static_cast<double>(mark.text.size()) + 8;
  const double x = s.across(mark.x) * s.width, y = s.up(mark.y) * s.height;
  const double left = side.across > 0 ? x + 5 : side.across < 0 ? x - 5 - width : x - width / 2;
  const double low = side.up > 0   ? y + 3
                     : side.up < 0 ? y - 3 - kLetterHeight
                                   : y - kLetterHeight / 2;
  return {left, left + width, low, low + kLetterHeight};
}

// Points of a series inside a box; of a line with few points also places between them.
std::size_t points_of(const Series& series, const Box& box, const Scaled& s) {
  if (series.draw == Draw::image) return 0;
  const Form& form = form_of(series.draw);
  const int between = series.draw == Draw::line && series.rows.size() < 100 ? 20 : 1;
  std::size_t count = 0;
  for (std::size_t i = 0; i < series.rows.size(); ++i) {
    const std::vector<double>& a = series.rows[i];
    const std::vector<double>& b = series.rows[std::min(i + 1, series.rows.size() - 1)];
    for (int k = 0; k < between; ++k) {
      const double share = static_cast<double>(k) / between;
      const double x = s.across(std::lerp(a[form.x[0]], b[form.x[0]], share)) * s.width;
      const double y = s.up(std::lerp(a[form.y[0]], b[form.y[0]], share)) * s.height;
      count += box.holds(x, y) ? 1 : 0;
    }
  }
  return count;
}

std::size_t points_inside(const Box& box, const Scaled& s) {
  std::size_t count = 0;
  for (const Series& series : s.panel.series) count += points_of(series, box, s);
  for (const PointMark& mark : s.panel.marks)
    count += box.holds(s.across(mark.x) * s.width, s.up(mark.y) * s.height) ? 10 : 0;
  return count;
}

bool meets_any(const Box& box, const std::vector<Box>& others) {
  return std::ranges::any_of(others, [&](const Box& other) { return box.meets(other); });
}

bool is_outside(const Box& box, const Scaled& s) {
  return box.left < 0 || box.right > s.width || box.low < 0 || box.high > s.height;
}

// The side where a text covers the fewest points, inside the panel and off the texts that are there.
Side side_of(const PointMark& mark, const Scaled& s, const std::vector<Box>& taken) {
  constexpr std::array<Side, 8> kSides = {
      {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  Side best = kSides[0];
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Side side : kSides) {
    const Box box = box_of(mark, s, side);
    const std::size_t covered = points_inside(box, s) + (meets_any(box, taken) ? 10000 : 0) +
                                (is_outside(box, s) ? 100000 : 0);
    if (covered >= least) continue;
    least = covered;
    best = side;
  }
  return best;
}

std::string label_text(const PointMark& mark, const Scaled& s, Side side) {
  const char* align = side.across > 0 ? "left" : side.across < 0 ? "right" : "center";
  return "set label " + plot_text(mark.text) + " at first " +
         plot_number(mark.x / s.x_unit.divisor) + ", first " +
         plot_number(mark.y / s.y_unit.divisor) + " " + align + " offset character " +
         plot_number(0.8 * side.across) + ", character " + plot_number(0.75 * side.up) +
         " font 'Arial,11' noenhanced front " +
         (mark.dot ? "point pointtype 7 pointsize 0.8 linecolor rgb '#000000'\n" : "boxed\n");
}

// Dots with their texts; then texts alone, where there is room.
std::string marks_text(const Scaled& s) {
  std::string script;
  std::vector<Box> taken;
  for (const PointMark& mark : s.panel.marks) {
    if (!mark.dot) continue;
    const Side side = side_of(mark, s, taken);
    taken.push_back(box_of(mark, s, side));
    script += label_text(mark, s, side);
  }
  for (const PointMark& mark : s.panel.marks) {
    const Box text = box_of(mark, s, {0, 0});
    const Box box{text.left - kMargin, text.right + kMargin, text.low - kMargin,
                  text.high + kMargin};
    if (mark.dot || is_outside(box, s) || meets_any(box, taken)) continue;
    taken.push_back(box);
    script += label_text(mark, s, {0, 0});
  }
  return script;
}

// The texts of upright lines stand below each other on a white ground, so that lines close together stay legible.
std::string guides_text(const Scaled& s) {
  std::string script = "set style textbox opaque noborder margins 0.3, 0.2\n";
  int line = 0;
  for (const Guide& guide : s.panel.guides) {
    if (guide.text.empty()) continue;
    const std::string at =
        "first " + plot_number(guide.at / (guide.upright ? s.x_unit : s.y_unit).divisor);
    const bool right = guide.upright && s.across(guide.at) < 0.7;
    script += "set label " + plot_text(guide.text) + " at " +
              (guide.upright ? at + ", graph " + plot_number(0.96 - 0.06 * line++)
                             : "graph 0.99, " + at) +
              (right ? " left offset character 0.7, " : " right offset character -0.7, ") +
              (guide.upright ? "character 0" : "character 0.6") +
              " font 'Arial,11' noenhanced front boxed\n";
  }
  return script;
}

}  // namespace

std::string texts_of(const Scaled& scaled) { return guides_text(scaled) + marks_text(scaled); }

}  // namespace twum::inline v0_1::cli
