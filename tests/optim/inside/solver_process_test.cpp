// SPDX-License-Identifier: Apache-2.0
// Code that never comes back is ended, and code that does gives the answers that it gives without a process of its own.
#include "solvers/solver_process.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solver_process.hpp>

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

using namespace twum;
using namespace twum::optim;

namespace {

constexpr double kNever = 1e9;  // [s]
bool patient() { return false; }

// Every point that NLopt asks for in a bent valley, with a circle as its limit.
class Valley : public NloptRequests {
 public:
  double objective(std::span<const double> z, double*) override {
    note(z);
    return 100.0 * (z[1] - z[0] * z[0]) * (z[1] - z[0] * z[0]) + (1.0 - z[0]) * (1.0 - z[0]);
  }
  void limits(Rows, std::span<const double> z, std::span<double> result, double*) override {
    note(z);
    result[0] = z[0] * z[0] + z[1] * z[1] - 1.5;
  }
  bool halted() const override { return asked.size() >= most; }

  std::vector<double> asked;
  std::size_t most{std::size_t(-1)};

 private:
  void note(std::span<const double> z) { asked.insert(asked.end(), z.begin(), z.end()); }
};

NloptJob valley_job(nlopt_algorithm id) {
  NloptJob job;
  job.id = id;
  if (id == NLOPT_GN_MLSL || id == NLOPT_GN_MLSL_LDS) job.subsidiary = NLOPT_LN_BOBYQA;
  if (id == NLOPT_LN_COBYLA) job.inequalities = {1e-9};
  job.lower = {-2.0, -2.0};
  job.upper = {2.0, 2.0};
  job.start = {-1.2, 1.0};
  job.xtol_rel = 1e-11;
  job.ftol_rel = 1e-14;
  job.calls = 300;
  job.inner_calls = 30;
  job.seed = 3;
  return job;
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

// The command that the solvers of this program run in, put back at the end.
class WithCommand {
 public:
  explicit WithCommand(std::vector<std::string> command) : before_(solver_process()) {
    use_solver_process(std::move(command));
  }
  ~WithCommand() { use_solver_process(before_); }
  WithCommand(const WithCommand&) = delete;
  WithCommand& operator=(const WithCommand&) = delete;

 private:
  std::vector<std::string> before_;
};

}  // namespace

TEST_CASE("NLopt asks for the same points to the last bit in a process of its own",
          "[optim][process][solvers]") {
  for (const nlopt_algorithm id :
       {NLOPT_LN_COBYLA, NLOPT_LN_BOBYQA, NLOPT_LN_PRAXIS, NLOPT_GN_MLSL, NLOPT_GN_MLSL_LDS}) {
    CAPTURE(nlopt_algorithm_name(id));
    SolverProcess process(solver_process(), kNever, patient);
    NloptJob job = valley_job(id);
    for (int run = 0; run < 2;
         ++run) {  // the second one goes on with the random numbers of the first
      Valley here, there;
      const NloptEnd end = run_job(job, here);
      const auto other = process.run(job, there);
      REQUIRE(other);
      CHECK(here.asked.size() > 100);
      CHECK(there.asked == here.asked);
      CHECK(other->z == end.z);
      CHECK(other->code == end.code);
      job.seed.reset();
    }
  }
}

TEST_CASE("a search in a process of its own ends where the requests say so",
          "[optim][process][solvers]") {
  SolverProcess process(solver_process(), kNever, patient);
  Valley valley;
  valley.most = 40;
  const auto end = process.run(valley_job(NLOPT_LN_BOBYQA), valley);
  REQUIRE(end);
  CHECK(end->code == NLOPT_FORCED_STOP);
  CHECK(valley.asked.size() == 40);
}

TEST_CASE("wrong arguments of NLopt come back with its words", "[optim][process][solvers]") {
  SolverProcess process(solver_process(), kNever, patient);
  NloptJob job = valley_job(NLOPT_LN_BOBYQA);
  job.start = {-3.0, 0.0};  // outside of the box
  Valley valley;
  const auto end = process.run(job, valley);
  REQUIRE(end);
  CHECK(end->code == NLOPT_INVALID_ARGS);
  CHECK(end->error == run_job(job, valley).error);
}

TEST_CASE("a request takes as long as it wants", "[optim][process]") {
  class Slow : public Valley {
    double objective(std::span<const double> z, double* slopes) override {
      // This thread computes for longer than the solver may; a sleep would be no computing.
      const auto begin = std::chrono::steady_clock::now();
      while (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(100)) {
      }
      return Valley::objective(z, slopes);
    }
  };
  SolverProcess process(solver_process(), 0.05, patient);
  Slow slow;
  NloptJob job = valley_job(NLOPT_LN_BOBYQA);
  job.calls = 6;
  CHECK(process.run(job, slow));
}

TEST_CASE("a process that computes for too long, or for a caller in a hurry, is ended",
          "[optim][process]") {
  const std::vector<std::string> turns_for_ever{"/bin/sh", "-c", "while :; do :; done"};
  Valley valley;
  SECTION("for too long") {
    SolverProcess process(turns_for_ever, 0.05, patient);
    CHECK_FALSE(process.run(valley_job(NLOPT_LN_BOBYQA), valley));
    CHECK_FALSE(process.run(valley_job(NLOPT_LN_BOBYQA), valley));
  }
  SECTION("in a hurry") {
    int calls = 0;
    SolverProcess process(turns_for_ever, kNever, [&] { return ++calls > 3; });
    CHECK_FALSE(process.run(valley_job(NLOPT_LN_BOBYQA), valley));
    CHECK(calls > 3);
  }
  CHECK(valley.asked.empty());
}

TEST_CASE("a process that ends by itself has no answer, and none that cannot start has one",
          "[optim][process]") {
  Valley valley;
  SolverProcess process({"/bin/true"}, kNever, patient);
  CHECK_FALSE(process.run(valley_job(NLOPT_LN_BOBYQA), valley));
  CHECK_THROWS_AS(SolverProcess({"/no/such/program"}, kNever, patient), std::system_error);
}

TEST_CASE("a program that names no process is refused the solvers that may compute for ever",
          "[optim][process][solvers]") {
  const WithCommand none({});
  for (const SolverInfo& solver : solvers()) {
    if (!solver.own_process) continue;
    SolveOptions options = by_cobyla();
    options.solver = solver.name;
    CHECK_THROWS_WITH(solve(endless(), options), Catch::Contains("'" + solver.name + "'") &&
                                                     Catch::Contains("process of its own"));
  }
  SolveOptions options;
  options.solver = "nlopt:sbplx";
  options.budget.evaluations = 50;
  CHECK_NOTHROW(solve(endless(), options));
}

TEST_CASE("COBYLA that never returns stalls, and the best design so far is kept",
          "[optim][process][solvers][budget]") {
  const Problem p = endless();
  const Result r = solve(p, by_cobyla());
  CHECK(r.stages.front().word == "STALLED");
  CHECK(r.stop == StopReason::finished);
  // From the start, at a distance of sqrt(3) / 4, the search has gone to other designs.
  REQUIRE(r.design.size() == 3);
  CHECK(p.evaluate(r.design, false).values[0] > std::sqrt(3.0) / 4.0);
}

TEST_CASE("a request to stop ends a solver that never returns",
          "[optim][process][solvers][budget]") {
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
