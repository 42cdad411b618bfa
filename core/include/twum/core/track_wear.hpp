// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/core/metric_value.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/worn_in.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace twum::inline v0_1 {

/// A node of a track of which each radius wears by itself: of Gauss' rule over the whole width. It stays with the material.
struct TrackNode {
  double radius;  ///< rho [m]
  double width;   ///< drho [m]
};

/// What a load does at the nodes of a worn track. SI units.
struct TrackLoad {
  double share{0};                  ///< of the time
  double speed{0};                  ///< Omega of the rotor [rad/s]
  double torque{0};                 ///< T on the rotor [N m]
  double amplitude{0};              ///< A of the wave [m]
  double friction_power{0};         ///< P_fric [W]
  std::vector<double> loads{};      ///< F_j, part of the preload that a node carries [N]
  std::vector<double> pressures{};  ///< largest in a turn of the wave [Pa]
  std::vector<double>
      stiffness{};  ///< f_j = dF_j / dd of a node, d depth of the layer under the crest [N/m]
  /// D_j: derivative in d of the rate at which a node wears, at the same speed and wave [1/s]
  std::vector<double> wear_stiffness{};
};

/// How fast a worn track wears at each node, over the mission (V3.3), and how that follows the worn depths.
struct TrackRates {
  MetricStatus status{
      MetricStatus::ok};              ///< else why a load has no point; there are no numbers then
  std::vector<double> rates{};        ///< de_j/dt [m/s]
  std::vector<double> jacobian{};     ///< of rates[i] in depth j, at [j nodes + i] [1/s]
  double turns{0};                    ///< revolutions per second, averaged [1/s]
  std::vector<double> turn_slopes{};  ///< and their derivative in each depth [1/(m s)]
  std::vector<TrackLoad> loads{};     ///< of each load of the mission, without its pauses
};

/// A motor of which each radius of the track wears by itself, under a load or in its operation. The speed of a load, and the wave of a
/// motor under a voltage, are searched once and then followed from call to call. A call takes the time of some ten operating points.
class TrackWear {
 public:
  /// @param load  none: the operation of the design
  /// @throws InputError without wear, without an operation, for one slice, and for what a free profile leaves out: temperatures that
  ///         change the motor, radial motion, and a load that the drive holds
  TrackWear(const MotorDesign& design, const std::optional<LoadPoint>& load);
  ~TrackWear();
  TrackWear(const TrackWear&) = delete;
  TrackWear& operator=(const TrackWear&) = delete;

  /// |radial_slices| of them, 16 for `auto`.
  const std::vector<TrackNode>& nodes() const;
  /// Depth at which a node has no lining left; infinite where the lining does not wear [m].
  double worn_through() const;
  /// Mean of the depths over the area of the track: u of (V3.2) [m].
  double mean(std::span<const double> depths) const;
  /// The inertia of a layer with density follows its mean thickness. Derivatives are exact.
  /// @param depths  e_j, worn off both bodies at each node [m]
  TrackRates at(std::span<const double> depths);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Whether a track stays even at these rates (V3.7): with the mean of D_j over the loads. @param at  of the even track
WearStability wear_stability(const TrackRates& at);

/// The first thing of a motor which a free profile leaves out, in the words of complaints(); empty if there is none.
std::string free_profile_complaint(const MotorDesign& design);

/// The motor whose track has worn to a depth at each node (V3.1, V3.2), as many as there are depths. All metrics, curves and fields
/// take it so.
/// @throws InputError beyond the lining or the preload, without wear, and for fewer than two depths
MotorDesign worn_motor(const MotorDesign& design, std::span<const double> depths);

}  // namespace twum::inline v0_1
