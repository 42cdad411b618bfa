// SPDX-License-Identifier: Apache-2.0
#include "mode_choice.hpp"

#include "plate_modes.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace twum::inline v0_1::stator {
namespace {

constexpr double kShared = 2;  // modal masses within this factor

}  // namespace

bool crosses(const Spectrum& spectrum, std::size_t mode) {
  const double own = spectrum.eigenvalues[mode];
  const auto near = [&](std::size_t other) {  // mode - 1 of 0 wraps round
    return other < spectrum.eigenvalues.size() &&
           std::abs(spectrum.eigenvalues[other] - own) < kCrossing * own;
  };
  return near(mode - 1) || near(mode + 1);
}

Order solve_order(const StatorPlate<double>& plate, PlateTheory theory, InnerEdge support,
                  int nodal_diameters, int count) {
  Order order{make_mesh(plate.segments, theory, support, nodal_diameters), {}, {}};
  order.spectrum = solve(order.mesh, plate.segments, count);
  for (const double eigenvalue : order.spectrum.eigenvalues)
    order.frequencies.push_back(frequency_of(eigenvalue, plate.segments));
  return order;
}

StatorMode described(const Order& order, const StatorPlate<double>& plate, double contact_radius,
                     std::size_t mode) {
  const auto shape = deflection(order.mesh, plate.segments, order.spectrum.vectors[mode]);
  const double at_contact = shape(contact_radius);
  return {order.mesh.nodal_diameters,
          shape.sign_changes(plate.segments.front().inner, plate.segments.back().outer),
          order.frequencies[mode], 1 / (at_contact * at_contact)};
}

Choice choose_mode(const Order& order, const StatorPlate<double>& plate, double ring_inner,
                   double contact_radius) {
  struct Candidate {
    std::size_t mode;
    double modal_mass;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < order.frequencies.size(); ++i) {
    if (order.frequencies[i] == 0) continue;  // rigid-body mode
    const auto shape = deflection(order.mesh, plate.segments, order.spectrum.vectors[i]);
    const double at_contact = shape(contact_radius);
    if (shape.sign_changes(ring_inner, plate.segments.back().outer) == 0)
      candidates.push_back({i, 1 / (at_contact * at_contact)});
  }
  if (candidates.empty()) {
    throw EvaluationError(
        "no-ring-mode",
        "no mode carries the travelling wave: each of the " + std::to_string(kLowest) +
            " lowest with " + std::to_string(order.mesh.nodal_diameters) + " nodal diameter" +
            (order.mesh.nodal_diameters == 1 ? "" : "s") +
            " changes its sign on the ring; check wavelengths, support, and the radii and "
            "thicknesses of web and ring");
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.modal_mass < b.modal_mass; });
  const std::size_t chosen = candidates.front().mode;
  if (crosses(order.spectrum, chosen)) return {chosen, ModeIdentity::crossing};
  const bool shared =
      candidates.size() > 1 && candidates[1].modal_mass < kShared * candidates.front().modal_mass;
  return {chosen, shared ? ModeIdentity::shared : ModeIdentity::clear};
}

std::vector<ModePlace> by_distance(const std::vector<Order>& orders, const ModePlace& chosen) {
  std::vector<ModePlace> others;
  for (std::size_t o = 0; o < orders.size(); ++o) {
    for (std::size_t m = 0; m < orders[o].frequencies.size(); ++m) {
      const bool rigid = orders[o].frequencies[m] == 0;
      if (!rigid && !(o == chosen.order && m == chosen.mode)) others.push_back({o, m});
    }
  }
  const double own = orders[chosen.order].frequencies[chosen.mode];
  const auto distance = [&](const ModePlace& place) {
    return std::abs(orders[place.order].frequencies[place.mode] - own);
  };
  std::stable_sort(others.begin(), others.end(), [&](const ModePlace& a, const ModePlace& b) {
    return distance(a) < distance(b);
  });
  return others;
}

}  // namespace twum::inline v0_1::stator
