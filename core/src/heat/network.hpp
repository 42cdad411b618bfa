// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/heat.hpp>

#include <array>
#include <cstddef>

namespace twum::inline v0_1::core {

inline constexpr std::size_t kMasses = 3;   // stator, rotor, housing
inline constexpr std::size_t kSources = 4;  // friction, layer, stator, dielectric

template <typename S>
using Masses = std::array<S, kMasses>;
template <typename S>
using Sources = std::array<S, kSources>;
template <typename S>
using PartValues = std::array<S, kParts>;

template <typename S, std::size_t columns>
using Rows3 = std::array<std::array<S, columns>, kMasses>;

/// Conductances of HeatNetwork, in its order; S is double or carries derivatives.
template <typename S>
using Paths = std::array<S, 7>;
enum PathIndex : std::size_t { kSc, kL, kSh, kRh, kHa, kSa, kRa };

inline Paths<double> paths_of(const HeatNetwork& n) {
  return {n.stator_contact,  n.lining,         n.stator_housing, n.rotor_housing,
          n.housing_ambient, n.stator_ambient, n.rotor_ambient};
}

inline Sources<double> sources_of(const HeatLosses& p) {
  return {p.friction, p.layer, p.stator, p.dielectric};
}

inline PartTemperatures parts_of(const PartValues<double>& x) {
  return {x[0], x[1], x[2], x[3], x[4]};
}

/// C theta' = -K theta + B p (H1.4), where the balance of the contact (H1.1) is solved for its temperature, and the temperatures of
/// all parts x = M theta + D p. One node is the first mass; the others then
/// have no heat and stand at ambient.
template <typename S>
struct NetworkMatrices {
  Rows3<S, kMasses> K;
  Rows3<S, kSources> B;
  std::array<Masses<S>, kParts> M;
  std::array<Sources<S>, kParts> D;
};

template <typename S>
NetworkMatrices<S> zero_matrices() {
  NetworkMatrices<S> m;
  for (auto& row : m.K) row.fill(S(0.0));
  for (auto& row : m.B) row.fill(S(0.0));
  for (auto& row : m.M) row.fill(S(0.0));
  for (auto& row : m.D) row.fill(S(0.0));
  return m;
}

/// @param conductance  of the node to ambient
template <typename S>
NetworkMatrices<S> one_node_matrices(const S& conductance) {
  NetworkMatrices<S> m = zero_matrices<S>();
  m.K[0][0] = conductance;
  m.K[1][1] = m.K[2][2] = S(1.0);
  m.B[0].fill(S(1.0));
  for (auto& row : m.M) row[0] = S(1.0);
  return m;
}

template <typename S>
NetworkMatrices<S> three_mass_matrices(const Paths<S>& g) {
  NetworkMatrices<S> m = zero_matrices<S>();
  const S across = g[kSc] + g[kL];
  const S beta = g[kSc] / across, rest = g[kL] / across, Gsr = g[kSc] * rest;
  m.K = {{{g[kSh] + g[kSa] + Gsr, -Gsr, -g[kSh]},
          {-Gsr, g[kRh] + g[kRa] + Gsr, -g[kRh]},
          {-g[kSh], -g[kRh], g[kSh] + g[kRh] + g[kHa]}}};
  m.B[0] = {beta, 0.5 * beta, S(1.0), S(1.0)};  // (H1.5)
  m.B[1] = {rest, 1.0 - 0.5 * beta, S(0.0), S(0.0)};
  for (std::size_t i = 0; i < kMasses; ++i) m.M[i][i] = S(1.0);
  m.M[3] = {beta, rest, S(0.0)};  // (H1.2)
  m.D[3] = {1.0 / across, 0.5 / across, S(0.0), S(0.0)};
  m.M[4] = {0.5 * beta, 0.5 * (1.0 + rest), S(0.0)};  // (H1.3)
  m.D[4] = {0.5 / across, 0.25 / across + 1.0 / (12.0 * g[kL]), S(0.0), S(0.0)};
  return m;
}

inline NetworkMatrices<double> matrices_of(const HeatNetwork& n) {
  return n.one_node ? one_node_matrices(n.stator_ambient) : three_mass_matrices(paths_of(n));
}

/// Solves a system whose matrix is an M-matrix, or close to the identity: no pivots are needed.
template <typename S>
Masses<S> solved(Rows3<S, kMasses> a, Masses<S> b) {
  for (std::size_t k = 0; k < kMasses; ++k)
    for (std::size_t i = k + 1; i < kMasses; ++i) {
      const S factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < kMasses; ++j) a[i][j] = a[i][j] - factor * a[k][j];
      b[i] = b[i] - factor * b[k];
    }
  for (std::size_t i = kMasses; i-- > 0;) {
    for (std::size_t j = i + 1; j < kMasses; ++j) b[i] = b[i] - a[i][j] * b[j];
    b[i] = b[i] / a[i][i];
  }
  return b;
}

/// The sum over a row.
template <typename S, std::size_t n>
S dot(const std::array<S, n>& a, const std::array<S, n>& b) {
  S sum = a[0] * b[0];
  for (std::size_t i = 1; i < n; ++i) sum = sum + a[i] * b[i];
  return sum;
}

template <typename S>
PartValues<S> parts_at(const NetworkMatrices<S>& m, const Masses<S>& theta, const Sources<S>& p) {
  PartValues<S> x;
  for (std::size_t i = 0; i < kParts; ++i) x[i] = dot(m.M[i], theta) + dot(m.D[i], p);
  return x;
}

/// theta = K^-1 B p, and the rises of all parts (H1.4 with theta' = 0).
template <typename S>
PartValues<S> steady_parts(const NetworkMatrices<S>& m, const Sources<S>& p) {
  Masses<S> heat;
  for (std::size_t i = 0; i < kMasses; ++i) heat[i] = dot(m.B[i], p);
  return parts_at(m, solved(m.K, heat), p);
}

inline Masses<double> capacities_of(const HeatNetwork& n) {
  if (n.one_node) return {n.stator_capacity, 1, 1};
  return {n.stator_capacity, n.rotor_capacity, n.housing_capacity};
}

}  // namespace twum::inline v0_1::core
