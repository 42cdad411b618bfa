// SPDX-License-Identifier: Apache-2.0
#include "nlp.hpp"

#include <algorithm>
#include <cmath>

namespace twum::optim {

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
  return a_ok ? a.f < b.f : a.violation < b.violation;
}

Nlp::Nlp(Session& session, const Scaling& scaling, Formulation formulation)
    : session_(session), scaling_(scaling), formulation_(std::move(formulation)) {
  if (formulation_.unit_lower.empty()) formulation_.unit_lower.assign(units(), 0.0);
  if (formulation_.unit_upper.empty()) formulation_.unit_upper.assign(units(), 1.0);
  lower_ = formulation_.unit_lower;
  upper_ = formulation_.unit_upper;
  lower_.insert(lower_.end(), formulation_.extra_lower.begin(), formulation_.extra_lower.end());
  upper_.insert(upper_.end(), formulation_.extra_upper.begin(), formulation_.extra_upper.end());
  value_.c.resize(rows());
  value_.df.resize(size());
  value_.dc.resize(rows() * size());
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
  }
  return usable(gradient);
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
  keep(point_);
  if (!usable) return nullptr;
  known_ = true;
  has_gradient_ = gradient;
  return &value_;
}

double Nlp::violation(const NlpValue& value) const {
  double worst = 0.0;
  for (std::size_t i = 0; i < rows(); ++i)
    worst = std::max({worst, row(i).lower - value.c[i], value.c[i] - row(i).upper});
  return worst;
}

void Nlp::keep(std::span<const double> z) {
  const double tolerance = session_.options().feasibility_tolerance;
  const double violated = violation(value_);
  const bool feasible = violated <= tolerance;
  if (best_) {
    const bool best_feasible = best_->violation <= tolerance;
    if (best_feasible && !feasible) return;
    if (best_feasible == feasible &&
        !(feasible ? value_.f < best_->f : violated < best_->violation))
      return;
  } else {
    best_.emplace();
  }
  best_->z.assign(z.begin(), z.end());
  best_->f = value_.f;
  best_->violation = violated;
}

}  // namespace twum::optim
