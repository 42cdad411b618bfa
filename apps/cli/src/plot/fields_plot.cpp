// SPDX-License-Identifier: Apache-2.0
#include "plot/fields_plot.hpp"

#include "plot/style.hpp"
#include "plot/told_panel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

constexpr double kPi = std::numbers::pi;

enum Trace : int {
  kPhase = 1,
  kPressure,
  kTraction,
  kKinetic,
  kStatic,
  kStatorVelocity,
  kLayerVelocity
};

struct FieldsPicture {
  ContactFields fields;
  std::vector<std::vector<double>> rows;
  double edge;  // of the picture, in both directions [rad]
  bool two_bounds;
  std::vector<telling::Chart> told;
  studies::DisplayUnit pressure;
  studies::DisplayUnit traction;
  studies::DisplayUnit velocity;
};

// The contact with a margin, or the whole wave if the contact fills most of it.
double edge_of(const std::vector<Zone>& zones) {
  if (zones.empty()) return kPi;
  return std::min(kPi, 1.25 * std::max(-zones.front().from, zones.back().to));
}

// Samples are equally spaced over the whole wave; as many as leave 600 in the picture.
int samples_for(double edge) { return 1 + static_cast<int>(std::min(600 * kPi / edge, 60000.0)); }

FieldsPicture fields_picture(const MotorDesign& design, double speed) {
  const Motor motor(design);
  FieldsPicture picture;
  picture.told = telling::contact_charts();
  picture.edge = edge_of(motor.zones(speed));
  picture.fields = motor.fields(speed, samples_for(picture.edge));
  picture.two_bounds = design.friction.threshold != design.friction.kinetic;
  for (const FieldSample& s : picture.fields.samples) {
    if (std::abs(s.phase) > picture.edge) continue;
    picture.rows.push_back({s.phase, s.pressure, s.traction, design.friction.kinetic * s.pressure,
                            design.friction.threshold * s.pressure, s.stator_velocity,
                            s.layer_velocity});
  }
  picture.pressure = studies::display_unit(largest(picture.rows, kPressure, kPressure), "Pa");
  picture.traction = studies::display_unit(largest(picture.rows, kTraction, kStatic), "Pa");
  picture.velocity =
      studies::display_unit(largest(picture.rows, kStatorVelocity, kLayerVelocity), "m/s");
  return picture;
}

const char* zone_colour(ZoneState state) {
  switch (state) {
    case ZoneState::slip_plus: return "#FFE3B3";
    case ZoneState::stick: return "#CFE6F5";
    case ZoneState::slip_minus: return "#F3D3E4";
  }
  return "#FFFFFF";
}

std::string zone_ground(const FieldsPicture& picture) {
  std::string script;
  int number = 0;
  for (const Zone& zone : picture.fields.zones) {
    script += "set object " + std::to_string(++number) + " rectangle from first " +
              plot_number(zone.from / kDegree) + ", graph 0 to first " +
              plot_number(zone.to / kDegree) + ", graph 1 behind fillstyle solid 1 noborder " +
              "fillcolor rgb '" + zone_colour(zone.state) + "'\n";
  }
  return script;
}

// Names over the zones, above the top panel; narrow zones have their colour only.
std::string zone_names(const FieldsPicture& picture) {
  std::string script;
  for (const Zone& zone : picture.fields.zones) {
    if (zone.to - zone.from < 0.12 * picture.edge) continue;
    script += "set label " + plot_text(to_string(zone.state)) + " at first " +
              plot_number((zone.from + zone.to) / 2 / kDegree) +
              ", graph 0.95 center font 'Arial,11' textcolor rgb '#333333' noenhanced front\n";
  }
  return script;
}

std::string series(const std::string& scaled, const std::string& name, const char* colour,
                   const char* dash) {
  return "$fields using ($1/" + plot_number(kDegree) + "):" + scaled +
         " with lines linewidth 2 dashtype " + dash + " linecolor rgb '" + colour + "' title " +
         plot_text(name);
}

std::string bounds(const FieldsPicture& picture, Trace column, const std::string& name,
                   const char* dash) {
  const std::string bound = in_unit(column, picture.traction);
  return series(bound, name, colour::kGrey, dash) + ", " +
         series("(-" + bound + ")", "", colour::kGrey, dash);
}

std::string pressure_panel(const FieldsPicture& picture) {
  std::string script = panel_place(0.915, 0.68, false) + zone_names(picture) +
                       "set offsets 0, 0, graph 0.12, 0\nset yrange [0:]\n" +
                       vertical_label(read(picture.told[0].y.name), picture.pressure) + "plot " +
                       series(in_unit(kPressure, picture.pressure), "", colour::kBlue, "1");
  const auto legend = [&](ZoneState state, const char* meaning) {
    script += std::string(", NaN with boxes fillstyle solid 1 noborder linecolor rgb '") +
              zone_colour(state) + "' title " + plot_text(to_string(state) + std::string(meaning));
  };
  legend(ZoneState::slip_plus, " (drives)");
  legend(ZoneState::stick, "");
  legend(ZoneState::slip_minus, " (brakes)");
  return script + "\nunset label\nset offsets 0, 0, 0, 0\nset yrange [*:*]\n";
}

std::string traction_panel(const FieldsPicture& picture) {
  const bool two = picture.two_bounds;
  const std::vector<telling::Series>& lines = picture.told[1].series;
  std::string script = panel_place(0.635, 0.37, false) +
                       vertical_label(read(picture.told[1].y.name), picture.traction) + "plot " +
                       bounds(picture, kKinetic, two ? "kinetic bound" : lines[0].name, "2");
  if (two) script += ", " + bounds(picture, kStatic, "static bound", "3");
  return script + ", " +
         series(in_unit(kTraction, picture.traction), lines[1].name, colour::kVermilion, "1") +
         "\nunset label\n";
}

std::string velocity_panel(const FieldsPicture& picture) {
  const telling::Chart& told = picture.told[2];
  return panel_place(0.325, 0.075, true) + horizontal_label(read(told.x.name), {"deg", 1}) +
         vertical_label(read(told.y.name), picture.velocity) + "plot " +
         series(in_unit(kStatorVelocity, picture.velocity), told.series[0].name, colour::kBlue,
                "1") +
         ", " +
         series(in_unit(kLayerVelocity, picture.velocity), told.series[1].name, colour::kVermilion,
                "2") +
         "\n";
}

}  // namespace

std::string fields_plot(const studies::MotorFile& file, double speed) {
  const FieldsPicture picture = fields_picture(file.design, speed);
  const OperatingPoint& point = picture.fields.point;
  const std::string edge = plot_number(picture.edge / kDegree);
  return plot_data("fields", picture.rows) +
         plot_style(plot_text(motor_title(file) + " at " +
                              studies::printed_engineering(point.speed, "rad/s") + ", " +
                              studies::printed_engineering(point.torque, "N.m"))) +
         "set multiplot\nset xrange [-" + edge + ":" + edge + "]\n" + zone_ground(picture) +
         pressure_panel(picture) + traction_panel(picture) + velocity_panel(picture) +
         "unset multiplot\n";
}

}  // namespace twum::inline v0_1::cli
