// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/core/metric_request.hpp>
#include <twum/stator/geometry.hpp>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1 {

/// Shape of the wave across the contact track: w = A R(rho) cos(omega t - n phi), R = 1 at the contact radius.
///
/// R(rho) = ((rho - rho_0) / (r - rho_0))^p, unless a table is given (theory, W1.3).
struct RadialShape {
  double exponent{0};  ///< p [1]
  double root{0};      ///< rho_0, where the shape is zero: a clamped edge, or the axis [m]
  /// Radius [m] and R, measured or computed, in rising order: replaces exponent and root. At least 4 rows that cover the
  /// track. Between them runs a cubic spline, C2 with not-a-knot ends, scaled to R = 1 at the contact radius.
  std::vector<std::pair<double, double>> table{};
  /// True if all members are equal.
  bool operator==(const RadialShape&) const = default;
};

/// Value of Stator::radial_slices that stands for as many slices as the numbers need: a Gauss rule on each panel of the track,
/// where a panel ends at each radius at which a zone appears. Below it -N stands for the same with N nodes a panel.
inline constexpr int kAutoSlices = 0;

/// Differences between the two phases and between the two modes of a stator (D6.1, D6.5). They drive a backward wave.
struct Imbalance {
  double voltage_ratio{1};  ///< rho, voltage of the second phase over voltage of the first [1]
  double phase_error{0};    ///< eps, lead of the second phase beyond a quarter of a turn [rad]
  double mode_splitting{
      0};  ///< delta: the modes have the stiffness k_s (1 + delta) and k_s (1 - delta) [1]
  /// True if all members are equal.
  bool operator==(const Imbalance&) const = default;
};

/// An electrode that senses the wave (D7.1).
struct Sensor {
  double force_factor{0};      ///< charge per amplitude of the wave at the contact radius [N/V]
  double capacitance{0};       ///< of the electrode [F]
  double load_capacitance{0};  ///< of cable and amplifier [F]
  std::optional<double>
      load_resistance;  ///< of the amplifier [ohm]; without it the electrode is open
  double position{0};   ///< position behind the first phase, as a phase of the wave [rad]
  /// True if all members are equal.
  bool operator==(const Sensor&) const = default;
};

/// Which of the two stable waves of a driven stator is meant.
enum class Branch : unsigned char {
  running,  ///< the large one, that of a running motor
  dead      ///< the small one of a stator that the rotor clamps, so that the motor does not start
};
/// As in a motor file; static lifetime.
const char* to_string(Branch value) noexcept;

/// What a drive changes so that the motor carries a torque at a speed.
enum class DriveControl : unsigned char {
  frequency,  ///< the frequency, at the voltage of the design
  voltage,    ///< the voltage, at the frequency of the design
  amplitude   ///< the wave's amplitude: of a motor without a voltage
};
/// As in a motor file; static lifetime.
const char* to_string(DriveControl value) noexcept;

/// The solved plate of a stator that is given by its geometry, shared by copies: see keep_plate(). It follows from the other
/// members, so it does not count in comparisons, and counts for nothing where these have changed.
struct SolvedPlate {
  struct Known;                          ///< a plate and what it was solved for
  std::shared_ptr<const Known> known{};  ///< null before it is solved
  /// Always true.
  bool operator==(const SolvedPlate&) const { return true; }
};

/// Factors by which a stator that is given by its geometry differs from the plate at the reference temperature.
struct PlateDrift {
  double resonance_frequency{1};  ///< of f_r
  double force_factor{1};         ///< of Theta
  double blocked_capacitance{1};  ///< of C_0
  bool moves{false};  ///< the three numbers have derivatives of their own, as parameters in use
  /// True if all members are equal.
  bool operator==(const PlateDrift&) const = default;
};

/// The vibrating ring. Wave w = A cos(omega t - kappa x), kappa = n / r.
///
/// The amplitude is given, or follows from the voltage and the load (theory of the driven stator). A voltage needs
/// resonance_frequency, modal_mass, force_factor and damping. If these and an amplitude are given, the voltage
/// follows.
struct Stator {
  double wavelengths{9};                 ///< n, wavelengths round the circumference [1], integer
  double contact_radius{0.0265};         ///< r, mean contact radius [m]
  double contact_width{0.004};           ///< b, radial contact width [m]
  double neutral_plane_distance{0.003};  ///< a, neutral plane to stator surface [m]
  double frequency{40e3};                ///< f, drive frequency [Hz], used without frequency_ratio
  double amplitude{1.6e-6};  ///< A, amplitude of the travelling wave [m], used without voltage
  double modal_damping{0};   ///< d_s, loss of the stator is d_s (omega A)^2 [N s/m], used without
                             ///< quality_factor
  std::optional<double> voltage{};              ///< of each of the two phases, rms [V]
  std::optional<double> frequency_ratio{};      ///< f / f_r [1]
  std::optional<double> resonance_frequency{};  ///< f_r of the free stator, phases shorted [Hz]
  std::optional<double> modal_mass{};           ///< m_s of each mode, at the contact radius [kg]
  std::optional<double> quality_factor{};       ///< Q of the free stator [1]
  std::optional<double> force_factor{};         ///< Theta of a phase [N/V]
  double blocked_capacitance{0};                ///< C_0 of a phase [F]
  double loss_tangent{0};                       ///< tan delta of C_0 [1]
  std::optional<Imbalance> imbalance{};         ///< without it phases and modes are equal
  std::optional<Sensor> sensor{};               ///< without it there is no such electrode
  Branch branch{Branch::running};               ///< which wave is meant if a voltage is given
  /// What follows where a torque is held at a speed; of a motor without a voltage the amplitude does. The voltage, or amplitude,
  /// is the most that the drive gives.
  DriveControl control{DriveControl::frequency};
  /// Lowest and highest frequency of a drive that follows by it [Hz]; without it any
  std::optional<std::pair<double, double>> frequency_range{};
  /// Nodes of the Gauss rule on each smooth piece of the track. 1: all at the contact radius, as in the
  /// paper; kAutoSlices and below: on each panel.
  int radial_slices{1};
  RadialShape radial_shape{};  ///< used if the track has more than one slice, or with radial_motion
  /// The surface moves radially, too, where radial_shape or the mode of the geometry rises across the track (theory of radial
  /// motion, R1.1). False: the model of the paper.
  bool radial_motion{false};
  /// Geometry of the stator. If given, it determines resonance_frequency, modal_mass, force_factor,
  /// blocked_capacitance, neutral_plane_distance and radial_shape, and these members are ignored (theory of the
  /// plate, section 8).
  std::optional<stator::StatorGeometry> geometry{};
  SolvedPlate plate{};       ///< of the geometry; kept by keep_plate(), with() and Motor
  PlateDrift plate_drift{};  ///< of a warm stator; see at_temperatures()
  /// True if all members are equal.
  bool operator==(const Stator&) const = default;
};

/// The layer between stator and rotor: a foundation that is elastic along the axis and has
/// stiffness, viscosity and inertia in shear, m eps'' + gamma eps' + G eps = tau (paper, eq. 16).
///
/// G, gamma and m follow from the material unless they are given directly.
struct ContactLayer {
  double thickness{0.3e-3};                       ///< h [m]
  double youngs_modulus{3e9};                     ///< E [Pa]
  double poisson_ratio{0.35};                     ///< nu [1], used when G is not given
  double density{1800};                           ///< rho [kg/m^3], used when m is not given
  double loss_factor{0.05};                       ///< [1], used when gamma is not given
  std::optional<double> given_shear_modulus{};    ///< G [Pa]; otherwise E / (2 (1 + nu))
  std::optional<double> given_shear_viscosity{};  ///< gamma [Pa s]; otherwise loss_factor G / omega
  std::optional<double> given_inertia{};          ///< m [Pa s^2]; otherwise rho h^2 / 3
  std::optional<double> conductivity{};           ///< lambda_l of heat [W/(m K)]
  /// True if all members are equal.
  bool operator==(const ContactLayer&) const = default;
};

/// Coulomb friction with a static threshold, mu_0 >= mu >= 0.
struct Friction {
  double kinetic{0.2};    ///< mu, while slipping [1]
  double threshold{0.2};  ///< mu_0, threshold of sticking [1]
  /// True if all members are equal.
  bool operator==(const Friction&) const = default;
};

/// The rotor.
struct Rotor {
  /// Cone angle of the face [rad]. At radius rho the face lies (rho - r) tan(taper) higher: positive if it lies
  /// farther from the stator at the outer edge. Used if the track has more than one slice.
  double taper{0};
  /// [kg], used for backward waves only (D6.2); without it the rotor has no inertia in the axial direction
  std::optional<double> mass{};
  std::optional<double>
      inertia{};            ///< J_r of rotor and shaft about the axis [kg m^2]; motions need it
  double axial_damping{0};  ///< d_z of its axial motion [N s/m], of oscillating motions
  /// True if all members are equal.
  bool operator==(const Rotor&) const = default;
};

/// What the shaft drives (theory of motion, section 1).
struct ShaftLoad {
  double inertia{0};    ///< J_L [kg m^2]
  double damping{0};    ///< c_L, viscous friction [N m s]
  double friction{0};   ///< T_c, Coulomb friction [N m]
  double stiffness{0};  ///< k_L of a spring about the neutral angle [N m/rad]
  double neutral{0};    ///< theta_0, angle at which the spring is relaxed [rad]
  /// True if all members are equal.
  bool operator==(const ShaftLoad&) const = default;
};

/// The electronics that feed the phases. With an inductance or a resistance in series every voltage of a design is the inverter's,
/// in front of them, and the terminals of a phase have another one (D8.1).
struct Driver {
  double off_resistance{0};  ///< R_off, across each phase while the drive is off [ohm]; 0: shorted
  double inductance{0};      ///< L_s, in series with each phase [H]
  double resistance{0};      ///< R_s, likewise [ohm]
  /// True if all members are equal.
  bool operator==(const Driver&) const = default;
};

/// What a body of the motor has for its warm-up.
struct ThermalBody {
  std::optional<double> heat_capacity{};      ///< C [J/K]
  std::optional<double> temperature_limit{};  ///< highest temperature that it may have [K]
  /// True if all members are equal.
  bool operator==(const ThermalBody&) const = default;
};

/// How heat flows between stator, rotor, housing, sliding contact and ambient [W/K]. A path that is not given is none.
struct ThermalConductances {
  std::optional<double> stator_contact{};  ///< G_sc, through the teeth
  std::optional<double> lining{};  ///< G_l, contact to rotor; else from the layer's conductivity
  std::optional<double> stator_housing{};   ///< G_sh
  std::optional<double> rotor_housing{};    ///< G_rh
  std::optional<double> housing_ambient{};  ///< G_ha
  std::optional<double> stator_ambient{};   ///< G_sa
  std::optional<double> rotor_ambient{};    ///< G_ra
  /// True if all members are equal.
  bool operator==(const ThermalConductances&) const = default;
};

/// Relative change of a parameter per kelvin (H3.1) [1/K]; 0 where it is not given. Each belongs to the parameter that the design
/// is stated through: modal_damping in place of quality_factor, shear_viscosity in place of loss_factor.
struct ThermalDrift {
  /// At the temperature of the stator.
  /// @{
  std::optional<double> resonance_frequency{}, quality_factor{}, modal_damping{}, force_factor{},
      blocked_capacitance{}, loss_tangent{};
  /// @}
  /// At the mean temperature of the lining. The shear modulus keeps its ratio to Young's modulus.
  /// @{
  std::optional<double> youngs_modulus{}, loss_factor{}, shear_viscosity{};
  /// @}
  std::optional<double> kinetic_friction{};  ///< at that of the contact; the static one with it
  std::optional<double> specific_wear{};     ///< likewise, of both bodies
  /// True if all members are equal.
  bool operator==(const ThermalDrift&) const = default;
};

/// One temperature for the whole motor, from a data sheet.
struct OneNode {
  double rise{0};           ///< above ambient, steady, at the torque [K]
  double torque{0};         ///< load torque [N m]
  double time_constant{0};  ///< of the warm-up [s]
  /// True if all members are equal.
  bool operator==(const OneNode&) const = default;
};

/// What heats and cools the motor, and how its parameters follow (theory of heat). Either three masses with conductances, or one
/// node.
struct Thermal {
  double ambient{293.15};             ///< T_a [K]
  std::optional<double> reference{};  ///< T_ref, at which the design holds [K]; else the ambient
  ThermalBody stator{};               ///< metal and ceramic
  ThermalBody rotor{};                ///< without the lining
  ThermalBody housing{};              ///< and what it is mounted on
  std::optional<double> contact_temperature_limit{};  ///< of the lining's face [K]
  ThermalConductances conductances{};                 ///< of the three masses
  ThermalDrift drift{};                               ///< of the design's parameters
  std::optional<OneNode> one_node{};                  ///< in place of masses and conductances
  /// True if all members are equal.
  bool operator==(const Thermal&) const = default;
};

/// A limit that a motor has to keep for its life.
struct WearLimit {
  MetricRequest request{};                                 ///< what is limited
  double lower{-std::numeric_limits<double>::infinity()};  ///< SI
  double upper{std::numeric_limits<double>::infinity()};   ///< SI
  std::string text{};                                      ///< as typed; not needed
  /// True if all members are equal.
  bool operator==(const WearLimit&) const = default;
};

/// Which radii of the track wear together.
enum class WearProfile : unsigned char {
  even,  ///< all: the track has one worn depth (V2.1)
  free   ///< none: each radius wears by its own pressure and slip (V3.3)
};

/// As in a motor file; static lifetime.
const char* to_string(WearProfile profile) noexcept;

/// How the track wears, and what ends its life (theory of wear).
struct Wear {
  std::optional<double> specific_wear{};  ///< k_l of the lining [m^2/N]
  double stator_specific_wear{0};         ///< k_s [m^2/N]
  std::optional<double> depth_limit{};    ///< largest depth of both bodies together [m]
  std::vector<WearLimit> until{};  ///< limits at the reference temperature that end the life, too
  double preload_spring{0};        ///< k_F, rate of the spring that gives the preload [N/m]
  /// E_lining, where modulus and thickness of the layer also stand for a flange [Pa]; else that of the layer
  std::optional<double> lining_youngs_modulus{};
  WearProfile profile{WearProfile::even};  ///< what a life of the motor takes
#ifndef __wasm__  // the page takes all tracks as even, which keeps it small
  /// Depth that is worn off at each node of the track, less the mean over its area (V3.1) [m]: at those of Gauss' rule over the whole
  /// width, from the inner edge on. Empty: the track is even. As worn_motor() gives it.
  std::vector<double> deviations{};
#endif
  /// True if all members are equal.
  bool operator==(const Wear&) const = default;
};

/// One motor: everything the contact model needs, in SI units. A plain value.
///
/// The defaults are a 60 mm ring motor with one slice: the one of `examples/motors/ring-60.yaml`, but with all of the
/// contact at the contact radius and without modal damping. The file has `radial_slices: auto`, by which its peak power
/// differs by 6 %.
struct MotorDesign {
  Stator stator{};                     ///< the vibrating ring
  ContactLayer layer{};                ///< between stator and rotor
  Friction friction{};                 ///< of the contact
  double preload{160};                 ///< F_N, total axial force [N]
  Rotor rotor{};                       ///< pressed on the stator
  std::optional<Thermal> thermal{};    ///< without it the motor has no temperatures
  std::optional<Wear> wear{};          ///< without it the motor does not wear
  std::optional<ShaftLoad> load{};     ///< of motions; without it the rotor turns alone
  std::optional<Driver> driver{};      ///< without it ideal, and phases are shorted while it is off
  std::vector<LoadPhase> operation{};  ///< what it does, repeated for ever; may be empty
  /// True if all members are equal.
  bool operator==(const MotorDesign&) const = default;
};

/// True if each radius of the motor's track wears by itself.
inline bool wears_freely(const MotorDesign& design) {
  return design.wear && design.wear->profile == WearProfile::free;
}

/// f, drive frequency: as given, or frequency_ratio f_r [Hz]. Smooth; never throws; NaN if f_r is needed and not
/// given.
double drive_frequency(const MotorDesign& design);

/// d_s, damping of each mode of the stator: as given, or 2 pi f_r m_s / Q (D2.2) [N s/m]. Smooth; never throws; NaN
/// if neither it nor what it follows from is given.
double modal_damping(const MotorDesign& design);

/// True if the design has all data that relate the wave to a voltage: resonance_frequency, modal_mass, force_factor,
/// and damping.
bool has_modal_data(const MotorDesign& design);

/// True if the wave's amplitude changes across the track: by radial_shape, or by the mode of a geometry.
bool has_radial_shape(const MotorDesign& design);

/// G, shear modulus of the layer: as given, or E / (2 (1 + nu)) [Pa]. Smooth; never throws.
double shear_modulus(const MotorDesign& design);

/// gamma, shear viscosity of the layer: as given, or loss_factor G / omega [Pa s]. Smooth; never throws.
double shear_viscosity(const MotorDesign& design);

/// m, inertia of the layer: as given, or rho h^2 / 3 [Pa s^2]. Smooth; never throws.
double inertia(const MotorDesign& design);

}  // namespace twum::inline v0_1
