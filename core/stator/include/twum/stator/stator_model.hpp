// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/geometry.hpp>
#include <twum/stator/plate.hpp>

#include <memory>
#include <span>
#include <vector>

namespace twum::inline v0_1::stator {

/// A mode of the stator.
struct StatorMode {
  int nodal_diameters;  ///< n
  int nodal_circles;    ///< over the whole plate
  double frequency;     ///< [Hz]
  double
      modal_mass;  ///< for the deflection at the contact radius [kg]; infinite where that is zero
};

/// Whether it is clear which mode carries the travelling wave, and whether it can be differentiated.
enum class ModeIdentity {
  clear,  ///< only one mode qualifies
  /// another mode with n nodal diameters also keeps its sign on the ring and has less than twice the modal mass: a
  /// mode of the web is near, the two mix, and the numbers change quickly with the geometry
  shared,
  /// another mode with n nodal diameters has the same frequency to 1e-6: derivatives are NaN
  crossing,
};
/// Its name; static lifetime.
const char* to_string(ModeIdentity value) noexcept;

/// The two degenerate modes w = R(rho) cos(n phi), sin(n phi) that make the travelling wave, with the numbers that
/// the drive needs. Derivatives are with respect to each Dimension; NaN if they were not requested.
struct StatorModel {
  Derived frequency;               ///< f_r, free and short-circuited [Hz]
  Derived modal_mass;              ///< m_s at the contact radius (P4.1) [kg]
  Derived modal_stiffness;         ///< k_s (P4.2) [N/m]
  Derived neutral_plane_distance;  ///< a at the contact radius (P1.7) [m]
  /// tangential motion of the surface over that of a plate without shear (P4.3) [1]
  Derived tangential_share;
  Derived force_factor;         ///< Theta of a phase (P4.4) [N/V]
  Derived blocked_capacitance;  ///< C_0 of a phase, a lower bound (P4.5) [F]
  Derived coupling_factor;      ///< sqrt(C_m / (C_0 + C_m)) (P4.6) [1]
  Derived mode_separation;      ///< distance to the nearest unwanted mode (P4.7) [Hz]
  Derived stator_mass;          ///< of metal, glue and ceramic (P4.9) [kg]
  Derived ceramic_stress;  ///< largest bending stress of the ceramic per amplitude (P4.8) [Pa/m]
  std::vector<Derived> shape_values;  ///< R at the contact radius and each offset from it [1]

  RadialFunction shape;                ///< R, 1 at the contact radius [1]
  int nodal_circles{};                 ///< of R over the whole plate
  ModeIdentity identity{};             ///< whether the choice of mode is clear
  std::vector<StatorMode> unwanted;    ///< other modes of n - 2 to n + 2, nearest frequency first
  std::vector<Dimension> joint_edges;  ///< radii that coincide with another one, see stator_model()
};

/// Whether derivatives are wanted.
enum class Derivatives { none, all };

/// Whether the modes beside the wave are wanted, which take four fifths of the time: without them mode_separation is NaN
/// and `unwanted` empty.
enum class OtherModes { none, found };

/// A stator whose travelling wave was found. What else is asked of it is computed then: derivatives and the distance of the
/// nearest mode each take up to twice as long as the wave itself, and all modes beside it, of n - 2 to n + 2, four times as long;
/// what was found of these is kept. Immutable and thread-safe; copies share it. Arguments, exceptions and derivatives are those of stator_model().
class SolvedStator {
 public:
  /// Finds the wave.
  SolvedStator(const StatorGeometry& geometry, int wavelengths, double contact_radius,
               PlateTheory theory = PlateTheory::mindlin, std::span<const double> offsets = {});

  /// All numbers but those of the modes beside the wave: mode_separation is NaN and `unwanted` empty.
  StatorModel wave(Derivatives derivatives) const;
  /// Distance to the nearest unwanted mode (P4.7) [Hz].
  Derived mode_separation(Derivatives derivatives) const;
  /// Other modes of n - 2 to n + 2, nearest frequency first.
  std::vector<StatorMode> unwanted() const;

 private:
  struct Modes;
  StatorModel numbers(Derivatives derivatives) const;

  std::shared_ptr<const Modes> modes_;
};

/// Modes of a stator and what follows from them.
///
/// Derivatives are exact for the discretized plate. They are NaN in two cases: where two modes with n nodal diameters
/// cross (identity), and for a mode separation that is zero or has two nearest modes. Radii that coincide
/// (joint_edges) can only be moved together: the sum of their derivatives is the derivative for moving all of them;
/// one of them alone has no meaning. Cost: the eight lowest modes for each of five numbers of nodal diameters, some
/// milliseconds.
/// @param wavelengths     n, 1 or more
/// @param contact_radius  r, where R = 1 [m]; it lies on the plate
/// @param offsets         for shape_values: radii minus the contact radius [m]; these radii move with the contact
///         radius
/// @throws InputError as check_geometry() and plate_modes(); for wavelengths < 1, for a contact radius or an offset
///          that is not on the plate, and if two phases do not fit on the ring
/// @throws EvaluationError "no-ring-mode" if each of the eight lowest modes of n changes its sign on the ring
StatorModel stator_model(const StatorGeometry& geometry, int wavelengths, double contact_radius,
                         PlateTheory theory = PlateTheory::mindlin,
                         Derivatives derivatives = Derivatives::none,
                         std::span<const double> offsets = {},
                         OtherModes others = OtherModes::found);

/// The modes of a stator with n nodal diameters, lowest frequency first; R is normalized as in PlateMode.
/// @throws InputError as check_geometry(), or for n < 0 or count < 1
std::vector<PlateMode> stator_modes(const StatorGeometry& geometry, int nodal_diameters, int count,
                                    PlateTheory theory = PlateTheory::mindlin);

}  // namespace twum::inline v0_1::stator
