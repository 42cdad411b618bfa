// SPDX-License-Identifier: Apache-2.0
#include "plot/chart.hpp"

#include "plot/panel_scale.hpp"
#include "plot/style.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace twum::inline v0_1::cli {
namespace {

// Points of the page.
constexpr int kWidth = 720, kTitle = 46, kPanel = 210, kAlone = 330, kBelow = 66, kBetween = 18;
constexpr int kCell = 170, kCellGap = 14;  // of a matrix
constexpr int kLeft = 92, kRight = 24, kScale = 112, kBar = 30, kKeyLine = 18;
// Width of a letter beside an axis.
constexpr double kLetter = 8.2;
// Fewer points than these are drawn larger.
constexpr std::size_t kFew = 300;

std::size_t longest(const std::vector<std::string>& words) {
  std::size_t length = 0;
  for (const std::string& word : words) length = std::max(length, word.size());
  return length;
}

std::vector<std::string> key_of(const Panel& panel) {
  std::vector<std::string> names;
  for (const Series& series : panel.series)
    if (!series.name.empty()) names.push_back(series.name);
  for (const Stretch& one : panel.shaded) names.push_back(one.name);
  return names;
}

// gnuplot gives every entry of a key the width of the longest, and reckons with wide letters.
int key_lines(const Panel& panel, int width) {
  const std::vector<std::string> names = key_of(panel);
  const double entry = 9.6 * static_cast<double>(longest(names)) + 70;
  const int beside = std::max(1, static_cast<int>(width / entry));
  return (static_cast<int>(names.size()) + beside - 1) / beside;
}

Place place_of(const Panel& panel, int top, int chart_height) {
  const bool words = !panel.y.words.empty();
  const int left =
      words ? 24 + std::min(340,
                            static_cast<int>(kLetter * static_cast<double>(longest(panel.y.words))))
            : kLeft;
  const int right = kWidth - (panel.colours.name.empty() ? kRight : kScale);
  const int height = words ? kBar * static_cast<int>(panel.y.words.size()) + 8 : chart_height;
  const int above = std::max(kKeyLine * key_lines(panel, right - left) + 6, 10);
  return {top + above, top + above + height, left, right};
}

std::string range_text(const char* axis, const Extent& ends, double divisor) {
  return std::string("set ") + axis + "range [" + plot_number(ends.low / divisor) + ":" +
         plot_number(ends.high / divisor) + "]\n";
}

std::string word_tics(const std::vector<std::string>& words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list += (i > 0 ? ", " : "") + plot_text(words[i]) + " " + std::to_string(i);
  return "set ytics nomirror scale 0 (" + list + ") noenhanced\n";
}

// Which axes of a panel have names and numbers.
struct Labels {
  bool across{true}, up{true};
};

std::string axes_of(const Scaled& s, const Labels& labels) {
  const Panel& panel = s.panel;
  std::string script =
      range_text("x", s.x, s.x_unit.divisor) + range_text("y", s.y, s.y_unit.divisor);
  script += panel.y.words.empty()
                ? "set ytics nomirror scale 0.5 autofreq\n" + vertical_label(panel.y.name, s.y_unit)
                : word_tics(panel.y.words);
  if (!labels.up) script += "set format y ''\nunset ylabel\n";
  script += labels.across ? "set format x '%g'\n" + horizontal_label(panel.x.name, s.x_unit)
                          : "set format x ''\nunset xlabel\n";
  if (panel.colours.name.empty()) return script;
  return script + (panel.colours.log ? "set" : "unset") + " logscale cb\n" +
         range_text("cb", s.value, s.value_unit.divisor) + "set cblabel " +
         plot_text(panel.colours.name +
                   (s.value_unit.text.empty()
                        ? ""
                        : " [" + studies::printed_unit(s.value_unit.text) + "]")) +
         " noenhanced\nset palette maxcolors " + std::to_string(panel.bands) +
         " defined (0 '#0B2F52', 0.35 '#0072B2', 0.7 '#8CC5E3', 1 '#F6E8B1')\n";
}

// Lines across the panel are series over the others and below all texts; what is shaded and dotted is behind them.
std::vector<Series> with_guides(const Scaled& s) {
  std::vector<Series> all;
  for (const Stretch& one : s.panel.shaded)
    all.push_back({one.name, Draw::boxes, "#E3ECD8", {{one.from, one.to, s.y.low, s.y.high}}});
  for (const PointMark& mark : s.panel.marks)
    if (mark.line)
      all.push_back({"", Draw::dotted, "#666666", {{mark.x, s.y.low}, {mark.x, s.y.high}}});
  all.insert(all.end(), s.panel.series.begin(), s.panel.series.end());
  for (const Guide& guide : s.panel.guides) {
    const std::vector<std::vector<double>> ends =
        guide.upright ? std::vector<std::vector<double>>{{guide.at, s.y.low}, {guide.at, s.y.high}}
                      : std::vector<std::vector<double>>{{s.x.low, guide.at}, {s.x.high, guide.at}};
    all.push_back({"", guide.dashed ? Draw::dashes : Draw::line, guide.colour, ends});
  }
  return all;
}

bool contains(const std::vector<std::size_t>& list, std::size_t one) {
  return std::find(list.begin(), list.end(), one) != list.end();
}

// Dots are larger where there are few of them in the panel.
std::size_t most_dots(const Panel& panel) {
  std::size_t most = 0;
  for (const Series& series : panel.series)
    if (series.draw == Draw::dots) most = std::max(most, series.rows.size());
  return most;
}

std::string series_text(const Scaled& s, std::size_t number, const Series& series) {
  const Form& form = form_of(series.draw);
  std::string columns;
  for (const std::size_t column : form.order) {
    const studies::DisplayUnit& unit = contains(form.x, column)   ? s.x_unit
                                       : contains(form.y, column) ? s.y_unit
                                                                  : s.value_unit;
    columns += (columns.empty() ? "" : ":") + in_unit(static_cast<int>(column) + 1, unit);
  }
  const std::string colour =
      series.draw == Draw::image   ? ""
      : series.draw == Draw::cells ? " fillcolor palette"
      : series.draw == Draw::boxes || series.draw == Draw::band || series.draw == Draw::area
          ? " fillcolor rgb '" + series.colour + "'"
          : " linecolor rgb '" + series.colour + "'";
  const std::string size =
      series.draw == Draw::dots
          ? std::string(most_dots(s.panel) < kFew ? " pointsize 0.8" : " pointsize 0.4")
          : "";
  return "$d" + std::to_string(number) + " using " + columns + " with " + form.with + size +
         colour + " title " + plot_text(series.name);
}

std::string margins(const Place& place, const PlotSize& page) {
  const auto share = [](int part, int whole) {
    return plot_number(static_cast<double>(part) / whole);
  };
  return "set lmargin at screen " + share(place.left, page.width) + "\nset rmargin at screen " +
         share(place.right, page.width) + "\nset tmargin at screen " +
         share(page.height - place.top, page.height) + "\nset bmargin at screen " +
         share(page.height - place.bottom, page.height) + "\n";
}

std::string draw_panel_at(const Panel& panel, const Place& place, const PlotSize& page,
                          const Labels& labels, std::size_t& number) {
  const Scaled s = scaled(panel, place);
  std::string data, plots;
  for (const Series& series : with_guides(s)) {
    if (series.rows.empty()) continue;
    data += plot_data("d" + std::to_string(number), series.rows);
    plots += (plots.empty() ? "plot " : ", ") + series_text(s, number, series);
    ++number;
  }
  if (plots.empty()) plots = "plot NaN title ''";  // an empty panel with its axes
  return data + margins(place, page) + axes_of(s, labels) + texts_of(s) + plots +
         "\nunset label\nunset arrow\nunset object\n" + (labels.up ? "" : "set format y '%g'\n");
}

// A matrix: names and numbers stand at its left and below.
Picture matrix_picture(const std::string& name, const Chart& chart) {
  const auto columns = static_cast<int>(chart.columns);
  const int rows = (static_cast<int>(chart.panels.size()) + columns - 1) / columns;
  const int top = kTitle + 2 * kKeyLine;
  const PlotSize page{kLeft + columns * (kCell + kCellGap) + kRight,
                      top + rows * (kCell + kCellGap) + 3 * kBelow / 2};
  std::string script = plot_style(plot_text(studies::printable(chart.title, 84)), page.height) +
                       "set xtics rotate by 90 right\nset multiplot\n";
  std::size_t number = 0;
  for (int i = 0; i < static_cast<int>(chart.panels.size()); ++i) {
    const Panel& panel = chart.panels[static_cast<std::size_t>(i)];
    if (panel.series.empty()) continue;
    const int row = i / columns, column = i % columns;
    const int left = kLeft + column * (kCell + kCellGap), above = top + row * (kCell + kCellGap);
    script += draw_panel_at(panel, {above, above + kCell, left, left + kCell}, page,
                            {row + 1 == rows, column == 0}, number);
  }
  return {name, page, script + "unset multiplot\n"};
}

}  // namespace

Picture picture_of(const std::string& name, const Chart& chart) {
  if (chart.columns > 0) return matrix_picture(name, chart);
  std::vector<Place> places;
  int top = kTitle;
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    places.push_back(place_of(chart.panels[i], top, chart.panels.size() == 1 ? kAlone : kPanel));
    const bool labelled = !chart.shared || i + 1 == chart.panels.size();
    top = places.back().bottom + (labelled ? kBelow : kBetween);
  }
  std::string script =
      plot_style(plot_text(studies::printable(chart.title, 84)), top) + "set multiplot\n";
  std::size_t number = 0;
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    const bool labelled = !chart.shared || i + 1 == chart.panels.size();
    script += draw_panel_at(chart.panels[i], places[i], {kWidth, top}, {labelled, true}, number);
  }
  return {name, {kWidth, top}, script + "unset multiplot\n"};
}

const char* colour_of(std::size_t i) {
  constexpr std::array<const char*, 7> kColours = {
      colour::kBlue, colour::kVermilion, colour::kGreen, colour::kOrange,
      "#CC79A7",     "#56B4E9",          colour::kGrey};
  return kColours[i % kColours.size()];
}

std::string file_word(const std::string& text) {
  std::string word;
  for (const char letter : text) {
    const bool kept =
        std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '.';
    if (kept)
      word += letter;
    else if (!word.empty() && word.back() != '-')
      word += '-';
  }
  while (word.ends_with('-')) word.pop_back();
  return word.substr(0, 60);
}

}  // namespace twum::inline v0_1::cli
