// SPDX-License-Identifier: Apache-2.0
#include "plot/section_panel.hpp"

#include "plot/gnuplot.hpp"

#include <twum/solid/section.hpp>

#include <algorithm>

namespace twum::inline v0_1::cli {
namespace {

using solid::SectionPart;

// Each part has a colour of its own, from light to dark so that grey tells them apart too.
const char* section_colour(const SectionPart& part) {
  if (part.name == "teeth") return "#DFC27D";
  if (part.name == "ring") return "#BF9B4B";
  if (part.name == "web") return "#A67C2E";
  return part.part == solid::Part::glue ? "#444444" : "#7FA7C9";
}

std::string section_mm(double length) { return plot_number(1e3 * length); }

std::string section_at(double x, double y) {
  return "first " + section_mm(x) + ", first " + section_mm(y);
}

struct SectionFrame {
  double inner, outer, low, high;
};

SectionFrame frame_of(const std::vector<SectionPart>& parts) {
  SectionFrame all{parts[0].inner, parts[0].outer, parts[0].bottom, parts[0].top};
  for (const SectionPart& one : parts)
    all = {std::min(all.inner, one.inner), std::max(all.outer, one.outer),
           std::min(all.low, one.bottom), std::max(all.high, one.top)};
  return all;
}

// A name stands in its part, or beside it with a line to it where the part is too thin.
std::string part_label(const SectionPart& part, const SectionFrame& all, int number) {
  constexpr double kThin = 0.02;  // of the width of the drawing, the height of the letters
  const double middle = 0.5 * (part.bottom + part.top), width = all.outer - all.inner;
  const std::string text =
      "set label " + std::to_string(number) + " '" + std::string(part.name) + "' ";
  if (part.top - part.bottom > kThin * width)
    return text + "at " + section_at(0.5 * (part.inner + part.outer), middle) + " center front\n";
  const double left = part.inner - 0.02 * width;
  return text + "at " + section_at(left - 0.005 * width, middle) + " right front\nset arrow " +
         std::to_string(number) + " from " + section_at(left, middle) + " to " +
         section_at(part.inner, middle) + " nohead front linecolor rgb '#444444'\n";
}

}  // namespace

std::string section_panel(const stator::StatorGeometry& geometry, double contact_radius,
                          double contact_width, double top, double bottom) {
  const auto parts = solid::cross_section(geometry, contact_radius);
  const SectionFrame all = frame_of(parts);
  const double width = all.outer - all.inner, track = 0.02 * width;
  std::string script = "set tmargin at screen " + plot_number(top) + "\nset bmargin at screen " +
                       plot_number(bottom) +
                       "\nset lmargin at screen 0.11\nset rmargin at screen 0.95\nset size ratio "
                       "-1\nunset grid\nunset ytics\nset ylabel ''\nset border 1\n";
  int number = 0;
  for (const SectionPart& part : parts) {
    ++number;
    script += "set object " + std::to_string(number) + " rectangle from " +
              section_at(part.inner, part.bottom) + " to " + section_at(part.outer, part.top) +
              " front fillcolor rgb '" + section_colour(part) +
              "' fillstyle solid border linecolor rgb '#555555'\n" + part_label(part, all, number);
  }
  script +=
      "set object 20 rectangle from " + section_at(contact_radius - 0.5 * contact_width, all.high) +
      " to " + section_at(contact_radius + 0.5 * contact_width, all.high + track) +
      " front fillcolor rgb '#0072B2' fillstyle solid noborder\nset label 20 'contact track' at " +
      section_at(contact_radius, all.high + 2.2 * track) + " center front\n";
  script += "set label 21 'cross-section to scale' at graph 0, graph 0.9 left front\n";
  return script + "set xrange [" + section_mm(all.inner) + ":" + section_mm(all.outer) +
         "]\nset yrange [" + section_mm(all.low) + ":" + section_mm(all.high + 4 * track) +
         "]\nset xlabel ''\nplot NaN title ''\nunset object\nunset label\nunset arrow\nset size "
         "noratio\nset grid noxtics ytics\nset ytics nomirror out scale 0.5\nset border 3\n";
}

}  // namespace twum::inline v0_1::cli
