// SPDX-License-Identifier: Apache-2.0
#include "drive/drive.hpp"
#include "random_ring.hpp"

#include <catch2/catch.hpp>

#include <twum/core/frequency_response.hpp>

#include <cmath>
#include <utility>

// A thousand random motors: what must hold for every curve of waves.
namespace {

using namespace twum;
using namespace twum::core;
using namespace twum::test;

// One slice, and eight for every tenth motor.
template <typename F>
void for_each_motor(int motors, F check) {
  Dice dice(644);
  for (int i = 0; i < motors; ++i) {
    MotorDesign design = random_ring(dice, i);
    if (i % 10 == 9) design.stator.radial_slices = 8;
    INFO("motor " << i);
    check(design);
  }
}

// Where the curve over the speed turns H_A is zero, so the curve over the frequency turns there too.
int ends_agree(int motors) {
  int compared = 0;
  for_each_motor(motors, [&](const MotorDesign& design) {
    const Drive drive(design);
    if (!drive.branch().exists()) return;
    const CurveNode& end = drive.branch().first();
    if (!end.fold || end.beyond_kink > 0) return;
    const FrequencyResponse response(design, {Argument::speed, end.parameter});
    double nearest = HUGE_VAL;
    for (const ResponseBranch& branch : response.branches())
      for (const auto& [kind, point] : {std::pair{branch.first_end, branch.points.front()},
                                        std::pair{branch.last_end, branch.points.back()}})
        if (kind == BranchEndKind::fold &&
            std::fabs(point.point.amplitude / end.amplitude - 1) < 1e-2)
          nearest = std::fmin(nearest, std::fabs(point.frequency / design.stator.frequency - 1));
    CAPTURE(end.parameter, end.amplitude);
    // The frequency of a turn goes with the square of the amplitude's error there, 1e-7 of it.
    CHECK(nearest <= 1e-9);
    ++compared;
  });
  return compared;
}

}  // namespace

TEST_CASE("a branch over the speed and one over the frequency end at the same wave (D2.8)",
          "[core][driven][identity]") {
  CHECK(ends_agree(30) > 2);
}
TEST_CASE(
    "branches of a thousand motors over the speed and over the frequency end at the same wave "
    "(D2.8)",
    "[.long][core][driven][identity]") {
  CHECK(ends_agree(1000) > 100);
}
