// SPDX-License-Identifier: Apache-2.0
#include "motion/motion_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>

#include <limits>

namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;
using Catch::Contains;

TEST_CASE("a profile is linear between its rows, with a step where a time stands twice",
          "[motion][input]") {
  const Profile p({{1, 2}, {3, 6}, {3, 0}, {4, 1}});
  CHECK(p.before(0) == 2);
  CHECK(p.after(2) == 4);
  CHECK(p.before(3) == 6);
  CHECK(p.after(3) == 0);
  CHECK(p.after(3.5) == 0.5);
  CHECK(p.before(9) == 1);
  CHECK(p.largest() == 6);
}

TEST_CASE("a profile refuses times that fall, a third row at a time, and no rows",
          "[motion][input]") {
  CHECK_THROWS_WITH(Profile({{1, 0}, {0.5, 0}}), Contains("must rise") && Contains("row 2"));
  CHECK_THROWS_WITH(Profile({{0, 0}, {1, 0}, {1, 1}, {1, 2}}), Contains("row 4 is a third one"));
  CHECK_THROWS_WITH(Profile(std::vector<Profile::Row>{}), Contains("at least one row"));
  CHECK_THROWS_WITH(Profile(std::nan("")), Contains("must be finite"));
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(Profile({{0, infinite}}), Contains("row 1 of a profile is not finite"));
}

TEST_CASE("a motion says what is missing or impossible", "[motion][input]") {
  const MotorDesign motor = elastic_60(1e-4);
  const MotionTask task = steady_drive(motor, 0.01);

  MotorDesign without = motor;
  without.rotor.inertia.reset();
  CHECK_THROWS_WITH(simulate(without, task), Contains("rotor_inertia is missing"));

  MotorDesign unequal = motor;
  unequal.stator.imbalance = Imbalance{1.04, 0, 0};
  CHECK_THROWS_WITH(simulate(unequal, task), Contains("stator.imbalance"));

  MotionTask wrong = task;
  wrong.duration = 0;
  CHECK_THROWS_WITH(simulate(motor, wrong), Contains("duration"));
  wrong = task;
  wrong.frequency = -1.0;
  CHECK_THROWS_WITH(simulate(motor, wrong), Contains("frequency"));
  wrong = task;
  wrong.switched_off = {{0.002, 0.004}, {0.003, 0.005}};
  CHECK_THROWS_WITH(simulate(motor, wrong), Contains("switched_off"));
  wrong = task;
  wrong.tolerance = 1;
  CHECK_THROWS_WITH(simulate(motor, wrong), Contains("tolerance"));
  wrong = task;
  wrong.output_times = {0.002, 0.001};
  CHECK_THROWS_WITH(simulate(motor, wrong), Contains("output times"));
}

TEST_CASE("a steady beginning needs a running wave, and a load without a spring",
          "[motion][input]") {
  MotorDesign motor = elastic_60(1e-4);
  MotionTask task = steady_drive(motor, 0.01);
  task.initial.steady = true;
  task.load_torque = 2.0;  // mu F_N r is 1.04 N m
  CHECK_THROWS_WITH(simulate(motor, task), Contains("no steady running state"));
  task.load_torque = 0.0;
  motor.load = ShaftLoad{.stiffness = 1};
  CHECK_THROWS_WITH(simulate(motor, task), Contains("spring"));
}

TEST_CASE("a wave that is still large cannot be swapped", "[motion][input]") {
  const MotorDesign motor = elastic_60(1e-4);
  MotionTask task = steady_drive(motor, 0.03);
  task.initial.steady = true;
  task.reversed = {{0.005, 0.03}};
  const Motion early = simulate(motor, task);
  CHECK(early.status == "swap-too-early");
  CHECK(early.end == 0.005);
  CHECK(early.last.time == 0.005);

  task.switched_off = {{0, 0.009}};
  task.reversed = {{0.009, 0.03}};
  const Motion late = simulate(motor, task);
  CHECK(late.status == "ok");
  CHECK(late.end == 0.03);
  CHECK(count_of(late, MotionEventKind::swapped) == 1);
  CHECK(late.last.speed < -10);
}

TEST_CASE("a motion stops where it is told to", "[motion][input]") {
  const MotorDesign motor = elastic_60(1e-4);
  MotionTask task = steady_drive(motor, 0.03);
  task.output_times = times_to(0.03, 30);
  task.go_on = [](double time) { return time < 0.004; };
  const Motion m = simulate(motor, task);
  CHECK(m.status == "stopped");
  CHECK(m.end >= 0.004);
  CHECK(m.end < 0.006);
  CHECK(m.samples.back().time <= m.end);
  CHECK(m.samples.back().time > 0.003);
}

TEST_CASE("an exception of a caller's function comes out of the motion", "[motion][input]") {
  const MotorDesign motor = elastic_60(1e-4);
  MotionTask task = steady_drive(motor, 0.03);
  task.go_on = [](double) -> bool { throw InputError("enough"); };
  CHECK_THROWS_WITH(simulate(motor, task), "enough");
}

TEST_CASE("the integrator has a version", "[motion]") {
  REQUIRE(has_integrator());
  CHECK(integrator_version().front() == '6');
}

TEST_CASE("every event has a word", "[motion]") {
  using Event = MotionEventKind;
  CHECK(std::string(to_string(Event::pulled_out)) == "pulled-out");
  CHECK(std::string(to_string(Event::switched_off)) == "switched-off");
}

}  // namespace
