// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/plant_table.hpp>

#include "contact.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <string>

namespace twum::motion {
namespace {

// Share of the speed of travel c = omega r / n that a tabulated rotor may reach. The table's last column stands for all larger speeds.
constexpr double kFastestShare = 0.5;
// Speed at which the contact of a rotor at rest is taken: the limit from one side (M4.1) [rad/s].
constexpr double kAtRest = 1e-12;

void require_table(const MotorDesign& design, const PlantTableOptions& options) {
  if (!design.stator.voltage)
    throw InputError("a plant needs a motor under a voltage; give stator.voltage and modal data");
  if (*design.stator.voltage == 0 && options.largest_amplitude == 0)
    throw InputError(
        "voltage must be more than 0 V for a plant, whose table reaches to the waves of that "
        "voltage");
  if (design.driver && (design.driver->inductance != 0 || design.driver->resistance != 0))
    throw InputError(
        "driver_inductance and driver_resistance must be 0 for a table of a plant, whose terminals "
        "have the voltage of its input; leave them out, or use twum move");
  if (design.load && design.load->stiffness != 0)
    throw InputError(
        "load_stiffness must be 0 N.m/rad for a plant: a spring on the shaft belongs to the load, "
        "which the tool that uses the plant applies");
}

std::string short_text(double value) {
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

// Rows and columns of a table, evenly spaced in x = asinh(A / A_1) and y = v / (1 + v).
struct Grid {
  double scale, last_x;
  std::size_t rows, columns;

  double amplitude(std::size_t j) const {
    return scale * std::sinh(last_x * static_cast<double>(j) / static_cast<double>(rows - 1));
  }
  double speed_ratio(std::size_t i) const {
    const double y = static_cast<double>(i) / static_cast<double>(columns - 1);
    return y / (1 - y);
  }
};

// A wave without losses but those of the stator at its resonance: Theta u_0 / (omega d_s).
double free_amplitude(const MotionModel& model, double voltage) {
  const double omega = std::sqrt(model.stiffness_of_wave / model.mass);
  return model.drive_force(voltage) / (omega * model.damping);
}

// The contact at any amplitude and speed ratio, at the design's frequency.
class TabulatedContact {
 public:
  TabulatedContact(const MotionModel& model, double frequency)
      : model_(&model), contact_(model), frequency_(frequency) {}

  /// @param side  1 for a rotor that turns as the wave drives it, else -1
  ContactForces at(double amplitude, double speed_ratio, double side) {
    const double omega = 2 * std::numbers::pi * frequency_;
    const double a = std::max(amplitude, 1e-7 * model_->full_contact_amplitude);
    const double crest = model_->crest_per_amplitude * omega * a;
    const double fastest = kFastestShare * omega / model_->motor.design().stator.wavelengths;
    const double speed = std::clamp(speed_ratio * crest, kAtRest, fastest);
    const ContactForces f = contact_.at(amplitude, side * speed, frequency_);
    if (!f.known)
      throw InputError("the contact has no answer at an amplitude of " + short_text(a) + " m and " +
                       short_text(side * speed) + " rad/s (" + contact_.failure() +
                       "), so there is no table of it");
    return f;
  }

 private:
  const MotionModel* model_;
  Contact contact_;
  double frequency_;
};

// Fills the tables row by row, and tells the share that is done.
class Filling {
 public:
  Filling(PlantTable& table, const Grid& grid, TabulatedContact& contact,
          const std::function<bool(double)>& go_on)
      : table_(table), grid_(grid), contact_(contact), go_on_(go_on) {}

  bool fill() {
    for (std::size_t j = 0; j < grid_.rows; ++j) table_.amplitudes.push_back(grid_.amplitude(j));
    for (std::size_t i = 0; i < grid_.columns; ++i)
      table_.speed_ratios.push_back(grid_.speed_ratio(i));
    return fill_side(table_.along, 1) && fill_side(table_.against, -1);
  }

 private:
  bool fill_side(ContactTable& side, double sign) {
    for (const double ratio : table_.speed_ratios) {
      for (const double amplitude : table_.amplitudes) {
        const ContactForces f = contact_.at(amplitude, ratio, sign);
        side.torque.push_back(f.torque);
        side.reactive_stiffness.push_back(f.stiffness.real());
        side.active_stiffness.push_back(f.stiffness.imag());
      }
      if (go_on_ && !go_on_(++done_ / (2.0 * static_cast<double>(grid_.columns)))) return false;
    }
    return true;
  }

  PlantTable& table_;
  const Grid& grid_;
  TabulatedContact& contact_;
  const std::function<bool(double)>& go_on_;
  double done_{0};
};

PlantTable without_contact(const MotorDesign& design, const MotionModel& model) {
  const ShaftLoad load = design.load.value_or(ShaftLoad{});
  PlantTable t{};
  t.modal_mass = model.mass, t.modal_damping = model.damping;
  t.modal_stiffness = model.stiffness_of_wave;
  t.force_factor = model.force_factor;
  t.blocked_capacitance = model.capacitance, t.loss_tangent = model.loss_tangent;
  t.rotor_inertia = *design.rotor.inertia, t.load_inertia = load.inertia;
  t.load_damping = load.damping, t.load_friction = load.friction;
  t.off_resistance = model.off_resistance;
  t.voltage = *design.stator.voltage, t.frequency = drive_frequency(design);
  t.opening_amplitude = model.full_contact_amplitude;
  t.holding_torque = model.holding_torque;
  t.crest_per_amplitude = model.crest_per_amplitude;
  return t;
}

}  // namespace

std::optional<PlantTable> tabulate(const MotorDesign& design, const PlantTableOptions& options) {
  require_table(design, options);
  if (options.amplitudes < 2 || options.speed_ratios < 2)
    throw InputError("a table needs at least two amplitudes and two speed ratios");
  const MotionModel model(design);
  PlantTable table = without_contact(design, model);
  const double largest = options.largest_amplitude > 0 ? options.largest_amplitude
                                                       : 2 * free_amplitude(model, table.voltage);
  // Without a preload there is no A_1, and the contact is nothing at any amplitude.
  const double scale = model.full_contact_amplitude > 0 ? model.full_contact_amplitude : largest;
  const Grid grid{scale, std::asinh(largest / scale), options.amplitudes, options.speed_ratios};
  TabulatedContact contact(model, table.frequency);
  if (!Filling(table, grid, contact, options.go_on).fill()) return {};
  return table;
}

}  // namespace twum::motion
