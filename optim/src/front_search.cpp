// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/hypervolume.hpp>

#include "front_search.hpp"

#include <algorithm>
#include <cmath>

namespace twum::optim {

double FrontSearch::sign(std::size_t k) const {
  return campaign_.problem().objectives[k].sense == Sense::maximize ? -1.0 : 1.0;
}

std::optional<Solved> FrontSearch::solved(Attempt& attempt) {
  if (!attempt.best || attempt.best->violation > campaign_.options().feasibility_tolerance)
    return std::nullopt;
  Solved s;
  s.unit.assign(attempt.best->z.begin(),
                attempt.best->z.begin() + static_cast<std::ptrdiff_t>(campaign_.scaling().size()));
  if (!fill(attempt, s)) return std::nullopt;
  snap_to_bounds(attempt, s);
  campaign_.book(attempt);
  return s;
}

// Evaluates s.unit, which is usually still remembered.
bool FrontSearch::fill(Attempt& attempt, Solved& s) {
  s.design = campaign_.scaling().to_design(s.unit);
  try {
    if (attempt.session->left() == 0)
      attempt.session->extend(std::min<std::size_t>(1, campaign_.left()));
    s.evaluation = attempt.session->at(s.design, true);
  } catch (const Stop&) {
    return false;
  }
  if (!s.evaluation.ok()) return false;
  s.scaled.clear();
  for (std::size_t k = 0; k < campaign_.problem().objectives.size(); ++k)
    s.scaled.push_back(sign(k) * campaign_.scaling().factor(k) * s.evaluation.values[k]);
  normalize(s);
  return true;
}

// A variable that stopped just short of its bound is put on it if that is no worse in anything:
// where an objective is steep at the bound, the last 1e-9 of the box can matter.
void FrontSearch::snap_to_bounds(Attempt& attempt, Solved& s) {
  constexpr double kNear = 1e-7;
  Solved snapped = s;
  for (double& u : snapped.unit) u = u < kNear ? 0.0 : u > 1.0 - kNear ? 1.0 : u;
  if (snapped.unit == s.unit || !fill(attempt, snapped) || !dominates(snapped.y, s.y)) return;
  const Problem& p = campaign_.problem();
  for (std::size_t i = 0; i < p.constraints.size(); ++i) {
    const std::size_t r = p.objectives.size() + i;
    const double room = campaign_.options().feasibility_tolerance / campaign_.scaling().factor(r);
    const double value = snapped.evaluation.values[r];
    if (value < p.constraints[i].lower - room || value > p.constraints[i].upper + room) return;
  }
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
    Attempt attempt = campaign_.run(slsqp, formulation, z);
    auto s = solved(attempt);
    if (!s || !(attempt.best->f < least)) continue;
    least = attempt.best->f;
    best = std::move(s);
    if (!all) break;
  }
  return best;
}

// The other objectives, with the first held at its best. The room is far below what a front shows
// and far above the solver's tolerance.
Formulation FrontSearch::lexicographic(std::size_t objective, const Solved& first) const {
  Formulation f = plain_formulation(campaign_.problem(), campaign_.scaling(), objective);
  f.objective.responses.clear();
  for (std::size_t k = 0; k < campaign_.problem().objectives.size(); ++k)
    if (k != objective) f.objective.responses.push_back({k, sign(k)});
  const double best = first.scaled[objective];
  f.rows.push_back(
      {{{objective, sign(objective)}}, {}, -kInfinity, best + 1e-8 * (1.0 + std::abs(best))});
  return f;
}

bool FrontSearch::find_ends(std::vector<std::vector<double>> starts) {
  const std::size_t objectives = campaign_.problem().objectives.size();
  for (std::size_t k = 0; k < objectives; ++k) {
    const auto first =
        best_of(plain_formulation(campaign_.problem(), campaign_.scaling(), k), starts, {}, true);
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
    span_.push_back(span > 1e-9 * (1.0 + std::abs(ideal_[k])) ? span : 1.0);
  }
  for (Solved& e : ends_) normalize(e);
  for (Solved& p : pool_) normalize(p);
  return true;
}

void FrontSearch::add_to_pool(const std::vector<double>& unit, const Evaluation& evaluation) {
  Solved s;
  s.unit = unit;
  for (std::size_t k = 0; k < campaign_.problem().objectives.size(); ++k)
    s.scaled.push_back(sign(k) * campaign_.scaling().factor(k) * evaluation.values[k]);
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
  Formulation f = plain_formulation(campaign_.problem(), campaign_.scaling());
  f.objective.responses.clear();
  f.objective.extras = {{0, 1.0}};
  f.extra_lower = {-10.0};
  f.extra_upper = {10.0};
  for (std::size_t k = 0; k < m.size(); ++k) {
    Row row;
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

}  // namespace twum::optim
