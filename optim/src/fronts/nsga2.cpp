// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/random.hpp>

#include "fronts/front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::optim {
namespace {

struct Individual {
  std::vector<double> unit;
  std::vector<double> design;
  Evaluation evaluation;
  std::vector<double> objectives;  // minimized
  double violation{kInfinity};     // sum of scaled violations; infinite for a failed design
  std::size_t rank{0};
  double crowding{0.0};
};

// Deb's constraint domination: feasible before infeasible, then less violation, then Pareto.
bool precedes(const Individual& a, const Individual& b) {
  if (a.violation > 0.0 || b.violation > 0.0) return a.violation < b.violation;
  return dominates(a.objectives, b.objectives);
}

class Nsga2 {
 public:
  Nsga2(const Problem& problem, const Nsga2Options& options)
      : problem_(problem),
        options_(options),
        deadline_(options.solve.budget.seconds),
        scaling_(problem),
        session_(problem, options.solve, deadline_, options.solve.first_stage,
                 options.solve.budget.evaluations) {}

  Front run() {
    Front front;
    try {
      begin();
      for (std::size_t g = 0; g < options_.generations; ++g) generation(g);
    } catch (const Stop& s) {
      front.stop = s.reason;
    }
    collect(front);
    return front;
  }

 private:
  void begin() {
    for (const auto& u : sobol_points(std::max<std::size_t>(scaling_.size(), 1),
                                      options_.population, options_.solve.seed)) {
      Individual one;
      one.unit.assign(u.begin(), u.begin() + static_cast<std::ptrdiff_t>(scaling_.size()));
      evaluate(one);
      population_.push_back(std::move(one));
    }
    sort_population();
  }

  void evaluate(Individual& one) {
    one.design = scaling_.to_design(one.unit);
    for (std::size_t j = 0; j < one.design.size(); ++j)
      if (const Variable& v = problem_.variables[j]; v.integer)
        one.design[j] =
            std::clamp(std::round(one.design[j]), std::ceil(v.lower), std::floor(v.upper));
    one.objectives.clear();
    one.evaluation = session_.at(one.design, false);
    if (!one.evaluation.ok()) return;
    one.objectives = minimized(problem_, one.evaluation);
    one.violation = violation(one.evaluation);
  }

  // Sum of violations relative to 1 + |limit|; violations below the feasibility tolerance count as 0.
  double violation(const Evaluation& e) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
      const Constraint& c = problem_.constraints[i];
      const double value = e.values[problem_.objectives.size() + i];
      const double excess = std::max({c.lower - value, value - c.upper, 0.0});
      const double limit = value < c.lower ? c.lower : c.upper;
      const double relative = excess / (1.0 + (std::isfinite(limit) ? std::abs(limit) : 0.0));
      if (relative > options_.solve.feasibility_tolerance) sum += relative;
    }
    return sum;
  }

  void generation(std::size_t g) {
    std::vector<Individual> children;
    for (std::size_t pair = 0; pair < options_.population / 2; ++pair) {
      Random random(options_.solve.seed, 1 + g, pair);
      Individual a = tournament(random);
      Individual b = tournament(random);
      cross(a, b, random);
      for (Individual* child : {&a, &b}) {
        mutate(*child, random);
        child->violation = kInfinity;
        evaluate(*child);
        children.push_back(std::move(*child));
      }
    }
    std::move(children.begin(), children.end(), std::back_inserter(population_));
    sort_population();
    population_.resize(options_.population);
  }

  const Individual& tournament(Random& random) const {
    const Individual& a = population_[random.below(population_.size())];
    const Individual& b = population_[random.below(population_.size())];
    if (a.rank != b.rank) return a.rank < b.rank ? a : b;
    return a.crowding >= b.crowding ? a : b;
  }

  // Simulated binary crossover with the bounds of the unit box (Deb and Agrawal 1995).
  void cross(Individual& a, Individual& b, Random& random) const {
    if (random.uniform() > options_.crossover) return;
    for (std::size_t k = 0; k < scaling_.size(); ++k) {
      if (random.uniform() > 0.5) continue;
      const double low = std::min(a.unit[k], b.unit[k]);
      const double high = std::max(a.unit[k], b.unit[k]);
      if (high - low < 1e-14) continue;
      const double u = random.uniform();
      const double first = 0.5 * (low + high - spread(u, 2.0 * low / (high - low)) * (high - low));
      const double second =
          0.5 * (low + high + spread(u, 2.0 * (1.0 - high) / (high - low)) * (high - low));
      const bool swap = random.uniform() < 0.5;
      a.unit[k] = std::clamp(swap ? second : first, 0.0, 1.0);
      b.unit[k] = std::clamp(swap ? first : second, 0.0, 1.0);
    }
  }

  double spread(double u, double room) const {
    const double power = options_.crossover_index + 1.0;
    const double alpha = 2.0 - std::pow(1.0 + room, -power);
    const double base = u <= 1.0 / alpha ? u * alpha : 1.0 / (2.0 - u * alpha);
    return std::pow(base, 1.0 / power);
  }

  // Polynomial mutation within the unit box.
  void mutate(Individual& one, Random& random) const {
    const double power = options_.mutation_index + 1.0;
    for (double& u : one.unit) {
      if (random.uniform() * static_cast<double>(scaling_.size()) > 1.0) continue;
      const double r = random.uniform();
      if (r < 0.5)
        u += std::pow(2.0 * r + (1.0 - 2.0 * r) * std::pow(1.0 - u, power), 1.0 / power) - 1.0;
      else
        u += 1.0 - std::pow(2.0 * (1.0 - r) + 2.0 * (r - 0.5) * std::pow(u, power), 1.0 / power);
      u = std::clamp(u, 0.0, 1.0);
    }
  }

  // Ranks by fronts, crowding within each, then orders the population by both.
  void sort_population() {
    const std::size_t n = population_.size();
    std::vector<std::vector<std::size_t>> worse(n);
    std::vector<std::size_t> betters(n, 0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        if (precedes(population_[i], population_[j]))
          worse[i].push_back(j), ++betters[j];
        else if (precedes(population_[j], population_[i]))
          worse[j].push_back(i), ++betters[i];
      }
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < n; ++i)
      if (betters[i] == 0) front.push_back(i);
    for (std::size_t rank = 0; !front.empty(); ++rank) {
      crowd(front, rank);
      std::vector<std::size_t> next;
      for (const std::size_t i : front)
        for (const std::size_t j : worse[i])
          if (--betters[j] == 0) next.push_back(j);
      front = std::move(next);
    }
    std::stable_sort(population_.begin(), population_.end(), [](const auto& a, const auto& b) {
      return a.rank != b.rank ? a.rank < b.rank : a.crowding > b.crowding;
    });
  }

  void crowd(std::vector<std::size_t>& front, std::size_t rank) {
    for (const std::size_t i : front) {
      population_[i].rank = rank;
      population_[i].crowding = 0.0;
    }
    for (std::size_t k = 0; k < problem_.objectives.size(); ++k) {
      const auto value = [&](std::size_t i) {
        return population_[i].objectives.empty() ? kInfinity : population_[i].objectives[k];
      };
      std::stable_sort(front.begin(), front.end(),
                       [&](auto a, auto b) { return value(a) < value(b); });
      const double span = value(front.back()) - value(front.front());
      population_[front.front()].crowding = kInfinity;
      population_[front.back()].crowding = kInfinity;
      if (!(span > 0.0) || !std::isfinite(span)) continue;
      for (std::size_t i = 1; i + 1 < front.size(); ++i)
        population_[front[i]].crowding += (value(front[i + 1]) - value(front[i - 1])) / span;
    }
  }

  void collect(Front& front) {
    std::vector<std::vector<double>> values;
    std::vector<const Individual*> feasible;
    bool evaluated = false;
    for (const Individual& one : population_) {
      evaluated = evaluated || one.evaluation.ok();
      if (one.violation > 0.0) continue;
      values.push_back(one.objectives);
      feasible.push_back(&one);
    }
    for (const std::size_t i : nondominated(values))
      front.points.push_back({feasible[i]->design, feasible[i]->evaluation, {}});
    std::sort(front.points.begin(), front.points.end(), [&](const auto& a, const auto& b) {
      return minimized(problem_, a.evaluation) < minimized(problem_, b.evaluation);
    });
    measure(front, problem_, options_.reference);
    front.counters = session_.counters();
    front.seconds = deadline_.elapsed();
    front.stages_used = 1;
    front.outcome = front.stop != StopReason::finished ? Outcome::budget
                    : !front.points.empty()            ? Outcome::feasible
                    : evaluated                        ? Outcome::infeasible
                                                       : Outcome::failed;
  }

  const Problem& problem_;
  const Nsga2Options& options_;
  Deadline deadline_;
  Scaling scaling_;
  Session session_;
  std::vector<Individual> population_;
};

}  // namespace

Front nsga2(const Problem& problem, const Nsga2Options& options) {
  validate_front(problem, options.reference);
  if (options.population < 4 || options.population % 2 != 0)
    throw InputError("nsga2: the population must be even and at least 4");
  return Nsga2(problem, options).run();
}

}  // namespace twum::inline v0_1::optim
