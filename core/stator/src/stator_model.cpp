// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/stator/stator_model.hpp>

#include "mode_choice.hpp"
#include "mode_numbers.hpp"
#include "quantity_text.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace twum::stator {
namespace {

Derived undifferentiated(double value) {
  Derived number(value);
  for (double& d : number.d) d = std::numeric_limits<double>::quiet_NaN();
  return number;
}

// A plain number without derivatives, a dual one as it is.
Derived published(double value) { return undifferentiated(value); }
Derived published(const Derived& value) { return value; }

template <typename S>
StatorModel published(const ModeNumbers<S>& m) {
  StatorModel model;
  model.frequency = published(m.frequency);
  model.modal_mass = published(m.modal_mass);
  model.modal_stiffness = published(m.modal_stiffness);
  model.neutral_plane_distance = published(m.neutral_plane_distance);
  model.tangential_share = published(m.tangential_share);
  model.force_factor = published(m.force_factor);
  model.blocked_capacitance = published(m.blocked_capacitance);
  model.coupling_factor = published(m.coupling_factor);
  model.ceramic_stress = published(m.ceramic_stress);
  for (const S& value : m.shape_values) model.shape_values.push_back(published(value));
  return model;
}

RadialFunction normalized(const RadialFunction& shape, double radius) {
  auto pieces = shape.pieces();
  const double scale = 1 / shape(radius);
  for (auto& piece : pieces) {
    for (double& coefficient : piece.coefficients) coefficient *= scale;
  }
  return RadialFunction(std::move(pieces));
}

std::string range_of(const StatorPlate<double>& plate) {
  return "between " + quantity_text(plate.segments.front().inner, "m") + " and " +
         quantity_text(plate.segments.back().outer, "m");
}

bool lies_on(const StatorPlate<double>& plate, double radius) {
  return radius >= plate.segments.front().inner && radius <= plate.segments.back().outer;
}

void check_wave(const StatorGeometry& g, const StatorPlate<double>& plate, int wavelengths,
                double contact_radius) {
  if (wavelengths < 1) {
    throw InputError("wavelengths must be a whole number of 1 or more, but is " +
                     std::to_string(wavelengths));
  }
  if (2 * g.electrodes.waves_per_phase > wavelengths) {
    throw InputError("electrodes_waves_per_phase must be at most half of the " +
                     std::to_string(wavelengths) +
                     " wavelengths, so that two phases fit round the stator, but is " +
                     quantity_text(g.electrodes.waves_per_phase, "1"));
  }
  if (!lies_on(plate, contact_radius)) {
    throw InputError("contact_radius must lie on the stator, " + range_of(plate) + ", but is " +
                     quantity_text(contact_radius, "m"));
  }
}

void check_track(const StatorPlate<double>& plate, double contact_radius,
                 std::span<const double> offsets) {
  if (offsets.empty()) return;
  const auto [inward, outward] = std::minmax_element(offsets.begin(), offsets.end());
  for (const double offset : {*inward, *outward}) {
    if (lies_on(plate, contact_radius + offset)) continue;
    throw InputError("contact_width must leave the contact track on the stator, " +
                     range_of(plate) + ", but the track reaches " +
                     quantity_text(contact_radius + offset, "m"));
  }
}

// The modes of a stator and the one that was chosen.
struct Modes {
  StatorPlate<double> plate;
  std::vector<Order> orders;
  ModePlace wave;
  ModeIdentity identity;
  std::vector<ModePlace> others;  // nearest frequency first

  const Order& order() const { return orders[wave.order]; }
  const StatorMode& mode(const ModePlace& place) const {
    return orders[place.order].modes[place.mode];
  }
  double distance(const ModePlace& place) const {
    return std::abs(mode(place).frequency - mode(wave).frequency);
  }
};

Modes find_modes(const StatorGeometry& geometry, int wavelengths, double contact_radius,
                 PlateTheory theory, std::span<const double> offsets, OtherModes others) {
  Modes modes{make_plate(geometry, plain_numbers(geometry, contact_radius)), {}, {}, {}, {}};
  check_wave(geometry, modes.plate, wavelengths, contact_radius);
  check_track(modes.plate, contact_radius, offsets);
  const int beside = others == OtherModes::found ? 2 : 0;
  const int lowest = std::max(0, wavelengths - beside);
  for (int n = lowest; n <= wavelengths + beside; ++n) {
    modes.orders.push_back(solve_order(modes.plate, theory, geometry.support, n, contact_radius));
  }
  modes.wave.order = static_cast<std::size_t>(wavelengths - lowest);
  const double ring_inner =
      geometry.web ? geometry.web->outer_radius : modes.plate.segments.front().inner;
  const Choice choice = choose_mode(modes.order(), modes.plate, ring_inner);
  modes.wave.mode = choice.mode;
  modes.identity = choice.identity;
  if (others == OtherModes::found) modes.others = by_distance(modes.orders, modes.wave);
  return modes;
}

// Distance to the nearest other mode (P4.7). It has no derivative where two others are equally near, where
// it is zero, and where the other mode crosses one of its own order.
Derived mode_separation(const Modes& modes, const StatorPlate<Derived>* dual_plate) {
  if (modes.others.empty()) return undifferentiated(std::numeric_limits<double>::quiet_NaN());
  const ModePlace nearest = modes.others[0];
  const double value = modes.distance(nearest);
  const double tie = 1e-9 * modes.mode(modes.wave).frequency;
  const bool kink = value < tie || modes.distance(modes.others[1]) - value < tie ||
                    crosses(modes.orders[nearest.order].spectrum, nearest.mode);
  if (!dual_plate || kink) return undifferentiated(value);
  const auto frequency = [&](const ModePlace& place) {
    const Order& order = modes.orders[place.order];
    return sqrt(derived_eigenvalue(order.mesh, dual_plate->segments, order.spectrum, place.mode)) /
           (2 * std::numbers::pi);
  };
  return magnitude(frequency(nearest) - frequency(modes.wave));
}

// Numbers of the wave's mode, differentiated if that is wanted and possible.
StatorModel wave_numbers(const Modes& modes, const StatorGeometry& geometry, double contact_radius,
                         Derivatives derivatives, std::span<const double> offsets) {
  const Order& order = modes.order();
  const double waves = geometry.electrodes.waves_per_phase;
  const std::size_t mode = modes.wave.mode;
  if (derivatives == Derivatives::none || modes.identity == ModeIdentity::crossing) {
    const Solution<double> solution{order.spectrum.eigenvalues[mode], order.spectrum.vectors[mode]};
    StatorModel model =
        published(mode_numbers(order.mesh, modes.plate, plain_numbers(geometry, contact_radius),
                               solution, waves, offsets));
    model.mode_separation = mode_separation(modes, nullptr);
    return model;
  }
  const auto numbers = dual_numbers(geometry, contact_radius);
  const auto plate = make_plate(geometry, numbers);
  const auto solution =
      derived_solution(order.mesh, modes.plate.segments, plate.segments, order.spectrum, mode);
  StatorModel model = published(mode_numbers(order.mesh, plate, numbers, solution, waves, offsets));
  model.mode_separation = mode_separation(modes, &plate);
  return model;
}

}  // namespace

std::vector<PlateMode> stator_modes(const StatorGeometry& geometry, int nodal_diameters, int count,
                                    PlateTheory theory) {
  check_geometry(geometry);
  const auto plate = make_plate(geometry, plain_numbers(geometry, 0));
  return plate_modes(plate.segments, theory, geometry.support, nodal_diameters, count);
}

StatorModel stator_model(const StatorGeometry& geometry, int wavelengths, double contact_radius,
                         PlateTheory theory, Derivatives derivatives,
                         std::span<const double> offsets, OtherModes others) {
  check_geometry(geometry);
  const Modes modes = find_modes(geometry, wavelengths, contact_radius, theory, offsets, others);
  StatorModel model = wave_numbers(modes, geometry, contact_radius, derivatives, offsets);
  const Order& order = modes.order();
  model.shape = normalized(
      deflection(order.mesh, modes.plate.segments, order.spectrum.vectors[modes.wave.mode]),
      contact_radius);
  model.nodal_circles = modes.mode(modes.wave).nodal_circles;
  model.identity = modes.identity;
  for (const ModePlace& place : modes.others) model.unwanted.push_back(modes.mode(place));
  model.joint_edges = find_edges(geometry).joint;
  return model;
}

}  // namespace twum::stator
