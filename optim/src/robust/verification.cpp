// SPDX-License-Identifier: Apache-2.0
#include "robust/verification.hpp"

#include "robust/statistic_verdict.hpp"

#include <twum/base/no_value.hpp>
#include <twum/optim/distributions.hpp>
#include <twum/optim/random.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <twum/base/error.hpp>
#include <twum/base/ordered.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr std::uint64_t kFreshStream =
    0x7E51F1ED00ULL;  // apart from the other random numbers of a seed
std::vector<double> fresh_normals(std::uint64_t seed, std::uint64_t run, std::uint64_t index,
                                  std::size_t count) {
  Random random(seed, kFreshStream + run, index);
  std::vector<double> z;
  for (std::size_t k = 0; k < count; ++k)
    z.push_back(normal_quantile(std::max(random.uniform(), 0x1.0p-54)));
  return z;
}

Evaluation fresh_product(const RobustProblem& problem, std::span<const double> x,
                         std::span<const double> z) {
  try {
    return problem.built(build(problem, x, z), {}, false);
  } catch (const EvaluationError& error) {
    Evaluation lost;
    lost.failure = error.reason();
    return lost;
  }
}

// Parts of a sample after whose first one, and after every doubling of it, the rest may be left out.
constexpr std::uint64_t kParts = 32;

// U6.6: d/ds of a normal density is (z^2 - 1) / s of it, so that 1 % less of every spread changes the share of the good ones
// by the mean of (z_k^2 - 1) / 100 over the failing products; with correlated inputs the part of U1.10 stands for the square. No
// derivative of a response is needed.
class TighterYields {
 public:
  explicit TighterYields(const RobustProblem& problem)
      : problem_(problem), sums_(problem.inputs.size()), squares_(problem.inputs.size()) {}

  void see_failing(std::span<const double> z) {
    const std::vector<double> squares = problem_.correlation.parts(input_numbers(problem_, z));
    for (std::size_t k = 0; k < squares.size(); ++k) {
      const double score = 0.01 * (squares[k] - 1.0);
      sums_[k] += score;
      squares_[k] += score * score;
    }
  }

  std::vector<SampledMean> of(std::uint64_t products) const {
    const auto n = static_cast<double>(products);
    std::vector<SampledMean> list;
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      const double mean = sums_[k] / n;
      list.push_back({mean, std::sqrt((squares_[k] / n - mean * mean) / n)});
      if (problem_.inputs[k].law != Law::normal) list.back() = {kNoValue, kNoValue};
    }
    return list;
  }

 private:
  const RobustProblem& problem_;
  std::vector<double> sums_, squares_;
};

// Counts products in the order in which they are made.
class CountedProducts {
 public:
  CountedProducts(const RobustProblem& problem, const RobustTerms& terms, std::span<const double> x,
                  const SamplePlan& plan, std::uint64_t run)
      : problem_(problem),
        terms_(terms),
        x_(x),
        plan_(plan),
        run_(run),
        good_(terms.of_target.size(), 0),
        failed_(terms.terms.size(), 0),
        tighter_(problem) {
    found_.values.resize(problem.limits.size());
  }

  void make_until(std::uint64_t end) {
    run_indexed(
        {made_, end, plan_.jobs, plan_.proceed},
        [this](std::uint64_t index) { return fresh_product(problem_, x_, normals(index)); },
        [this](std::uint64_t, std::vector<Evaluation>& answers) {
          for (const Evaluation& answer : answers) count(answer);
          if (plan_.sampled) plan_.sampled(made_, plan_.products);
        });
  }

  std::uint64_t made() const { return made_; }

  std::vector<YieldEstimate> yields() const {
    std::vector<YieldEstimate> list;
    for (const std::uint64_t kept : good_)
      list.push_back(made_ > 0 ? yield_estimate(kept, made_) : YieldEstimate{});
    return list;
  }

  Verification verification() && {
    found_.yields = yields();
    for (const std::uint64_t failed : failed_)
      found_.term_shares.push_back(static_cast<double>(failed) /
                                   static_cast<double>(std::max<std::uint64_t>(made_, 1)));
    if (made_ > 0 && !good_.empty()) found_.tighter = tighter_.of(made_);
    for (const StatisticTarget& target : problem_.statistics)
      found_.statistics.push_back(statistic_estimate(target, found_.values[target.response]));
    return std::move(found_);
  }

 private:
  std::vector<double> normals(std::uint64_t index) const {
    return fresh_normals(plan_.seed, run_, index, drawn_numbers(problem_));
  }

  void count(const Evaluation& answer) {
    const std::uint64_t index = made_++;
    if (!answer.ok()) ++found_.lost[answer.failure];
    for (std::size_t r = 0; r < found_.values.size(); ++r)
      found_.values[r].push_back(answer.ok() ? answer.values[r] : kNoValue);
    std::vector<bool> keeps(good_.size(), true);
    for (std::size_t j = 0; j < terms_.terms.size(); ++j) {
      const RobustTerm& term = terms_.terms[j];
      if (!term.target) continue;
      const bool holds =
          answer.ok() &&
          term.margin.sign * (answer.values[term.margin.response] - term.margin.end) >= 0.0;
      if (holds) continue;
      ++failed_[j];
      keeps[*term.target] = false;
    }
    for (std::size_t s = 0; s < good_.size(); ++s) good_[s] += keeps[s] ? 1 : 0;
    if (!keeps.empty() && !keeps.front()) tighter_.see_failing(normals(index));
  }

  const RobustProblem& problem_;
  const RobustTerms& terms_;
  std::span<const double> x_;
  const SamplePlan& plan_;
  std::uint64_t run_;
  std::uint64_t made_{0};
  std::vector<std::uint64_t> good_, failed_;
  TighterYields tighter_;
  Verification found_;
};

}  // namespace

Verification verify_products(const RobustProblem& problem, const RobustTerms& terms,
                             std::span<const double> x, const SamplePlan& plan, std::uint64_t run,
                             const EnoughProducts& enough) {
  CountedProducts counted(problem, terms, x, plan, run);
  // Statistics of the responses need all products.
  for (std::uint64_t part = problem.statistics.empty() && enough ? kParts : 1; part >= 1;
       part /= 2) {
    const std::uint64_t end = plan.products / part;
    counted.make_until(end);
    if (counted.made() < end || (part > 1 && enough(counted.yields()))) break;
  }
  return std::move(counted).verification();
}

bool wants_rare(const RobustProblem& problem) {
  return std::any_of(problem.yields.begin(), problem.yields.end(), [](const YieldTarget& target) {
    return target.at_least < 1.0 && 1.0 - target.at_least < kRareRisk;
  });
}

// U5.5
Verification weighted(Verification seen, const RobustTerms& terms,
                      const std::function<ImportanceSample(std::uint64_t)>& sample) {
  constexpr double kStudent95 = 2.13145;  // 97.5 % quantile for 15 degrees of freedom
  constexpr auto n = static_cast<double>(kScrambles);
  std::vector<std::vector<double>> risks(terms.of_target.size());
  std::uint64_t products = 0;
  std::fill(seen.term_shares.begin(), seen.term_shares.end(), 0.0);
  for (std::uint64_t scramble = 0; scramble < kScrambles; ++scramble) {
    const ImportanceSample drawn = sample(scramble);
    products += drawn.weights.size();
    for (std::size_t s = 0; s < risks.size(); ++s) {
      const SampledRisk risk = sampled_risk(drawn, terms.of_target[s]);
      risks[s].push_back(risk.any);
      for (std::size_t i = 0; i < risk.of_term.size(); ++i)
        seen.term_shares[terms.of_target[s][i]] += risk.of_term[i] / n;
    }
  }
  for (std::size_t s = 0; s < risks.size(); ++s) {
    const double mean = std::accumulate(risks[s].begin(), risks[s].end(), 0.0) / n;
    double squares = 0.0;
    for (const double risk : risks[s]) squares += (risk - mean) * (risk - mean);
    const double room = kStudent95 * std::sqrt(squares / (n - 1.0) / n);
    YieldEstimate& yield = seen.yields[s];
    yield.products = products;
    yield.value = 1.0 - mean;
    yield.low = yield.value - room;
    yield.high = std::min(1.0, yield.value + room);
    yield.good = products - static_cast<std::uint64_t>(mean * static_cast<double>(products));
  }
  seen.weighted = true;
  seen.tighter.clear();
  return seen;
}

}  // namespace twum::inline v0_1::optim
