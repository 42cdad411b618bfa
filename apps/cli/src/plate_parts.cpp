// SPDX-License-Identifier: Apache-2.0
#include "plate_parts.hpp"

#include "text_table.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::cli {
namespace {

using stator::StatorModel;

constexpr int kShapeRows = 51;  // of R(rho) in JSON, from edge to edge of the plate

const char* word_of(stator::ModeIdentity identity) {
  switch (identity) {
    case stator::ModeIdentity::clear: return "clear";
    case stator::ModeIdentity::shared: return "shared";
    case stator::ModeIdentity::crossing: break;
  }
  return "crossing";
}

std::string shown_mass(double mass) {
  return std::isfinite(mass) ? studies::engineering(mass, "kg") : "-";
}

}  // namespace

std::vector<ListedMode> listed_modes(const MotorDesign& design, std::size_t count) {
  const auto plate = plate_model(design);
  const auto n = static_cast<int>(design.stator.wavelengths);
  std::vector<ListedMode> modes{
      {{n, plate->nodal_circles, plate->frequency.v, plate->modal_mass.v}, true}};
  for (const stator::StatorMode& other : plate->unwanted)
    if (modes.size() < count) modes.push_back({other, false});
  std::stable_sort(modes.begin(), modes.end(), [](const ListedMode& a, const ListedMode& b) {
    return a.mode.frequency < b.mode.frequency;
  });
  return modes;
}

std::string plate_text(const MotorDesign& design, std::size_t modes) {
  const auto plate = plate_model(design);
  TextTable numbers{{{"plate", ""}}};
  numbers.rows.push_back(
      {"neutral_plane_distance",
       studies::engineering(get(design, Parameter::neutral_plane_distance), "m")});
  numbers.rows.push_back({"mode_separation", studies::engineering(plate->mode_separation.v, "Hz")});
  numbers.rows.push_back(
      {"ceramic_stress at 1 um", studies::engineering(1e-6 * plate->ceramic_stress.v, "Pa")});
  TextTable table{{{"mode", "wavelengths", "nodal circles", "frequency", "modal mass"}}};
  for (const ListedMode& one : listed_modes(design, modes))
    table.rows.push_back({one.drive ? "drive" : "", std::to_string(one.mode.nodal_diameters),
                          std::to_string(one.mode.nodal_circles),
                          studies::engineering(one.mode.frequency, "Hz"),
                          shown_mass(one.mode.modal_mass)});
  return aligned(numbers) + "\n" + aligned(table);
}

Json plate_json(const MotorDesign& design, std::size_t modes, Json& units) {
  const auto plate = plate_model(design);
  Json json;
  json["neutral_plane_distance"] = get(design, Parameter::neutral_plane_distance);
  json["mode_separation"] = plate->mode_separation.v;
  json["ceramic_stress_per_amplitude"] = plate->ceramic_stress.v;
  json["tangential_share"] = plate->tangential_share.v;
  json["identity"] = word_of(plate->identity);
  for (const ListedMode& one : listed_modes(design, modes))
    json["modes"].push_back({{"wavelengths", one.mode.nodal_diameters},
                             {"nodal_circles", one.mode.nodal_circles},
                             {"frequency", one.mode.frequency},
                             {"modal_mass", number_json(one.mode.modal_mass)},
                             {"drive", one.drive}});
  const auto& pieces = plate->shape.pieces();
  const double inner = pieces.front().inner, outer = pieces.back().outer;
  for (int i = 0; i < kShapeRows; ++i) {
    const double radius = inner + (outer - inner) * i / (kShapeRows - 1);
    json["shape"].push_back({{"radius", radius}, {"R", plate->shape(radius)}});
  }
  units["mode_separation"] = "Hz";
  units["ceramic_stress_per_amplitude"] = "Pa/m";
  units["tangential_share"] = units["R"] = units["nodal_circles"] = "1";
  units["radius"] = "m";
  return json;
}

}  // namespace twum::inline v0_1::cli
