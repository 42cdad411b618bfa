// SPDX-License-Identifier: Apache-2.0
#include "plant_nodes.hpp"

#include <twum/base/error.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {
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
  if (options.amplitudes < 2 || options.speed_ratios < 2)
    throw InputError("a table needs at least two amplitudes and two speed ratios");
}

const MotorDesign& with_table(const MotorDesign& design, const PlantTableOptions& options) {
  require_table(design, options);
  return design;
}

// A wave without losses but those of the stator at its resonance: Theta u_0 / (omega d_s).
double free_amplitude(const MotionModel& model, double voltage) {
  const double omega = std::sqrt(model.stiffness_of_wave / model.mass);
  return model.drive_force(voltage) / (omega * model.damping);
}

PlantTable numbers_of(const MotorDesign& design, const MotionModel& model) {
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

// Axes of a table, evenly spaced in x = asinh(A / A_1) and y = v / (1 + v).
void add_axes(PlantTable& table, const MotionModel& model, const PlantTableOptions& options) {
  const double largest = options.largest_amplitude > 0 ? options.largest_amplitude
                                                       : 2 * free_amplitude(model, table.voltage);
  // Without a preload there is no A_1, and the contact is nothing at any amplitude.
  const double scale = model.full_contact_amplitude > 0 ? model.full_contact_amplitude : largest;
  const double last = std::asinh(largest / scale);
  const auto share = [](std::size_t i, std::size_t count) {
    return static_cast<double>(i) / static_cast<double>(count - 1);
  };
  for (std::size_t j = 0; j < options.amplitudes; ++j)
    table.amplitudes.push_back(scale * std::sinh(last * share(j, options.amplitudes)));
  for (std::size_t i = 0; i < options.speed_ratios; ++i) {
    const double y = share(i, options.speed_ratios);
    table.speed_ratios.push_back(y / (1 - y));
  }
}

}  // namespace

PlantNodes::PlantNodes(const MotorDesign& design, const PlantTableOptions& options)
    : model_(with_table(design, options)), contact_(model_), frame_(numbers_of(design, model_)) {
  add_axes(frame_, model_, options);
}

double PlantNodes::speed(std::size_t amplitude, std::size_t speed_ratio) const {
  const double omega = 2 * std::numbers::pi * frame_.frequency;
  const double a = std::max(frame_.amplitudes[amplitude], contact_.floor());
  const double crest = model_.crest_per_amplitude * omega * a;
  const double fastest = kFastestShare * omega / model_.motor.design().stator.wavelengths;
  return std::clamp(frame_.speed_ratios[speed_ratio] * crest, kAtRest, fastest);
}

ContactForces PlantNodes::at(std::size_t amplitude, std::size_t speed_ratio, double side) {
  return contact_.at(frame_.amplitudes[amplitude], side * speed(amplitude, speed_ratio),
                     frame_.frequency);
}

}  // namespace twum::inline v0_1::motion
