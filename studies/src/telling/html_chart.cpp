// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/html_parts.hpp"

#include <twum/base/no_value.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies::telling {
namespace {

// Height and left edge of the plane within the axes; room at its right, for a title above and for an axis below [pixels].
constexpr double kPlaneHeight = 204, kPlaneLeft = 62, kRight = 12, kTitle = 26, kBelow = 45;
constexpr double kNoTitle = 8;
constexpr double kRoom = 0.05;  // about the values, in parts of their range

// These can be read on white and on black.
std::string svg_colour(const std::string& name) {
  static constexpr std::array<const char*, 7> kColours{"#3a8fc2", "#e0701c", "#16a37f", "#9a5cff",
                                                       "#a8862a", "#d0406a", "#808080"};
  if (name == "ink") return "currentColor";
  if (name == "faint") return "#bbb";
  return name.starts_with('c') ? kColours.at(static_cast<std::size_t>(name.at(1) - '0')) : "#999";
}

std::string pixels(double value) { return rounded_text(value, 5); }
std::string pixels(double x, double y) { return pixels(x) + " " + pixels(y); }

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + value + "\"";
}

// An axis between two pixels.
class PixelAxis {
 public:
  PixelAxis(const Axis& told, const std::vector<double>& values) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double low = told.zero ? 0 : kInfinity, high = told.zero ? 0 : -kInfinity;
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value), high = std::max(high, value);
    }
    if (low > high) low = high = 0;
    const double range = high > low ? high - low : std::max(std::fabs(low), 1e-12);
    low_ = std::isfinite(told.low) ? told.low : low - (low == 0 ? 0 : kRoom * range);
    high_ = std::isfinite(told.high) ? told.high : high + kRoom * range;
    const double size = std::max(std::fabs(low_), std::fabs(high_));
    unit_ = told.unit == "%" ? DisplayUnit{"%", 0.01} : display_unit(size, told.unit);
    const std::string unit = unit_.text.empty() ? "" : " [" + printed_unit(unit_.text) + "]";
    name_ = written(capitalized(told.name), Writing::page) + unit;
  }

  void put(double from, double to) { from_ = from, to_ = to; }
  const std::string& name() const { return name_; }
  double range() const { return high_ - low_; }
  double at(double value) const { return from_ + (value - low_) / (high_ - low_) * (to_ - from_); }

  struct Tick {
    double at;
    std::string text;
  };
  /// At multiples of 1, 2 or 5 times a power of ten, with room for their texts [pixels].
  std::vector<Tick> ticks(double room) const {
    const double least = range() / unit_.divisor * std::min(room / std::fabs(to_ - from_), 1.0);
    const double power = std::pow(10, std::floor(std::log10(least)));
    double step = power;
    for (const double factor : {2, 5, 10})
      if (step < least) step = factor * power;
    std::vector<Tick> ticks;
    for (double i = std::ceil(low_ / unit_.divisor / step); i * step <= high_ / unit_.divisor; ++i)
      ticks.push_back({at(i * step * unit_.divisor), rounded_text(i * step + 0.0, 6)});
    return ticks;
  }

 private:
  double from_{0}, to_{1}, low_{0}, high_{0};
  DisplayUnit unit_;
  std::string name_;
};

void append_values(std::vector<double>& to, const Numbers& numbers) {
  to.insert(to.end(), numbers.values.begin(), numbers.values.end());
}

std::vector<double> x_values(const Chart& chart) {
  std::vector<double> values{};
  if (chart.field.columns > 0) values = {chart.field.left, chart.field.right};
  for (const Series& series : chart.series) append_values(values, series.x);
  for (const Mark& mark : chart.marks) values.push_back(mark.x);
  return values;
}

std::vector<double> y_values(const Chart& chart) {
  std::vector<double> values{};
  if (chart.field.columns > 0) values = {chart.field.bottom, chart.field.top};
  for (const Series& series : chart.series) {
    for (const Numbers* numbers : {&series.y, &series.low, &series.high})
      append_values(values, *numbers);
    if (series.stroke == Stroke::bars) values.push_back(0);
  }
  for (const Mark& mark : chart.marks) values.push_back(mark.y);
  return values;
}

class SvgChart {
 public:
  SvgChart(const Chart& chart, double width)
      : chart_(chart),
        width_(width),
        top_(chart.title.empty() ? kNoTitle : kTitle),
        right_(width - kRight),
        bottom_(top_ + kPlaneHeight),
        x_(chart.x, x_values(chart)),
        y_(chart.y, y_values(chart)) {
    if (chart.one_scale) {
      const double scale = std::min((right_ - kPlaneLeft) / x_.range(), kPlaneHeight / y_.range());
      right_ = kPlaneLeft + scale * x_.range();
      bottom_ = top_ + scale * y_.range();
    }
    x_.put(kPlaneLeft, right_);
    y_.put(bottom_, top_);
  }

  std::string svg() {
    add_plane();
    add_axes();
    for (std::size_t i = 0; i < chart_.guides.size(); ++i) add_guide(chart_.guides[i], i);
    for (const Mark& mark : chart_.marks) add_mark(mark);
    const std::string box = "0 0 " + pixels(width_, bottom_ + kBelow);
    return "<svg" + attribute("viewBox", box) + attribute("style", "width: 100%; height: auto") +
           attribute("font-size", "11") + attribute("fill", "currentColor") + ">\n" + body_ +
           "</svg>\n";
  }

 private:
  void add_text(double x, double y, const std::string& text, const std::string& more = {}) {
    body_ += "<text" + attribute("x", pixels(x)) + attribute("y", pixels(y)) + more + ">" +
             harmless(text) + "</text>\n";
  }

  void add_path(const std::string& points, const std::string& colour,
                const std::string& more = {}) {
    if (points.empty()) return;
    body_ += "<path" + attribute("d", points) + attribute("fill", "none") +
             attribute("stroke", colour) + more + "/>\n";
  }

  void add_area(const std::string& points, const std::string& colour, double opacity) {
    body_ += "<path" + attribute("d", points) + attribute("fill", colour) +
             attribute("fill-opacity", rounded_text(opacity, 2)) +
             attribute("shape-rendering", "crispEdges") + "/>\n";  // no seams between areas
  }

  // What lies beyond the ends of the axes is not shown.
  void add_plane() {
    const double wide = right_ - kPlaneLeft, high = bottom_ - top_;
    body_ += "<svg" + attribute("x", pixels(kPlaneLeft)) + attribute("y", pixels(top_)) +
             attribute("width", pixels(wide)) + attribute("height", pixels(high)) +
             attribute("viewBox", pixels(kPlaneLeft, top_) + " " + pixels(wide, high)) + ">\n";
    add_field();
    for (const Stretch& one : chart_.shaded)
      add_area("M" + pixels(x_.at(one.from), top_) + "H" + pixels(x_.at(one.to)) + "V" +
                   pixels(bottom_) + "H" + pixels(x_.at(one.from)) + "Z",
               svg_colour("soft"), 0.15);
    for (const Series& series : chart_.series) add_series(series);
    body_ += "</svg>\n";
  }

  void add_axes() {
    const std::string middle = attribute("text-anchor", "middle");
    const std::string thin = attribute("stroke-opacity", "0.2");
    if (!chart_.title.empty())
      add_text(kPlaneLeft, 14, written(capitalized(chart_.title), Writing::page),
               attribute("font-weight", "bold"));
    for (const PixelAxis::Tick& tick : x_.ticks(55)) {
      add_path("M" + pixels(tick.at, top_) + "V" + pixels(bottom_), "currentColor", thin);
      add_text(tick.at, bottom_ + 14, tick.text, middle);
    }
    for (const PixelAxis::Tick& tick : y_.ticks(29)) {
      add_path("M" + pixels(kPlaneLeft, tick.at) + "H" + pixels(right_), "currentColor", thin);
      add_text(kPlaneLeft - 5, tick.at + 4, tick.text, attribute("text-anchor", "end"));
    }
    add_text((kPlaneLeft + right_) / 2, bottom_ + 32, x_.name(), middle);
    const std::string place = pixels(13, (top_ + bottom_) / 2);
    add_text(0, 0, y_.name(),
             middle + attribute("transform", "translate(" + place + ") rotate(-90)"));
  }

  // Cells of one band side by side are one area.
  void add_field() {
    const Field& field = chart_.field;
    if (field.levels.size() < 2 || field.columns < 2 || field.rows < 2) return;
    const double wide = (field.right - field.left) / static_cast<double>(field.columns - 1);
    const double high = (field.top - field.bottom) / static_cast<double>(field.rows - 1);
    for (std::size_t j = 0; j < field.rows; ++j) {
      const double y = field.bottom + (static_cast<double>(j) - 0.5) * high;
      for (std::size_t i = 0, end = 0; i < field.columns; i = end) {
        const auto* row = &field.bands[j * field.columns];
        for (end = i; end < field.columns && row[end] == row[i];) ++end;
        if (row[i] < 0) continue;
        const double left = field.left + (static_cast<double>(i) - 0.5) * wide;
        const double right = field.left + (static_cast<double>(end) - 0.5) * wide;
        add_area("M" + pixels(x_.at(left), y_.at(y)) + "H" + pixels(x_.at(right)) + "V" +
                     pixels(y_.at(y + high)) + "H" + pixels(x_.at(left)) + "Z",
                 svg_colour("c0"), (row[i] + 1.0) / static_cast<double>(field.levels.size() - 1));
      }
    }
  }

  void add_series(const Series& series) {
    const std::string colour = svg_colour(series.colour);
    if (!series.low.values.empty()) add_band(series, colour);
    switch (series.stroke) {
      case Stroke::bars: return add_bars(series, colour);
      case Stroke::area:  // its edge shows where it is too thin
        add_path(line(series) + "Z", colour);
        return add_area(line(series) + "Z", colour, 0.85);
      case Stroke::cells: return;  // maps of a sweep are on pages and pictures
      case Stroke::dots: return add_dots(series, colour);
      case Stroke::dashes:
        return add_path(line(series), colour, attribute("stroke-dasharray", "5 4"));
      case Stroke::contour: return add_path(line(series), colour, attribute("stroke-width", "0.7"));
      case Stroke::line:
      case Stroke::steps:
      case Stroke::path:
      case Stroke::stack:
      case Stroke::outline: return add_path(line(series), colour, attribute("stroke-width", "1.6"));
    }
  }

  // True for a point that no eye tells from the last one drawn.
  static bool is_near(double x, double y, double last_x, double last_y) {
    constexpr double kSeen = 0.4;  // pixels
    return std::fabs(x - last_x) < kSeen && std::fabs(y - last_y) < kSeen;
  }

  // A value that is none interrupts the line.
  std::string line(const Series& series) const {
    std::string points;
    double last_x = kNoValue, last_y = kNoValue;
    for (std::size_t i = 0; i < series.y.values.size(); ++i) {
      const double x = x_.at(series.x.values[i]), y = y_.at(series.y.values[i]);
      const bool known = std::isfinite(x) && std::isfinite(y), drawing = std::isfinite(last_x);
      const bool end = i + 1 == series.y.values.size();
      if (known && !end && is_near(x, y, last_x, last_y)) continue;
      if (known && drawing && series.stroke == Stroke::steps) points += "H" + pixels(x);
      if (known) points += (drawing ? "L" : "M") + pixels(x, y);
      if (known && series.stroke == Stroke::outline)
        points += "H" + pixels(x_.at(series.x.values[i + 1]));
      last_x = known ? x : kNoValue, last_y = y;
    }
    return points;
  }

  void add_dots(const Series& series, const std::string& colour) {
    std::string points;
    double last_x = kNoValue, last_y = kNoValue;
    for (std::size_t i = 0; i < series.y.values.size(); ++i) {
      const double x = x_.at(series.x.values[i]), y = y_.at(series.y.values[i]);
      if (!std::isfinite(x) || !std::isfinite(y) || is_near(x, y, last_x, last_y)) continue;
      points += "M" + pixels(x, y) + "h0";
      last_x = x, last_y = y;
    }
    constexpr std::size_t kMany = 300;
    add_path(points, colour,
             attribute("stroke-width", series.y.values.size() > kMany ? "3" : "5") +
                 attribute("stroke-linecap", "round"));
  }

  void add_bars(const Series& series, const std::string& colour) {
    std::string points;
    for (std::size_t i = 0; i < series.y.values.size(); ++i)
      if (std::isfinite(series.y.values[i]))
        points += "M" + pixels(x_.at(series.x.values[i]), y_.at(0)) + "V" +
                  pixels(y_.at(series.y.values[i])) + "H" + pixels(x_.at(series.x.values[i + 1])) +
                  "V" + pixels(y_.at(0)) + "Z";
    add_area(points, colour, 0.7);
  }

  // There along the lower edge, and back along the upper one.
  void add_band(const Series& series, const std::string& colour) {
    std::string there, back;
    for (std::size_t i = 0; i < series.low.values.size(); ++i) {
      if (!std::isfinite(series.low.values[i]) || !std::isfinite(series.high.values[i])) continue;
      const double x = x_.at(series.x.values[i]);
      there += (there.empty() ? "M" : "L") + pixels(x, y_.at(series.low.values[i]));
      back.insert(0, "L" + pixels(x, y_.at(series.high.values[i])));
    }
    add_area(there + back, colour, 0.2);
  }

  bool is_inside(double x, double y) const {
    return x >= kPlaneLeft && x <= right_ && y >= top_ && y <= bottom_;
  }

  // Texts of neighbours are on different heights.
  void add_guide(const Guide& guide, std::size_t number) {
    const bool level = guide.kind == Guide::Kind::level;
    const double at = level ? y_.at(guide.at) : x_.at(guide.at);
    if (!is_inside(level ? kPlaneLeft : at, level ? at : top_)) return;
    add_path(level ? "M" + pixels(kPlaneLeft, at) + "H" + pixels(right_)
                   : "M" + pixels(at, top_) + "V" + pixels(bottom_),
             svg_colour(guide.kind == Guide::Kind::quantile ? "soft" : "c1"),
             attribute("stroke-dasharray", "3 3"));
    const bool right = !level && at > (kPlaneLeft + right_) / 2;
    add_text(level ? right_ - 4 : at + (right ? -4 : 4),
             level ? at - 4 : top_ + 11 + 12 * static_cast<double>(number % 3),
             written(guide.text, Writing::page),
             attribute("text-anchor", level || right ? "end" : "start"));
  }

  void add_mark(const Mark& mark) {
    const double x = x_.at(mark.x), y = y_.at(mark.y);
    if (!is_inside(x, y)) return;
    if (mark.line)
      add_path("M" + pixels(x, top_) + "V" + pixels(bottom_), svg_colour("soft"),
               attribute("stroke-dasharray", "2 3"));
    if (mark.dot)
      add_path("M" + pixels(x, y) + "h0", svg_colour(mark.colour),
               attribute("stroke-width", "7") + attribute("stroke-linecap", "round"));
    const bool right = x > (kPlaneLeft + right_) / 2;
    if (!mark.text.empty())
      add_text(x + (right ? -6 : 6), y - 4, written(mark.text, Writing::page),
               attribute("text-anchor", right ? "end" : "start"));
  }

  const Chart& chart_;
  double width_, top_, right_, bottom_;
  PixelAxis x_, y_;
  std::string body_;
};

std::string key_entry(const std::string& colour, const std::string& name) {
  return "<span style=\"color: " + colour + "\">&#9632;</span>&#160;" + harmless(name) + " &#160; ";
}

// Names of the series, each once, and what the field shows.
std::string key(const Chart& chart) {
  std::string text;
  std::vector<std::string> named;
  const auto add = [&](const std::string& colour, const std::string& name) {
    if (name.empty() || std::ranges::find(named, name) != named.end()) return;
    named.push_back(name);
    text += key_entry(svg_colour(colour), name);
  };
  for (const Series& series : chart.series)
    add(series.colour, series.name), add(series.colour, series.band);
  for (const Stretch& one : chart.shaded) add("faint", one.name);
  const Field& field = chart.field;
  if (field.levels.size() < 2) return text;
  const auto level = [&](double value) {
    return written(field.unit == "%" ? share_part(value) : value_part(value, field.unit),
                   Writing::page);
  };
  return key_entry(svg_colour("c0"), written(field.name, Writing::page) + " from " +
                                         level(field.levels.front()) + " (light) to " +
                                         level(field.levels.back()) + " (dark)") +
         text;
}

}  // namespace

std::string html(const Chart& chart, double width) {
  return "<div style=\"display: inline-block; vertical-align: top; width: 100%; max-width: " +
         pixels(width) + "px\">\n" + SvgChart(chart, width).svg() + "<div>" + key(chart) +
         "</div>\n</div>\n";
}

}  // namespace twum::inline v0_1::studies::telling
