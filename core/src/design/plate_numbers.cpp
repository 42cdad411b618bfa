// SPDX-License-Identifier: Apache-2.0
#include "design/plate_numbers.hpp"

#include <twum/base/error.hpp>
#include <twum/core/plate.hpp>

#include <algorithm>
#include <limits>
#include <string_view>

namespace twum::inline v0_1 {
namespace {

using P = Parameter;
using N = PlateNumber;
using stator::Derivatives;
using stator::Dimension;
using stator::OtherModes;
using stator::StatorModel;

constexpr double kNoPlate = std::numeric_limits<double>::quiet_NaN();

// Teeth do not rotate with the cross section below them. Shear reduces the lever of the section only (P4.3).
stator::Derived lever_of(const MotorDesign& design, const StatorModel& plate) {
  const auto& teeth = design.stator.geometry->teeth;
  const double radius = design.stator.contact_radius;
  const bool toothed = teeth && radius > teeth->inner_radius && radius < teeth->outer_radius;
  return toothed ? plate.neutral_plane_distance
                 : plate.neutral_plane_distance * plate.tangential_share;
}

// A warm stator differs by a factor in some of its numbers (H3.1).
stator::Derived drifted(const MotorDesign& design, stator::Derived number, std::size_t which) {
  const PlateDrift& drift = design.stator.plate_drift;
  switch (static_cast<N>(which)) {
    case N::resonance_frequency: return number * drift.resonance_frequency;
    case N::force_factor: return number * drift.force_factor;
    case N::blocked_capacitance: return number * drift.blocked_capacitance;
    default: return number;
  }
}

std::array<stator::Derived, kPlateNumbers> plate_values(const MotorDesign& design,
                                                        const StatorModel& plate) {
  std::array<stator::Derived, kPlateNumbers> numbers{
      lever_of(design, plate),   plate.frequency,       plate.modal_mass,     plate.force_factor,
      plate.blocked_capacitance, plate.mode_separation, plate.ceramic_stress, plate.stator_mass};
  std::copy_n(plate.shape_values.begin(), kShapePoints.size(),
              numbers.begin() + index_of(N::shape));
  for (std::size_t i = 0; i < kPlateNumbers; ++i) numbers[i] = drifted(design, numbers[i], i);
  return numbers;
}

// A phase of twice the waves has twice the force and twice the charge (P4.4, P4.5); slots count as their width (P1.8); the
// points of the shape move with the width.
double slope_of(const MotorDesign& design, const StatorModel& plate, const stator::Derived& number,
                std::size_t which, Parameter moved) {
  if (const auto dimension = dimension_of(moved)) return derivative(number, *dimension);
  const stator::StatorGeometry& g = *design.stator.geometry;
  if (moved == P::electrodes_waves_per_phase) {
    const bool charge =
        which == index_of(N::force_factor) || which == index_of(N::blocked_capacitance);
    return charge ? number.v / g.electrodes.waves_per_phase : 0;
  }
  if (moved == P::teeth_count)
    return derivative(number, Dimension::teeth_slot_width) * g.teeth->slot_width / g.teeth->count;
  if (moved == P::contact_width && which >= index_of(N::shape)) {
    const double point = kShapePoints[which - index_of(N::shape)];
    const Stator& s = design.stator;
    return 0.5 * point * plate.shape.slope(s.contact_radius + 0.5 * s.contact_width * point);
  }
  return 0;
}

}  // namespace

std::array<double, kPlateNumbers> plate_numbers(const MotorDesign& design) {
  std::array<double, kPlateNumbers> values{};
  try {
    const auto numbers =
        plate_values(design, *plate_model(design, OtherModes::none, Derivatives::none));
    std::transform(numbers.begin(), numbers.end(), values.begin(),
                   [](const auto& x) { return x.v; });
  } catch (const InputError&) {
    values.fill(kNoPlate);
  } catch (const EvaluationError&) {
    values.fill(kNoPlate);
  }
  return values;
}

std::array<std::array<double, kParameterCount>, kPlateNumbers> plate_jacobian(
    const MotorDesign& design) {
  const auto plate = plate_model(design, OtherModes::none);
  const auto numbers = plate_values(design, *plate);
  std::array<std::array<double, kParameterCount>, kPlateNumbers> jacobian{};
  for (std::size_t moved = 0; moved < kParameterCount; ++moved) {
    const auto parameter = static_cast<Parameter>(moved);
    if (!in_use(design, parameter)) continue;
    for (std::size_t i = 0; i < kPlateNumbers; ++i)
      jacobian[i][moved] = slope_of(design, *plate, numbers[i], i, parameter);
  }
  return jacobian;
}

double mode_separation(const MotorDesign& design) {
  try {
    return plate_separation(design, Derivatives::none).v;
  } catch (const Error&) {  // no plate, or none that carries the wave
    return kNoPlate;
  }
}

std::array<double, kParameterCount> mode_separation_slopes(const MotorDesign& design) {
  const auto plate = plate_model(design, OtherModes::none, Derivatives::none);
  const stator::Derived separation = plate_separation(design, Derivatives::all);
  std::array<double, kParameterCount> slopes{};
  for (std::size_t moved = 0; moved < kParameterCount; ++moved) {
    const auto parameter = static_cast<Parameter>(moved);
    if (in_use(design, parameter))
      slopes[moved] = slope_of(design, *plate, separation, index_of(N::mode_separation), parameter);
  }
  return slopes;
}

std::string follows_from_geometry(const MotorDesign& design, Parameter parameter) {
  const bool shape = parameter == P::shape_exponent || parameter == P::shape_root;
  if (!design.stator.geometry || !(shape || plate_number_of(parameter))) return {};
  return std::string(info(parameter).name) +
         " follows from the geometry of the stator and cannot be set; change the geometry";
}

std::vector<std::string> geometry_complaints(const MotorDesign& design) {
  const Stator& s = design.stator;
  if (!s.geometry) return {};
  const RadialShape& shape = s.radial_shape;
  if (!shape.table.empty() || shape.exponent != 0 || shape.root != 0)
    return {"radial_shape must be left out with a geometry, from which it follows, but is given"};
  if (s.resonance_frequency || s.modal_mass || s.force_factor || s.blocked_capacitance != 0)
    return {
        "geometry must stand without modal data, which follow from it, but "
        "resonance_frequency, modal_mass, force_factor or blocked_capacitance is given"};
  if (auto wrong = geometry_complaints(*s.geometry); !wrong.empty()) return wrong;
  try {
    const auto plate = plate_model(design, OtherModes::none, Derivatives::none);
    const auto low = std::min_element(plate->shape_values.begin(), plate->shape_values.end(),
                                      [](const auto& a, const auto& b) { return a.v < b.v; });
    if (low->v > 0) return {};
    return {
        "contact_width must leave the track where the wave of the stator has one sign, but the "
        "wave has a node on it"};
  } catch (const InputError& error) {
    return {error.what()};
  } catch (const EvaluationError&) {
    return {};  // a valid plate without a mode for this wave
  }
}

}  // namespace twum::inline v0_1
