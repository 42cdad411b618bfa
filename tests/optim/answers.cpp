// SPDX-License-Identifier: Apache-2.0
// Answers of the optimizers on problems from books and made by hand, for scripts/mutate.py: does a change that
// no test noticed alter an answer, or only the way there? Always the same answers of the same optimizers.
//
// A cost is written with itself as the allowed difference: up to twice as many evaluations are the same.
#include "support/answers.hpp"
#include "optim/bank/dual_problem.hpp"
#include "optim/bank/fronts.hpp"
#include "optim/bank/hock_schittkowski.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/latin_hypercube.hpp>
#include <twum/optim/least_squares.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/random.hpp>
#include <twum/optim/scrambled_sobol.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <cmath>
#include <exception>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace twum;
using namespace twum::optim;
using namespace twum::test;
using D = Dual<double, 2>;

// Solvers are asked for a stationarity of 1e-6: to first order, values err by its square at a plain optimum
// and by itself where limits are active; designs and multipliers by it times the problem's curvature.
void put_value(double value) { put_number(value, 1e-6, 1e-6); }
void put_place(double value) { put_number(value, 1e-3, 1e-3); }

void put_cost(const Counters& counters) {
  put(static_cast<double>(counters.evaluations), static_cast<double>(counters.evaluations));
  put(static_cast<double>(counters.failed()), static_cast<double>(counters.evaluations));
}

void put_words(const std::vector<std::string>& words) {
  for (const std::string& word : words)
    for (const char letter : word) put_status(letter);
}

void put_certificate(const Certificate& c) {
  put_status(c.passed);
  put(c.infeasibility, 1e-7);
  put(c.stationarity, c.passed ? 1e-6 : 1e-3);
  put(c.complementarity, 1e-5);
  for (const double weight : c.weights) put_place(weight);
  for (const double price : c.prices) put_place(price);
  for (const Activity& limit : c.limits) {
    put_words({limit.name});
    put_status(limit.side);
    put_status(limit.active);
    put_value(limit.limit);
    for (const double each :
         {limit.value, limit.violation, limit.multiplier, limit.one_percent_buys})
      put_place(each);
  }
  for (const Finding& finding : c.findings) {
    put_status(finding.kind);
    put_words(finding.names);
  }
}

void put_infeasibility(const Infeasibility& why) {
  put_status(why.certified);
  put_words(why.conflict);
  for (const double x : why.design) put_place(x);
  for (const Relaxation& each : why.relaxations) {
    put_words({each.name});
    put_status(each.side);
    put_place(each.amount);
    put_place(each.alone);
  }
}

void put_result(const Result& result) {
  put_status(result.outcome);
  put_status(result.stop);
  put_cost(result.counters);
  if (!result.evaluation.values.empty()) put_value(result.evaluation.values[0]);
  put_certificate(result.certificate);
  put_infeasibility(result.infeasibility);
  put_words({result.solver});
}

// Which of several points of a front is found depends on the way; how much they cover does not.
void put_front(const Front& front, double share) {
  put_status(front.outcome);
  put_status(front.stop);
  put_cost(front.counters);
  put(static_cast<double>(front.points.size()), 2);
  put_number(front.hypervolume, share, 0);
  for (const double each : front.reference) put_number(each, share, share);
  std::size_t certified = 0;
  for (const FrontPoint& point : front.points) certified += point.certificate.passed ? 1U : 0U;
  put(static_cast<double>(certified), 2);
  put_infeasibility(front.infeasibility);
  if (front.points.empty()) return;
  for (const FrontPoint* end : {&front.points.front(), &front.points.back()})
    for (const double value : end->evaluation.values) put_number(value, share, share);
}

// Not the optimizers' own random numbers, which may be what is changed.
class Numbers {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11U) * 0x1.0p-53;
  }

 private:
  std::mt19937_64 bits_;
};

template <typename Ask>
void or_refusal(Ask ask) {
  try {
    ask();
  } catch (const std::exception&) {
    put(std::numeric_limits<double>::infinity(), 0);
  }
}

Problem plane(std::size_t objectives, std::vector<Constraint> constraints,
              const std::function<void(const D*, D*)>& f) {
  Problem p;
  p.variables = box(2, -2.0, 2.0, {1.5, -0.5});
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({numbered('f', k)});
  p.constraints = std::move(constraints);
  p.evaluate = dual_evaluator<2>(p.responses(), f);
  return p;
}

// Optima of every kind that a certificate tells apart.
std::vector<Problem> odd_problems() {
  const auto bowl = [](const D* x, D* r) {
    r[0] = (x[0] - 0.3) * (x[0] - 0.3) + 2.0 * (x[1] - 0.4) * (x[1] - 0.4);
    r[1] = x[0] + x[1];
    r[2] = x[0] * x[0] + x[1] * x[1];
  };
  const auto valley = [](const D* x, D* r) { r[0] = (x[0] + x[1] - 0.5) * (x[0] + x[1] - 0.5); };
  const auto saddle = [](const D* x, D* r) { r[0] = x[0] * x[0] - x[1] * x[1]; };
  const auto hinge = [](const D* x, D* r) {
    const D far = x[0] - 0.2;
    r[0] = (far.v < 0 ? -far : far) + x[1] * x[1];
  };
  std::vector<Problem> all{
      plane(1, {{"sum", 1.0}, {"circle", -kInfinity, 3.0}}, bowl),
      plane(1, {{"sum", 1.0, 1.0}, {"circle", 0.1, 0.5}}, bowl),
      plane(1, {{"sum", 3.0}, {"circle", -kInfinity, 1.0}}, bowl),  // contradictory
      plane(1, {{"sum", 9.0}, {"circle", -kInfinity, 1.0}}, bowl),  // beyond the box too
      plane(1, {}, valley),
      plane(1, {}, saddle),
      plane(1, {}, hinge),
  };
  Problem whole = plane(1, {{"sum", 1.0}, {"circle", -kInfinity, 8.0}}, bowl);
  whole.variables[0].integer = true;
  all.push_back(whole);
  whole.variables[1].integer = true;
  all.push_back(whole);
  Problem logarithmic = plane(1, {{"sum", 1.0}, {"circle", -kInfinity, 3.0}}, bowl);
  for (Variable& v : logarithmic.variables) v.lower = 1e-3, v.scale = Scale::log, v.start = 0.1;
  all.push_back(logarithmic);
  Problem failing = all[0];
  failing.evaluate = [right = failing.evaluate](std::span<const double> x, bool gradient) {
    if (x[0] + 3 * x[1] < -1) throw EvaluationError("no-periodic-state", "there");
    return right(x, gradient);
  };
  all.push_back(failing);
  return all;
}

void put_searches() {
  for (const KnownProblem& known : hock_schittkowski())
    or_refusal([&] { put_result(solve(known.problem)); });
  for (const Problem& p : odd_problems()) or_refusal([&] { put_result(solve(p)); });
  for (const SolverInfo& row : solvers()) {
    if (!row.available) continue;
    SolveOptions options;
    options.solver = row.name;
    options.budget.evaluations = 400;
    for (const auto* name : {"HS1", "HS71", "HS43"})
      or_refusal([&] { put_result(solve(hock_schittkowski(name).problem, options)); });
    for (const std::size_t odd : {0U, 8U, 10U})
      or_refusal([&] { put_result(solve(odd_problems()[odd], options)); });
  }
  for (const std::size_t budget : {1U, 3U, 10U, 30U}) {
    SolveOptions options;
    options.budget.evaluations = budget;
    for (const std::size_t odd : {0U, 2U})
      or_refusal([&] { put_result(solve(odd_problems()[odd], options)); });
  }
}

// With its limits met in the middle of nowhere, at the optimum and beyond: what the certificate says there.
void put_certificates() {
  Numbers random;
  for (const Problem& p : odd_problems())
    for (int i = 0; i < 8; ++i) {
      const std::vector<double> x{random(-1.0, 1.9), random(-1.0, 1.9)};
      or_refusal([&] { put_certificate(certify(p, x)); });
    }
  for (const std::size_t valley : {4U, 5U, 6U})
    for (const std::vector<double>& x :
         {std::vector<double>{0.25, 0.25}, std::vector<double>{0.0, 0.0},
          std::vector<double>{0.2, 0.0}})
      or_refusal([&] { put_certificate(certify(odd_problems()[valley], x)); });
}

void put_fronts() {
  for (const KnownFront& known : known_fronts(10)) {
    if (known.name.starts_with("ZDT") && known.name != "ZDT1") continue;  // many variables
    ParetoOptions options;
    options.points = 20;
    or_refusal([&] { put_front(pareto_front(known.problem, options), 2e-3); });
    if (known.name != "BNH" && known.name != "TNK") continue;
    Nsga2Options evolution;
    evolution.population = 40;
    evolution.generations = 50;
    evolution.reference = known.reference;
    or_refusal([&] { put_front(nsga2(known.problem, evolution), 2e-2); });
  }
  ParetoOptions options;
  options.points = 15;
  options.reference = {1.1, 1.1, 1.1};
  or_refusal([&] { put_front(pareto_front(dtlz2(), options), 5e-3); });
}

void put_fit(const LeastSquaresResult& fit) {
  put_status(fit.outcome);
  put_cost(fit.counters);
  put(static_cast<double>(fit.rank), 0);
  put(static_cast<double>(fit.degrees_of_freedom), 0);
  for (const double each : {fit.sum_of_squares, fit.residual_deviation, fit.student_t})
    put_number(each, 1e-6, 1e-12);
  put(fit.gradient, 1e-6);
  for (const Estimate& e : fit.estimates) {
    put_status(e.at_bound);
    for (const double each : {e.value, e.standard_deviation, e.low, e.high})
      put_number(each, 1e-5, 1e-9);
  }
  for (const auto* matrix : {&fit.correlation, &fit.covariance, &fit.follows})
    for (const double each : *matrix) put_number(each, 1e-4, 1e-9);
  for (const auto& group : fit.undetermined) put_words(group);
}

// y = a exp(-b t) + c + d sin(t) with noise; bounds that hold one parameter, none or two; a pair that only
// counts as a product.
void put_fits() {
  for (const double held : {10.0, 0.4, 0.1})
    for (const bool product : {false, true})
      for (const double jump : {0.0, 3.0}) {
        std::vector<Variable> v{{"a", 0.1, 10.0, 1.0},
                                {"b", 0.01, held, 0.05, Scale::log},
                                {"c", -1.0, 5.0 * held, 0.0},
                                {"d", -2.0, 2.0, 0.5}};
        or_refusal([&] {
          put_fit(least_squares(v, [=](std::span<const double> b) {
            Residuals r;
            if (std::abs(b[3]) > 1.9 && jump > 0) r.failure = "too far";
            Numbers noise;
            for (int i = 0; i < 25; ++i) {
              const double t = 0.3 * i, e = std::exp(-b[1] * t);
              const double d = product ? b[2] * b[3] : b[2] + b[3] * std::sin(t);
              r.values.push_back(b[0] * e + d - 2 * std::exp(-0.5 * t) - 1 - 0.1 * std::sin(t) -
                                 0.05 * noise(-1.0, 1.0) - jump * (i == 7));
              const std::vector<double> row{e, -t * b[0] * e, product ? b[3] : 1.0,
                                            product ? b[2] : std::sin(t)};
              r.jacobian.insert(r.jacobian.end(), row.begin(), row.end());
            }
            return r;
          }));
        });
      }
}

// Any change of a sequence gives other points that are as good; what makes them good are strata and means.
void put_sequences() {
  constexpr std::size_t kCount = 512, kDimension = 5;
  const auto put_means = [](const auto& points, double allowed) {
    for (std::size_t j = 0; j < kDimension; ++j) {
      double mean = 0, square = 0;
      for (const auto& x : points) mean += x[j] / kCount, square += x[j] * x[j] / kCount;
      put(mean, allowed);
      put(square, allowed);
    }
  };
  std::vector<std::vector<double>> points(kCount, std::vector<double>(kDimension));
  const LatinHypercube hypercube(kDimension, kCount, 3);
  for (std::size_t i = 0; i < kCount; ++i) hypercube.point(i, points[i]);
  put_means(points, 1.0 / kCount);
  const ScrambledSobol scrambled(kDimension, 3, 1);
  for (std::size_t i = 0; i < kCount; ++i) scrambled.point(i, points[i]);
  put_means(points, 1.0 / kCount);
  put_means(sobol_points(kDimension, kCount, 3), 4.0 / kCount);
  Random random(11, 1, 1);
  double mean = 0, square = 0;
  for (int i = 0; i < 10000; ++i) {
    const double u = random.uniform();
    mean += u / 1e4, square += u * u / 1e4;
  }
  put(mean, 0.015);  // five deviations
  put(square, 0.015);
}

void put_volumes() {
  Numbers random;
  for (const std::size_t objectives : {2U, 3U})
    for (const std::size_t count : {1U, 5U, 30U}) {
      std::vector<std::vector<double>> points;
      for (std::size_t i = 0; i < count; ++i) {
        points.emplace_back();
        for (std::size_t k = 0; k < objectives; ++k) points.back().push_back(random(0.0, 1.1));
      }
      const std::vector<double> reference(objectives, 1.0);
      put(hypervolume(points, reference), 1e-12);
      std::vector<std::vector<double>> front;
      for (const std::size_t i : nondominated(points)) {
        put_status(i);
        front.push_back(points[i]);
      }
      for (const std::size_t i : greedy_subset(front, 3, reference)) put_status(i);
      if (objectives == 2)
        for (const std::size_t i : best_subset(front, 3, reference)) put_status(i);
    }
}

}  // namespace

int main() {
  put_volumes();
  put_sequences();
  put_fits();
  put_certificates();
  put_searches();
  put_fronts();
  return 0;
}
