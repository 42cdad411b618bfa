// SPDX-License-Identifier: Apache-2.0
#include "solid/solid_stator.hpp"

#include "output.hpp"
#include "solid/calculix.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>
#include <twum/core/plate.hpp>
#include <twum/solid/deck.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace twum::inline v0_1::cli {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
// Modes of one number of nodal diameters that CalculiX looks for. The plate has the wave among its eight lowest; the solid has those
// within the plane between them.
constexpr int kModes = 8;

// A deck and what it is for.
struct Task {
  std::string name;
  const solid::Sector* sector;
  int order;  // number of nodal diameters
};

void write_deck(const MotorDesign& design, const std::string& folder, const Task& task) {
  const std::string path = folder + "/" + task.name + ".inp";
  Output output(path);
  output.write(solid::deck_text(*task.sector, *design.stator.geometry, task.order,
                                (task.order > 0 ? 2 : 1) * kModes));
  output.finish();
}

std::vector<solid::Eigenmode> modes_of(const std::string& folder, const Task& task) {
  const std::string path = folder + "/" + task.name + ".dat";
  std::ifstream file(path);
  try {
    return solid::read_eigenmodes(file, *task.sector);
  } catch (const InputError& error) {
    throw OutputError(path + ": " + error.what());
  }
}

solid::SolidWave wave_in(const MotorDesign& design, const Task& task,
                         const std::vector<solid::Eigenmode>& modes) {
  return solid::solid_wave(*task.sector, *design.stator.geometry, task.order,
                           design.stator.contact_radius, modes);
}

StatorNumbers numbers_of(const solid::SolidWave& wave, double blocked_capacitance) {
  return {wave.frequency,
          wave.modal_mass,
          wave.force_factor,
          blocked_capacitance,
          wave.tangential_ratio,
          wave.radial_ratio,
          kNone};
}

MeshSize size_of(const solid::Sector& sector, int elements) {
  return {elements, sector.count, sector.bricks.size(), sector.nodes.size()};
}

// The modes of all orders, and the place of the wave among them.
void sort_modes(SolidStator& solid, int order, double frequency) {
  const auto is_wave = [=](const solid::SolidMode& mode) {
    return mode.nodal_diameters == order && mode.frequency == frequency;
  };
  std::stable_sort(solid.modes.begin(), solid.modes.end(),
                   [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
  const auto found = std::find_if(solid.modes.begin(), solid.modes.end(), is_wave);
  solid.wave = static_cast<std::size_t>(found - solid.modes.begin());
  double nearest = kNone;
  for (const solid::SolidMode& mode : solid.modes)
    if (!is_wave(mode)) nearest = std::fmin(nearest, std::abs(mode.frequency - frequency));
  solid.numbers.mode_separation = nearest;
}

}  // namespace

SolidStator solve_solid(const MotorDesign& design, int elements, const std::string& folder) {
  const Stator& s = design.stator;
  const int n = static_cast<int>(s.wavelengths);
  const auto sector = solid::make_sector(*s.geometry, n, s.contact_radius, elements);
  const auto coarser = solid::make_sector(*s.geometry, n, s.contact_radius, elements / 2);
  SolidStator solid;
  solid.mesh = size_of(sector, elements), solid.coarser_mesh = size_of(coarser, elements / 2);
  std::vector<Task> tasks{{"wave", &sector, n}, {"coarser", &coarser, n}};
  for (const int order : {n - 2, n - 1, n + 1, n + 2}) {
    if (order > solid::most_nodal_diameters(sector))
      solid.untold.push_back(order);
    else if (order >= 0)
      tasks.push_back({"waves-" + std::to_string(order), &sector, order});
  }
  std::vector<std::string> names;
  for (const Task& task : tasks) write_deck(design, folder, task), names.push_back(task.name);
  run_calculix(folder, names);

  const double capacitance = get(design, Parameter::blocked_capacitance);
  const auto coarse_modes = modes_of(folder, tasks[1]);
  solid.coarser = numbers_of(wave_in(design, tasks[1], coarse_modes), capacitance);
  for (const Task& task : tasks) {
    if (task.sector != &sector) continue;
    const auto modes = modes_of(folder, task);
    for (const solid::Eigenmode& mode : modes)
      if (mode.frequency > 0)
        solid.modes.push_back(solid::described(sector, task.order, s.contact_radius, mode));
    if (task.order != n) continue;
    const auto wave = wave_in(design, task, modes);
    solid.numbers = numbers_of(wave, capacitance);
    solid.shape = wave.shape;
    solid.section = solid::bent_section(sector, n, s.contact_radius, modes[wave.mode]);
  }
  sort_modes(solid, n, solid.numbers.resonance_frequency);
  return solid;
}

StatorNumbers numbers_of_plate(const MotorDesign& design) {
  const auto plate = plate_model(design);
  const Stator& s = design.stator;
  const double waves = s.wavelengths / s.contact_radius;
  return {plate->frequency.v,
          plate->modal_mass.v,
          plate->force_factor.v,
          plate->blocked_capacitance.v,
          get(design, Parameter::neutral_plane_distance) * waves,
          plate->shape.slope(s.contact_radius) / waves,
          plate->mode_separation.v};
}

}  // namespace twum::inline v0_1::cli
