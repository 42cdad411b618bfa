// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/plain_name.hpp>

#include <catch2/catch.hpp>

using namespace twum::studies;

TEST_CASE("names are read as words", "[studies][names]") {
  CHECK(plain_name("peak_power") == "peak power");
  CHECK(plain_name("no_load_speed") == "no-load speed");
  CHECK(plain_name("torque_at(80 rpm)") == "torque at 80 rpm");
  CHECK(plain_name("thickness") == "contact layer thickness");
  CHECK(plain_name("youngs_modulus") == "contact layer Young's modulus");
  CHECK(plain_name("glue_poisson_ratio") == "glue Poisson ratio");
  CHECK(plain_name("preload") == "preload");
  CHECK(plain_name("mean(peak_power)") == "mean peak power");
  CHECK(plain_name("sd(no_load_speed)") == "standard deviation of the no-load speed");
  CHECK(plain_name("quantile(torque_at(80 rpm), 5 %)") == "5 % quantile of the torque at 80 rpm");
  CHECK(plain_name("probability(no_load_speed >= 100 rpm)") ==
        "probability of no-load speed ≥ 100 rpm");
}

TEST_CASE("formulas and unknown names stay as they are typed", "[studies][names]") {
  CHECK(plain_name("thickness / (2 * contact_half_length)") ==
        "thickness / (2 * contact_half_length)");
  CHECK(plain_name("mean()") == "mean()");
  CHECK(plain_name("quantile(peak_power)") == "quantile(peak_power)");
  CHECK(plain_name("_at(") == "_at(");
  CHECK(plain_name("").empty());
}

TEST_CASE("limits are read with the signs of mathematics", "[studies][names]") {
  CHECK(plain_limit("no_load_speed >= 100 rpm") == "no-load speed ≥ 100 rpm");
  CHECK(plain_limit("145 rpm <= no_load_speed<=155 rpm") == "145 rpm ≤ no-load speed ≤ 155 rpm");
  CHECK(plain_limit("no_load_speed == 150 rpm +- 3 %") == "no-load speed = 150 rpm ± 3 %");
  CHECK(plain_limit("peak_power") == "peak power");
}
