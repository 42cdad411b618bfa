// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/settings.hpp>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;

namespace {

MotorDesign apply(std::vector<std::string> settings) {
  return with_settings(MotorDesign{}, settings);
}

}  // namespace

TEST_CASE("settings override parameters by name or symbol, the last one holds",
          "[studies][motor]") {
  CHECK(apply({"preload=140 N"}).preload == 140);
  CHECK(apply({" h = 0.2 mm "}).layer.thickness == 0.2e-3);
  CHECK(apply({"h=0.2 mm", "thickness=0.25 mm"}).layer.thickness == 0.25e-3);
  CHECK(apply({}).preload == 160);
  CHECK(apply({"radial_slices=auto"}).stator.radial_slices == kAutoSlices);
  CHECK(apply({"radial_slices=auto 10"}).stator.radial_slices == -10);
}

TEST_CASE("a setting replaces the alternative of its parameter", "[studies][motor]") {
  const MotorDesign design = apply({"G=1 GPa", "gamma=0 Pa.s", "inertia=0 Pa.s^2"});
  CHECK(shear_modulus(design) == 1e9);
  CHECK(shear_viscosity(design) == 0);
  CHECK(inertia(design) == 0);
}

TEST_CASE("wrong settings are all named", "[studies][motor][error]") {
  CHECK_THROWS_WITH(apply({"thicknes=3 mm", "preload=3 mm", "mu", "n=9.5", "h=-1 mm"}),
                    "--set thicknes: unknown parameter 'thicknes'; did you mean 'thickness'?\n"
                    "--set preload: '3 mm' is a length [m]; expected a force [N] such as '160 N'\n"
                    "--set mu: 'mu' has no '='; expected NAME=VALUE such as 'preload=140 N'\n"
                    "--set n: '9.5' is not a whole number; expected a whole number such as '9'\n"
                    "--set h: '-1 mm' is too small; must be at least 10 nm, such as '0.3 mm'");
  CHECK_THROWS_WITH(apply({"nu=0.3", "G=1 GPa"}), Catch::Contains("exclude each other"));
  CHECK_THROWS_WITH(apply({"mu_0=0.1"}), Catch::Contains("static_friction must be at least"));
}
