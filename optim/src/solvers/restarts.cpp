// SPDX-License-Identifier: Apache-2.0
#include "solvers/restarts.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

constexpr int kMostRestarts = 60;  // number of restarts, each in a smaller or a shifted box

double distance(std::span<const double> a, std::span<const double> b) {
  double d = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) d = std::max(d, std::abs(a[k] - b[k]));
  return d;
}

}  // namespace

bool Restarts::next(std::span<const double> failed_at, std::span<const double> ended_at) {
  if (++count_ > kMostRestarts) return false;
  if (nlp_.best()) from_ = nlp_.best()->z;
  return failed_at.empty() ? grow(ended_at) : shrink(failed_at.first(nlp_.units()));
}

bool Restarts::grow(std::span<const double> ended_at) {
  if (!at_a_wall(ended_at)) return false;
  radius_ *= 4.0;
  if (radius_ >= widest()) radius_ = 0.0;
  nlp_.restrict_box(from_, radius_);
  return true;
}

double Restarts::widest() const {
  double width = 0.0;
  for (std::size_t k = 0; k < nlp_.units(); ++k)
    width = std::max(width, nlp_.most()[k] - nlp_.least()[k]);
  return width;
}

bool Restarts::at_a_wall(std::span<const double> z) const {
  if (radius_ <= 0.0) return false;
  for (std::size_t k = 0; k < nlp_.units(); ++k) {
    const bool low = z[k] - nlp_.lower()[k] < 1e-3 * radius_ && nlp_.lower()[k] > nlp_.least()[k];
    const bool high = nlp_.upper()[k] - z[k] < 1e-3 * radius_ && nlp_.upper()[k] < nlp_.most()[k];
    if (low || high) return true;
  }
  return false;
}

bool Restarts::shrink(std::span<const double> failed) {
  const bool somewhere = std::ranges::all_of(failed, [](double u) { return std::isfinite(u); });
  if (!somewhere) {  // the solver failed
    if (!nlp_.best()) return false;
    radius_ = 0.25 * (radius_ > 0.0 ? radius_ : widest());
  } else if (!nlp_.best()) {
    nudge(failed);
  } else {
    const double d = distance(failed, std::span<const double>(from_).first(nlp_.units()));
    // The best design itself has no derivative, so start next to it.
    if (d == 0.0) nudge(failed);
    radius_ = d > 0.0 ? 0.5 * d : 0.25 * (radius_ > 0.0 ? radius_ : widest());
    if (radius_ < 1e-10) return false;
  }
  nlp_.restrict_box(from_, radius_);
  return true;
}

// A small move towards the middle of the box, longer each time.
void Restarts::nudge(std::span<const double> failed) {
  ++nudges_;
  const double part = std::min(0.5, 1e-4 * std::pow(4.0, nudges_));
  for (std::size_t k = 0; k < nlp_.units(); ++k) {
    const double share = (k + static_cast<std::size_t>(nudges_)) % 2 == 0 ? 0.45 : 0.55;
    const double middle = nlp_.least()[k] + share * (nlp_.most()[k] - nlp_.least()[k]);
    from_[k] = failed[k] + part * (middle - failed[k]);
  }
}

}  // namespace twum::inline v0_1::optim
