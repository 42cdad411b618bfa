// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace twum::inline v0_1::io {

// The unit system that UDUNITS-2 is given. It differs from the one that UDUNITS ships in two points: the radian is a
// base unit, and an energy is a torque times an angle (J = N m rad). So rad/s is not Hz, rpm is neither, and N.m is
// not J; torque times angular speed is a power all the same. Compiled in, so that no file has to be found at run
// time. Factors are doubles, not text, because UDUNITS reads decimals with the locale of the process.

struct BaseUnit {
  const char* symbol;
  const char* name;
};

inline constexpr BaseUnit kBaseUnits[] = {{"m", "meter"},    {"kg", "kilogram"}, {"s", "second"},
                                          {"rad", "radian"}, {"A", "ampere"},    {"K", "kelvin"}};

struct UnitPrefix {
  const char* symbol;
  double value;
};

inline constexpr UnitPrefix kPrefixes[] = {
    {"f", 1e-15},       {"p", 1e-12}, {"n", 1e-9}, {"u", 1e-6}, {"\xC2\xB5", 1e-6},
    {"\xCE\xBC", 1e-6}, {"m", 1e-3},  {"c", 1e-2}, {"d", 1e-1}, {"h", 1e2},
    {"k", 1e3},         {"M", 1e6},   {"G", 1e9},  {"T", 1e12}};

struct DerivedUnit {
  const char* symbol;
  double factor;
  const char* definition;
};

inline constexpr DerivedUnit kDerivedUnits[] = {
    {"metre", 1, "m"},
    {"g", 1e-3, "kg"},
    {"t", 1e3, "kg"},
    {"min", 60, "s"},
    {"h", 3600, "s"},
    {"Hz", 1, "s-1"},
    {"N", 1, "kg.m.s-2"},
    {"Pa", 1, "N.m-2"},
    {"J", 1, "N.m.rad"},
    {"W", 1, "J.s-1"},
    {"C", 1, "A.s"},
    {"V", 1, "W.A-1"},
    {"ohm", 1, "V.A-1"},
    {"Ohm", 1, "V.A-1"},
    {"ohms", 1, "V.A-1"},
    {"Ohms", 1, "V.A-1"},
    {"\xCE\xA9", 1, "V.A-1"},
    {"S", 1, "A.V-1"},
    {"F", 1, "C.V-1"},
    {"H", 1, "V.s.A-1"},
    {"deg", std::numbers::pi / 180, "rad"},
    {"degree", std::numbers::pi / 180, "rad"},
    {"degrees", std::numbers::pi / 180, "rad"},
    {"\xC2\xB0", std::numbers::pi / 180, "rad"},
    {"rev", 2 * std::numbers::pi, "rad"},
    {"turn", 2 * std::numbers::pi, "rad"},
    {"rpm", 2 * std::numbers::pi / 60, "rad.s-1"},
    {"RPM", 2 * std::numbers::pi / 60, "rad.s-1"},
    {"rps", 2 * std::numbers::pi, "rad.s-1"},
    {"Nm", 1, "N.m"},
    {"Ncm", 1e-2, "N.m"},
    {"Nmm", 1e-3, "N.m"},
    {"Ns", 1, "N.s"},
    {"bar", 1e5, "Pa"},
    {"in", 0.0254, "m"},
    {"inch", 0.0254, "m"},
    {"ft", 0.3048, "m"},
    {"mil", 2.54e-5, "m"},
    {"lb", 0.45359237, "kg"},
    {"lbf", 4.4482216152605, "N"},
    {"ozf", 4.4482216152605 / 16, "N"},
    {"kgf", 9.80665, "N"},
    {"psi", 4.4482216152605 / (0.0254 * 0.0254), "Pa"},
};

struct NamedDimension {
  const char* unit;
  const char* name;
};

// Names of dimensions in error texts; the first unit that fits is used.
inline constexpr NamedDimension kDimensions[] = {
    {"m", "length"},
    {"N", "force"},
    {"N.m", "torque"},
    {"rad/s", "angular speed"},
    {"Hz", "frequency"},
    {"1/s", "rate of growth"},
    {"Pa", "pressure"},
    {"W", "power"},
    {"V.A", "apparent power"},
    {"rad/s/Hz", "angular speed over frequency"},
    {"rad/s/V", "angular speed over voltage"},
    {"W/m^2", "power per area"},
    {"kg/m^3", "density"},
    {"N.s/m", "force per speed"},
    {"N/V", "force per voltage"},
    {"m/V", "piezoelectric coefficient"},
    {"F/m", "permittivity"},
    {"F", "capacitance"},
    {"ohm", "resistance"},
    {"S", "conductance"},
    {"H", "inductance"},
    {"Pa.s", "viscosity"},
    {"Pa.s^2", "inertia in shear"},
    {"rad", "angle"},
    {"s", "time"},
    {"kg", "mass"},
    {"J", "energy"},
    {"m/s", "speed"},
    {"m^2", "area"},
    {"m^3", "volume"},
    {"m/s^2", "acceleration"},
    {"N/m", "force per length"},
    {"V", "voltage"},
    {"A", "current"},
    {"K", "temperature"},
    {"N.s", "impulse"},
    {"kg.m^2", "moment of inertia"},
    {"N.m.s", "damping of a rotation"},
    {"N.m/rad", "stiffness of a rotation"},
    {"W/K", "conductance for heat"},
    {"J/K", "heat capacity"},
    {"m^2/N", "specific wear"},
    {"W/(m.K)", "conductivity for heat"},
    {"J/(kg.K)", "specific heat"},
    {"1/K", "change per kelvin"},
};

}  // namespace twum::inline v0_1::io
