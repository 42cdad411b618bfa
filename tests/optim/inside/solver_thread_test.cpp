// SPDX-License-Identifier: Apache-2.0
// Code that never comes back is ended, and code that does gives the answers that it gives without a thread of its own.
#include "solvers/solver_thread.hpp"

#include <twum/optim/solve.hpp>

#include <nlopt.h>
#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <thread>

using namespace twum;
using namespace twum::optim;

// A solver that is ended loses its memory, which the leak sanitizer is not to report.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the name is the sanitizer's
extern "C" const char* __lsan_default_suppressions() { return "leak:libnlopt\n"; }

namespace {

constexpr double kNever = 1e9;  // [s]
bool patient() { return false; }

volatile bool going =
    true;  // what is cut off has nothing on the stack: the address sanitizer marks it

void turn() {
  while (going) {
  }
}

// As a C library's, nobody can see that it does not throw.
void (*volatile turn_for_ever)() = turn;

// Every point that NLopt asks for in a bent valley with one limit or none, in a thread of its own or not.
struct Search {
  std::vector<double> asked;
  SolverThread* thread{nullptr};

  template <class F>
  double answer(const double* x, F f) {
    double value = 0.0;
    const auto request = [&] {
      asked.insert(asked.end(), {x[0], x[1]});
      value = f(x[0], x[1]);
    };
    if (thread != nullptr)
      thread->ask(request);
    else
      request();
    return value;
  }
};

double valley(unsigned, const double* x, double*, void* search) {
  return static_cast<Search*>(search)->answer(x, [](double a, double b) {
    return 100.0 * (b - a * a) * (b - a * a) + (1.0 - a) * (1.0 - a);
  });
}

double circle(unsigned, const double* x, double*, void* search) {
  return static_cast<Search*>(search)->answer(
      x, [](double a, double b) { return a * a + b * b - 1.5; });
}

using Opt = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

std::vector<double> points_asked(nlopt_algorithm id, SolverThread* thread) {
  Search search{{}, thread};
  const Opt opt(nlopt_create(id, 2), nlopt_destroy);
  const Opt local(nlopt_create(NLOPT_LN_BOBYQA, 2), nlopt_destroy);  // for MLSL
  nlopt_set_maxeval(local.get(), 30);
  nlopt_set_local_optimizer(opt.get(), local.get());
  nlopt_set_lower_bounds1(opt.get(), -2.0);
  nlopt_set_upper_bounds1(opt.get(), 2.0);
  nlopt_set_min_objective(opt.get(), valley, &search);
  if (id == NLOPT_LN_COBYLA) nlopt_add_inequality_constraint(opt.get(), circle, &search, 1e-9);
  nlopt_set_maxeval(opt.get(), 300);
  std::vector<double> x{-1.2, 1.0};
  double f = 0.0;
  const auto work = [&] {
    nlopt_srand(3);
    nlopt_optimize(opt.get(), x.data(), &f);
  };
  if (thread != nullptr)
    CHECK(thread->run(work));
  else
    work();
  search.asked.insert(search.asked.end(), {x[0], x[1], f});
  return search.asked;
}

// The distance from (1, 1, 1), and 1e-85 / (x1 - 1/4) which is to be at least -2e-86. COBYLA comes to a linear problem
// in it that it never ends.
Problem endless() {
  Problem p;
  for (const char* name : {"x1", "x2", "x3"}) {
    Variable v;
    v.name = name;
    // Sizes of 1, so that COBYLA's box is one unit wide.
    const bool last = std::string(name) == "x3";
    v.lower = last ? -0.25 : 0.0;
    v.upper = last ? 0.75 : 1.0;
    v.start = last ? 0.375 : 0.5;
    p.variables.push_back(v);
  }
  p.objectives = {{"distance", Sense::maximize}};
  p.constraints = {{"pole", -2e-96, kInfinity}};
  p.evaluate = [](std::span<const double> x, bool gradient) {
    const double width[] = {1.5, 1.5, 2.0};
    double square = 0.0;
    for (std::size_t k = 0; k < 3; ++k) square += (width[k] * x[k] - 1.0) * (width[k] * x[k] - 1.0);
    const double distance = std::sqrt(square), d = width[0] * x[0] - 0.25;
    Evaluation e;
    e.values = {distance, 1e-95 / d};
    if (!gradient) return e;
    for (std::size_t k = 0; k < 3; ++k)
      e.jacobian.push_back(width[k] * (width[k] * x[k] - 1.0) / distance);
    e.jacobian.insert(e.jacobian.end(), {-1.5e-95 / d / d, 0.0, 0.0});
    return e;
  };
  return p;
}

SolveOptions by_cobyla() {
  SolveOptions options;
  options.solver = "nlopt:cobyla";
  options.starts = 1;
  options.polish = false;
  return options;
}

void expect_ended(int times) {
  for (int i = 0; i < times; ++i) {
    int asked = 0;
    const auto request = [&] { ++asked; };
    SolverThread thread(0.01, patient);
    CHECK_FALSE(thread.run([&] {
      for (int k = 0; k < i % 5; ++k) thread.ask(request);
      turn_for_ever();
    }));
    CHECK(asked == i % 5);
    CHECK_FALSE(thread.run([&] { ++asked; }));
    CHECK(asked == i % 5);
  }
}

}  // namespace

TEST_CASE("work that never comes back is ended, and there is no more to come", "[optim][threads]") {
  expect_ended(20);
}

TEST_CASE("work that never comes back is ended a thousand times", "[optim][threads][.long]") {
  expect_ended(1000);
}

TEST_CASE("a caller in a hurry does not wait for the longest step", "[optim][threads]") {
  int calls = 0;
  SolverThread thread(kNever, [&] { return ++calls > 3; });
  CHECK_FALSE(thread.run([] { turn_for_ever(); }));
  CHECK(calls > 3);
}

TEST_CASE("requests are done by the caller's thread, in their order", "[optim][threads]") {
  SolverThread thread(kNever, patient);
  for (int run = 0; run < 3; ++run) {
    std::vector<int> order;
    std::thread::id here;
    CHECK(thread.run([&] {
      for (int k = 0; k < 100; ++k)
        thread.ask([&] {
          order.push_back(k);
          here = std::this_thread::get_id();
        });
    }));
    REQUIRE(order.size() == 100);
    for (int k = 0; k < 100; ++k) CHECK(order[static_cast<std::size_t>(k)] == k);
    CHECK(here == std::this_thread::get_id());
  }
}

TEST_CASE("a request takes as long as it wants", "[optim][threads]") {
  // The caller computes for longer than the solver may; a sleep would be no computing.
  SolverThread thread(0.01, patient);
  CHECK(thread.run([&] {
    thread.ask([] {
      const auto begin = std::chrono::steady_clock::now();
      while (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(100)) {
      }
    });
  }));
}

TEST_CASE("what a request throws reaches the caller, and nothing runs after it",
          "[optim][threads]") {
  SolverThread thread(kNever, patient);
  std::atomic<int> done{0};
  const auto request = [] { throw std::runtime_error("no"); };
  CHECK_THROWS_AS(thread.run([&] {
    thread.ask(request);
    ++done;
  }),
                  std::runtime_error);
  CHECK(done == 0);
  CHECK_FALSE(thread.run([&] { ++done; }));
  CHECK(done == 0);
}

TEST_CASE("NLopt asks for the same points to the last bit in a thread of its own",
          "[optim][threads][solvers]") {
  for (const nlopt_algorithm id :
       {NLOPT_LN_COBYLA, NLOPT_LN_BOBYQA, NLOPT_LN_PRAXIS, NLOPT_GN_MLSL, NLOPT_GN_MLSL_LDS}) {
    SolverThread thread(kNever, patient);
    const auto plain = points_asked(id, nullptr);
    CAPTURE(nlopt_algorithm_name(id));
    CHECK(plain.size() > 100);
    CHECK(points_asked(id, &thread) == plain);
    CHECK(points_asked(id, &thread) == plain);  // a second run in the same thread
  }
}

TEST_CASE("COBYLA that never returns stalls, and the best design so far is kept",
          "[optim][threads][solvers][budget]") {
  const Problem p = endless();
  const Result r = solve(p, by_cobyla());
  CHECK(r.stages.front().word == "STALLED");
  CHECK(r.stop == StopReason::finished);
  // From the start, at a distance of sqrt(3) / 4, the search has gone to other designs.
  REQUIRE(r.design.size() == 3);
  CHECK(p.evaluate(r.design, false).values[0] > std::sqrt(3.0) / 4.0);
}

TEST_CASE("a request to stop ends a solver that never returns",
          "[optim][threads][solvers][budget]") {
  std::atomic<std::size_t> calls{0};
  std::stop_source source;
  SolveOptions options = by_cobyla();
  options.stop = source.get_token();
  options.observer = [&](const Observation&) { ++calls; };
  // The request comes once nothing has been asked for a while. Should it come earlier, the answer is the same.
  const std::jthread stopper([&](const std::stop_token& over) {
    std::size_t before = 0;
    for (int still = 0; still < 20 && !over.stop_requested(); ++still) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (calls != before) still = 0;
      before = calls;
    }
    source.request_stop();
  });
  const Result r = solve(endless(), options);
  CHECK(r.stop == StopReason::requested);
  CHECK(r.stages.front().word == "FORCED_STOP");
}
