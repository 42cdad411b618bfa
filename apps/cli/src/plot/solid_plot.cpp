// SPDX-License-Identifier: Apache-2.0
#include "plot/solid_plot.hpp"

#include "plot/style.hpp"

#include <twum/base/error.hpp>
#include <twum/core/plate.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::cli {
namespace {

using Rows = std::vector<std::vector<double>>;

constexpr int kPlateShapeSteps = 301;

Rows solid_shape_rows(const SolidStator& solid) {
  Rows rows;
  for (const auto& [radius, shape] : solid.shape) rows.push_back({1e3 * radius, shape});
  return rows;
}

// None if the plate has no such wave.
Rows plate_shape_rows(const MotorDesign& design) {
  Rows rows;
  try {
    const auto shape = plate_model(design)->shape;
    const double inner = shape.pieces().front().inner, outer = shape.pieces().back().outer;
    for (int i = 0; i < kPlateShapeSteps; ++i) {
      const double radius = inner + (outer - inner) * i / (kPlateShapeSteps - 1);
      rows.push_back({1e3 * radius, shape(radius)});
    }
  } catch (const EvaluationError&) {
    rows.push_back({0, std::nan("")});
  }
  return rows;
}

// The motion is drawn so large that it is a third of the stator's height at most.
double enlargement(const SolidStator& solid) {
  double low = 0, high = 0, most = 0;
  for (const solid::BentFace& face : solid.section)
    for (std::size_t k = 0; k < face.place.size(); ++k) {
      low = std::min(low, face.place[k][1]), high = std::max(high, face.place[k][1]);
      most = std::max(most, std::hypot(face.motion[k][0], face.motion[k][1]));
    }
  return (high - low) / (3 * most);
}

// Closed polygons, with an empty line between them.
std::string bent_faces(const char* name, const SolidStator& solid, solid::Part part, double by) {
  std::string text = "$" + std::string(name) + " << END\n";
  for (const solid::BentFace& face : solid.section) {
    if (face.part != part) continue;
    for (const std::size_t k : {0, 1, 2, 3, 0})
      text += plot_number(1e3 * (face.place[k][0] + by * face.motion[k][0])) + " " +
              plot_number(1e3 * (face.place[k][1] + by * face.motion[k][1])) + "\n";
    text += "\n";
  }
  return text + "END\n";
}

std::string solid_shape_part(const MotorDesign& design) {
  const Stator& s = design.stator;
  const auto mm = [](double length) { return plot_number(1e3 * length); };
  return "set tmargin at screen 0.89\nset bmargin at screen 0.52\nset lmargin at screen 0.11\nset "
         "rmargin at screen 0.95\nset format x '%g'\nset yrange [*:*]\nset key at graph 0.02, "
         "graph "
         "0.95 left top\nset object 1 rectangle from first " +
         mm(s.contact_radius - 0.5 * s.contact_width) + ", graph 0 to first " +
         mm(s.contact_radius + 0.5 * s.contact_width) +
         ", graph 1 back fillcolor rgb '#E8EEF4' fillstyle solid noborder\n" +
         horizontal_label("radius", {"mm", 1}) + vertical_label("shape R", {"", 1}) +
         "plot $plate using 1:2 with lines linewidth 2 linecolor rgb '" + colour::kBlue +
         "' title 'plate', $shape using 1:2 with points pointtype 7 linecolor rgb '" +
         colour::kVermilion + "' title 'solid'\nunset object\n";
}

std::string bent_section_part(bool glue) {
  const auto filled = [](const char* name, const char* colour, const char* title) {
    return std::string("$") + name + " using 1:2 with filledcurves closed linecolor rgb '" +
           colour + "' title '" + title + "', $" + name +
           " using 1:2 with lines linewidth 0.5 linecolor rgb '#FFFFFF' title ''";
  };
  return "set tmargin at screen 0.4\nset bmargin at screen 0.1\nset size ratio -1\nunset grid\nset "
         "yrange [*:*]\nunset label\nset ylabel 'height [mm]'\nset xlabel 'radius [mm], "
         "cross-section at the crest, motion enlarged; grey: at rest'\nset key at graph 0.02, "
         "graph 0.95 left top\nplot "
         "$rest "
         "using 1:2 with lines linecolor rgb '#BBBBBB' title '', " +
         filled("metal", "#BF9B4B", "metal") + ", " + filled("ceramic", "#7FA7C9", "ceramic") +
         (glue ? ", " + filled("glue", "#444444", "glue") : std::string()) + "\n";
}

}  // namespace

std::string solid_plot(const studies::MotorFile& file, const SolidStator& solid) {
  const double by = enlargement(solid);
  const bool glue = file.design.stator.geometry->glue.thickness > 0;
  std::string script = plot_data("shape", solid_shape_rows(solid)) +
                       plot_data("plate", plate_shape_rows(file.design)) +
                       bent_faces("metal", solid, solid::Part::metal, by) +
                       bent_faces("ceramic", solid, solid::Part::ceramic, by) +
                       bent_faces("rest", solid, solid::Part::metal, 0);
  if (glue) script += bent_faces("glue", solid, solid::Part::glue, by);
  return script + plot_style(plot_text(motor_title(file))) + "set multiplot\n" +
         solid_shape_part(file.design) + bent_section_part(glue) + "unset multiplot\n";
}

}  // namespace twum::inline v0_1::cli
