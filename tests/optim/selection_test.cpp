// SPDX-License-Identifier: Apache-2.0
// Selection of NSGA-II by its definitions: ranks, crowding distance, constraint domination, binary
// tournaments. An observer sees every design, so that what survives can be foretold.
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/pareto.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace twum;
using namespace twum::optim;

namespace {

struct Seen {
  double x{0}, violation{0};
  std::vector<double> f;
  std::size_t rank{0};
  double crowding{0};
};

using Functions = std::vector<double (*)(double)>;

// One variable; a constraint g(x) <= 0 comes last if there is one more function than objectives.
Problem of_one(const Functions& functions, std::size_t objectives) {
  Problem p;
  p.variables = {{"x", 0.0, 1.0}};
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({"f" + std::to_string(k)});
  if (functions.size() > objectives) p.constraints = {{"limit", -kInfinity, 0.0}};
  p.evaluate = [functions](std::span<const double> x, bool) {
    Evaluation e;
    for (const auto f : functions) e.values.push_back(f(x[0]));
    return e;
  };
  return p;
}

Observer recorder(std::vector<Seen>& into, std::size_t objectives) {
  return [&into, objectives](const Observation& o) {
    Seen s;
    s.x = o.design[0];
    const auto& v = o.evaluation.values;
    s.f.assign(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(objectives));
    if (v.size() > objectives) s.violation = std::max(0.0, v.back());
    into.push_back(s);
  };
}

bool better(const Seen& a, const Seen& b) {
  if (a.violation != b.violation) return a.violation < b.violation;
  return a.violation == 0.0 && dominates(a.f, b.f);
}

// The longest chain of better designs above it.
void rank(std::vector<Seen>& all) {
  std::sort(all.begin(), all.end(), [](const Seen& a, const Seen& b) {
    return a.violation != b.violation ? a.violation < b.violation : a.f < b.f;
  });
  for (std::size_t j = 0; j < all.size(); ++j) {
    all[j].rank = 0;
    for (std::size_t i = 0; i < j; ++i)
      if (better(all[i], all[j])) all[j].rank = std::max(all[j].rank, all[i].rank + 1);
  }
}

// Sum over the objectives of the distance between the neighbours, relative to that of the ends.
void crowd(std::vector<Seen*> front) {
  for (Seen* s : front) s->crowding = 0.0;
  for (std::size_t k = 0; k < front[0]->f.size(); ++k) {
    std::sort(front.begin(), front.end(), [k](auto* a, auto* b) { return a->f[k] < b->f[k]; });
    const double span = front.back()->f[k] - front.front()->f[k];
    front.front()->crowding = front.back()->crowding = kInfinity;
    for (std::size_t i = 1; i + 1 < front.size(); ++i)
      front[i]->crowding += (front[i + 1]->f[k] - front[i - 1]->f[k]) / span;
  }
}

// Best first: by rank, then the less crowded.
void order(std::vector<Seen>& all) {
  rank(all);
  for (std::size_t r = 0; r < all.size(); ++r) {
    std::vector<Seen*> front;
    for (Seen& s : all)
      if (s.rank == r) front.push_back(&s);
    if (!front.empty()) crowd(front);
  }
  std::sort(all.begin(), all.end(), [](const Seen& a, const Seen& b) {
    return a.rank != b.rank ? a.rank < b.rank : a.crowding > b.crowding;
  });
}

// Children that are all but copies of one parent; every variable is mutated where there is one.
Nsga2Options copying(std::size_t population, std::size_t generations, std::uint64_t seed) {
  Nsga2Options options;
  options.population = population;
  options.generations = generations;
  options.crossover = 0.0;
  options.mutation_index = 1e9;  // moves by 1e-9 times a logarithm
  options.solve.seed = seed;
  return options;
}

const Functions kWavy = {[](double x) { return 100.0 + std::sin(9.0 * x); },
                         [](double x) { return 7.0 * std::cos(16.0 * x) - x; },
                         [](double x) { return 0.4 * std::sin(31.0 * x) - 0.1; }};

}  // namespace

TEST_CASE("of designs that are all as good, those in the least crowded places survive",
          "[optim][pareto][definition]") {
  // Units that differ and an offset: only distances relative to the span count.
  const Functions falling = {[](double x) { return 100.0 + 3.0 * x; },
                             [](double x) { return 50.0 / (1.0 + 9.0 * x); }};
  constexpr std::size_t kPopulation = 8;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::vector<Seen> seen;
    Nsga2Options options;
    options.population = kPopulation;
    options.generations = 1;
    options.solve.seed = seed;
    options.solve.observer = recorder(seen, 2);
    const Front front = nsga2(of_one(falling, 2), options);
    REQUIRE(seen.size() == 2 * kPopulation);
    order(seen);
    seen.resize(kPopulation);
    std::sort(seen.begin(), seen.end(), [](auto& a, auto& b) { return a.x < b.x; });
    REQUIRE(front.points.size() == kPopulation);
    for (std::size_t i = 0; i < kPopulation; ++i) CHECK(front.points[i].design[0] == seen[i].x);
  }
}

TEST_CASE("parents are taken from the best half of parents and children",
          "[optim][pareto][definition]") {
  constexpr std::size_t kPopulation = 20;
  const std::size_t functions = GENERATE(2U, 3U);  // without and with a constraint
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<Seen> seen;
    Nsga2Options options = copying(kPopulation, 2, seed);
    options.solve.observer = recorder(seen, 2);
    nsga2(of_one({kWavy.begin(), kWavy.begin() + static_cast<std::ptrdiff_t>(functions)}, 2),
          options);
    REQUIRE(seen.size() == 3 * kPopulation);
    const std::vector<Seen> last(seen.end() - kPopulation, seen.end());
    seen.resize(2 * kPopulation);
    order(seen);
    const Seen worst = seen[kPopulation - 1];
    std::erase_if(
        seen, [&](const Seen& s) {  // of equals, such as the ends of a front, any may stay
          return s.rank > worst.rank || (s.rank == worst.rank && s.crowding < worst.crowding);
        });
    for (const Seen& child : last)
      // Copies are within 1e-7 of the first ancestor, and no two ancestors of each other.
      CHECK(std::any_of(seen.begin(), seen.end(),
                        [&](const Seen& s) { return std::abs(s.x - child.x) < 1e-7; }));
  }
}

TEST_CASE("a design wins a tournament of two with the odds of its place",
          "[optim][pareto][statistics]") {
  // Drawn with replacement, the better of two is beyond the best part q with probability (1 - q)^2.
  constexpr std::size_t kPopulation = 300;
  const std::size_t functions = GENERATE(2U, 3U);
  double most = 0.0;
  std::vector<double> numbers;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::vector<Seen> seen;
    Nsga2Options options = copying(kPopulation, 1, seed);
    options.solve.observer = recorder(seen, 2);
    nsga2(of_one({kWavy.begin(), kWavy.begin() + static_cast<std::ptrdiff_t>(functions)}, 2),
          options);
    const std::vector<Seen> children(seen.begin() + kPopulation, seen.end());
    seen.resize(kPopulation);
    order(seen);
    for (const Seen& child : children) {
      const auto at = std::find_if(seen.begin(), seen.end(),
                                   [&](const Seen& s) { return std::abs(s.x - child.x) < 1e-7; });
      REQUIRE(at != seen.end());
      const double part = (static_cast<double>(at - seen.begin()) + 0.5) / kPopulation;
      numbers.push_back((1.0 - part) * (1.0 - part));
    }
  }
  std::sort(numbers.begin(), numbers.end());
  const double n = static_cast<double>(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    most = std::max(most, std::abs(numbers[i] - (static_cast<double>(i) + 0.5) / n));
  // Kolmogorov's distance, exceeded with probability 1e-4, and half a step of the places.
  CHECK(most < 2.2 / std::sqrt(n) + 1.0 / kPopulation);
}

TEST_CASE("a limit gives way by the tolerance relative to one and its size, and no more",
          "[optim][pareto][closed_form]") {
  const double limit = GENERATE(0.0, 1000.0, -1000.0);
  constexpr double kTolerance = 0.1;
  Problem p;
  p.variables = {{"x", 0.0, 1.0}};
  p.objectives = {{"up"}, {"down"}};
  p.constraints = {{"limit", -kInfinity, limit}};
  const double slope = limit == 0.0 ? 1.0 : 2000.0;
  p.evaluate = [limit, slope](std::span<const double> x, bool) {
    return Evaluation{{x[0], -x[0], limit + slope * (x[0] - 0.5)}, {}, {}, {}};
  };
  Nsga2Options options;
  options.population = 40;
  options.generations = 60;
  options.solve.feasibility_tolerance = kTolerance;
  const Front front = nsga2(p, options);
  REQUIRE_FALSE(front.points.empty());
  const double last = 0.5 + kTolerance * (1.0 + std::abs(limit)) / slope;
  CHECK(front.points.back().design[0] <= last * (1.0 + 1e-12));  // rounding of the limit's sum
  // The end of a front always stays, and so is nearer than 40 neighbours are to each other, 0.5 / 39.
  CHECK(front.points.back().design[0] > last - 1e-2);
  CHECK(front.points.front().design[0] < 1e-2);
}

TEST_CASE("a population costs its size once and once a generation",
          "[optim][pareto][closed_form]") {
  for (const std::size_t generations : {0U, 1U, 7U}) {
    Nsga2Options options;
    options.population = 12;
    options.generations = generations;
    const Front front = nsga2(of_one(kWavy, 2), options);
    CHECK(front.counters.evaluations + front.counters.reused == 12 * (1 + generations));
    CHECK(front.stop == StopReason::finished);
    CHECK(front.outcome == Outcome::feasible);
    options.solve.budget.evaluations = 10;
    const Front short_of = nsga2(of_one(kWavy, 2), options);
    CHECK(short_of.counters.evaluations == 10);
    CHECK(short_of.stop == StopReason::evaluations);
    CHECK(short_of.outcome == Outcome::budget);
  }
}
