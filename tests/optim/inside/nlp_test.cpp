// SPDX-License-Identifier: Apache-2.0
// Parts that solvers share: the archive of what they see, the box they search, names and random
// numbers.
#include "problem/nlp.hpp"
#include "solvers/optimizer.hpp"

#include "optim/bank/dual_problem.hpp"

#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 3>;

// x1 + 2 x2 + 4 x3 over the unit box, which cannot be evaluated where x1 > 0.9.
Problem slanted() {
  Problem p;
  p.variables = test::box(3, 0.0, 1.0, {0.5, 0.5, 0.5});
  p.objectives = {{"f"}};
  p.evaluate = [right = test::dual_evaluator<3>(1, [](const D* x, D* r) {
                  r[0] = x[0] + 2.0 * x[1] + 4.0 * x[2];
                })](std::span<const double> x, bool gradient) {
    if (x[0] > 0.9) return Evaluation{{}, {}, {}, "torn"};
    return right(x, gradient);
  };
  return p;
}

// What an Nlp needs, without scale factors: they stay 1.
struct Bench {
  Problem problem = slanted();
  SolveOptions options;
  Deadline deadline{kInfinity};
  Session session{problem, options, deadline, 0, 1000};
  Scaling scaling{problem};

  // Minimize f + extras 10 s + 100 t, with f - s <= 0 and f + t >= 9.
  Formulation with_slacks() const {
    Formulation f = plain_formulation(problem, scaling);
    f.objective.extras = {{0, 10.0}, {1, 100.0}};
    f.rows = {{{{0, 1.0}}, {{0, -1.0}}, -kInfinity, 0.0}, {{{0, 1.0}}, {{1, 1.0}}, 9.0, kInfinity}};
    f.extra_lower = {0.0, 0.0};
    f.extra_upper = {50.0, 50.0};
    return f;
  }
};

// Philox 2x64 with ten rounds, from the paper: M = D2B74407B1CE6E93, W = 9E3779B97F4A7C15.
std::uint64_t philox(std::uint64_t low, std::uint64_t high, std::uint64_t key) {
  __extension__ using Wide = unsigned __int128;
  for (int round = 0; round < 10; ++round) {
    const Wide product = Wide{0xD2B74407B1CE6E93ULL} * low;
    low = static_cast<std::uint64_t>(product >> 64U) ^ key ^ high;
    high = static_cast<std::uint64_t>(product);
    key += 0x9E3779B97F4A7C15ULL;
  }
  return low;
}

}  // namespace

TEST_CASE("a point with extra unknowns has the value and the gradient of its formula",
          "[optim][nlp][closed_form]") {
  Bench bench;
  Nlp nlp(bench.session, bench.scaling, bench.with_slacks());
  REQUIRE(nlp.size() == 5);
  // Every number is a multiple of 1/8: sums are exact.
  const std::vector<double> z{0.25, 0.5, 0.125, 3.0, 7.0};
  const NlpValue* v = nlp.at(z, true);
  REQUIRE(v != nullptr);
  CHECK(v->f == 1.75 + 30.0 + 700.0);
  CHECK(v->c == std::vector<double>{1.75 - 3.0, 1.75 + 7.0});
  CHECK(v->df == std::vector<double>{1, 2, 4, 10, 100});
  CHECK(v->dc == std::vector<double>{1, 2, 4, -1, 0, 1, 2, 4, 0, 1});
  CHECK(nlp.excess(*v) == 0.25);  // of f + t >= 9
}

TEST_CASE("a box around a point reaches its radius to each side and no bound beyond",
          "[optim][nlp][definition]") {
  Bench bench;
  Nlp nlp(bench.session, bench.scaling, bench.with_slacks());
  const std::vector<double> all_lower = nlp.lower(), all_upper = nlp.upper();
  const std::vector<double> centre{0.5, 0.125, 0.75, 1.0, 1.0};
  nlp.restrict_box(centre, 0.25);
  CHECK(nlp.lower() == std::vector<double>{0.25, 0.0, 0.5, 0.0, 0.0});
  CHECK(nlp.upper() == std::vector<double>{0.75, 0.375, 1.0, 50.0, 50.0});
  nlp.restrict_box(centre, 0.0);
  CHECK(nlp.lower() == all_lower);
  CHECK(nlp.upper() == all_upper);
}

TEST_CASE("a design without an answer has none however often it is asked for",
          "[optim][nlp][failure]") {
  Bench bench;
  Nlp nlp(bench.session, bench.scaling, plain_formulation(bench.problem, bench.scaling));
  const std::vector<double> good{0.5, 0.5, 0.5}, torn{1.0, 0.5, 0.5};
  REQUIRE(nlp.at(good, true) != nullptr);
  CHECK(nlp.at(torn, true) == nullptr);
  CHECK(nlp.at(torn, true) == nullptr);
  CHECK(nlp.at(torn, false) == nullptr);
  REQUIRE(nlp.best());
  CHECK(nlp.best()->z == good);
  CHECK(nlp.at(good, true)->f == 3.5);
  CHECK(bench.session.counters().failures.at("torn") == 1);
}

TEST_CASE("a solver asks for no more points than it may, and says that it would have",
          "[optim][nlp][budget]") {
  for (const std::string name : {"nlopt:cobyla", "nlopt:praxis", "nlopt:crs2_lm", "nlopt:isres"}) {
    Bench bench;
    Nlp nlp(bench.session, bench.scaling, plain_formulation(bench.problem, bench.scaling));
    RunSettings settings;
    settings.max_calls = 7;  // a plane of three variables takes more
    const Optimizer& optimizer = find_optimizer(name);
    const std::vector<double> start{0.5, 0.5, 0.5};
    const RunReport report = optimizer.run(optimizer.info, nlp, start, settings);
    CAPTURE(name);
    CHECK(bench.session.counters().evaluations <= 7);
    CHECK(report.word == "MAXEVAL_REACHED");  // NLopt's word for it
  }
}

TEST_CASE("feasible candidates come before others, then the smaller objective or violation",
          "[optim][nlp][definition]") {
  const Candidate low{{}, 1.0, 0.0, 0.0, {}}, high{{}, 2.0, 1e-9, 1.0, {}};
  const Candidate near{{}, 0.0, 0.2, 0.1, {}}, far{{}, -1.0, 0.1, 0.2, {}};
  const Candidate ranked[] = {low, high, near, far};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) CHECK(better(ranked[i], ranked[j], 1e-8) == (i < j));
}

TEST_CASE("a name without its prefix is nearer than a name that differs by a letter",
          "[optim][definition]") {
  CHECK(nearest_name("mma", {"mmb", "nlopt:mma", "mmc"}) == "nlopt:mma");
  CHECK(nearest_name("mmb", {"mmb", "nlopt:mmb"}) == "mmb");
  CHECK(nearest_name("mma", {"mmb", "mmc"}) == "mmb");
}

TEST_CASE("random numbers are those of Philox 2x64", "[optim][random][published]") {
  // The three known answers that Random123 comes with.
  REQUIRE(philox(0, 0, 0) == 0xca00a0459843d731ULL);
  REQUIRE(philox(~0ULL, ~0ULL, ~0ULL) == 0x65b021d60cd8310fULL);
  REQUIRE(philox(0x243f6a8885a308d3ULL, 0x13198a2e03707344ULL, 0xa4093822299f31d0ULL) ==
          0x0a5e742c2997341cULL);
  // The counter's words are the number within a stream and, in stage 0, the index of the stream.
  for (const std::uint64_t index : {0ULL, 1ULL, 7ULL, 1ULL << 40U}) {
    for (const std::uint64_t seed : {0ULL, 1ULL, 0xa4093822299f31d0ULL}) {
      Random random(seed, 0, index);
      for (std::uint64_t k = 0; k < 4; ++k) CHECK(random.bits() == philox(k, index, seed));
    }
  }
}

TEST_CASE("an infinite point has no value however often it is asked for", "[optim][nlp]") {
  Problem p;
  p.variables = test::box(1, 0.0, 1.0, {0.5});
  p.objectives = {{"f"}};
  p.evaluate = [](std::span<const double> x, bool) { return Evaluation{{x[0]}, {1.0}, {}, {}}; };
  const SolveOptions options;
  const Deadline deadline(kInfinity);
  Session session(p, options, deadline, 0, 100);
  const Scaling scaling(p);
  Nlp nlp(session, scaling, plain_formulation(p, scaling));
  const std::vector<double> good{0.5}, lost{kInfinity};
  REQUIRE(nlp.at(good, true) != nullptr);
  CHECK(nlp.at(lost, true) == nullptr);
  CHECK(nlp.at(lost, true) == nullptr);
}
