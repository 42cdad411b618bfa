// SPDX-License-Identifier: Apache-2.0
#include "solid/solid_text.hpp"

#include "text_table.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::cli {
namespace {

// Modes that move the nodes more within the plane than along the axis.
constexpr double kWithinPlane = 0.5;

std::string solid_cell(double value, const char* unit) {
  return std::isfinite(value) ? studies::engineering(value, unit) : "-";
}

std::string percent(double value, double from) {
  const double change = 100 * (value / from - 1);
  char text[32];
  std::snprintf(text, sizeof text, std::abs(change) < 0.005 ? "0.00 %%" : "%+.2f %%", change);
  return text;
}

// A value with its difference from the solid's.
std::string compared(double value, double solid, const char* unit) {
  if (!std::isfinite(value) || !std::isfinite(solid)) return solid_cell(value, unit);
  return solid_cell(value, unit) + " (" + percent(value, solid) + ")";
}

std::string mesh_text(const char* name, const MeshSize& mesh) {
  return std::string(name) + ": " +
         studies::counted(static_cast<std::uint64_t>(mesh.elements), "element") +
         " through the plate; a sector of 1/" + std::to_string(mesh.sectors) + " has " +
         std::to_string(mesh.bricks) + " bricks and " + std::to_string(mesh.nodes) + " nodes\n";
}

std::string share_text(double share) { return studies::rounded_text(share, 4); }

std::string numbers_table(const SolidComparison& c) {
  TextTable table{{{"", "solid", "coarser mesh"}}};
  if (c.plate) table.rows[0].emplace_back("plate");
  if (c.fitted_plate) table.rows[0].push_back("plate, share " + share_text(*c.share->share));
  for (const StatorRow& row : kStatorRows) {
    const double solid = c.solid.numbers.*row.value;
    const auto beside = [&](const StatorNumbers& numbers) {
      return compared(numbers.*row.value, solid, row.unit);
    };
    std::vector<std::string> cells{row.name, solid_cell(solid, row.unit), beside(c.solid.coarser)};
    if (c.plate) cells.push_back(beside(*c.plate));
    if (c.fitted_plate) cells.push_back(beside(*c.fitted_plate));
    table.rows.push_back(std::move(cells));
  }
  return aligned(table);
}

// The wave and the modes that are nearest to it, lowest frequency first.
std::vector<std::size_t> listed_places(const SolidComparison& c) {
  const auto& modes = c.solid.modes;
  std::vector<std::size_t> places(modes.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  const auto distance = [&](std::size_t i) {
    return std::abs(modes[i].frequency - modes[c.solid.wave].frequency);
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  places.resize(std::min(places.size(), c.listed_modes));
  std::sort(places.begin(), places.end());
  return places;
}

std::string modes_table(const SolidComparison& c) {
  TextTable table{{{"mode", "wavelengths", "nodal circles", "frequency", "modal mass"}}};
  for (const std::size_t i : listed_places(c)) {
    const solid::SolidMode& mode = c.solid.modes[i];
    const bool bends = mode.axial_share >= kWithinPlane;
    table.rows.push_back({i == c.solid.wave ? "drive" : "", std::to_string(mode.nodal_diameters),
                          bends ? std::to_string(mode.nodal_circles) : "within the plane",
                          solid_cell(mode.frequency, "Hz"),
                          bends ? solid_cell(mode.modal_mass, "kg") : "-"});
  }
  return aligned(table);
}

std::string share_sentence(const SolidComparison& c) {
  if (!c.share) return "";
  const std::string solid = solid_cell(c.solid.numbers.resonance_frequency, "Hz");
  if (c.share->share)
    return "\nWith teeth_stiffness_share " + share_text(*c.share->share) +
           " the plate has the solid's frequency.\n";
  return "\nNo teeth_stiffness_share between 0 and 1 gives the plate the solid's frequency, " +
         solid + ": the plate has " + solid_cell(c.share->lowest, "Hz") + " with 0 and " +
         solid_cell(c.share->highest, "Hz") + " with 1.\n";
}

std::string untold_sentence(const SolidStator& solid) {
  if (solid.untold.empty()) return "";
  std::string orders;
  for (const int order : solid.untold)
    orders += (orders.empty() ? "" : ", ") + std::to_string(order);
  return "\nModes with these numbers of wavelengths are left out, because each wavelength has no "
         "more than "
         "two teeth: " +
         orders + ".\n";
}

void add_numbers(Json& json, const StatorNumbers& numbers) {
  for (const StatorRow& row : kStatorRows) json[row.name] = number_json(numbers.*row.value);
}

Json mesh_json(const MeshSize& mesh) {
  return {{"elements", mesh.elements},
          {"sectors", mesh.sectors},
          {"bricks", mesh.bricks},
          {"nodes", mesh.nodes}};
}

Json solid_part(const SolidComparison& c) {
  Json json;
  json["mesh"] = mesh_json(c.solid.mesh);
  add_numbers(json, c.solid.numbers);
  for (const std::size_t i : listed_places(c)) {
    const solid::SolidMode& mode = c.solid.modes[i];
    json["modes"].push_back({{"wavelengths", mode.nodal_diameters},
                             {"nodal_circles", mode.nodal_circles},
                             {"frequency", mode.frequency},
                             {"modal_mass", number_json(mode.modal_mass)},
                             {"axial_share", mode.axial_share},
                             {"drive", i == c.solid.wave}});
  }
  for (const auto& [radius, shape] : c.solid.shape)
    json["shape"].push_back({{"radius", radius}, {"R", shape}});
  return json;
}

}  // namespace

std::string solid_text(const SolidComparison& c) {
  const std::string name = c.file.name.empty() ? "motor" : studies::printable(c.file.name);
  return name + ": the stator as a solid\n\n" + numbers_table(c) + "\n" +
         mesh_text("solid", c.solid.mesh) + mesh_text("coarser mesh", c.solid.coarser_mesh) + "\n" +
         modes_table(c) + untold_sentence(c.solid) + share_sentence(c);
}

std::string solid_json(const SolidComparison& c) {
  Json json = motor_json(c.file);
  Json units = parameter_units_json(c.file);
  json["solid"] = solid_part(c);
  json["coarser_mesh"]["mesh"] = mesh_json(c.solid.coarser_mesh);
  add_numbers(json["coarser_mesh"], c.solid.coarser);
  json["plate"] = nullptr;
  if (c.plate) add_numbers(json["plate"], *c.plate);
  json["fitted_plate"] = nullptr;
  if (c.fitted_plate) {
    json["fitted_plate"]["teeth_stiffness_share"] = *c.share->share;
    add_numbers(json["fitted_plate"], *c.fitted_plate);
  }
  for (const StatorRow& row : kStatorRows) units[row.name] = row.unit;
  units["R"] = units["nodal_circles"] = units["axial_share"] = units["wavelengths"] = "1";
  units["radius"] = "m";
  json["units"] = units;
  return json_text(json);
}

}  // namespace twum::inline v0_1::cli
