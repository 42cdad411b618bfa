// SPDX-License-Identifier: Apache-2.0
#include "stator/solid_sector.hpp"

#include "support/scratch_folder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace twum::test {
namespace {

using Index = std::array<int, 3>;  // along radius, circumference and axis, in half bricks

// Corners, then middles of edges, of CalculiX's brick with 20 nodes, in half bricks.
constexpr std::array<Index, 20> kNodes{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2},
                                        {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 0}, {2, 1, 0},
                                        {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2}, {1, 2, 2},
                                        {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};

struct Brick {
  Index corner;
  int solid;
};

class Deck {
 public:
  explicit Deck(const SolidSector& sector) : sector_(sector) {
    const int around = sector.tooth_bricks + 2;
    for (int i = 0; i + 1 < static_cast<int>(sector.radii.size()); ++i) {
      for (int k = 0; k + 1 < static_cast<int>(sector.heights.size()); ++k) {
        const auto& fill = sector.fill[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
        for (int j = 0; j < around && fill.solid >= 0; ++j) {
          const bool in_slot = j == 0 || j == around - 1;
          if (!(fill.tooth_only && in_slot)) add({{2 * i, 2 * j, 2 * k}, fill.solid});
        }
      }
    }
  }

  void write(std::ostream& out, int n, int modes) const {
    out << std::setprecision(12) << "*NODE,NSET=ALL\n";
    for (const auto& [index, number] : nodes_) {
      const auto [x, y, z] = position(index);
      out << number << "," << x << "," << y << "," << z << "\n";
    }
    write_elements(out);
    write_sides(out);
    if (sector_.clamped) {
      out << "*BOUNDARY\n";
      for (const auto& [index, number] : nodes_) {
        // CalculiX takes the held nodes of the dependent side from the other side.
        if (index[0] == 0 && index[1] > 0) out << number << ",1,3\n";
      }
    }
    out << "*STEP\n*FREQUENCY\n"
        << modes << "\n*SELECT CYCLIC SYMMETRY MODES,NMIN=" << n << ",NMAX=" << n
        << "\n*NODE PRINT,NSET=ALL,GLOBAL=YES\nU\n*END STEP\n";
  }

  // Nodes at the reference radius, with their angle and height.
  struct Place {
    double angle;
    double height;
  };
  std::map<int, Place> circle() const {
    std::map<int, Place> found;
    for (const auto& [index, number] : nodes_) {
      const auto [x, y, z] = position(index);
      if (std::abs(std::hypot(x, y) - sector_.reference_radius) < 1e-9) {
        found[number] = {std::atan2(y, x), z};
      }
    }
    return found;
  }

 private:
  void add(const Brick& brick) {
    bricks_.push_back(brick);
    for (const Index& offset : kNodes) {
      Index index = brick.corner;
      for (std::size_t d = 0; d < 3; ++d) index[d] += offset[d];
      nodes_.try_emplace(index, static_cast<int>(nodes_.size()) + 1);
    }
  }

  int node(const Brick& brick, const Index& offset) const {
    return nodes_.at(
        {brick.corner[0] + offset[0], brick.corner[1] + offset[1], brick.corner[2] + offset[2]});
  }

  static double between(const std::vector<double>& lines, int half) {
    const auto line = static_cast<std::size_t>(half / 2);
    return half % 2 == 0 ? lines[line] : 0.5 * (lines[line] + lines[line + 1]);
  }

  std::array<double, 3> position(const Index& index) const {
    const double radius = between(sector_.radii, index[0]);
    const double pitch = 2 * std::numbers::pi / sector_.sectors;
    const double slot = sector_.slot_width / radius;
    std::vector<double> lines{-pitch / 2};
    for (int j = 0; j <= sector_.tooth_bricks; ++j) {
      lines.push_back((pitch - slot) * (static_cast<double>(j) / sector_.tooth_bricks - 0.5));
    }
    lines.push_back(pitch / 2);
    const double angle = between(lines, index[1]);
    return {radius * std::cos(angle), radius * std::sin(angle), between(sector_.heights, index[2])};
  }

  void write_elements(std::ostream& out) const {
    for (std::size_t s = 0; s < sector_.solids.size(); ++s) {
      out << "*ELEMENT,TYPE=C3D20R,ELSET=S" << s << "\n";
      for (std::size_t b = 0; b < bricks_.size(); ++b) {
        if (bricks_[b].solid != static_cast<int>(s)) continue;
        out << b + 1;
        for (std::size_t n = 0; n < 20; ++n)
          out << (n == 10 ? ",\n" : ",") << node(bricks_[b], kNodes[n]);
        out << "\n";
      }
      const Solid& solid = sector_.solids[s];
      out << "*MATERIAL,NAME=M" << s << "\n*ELASTIC\n"
          << solid.youngs_modulus << "," << solid.poisson_ratio << "\n*DENSITY\n"
          << solid.density << "\n*SOLID SECTION,ELSET=S" << s << ",MATERIAL=M" << s << "\n";
    }
  }

  void write_sides(std::ostream& out) const {
    const int last = 2 * (sector_.tooth_bricks + 1);
    for (const auto& [name, row, face] :
         {std::tuple{"LOW", 0, "S3"}, std::tuple{"HIGH", last, "S5"}}) {
      out << "*SURFACE,NAME=" << name << "\n";
      for (std::size_t b = 0; b < bricks_.size(); ++b) {
        if (bricks_[b].corner[1] == row) out << b + 1 << "," << face << "\n";
      }
    }
    out << "*TIE,NAME=SIDES,CYCLIC SYMMETRY,POSITION TOLERANCE=1e-7\nLOW,HIGH\n*CYCLIC SYMMETRY "
           "MODEL,N="
        << sector_.sectors << ",NGRAPH=1,TIE=SIDES\n0.,0.,0.,0.,0.,1.\n";
  }

  const SolidSector& sector_;
  std::map<Index, int> nodes_;
  std::vector<Brick> bricks_;
};

void run(const Deck& deck, int n, int modes, const ScratchFolder& scratch) {
  {
    std::ofstream file(scratch.path("sector.inp"));
    deck.write(file, n, modes);
    if (!file) throw std::runtime_error("cannot write " + scratch.path("sector.inp"));
  }
  const std::string command = "cd '" + scratch.folder() + "' && ccx -i sector >sector.log 2>&1";
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error("ccx failed or is missing; install the Debian package calculix-ccx");
  }
}

// Frequencies of the table, one for each eigenvalue number.
std::vector<double> frequencies(const std::string& path) {
  std::ifstream file(path);
  std::vector<double> found;
  for (std::string line;
       std::getline(file, line) && line.find("P A R T I C I P") == std::string::npos;) {
    std::istringstream stream(line);
    int n = 0;
    int mode = 0;
    double eigenvalue = 0;
    double omega = 0;
    double frequency = 0;
    if (stream >> n >> mode >> eigenvalue >> omega >> frequency) found.push_back(frequency);
  }
  return found;
}

// Sums of squares, real and imaginary part together: of all nodes, of those at the reference radius, and of the
// highest of these.
struct Motion {
  double axial{0};
  double all{0};
  double circle_axial{0};
  int circle_lines{0};
  double top_axial{0};
  double top_tangential{0};
};

std::vector<Motion> motions_of(const std::string& path, const std::map<int, Deck::Place>& circle) {
  double top = -1;
  for (const auto& [number, place] : circle) top = std::max(top, place.height);
  std::ifstream file(path);
  std::vector<Motion> motions;  // of each eigenvalue number
  for (std::string line; std::getline(file, line);) {
    if (line.find("E I G E N V A L U E    N U M B E R") != std::string::npos)
      motions.emplace_back();
    std::istringstream stream(line);
    int node = 0;
    double x = 0;
    double y = 0;
    double z = 0;
    if (motions.empty() || !(stream >> node >> x >> y >> z)) continue;
    Motion& motion = motions.back();
    motion.axial += z * z;
    motion.all += x * x + y * y + z * z;
    const auto found = circle.find(node);
    if (found == circle.end()) continue;
    motion.circle_axial += z * z;
    ++motion.circle_lines;
    const auto& place = found->second;
    if (place.height < top - 1e-9) continue;
    const double tangential = y * std::cos(place.angle) - x * std::sin(place.angle);
    motion.top_axial += z * z;
    motion.top_tangential += tangential * tangential;
  }
  return motions;
}

}  // namespace

std::vector<SolidMode> bending_modes(const SolidSector& sector, int nodal_diameters, int modes) {
  const ScratchFolder scratch;
  const Deck deck(sector);
  run(deck, nodal_diameters, modes, scratch);
  const auto all = frequencies(scratch.path("sector.dat"));
  const auto motions = motions_of(scratch.path("sector.dat"), deck.circle());
  if (all.empty() || motions.size() < all.size()) throw std::runtime_error("ccx wrote no modes");
  std::vector<SolidMode> bending;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Motion& motion = motions[i];
    const bool again =  // sine and cosine
        !bending.empty() && std::abs(all[i] - bending.back().frequency) < 1e-5 * all[i];
    if (again || motion.axial < 0.5 * motion.all) continue;
    // CalculiX gives one sector of a wave that travels round a generalized mass of 1; a standing wave on all
    // sectors has half of the mean. Two lines, real and imaginary, belong to each node.
    const double amplitude_squared = motion.circle_axial / (0.5 * motion.circle_lines);
    bending.push_back({all[i], 0.5 * sector.sectors / amplitude_squared,
                       std::sqrt(motion.top_tangential / motion.top_axial)});
  }
  return bending;
}

}  // namespace twum::test
