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

// Width of the drawing and its largest height, room at its sides, the least height of a part that is still seen, and that of one
// with its name inside.
constexpr double kDrawing = 400, kTallest = 150, kSide = 8, kThinnest = 1.2, kNamed = 11;

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
                            middle + 0.5 * web, "web", "web"));
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

// The text stands in the middle of the drawing, where it has room.
std::string dimension(double left, double right, double y, const std::string& text) {
  const std::string a = place(left), b = place(right), h = place(y);
  return element("path",
                 {{"class", "measure"},
                  {"d", "M" + a + " " + place(y - 4) + "V" + place(y + 4) + "M" + b + " " +
                            place(y - 4) + "V" + place(y + 4) + "M" + a + " " + h + "H" + b}}) +
         element("text",
                 {{"x", place(0.5 * kDrawing)}, {"y", place(y + 15)}, {"text-anchor", "middle"}},
                 escaped(text));
}

}  // namespace

// One side of the motor, from the innermost to the outermost radius, as large as fits.
std::string section(const MotorDesign& design) {
  const std::vector<SectionPart> parts = section_parts(design);
  double inner = parts[0].inner, outer = 0, low = 0, high = 0;
  for (const SectionPart& part : parts) {
    inner = std::min(inner, part.inner), outer = std::max(outer, part.outer);
    low = std::min(low, part.low), high = std::max(high, part.high);
  }
  const double scale = std::min((kDrawing - 2 * kSide) / (outer - inner), kTallest / (high - low));
  const double depth = (high - low) * scale, top = 8;
  const double left = 0.5 * (kDrawing - (outer - inner) * scale);
  const auto x = [&](double radius) { return left + (radius - inner) * scale; };
  std::string drawing, names;
  for (const SectionPart& part : parts) {
    const double y = top + (high - part.high) * scale, size = (part.high - part.low) * scale;
    drawing += element("rect", {{"class", part.look},
                                {"x", place(x(part.inner))},
                                {"y", place(y)},
                                {"width", place((part.outer - part.inner) * scale)},
                                {"height", place(std::max(size, kThinnest))}});
    if (size >= kNamed && design.stator.geometry)
      names += element("text",
                       {{"x", place(x(0.5 * (part.inner + part.outer)))},
                        {"y", place(y + 0.5 * size + 4)},
                        {"text-anchor", "middle"}},
                       part.name);
  }
  const Stator& s = design.stator;
  const double half = 0.5 * s.contact_width;
  drawing +=
      names + dimension(x(s.contact_radius - half), x(s.contact_radius + half), top + depth + 16,
                        "track " + printed_engineering(s.contact_width, "m") +
                            " wide at a radius of " + printed_engineering(s.contact_radius, "m"));
  return element("svg",
                 {{"class", "section"},
                  {"viewBox", "0 0 " + place(kDrawing) + " " + place(top + depth + 38)},
                  {"role", "img"},
                  {"aria-label", "Cross-section of one side of the motor to scale"}},
                 drawing) +
         "\n" + key_of(parts);
}

}  // namespace twum::studies::datasheet
