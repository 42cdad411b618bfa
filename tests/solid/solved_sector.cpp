// SPDX-License-Identifier: Apache-2.0
#include "solid/solved_sector.hpp"

#include "support/scratch_folder.hpp"

#include <twum/solid/deck.hpp>
#include <twum/solid/wave.hpp>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

namespace twum::test {

std::vector<solid::Eigenmode> calculix_modes(const solid::Sector& sector,
                                             const stator::StatorGeometry& geometry, int n,
                                             int modes) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path("sector.inp")) << solid::deck_text(sector, geometry, n, modes);
  const std::string command = "cd '" + scratch.folder() + "' && ccx -i sector >sector.log 2>&1";
  if (std::system(command.c_str()) != 0)
    throw std::runtime_error("ccx failed or is missing; install the Debian package calculix-ccx");
  std::ifstream results(scratch.path("sector.dat"));
  return solid::read_eigenmodes(results, sector);
}

std::vector<solid::Eigenmode> bending_modes(const solid::Sector& sector,
                                            const stator::StatorGeometry& geometry, int n,
                                            int modes, double contact_radius) {
  std::vector<solid::Eigenmode> bending;
  for (const auto& mode : calculix_modes(sector, geometry, n, modes))
    if (mode.frequency > 0 && solid::described(sector, n, contact_radius, mode).axial_share > 0.5)
      bending.push_back(mode);
  return bending;
}

stator::StatorGeometry metal_plate(double inner_radius, double outer_radius, double thickness,
                                   stator::InnerEdge support) {
  stator::StatorGeometry g;
  g.substrate = {inner_radius, outer_radius, thickness, 110e9, 0.3, 8800};
  g.ceramic = {inner_radius, outer_radius, 0.1 * thickness, 110e3, 0.3, 8.8e-3, -1e-10, 1e-8};
  g.electrodes.waves_per_phase = 1;
  g.support = support;
  return g;
}

}  // namespace twum::test
