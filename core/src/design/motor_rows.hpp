// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/layer_properties.hpp"
#include "design/parameter_place.hpp"

#include <twum/core/parameters.hpp>

#include <array>
#include <numbers>

namespace twum::inline v0_1 {

/// One parameter: what is said of it, and where a design holds it.
struct ParameterRow {
  ParameterInfo info;
  ParameterPlace place;
};

namespace motor_rows {

using P = Parameter;
using N = PlateNumber;
inline constexpr std::optional<Parameter> kNoAlternative;

/// @name Values of numbers that the design states otherwise
/// @{
inline double frequency_ratio(const MotorDesign& d) {
  return d.stator.frequency_ratio ? *d.stator.frequency_ratio
                                  : d.stator.frequency / get(d, P::resonance_frequency);
}
inline double given_amplitude(const MotorDesign& d) {
  return d.stator.voltage ? kNoValue : d.stator.amplitude;
}
inline double quality_factor(const MotorDesign& d) {
  return d.stator.quality_factor
             ? *d.stator.quality_factor
             : modal_damping_of(d.stator.modal_damping, get(d, P::resonance_frequency),
                                get(d, P::modal_mass));
}
inline double poisson_ratio(const MotorDesign& d) {
  return d.layer.given_shear_modulus
             ? poisson_ratio_of(d.layer.youngs_modulus, *d.layer.given_shear_modulus)
             : d.layer.poisson_ratio;
}
inline double density(const MotorDesign& d) {
  return d.layer.given_inertia ? density_of(*d.layer.given_inertia, d.layer.thickness)
                               : d.layer.density;
}
inline double loss_factor(const MotorDesign& d) {
  return d.layer.given_shear_viscosity
             ? loss_factor_of(*d.layer.given_shear_viscosity, shear_modulus(d),
                              2 * std::numbers::pi * drive_frequency(d))
             : d.layer.loss_factor;
}
/// @}

inline bool is_sliced(const MotorDesign& d) { return d.stator.radial_slices != 1; }
inline bool has_shape(const MotorDesign& d) { return is_sliced(d) || d.stator.radial_motion; }
inline bool by_modal_data(const MotorDesign& d) { return !d.stator.geometry; }
inline bool has_electrodes(const MotorDesign& d) {
  return d.stator.geometry || d.stator.force_factor;
}
inline bool shape_has_formula(const MotorDesign& d) {
  return !d.stator.geometry && d.stator.radial_shape.table.empty();
}

/// mu_0 keeps its ratio to mu.
inline bool set_kinetic_friction(MotorDesign& d, double value) {
  d.friction.threshold = friction_ratio(d.friction) * value;
  return assign<&Friction::kinetic>(d, value);
}

/// Exponent and root of the radial shape; they replace its table.
template <auto member>
constexpr ParameterPlace of_shape() {
  return plain<member>()
      .used_if([](const MotorDesign& d) { return has_shape(d) && shape_has_formula(d); })
      .kept_if(shape_has_formula)
      .set_by([](MotorDesign& d, double value) {
        d.stator.radial_shape.table.clear();
        return assign<member>(d, value);
      });
}

/// A number of the sensor; none without a sensor.
template <auto member>
constexpr ParameterPlace of_sensor() {
  return in_block<&Stator::sensor, member>().read_by([](const MotorDesign& d) {
    return d.stator.sensor ? double{(*d.stator.sensor).*member} : kNoValue;
  });
}

inline constexpr ParameterPlace kSensorLoadResistance{
    [](const MotorDesign& d) {
      return d.stator.sensor ? d.stator.sensor->load_resistance.value_or(kNoValue) : kNoValue;
    },
    [](const MotorDesign& d) { return d.stator.sensor && d.stator.sensor->load_resistance; },
    [](MotorDesign& d, double value) {
      if (!d.stator.sensor) d.stator.sensor.emplace();
      d.stator.sensor->load_resistance = value;
      return true;
    }};

/// Rows of the parameter table for everything but the stator's geometry. The ranges admit every plausible motor and
/// the limits of the model; `reason` says why they end there. Within them no number of the model overflows.
inline constexpr std::array kMotorRows{std::to_array<ParameterRow>({
    {{P::wavelengths, "wavelengths", "n", "1", "stator.wavelengths", 1, 200, true, true,
      kNoAlternative, "9", "number of wavelengths around the circumference",
      "more than 200 would be shorter than 1 mm on a ring of 60 mm", ""},
     plain<&Stator::wavelengths>()},
    {{P::contact_radius, "contact_radius", "r", "m", "stator.contact_radius", 1e-4, 1, false, true,
      kNoAlternative, "26.5 mm", "mean radius of the contact track",
      "from silicon rings to rings of 2 m; known motors have 1 to 200 mm", ""},
     plain<&Stator::contact_radius>().moving(stator::Dimension::contact_radius)},
    {{P::contact_width, "contact_width", "b", "m", "stator.contact_width", 1e-8, 1, false, true,
      kNoAlternative, "4 mm", "radial width of the contact track",
      "from a line contact of 10 nm to the largest radius", ""},
     plain<&Stator::contact_width>()},
    {{P::neutral_plane_distance, "neutral_plane_distance", "a", "m",
      "stator.neutral_plane_distance", 1e-6, 0.1, false, true, kNoAlternative, "3 mm",
      "distance from the neutral plane to the stator surface",
      "from half of a film of 2 um to teeth of 100 mm", ""},
     plain<&Stator::neutral_plane_distance>().given_by(N::neutral_plane_distance)},
    {{P::frequency, "frequency", "f", "Hz", "stator.frequency", 1, 1e9, false, true,
      P::frequency_ratio, "40 kHz", "drive frequency",
      "from slow scale models to surface acoustic waves of 1 GHz", ""},
     unless_given<&Stator::frequency, &Stator::frequency_ratio>().read_by(drive_frequency)},
    {{P::frequency_ratio, "frequency_ratio", "", "1", "stator.frequency_ratio", 0.01, 100, false,
      false, P::frequency, "1.046", "drive frequency over resonance_frequency",
      "a motor runs within a tenth of its resonance; two decades each way leave room for other "
      "stators",
      ""},
     optional_number<&Stator::frequency_ratio>().read_by(frequency_ratio)},
    {{P::amplitude, "amplitude", "A", "m", "stator.amplitude", 0, 1e-2, false, true, P::voltage,
      "1.6 um", "amplitude of the travelling wave",
      "0 is no drive; 10 mm is a model of a motor at audible frequencies", ""},
     unless_given<&Stator::amplitude, &Stator::voltage>().read_by(given_amplitude)},
    {{P::voltage, "voltage", "", "V", "stator.voltage", 0, 1e5, false, false, P::amplitude, "120 V",
      "drive voltage of each of the two phases, rms; gives the amplitude at each load",
      "0 is no drive; no stator withstands 100 kV", ""},
     optional_number<&Stator::voltage>()},
    {{P::modal_damping, "modal_damping", "", "N.s/m", "stator.modal_damping", 0, 1e6, false, false,
      P::quality_factor, "45 N.s/m", "modal damping c of the stator; its loss is c (omega A)^2",
      "0 is a stator without loss; 1 MN.s/m is 1 kg at 150 kHz with a quality factor of 1", "0"},
     unless_given<&Stator::modal_damping, &Stator::quality_factor>().read_by(twum::modal_damping)},
    {{P::quality_factor, "quality_factor", "", "1", "stator.quality_factor", 0.5, 1e9, false, false,
      P::modal_damping, "150", "quality factor of the free stator; gives modal_damping",
      "below 0.5 a stator does not vibrate freely; the best quartz resonators reach 1e9 at low "
      "temperature",
      ""},
     optional_number<&Stator::quality_factor>().read_by(quality_factor)},
    {{P::resonance_frequency, "resonance_frequency", "", "Hz", "stator.resonance_frequency", 1, 1e9,
      false, false, kNoAlternative, "39 kHz", "resonance of the free stator with shorted phases",
      "as the drive frequency", "none; a voltage needs it", false},
     optional_number<&Stator::resonance_frequency>().given_by(N::resonance_frequency)},
    {{P::modal_mass, "modal_mass", "", "kg", "stator.modal_mass", 1e-15, 1e4, false, false,
      kNoAlternative, "25 g",
      "mass of each of the two modes, for the displacement at the contact radius",
      "from a silicon disc of 10 um to a steel ring of 2 m", "none; a voltage needs it", false},
     optional_number<&Stator::modal_mass>().given_by(N::modal_mass)},
    {{P::force_factor, "force_factor", "", "N/V", "stator.force_factor", 1e-9, 1e6, false, false,
      kNoAlternative, "0.55 N/V",
      "modal force of a phase per volt, and charge per modal displacement",
      "from a phase with practically no effect to a stack of a thousand thin layers on a ring of 2 "
      "m",
      "none; a voltage needs it", false},
     optional_number<&Stator::force_factor>().given_by(N::force_factor)},
    {{P::blocked_capacitance, "blocked_capacitance", "", "F", "stator.blocked_capacitance", 0, 1,
      false, false, kNoAlternative, "8.5 nF", "capacitance of a phase with the stator blocked",
      "0 leaves the motional current only; 1 F is beyond any ceramic", "0 F", false},
     plain<&Stator::blocked_capacitance>()
         .used_if(has<&Stator::force_factor>)
         .given_by(N::blocked_capacitance)
         .kept_if(by_modal_data)},
    {{P::loss_tangent, "loss_tangent", "", "1", "stator.loss_tangent", 0, 10, false, false,
      kNoAlternative, "0.01", "loss tangent of the blocked capacitance",
      "0 is a ceramic without dielectric loss; soft ceramics in strong fields reach 0.1", "0",
      false},
     plain<&Stator::loss_tangent>().used_if(has_electrodes).kept_if(always)},
    {{P::voltage_ratio, "voltage_ratio", "", "1", "stator.imbalance.voltage_ratio", 0.1, 10, false,
      false, kNoAlternative, "1.05", "voltage of the second phase over that of the first",
      "beyond a factor of ten one phase has almost no effect, and the wave stands", "1"},
     in_block<&Stator::imbalance, &Imbalance::voltage_ratio>()},
    {{P::phase_error, "phase_error", "", "rad", "stator.imbalance.phase_error", -1.5, 1.5, false,
      false, kNoAlternative, "0.05 rad",
      "lead of the second phase over its ideal place 90 degrees behind the first",
      "at 1.57 rad, 90 degrees, both phases are equal: a standing wave", "0 rad"},
     in_block<&Stator::imbalance, &Imbalance::phase_error>()},
    {{P::mode_splitting, "mode_splitting", "", "1", "stator.imbalance.mode_splitting", -0.1, 0.1,
      false, false, kNoAlternative, "0.001",
      "half the relative difference of the two modes' stiffnesses",
      "at 0.1 the resonances of the two modes differ by 10 %: no travelling wave", "0"},
     in_block<&Stator::imbalance, &Imbalance::mode_splitting>()},
    {{P::sensor_force_factor, "sensor_force_factor", "", "N/V", "stator.sensor.force_factor", -1e6,
      1e6, false, false, kNoAlternative, "0.03 N/V",
      "charge of the sensor electrode per amplitude of the wave", "as force_factor, of either sign",
      "0 N/V"},
     of_sensor<&Sensor::force_factor>()},
    {{P::sensor_capacitance, "sensor_capacitance", "", "F", "stator.sensor.capacitance", 0, 1,
      false, false, kNoAlternative, "0.5 nF", "capacitance of the sensor electrode",
      "0 is an electrode whose charge goes to its load only; 1 F is beyond any ceramic", "0 F"},
     of_sensor<&Sensor::capacitance>()},
    {{P::sensor_load_capacitance, "sensor_load_capacitance", "", "F",
      "stator.sensor.load_capacitance", 0, 1, false, false, kNoAlternative, "0.1 nF",
      "capacitance of the cable and the amplifier on the sensor", "0 is an electrode without cable",
      "0 F"},
     of_sensor<&Sensor::load_capacitance>()},
    {{P::sensor_load_resistance, "sensor_load_resistance", "", "ohm",
      "stator.sensor.load_resistance", 1e-3, 1e15, false, false, kNoAlternative, "1 Mohm",
      "resistance of the amplifier on the sensor", "from a short circuit to the best insulators",
      "none: the electrode is open"},
     kSensorLoadResistance},
    {{P::sensor_position, "sensor_position", "", "rad", "stator.sensor.position", -7, 7, false,
      false, kNoAlternative, "1.57 rad",
      "phase of the wave by which the sensor stands behind the first phase",
      "one wavelength in either direction", "0 rad"},
     of_sensor<&Sensor::position>()},
    {{P::radial_slices, "radial_slices", "", "1", "stator.radial_slices", -256, 256, true, false,
      kNoAlternative, "8",
      "slices of each smooth piece of the contact track; 1: the whole contact at the contact "
      "radius; auto (0 as a number): as many as needed for an accurate torque",
      "with 256 slices of each smooth piece the torque is exact to rounding, next to kinks to 1e-6",
      "1"},
     plain<&Stator::radial_slices>().used_if(is_sliced)},
    {{P::shape_exponent, "shape_exponent", "", "1", "stator.radial_shape.exponent", -20, 20, false,
      false, kNoAlternative, "1.5",
      "exponent p of the wave's radial shape R = ((rho - rho_0) / (r - rho_0))^p",
      "a plate near its clamp has 2; with 20, on a track as wide as a fifth of its radius, the "
      "wave "
      "is 55 times higher at the outer than at the inner edge",
      "0"},
     of_shape<&RadialShape::exponent>()},
    {{P::shape_root, "shape_root", "", "m", "stator.radial_shape.root", 0, 2, false, false,
      kNoAlternative, "13 mm",
      "radius rho_0 where the wave's radial shape is zero; outside the contact track",
      "0 is the axis; twice the largest contact radius for a ring clamped at its outer edge",
      "0 m"},
     of_shape<&RadialShape::root>()},
    {{P::thickness, "thickness", "h", "m", "contact_layer.thickness", 1e-8, 0.1, false, true,
      kNoAlternative, "0.3 mm", "thickness of the contact layer",
      "thinner than 10 nm is no continuum; thicker than 100 mm is no layer", ""},
     plain<&ContactLayer::thickness>()},
    {{P::youngs_modulus, "youngs_modulus", "E", "Pa", "contact_layer.youngs_modulus", 1e3, 1e13,
      false, true, kNoAlternative, "3 GPa", "Young's modulus of the contact layer",
      "from soft gels, 1 kPa, to ten times diamond, the limit of a rigid layer", ""},
     plain<&ContactLayer::youngs_modulus>()},
    {{P::poisson_ratio, "poisson_ratio", "nu", "1", "contact_layer.poisson_ratio", -0.99, 0.5,
      false, true, P::shear_modulus, "0.35",
      "Poisson ratio of the contact layer; gives G = E / (2 (1 + nu))",
      "a stable isotropic material lies between -1 and 0.5; near -1 G grows without bound, so give "
      "shear_modulus instead",
      ""},
     unless_given<&ContactLayer::poisson_ratio, &ContactLayer::given_shear_modulus>().read_by(
         poisson_ratio)},
    {{P::density, "density", "rho", "kg/m^3", "contact_layer.density", 0, 3e4, false, true,
      P::inertia, "1800 kg/m^3", "density of the contact layer; gives m = rho h^2 / 3",
      "0 is a layer without inertia; osmium, the densest solid, has 22600 kg/m^3", ""},
     unless_given<&ContactLayer::density, &ContactLayer::given_inertia>().read_by(density)},
    {{P::loss_factor, "loss_factor", "", "1", "contact_layer.loss_factor", 0, 10, false, true,
      P::shear_viscosity, "0.05",
      "loss factor of the layer in shear; gives gamma = loss_factor G / omega",
      "0 is a layer without loss; rubber in its glass transition reaches 3", ""},
     unless_given<&ContactLayer::loss_factor, &ContactLayer::given_shear_viscosity>().read_by(
         loss_factor)},
    {{P::shear_modulus, "shear_modulus", "G", "Pa", "contact_layer.shear_modulus", 100, 1e13, false,
      false, P::poisson_ratio, "1.1 GPa", "shear modulus of the contact layer, given directly",
      "below a third of the softest E; up to 10 TPa, the limit of a rigid layer", ""},
     optional_number<&ContactLayer::given_shear_modulus>().read_by(twum::shear_modulus)},
    {{P::shear_viscosity, "shear_viscosity", "gamma", "Pa.s", "contact_layer.shear_viscosity", 0,
      1e9, false, false, P::loss_factor, "220 Pa.s", "shear viscosity of the layer, given directly",
      "0 is a layer without loss; 1 GPa.s is a loss factor of 10 at G = 10 TPa and 16 kHz", ""},
     optional_number<&ContactLayer::given_shear_viscosity>().read_by(twum::shear_viscosity)},
    {{P::inertia, "inertia", "m", "Pa.s^2", "contact_layer.inertia", 0, 1e6, false, false,
      P::density, "5.4e-5 Pa.s^2", "inertia of the layer in shear, given directly",
      "0 is a layer without inertia; at 1 Hz, 1 MPa.s^2 has the effect of 100 mPa.s^2 at 3 kHz",
      ""},
     optional_number<&ContactLayer::given_inertia>().read_by(twum::inertia)},
    {{P::kinetic_friction, "kinetic_friction", "mu", "1", "friction.kinetic", 0, 5, false, true,
      kNoAlternative, "0.2", "friction coefficient while slipping",
      "0 is no friction; soft rubber on a dry track reaches 4", ""},
     plain<&Friction::kinetic>().set_by(set_kinetic_friction)},
    {{P::static_friction, "static_friction", "mu_0", "1", "friction.static", 0, 10, false, false,
      kNoAlternative, "0.2",
      "friction coefficient at the threshold of sticking, at least the kinetic one",
      "0 is no friction; twice the largest kinetic one", "the kinetic one"},
     plain<&Friction::threshold>()},
    {{P::rotor_taper, "rotor_taper", "", "rad", "rotor.taper", -0.1, 0.1, false, false,
      kNoAlternative, "20 urad",
      "cone angle of the rotor's face; positive if the gap widens towards the outer edge",
      "1 mrad over 4 mm is 4 um, more than a usual amplitude; beyond 0.1 rad only an edge touches",
      "0 rad"},
     plain<&Rotor::taper>().used_if(is_sliced).kept_if(always)},
    {{P::rotor_mass, "rotor_mass", "", "kg", "rotor.mass", 0, 1e6, false, false, kNoAlternative,
      "100 g",
      "mass that moves along the axis with the rotor's face; used for backward waves and the axial "
      "motion",
      "0 is a rotor without inertia; 1000 t practically do not move",
      "none: the rotor has no inertia"},
     optional_number<&Rotor::mass>()},
    {{P::preload, "preload", "F_N", "N", "preload", 0, 1e11, false, true, kNoAlternative, "160 N",
      "total axial force that presses rotor and stator together",
      "0 is no contact; 100 GN is ten times the preload for full contact of the stiffest tested "
      "motor",
      ""},
     plain<&MotorDesign::preload>()},
})};

}  // namespace motor_rows

using motor_rows::kMotorRows;
}  // namespace twum::inline v0_1
