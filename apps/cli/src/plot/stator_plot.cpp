// SPDX-License-Identifier: Apache-2.0
#include "plot/stator_plot.hpp"

#include "plot/section_panel.hpp"
#include "plot/style.hpp"

#include <twum/core/plate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

constexpr int kSteps = 301, kCells = 401;

using Rows = std::vector<std::vector<double>>;

struct PlateEdges {
  double inner, outer;  // [m]
};

PlateEdges edges_of(const stator::StatorModel& plate) {
  return {plate.shape.pieces().front().inner, plate.shape.pieces().back().outer};
}

Rows shape_rows(const stator::StatorModel& plate) {
  const auto [inner, outer] = edges_of(plate);
  Rows rows;
  for (int i = 0; i < kSteps; ++i) {
    const double radius = inner + (outer - inner) * i / (kSteps - 1);
    rows.push_back({1e3 * radius, plate.shape(radius)});
  }
  return rows;
}

// w = R(rho) cos(n phi) on a square around the plate.
Rows deflection_rows(const stator::StatorModel& plate, double wavelengths) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto [inner, outer] = edges_of(plate);
  Rows rows;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const double x = outer * (2.0 * i / (kCells - 1) - 1),
                   y = outer * (2.0 * j / (kCells - 1) - 1);
      const double radius = std::hypot(x, y);
      const bool on_plate = radius >= inner && radius <= outer;
      rows.push_back(
          {1e3 * x, 1e3 * y,
           on_plate ? plate.shape(radius) * std::cos(wavelengths * std::atan2(y, x)) : kNone});
    }
  }
  return rows;
}

Rows mode_rows(const stator::StatorModel& plate, double below) {
  Rows rows;
  for (const stator::StatorMode& mode : plate.unwanted)
    if (mode.frequency < below)
      rows.push_back({1e-3 * mode.frequency, static_cast<double>(mode.nodal_diameters)});
  return rows;
}

std::string shape_panel(const MotorDesign& design, const stator::StatorModel& plate) {
  const Stator& s = design.stator;
  const auto [inner, outer] = edges_of(plate);
  const auto mm = [](double length) { return plot_number(1e3 * length); };
  return "set lmargin at screen 0.11\nset rmargin at screen 0.95\nset tmargin at screen 0.726\nset "
         "bmargin at "
         "screen 0.568\nset format x '%g'\nset xrange [" +
         mm(inner) + ":" + mm(outer) + "]\nset yrange [*:*]\nset object 1 rectangle from first " +
         mm(s.contact_radius - 0.5 * s.contact_width) + ", graph 0 to first " +
         mm(s.contact_radius + 0.5 * s.contact_width) +
         ", graph 1 back fillcolor rgb '#E8EEF4' fillstyle solid noborder\n" +
         "set label 1 'contact track' at first " + mm(s.contact_radius) +
         ", graph 0.08 center font 'Arial,11'\n" + horizontal_label("radius", {"mm", 1}) +
         vertical_label("shape R", {"", 1}) +
         "plot $shape using 1:2 with lines linewidth 2 linecolor rgb '" + colour::kBlue +
         "' title ''\nunset object\nunset label\n";
}

std::string deflection_panel(double outer) {
  const std::string edge = plot_number(1.02e3 * outer);
  return "set lmargin at screen 0.25\nset rmargin at screen 0.73\nset tmargin at screen 0.509\nset "
         "bmargin at "
         "screen 0.205\nset xrange [-" +
         edge + ":" + edge + "]\nset yrange [-" + edge + ":" + edge +
         "]\nunset grid\nunset border\nunset xtics\nunset ytics\nunset xlabel\nunset ylabel\n" +
         "set palette defined (-1 '#0072B2', 0 '#F4F4F4', 1 '#D55E00')\n" +
         "set cblabel 'deflection over that at the contact radius'\n" +
         "stats $plate using 3 nooutput\nlargest = abs(STATS_min) > STATS_max ? abs(STATS_min) : "
         "STATS_max\n" +
         "set cbrange [-largest:largest]\nplot $plate using 1:2:3 with image title ''\n" +
         "unset colorbox\nset grid\nset xtics nomirror\nset ytics nomirror\n";
}

std::string spectrum_panel(const MotorDesign& design, const stator::StatorModel& plate,
                           double below) {
  const double n = design.stator.wavelengths, frequency = 1e-3 * plate.frequency.v;
  const std::string f = plot_number(frequency);
  return "set lmargin at screen 0.11\nset rmargin at screen 0.95\nset tmargin at screen 0.174\nset "
         "bmargin at "
         "screen 0.059\nset xrange [0:" +
         plot_number(1e-3 * below) + "]\nset yrange [" + plot_number(std::max(-0.5, n - 2.6)) +
         ":" + plot_number(n + 2.6) + "]\nset ytics 1\n" +
         horizontal_label("frequency of the modes", {"kHz", 1}) +
         "set ylabel 'wavelengths'\nset border 3\nset key at graph 1, graph 1.04 right bottom "
         "horizontal\n" +
         "set arrow from first " + f + ", graph 0 to first " + f +
         ", graph 1 nohead back dashtype '.' linecolor rgb '#999999'\n$drive << END\n" + f + " " +
         plot_number(n) + "\nEND\n" +
         "plot $modes using 1:2 with points pointtype 6 pointsize 0.9 linecolor rgb '" +
         colour::kGrey +
         "' title 'other modes', $drive using 1:2 with points pointtype 7 pointsize 1.2 linecolor "
         "rgb '" +
         colour::kVermilion + "' title " +
         plot_text("drive, " + studies::printed_engineering(plate.frequency.v, "Hz")) + "\n";
}

}  // namespace

std::string stator_plot(const studies::MotorFile& file) {
  const auto plate = plate_model(file.design);
  const double below = 2.2 * plate->frequency.v;
  return plot_data("shape", shape_rows(*plate)) +
         plot_data("plate", deflection_rows(*plate, file.design.stator.wavelengths)) +
         plot_data("modes", mode_rows(*plate, below)) + plot_style(plot_text(motor_title(file))) +
         "set multiplot\n" +
         section_panel(*file.design.stator.geometry, file.design.stator.contact_radius,
                       file.design.stator.contact_width, 0.95, 0.775) +
         shape_panel(file.design, *plate) + deflection_panel(edges_of(*plate).outer) +
         spectrum_panel(file.design, *plate, below) + "unset multiplot\n";
}

}  // namespace twum::inline v0_1::cli
