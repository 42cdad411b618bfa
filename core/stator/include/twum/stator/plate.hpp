// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/laminate.hpp>

#include <vector>

namespace twum::inline v0_1::stator {

/// A ring of a stepped plate: constant section between two radii.
template <typename S>
struct SegmentOf {
  S inner;               ///< [m]
  S outer;               ///< [m]
  SectionOf<S> section;  ///< of its laminate
};
using Segment = SegmentOf<double>;  ///< in plain numbers

/// How the rotation of a cross section is modelled.
enum class PlateTheory {
  mindlin,  ///< independent of the slope: shear deformation and rotary inertia
  /// equal to the slope of the deflection: no shear deformation; rotary inertia if the section has it
  kirchhoff,
};
/// Its name; static lifetime.
const char* to_string(PlateTheory value) noexcept;

/// What holds the inner edge. The outer edge is free.
enum class InnerEdge {
  free,
  clamped,    ///< neither deflection nor rotation
  supported,  ///< no deflection and, with Mindlin, no rotation about the radius
};
/// As in a motor file; static lifetime.
const char* to_string(InnerEdge value) noexcept;

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

  /// Number of sign changes between two radii [m]. Values below 1e-6 of the largest one have no sign, so that a
  /// supported edge does not count.
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
/// Uses polynomials of high degree on each segment; a segment whose radii differ by more than a factor of 2 is
/// divided. With n up to 12, the three lowest frequencies of thin plates are accurate to 1e-7, those of Mindlin's
/// plate to 2e-6. The boundary layers at its free edges, a third of the thickness wide, limit the latter. Cost: the
/// lowest solutions of a dense eigenproblem with 30 to 40 unknowns for each segment (Mindlin).
/// @param segments  from the inside to the outside, without gaps
/// @throws InputError for a segment without width or with a section that is not positive, a gap, n < 0, or count < 1;
///          also for a segment narrower than 1e-9 (Mindlin) or 1e-3 (Kirchhoff) of the plate's width, where rounding
///          errors would dominate
std::vector<PlateMode> plate_modes(const std::vector<Segment>& segments, PlateTheory theory,
                                   InnerEdge inner_edge, int nodal_diameters, int count);

}  // namespace twum::inline v0_1::stator
