// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/plant_table.hpp>

#include "plant_nodes.hpp"

#include <twum/base/error.hpp>

#include <iomanip>
#include <sstream>
#include <string>

namespace twum::inline v0_1::motion {
namespace {

std::string no_answer(double amplitude, double speed, const std::string& why) {
  std::ostringstream text;
  text << std::setprecision(3) << "the contact has no answer at an amplitude of " << amplitude
       << " m and " << speed << " rad/s (" << why << "), so there is no table of it";
  return text.str();
}

// Fills the tables row by row, and tells the share that is done.
class Filling {
 public:
  Filling(PlantTable& table, PlantNodes& nodes, const std::function<bool(double)>& go_on)
      : table_(table), nodes_(nodes), go_on_(go_on) {}

  bool fill() { return fill_side(table_.along, 1) && fill_side(table_.against, -1); }

 private:
  bool fill_side(ContactTable& side, double sign) {
    const std::size_t rows = table_.speed_ratios.size();
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < table_.amplitudes.size(); ++j) add_node(side, j, i, sign);
      if (go_on_ && !go_on_(++done_ / (2.0 * static_cast<double>(rows)))) return false;
    }
    return true;
  }

  void add_node(ContactTable& side, std::size_t j, std::size_t i, double sign) {
    const ContactForces f = nodes_.at(j, i, sign);
    if (!f.known)
      throw InputError(
          no_answer(table_.amplitudes[j], sign * nodes_.speed(j, i), nodes_.failure()));
    side.torque.push_back(f.torque);
    side.reactive_stiffness.push_back(f.stiffness.real());
    side.active_stiffness.push_back(f.stiffness.imag());
  }

  PlantTable& table_;
  PlantNodes& nodes_;
  const std::function<bool(double)>& go_on_;
  double done_{0};
};

}  // namespace

std::optional<PlantTable> tabulate(const MotorDesign& design, const PlantTableOptions& options) {
  PlantNodes nodes(design, options);
  PlantTable table = nodes.frame();
  if (!Filling(table, nodes, options.go_on).fill()) return {};
  return table;
}

}  // namespace twum::inline v0_1::motion
