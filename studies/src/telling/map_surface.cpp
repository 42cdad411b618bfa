// SPDX-License-Identifier: Apache-2.0
#include "telling/map_surface.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

// Cells of a picture: two or three of its points each.
constexpr std::size_t kColumns = 241, kRows = 161;

}  // namespace

MapSurface::MapSurface(const MapResult& map, const MapResult::Member& member, std::size_t column) {
  for (std::size_t i = 0; i < member.envelope.size(); ++i) {
    const MapResult::Corner& corner = member.envelope[i];
    if (!(corner.torque > 0)) continue;
    Column one{corner.speed, corner.torque, {}, {}};
    for (std::size_t j = 0; j < map.torques; ++j) {
      const MapResult::Point& point = member.points[i * map.torques + j];
      if (point.torque >= corner.torque) break;
      one.torques.push_back(point.torque);
      one.values.push_back(point.values[column]);
    }
    one.torques.push_back(corner.torque);
    one.values.push_back(corner.values[column]);
    columns_.push_back(std::move(one));
  }
  // At its largest speed the drive holds no torque.
  if (!columns_.empty() && member.largest_speed > largest_speed())
    columns_.push_back({member.largest_speed, 0, {0}, {columns_.back().values.front()}});
}

double MapSurface::on(const Column& column, double share) {
  const double torque = share * column.largest;
  const auto next = std::ranges::lower_bound(column.torques, torque);
  if (next == column.torques.end()) return column.values.back();
  const auto k = static_cast<std::size_t>(next - column.torques.begin());
  if (k == 0) return column.values.front();
  const double from = column.torques[k - 1], part = (torque - from) / (*next - from);
  return column.values[k - 1] + part * (column.values[k] - column.values[k - 1]);
}

double MapSurface::at(double speed, double torque) const {
  const auto next = std::ranges::lower_bound(columns_, speed, {}, &Column::speed);
  if (next == columns_.end() || (next == columns_.begin() && next->speed > speed))
    return std::nan("");
  if (next == columns_.begin())
    return torque <= next->largest ? on(*next, torque / next->largest) : std::nan("");
  const Column &a = *(next - 1), &b = *next;
  const double part = (speed - a.speed) / (b.speed - a.speed);
  const double largest = a.largest + part * (b.largest - a.largest);
  const double share = largest > 0 ? torque / largest : torque > 0 ? 2 : 0;
  if (share > 1) return std::nan("");
  return on(a, share) + part * (on(b, share) - on(a, share));
}

ValueGrid MapSurface::fine(const MapResult& map) const {
  ValueGrid grid{kColumns,   kRows, map.speed / static_cast<double>(map.speeds), map.speed, 0,
                 map.torque, {}};
  for (std::size_t j = 0; j < kRows; ++j)
    for (std::size_t i = 0; i < kColumns; ++i)
      grid.values.push_back(at(grid.x(static_cast<double>(i)), grid.y(static_cast<double>(j))));
  return grid;
}

}  // namespace twum::inline v0_1::studies::telling
