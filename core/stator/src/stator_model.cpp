// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/base/once.hpp>
#include <twum/stator/stator_model.hpp>

#include "mode_choice.hpp"
#include "mode_numbers.hpp"
#include "quantity_text.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace twum::inline v0_1::stator {
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

template <typename S>
StatorModel with_mass(StatorModel model, [[maybe_unused]] const StatorPlate<S>& plate) {
  model.stator_mass = published(mass_of(plate));
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

}  // namespace

// The modes that were solved, and those beside the wave once they are needed.
// Hidden, as are then templates of the standard library with its functions.
struct [[gnu::visibility("hidden")]] SolvedStator::Modes {
  StatorGeometry geometry;
  int wavelengths;
  double contact_radius;
  PlateTheory theory;
  std::vector<double> offsets;
  StatorPlate<double> plate;
  Order order;
  std::size_t wave;
  ModeIdentity identity;

  /// The wave among modes of n - 2 to n + 2, and the others, nearest frequency first.
  struct Found {
    std::vector<Order> orders;
    ModePlace wave;
    std::vector<ModePlace> others;

    double frequency(const ModePlace& place) const {
      return orders[place.order].frequencies[place.mode];
    }
    double distance(const ModePlace& place) const {
      return std::abs(frequency(place) - frequency(wave));
    }
  };
  /// All modes that are looked at.
  const Found& all() const {
    return all_.get([this] { return beside(kLowest); });
  }
  /// Those that determine the nearest of them: few of each order suffice, unless others may be as near or cross it.
  const Found& nearest() const {
    const Found& found = few_.get([this] { return beside(kFew); });
    return settle_nearest(found) ? found : all();
  }

  // P4.7
  Found beside(int count) const {
    Found found;
    const int lowest = std::max(0, wavelengths - 2);
    for (int n = lowest; n <= wavelengths + 2; ++n)
      found.orders.push_back(
          n == wavelengths ? order : solve_order(plate, theory, geometry.support, n, count));
    found.wave = {static_cast<std::size_t>(wavelengths - lowest), wave};
    found.others = by_distance(found.orders, found.wave);
    return found;
  }

  static bool settle_nearest(const Found& found) {
    if (found.others.empty()) return false;
    const double wave = found.frequency(found.wave);
    const double reach = wave + found.distance(found.others[0]) + kCrossing * wave;
    return std::all_of(found.orders.begin(), found.orders.end(), [&](const Order& order) {
      return order.mesh.nodal_diameters == found.orders[found.wave.order].mesh.nodal_diameters ||
             (!order.frequencies.empty() && order.frequencies.back() >= reach);
    });
  }

  Once<Found> few_{}, all_{};
};

SolvedStator::SolvedStator(const StatorGeometry& geometry, int wavelengths, double contact_radius,
                           PlateTheory theory, std::span<const double> offsets) {
  check_geometry(geometry);
  StatorPlate<double> plate = make_plate(geometry, plain_numbers(geometry, contact_radius));
  check_wave(geometry, plate, wavelengths, contact_radius);
  check_track(plate, contact_radius, offsets);
  Order order = solve_order(plate, theory, geometry.support, wavelengths, kLowest);
  const double ring_inner =
      geometry.web ? geometry.web->outer_radius : plate.segments.front().inner;
  const Choice choice = choose_mode(order, plate, ring_inner, contact_radius);
  modes_.reset(new Modes{geometry,
                         wavelengths,
                         contact_radius,
                         theory,
                         {offsets.begin(), offsets.end()},
                         std::move(plate),
                         std::move(order),
                         choice.mode,
                         choice.identity});
}

// Distance to the nearest other mode (P4.7). It has no derivative where two others are equally near, where
// it is zero, and where the other mode crosses one of its own order.
Derived SolvedStator::mode_separation(Derivatives derivatives) const {
  const Modes::Found& found = modes_->nearest();
  if (found.others.empty()) return undifferentiated(std::numeric_limits<double>::quiet_NaN());
  const ModePlace nearest = found.others[0];
  const double value = found.distance(nearest);
  const double tie = 1e-9 * found.frequency(found.wave);
  const bool kink = value < tie || found.distance(found.others[1]) - value < tie ||
                    crosses(found.orders[nearest.order].spectrum, nearest.mode);
  const bool wave_crosses = modes_->identity == ModeIdentity::crossing;
  if (derivatives == Derivatives::none || kink || wave_crosses) return undifferentiated(value);
  const auto plate =
      make_plate(modes_->geometry, dual_numbers(modes_->geometry, modes_->contact_radius));
  const auto frequency = [&](const ModePlace& place) {
    const Order& order = found.orders[place.order];
    return sqrt(derived_eigenvalue(order.mesh, plate.segments, order.spectrum, place.mode)) /
           (2 * std::numbers::pi);
  };
  return magnitude(frequency(nearest) - frequency(found.wave));
}

std::vector<StatorMode> SolvedStator::unwanted() const {
  const Modes::Found& all = modes_->all();
  std::vector<StatorMode> list;
  for (const ModePlace& place : all.others)
    list.push_back(
        described(all.orders[place.order], modes_->plate, modes_->contact_radius, place.mode));
  return list;
}

// Numbers of the wave's mode, differentiated if that is wanted and possible.
StatorModel SolvedStator::numbers(Derivatives derivatives) const {
  const Modes& m = *modes_;
  const double waves = m.geometry.electrodes.waves_per_phase;
  if (derivatives == Derivatives::none || m.identity == ModeIdentity::crossing) {
    const Solution<double> solution{m.order.spectrum.eigenvalues[m.wave],
                                    m.order.spectrum.vectors[m.wave]};
    return with_mass(
        published(mode_numbers(m.order.mesh, m.plate, plain_numbers(m.geometry, m.contact_radius),
                               solution, waves, m.offsets)),
        m.plate);
  }
  const auto numbers = dual_numbers(m.geometry, m.contact_radius);
  const auto plate = make_plate(m.geometry, numbers);
  const auto solution =
      derived_solution(m.order.mesh, m.plate.segments, plate.segments, m.order.spectrum, m.wave);
  return with_mass(
      published(mode_numbers(m.order.mesh, plate, numbers, solution, waves, m.offsets)), plate);
}

StatorModel SolvedStator::wave(Derivatives derivatives) const {
  const Modes& m = *modes_;
  StatorModel model = numbers(derivatives);
  model.mode_separation = undifferentiated(std::numeric_limits<double>::quiet_NaN());
  model.shape =
      normalized(deflection(m.order.mesh, m.plate.segments, m.order.spectrum.vectors[m.wave]),
                 m.contact_radius);
  model.nodal_circles =
      model.shape.sign_changes(m.plate.segments.front().inner, m.plate.segments.back().outer);
  model.identity = m.identity;
  model.joint_edges = find_edges(m.geometry).joint;
  return model;
}

std::vector<PlateMode> stator_modes(const StatorGeometry& geometry, int nodal_diameters, int count,
                                    PlateTheory theory) {
  check_geometry(geometry);
  const auto plate = make_plate(geometry, plain_numbers(geometry, 0));
  return plate_modes(plate.segments, theory, geometry.support, nodal_diameters, count);
}

StatorModel stator_model(const StatorGeometry& geometry, int wavelengths, double contact_radius,
                         PlateTheory theory, Derivatives derivatives,
                         std::span<const double> offsets, OtherModes others) {
  const SolvedStator solved(geometry, wavelengths, contact_radius, theory, offsets);
  StatorModel model = solved.wave(derivatives);
  if (others == OtherModes::none) return model;
  model.mode_separation = solved.mode_separation(derivatives);
  model.unwanted = solved.unwanted();
  return model;
}

const char* to_string(ModeIdentity value) noexcept {
  switch (value) {
    case ModeIdentity::clear: return "clear";
    case ModeIdentity::shared: return "shared";
    case ModeIdentity::crossing: return "crossing";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::stator
