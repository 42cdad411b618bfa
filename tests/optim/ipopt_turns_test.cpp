// SPDX-License-Identifier: Apache-2.0
// Solves that share Ipopt: within each other, and one beside the other.
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <condition_variable>
#include <mutex>
#include <thread>

using namespace twum::optim;

namespace {

// (x - centre)^2 on [-2, 2].
Problem bowl(double centre) {
  Problem p;
  p.variables = {{.name = "x", .lower = -2, .upper = 2}};
  p.objectives = {{.name = "f"}};
  p.evaluate = [centre](std::span<const double> x, bool) {
    const double d = x[0] - centre;
    return Evaluation{.values = {d * d}, .jacobian = {2 * d}, .kinks = {}, .failure = {}};
  };
  return p;
}

SolveOptions ipopt() {
  SolveOptions options;
  options.solver = "ipopt";
  return options;
}

// A gate that an evaluator waits at until it is opened.
class Gate {
 public:
  void open() {
    const std::lock_guard guard(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  void wait() {
    std::unique_lock lock(mutex_);
    waiting_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return open_; });
  }
  void wait_until_reached() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_{false};
  bool waiting_{false};
};

}  // namespace

TEST_CASE("an evaluator may itself solve with Ipopt, and changes nothing for the solve around it",
          "[optim][ipopt]") {
  if (!find_solver("ipopt").available) return;
  const Result alone = solve(bowl(0.3), ipopt());
  std::size_t solved = 0;
  Problem outer = bowl(0.3);
  outer.evaluate = [&, inner = outer.evaluate](std::span<const double> x, bool gradient) {
    solved += solve(bowl(0.5), ipopt()).outcome == Outcome::optimal ? 1 : 0;
    return inner(x, gradient);
  };
  const Result around = solve(outer, ipopt());
  CHECK(around.outcome == Outcome::optimal);
  CHECK(around.design == alone.design);  // the same sequence of points, to the bit
  CHECK(solved == around.counters.evaluations);
}

TEST_CASE("a solve with Ipopt is not held up by the evaluator of another one", "[optim][ipopt]") {
  if (!find_solver("ipopt").available) return;
  Gate gate;
  Problem slow = bowl(0.3);
  slow.evaluate = [&gate, inner = slow.evaluate](std::span<const double> x, bool gradient) {
    gate.wait();
    return inner(x, gradient);
  };
  Result first;
  std::thread other([&] { first = solve(slow, ipopt()); });
  gate.wait_until_reached();
  // This returns although the other one is within a solve until the gate opens.
  CHECK(solve(bowl(0.5), ipopt()).outcome == Outcome::optimal);
  gate.open();
  other.join();
  CHECK(first.design == solve(bowl(0.3), ipopt()).design);
}

TEST_CASE("solves with Ipopt on many threads find what each finds alone", "[optim][ipopt]") {
  if (!find_solver("ipopt").available) return;
  constexpr int kSolves = 8;
  std::vector<Result> together(kSolves);
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < kSolves; ++i)
      threads.emplace_back([&together, i] { together[i] = solve(bowl(0.1 * i), ipopt()); });
  }
  for (int i = 0; i < kSolves; ++i)
    CHECK(together[i].design == solve(bowl(0.1 * i), ipopt()).design);
}
