// SPDX-License-Identifier: Apache-2.0
// Every solver on functions that were made to lead it astray: steps, noise, kinks, flats, slopes that are wrong or
// do not exist, numbers of any size, holes, limits that cannot be met. Whatever is found, each solve must end within
// its budget and a bounded number of requests; a solver that turns without a request is ended by an alarm.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/random.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <unistd.h>
#include <bit>
#include <cmath>
#include <csignal>
#include <cstdlib>

using namespace twum;
using namespace twum::optim;

namespace {

constexpr unsigned kEndless = 60;  // [s] for one solve, which takes some hundredths
constexpr std::size_t kBudget = 400;

double noise(std::span<const double> x, std::uint64_t salt) {
  std::uint64_t h = salt;
  for (const double v : x)
    h = (h ^ std::bit_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15U + (h >> 29U);
  return static_cast<double>(h >> 11U) * 0x1p-53;
}

// One response and its slopes; `kind` says what is wrong with it.
struct Strange {
  std::uint64_t kind{0};
  std::uint64_t salt{0};
  double size{1.0};
  double centre{0.5};

  double value(std::span<const double> x) const {
    double sum = 0.0, product = 1.0;
    for (const double v : x) {
      sum += (v - centre) * (v - centre);
      product *= v;
    }
    switch (kind) {
      case 0: return size * sum;
      case 1: return size;                                 // flat
      case 2: return size * std::floor(5.0 * sum);         // steps
      case 3: return size * std::sqrt(sum);                // a kink at its minimum
      case 4: return size * (sum + 0.1 * noise(x, salt));  // noise
      case 5: return size * noise(x, salt);
      case 6: return -size * sum;                              // largest in a corner
      case 7: return size * std::exp(40.0 * (x[0] - centre));  // of many sizes
      case 8: return size / (x[0] - centre);                   // a pole
      case 9: return size * std::log(std::abs(product) + 1e-300);
      case 10: return size * (x[0] < centre ? sum : 1.0 + sum);  // a jump
      default: return size * std::abs(x[0] - centre) * 1e-18;    // next to nothing
    }
  }
  bool hole(std::span<const double> x) const { return salt % 5 == 0 && noise(x, salt) < 0.1; }
  double slope(std::span<const double> x, std::size_t k) const {
    std::vector<double> y(x.begin(), x.end());
    if (salt % 11 == 0 && noise(x, salt + 1) < 0.05) return std::nan("");
    if (salt % 7 == 0) return size * (noise(x, salt + k) - 0.5);  // anything
    y[k] += 1e-6;
    const double right = value(y);
    y[k] -= 2e-6;
    return (right - value(y)) / 2e-6;
  }
};

Problem strange_problem(Random& random) {
  Problem p;
  const std::size_t n = 1 + random.below(5);
  for (std::size_t k = 0; k < n; ++k) {
    Variable v;
    v.name = test::numbered('x', k);
    v.lower = random.uniform() < 0.3 ? 0.0 : -random.uniform();
    const double width = random.uniform() < 0.15 ? std::pow(10.0, -16.0 * random.uniform()) : 1.5;
    v.upper = v.lower + width;
    if (random.uniform() < 0.5) v.start = v.lower + random.uniform() * width;
    p.variables.push_back(v);
  }
  std::vector<Strange> rows;
  const std::size_t limits = random.below(4);
  for (std::size_t r = 0; r <= limits; ++r) {
    const double size =
        random.uniform() < 0.2 ? std::pow(10.0, 400.0 * random.uniform() - 200.0) : 1.0;
    rows.push_back({random.below(12), random.below(1000), size, 1.4 * random.uniform() - 0.2});
  }
  p.objectives = {{"f", random.uniform() < 0.5 ? Sense::minimize : Sense::maximize}};
  for (std::size_t r = 1; r <= limits; ++r) {
    const double limit = rows[r].size * (1.2 * random.uniform() - 0.4);
    const std::uint64_t side = random.below(3);
    p.constraints.push_back(
        {test::numbered('c', r), side == 0 ? -kInfinity : limit, side == 1 ? kInfinity : limit});
  }
  p.evaluate = [rows, n](std::span<const double> x, bool gradient) {
    Evaluation e;
    for (const Strange& row : rows) {
      if (row.hole(x)) e.failure = "hole";
      e.values.push_back(row.value(x));
      for (std::size_t k = 0; gradient && k < n; ++k) e.jacobian.push_back(row.slope(x, k));
    }
    return e;
  };
  return p;
}

// An abort is reported with the case that it came in.
void watch(unsigned seconds) {
  std::signal(SIGALRM, [](int) { std::abort(); });
  alarm(seconds);
}

void expect_ends(const std::string& solver, std::uint64_t first, std::uint64_t count) {
  for (std::uint64_t number = first; number < first + count; ++number) {
    Random random(7, number, 0);
    const Problem p = strange_problem(random);
    SolveOptions options;
    options.solver = solver;
    options.starts = 2;
    options.seed = 1 + number;
    options.budget.evaluations = 1 + random.below(kBudget);
    std::stop_source source;
    std::size_t calls = 0;
    const std::size_t last = random.uniform() < 0.3 ? 1 + random.below(kBudget) : kBudget + 1;
    options.stop = source.get_token();
    options.observer = [&](const Observation&) {
      if (++calls == last) source.request_stop();
    };
    INFO(solver << " on problem " << number);
    watch(kEndless);
    const Result r = solve(p, options);
    watch(0);
    CHECK(calls <= std::min(last, options.budget.evaluations));
    // At most some twenty stages, 60 runs each, 1000 requests in a row without an evaluation.
    CHECK(r.counters.reused < 20 * 60 * 1000);
  }
}

}  // namespace

TEST_CASE("every solver ends on functions made to lead it astray", "[optim][solvers][budget]") {
  expect_ends("auto", 0, 30);
  for (const SolverInfo& solver : solvers())
    if (solver.available) expect_ends(solver.name, 0, 30);
}

TEST_CASE("every solver ends on thousands of functions made to lead it astray",
          "[optim][solvers][budget][.long]") {
  expect_ends("auto", 0, 3000);
  for (const SolverInfo& solver : solvers())
    if (solver.available) expect_ends(solver.name, 0, 3000);
}
