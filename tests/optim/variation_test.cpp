// SPDX-License-Identifier: Apache-2.0
// The laws of variation of NSGA-II, read off the designs that an observer sees. Both operators turn
// a uniform number into a child; turned back by the inverse of the published formula, the numbers
// have to be uniform again.
#include <twum/optim/pareto.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

constexpr std::size_t kPopulation = 400;
using Designs = std::vector<std::vector<double>>;

// In [0, 1], so that a design is its place in the box; no design dominates another.
Problem trade(std::size_t variables) {
  Problem p;
  for (std::size_t k = 0; k < variables; ++k) p.variables.push_back({"x" + std::to_string(k)});
  p.objectives = {{"up"}, {"down"}};
  p.evaluate = [](std::span<const double> x, bool) {
    return Evaluation{{x[0], 1.0 - x[0]}, {}, {}, {}};
  };
  return p;
}

struct Family {
  Designs parents, children;
  bool complete{false};  // a child that repeats a design just evaluated is not evaluated again
};

Family family(std::size_t variables, Nsga2Options options, std::uint64_t seed) {
  Family f;
  options.population = kPopulation;
  options.solve.seed = seed;
  options.solve.budget.evaluations = 2 * kPopulation - 2;  // no time goes into sorting them
  options.solve.observer = [&](const Observation& o) {
    Designs& into = f.parents.size() < kPopulation ? f.parents : f.children;
    into.emplace_back(o.design.begin(), o.design.end());
  };
  f.complete = nsga2(trade(variables), options).counters.reused == 0;
  return f;
}

// More than mutation moves a variable where it is all but off, less than between any two designs.
bool same(double a, double b) { return std::abs(a - b) <= 1e-10; }

// The first individual that shares most variables with the child.
const std::vector<double>& parent_of(const std::vector<double>& child, const Designs& parents) {
  std::size_t best = 0, most = 0;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    std::size_t shared = 0;
    for (std::size_t k = 0; k < child.size(); ++k)
      shared += same(parents[i][k], child[k]) ? 1U : 0U;
    if (shared <= most) continue;
    most = shared;
    best = i;
  }
  return parents[best];
}

// Kolmogorov's distance from the uniform distribution, times the root of the number of samples.
double unevenness(std::vector<double> u) {
  std::sort(u.begin(), u.end());
  const double n = static_cast<double>(u.size());
  double most = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i)
    most = std::max(
        {most, (static_cast<double>(i) + 1.0) / n - u[i], u[i] - static_cast<double>(i) / n});
  return most * std::sqrt(n);
}
constexpr double kUneven = 2.2;  // exceeded with probability 2 exp(-2 * 2.2^2) = 1e-4

// How far a share of `of` fair draws is from its probability, in standard deviations.
double deviations(double count, double of, double probability) {
  return std::abs(count - of * probability) / std::sqrt(of * probability * (1.0 - probability));
}
constexpr double kDeviations = 4.0;  // exceeded with probability 6e-5

// The uniform number behind a polynomial mutation from u to v (Deb's bounded form).
double mutation_number(double u, double v, double power) {
  if (v < u) {
    const double edge = std::pow(1.0 - u, power);
    return (std::pow(1.0 + v - u, power) - edge) / (2.0 * (1.0 - edge));
  }
  const double edge = std::pow(u, power);
  return 1.0 - (std::pow(1.0 - v + u, power) - edge) / (2.0 * (1.0 - edge));
}

// The probability of a spread factor below `spread` where a bound leaves `room` (Deb and Agrawal).
double spread_number(double spread, double room, double power) {
  const double whole = 2.0 - std::pow(1.0 + room, -power);
  return (spread <= 1.0 ? std::pow(spread, power) : 2.0 - std::pow(spread, -power)) / whole;
}

struct Crossings {
  double pairs{0}, compared{0}, crossed{0}, first_is_lower{0}, worst{0};
  std::vector<double> numbers;
};

// Two children keep the same multiple of their parents' half difference from the mean, but for what
// the two bounds leave of it: both are images of one uniform number.
void note_crossing(double a, double b, double p, double q, double power, Crossings& c) {
  ++c.compared;
  if (same(a, p) && same(b, q)) return;
  ++c.crossed;
  if (a < b) ++c.first_is_lower;
  const double low = std::min(p, q), high = std::max(p, q), gap = high - low;
  const double below = (low + high - 2.0 * std::min(a, b)) / gap;
  const double above = (2.0 * std::max(a, b) - low - high) / gap;
  const double number = spread_number(below, 2.0 * low / gap, power);
  c.numbers.push_back(number);
  const double other = spread_number(above, 2.0 * (1.0 - high) / gap, power);
  c.worst = std::max(c.worst, std::abs(number - other));
}

void note_pairs(const Family& f, double power, Crossings& c) {
  for (std::size_t i = 0; i + 1 < f.children.size(); i += 2) {
    const auto &a = f.children[i], &b = f.children[i + 1];
    const auto &p = parent_of(a, f.parents), &q = parent_of(b, f.parents);
    if (&p == &q) continue;
    ++c.pairs;
    for (std::size_t k = 0; k < a.size(); ++k)
      if (std::abs(p[k] - q[k]) > 1e-2) note_crossing(a[k], b[k], p[k], q[k], power, c);
  }
}

}  // namespace

TEST_CASE("mutation moves one variable in as many as there are, by the polynomial law",
          "[optim][pareto][statistics]") {
  constexpr std::size_t kVariables = 5;
  const double index = GENERATE(0.0, 2.0, 20.0);
  Nsga2Options options;
  options.crossover = 0.0;
  options.mutation_index = index;
  std::vector<double> numbers, folded;  // folded: as uniform, and both directions err alike
  double compared = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Family f = family(kVariables, options, seed);
    for (const auto& child : f.children) {
      const auto& parent = parent_of(child, f.parents);
      compared += kVariables;
      for (std::size_t k = 0; k < kVariables; ++k)
        if (child[k] != parent[k])
          numbers.push_back(mutation_number(parent[k], child[k], index + 1.0));
    }
  }
  for (const double r : numbers) folded.push_back(2.0 * std::min(r, 1.0 - r));
  CAPTURE(index, numbers.size(), compared);
  CHECK(deviations(static_cast<double>(numbers.size()), compared, 1.0 / kVariables) < kDeviations);
  CHECK(unevenness(numbers) < kUneven);
  CHECK(unevenness(folded) < kUneven);
}

TEST_CASE(
    "crossover spreads two children about their parents by the law of simulated binary "
    "crossover",
    "[optim][pareto][statistics]") {
  const double index = GENERATE(0.0, 2.0, 15.0);
  Nsga2Options options;
  options.crossover = 1.0;
  options.crossover_index = index;
  options.mutation_index = 1e13;  // moves by 1e-13 times a logarithm
  Crossings c;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Family f = family(10, options, seed);
    if (f.complete) note_pairs(f, index + 1.0, c);
  }
  CAPTURE(index, c.pairs);
  REQUIRE(c.pairs > 500);
  CHECK(deviations(c.crossed, c.compared, 0.5) < kDeviations);
  CHECK(deviations(c.first_is_lower, c.crossed, 0.5) < kDeviations);
  CHECK(unevenness(c.numbers) < kUneven);
  // Gaps of 1e-2 turn rounding and what is left of mutation, 1e-12, into 1e-10 of a spread factor,
  // and that into at most 16 times as much of a probability.
  CHECK(c.worst < 1e-8);
}

TEST_CASE("the defaults are those of the book where it has them", "[optim][pareto][published]") {
  // Deb, Pratap, Agarwal, Meyarivan (2002), section IV: crossover 0.9, index of mutation 20.
  CHECK(Nsga2Options{}.crossover == 0.9);
  CHECK(Nsga2Options{}.mutation_index == 20.0);
}
