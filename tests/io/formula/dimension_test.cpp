// SPDX-License-Identifier: Apache-2.0
#include <twum/io/dimension.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/value_error.hpp>

#include <catch2/catch.hpp>

using namespace twum::io;

TEST_CASE("a dimension goes by its usual unit", "[files][units]") {
  for (const char* unit :
       {"m", "N.m", "rad/s", "Hz", "Pa", "W/m^2", "kg/m^3", "N.s/m", "Pa.s^2", "J", "V"})
    CHECK(Dimension(unit).unit() == unit);
  CHECK(Dimension("kW/cm^2") == Dimension("W/m^2"));
  CHECK(Dimension("N.m.rad/s").unit() == "W");
  CHECK(Dimension("1").unit() == "1");
  CHECK(Dimension("%").none());
  CHECK(Dimension("W").power(2).unit() == "W^2");
  CHECK(Dimension("m").power(0.5).unit() == "m^0.5");
  CHECK(Dimension("K").power(-3).unit() == "1/K^3");
  CHECK(Dimension("m").times(Dimension("K")).over(Dimension("A")).power(3).unit() == "m^3.K^3/A^3");
  CHECK(Dimension("kg").over(Dimension("m").times(Dimension("K"))).unit() == "kg/(m.K)");
}

TEST_CASE("a torque is no energy, and differs from it by an angle", "[files][units]") {
  CHECK_FALSE(Dimension("N.m") == Dimension("J"));
  CHECK(Dimension("N.m").differs_by_angle_only(Dimension("J")));
  CHECK(Dimension("Hz").differs_by_angle_only(Dimension("rad/s")));
  CHECK_FALSE(Dimension("Hz").differs_by_angle_only(Dimension("Hz")));
  CHECK_FALSE(Dimension("Hz").differs_by_angle_only(Dimension("m")));
}

TEST_CASE("a number of whatever unit is read with its dimension", "[files][units]") {
  const Measure wear = parse_measure("5 kW/m^2");
  CHECK(wear.value == 5000);
  CHECK(wear.dimension == Dimension("W/m^2"));
  CHECK(parse_measure("26.5 mm").value == 0.0265);
  CHECK(parse_measure("12").dimension.none());
  CHECK(parse_measure("3 %").value == 0.03);
  CHECK_THROWS_WITH(parse_measure("5 Gpa"), "'5 Gpa': unknown unit 'Gpa'; did you mean 'GPa'?");
  CHECK_THROWS_AS(parse_measure("5 mm 3"), ValueError);
  CHECK_THROWS_WITH(parse_measure("5 W92"), Catch::Contains("'W92' is of too high a power"));
}

TEST_CASE("the display of a power takes no prefix, which would belong to its base",
          "[files][units]") {
  CHECK(engineering(2e-6, "m^2") == "2e-06 m^2");
  CHECK(engineering(2e6, "W^2") == "2e+06 W^2");
  CHECK(engineering(5e3, "W/m^2") == "5 kW/m^2");
}
