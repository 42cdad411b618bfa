// SPDX-License-Identifier: Apache-2.0
#include "plot/fields_plot.hpp"
#include "plot/style.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

constexpr int kRadii = 81, kPhases = 361;

using Rows = std::vector<std::vector<double>>;

struct FieldsMap {
  Rows cells;  // phase [deg], radius [mm], pressure, slip speed; NaN where nothing touches
  Rows stick;  // ends of stick zones: phase [deg], radius [mm]
  double edge{0};
  double pressure{0}, slip{0};  // the largest
  OperatingPoint point;
};

FieldsMap map_of(const MotorDesign& design, double speed) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Motor motor(design);
  const double inner = design.stator.contact_radius - 0.5 * design.stator.contact_width;
  FieldsMap map;
  for (int i = 0; i < kRadii; ++i) {
    const double radius = inner + design.stator.contact_width * i / (kRadii - 1);
    const ContactFields fields = motor.fields(speed, kPhases, radius);
    map.point = fields.point;
    for (const FieldSample& s : fields.samples) {
      const bool touches = s.pressure > 0;
      const double slip = std::fabs(s.layer_velocity - s.stator_velocity);
      map.cells.push_back(
          {s.phase / kDegree, 1e3 * radius, touches ? s.pressure : kNone, touches ? slip : kNone});
      if (!touches) continue;
      map.edge = std::max(map.edge, std::fabs(s.phase) / kDegree);
      map.pressure = std::max(map.pressure, s.pressure);
      map.slip = std::max(map.slip, slip);
    }
    for (const Zone& zone : fields.zones) {
      if (zone.state != ZoneState::stick) continue;
      map.stick.push_back({zone.from / kDegree, 1e3 * radius});
      map.stick.push_back({zone.to / kDegree, 1e3 * radius});
    }
  }
  map.edge = std::min(180.0, 1.25 * map.edge);
  return map;
}

std::string panel(const FieldsMap& map, int column, const char* quantity, double largest,
                  const char* unit) {
  const studies::DisplayUnit shown = studies::display_unit(largest, unit);
  std::string script =
      "set cblabel " +
      plot_text(std::string(quantity) + " [" + studies::printed_unit(shown.text) + "]") +
      "\nset cbrange [0:*]\nplot $cells using 1:2:" + in_unit(column, shown) +
      " with image title ''";
  if (!map.stick.empty())
    script +=
        ", $stick using 1:2 with points pointtype 7 pointsize 0.25 linecolor rgb '#FFFFFF' "
        "title ''";
  return script + "\n";
}

}  // namespace

std::string fields_map(const studies::MotorFile& file, double speed) {
  const FieldsMap map = map_of(file.design, speed);
  const std::string edge = plot_number(map.edge);
  const std::string radius = vertical_label("radius", {"mm", 1});
  return plot_data("cells", map.cells) + plot_data("stick", map.stick) +
         plot_style(plot_text(motor_title(file) + " at " +
                              studies::printed_engineering(map.point.speed, "rad/s") + ", " +
                              studies::printed_engineering(map.point.torque, "N.m"))) +
         "set multiplot\nset xrange [-" + edge + ":" + edge +
         "]\nset yrange [*:*] noextend\nunset grid\n" +
         "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n" +
         panel_place(0.915, 0.54, false) + "set rmargin at screen 0.84\n" + radius +
         panel(map, 3, "pressure", map.pressure, "Pa") + panel_place(0.46, 0.085, true) +
         "set rmargin at screen 0.84\n" +
         horizontal_label("phase of the wave; white: ends of the stick zones", {"deg", 1}) +
         radius + panel(map, 4, "slip speed", map.slip, "m/s") + "unset multiplot\n";
}

}  // namespace twum::inline v0_1::cli
