// SPDX-License-Identifier: Apache-2.0
#include "telling/histogram.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

// More than 60 bars cannot be distinguished, and fewer than 8 show little of the shape.
double bins_for(std::size_t count) {
  return std::clamp(std::ceil(std::sqrt(static_cast<double>(count)) / 1.5), 8.0, 60.0);
}

}  // namespace

Bins counted_bins(const std::vector<double>& values, const Window& window) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double even = (*high - *low) / bins_for(values.size());
  const double open = window.upper - window.lower;
  const bool fits = std::isfinite(open) && open > (*high - *low) / 240;
  Bins bins{0, fits ? open / std::max(std::round(open / even), 1.0) : even, {}, {}};
  const double anchor = std::isfinite(window.lower)   ? window.lower
                        : std::isfinite(window.upper) ? window.upper
                                                      : *low;
  bins.first = anchor + std::floor((*low - anchor) / bins.width + 1e-9) * bins.width;
  const auto count =
      static_cast<std::size_t>(std::max(std::ceil((*high - bins.first) / bins.width - 1e-9), 1.0));
  bins.kept.assign(count, 0);
  bins.failed.assign(count, 0);
  // At an end of the window the limit itself decides the side, since edges are rounded.
  const auto bin_of = [&](double value) {
    const double to = (value - bins.first) / bins.width;
    const double edge = std::round(to);
    const bool on_edge = std::abs(to - edge) < 1e-9;
    const bool below = on_edge && (value < window.lower ||
                                   (value <= window.upper && edge > 0 &&
                                    std::abs(value - window.upper) <= 1e-9 * std::abs(value)));
    const double bin = on_edge ? (below ? edge - 1 : edge) : std::floor(to);
    return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(count - 1)));
  };
  for (const double value : values)
    ++(window.holds(value) ? bins.kept : bins.failed)[bin_of(value)];
  return bins;
}

}  // namespace twum::inline v0_1::studies::telling
