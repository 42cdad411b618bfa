// SPDX-License-Identifier: Apache-2.0
// A host may have enabled floating-point traps: an operation of the core that raised one would end this program.
#include "support/driven_motors.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cfenv>
#include <vector>

#ifdef __GLIBC__
using namespace twum;

namespace {

constexpr int kTraps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

// Everything that a motor answers, with traps enabled.
std::size_t ask_everything(const MotorDesign& design) {
  std::vector<MetricRequest> all;
  for (const MetricInfo& row : metric_table())
    if (row.argument == Argument::none) all.push_back({row.metric});
  std::feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(kTraps);
  const Motor motor(design);
  std::size_t asked = 0;
  for (int i = 0; i < 80; ++i) {
    const OperatingPoint point = motor.operating_point(0.25 * i);
    if (point.status == PointStatus::ok) asked += motor.zones(0.25 * i).size();
  }
  asked += motor.fields(1.0, 50).samples.size();
  asked += evaluate(motor, all).size();
  asked += differentiate(motor, all).size();
  const int after = fedisableexcept(FE_ALL_EXCEPT);
  CHECK(after == kTraps);  // the host's traps are what they were
  CHECK(std::fetestexcept(kTraps) == 0);
  return asked;
}

}  // namespace

TEST_CASE("traps of the host do not fire, and stay enabled", "[core][traps]") {
  CHECK(ask_everything(MotorDesign{}) > 100);
  CHECK(ask_everything(test::ring_motor()) > 100);
  MotorDesign rubbery;
  rubbery.friction.threshold = 0.3;
  rubbery.layer.loss_factor = 0.005;
  CHECK(ask_everything(rubbery) > 100);
  CHECK(ask_everything(test::driven_motor()) > 100);
}
#endif
