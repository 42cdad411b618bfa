// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/laminate.hpp>

#include <vector>

namespace twum::stator {

/// A ring of a stepped plate: constant section between two radii.
template <typename S>
struct SegmentOf {
  S inner;               ///< [m]
  S outer;               ///< [m]
  SectionOf<S> section;  ///< of its laminate
};
using Segment = SegmentOf<double>;  ///< in plain numbers

/// How a cross section may turn.
enum class PlateTheory {
  mindlin,  ///< on its own: shear deformation and rotary inertia
  kirchhoff,  ///< with the slope of the deflection: no shear deformation; rotary inertia if the section has it
};

/// What holds the inner edge. The outer edge is free.
enum class InnerEdge {
  free,
  clamped,    ///< neither deflection nor rotation
  supported,  ///< no deflection and, with Mindlin, no rotation about the radius
};

/// One radial function in polynomial pieces.
class RadialFunction {
 public:
  /// A piece: coefficients of Legendre polynomials on [inner, outer] mapped to [-1, 1].
  struct Piece {
    double inner;                      ///< [m]
    double outer;                      ///< [m]
    std::vector<double> coefficients;  ///< of P_0, P_1, ...
  };
  /// Zero everywhere.
  RadialFunction() = default;
  /// @param pieces  from the inside to the outside, without gaps
  explicit RadialFunction(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  /// Value at a radius [m]; outside the plate the nearest piece is continued.
  double operator()(double radius) const;

  /// Slope dR / d rho at a radius [m], continued likewise.
  double slope(double radius) const;

  /// How often the function changes its sign between two radii [m]. Values below 1e-6 of the largest one
  /// have no sign: a supported edge is no change.
  int sign_changes(double inner, double outer) const;

  /// From the inside to the outside.
  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  std::vector<Piece> pieces_;
};

/// A mode w = R(rho) cos(n phi), normalized to a generalized mass of 1 kg (P4.1).
struct PlateMode {
  double frequency;           ///< [Hz]; 0 for a rigid-body mode
  RadialFunction deflection;  ///< R [m] for a modal coordinate of 1
  int nodal_circles;          ///< sign changes of R between the edges
};

/// Lowest modes with n nodal diameters, lowest frequency first (P3.1).
///
/// Polynomials of high degree on each segment, more than one where its radii differ by more than a factor
/// of 2. With n up to 12 the three lowest frequencies of thin plates are good to 1e-7; those of Mindlin's
/// plate to 2e-6, where the layers at its free edges, a third of the thickness wide, are hardest.
/// Cost: the lowest solutions of a dense eigenproblem with 30 to 40 unknowns for each segment (Mindlin).
/// @param segments  from the inside to the outside, without gaps
/// @throws InputError for a segment without width or with a section that is not positive, a gap, n < 0,
/// count < 1, and for a segment narrower than 1e-9 of the plate's width (Mindlin) or 1e-3 (Kirchhoff), which
/// rounding would spoil
std::vector<PlateMode> plate_modes(const std::vector<Segment>& segments, PlateTheory theory,
                                   InnerEdge inner_edge, int nodal_diameters, int count);

}  // namespace twum::stator
