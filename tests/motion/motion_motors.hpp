// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/csv_rows.hpp"
#include "support/driven_motors.hpp"

#include <twum/motion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

namespace twum::test {

/// The motor of examples/motors/drive-60.yaml with an elastic layer and one slice, to which most numbers of the theory of motion
/// belong.
inline MotorDesign elastic_60(double inertia, double voltage = 140, double frequency = 40.8e3) {
  MotorDesign design = driven_motor(voltage, frequency);
  design.stator.wavelengths = 9;
  design.stator.contact_radius = 0.0265;
  design.stator.contact_width = 0.004;
  design.stator.neutral_plane_distance = 0.003;
  design.stator.quality_factor = 153;
  design.stator.loss_tangent = 0;
  design.rotor.inertia = inertia;
  return design;
}

/// The motor of a row of reference/motion: elastic, one slice.
/// @param frequency, voltage  names of their columns
inline MotorDesign motor_of_row(const CsvRow& row, const char* frequency, const char* voltage) {
  MotorDesign d;
  Stator& s = d.stator;
  s.wavelengths = row["n"], s.contact_radius = row["r"], s.contact_width = row["b"];
  s.neutral_plane_distance = row["a"], s.frequency = row[frequency], s.voltage = row[voltage];
  s.resonance_frequency = row["f_r"], s.modal_mass = row["m"], s.modal_damping = row["d"];
  s.force_factor = row["Theta"];
  d.layer.thickness = row["h"], d.layer.youngs_modulus = row["E"];
  d.layer.given_shear_modulus = row["G"], d.layer.loss_factor = 0, d.layer.density = 0;
  d.friction = {row["mu"], row["mu"]}, d.preload = row["F_N"];
  d.rotor.inertia = row["J"], d.load = ShaftLoad{.damping = row["c_L"]};
  return d;
}

/// Place of an output among the rows of a plant's gains, which have none of the angle.
inline std::size_t row_of_gains(const motion::LinearPlant& plant, const std::string& output) {
  const auto names = [](const motion::Signal& one) { return one.name; };
  const auto place = std::ranges::find(plant.outputs, output, names) - plant.outputs.begin();
  const auto angle = std::ranges::find(plant.outputs, "angle", names) - plant.outputs.begin();
  return static_cast<std::size_t>(place - (place > angle ? 1 : 0));
}

/// A number, or "time:value,time:value,...".
inline motion::Profile profile_of(const std::string& text) {
  if (text.find(':') == std::string::npos) return std::stod(text);
  std::vector<motion::Profile::Row> rows;
  std::istringstream in(text);
  for (std::string row; std::getline(in, row, ',');)
    rows.emplace_back(std::stod(row), std::stod(row.substr(row.find(':') + 1)));
  return motion::Profile(rows);
}

/// A_1 of a motor with one slice (D1.5) [m].
inline double contact_opens_at(const MotorDesign& d) {
  return d.preload * d.layer.thickness /
         (2 * std::numbers::pi * d.stator.contact_radius * d.stator.contact_width *
          d.layer.youngs_modulus);
}

/// mu F_N r [N m].
inline double largest_torque(const MotorDesign& d) {
  return d.friction.kinetic * d.preload * d.stator.contact_radius;
}

/// Equally spaced times from 0 to `end`.
inline std::vector<double> times_to(double end, int count) {
  std::vector<double> times;
  for (int k = 0; k <= count; ++k) times.push_back(end * k / count);
  return times;
}

/// The time of the first event of a kind; -1 without one.
inline double time_of(const motion::Motion& m, motion::MotionEventKind kind) {
  const auto found = std::ranges::find(m.events, kind, &motion::MotionEvent::kind);
  return found == m.events.end() ? -1 : found->time;
}

inline int count_of(const motion::Motion& m, motion::MotionEventKind kind) {
  return static_cast<int>(std::ranges::count(m.events, kind, &motion::MotionEvent::kind));
}

}  // namespace twum::test
