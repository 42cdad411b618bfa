// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/chart.hpp"

#include <twum/io/engineering.hpp>
#include <twum/studies/extent.hpp>

#include <cstddef>
#include <string>
#include <vector>

/// How values become places and units of a panel; for chart.cpp and its texts.
namespace twum::inline v0_1::cli {

/// What a series of one kind is to gnuplot.
struct Form {
  std::vector<std::size_t> x, y;   ///< columns on the axes
  std::vector<std::size_t> order;  ///< columns as gnuplot takes them
  const char* with;
};

/// Static lifetime.
const Form& form_of(Draw draw);

using studies::Extent;

/// Where a panel stands [points from the top and the left of the page].
struct Place {
  int top, bottom, left, right;
};

/// A panel with the ends and units of its axes.
struct Scaled {
  const Panel& panel;
  Extent x, y, value;
  studies::DisplayUnit x_unit, y_unit, value_unit;
  double width, height;  ///< [points of the page]

  /// Place of a value in the panel, 0 on the left or below, 1 on the right or above.
  double across(double at) const { return (at - x.low) / (x.high - x.low); }
  double up(double at) const { return (at - y.low) / (y.high - y.low); }
};

Scaled scaled(const Panel& panel, const Place& place);

/// The texts of marks and guides as labels of gnuplot.
std::string texts_of(const Scaled& scaled);

}  // namespace twum::inline v0_1::cli
