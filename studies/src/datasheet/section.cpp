// SPDX-License-Identifier: Apache-2.0
#include "datasheet/parts.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>

#include <algorithm>
#include <cmath>

namespace twum::studies::datasheet {
namespace {

// A ring with a rectangular cut. Height 0 is the stator's surface [m].
struct SectionPart {
  double inner, outer, low, high;
  const char* look;
  const char* name;
};

// Width of the drawing, room at its sides, and the least height of a part that is still seen.
constexpr double kDrawing = 400, kSide = 8, kThinnest = 1.2;

SectionPart between(const MotorDesign& design, Parameter inner, Parameter outer, double low,
                    double high, const char* look, const char* name) {
  return {get(design, inner), get(design, outer), low, high, look, name};
}

std::vector<SectionPart> plate_parts(const MotorDesign& design) {
  const auto of = [&](Parameter parameter) {
    const double value = get(design, parameter);
    return std::isfinite(value) ? value : 0;
  };
  using P = Parameter;
  const double teeth = of(P::teeth_height), metal = of(P::substrate_thickness),
               glue = of(P::glue_thickness), web = of(P::web_thickness), bottom = -teeth - metal;
  std::vector<SectionPart> parts;
  if (web > 0) {
    const double middle = bottom + 0.5 * metal;
    parts.push_back(between(design, P::web_inner_radius, P::web_outer_radius, middle - 0.5 * web,
                            middle + 0.5 * web, "faint", "web"));
  }
  parts.push_back(between(design, P::substrate_inner_radius, P::substrate_outer_radius, bottom,
                          -teeth, "metal", "metal"));
  if (teeth > 0)
    parts.push_back(
        between(design, P::teeth_inner_radius, P::teeth_outer_radius, -teeth, 0, "faint", "teeth"));
  if (glue > 0)
    parts.push_back(between(design, P::ceramic_inner_radius, P::ceramic_outer_radius, bottom - glue,
                            bottom, "glue", "glue"));
  parts.push_back(between(design, P::ceramic_inner_radius, P::ceramic_outer_radius,
                          bottom - glue - of(P::ceramic_thickness), bottom - glue, "ceramic",
                          "ceramic"));
  return parts;
}

std::vector<SectionPart> section_parts(const MotorDesign& design) {
  const Stator& s = design.stator;
  const double inner = s.contact_radius - 0.5 * s.contact_width,
               outer = s.contact_radius + 0.5 * s.contact_width;
  std::vector<SectionPart> parts;
  if (s.geometry)
    parts = plate_parts(design);
  else
    parts.push_back({inner, outer, -2 * s.neutral_plane_distance, 0, "metal",
                     "stator, drawn as deep as twice the distance of its neutral plane"});
  parts.push_back({inner, outer, 0, design.layer.thickness, "layer", "contact layer"});
  return parts;
}

std::string key_of(const std::vector<SectionPart>& parts) {
  std::string key;
  for (const SectionPart& part : parts)
    key += "<span><i class=\"" + std::string(part.look) + "\"></i>" + part.name + "</span>\n";
  return "<p class=\"key\">" + key + "</p>\n";
}

std::string dimension(double left, double right, double y, const std::string& text) {
  const std::string a = place(left), b = place(right), h = place(y);
  return element("path",
                 {{"class", "measure"},
                  {"d", "M" + a + " " + place(y - 4) + "V" + place(y + 4) + "M" + b + " " +
                            place(y - 4) + "V" + place(y + 4) + "M" + a + " " + h + "H" + b}}) +
         element(
             "text",
             {{"x", place(0.5 * (left + right))}, {"y", place(y + 15)}, {"text-anchor", "middle"}},
             escaped(text));
}

}  // namespace

std::string section(const MotorDesign& design) {
  const std::vector<SectionPart> parts = section_parts(design);
  double outer = 0, low = 0, high = 0;
  for (const SectionPart& part : parts) {
    outer = std::max(outer, part.outer);
    low = std::min(low, part.low);
    high = std::max(high, part.high);
  }
  const double scale = (0.5 * kDrawing - kSide) / outer, depth = (high - low) * scale, top = 8;
  const double middle = 0.5 * kDrawing, radius = design.stator.contact_radius * scale;
  std::string drawing;
  for (const SectionPart& part : parts) {
    const double width = (part.outer - part.inner) * scale;
    const double height = std::max((part.high - part.low) * scale, kThinnest);
    for (const double left : {middle + part.inner * scale, middle - part.outer * scale})
      drawing += element("rect", {{"class", part.look},
                                  {"x", place(left)},
                                  {"y", place(top + (high - part.high) * scale)},
                                  {"width", place(width)},
                                  {"height", place(height)}});
  }
  drawing += element(
      "path", {{"class", "axis"}, {"d", "M" + place(middle) + " 0V" + place(top + depth + 8)}});
  drawing +=
      dimension(middle - radius, middle + radius, top + depth + 16,
                "contact diameter " + printed_engineering(2 * design.stator.contact_radius, "m") +
                    ", track " + printed_engineering(design.stator.contact_width, "m") + " wide");
  return element("svg",
                 {{"class", "section"},
                  {"viewBox", "0 0 " + place(kDrawing) + " " + place(top + depth + 38)},
                  {"role", "img"},
                  {"aria-label", "Cross-section of the motor to scale"}},
                 drawing) +
         "\n" + key_of(parts);
}

}  // namespace twum::studies::datasheet
