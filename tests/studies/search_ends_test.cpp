// SPDX-License-Identifier: Apache-2.0
// Every rung of auto's ladder on motors where searches have gone astray: light damping, static friction above
// kinetic, limits that no design keeps. Each solve must end by itself, and take no further call once it is asked
// to stop.
#include "search_support.hpp"

#include <twum/optim/random.hpp>
#include <twum/optim/solvers.hpp>
#include <twum/studies/motor_problem.hpp>

#include "search/solve_continuous.hpp"
#include "support/motor_files.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>
#include <array>
#include <csignal>
#include <cstdlib>
#include <set>

using namespace twum;
using namespace twum::studies;

namespace {

constexpr unsigned kEndless = 600;  // [s] after which the alarm ends the test program

// An abort is reported with the case that it came in.
void watch(unsigned seconds) {
  std::signal(SIGALRM, [](int) { std::abort(); });
  alarm(seconds);
}

struct Question {
  DesignProblem problem;
  std::string text;
};

Question random_question(std::uint64_t number) {
  optim::Random random(1, number, 0);
  const auto spread = [&](double low, double high) {
    return low * std::pow(high / low, random.uniform());
  };
  MotorDesign motor = read_motor_file(test::motor_path("ring-60")).design;
  motor.layer.loss_factor = spread(2e-3, 5e-2);
  motor.friction.kinetic = spread(0.12, 0.3);
  motor.friction.threshold = motor.friction.kinetic * (1 + 0.5 * random.uniform());
  motor.preload = spread(80, 250);
  Question question{{motor, {}, {}, {}}, {}};
  DesignProblem& p = question.problem;
  p.vary(Parameter::preload, motor.preload / 2, motor.preload * 2);
  if (random.uniform() < 0.7) p.vary(Parameter::thickness, 1e-4, 1e-3);
  if (random.uniform() < 0.5) p.vary(Parameter::frequency, 25e3, 80e3);
  constexpr std::array kObjectives{"peak_power", "torque_at_peak_power", "no_load_speed",
                                   "stick_fraction_at(100 rpm)", "max_efficiency"};
  const std::string objective = kObjectives.at(random.below(kObjectives.size()));
  random.uniform() < 0.5 ? p.maximize(objective) : p.minimize(objective);
  const std::array limits{"peak_power <= " + std::to_string(spread(1, 30)) + " W",
                          "no_load_speed <= " + std::to_string(spread(50, 300)) + " rpm",
                          "efficiency_at(0.4 N.m) >= " + std::to_string(spread(0.1, 0.8)),
                          "max_pressure <= " + std::to_string(spread(0.8, 8)) + " MPa"};
  for (const std::string& limit : limits)
    if (random.uniform() < 0.5) p.limit(limit), question.text += limit + "; ";
  question.text += objective;
  return question;
}

}  // namespace

TEST_CASE("a search whose limits no motor keeps ends, and says so", "[studies][solvers]") {
  // A layer of 1 mm turns the slowest, at 135 rpm; 115 rpm were asked for.
  for (const std::string solver : {"nlopt:auglag", "nlopt:lbfgs", "nlopt:tnewton_precond_restart",
                                   "nlopt:var1", "nlopt:bobyqa", "nlopt:sbplx"}) {
    const test::Search search(
        test::study_of("ring-60", "",
                       "{kind: optimize, variables: {thickness: {min: 0.1 mm, max: 1 mm}}, "
                       "maximize: no_load_speed, "
                       "constraints: [max_pressure <= 2.7 MPa, no_load_speed <= 115 rpm], "
                       "solver: {name: \"" +
                           solver + "\", max_evaluations: 2000, starts: 1}}"));
    CAPTURE(solver);
    CHECK(search.answer.outcome == "infeasible");
    CHECK(search.rows().size() <= 2000);
  }
}

TEST_CASE("a search whose limits leave a narrow corner ends with a design in it",
          "[studies][solvers]") {
  for (const std::string solver : {"nlopt:lbfgs", "nlopt:auglag", "nlopt:var2"}) {
    const test::Search search(test::study_of(
        "ring-60", "",
        "{kind: optimize, variables: {thickness: {min: 0.1 mm, max: 1 mm}, frequency: {min: 25 "
        "kHz, "
        "max: 80 kHz}, kinetic_friction: {min: 0.1, max: 0.4}}, "
        "minimize: wear_intensity_at(60 rpm), constraints: [max_pressure <= 2.5 MPa, "
        "peak_power >= 4.5 W, efficiency_at(0.41 N.m) >= 0.49], "
        "solver: {name: \"" +
            solver + "\", max_evaluations: 2000, starts: 1}}"));
    CAPTURE(solver);
    CHECK(search.optimum().found);
    CHECK(keeps_limits(search.optimum().best));
    CHECK(search.rows().size() <= 2000);
  }
}

TEST_CASE("every rung of the ladder ends on motors where searches went astray",
          "[studies][solvers][.long]") {
  std::set<std::string> climbed;
  for (std::uint64_t number = 0; number < 60; ++number) {
    const Question question = random_question(number);
    const optim::Problem problem = motor_problem(question.problem);
    CAPTURE(number, question.text);
    optim::SolveOptions options;
    options.starts = 1;
    options.budget.evaluations = 2000;
    const optim::Ladder ladder{optim::Ladder{}.rungs, true};
    watch(kEndless);
    const optim::Deadline clock(optim::kInfinity);
    const optim::Result whole = optim::solve_continuous(problem, options, clock, ladder);
    CHECK(whole.counters.evaluations <= options.budget.evaluations);
    for (const optim::StageReport& stage : whole.stages) climbed.insert(stage.solver);

    std::stop_source source;
    std::size_t calls = 0;
    const std::size_t last = 1 + number * 37 % std::max<std::size_t>(whole.counters.evaluations, 1);
    options.stop = source.get_token();
    options.observer = [&](const optim::Observation&) {
      if (++calls == last) source.request_stop();
    };
    optim::solve_continuous(problem, options, clock, ladder);
    CHECK(calls <= last);
    watch(0);
  }
  for (const std::string& rung : optim::Ladder{}.rungs)
    if (optim::find_solver(rung).available) CHECK(climbed.contains(rung));
}
