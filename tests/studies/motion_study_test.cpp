// SPDX-License-Identifier: Apache-2.0
// Studies of motions in time.
#include "entries/motion_columns.hpp"
#include "entries/motion_task.hpp"
#include "results/answers.hpp"

#include "support/motor_files.hpp"

#include <twum/io/value_error.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/telling.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;

namespace {

MotorDesign moving_motor() { return read_motor_file(motor_path("moving-60")).design; }

StudyResult moved(MotionStudy asked, const MotorDesign& design = moving_motor()) {
  return run_study({.motor = {"motor", design}, .asked = std::move(asked)});
}

const MotionResult& motion_of(const StudyResult& result) {
  return std::get<MotionResult>(result.answer);
}

MotionStudy start_and_stop() {
  MotionStudy asked;
  asked.duration = 0.03;
  asked.drive.switched_off = {{0.02, 0.03}};
  return asked;
}

MotionStudy speed_loop() {
  MotionStudy asked;
  asked.duration = 0.05;
  asked.load.inertia = 93e-6;
  asked.control.emplace();
  asked.control->reference = 12.0;
  asked.control->range = {{39.7e3}, {44.5e3}};
  return asked;
}

}  // namespace

TEST_CASE("a study's motion is that of the engine", "[studies][motion]") {
  MotionStudy asked = start_and_stop();
  asked.load.torque = motion::Profile({{0, 0}, {0.01, 0.1}});
  asked.load.inertia = 1e-4;
  const StudyResult result = moved(asked);
  REQUIRE(result.outcome == "done");
  MotorDesign design = moving_motor();
  design.load = ShaftLoad{.inertia = 1e-4};
  motion::MotionTask task = motion::steady_drive(design, 0.03);
  task.switched_off = {{0.02, 0.03}};
  task.load_torque = motion::Profile({{0, 0}, {0.01, 0.1}});
  const motion::Motion direct = motion::simulate(design, task);
  const motion::Motion& own = motion_of(result).members.at(0).motion;
  CHECK(own.last.speed == direct.last.speed);
  CHECK(own.last.angle == direct.last.angle);
  REQUIRE(own.events.size() == direct.events.size());
  for (std::size_t i = 0; i < own.events.size(); ++i)
    CHECK(own.events[i].time == direct.events[i].time);
  CHECK(own.samples.size() == 1001);
}

TEST_CASE("measures are numbers of the samples", "[studies][motion]") {
  MotionStudy asked = start_and_stop();
  for (const char* text :
       {"time_to(speed, 90 %)", "time_to(speed, 100 rpm)", "overshoot(speed)", "peak(amplitude)",
        "angle_after(20.015 ms)", "energy(0 ms, 20 ms)", "time_of(held)", "time_of(pulled-out)"})
    asked.measure.push_back(motion_measure(text));
  const StudyResult result = moved(asked);
  const MotionResult::Member& motor = motion_of(result).members.at(0);
  const auto& samples = motor.motion.samples;
  const auto value = [&](std::size_t i) { return motor.measures.at(i).value; };
  const auto speed_at = [&](double time) {
    return std::ranges::lower_bound(samples, time, {}, &motion::MotionSample::time)->speed;
  };
  const double settled = speed_at(0.02);
  // Between the samples about the time, 30 us apart.
  CHECK(speed_at(value(0) - 30e-6) < 0.9 * settled);
  CHECK(speed_at(value(0)) >= 0.9 * settled);
  CHECK(speed_at(value(1) - 30e-6) < 100 * M_PI / 30);
  CHECK(speed_at(value(1)) >= 100 * M_PI / 30);
  double largest = 0, amplitude = 0;
  for (const auto& s : samples) {
    largest = std::max(largest, s.speed);
    amplitude = std::max(amplitude, s.amplitude);
  }
  // The peak is told between the samples, too: above the largest sample by less than its neighbours are below it.
  const auto most = std::ranges::max_element(samples, {}, &motion::MotionSample::speed);
  const double least_beside = std::min((most - 1)->speed, (most + 1)->speed);
  CHECK(value(2) >= largest / settled - 1);
  CHECK(value(2) < (2 * largest - least_beside) / settled - 1);
  CHECK(value(3) == amplitude);
  // 20.015 ms is no time of a row: the motion has a sample there all the same.
  const auto off = std::ranges::lower_bound(samples, 0.020015, {}, &motion::MotionSample::time);
  CHECK(off->time == 0.020015);
  CHECK(value(4) == samples.back().angle - off->angle);
  CHECK(value(5) ==
        std::ranges::lower_bound(samples, 0.02, {}, &motion::MotionSample::time)->energy);
  CHECK(value(6) > 0.02);
  CHECK(std::isnan(value(7)));
}

TEST_CASE("a measure that is none says what would be right", "[studies][motion]") {
  CHECK_THROWS_WITH(motion_measure("overshot(speed)"), Catch::Contains("did you mean 'overshoot'"));
  CHECK_THROWS_WITH(motion_measure("peak(sped)"), Catch::Contains("did you mean 'speed'"));
  CHECK_THROWS_WITH(motion_measure("peak"), Catch::Contains("peak(phase_current)"));
  CHECK_THROWS_WITH(motion_measure("time_of(stopped)"), Catch::Contains("no event"));
  CHECK_THROWS_AS(motion_measure("time_to(speed, 3 V)"), ValueError);
}

TEST_CASE("a family of motions has a motor for each value", "[studies][motion]") {
  MotionStudy asked = start_and_stop();
  asked.family = CurveStudy::Family{Parameter::load_inertia, {0, 1e-4}};
  const StudyResult result = moved(asked);
  const MotionResult& answer = motion_of(result);
  REQUIRE(answer.members.size() == 2);
  CHECK(answer.members[0].value == 0);
  CHECK(answer.members[1].value == 1e-4);
  // The heavier rotor takes longer to stop: its kinetic energy is 15 times as large.
  CHECK(answer.members[1].motion.last.angle - answer.members[0].motion.last.angle > 0.02);
  CHECK(summary_text(result).find("load_inertia 0.0001 kg.m^2") != std::string::npos);
}

TEST_CASE("a motion is told by its start and its stop", "[studies][motion]") {
  const std::string text = summary_text(moved(start_and_stop()));
  for (const char* words : {"turns at", "It stops", "comes to rest and is held"}) {
    CAPTURE(words, text);
    CHECK(text.find(words) != std::string::npos);
  }
  MotionStudy weak = start_and_stop();
  weak.drive.voltage = 80.0;
  CHECK(summary_text(moved(weak)).find("does not run") != std::string::npos);
}

TEST_CASE("a motion notes what it leaves out", "[studies][motion]") {
  // The load passes the speeds of squeal slowly, and nothing damps the hops of the rotor; of the bare rotor neither grows.
  MotorDesign loaded = moving_motor();
  loaded.rotor.mass = 0.1;
  loaded.load = ShaftLoad{.inertia = 1e-3};
  const StudyResult result = moved(start_and_stop(), loaded);
  const Json notes = answer_json(motion_of(result))["motion"]["notes"];
  REQUIRE(!notes.empty());
  CHECK(notes[0]["note"] == "squeals-while-moving");
  CHECK(summary_text(result).find("Note squeals-while-moving: ") != std::string::npos);
  MotorDesign bare = moving_motor();
  bare.rotor.mass = 0.1, bare.rotor.axial_damping = 300;
  CHECK(answer_json(motion_of(moved(start_and_stop(), bare)))["motion"]["notes"].empty());
}

TEST_CASE("a motor that does not turn is not said to, nor one that speeds up to be settled",
          "[studies][motion]") {
  MotorDesign free = moving_motor();
  free.preload = 0;
  CHECK(summary_text(moved(start_and_stop(), free)).find("does not turn") != std::string::npos);
  MotorDesign heavy = moving_motor();
  heavy.load = ShaftLoad{.inertia = 1};
  CHECK(summary_text(moved(start_and_stop(), heavy)).find("is still becoming faster") !=
        std::string::npos);
}

TEST_CASE("a motion in each vibration tells the error of its points and steps",
          "[studies][motion]") {
  MotionStudy asked = start_and_stop();
  asked.engine = motion::MotionEngine::oscillating;
  asked.measure = {motion_measure("overshoot(speed)"), motion_measure("time_of(started)")};
  const StudyResult result = moved(asked);
  const MotionResult::Member& motor = motion_of(result).members.at(0);
  REQUIRE(motor.motion.status == "ok");
  REQUIRE(motor.step_error.has_value());
  // The largest difference is beyond that at the end of the run, which is the difference of two motions.
  motion::MotionTask task = motion::steady_drive(moving_motor(), 0.03);
  task.engine = motion::MotionEngine::oscillating, task.accuracy = 0.5;
  task.switched_off = asked.drive.switched_off, task.output_times = {0.02};
  const double coarse = motion::simulate(moving_motor(), task).samples.at(0).speed;
  task.accuracy = 1;
  const double fine = motion::simulate(moving_motor(), task).samples.at(0).speed;
  CHECK(motor.step_error->speed >= std::abs(fine - coarse));
  CHECK(motor.step_error->speed < 0.05 * fine);
  REQUIRE(motor.measures.at(0).step_error.has_value());
  CHECK(*motor.measures[0].step_error < 0.05);
  const std::string text = summary_text(result);
  CHECK(text.find("half as many") != std::string::npos);
}

TEST_CASE("a settling time is the last time outside a share of the last value",
          "[studies][motion]") {
  MotionStudy asked;
  asked.duration = 0.02;
  asked.load.inertia = 93e-6;
  asked.measure = {motion_measure("settling_time(speed, 5 %)")};
  const StudyResult result = moved(asked);
  const MotionResult::Member& motor = motion_of(result).members.at(0);
  const auto& samples = motor.motion.samples;
  const double last = samples.back().speed, settled = motor.measures.at(0).value;
  CHECK(settled > 0.001);
  for (const auto& s : samples) {
    const double distance = std::abs(s.speed / last - 1);
    if (s.time > settled) CHECK(distance <= 0.05);
    if (s.time < settled && s.time > settled - 21e-6) CHECK(distance > 0.05);  // the sample before
  }
}

TEST_CASE("a loop's study is that of the engine, with gains and margins", "[studies][motion]") {
  MotionStudy asked = speed_loop();
  const StudyResult result = moved(asked);
  const MotionResult::Member& motor = motion_of(result).members.at(0);
  MotorDesign design = moving_motor();
  design.load = ShaftLoad{.inertia = 93e-6};
  motion::SpeedControl control;
  control.reference = 12.0, control.range = {39.7e3, 44.5e3}, control.start = 44.5e3;
  const motion::ControlledMotion direct =
      motion::simulate(design, motion::steady_drive(design, 0.05), control);
  CHECK(motor.motion.last.speed == direct.motion.last.speed);
  REQUIRE(motor.loop.has_value());
  CHECK(motor.loop->gains.integral == direct.gains.integral);
  CHECK(motor.loop->margins.phase == direct.margins.phase);
  CHECK(summary_text(result).find("phase margin") != std::string::npos);
  CHECK(summary_text(result).find("its reference") != std::string::npos);
  asked.control->kind = MotionControl::Kind::position;
  asked.control->reference = 0.2, asked.control->range = {{40.2e3}, {43.6e3}};
  asked.control->slew = LoopValue{2e5};
  asked.control->gain = 60;
  CHECK(summary_text(moved(asked)).find("from its reference") != std::string::npos);
}

TEST_CASE(
    "measures of a loop refer to its reference, which a loop without an integral does not reach",
    "[studies][motion]") {
  MotionStudy asked = speed_loop();
  asked.control->gains = MotionControl::Gains{{-12.0}, {-1e-3}};
  asked.measure = {motion_measure("settling_time(speed, 1 %)"), motion_measure("overshoot(speed)"),
                   motion_measure("time_to(speed, 90 %)"), motion_measure("overshoot(amplitude)")};
  const StudyResult result = moved(asked);
  const MotionResult::Member& motor = motion_of(result).members.at(0);
  const double last = motor.motion.last.speed;
  REQUIRE(last < 0.99 * 12);
  CHECK(std::isnan(motor.measures.at(0).value));
  CHECK(motor.measures.at(1).value == Approx(motor.motion.fastest / 12 - 1));
  CHECK(std::isnan(motor.measures.at(2).value) == (motor.motion.fastest < 0.9 * 12));
  // The loop does not control the amplitude: its overshoot is over the last one.
  CHECK(motor.measures.at(3).value >= 0);
  CHECK(answer_json(motion_of(result))["motion"]["reference"] == 12.0);
}
