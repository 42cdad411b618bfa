// SPDX-License-Identifier: Apache-2.0
#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>

#include <catch2/catch.hpp>

#include <atomic>
#include <numbers>
#include <thread>

using namespace twum::studies;

namespace {

struct Good {
  const char* text;
  const char* unit;
  double value;
};

// Decimal units are exact (==): the point moves before the only rounding. The others are one product
// of a double that is within an ulp of the true factor.
constexpr double kRpm = 2 * std::numbers::pi / 60;
const Good kGood[] = {
    {"1.6 um", "m", 1.6e-6},
    {"1.6 µm", "m", 1.6e-6},  // micro sign
    {"1.6 μm", "m", 1.6e-6},  // Greek mu
    {"26.5mm", "m", 0.0265},
    {"3 GPa", "Pa", 3e9},
    {"3 N/mm^2", "Pa", 3e6},
    {"3 N/mm²", "Pa", 3e6},
    {"100 rpm", "rad/s", 100 * kRpm},
    {"100 RPM", "rad/s", 100 * kRpm},
    {"1 rev/s", "rad/s", 60 * kRpm},
    {"2 rad/s", "rad/s", 2},
    {"-50 rpm", "rad/s", -50 * kRpm},
    {"0.5 N.m", "N.m", 0.5},
    {"0.5 N m", "N.m", 0.5},
    {"0.5 N*m", "N.m", 0.5},
    {"0.5 N·m", "N.m", 0.5},
    {"500 mNm", "N.m", 0.5},
    {"50 N.cm", "N.m", 0.5},
    {"40 kHz", "Hz", 40e3},
    {"0.04 MHz", "Hz", 40e3},
    {"5 kW/m^2", "W/m^2", 5e3},
    {"0.5 W/cm^2", "W/m^2", 5e3},
    {"45 N.s/m", "N.s/m", 45},
    {"45 Ns/m", "N.s/m", 45},
    {"5.4e-5 Pa.s^2", "Pa.s^2", 5.4e-5},
    {"220 Pa.s", "Pa.s", 220},
    {"1.8 g/cm^3", "kg/m^3", 1800},
    {"1800 kg/m³", "kg/m^3", 1800},
    {"180 deg", "rad", std::numbers::pi},
    {"0.35", "1", 0.35},
    {"5 %", "1", 0.05},
    {"  5   mm ", "m", 0.005},
    {"5\xC2\xA0mm", "m", 0.005},  // no-break space
    {"3 1/s", "1/s", 3},
    {"3 1/ms", "1/s", 3000},
    {"40000 1/s", "Hz", 40000},
    {"120 1/min", "Hz", 2},
    {"1 N.m.rad/s", "W", 1},  // torque times angular speed is a power
    // As people and instruments type them.
    {"45 N\xE2\x8B\x85s/m", "N.s/m", 45},
    {"45 N\xC2\xB7s\xC2\xB7m\xE2\x81\xBB\xC2\xB9", "N.s/m", 45},
    {"45 N\xE3\x83\xBBs/m", "N.s/m", 45},
    {"5 kg/m\xC2\xB3", "kg/m^3", 5},
    {"5 W/(m\xC2\xB7K)", "W/(m.K)", 5},
    {"3 \xCE\xA9", "ohm", 3},
    {"3 \xE2\x84\xA6", "ohm", 3},
    {"3 k\xCE\xA9", "ohm", 3000},
    {"3 kOhm", "ohm", 3000},
    {"60 r/min", "rad/s", 2 * std::numbers::pi},
    {"5 Ncm", "N.m", 0.05},
    {"5 Nmm", "N.m", 0.005},
    {"120 Vrms", "V", 120},
    {"120 V_rms", "V", 120},
    {"12 mArms", "A", 0.012},
};

struct Bad {
  const char* text;
  const char* unit;
  const char* message;
};

const Bad kBad[] = {
    {"0.3 N", "m", "'0.3 N' is a force [N]; expected a length [m] such as 'x'"},
    {"40000 rad/s", "Hz",
     "'40000 rad/s' is an angular speed [rad/s]; expected a frequency [Hz] such as 'x'"},
    {"40000 rpm", "Hz",
     "'40000 rpm' is an angular speed [rad/s]; expected a frequency [Hz] such as 'x'"},
    {"25 us", "Hz", "'25 us' is a time [s]; expected a frequency [Hz] such as 'x'"},
    {"2 Hz", "rad/s", "'2 Hz' is a frequency [Hz]; expected an angular speed [rad/s] such as 'x'"},
    {"100 min^-1", "rad/s",
     "'100 min^-1' is a frequency [Hz]; expected an angular speed [rad/s] such as 'x'; did you "
     "mean "
     "'rpm'?"},
    {"100 1/min", "rad/s",
     "'100 1/min' is a frequency [Hz]; expected an angular speed [rad/s] such as 'x'; did you "
     "mean "
     "'rpm'?"},
    {"3 1/s", "N.m", "'3 1/s' is a frequency [Hz]; expected a torque [N.m] such as 'x'"},
    {"2 s", "rad/s", "'2 s' is a time [s]; expected an angular speed [rad/s] such as 'x'"},
    {"1 J", "N.m", "'1 J' is an energy [J]; expected a torque [N.m] such as 'x'"},
    {"1 N.m", "J", "'1 N.m' is a torque [N.m]; expected an energy [J] such as 'x'"},
    {"3", "m", "'3' has no unit; expected a length [m] such as 'x'"},
    {"3 mm", "1", "'3 mm' is a length [m]; expected a number without unit such as 'x'"},
    {"3 %", "m", "'3 %' is a number without dimension; expected a length [m] such as 'x'"},
    {"3 Mpa", "Pa",
     "'3 Mpa': unknown unit 'Mpa'; expected a pressure [Pa] such as 'x'; did you mean 'MPa'?"},
    {"3 5 mm", "m", "'3 5 mm': '5 mm' is not a unit; expected a length [m] such as 'x'"},
    {"3 mm from 2", "m",
     "'3 mm from 2': 'mm from 2' is not a unit; expected a length [m] such as 'x'"},
    {"3 mm @ 2", "m", "'3 mm @ 2': 'mm @ 2' is not a unit; expected a length [m] such as 'x'"},
    {"3 1/", "Hz", "'3 1/': '1/' is not a unit; expected a frequency [Hz] such as 'x'"},
    {"3 2/s", "Hz", "'3 2/s': '2/s' is not a unit; expected a frequency [Hz] such as 'x'"},
    {"3 1/2s", "Hz", "'3 1/2s': '1/2s' is not a unit; expected a frequency [Hz] such as 'x'"},
    {"3 1/1/s", "Hz", "'3 1/1/s': '1/1/s' is not a unit; expected a frequency [Hz] such as 'x'"},
    {"3 1/s.m", "1/s",
     "'3 1/s.m': '1/s.m' is ambiguous; put parentheses around the denominator; expected a rate of "
     "growth [1/s] "
     "such as 'x'"},
    {"3 W/m.K", "m",
     "'3 W/m.K': 'W/m.K' is ambiguous; put parentheses around the denominator; expected "
     "a length [m] such as "
     "'x'"},
    {"0,3 mm", "m", "'0,3 mm' has a decimal comma; write '0.3 mm'"},
    {"inf m", "m", "'inf m' is not a number; expected a length [m] such as 'x'"},
    {"1e999 m", "m", "'1e999 m' is beyond the range of numbers; expected a length [m] such as 'x'"},
    {"1e308 km", "m",
     "'1e308 km' is beyond the range of numbers; expected a length [m] such as 'x'"},
    {"", "m", "empty; expected a length [m] such as 'x'"},
    {"m", "m", "'m' is not a number; expected a length [m] such as 'x'"},
    {"3 m^999", "m", "'3 m^999': 'm^999' is not a unit; expected a length [m] such as 'x'"},
    {"3 m^", "m", "'3 m^': unknown unit 'm^'; expected a length [m] such as 'x'"},
    {"3 (m", "m", "'3 (m': unknown unit '(m'; expected a length [m] such as 'x'"},
    {"10 Vpp", "V",  // of a sine: 10 / (2 sqrt(2))
     "'10 Vpp' is a peak value, but voltages and currents are rms; of a sine write '3.536 V'"},
    {"10 Vp", "V",
     "'10 Vp' is a peak value, but voltages and currents are rms; of a sine write '7.071 V'"},
    {"10 mApk-pk", "A",
     "'10 mApk-pk' is a peak value, but voltages and currents are rms; of a sine write '3.536 mA'"},
    {"10 Vpp", "m", "'10 Vpp': unknown unit 'Vpp'; expected a length [m] such as 'x'"},
    {"5 W/m\xC2\xB7K", "m",
     "'5 W/m\xC2\xB7K': 'W/m\xC2\xB7K' is ambiguous; put parentheses around the denominator; "
     "expected "
     "a length [m] such as 'x'"},
    {"20 degC", "K",
     "'20 degC' is an absolute temperature; expected a difference of temperatures in K such as '40 "
     "K'"},
};

}  // namespace

TEST_CASE("quantities are read in their unit and come out in SI", "[studies][units]") {
  for (const Good& good : kGood) {
    CAPTURE(good.text);
    CHECK(parse_quantity(good.text, Expected{good.unit, "x"}) == good.value);
  }
}

TEST_CASE("a wrong unit names both dimensions and an example", "[studies][units][error]") {
  for (const Bad& bad : kBad) {
    CAPTURE(bad.text);
    CHECK_THROWS_WITH(parse_quantity(bad.text, Expected{bad.unit, "x"}), bad.message);
  }
}

TEST_CASE("the dimension tells which of several quantities it is", "[studies][units]") {
  const Expected speed_or_torque[] = {{"rad/s", "100 rpm"}, {"N.m", "0.5 N.m"}};
  CHECK(parse_quantity("100 rpm", speed_or_torque).which == 0);
  CHECK(parse_quantity("1 kN.m", speed_or_torque).which == 1);
  CHECK(parse_quantity("1 kN.m", speed_or_torque).value == 1000);
  CHECK_THROWS_WITH(parse_quantity("1 N", speed_or_torque),
                    "'1 N' is a force [N]; expected an angular speed [rad/s] such as '100 rpm' or "
                    "a torque [N.m] such as "
                    "'0.5 N.m'");
}

TEST_CASE("every unit in the tables of parameters and metrics has a name and reads itself",
          "[studies][units]") {
  for (const auto& row : twum::parameter_table()) {
    CAPTURE(row.name);
    CHECK_NOTHROW(parse_quantity(row.example, Expected{row.unit, "", row.absolute}));
    CHECK((row.unit == "1" || !dimension_name(row.unit).empty()));
  }
  for (const auto& row : twum::metric_table()) {
    CAPTURE(row.name);
    CHECK((row.unit == "1" || !dimension_name(row.unit).empty()));
  }
}

TEST_CASE("engineering text reads as people say it", "[studies][units]") {
  CHECK(engineering(1.6e-6, "m") == "1.6 um");
  CHECK(engineering(3e9, "Pa") == "3 GPa");
  CHECK(engineering(100 * kRpm, "rad/s") == "100 rpm");
  CHECK(engineering(0.35, "1") == "0.35");
  CHECK(engineering(1800, "kg/m^3") == "1800 kg/m^3");
  CHECK(engineering(1800, "1/s") == "1800 1/s");
  CHECK(engineering(0, "N") == "0 N");
  CHECK(engineering(-0.0005, "N.m") == "-500 uN.m");
  CHECK(engineering(999.99999999, "W") == "1 kW");
  CHECK(engineering(123456, "W/m^2") == "123.5 kW/m^2");
}

TEST_CASE("units may be parsed from several threads", "[studies][units]") {
  std::atomic<int> wrong{0};
  const auto parse_many = [&] {
    for (int i = 0; i < 2000; ++i) {
      if (parse_quantity("1.5 kW/m^2", Expected{"W/m^2", ""}) != 1500) ++wrong;
    }
  };
  std::thread other(parse_many);
  parse_many();
  other.join();
  CHECK(wrong == 0);
}
