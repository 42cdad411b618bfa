// SPDX-License-Identifier: Apache-2.0
#include "plot/panel_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace twum::inline v0_1::cli {
namespace {

// The ends of an axis around these values.
Extent ends_of(const Axis& axis, Extent values) {
  if (axis.zero) values.add(0);
  if (!(values.low <= values.high)) values = {0, 1};
  const double size = std::max(std::abs(values.low), std::abs(values.high));
  const double span = values.high - values.low;
  // Values that differ by rounding only count as one value, drawn in the middle.
  const bool one = span <= 1e-9 * size || span == 0;
  const double room = one ? 0.1 * (size > 0 ? size : 1) : axis.pad * span;
  if (!(axis.zero && values.low == 0)) values.low -= room;
  if (!(axis.zero && values.high == 0) || one) values.high += room;
  if (std::isfinite(axis.low)) values.low = axis.low;
  if (std::isfinite(axis.high)) values.high = axis.high;
  return values;
}

studies::DisplayUnit unit_of_axis(const Axis& axis, const Extent& ends) {
  if (axis.unit == "%") return {"%", 0.01};
  return studies::display_unit(std::max(std::abs(ends.low), std::abs(ends.high)),
                               axis.unit.empty() ? "1" : axis.unit);
}

// Widens about its middle the axis that is drawn to the larger scale.
void to_one_scale(Extent& x, Extent& y, const Place& place) {
  const double width = place.right - place.left;
  const double height = place.bottom - place.top;
  const double step = std::max((x.high - x.low) / width, (y.high - y.low) / height);
  const auto widened = [&](const Extent& from, double length) {
    const double middle = 0.5 * (from.low + from.high);
    return Extent{middle - 0.5 * step * length, middle + 0.5 * step * length};
  };
  x = widened(x, width);
  y = widened(y, height);
}

}  // namespace

const Form& form_of(Draw draw) {
  static const std::array<Form, 14> kForms = {{
      {{0}, {1}, {0, 1}, "lines linewidth 2"},
      {{0}, {1}, {0, 1}, "lines linewidth 0.7"},
      {{0}, {1}, {0, 1}, "lines linewidth 1.6 dashtype 2"},
      {{0}, {1}, {0, 1}, "lines linewidth 1 dashtype '.'"},
      {{0}, {1}, {0, 1}, "steps linewidth 2"},
      {{0}, {1}, {0, 1}, "points pointtype 7"},
      {{0}, {1}, {0, 1}, "points pointtype 9 pointsize 1.1"},
      {{0}, {1}, {0, 1}, "points pointtype 11 pointsize 1.1"},
      {{0}, {1, 2}, {0, 1, 2}, "filledcurves fillstyle solid 0.25 noborder"},
      {{0}, {1, 2}, {0, 1, 2}, "filledcurves fillstyle solid 0.75 noborder"},
      {{0, 1}, {2, 3}, {0, 2, 0, 1, 2, 3}, "boxxyerror fillstyle solid 0.8 noborder"},
      {{0, 1}, {2, 3}, {0, 2, 0, 1, 2, 3, 4}, "boxxyerror fillstyle solid 1 noborder"},
      {{0}, {1}, {0, 1, 2}, "image"},
      {{0, 2, 3}, {1}, {0, 1, 2, 3}, "xerrorbars pointtype 7 pointsize 0.3 linewidth 1.3"},
  }};
  return kForms[static_cast<std::size_t>(draw)];
}

Scaled scaled(const Panel& panel, const Place& place) {
  Extent x, y, value;
  for (const Series& series : panel.series) {
    const Form& form = form_of(series.draw);
    for (const std::vector<double>& row : series.rows) {
      for (const std::size_t column : form.x) x.add(row[column]);
      for (const std::size_t column : form.y) y.add(row[column]);
      if (series.draw == Draw::cells) value.add(row[4]);
      if (series.draw == Draw::image) value.add(row[2]);
    }
  }
  for (const PointMark& mark : panel.marks) {
    x.add(mark.x);
    y.add(mark.y);
  }
  for (const Guide& guide : panel.guides) (guide.upright ? x : y).add(guide.at);
  x = ends_of(panel.x, x);
  y = ends_of(panel.y, y);
  value = ends_of(panel.colours, value);
  if (panel.one_scale) to_one_scale(x, y, place);
  return {panel,
          x,
          y,
          value,
          unit_of_axis(panel.x, x),
          unit_of_axis(panel.y, y),
          unit_of_axis(panel.colours, value),
          static_cast<double>(place.right - place.left),
          static_cast<double>(place.bottom - place.top)};
}

}  // namespace twum::inline v0_1::cli
