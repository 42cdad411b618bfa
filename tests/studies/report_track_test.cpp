// SPDX-License-Identifier: Apache-2.0
// What a report page shows of a track with width, against the laws that hold for the whole motor.
#include "report/encode.hpp"
#include "report/track.hpp"
#include "report_numbers.hpp"
#include "support/motor_files.hpp"

#include <twum/core/parameters.hpp>
#include <twum/motors/motor_file.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace twum;
using namespace twum::test;
using namespace twum::studies;
using Catch::Matchers::WithinRel;

namespace {

Motor wide_motor() {
  const MotorDesign ring = read_motor_file(test::motor_path("ring-60")).design;
  return Motor(with(ring, Parameter::radial_slices, 8));
}

}  // namespace

TEST_CASE("one slice has no map of the track", "[studies][report]") {
  const Motor slice(with(wide_motor().design(), Parameter::radial_slices, 1));
  CHECK(track_json(slice).is_null());
  CHECK(one_slice_torque_json(slice, {}).is_null());
}

TEST_CASE("the pressure on the map of a track adds up to the preload", "[studies][report]") {
  const Motor motor = wide_motor();
  const Json track = track_json(motor);
  const auto phase = numbers<float>(track["phase"]);
  const auto radius = numbers<float>(track["radius"]);
  const auto pressure = numbers<float>(track["pressure"]);
  REQUIRE(pressure.size() == phase.size() * radius.size());
  CHECK_THAT(radius.back() - radius.front(),
             WithinRel(motor.design().stator.contact_width, 1e-4));  // single precision of 28 mm
  // n waves over the whole circle: F_N is the integral of p r over radius and phase. Trapezoids over the
  // radius; over the phase some 70 places with kinks at the ends of the contact, (1 / 70)^2 of its size.
  const double dphase = (phase.back() - phase.front()) / static_cast<double>(phase.size() - 1);
  const double dradius = (radius.back() - radius.front()) / static_cast<double>(radius.size() - 1);
  double force = 0;
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    const std::size_t row = k / phase.size();
    const double end = row == 0 || row + 1 == radius.size() ? 0.5 : 1;
    if (std::isfinite(pressure[k])) force += end * pressure[k] * radius[row] * dphase * dradius;
  }
  CHECK_THAT(force, WithinRel(motor.design().preload, 5e-3));
}

TEST_CASE("nothing slips on the map where a zone sticks, and something does elsewhere",
          "[studies][report]") {
  const Json track = track_json(wide_motor());
  const auto phase = numbers<float>(track["phase"]);
  REQUIRE(track["frames"].size() == 21);
  std::size_t sticking = 0;
  for (const Json& frame : track["frames"]) {
    const auto slip = numbers<float>(frame["slip"]);
    double most = 0;
    for (const float v : slip)
      if (std::isfinite(v)) most = std::max(most, static_cast<double>(v));
    CHECK(most > 0);
    for (std::size_t row = 0; row < frame["zones"].size(); ++row)
      for (const Json& zone : frame["zones"][row])
        for (std::size_t i = 0; i < phase.size(); ++i) {
          if (zone[0] != 0 || phase[i] <= zone[1] || phase[i] >= zone[2]) continue;
          const float v = slip[row * phase.size() + i];
          if (!std::isfinite(v)) continue;  // on the edge of the contact, by rounding
          ++sticking;
          if (v > 1e-6 * most) FAIL_CHECK("slips by " << v << " at row " << row);
        }
  }
  CHECK(sticking > 1000);
}

TEST_CASE("the torque of one slice is that of the motor without width", "[studies][report]") {
  const Motor motor = wide_motor();
  const std::vector<double> speeds{0, 5, 10};
  const auto torque = numbers<double>(one_slice_torque_json(motor, speeds));
  const Motor slice(with(motor.design(), Parameter::radial_slices, 1));
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    CHECK(torque[i] == slice.operating_point(speeds[i]).torque);
    CHECK(torque[i] != motor.operating_point(speeds[i]).torque);
  }
}
