// SPDX-License-Identifier: Apache-2.0
#include "support/reference_cases.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace twum::test {
namespace {

std::vector<std::string> split(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();  // files written with CRLF
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

std::vector<Row> read_numbers(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = split(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = split(line);
    Row row;
    for (std::size_t i = 0; i < cells.size(); ++i) row[names.at(i)] = std::stod(cells[i]);
    rows.push_back(row);
  }
  return rows;
}

MotorDesign design_from_row(const Row& row) {
  MotorDesign design;
  design.stator.wavelengths = row.at("wavelengths");
  design.stator.contact_radius = row.at("contact_radius");
  design.stator.contact_width = row.at("contact_width");
  design.stator.neutral_plane_distance = row.at("neutral_plane_distance");
  design.stator.frequency = row.at("frequency");
  design.stator.amplitude = row.at("amplitude");
  design.layer.thickness = row.at("thickness");
  design.layer.youngs_modulus = row.at("youngs_modulus");
  design.layer.given_shear_modulus = row.at("shear_modulus");
  design.layer.given_shear_viscosity = row.at("shear_viscosity");
  design.layer.given_inertia = row.at("inertia");
  design.friction = {row.at("kinetic_friction"), row.at("static_friction")};
  design.preload = row.at("preload");
  return design;
}

std::vector<ReferenceCase> read_reference_cases(const std::string& folder) {
  std::vector<ReferenceCase> cases;
  for (const Row& row : read_numbers(folder + "/designs.csv")) {
    cases.push_back({static_cast<int>(row.at("design")), design_from_row(row), {}, {}});
  }
  const auto find = [&](const Row& row) -> ReferenceCase& {
    return cases.at(static_cast<std::size_t>(row.at("design")));
  };
  for (const Row& row : read_numbers(folder + "/points.csv")) find(row).points.push_back(row);
  for (const Row& row : read_numbers(folder + "/metrics.csv")) find(row).metrics = row;
  return cases;
}

}  // namespace twum::test
