// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/gnuplot.hpp"

#include <limits>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// How the rows of a series are drawn, and what their columns are.
enum class Draw : unsigned char {
  line,       ///< x, y
  thin,       ///< x, y: a line as thin as one can see
  dashes,     ///< x, y
  dotted,     ///< x, y: a thin line
  steps,      ///< x, y
  dots,       ///< x, y
  rises,      ///< x, y: triangles that point up, for what has to be reached
  falls,      ///< x, y: triangles that point down, for what may not be exceeded
  band,       ///< x, low y, high y
  area,       ///< likewise, darker
  boxes,      ///< low x, high x, low y, high y
  cells,      ///< as boxes, and the value that is the colour
  image,      ///< x, y, and the value that is the colour: cells in rows, evenly spaced
  intervals,  ///< x, y, low x, high x
};

/// What one entry of the key stands for. Values in SI units, NaN where there is none.
struct Series {
  std::string name;  ///< in the key; empty: not there
  Draw draw{Draw::line};
  std::string colour;
  std::vector<std::vector<double>> rows;
};

/// One axis of a panel.
struct Axis {
  std::string name;  ///< with the unit behind it as its label
  std::string unit;  ///< SI; "%" for a share of 1
  bool zero{false};  ///< zero belongs to it
  double pad{0};     ///< room beyond the values, share of their span
  double low{
      std::numeric_limits<double>::quiet_NaN()};  ///< ends of the axis; NaN: those of the values
  double high{std::numeric_limits<double>::quiet_NaN()};
  std::vector<std::string> words{};  ///< what 0, 1, ... stand for, in place of numbers
  bool log{false};                   ///< of colours: by powers of ten
};

/// A point with a text beside it.
struct PointMark {
  double x, y;
  std::string text;
  bool dot{true};    ///< false: the text alone
  bool line{false};  ///< with a dotted upright line
};

/// A range of the horizontal axis, shaded from below to above.
struct Stretch {
  double from, to;
  std::string name;  ///< in the key
};

/// A line across the panel with a text beside it.
struct Guide {
  double at;
  bool upright;
  std::string text;
  std::string colour;
  bool dashed{false};
};

/// A chart with its axes.
struct Panel {
  Axis x, y;
  std::vector<Series> series;
  std::vector<PointMark> marks{};
  std::vector<Guide> guides{};
  Axis colours{};         ///< of cells
  std::size_t bands{0};   ///< how many colours they have; 0: each value its own
  bool one_scale{false};  ///< both axes have the same length for the same step, as a circle needs
  std::vector<Stretch> shaded{};
};

/// Panels below each other under one title, or in a matrix.
struct Chart {
  std::string title;
  std::vector<Panel> panels;
  bool shared{false};      ///< the panels have one horizontal axis
  std::size_t columns{0};  ///< panels in a row of a matrix; one without series is a gap
};

/// A picture: its script for gnuplot and the size of its page.
struct Picture {
  std::string name;  ///< of its file, without ending
  PlotSize size;
  std::string script;
};

/// The picture of a chart. Keys stand above their panel, so that they cover nothing.
Picture picture_of(const std::string& name, const Chart& chart);

/// The colour of the i-th of several things; seven differ.
const char* colour_of(std::size_t i);

/// The text with everything but letters, digits, dot and underscore as "-", for the name of a file.
std::string file_word(const std::string& text);

}  // namespace twum::inline v0_1::cli
