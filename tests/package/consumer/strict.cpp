// SPDX-License-Identifier: Apache-2.0
// Values made in place, as a program with many warnings switched on makes them. Prints two numbers that are 100.
#include <twum/twum.hpp>

#include <cstdio>
#include <utility>

namespace {

using namespace twum;

// (x - 100)^2 as a program states it.
optim::Problem parabola() {
  optim::Problem p;
  p.variables = {{.name = "x", .lower = 1, .upper = 1000, .scale = optim::Scale::log}};
  p.objectives = {{.name = "f"}};
  p.constraints = {{.name = "g", .upper = 1e9}};
  p.evaluate = [](std::span<const double> x, bool) {
    const double d = x[0] - 100;
    return optim::Evaluation{.values = {d * d, x[0]}, .jacobian = {2 * d, 1}};
  };
  return p;
}

double best_preload() {
  studies::DesignProblem p{MotorDesign{}};
  p.vary("preload", "10 N", "500 N").minimize("preload").limit("holding_torque >= 0.53 N.m");
  return solve(p, {.solver = "auto"}).motor.preload;
}

// A study made in place, with its rows.
std::size_t rows() {
  studies::SweepStudy sweep;
  sweep.variables = {{.parameter = Parameter::preload, .values = {60, 70}},
                     {.parameter = Parameter::amplitude, .min = 1e-6, .max = 2e-6, .points = 3}};
  sweep.metrics = studies::parse_metric_list("holding_torque");
  const auto result = run_study(
      studies::StudyFile{.motor = {.name = "m", .design = {}}, .asked = sweep}, {.jobs = 1});
  std::size_t count = 0;
  result.rows->read([&](const auto&) { ++count; });
  return count;
}

}  // namespace

int main() try {
  const auto best = optim::solve(parabola(), {.starts = 2, .budget = {.evaluations = 500}});
  std::printf("%.6f %.6f\n", best.design.at(0), best_preload());
  Motor motor(MotorDesign{.stator = {.contact_radius = 0.02}, .preload = 140});
  const Motor moved(std::move(motor));
  return rows() == 6 && moved.design() == motor.design() && motor == moved ? 0 : 1;
} catch (const Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
