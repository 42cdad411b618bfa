// SPDX-License-Identifier: Apache-2.0
// What a solve says of its own work: calls, derivatives, failures, stages and threads, as an observer or
// the evaluator counts them.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;

// Quartic enough that no search is done after one step.
Problem bowl(std::size_t objectives = 1) {
  Problem p;
  p.variables = test::box(2, -2.0, 2.0, {1.0, -1.0});
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({test::numbered('f', k)});
  p.evaluate = test::dual_evaluator<2>(objectives, [objectives](const D* x, D* r) {
    for (std::size_t k = 0; k < objectives; ++k) {
      const D a = x[0] - 0.3 - static_cast<double>(k), b = x[1] - 0.4;
      r[k] = a * a + 2.0 * b * b + 0.1 * a * a * a * a;
    }
  });
  return p;
}

// Calls and derivatives that an observer sees.
struct Seen {
  std::size_t calls{0};
  std::size_t gradients{0};

  Observer observer() {
    return [this](const Observation& o) {
      ++calls;
      if (o.gradient) ++gradients;
    };
  }
};

std::set<std::thread::id> threads_of(const SolveOptions& options) {
  std::set<std::thread::id> ids;
  std::mutex lock;
  Problem p = bowl();
  p.evaluate = [&, right = p.evaluate](std::span<const double> x, bool gradient) {
    {
      const std::lock_guard<std::mutex> guard(lock);
      ids.insert(std::this_thread::get_id());
    }
    // Long enough that one thread too many, if there is one, would find starts that are not taken yet.
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return right(x, gradient);
  };
  CHECK(solve(p, options).outcome == Outcome::optimal);
  return ids;
}

}  // namespace

TEST_CASE("calls and derivatives are counted as an observer counts them", "[optim][definition]") {
  for (const std::string solver : {"auto", "nlopt:slsqp", "nlopt:cobyla"}) {
    Seen seen;
    SolveOptions options;
    options.solver = solver;
    options.observer = seen.observer();
    const Result r = solve(bowl(), options);
    CAPTURE(solver);
    CHECK(r.counters.evaluations == seen.calls);
    CHECK(r.counters.gradients == seen.gradients);
    CHECK(seen.gradients > 0);
    // A search that compares values asks for derivatives where it begins and where it ends alone.
    CHECK((2 * seen.gradients < seen.calls) == (solver == "nlopt:cobyla"));
  }
  Seen seen;
  ParetoOptions options;
  options.points = 5;
  options.solve.observer = seen.observer();
  const Front front = pareto_front(bowl(2), options);
  CHECK(front.counters.evaluations == seen.calls);
  CHECK(front.counters.gradients == seen.gradients);
  CHECK(seen.gradients > 0);
}

TEST_CASE("a failure that happens once is reported, and none that never happened",
          "[optim][failure][definition]") {
  for (const std::size_t fatal : {1U, 3U, 6U}) {
    std::size_t calls = 0;
    Problem p = bowl();
    p.evaluate = [&, right = p.evaluate](std::span<const double> x, bool gradient) {
      return ++calls == fatal ? Evaluation{{}, {}, {}, "once"} : right(x, gradient);
    };
    const Result r = solve(p);
    CAPTURE(fatal);
    CHECK(r.outcome == Outcome::optimal);
    CHECK(r.counters.failures == std::map<std::string, std::size_t>{{"once", 1}});
    CHECK(r.counters.failed() == 1);
  }
  CHECK(solve(bowl()).counters.failures.empty());
}

TEST_CASE("a solve uses as many stages wherever they begin, and no more than it shows",
          "[optim][definition]") {
  for (const std::string solver : {"auto", "nlopt:slsqp"}) {
    SolveOptions options;
    options.solver = solver;
    const Result from_zero = solve(bowl(), options);
    options.first_stage = 7;
    const Result later = solve(bowl(), options);
    CAPTURE(solver);
    CHECK(later.stages_used == from_zero.stages_used);
    // One before the solver runs, where the scale factors are found, one for each of them, and one in which auto looks
    // at the other starts.
    CHECK(from_zero.stages_used == from_zero.stages.size() + (solver == "auto" ? 2 : 1));
  }
}

TEST_CASE("the evaluator is called by no more threads than were asked for, the caller's among them",
          "[optim][threads]") {
  CHECK(threads_of({}) == std::set<std::thread::id>{std::this_thread::get_id()});
  SolveOptions options;
  options.jobs = 2;
  const auto two = threads_of(options);
  CHECK(two.size() <= 2);
  CHECK(two.contains(std::this_thread::get_id()));
}

TEST_CASE("seconds end a solve once they have passed, and not before", "[optim][budget]") {
  SolveOptions options;
  options.budget.seconds = 1e6;  // days
  CHECK(solve(bowl(), options).outcome == Outcome::optimal);
  // The first call takes longer than there is time, however fast or slow the machine is.
  options.budget.seconds = 0.02;
  Problem p = bowl();
  p.evaluate = [right = p.evaluate](std::span<const double> x, bool gradient) {
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
    return right(x, gradient);
  };
  for (const std::string solver : {"auto", "nlopt:isres"}) {
    options.solver = solver;
    const Result r = solve(p, options);
    CAPTURE(solver);
    CHECK(r.outcome == Outcome::budget);
    CHECK(r.stop == StopReason::seconds);
    CHECK(r.counters.evaluations <= 1);
  }
}
