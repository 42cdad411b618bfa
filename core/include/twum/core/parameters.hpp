// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace twum::inline v0_1 {

/// Every parameter of a motor, in the order of the parameter table.
enum class Parameter : unsigned char {
  wavelengths,
  contact_radius,
  contact_width,
  neutral_plane_distance,
  frequency,
  frequency_ratio,
  amplitude,
  voltage,
  modal_damping,
  quality_factor,
  resonance_frequency,
  modal_mass,
  force_factor,
  blocked_capacitance,
  loss_tangent,
  voltage_ratio,
  phase_error,
  mode_splitting,
  sensor_force_factor,
  sensor_capacitance,
  sensor_load_capacitance,
  sensor_load_resistance,
  sensor_position,
  radial_slices,
  shape_exponent,
  shape_root,
  thickness,
  youngs_modulus,
  poisson_ratio,
  density,
  loss_factor,
  shear_modulus,
  shear_viscosity,
  inertia,
  kinetic_friction,
  static_friction,
  rotor_taper,
  rotor_mass,
  preload,
  // of heat
  conductivity,
  substrate_conductivity,
  substrate_specific_heat,
  ceramic_specific_heat,
  ambient_temperature,
  reference_temperature,
  stator_heat_capacity,
  stator_temperature_limit,
  rotor_heat_capacity,
  rotor_temperature_limit,
  housing_heat_capacity,
  housing_temperature_limit,
  contact_temperature_limit,
  conductance_stator_contact,
  conductance_lining,
  conductance_stator_housing,
  conductance_rotor_housing,
  conductance_housing_ambient,
  conductance_stator_ambient,
  conductance_rotor_ambient,
  drift_resonance_frequency,
  drift_quality_factor,
  drift_modal_damping,
  drift_force_factor,
  drift_blocked_capacitance,
  drift_loss_tangent,
  drift_youngs_modulus,
  drift_loss_factor,
  drift_shear_viscosity,
  drift_kinetic_friction,
  drift_specific_wear,
  one_node_rise,
  one_node_torque,
  one_node_time_constant,
  // of wear
  specific_wear,
  stator_specific_wear,
  wear_depth_limit,
  preload_spring,
  lining_youngs_modulus,
  // of motions
  rotor_inertia,
  load_inertia,
  load_damping,
  load_friction,
  load_stiffness,
  load_neutral,
  off_resistance,
  driver_inductance,
  driver_resistance,
  axial_damping,
  // of the stator's geometry, in the order of stator::Dimension but for teeth_count and electrodes_waves_per_phase
  substrate_inner_radius,
  substrate_outer_radius,
  substrate_thickness,
  substrate_youngs_modulus,
  substrate_poisson_ratio,
  substrate_density,
  web_inner_radius,
  web_outer_radius,
  web_thickness,
  teeth_count,
  teeth_height,
  teeth_slot_width,
  teeth_inner_radius,
  teeth_outer_radius,
  teeth_stiffness_share,
  glue_thickness,
  glue_youngs_modulus,
  glue_poisson_ratio,
  glue_density,
  ceramic_inner_radius,
  ceramic_outer_radius,
  ceramic_thickness,
  ceramic_youngs_modulus,
  ceramic_poisson_ratio,
  ceramic_density,
  ceramic_d31,
  ceramic_permittivity,
  electrodes_waves_per_phase,
  electrodes_inner_radius,
  electrodes_outer_radius
};

/// Rows of the parameter table.
inline constexpr std::size_t kParameterCount =
    static_cast<std::size_t>(Parameter::electrodes_outer_radius) + 1;

/// Position of a parameter in arrays over the parameter table.
constexpr std::size_t index_of(Parameter parameter) { return static_cast<std::size_t>(parameter); }

/// One row of the parameter table: the single source for reading, listing, schema and reference.
struct ParameterInfo {
  Parameter parameter;      ///< whose row it is
  std::string_view name;    ///< flat name, as in studies, CSV headers and --set
  std::string_view symbol;  ///< the paper's letter, an alias of the name; may be empty
  std::string_view unit;    ///< SI unit, "1" if dimensionless
  std::string_view
      file_entry;  ///< entry of the motor file below `motor:`, such as "stator.amplitude"
  double min;      ///< smallest admissible value, in `unit`
  double max;      ///< largest admissible value, in `unit`
  bool integer;    ///< true: only whole numbers
  bool required;   ///< must stand in a motor file (unless its alternative does)
  /// the parameter that may be given instead of this one, such as shear_modulus for poisson_ratio; both in one file
  /// is an error
  std::optional<Parameter> alternative;
  std::string_view example;  ///< a valid value with its unit, as a user types it
  std::string_view text;     ///< what it is, in one line
  std::string_view reason;   ///< why the range ends where it does
  /// what holds where a motor file leaves it out; empty if it must be given, or its alternative
  std::string_view fallback{};
  bool in_templates{true};  ///< false: a motor with a given amplitude does without it
  bool absolute{false};     ///< an absolute temperature, which is also read in degC
};

/// The table, one row for each Parameter, in its order; static lifetime.
std::span<const ParameterInfo> parameter_table();

/// The row of a parameter; static lifetime.
const ParameterInfo& info(Parameter parameter);

/// The parameter with this flat name or symbol ("thickness" or "h"), if there is one. Case-sensitive.
std::optional<Parameter> find_parameter(std::string_view name_or_symbol);

/// Value of a parameter in SI units. A parameter that follows from others (G from E and nu, ...) has the value in
/// use. An alternative that is not in use has the value that states the same: nu from G and E; loss_factor from gamma,
/// G and omega; density from m and h. NaN for a parameter without a value: modal data that are not given, and whichever of
/// amplitude and voltage follows from the load. Never throws for any design.
double get(const MotorDesign& design, Parameter parameter);

/// True if the design is stated through this parameter. False for the alternative that is not used: shear_modulus when
/// G follows from E and nu, poisson_ratio when G is given directly, and so on. False for the radial shape and the
/// taper of a track with one slice, and for exponent and root beside a table. False for modal data that are not given, and
/// for capacitance and loss tangent of a stator without a force factor. A geometry replaces modal data, neutral plane
/// distance and radial shape, which are then not in use; without a geometry its own parameters are not in use.
bool in_use(const MotorDesign& design, Parameter parameter);

/// True if a file of this design has to state the parameter: it is in use, or it has a value of its own that comes into use
/// with another parameter. These are the radial shape and the taper of a track with one slice, and capacitance and loss
/// tangent of a stator without a force factor, where they are not zero.
bool is_given(const MotorDesign& design, Parameter parameter);

/// Derivatives of every parameter's value, as get() returns it: row i, column j is d value i / d parameter j, SI.
using ParameterJacobian = std::array<std::array<double, kParameterCount>, kParameterCount>;

/// Derivatives of all parameters with respect to each parameter in use (in_use()) while the others in use stay fixed.
/// G, gamma and m follow the material that gives them (T1.2 to T1.4), or the other way round, and mu_0 moves in
/// proportion to mu unless `fixed_static_friction`. Columns of parameters not in use are zero. Takes a microsecond;
/// with a geometry some milliseconds, and NaN where modes cross. With a geometry, the column of wavelengths keeps the
/// plate and its mode. It does not lead to another n, which has another mode: compare the values of whole n instead.
/// Radii that coincide move together, and the column of one of them alone has no meaning
/// (stator::StatorModel::joint_edges). Never throws for an admissible design.
ParameterJacobian parameter_jacobian(const MotorDesign& design, bool fixed_static_friction = false);

/// Why a value [SI] is not admissible for this parameter, such as "must be at least 0 m, but is -1 m"; empty if it is
/// admissible. NaN and infinity are not.
std::string complaint(Parameter parameter, double value);

/// @throws InputError with the name of the parameter and complaint(), if there is one
void require_admissible(Parameter parameter, double value);

/// A parameter and its value [SI].
using ParameterValue = std::pair<Parameter, double>;

/// The design with some parameters replaced (SI units). The order of the list does not matter, but of two values for
/// the same parameter the last one counts. A value replaces its alternative, and exponent or root of the radial shape
/// replace its table. mu_0 keeps its ratio to mu when only mu is replaced.
/// @throws InputError if a value is not admissible, if a parameter and its alternative are both in the list, if the
///         result has mu_0 < mu, an impossible track or a voltage without the modal data it needs, and for a parameter that
///         follows from the geometry, or belongs to a geometry that the design does not have. A geometry as a whole
///         is checked by complaints().
/// @{
MotorDesign with(const MotorDesign& design, std::span<const ParameterValue> values);
MotorDesign with(const MotorDesign& design, Parameter parameter, double value);
/// @}

/// Everything that is wrong with a design, one sentence each, in the order of the table; empty if it is admissible. A
/// design is admissible if every parameter in use is within its range, mu_0 >= mu, the track does not reach the axis,
/// its radial shape is known and positive on the track, a voltage has its modal data, and a geometry can be built.
std::vector<std::string> complaints(const MotorDesign& design);

/// @throws InputError with every complaint, as the constructor of Motor does
void require_motor(const MotorDesign& design);

}  // namespace twum::inline v0_1
