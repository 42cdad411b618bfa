// SPDX-License-Identifier: Apache-2.0
#include "telling/sheet_sections.hpp"

#include <twum/core/parameters.hpp>

#include <cmath>

namespace twum::inline v0_1::studies::telling {
namespace {

// A ring with a rectangular cut. Height 0 is the stator's surface [m].
Series ring(const char* name, const char* colour, double inner, double outer, double low,
            double high) {
  return {
      name, Stroke::area, {"", {inner, outer, outer, inner}}, {"", {low, low, high, high}}, colour};
}

// Those that a motor does not have are left out.
std::vector<Series> plate_rings(const MotorDesign& design) {
  using P = Parameter;
  std::vector<Series> rings;
  const auto add = [&](const char* name, const char* colour, P inner, P outer, double low,
                       double high) {
    if (high > low)
      rings.push_back(ring(name, colour, get(design, inner), get(design, outer), low, high));
  };
  const auto of = [&](P parameter) {
    const double value = get(design, parameter);
    return std::isfinite(value) ? value : 0;
  };
  const double top = -of(P::teeth_height), bottom = top - of(P::substrate_thickness);
  const double glue = bottom - of(P::glue_thickness), half_web = 0.5 * of(P::web_thickness);
  const double middle = 0.5 * (top + bottom);
  add("web", "c4", P::web_inner_radius, P::web_outer_radius, middle - half_web, middle + half_web);
  add("metal", "c6", P::substrate_inner_radius, P::substrate_outer_radius, bottom, top);
  add("teeth", "faint", P::teeth_inner_radius, P::teeth_outer_radius, top, 0);
  add("glue", "c1", P::ceramic_inner_radius, P::ceramic_outer_radius, glue, bottom);
  add("ceramic", "c2", P::ceramic_inner_radius, P::ceramic_outer_radius,
      glue - of(P::ceramic_thickness), glue);
  return rings;
}

}  // namespace

Section cross_section(const MotorDesign& design) {
  const Stator& s = design.stator;
  const double inner = s.contact_radius - 0.5 * s.contact_width,
               outer = s.contact_radius + 0.5 * s.contact_width;
  Chart chart{"cross-section", {}, {{"radius"}, "m"}, {{"height"}, "m"}};
  chart.one_scale = true;
  chart.series = s.geometry ? plate_rings(design)
                            : std::vector<Series>{ring("stator", "c6", inner, outer,
                                                       -2 * s.neutral_plane_distance, 0)};
  chart.series.push_back(ring("contact layer", "c0", inner, outer, 0, design.layer.thickness));
  Section section{{"Cross-section"}};
  section.wide = false;
  section.charts = {std::move(chart)};
  section.sentences = {{"The track is ", value_part(s.contact_width, "m"), " wide at a radius of ",
                        value_part(s.contact_radius, "m"), "."}};
  if (!s.geometry)
    section.sentences.push_back(
        {"The stator is drawn as deep as twice the distance of its neutral plane."});
  return section;
}

}  // namespace twum::inline v0_1::studies::telling
