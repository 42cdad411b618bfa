// SPDX-License-Identifier: Apache-2.0
#include "problem/nlp.hpp"

#include "problem/tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {

Formulation plain_formulation(const Problem& problem, const Scaling& scaling,
                              std::size_t objective) {
  Formulation f;
  const double sign = problem.objectives[objective].sense == Sense::maximize ? -1.0 : 1.0;
  f.objective.responses = {{objective, sign}};
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const std::size_t r = problem.objectives.size() + i;
    const double s = scaling.factor(r);
    f.rows.push_back(
        {{{r, 1.0}}, {}, s * problem.constraints[i].lower, s * problem.constraints[i].upper});
  }
  return f;
}

bool better(const Candidate& a, const Candidate& b, double tolerance) {
  const bool a_ok = a.violation <= tolerance;
  const bool b_ok = b.violation <= tolerance;
  if (a_ok != b_ok) return a_ok;
  return a_ok ? a.f < b.f : a.excess < b.excess;
}

Nlp::Nlp(Session& session, const Scaling& scaling, Formulation formulation)
    : session_(session), scaling_(scaling), formulation_(std::move(formulation)) {
  if (formulation_.unit_lower.empty()) formulation_.unit_lower = scaling_.lower();
  if (formulation_.unit_upper.empty()) formulation_.unit_upper = scaling_.upper();
  lower_ = formulation_.unit_lower;
  upper_ = formulation_.unit_upper;
  lower_.insert(lower_.end(), formulation_.extra_lower.begin(), formulation_.extra_lower.end());
  upper_.insert(upper_.end(), formulation_.extra_upper.begin(), formulation_.extra_upper.end());
  value_.c.resize(rows());
  value_.df.resize(size());
  value_.dc.resize(rows() * size());
  terms_.assign(session_.problem().responses(), 0.0);
}

std::vector<double> Nlp::design(std::span<const double> z) const {
  return scaling_.to_design(z.first(units()));
}

void Nlp::restrict_box(std::span<const double> centre, double radius) {
  for (std::size_t k = 0; k < units(); ++k) {
    const double least = formulation_.unit_lower[k];
    const double most = formulation_.unit_upper[k];
    lower_[k] = radius > 0.0 ? std::max(least, centre[k] - radius) : least;
    upper_[k] = radius > 0.0 ? std::min(most, centre[k] + radius) : most;
  }
}

double Nlp::row_value(const LinearForm& row, const Evaluation& e, std::span<const double> z) const {
  double sum = 0.0;
  for (const Term& t : row.responses)
    sum += t.factor * scaling_.factor(t.index) * e.values[t.index];
  for (const Term& t : row.extras) sum += t.factor * z[units() + t.index];
  return without_dust(sum);
}

void Nlp::row_gradient(const LinearForm& row, const Evaluation& e, double* out) const {
  std::fill_n(out, size(), 0.0);
  for (const Term& t : row.responses)
    for (std::size_t k = 0; k < units(); ++k)
      out[k] = without_dust(out[k] + t.factor * scaling_.derivative(e, t.index, k, design_));
  for (const Term& t : row.extras) out[units() + t.index] += t.factor;
}

bool Nlp::fill(const Evaluation& e, std::span<const double> z, bool gradient) {
  value_.f = row_value(formulation_.objective, e, z);
  for (std::size_t i = 0; i < rows(); ++i) value_.c[i] = row_value(row(i), e, z);
  if (gradient) {
    row_gradient(formulation_.objective, e, value_.df.data());
    for (std::size_t i = 0; i < rows(); ++i) row_gradient(row(i), e, value_.dc.data() + i * size());
    flatten_kept();
  }
  return usable(gradient);
}

// A limit that the design keeps may have no derivative there, as where a wave ends. It does not bind, so it counts as flat.
void Nlp::flatten_kept() {
  for (std::size_t i = 0; i < rows(); ++i) {
    const std::span slopes(value_.dc.data() + i * size(), size());
    const bool kept = row(i).lower < value_.c[i] && value_.c[i] < row(i).upper;
    if (kept && !std::ranges::all_of(slopes, can_be_reckoned_with)) std::ranges::fill(slopes, 0.0);
  }
}

bool Nlp::usable(bool gradient) const {
  const auto all = [](const auto& list) { return std::ranges::all_of(list, can_be_reckoned_with); };
  return can_be_reckoned_with(value_.f) && all(value_.c) &&
         (!gradient || (all(value_.df) && all(value_.dc)));
}

const NlpValue* Nlp::at(std::span<const double> z, bool gradient) {
  session_.heed();
  if (known_ && (has_gradient_ || !gradient) && std::equal(z.begin(), z.end(), point_.begin()))
    return &value_;
  known_ = false;
  point_.assign(z.begin(), z.end());
  for (std::size_t k = 0; k < size(); ++k) {
    if (!std::isfinite(point_[k])) return nullptr;  // a failure of the solver, not of the design
    point_[k] = std::clamp(point_[k], lower_[k], upper_[k]);
  }
  design_ = design(point_);
  const Evaluation& e = session_.at(design_, gradient);
  if (!e.ok()) return nullptr;
  const bool usable = fill(e, point_, gradient);
  if (gradient) note_terms(e);
  keep(point_, e);
  beside_ = beside_known() ? beside_ + 1 : 0;
  if (!usable) return nullptr;
  known_ = true;
  has_gradient_ = gradient;
  return &value_;
}

void Nlp::expect(std::span<const double> optimum) {
  around_.emplace(session_.problem(), search_sizes(session_.problem(), optimum));
  optimum_ = around_->to_unit(optimum);
}

bool Nlp::beside_known() const {
  constexpr double kBeside = 0.1;  // of the variables' magnitudes
  if (!around_) return false;
  const std::vector<double> here = around_->to_unit(design_);
  for (std::size_t k = 0; k < here.size(); ++k)
    if (std::abs(here[k] - optimum_[k]) > kBeside) return false;
  return true;
}

double Nlp::excess(const NlpValue& value) const {
  double worst = 0.0;
  for (std::size_t i = 0; i < rows(); ++i)
    worst = std::max({worst, row(i).lower - value.c[i], value.c[i] - row(i).upper});
  return worst;
}

// A method without derivatives uses the magnitudes of the last design that had some.
void Nlp::note_terms(const Evaluation& e) {
  for (std::size_t r = 0; r < terms_.size(); ++r)
    terms_[r] = term_magnitude(session_.problem(), r, e, design_);
}

double Nlp::side_tolerance(std::size_t i, double bound) const {
  const Problem& problem = session_.problem();
  double terms = 0.0;
  for (const Term& t : row(i).responses)
    terms = std::max(terms, std::abs(t.factor * scaling_.factor(t.index)) * terms_[t.index]);
  const double relative = session_.options().feasibility_tolerance;
  const auto& own = row(i).responses;
  const bool of_a_limit = own.size() == 1 && own[0].index >= problem.objectives.size();
  // Rows of a front's construction are no limits of the user.
  if (!of_a_limit) return relative * std::max({1.0, std::abs(bound), terms});
  Constraint limit;
  limit.tolerance = std::abs(own[0].factor * scaling_.factor(own[0].index)) *
                    problem.constraints[own[0].index - problem.objectives.size()].tolerance;
  return limit_tolerance(limit, bound, terms, relative);
}

double Nlp::tolerance(std::size_t i) const {
  double least = kInfinity;
  for (const double bound : {row(i).lower, row(i).upper})
    if (std::isfinite(bound)) least = std::min(least, side_tolerance(i, bound));
  return least;
}

double Nlp::violation() const {
  double worst = 0.0;
  for (std::size_t i = 0; i < rows(); ++i) {
    const double c = value_.c[i];
    const double excess = std::max(row(i).lower - c, c - row(i).upper);
    if (!(excess > 0.0)) continue;
    const double allowed = side_tolerance(i, c < row(i).lower ? row(i).lower : row(i).upper);
    worst = std::max(worst, session_.options().feasibility_tolerance * (excess / allowed));
  }
  return worst;
}

void Nlp::keep(std::span<const double> z, const Evaluation& e) {
  Candidate seen{{}, value_.f, violation(), excess(value_), {}};
  if (best_ && !better(seen, *best_, session_.options().feasibility_tolerance)) return;
  seen.z.assign(z.begin(), z.end());
  seen.values = e.values;
  best_ = std::move(seen);
}

}  // namespace twum::inline v0_1::optim
