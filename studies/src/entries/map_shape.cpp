// SPDX-License-Identifier: Apache-2.0
// Maps over speed and torque.
#include "entries/entry_shapes.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace twum::inline v0_1::studies {

using namespace shapes;

namespace {

using Grid = MapStudy::Grid;

constexpr std::uint64_t kMost = 1000;  // points of an axis: a picture shows no more

std::optional<std::uint64_t> points_of(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && value >= 2 && value <= kMost ? std::optional(value) : std::nullopt;
}

std::string grid_text(const Grid& grid) {
  return std::to_string(grid.speeds) + "x" + std::to_string(grid.torques);
}

Shape<Metric> held_metric() {
  std::vector<std::string> names;
  for (const Metric metric : MapStudy::quantities()) names.emplace_back(info(metric).name);
  return shape_as<Metric, std::size_t>(
      choice("metric shown in the pictures, at a torque and a speed", std::move(names)),
      [](std::size_t number) { return MapStudy::quantities()[number]; },
      [](Metric metric) {
        const auto list = MapStudy::quantities();
        return static_cast<std::size_t>(std::ranges::find(list, metric) - list.begin());
      });
}

void more_than_zero(const Given& given, const char* name, const std::optional<double>& value,
                    Diagnostics& diagnostics) {
  const YamlNode* node = given.right(name);
  if (node != nullptr && !(*value > 0))
    diagnostics.add(node->mark, given.path(name), quoted(node->scalar),
                    "expected the upper end of the axis, more than 0");
}

bool check_map(MapStudy& study, const Given& given, Diagnostics& diagnostics) {
  more_than_zero(given, "torque", study.torque, diagnostics);
  more_than_zero(given, "speed", study.speed, diagnostics);
  const YamlNode* duty = given.right("duty");
  for (std::size_t i = 0; duty != nullptr && i < study.duty.size(); ++i)
    if (!(study.duty[i].speed > 0))
      diagnostics.add(duty->items[i].mark, given.path("duty") + "[" + std::to_string(i) + "].speed",
                      "a duty at rest, where friction holds the rotor without a wave",
                      "expected a speed of more than 0 rpm");
  return true;
}

}  // namespace

Grid Grid::parse(std::string_view text) {
  const std::size_t cross = text.find('x');
  const auto speeds = points_of(text.substr(0, cross));
  const auto torques =
      cross == std::string_view::npos ? std::nullopt : points_of(text.substr(cross + 1));
  if (speeds && torques) return {*speeds, *torques};
  throw ValueError(quoted(text), "expected the number of speeds and that of torques, each 2 to " +
                                     std::to_string(kMost) + ", such as 60x40");
}

std::span<const Metric> MapStudy::quantities() {
  static const std::vector<Metric> list = [] {
    std::vector<Metric> metrics;
    for (const MetricInfo& row : metric_table())
      if (row.argument == Argument::both || row.argument == Argument::speed_or_torque)
        metrics.push_back(row.metric);
    return metrics;
  }();
  return list;
}

Shape<MapStudy> MapStudy::shape() {
  using M = MapStudy;
  auto duty = list("operating points marked in the pictures", duty_point());
  duty.schema.sample = "- {torque: 0.5 N.m, speed: 100 rpm}";
  return mapping<M>(
      "efficiency, power, current and losses over speed and torque, for one motor or a family over "
      "one parameter",
      {kind_field<M>(),
       optional<M>("family", shapes::family("preload: [120 N, 160 N, 200 N]"), &M::family,
                   "the motor alone"),
       optional<M>("torque", io::quantity("largest torque of the map", "N.m", "1 N.m"), &M::torque,
                   "the largest that the drive can hold"),
       optional<M>("speed", io::quantity("largest speed of the map", "rad/s", "150 rpm"), &M::speed,
                   "the largest that the drive can hold"),
       standard<M>(
           "points",
           text_of<Grid>("number of speeds and of torques", "60x40", Grid::parse, grid_text),
           &M::points),
       hidden(optional<M>("quantity", held_metric(), &M::quantity,
                          "overall_efficiency_at, or efficiency_at without modal data")),
       optional<M>("duty", duty, &M::duty, "none")},
      check_map);
}

}  // namespace twum::inline v0_1::studies
