// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/random.hpp>

#include "certificate/polish.hpp"
#include "fronts/front_search.hpp"
#include "problem/tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {

namespace {

// of an objective that is held at its best: far below the resolution of a front and far above the solver's tolerance
constexpr double kMargin = 1e-8;

}  // namespace

double FrontSearch::sign(std::size_t k) const {
  return runner_.problem().objectives[k].sense == Sense::maximize ? -1.0 : 1.0;
}

// A certificate with Newton steps takes some four evaluations a variable. Once the ends are known, they are kept for the
// points, up to a quarter of the budget.
std::size_t FrontSearch::left() const {
  if (span_.empty()) return runner_.left();
  const std::size_t of_one = 4 * runner_.scaling().size() + 8;
  const std::size_t reserve =
      std::min(of_one * options_.points, runner_.options().budget.evaluations / 4);
  return runner_.left() - std::min(runner_.left(), reserve);
}

std::optional<Solved> FrontSearch::solved(SolverRun& run) {
  if (!run.best || run.best->violation > runner_.options().feasibility_tolerance)
    return std::nullopt;
  Solved s;
  s.unit.assign(run.best->z.begin(),
                run.best->z.begin() + static_cast<std::ptrdiff_t>(runner_.scaling().size()));
  if (!fill(run, s)) return std::nullopt;
  snap_to_bounds(run, s);
  runner_.book(run);
  return s;
}

// Evaluates s.unit, which is usually in the cache.
bool FrontSearch::fill(SolverRun& run, Solved& s) {
  s.design = runner_.scaling().to_design(s.unit);
  try {
    if (run.session->left() == 0) runner_.allow(run, 1);
    s.evaluation = run.session->at(s.design, true);
  } catch (const Stop&) {
    return false;
  }
  if (!s.evaluation.ok()) return false;
  s.scaled.clear();
  for (std::size_t k = 0; k < runner_.problem().objectives.size(); ++k)
    s.scaled.push_back(sign(k) * runner_.scaling().factor(k) * s.evaluation.values[k]);
  normalize(s);
  return true;
}

// Puts a variable that stopped just short of its bound onto the bound if no response becomes worse. If an objective
// is steep at the bound, the last 1e-9 of the box can matter.
void FrontSearch::snap_to_bounds(SolverRun& run, Solved& s) {
  constexpr double kNear = 1e-7;
  Solved snapped = s;
  for (double& u : snapped.unit) u = u < kNear ? 0.0 : u > 1.0 - kNear ? 1.0 : u;
  if (snapped.unit == s.unit || !fill(run, snapped) || !dominates(snapped.y, s.y)) return;
  const double tolerance = runner_.options().feasibility_tolerance;
  if (relative_violation(runner_.problem(), snapped.evaluation, snapped.design, tolerance) <=
      tolerance)
    s = std::move(snapped);
}

void FrontSearch::normalize(Solved& s) const {
  s.y = s.scaled;
  for (std::size_t k = 0; k < ideal_.size(); ++k) s.y[k] = (s.scaled[k] - ideal_[k]) / span_[k];
}

std::optional<Solved> FrontSearch::best_of(const Formulation& formulation,
                                           const std::vector<std::vector<double>>& starts,
                                           std::vector<double> extra_start, bool all) {
  const Optimizer& slsqp = find_optimizer("nlopt:slsqp");
  std::optional<Solved> best;
  double least = kInfinity;
  for (const auto& start : starts) {
    if (exhausted()) break;
    std::vector<double> z = start;
    z.insert(z.end(), extra_start.begin(), extra_start.end());
    SolverRun run = runner_.run(slsqp, formulation, z, left());
    auto s = solved(run);
    if (!s || !(run.best->f < least)) continue;
    least = run.best->f;
    best = std::move(s);
    if (!all) break;
  }
  return best;
}

// Minimizes the other objectives with the first one held at its best, up to a margin.
Formulation FrontSearch::lexicographic(std::size_t objective, const Solved& first) const {
  Formulation f = plain_formulation(runner_.problem(), runner_.scaling(), objective);
  f.objective.responses.clear();
  for (std::size_t k = 0; k < runner_.problem().objectives.size(); ++k)
    if (k != objective) f.objective.responses.push_back({k, sign(k)});
  const double best = first.scaled[objective];
  f.rows.push_back(
      {{{objective, sign(objective)}}, {}, -kInfinity, best + kMargin * (1.0 + std::abs(best))});
  return f;
}

// The minimum of one objective. If the starts end in different optima, there are usually more, and the search
// continues from the best one.
std::optional<Solved> FrontSearch::best_alone(std::size_t objective,
                                              const std::vector<std::vector<double>>& starts) {
  constexpr double kSamePlace = 1e-6;  // relative to the gain of the start's gradient over the box
  const Formulation f = plain_formulation(runner_.problem(), runner_.scaling(), objective);
  std::vector<Solved> found;
  for (const auto& start : starts)
    if (auto one = best_of(f, {start}, {}, true)) found.push_back(std::move(*one));
  if (found.empty()) return std::nullopt;
  const auto less = [&](const Solved& a, const Solved& b) {
    return a.scaled[objective] < b.scaled[objective];
  };
  const auto [least, most] = std::minmax_element(found.begin(), found.end(), less);
  const double apart = most->scaled[objective] - least->scaled[objective];
  if (apart <= kSamePlace || runner_.scaling().size() == 0) return std::move(*least);
  return improved_by_hops(objective, std::move(*least));
}

// Monotonic basin hopping (Leary 2000): a random step, whose size varies over two decades, then a short local search;
// the result is kept if it is lower. Two of three steps change one variable with the others held, which is cheap. The
// third changes several and lets all variables follow.
Solved FrontSearch::improved_by_hops(std::size_t objective, Solved from) {
  constexpr std::size_t kCalls = 8;
  const std::size_t n = runner_.scaling().size();
  Formulation f = plain_formulation(runner_.problem(), runner_.scaling(), objective);
  Random random(runner_.options().seed, runner_.next_stage(), 0);
  std::size_t failed = 0;
  while (failed < options_.hops && !exhausted()) {
    std::vector<double> z = from.unit;
    const std::size_t first = random.below(n);
    const bool single = random.below(3) > 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (k != first && (single || random.uniform() * static_cast<double>(n) >= 2.0)) continue;
      const double size = std::pow(10.0, -2.0 * random.uniform());
      z[k] = std::clamp(z[k] + (2.0 * random.uniform() - 1.0) * size, 0.0, 1.0);
    }
    f.unit_lower.assign(n, 0.0);
    f.unit_upper.assign(n, 1.0);
    if (single) {
      f.unit_lower = f.unit_upper = z;
      f.unit_lower[first] = 0.0;
      f.unit_upper[first] = 1.0;
    }
    SolverRun run = runner_.run(find_optimizer("nlopt:slsqp"), f, z,
                                std::min(left(), single ? kCalls : kCalls + n));
    auto s = solved(run);
    const double least = from.scaled[objective];
    ++failed;
    if (!s || !(s->scaled[objective] < least - 1e-6 * std::abs(least))) continue;
    from = std::move(*s);
    failed = 0;
  }
  return from;
}

bool FrontSearch::find_ends(std::vector<std::vector<double>> starts) {
  const std::size_t objectives = runner_.problem().objectives.size();
  ends_.clear();
  for (std::size_t k = 0; k < objectives; ++k) {
    const auto first = best_alone(k, starts);
    if (!first) return false;
    const auto second = best_of(lexicographic(k, *first), {first->unit}, {}, true);
    ends_.push_back(second ? *second : *first);
    starts.push_back(ends_.back().unit);
  }
  ideal_ = ends_[0].scaled;
  std::vector<double> nadir = ideal_;
  for (const Solved& e : ends_)
    for (std::size_t k = 0; k < objectives; ++k) {
      ideal_[k] = std::min(ideal_[k], e.scaled[k]);
      nadir[k] = std::max(nadir[k], e.scaled[k]);
    }
  for (std::size_t k = 0; k < objectives; ++k) {
    const double span = nadir[k] - ideal_[k];
    // Ends that differ by the margin of the lexicographic search are the same.
    span_.push_back(span > 10.0 * kMargin * (1.0 + std::abs(ideal_[k])) ? span : 1.0);
  }
  for (Solved& e : ends_) normalize(e);
  for (Solved& p : pool_) normalize(p);
  return true;
}

void FrontSearch::add_to_pool(const std::vector<double>& unit, const Evaluation& evaluation) {
  Solved s;
  s.unit = unit;
  for (std::size_t k = 0; k < runner_.problem().objectives.size(); ++k)
    s.scaled.push_back(sign(k) * runner_.scaling().factor(k) * evaluation.values[k]);
  pool_.push_back(std::move(s));
}

std::vector<double> FrontSearch::from_pool(const std::vector<double>& y) const {
  const Solved* best = nullptr;
  double least = kInfinity;
  for (const Solved& p : pool_) {
    double d = 0.0;
    for (std::size_t k = 0; k < y.size(); ++k) d += (p.y[k] - y[k]) * (p.y[k] - y[k]);
    if (d >= least) continue;
    least = d;
    best = &p;
  }
  return best == nullptr ? std::vector<double>{} : best->unit;
}

Formulation FrontSearch::ray(const std::vector<double>& m, const std::vector<double>& n) const {
  Formulation f = plain_formulation(runner_.problem(), runner_.scaling());
  f.objective.responses.clear();
  f.objective.extras = {{0, 1.0}};
  f.extra_lower = {-10.0};
  f.extra_upper = {10.0};
  for (std::size_t k = 0; k < m.size(); ++k) {
    LinearForm row;
    row.responses = {{k, sign(k) / span_[k]}};
    row.extras = {{0, -n[k]}};
    row.upper = m[k] + ideal_[k] / span_[k];
    f.rows.push_back(std::move(row));
  }
  return f;
}

std::optional<Solved> FrontSearch::scalarize(const std::vector<double>& m,
                                             const std::vector<double>& n,
                                             const std::vector<std::vector<double>>& starts,
                                             bool all) {
  return best_of(ray(m, n), starts, {0.0}, all);
}

std::optional<Solved> FrontSearch::scalarize_within(const std::vector<double>& m,
                                                    const std::vector<double>& n,
                                                    const std::vector<double>& start,
                                                    const Solved& a, const Solved& b) {
  Formulation f = ray(m, n);
  f.unit_lower.assign(start.size(), 0.0);
  f.unit_upper.assign(start.size(), 1.0);
  bool any = false;
  for (std::size_t k = 0; k < start.size(); ++k) {
    if (a.unit[k] != b.unit[k] || (a.unit[k] > 0.0 && a.unit[k] < 1.0)) continue;
    f.unit_lower[k] = f.unit_upper[k] = a.unit[k];
    any = true;
  }
  return any ? best_of(f, {start}, {0.0}, false) : std::nullopt;
}

// From the cached gradients: how far a point of a front is from Pareto stationarity in all variables, relative to the
// gradients, and the weights of the objectives there.
std::optional<std::pair<double, std::vector<double>>> FrontSearch::stationarity(
    SolverRun& run, const Solved& s) const {
  const auto point = kkt_point(*run.session, runner_.scaling(), s.design);
  if (!point) return std::nullopt;
  const std::size_t objectives = runner_.problem().objectives.size();
  const Eigen::MatrixXd gradients = objective_gradients(*point, objectives);
  if (!gradients.allFinite()) return std::nullopt;
  const Multipliers found = find_multipliers(*point, gradients, objectives, 1e-6);
  if (found.weights.size() != static_cast<Eigen::Index>(objectives)) return std::nullopt;
  const double size = (gradients * found.weights.asDiagonal()).cwiseAbs().maxCoeff();
  return std::pair{found.residual.cwiseAbs().maxCoeff() / size,
                   std::vector<double>(found.weights.begin(), found.weights.end())};
}

// True if the point is Pareto stationary in all variables, after Newton steps if necessary.
bool FrontSearch::make_stationary(SolverRun& run, Solved& s) {
  constexpr double kSettled = 1e-5;
  constexpr double kNear = 0.1;
  try {
    const auto before = stationarity(run, s);
    if (!before || !(before->first < kNear)) return false;
    if (before->first <= kSettled) return true;
    const auto better = polish(*run.session, runner_.scaling(), s.design, before->second);
    if (!better) return false;
    s.unit = runner_.scaling().to_unit(*better);
    if (!fill(run, s)) return false;
    const auto after = stationarity(run, s);
    return after && after->first <= kSettled;
  } catch (const Stop&) {
    return false;
  }
}

std::optional<Solved> FrontSearch::scalarize_predicted(const std::vector<double>& m,
                                                       const std::vector<double>& n,
                                                       const Solved& a, const Solved& b) {
  constexpr double kAgree = 1e-6;     // of the box
  constexpr std::size_t kCalls = 30;  // a good prediction needs about ten
  Formulation f = ray(m, n);
  std::vector<double> z;
  std::size_t held = 0;
  for (std::size_t k = 0; k < a.unit.size(); ++k) {
    const bool agree = std::abs(a.unit[k] - b.unit[k]) <= kAgree;
    z.push_back(agree ? a.unit[k] : 0.5 * (a.unit[k] + b.unit[k]));
    f.unit_lower.push_back(agree ? z[k] : 0.0);
    f.unit_upper.push_back(agree ? z[k] : 1.0);
    held += agree ? 1U : 0U;
  }
  if (held == 0 || exhausted()) return std::nullopt;
  z.push_back(0.0);
  SolverRun run = runner_.run(find_optimizer("nlopt:slsqp"), f, z, std::min(left(), kCalls));
  auto s = solved(run);
  if (s) runner_.allow(run, run.session->left() + 4 * certificate_cost(a.unit.size()));
  const bool good = s && make_stationary(run, *s);
  runner_.book(run);
  return good ? std::move(s) : std::nullopt;
}

}  // namespace twum::inline v0_1::optim
