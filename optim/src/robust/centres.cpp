// SPDX-License-Identifier: Apache-2.0
#include "robust/centres.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

// indices larger than the smallest by this are left out; their risk is 100 times smaller
constexpr double kSpan = 1.5;
constexpr double kApart = 0.3;  // cosine below which a failing product belongs to no centre
constexpr double kSameCentre = 0.99;
constexpr int kMostDraws = 4;

}  // namespace

std::vector<bool> take_part(const RobustTerms& terms, std::span<const double> beta) {
  std::vector<bool> taken;
  for (std::size_t j = 0; j < beta.size(); ++j) {
    const auto& target = terms.terms[j].target;
    double least = beta[j];
    if (target)
      for (const std::size_t l : terms.of_target[*target]) least = std::min(least, beta[l]);
    taken.push_back(beta[j] <= least + kSpan);
  }
  return taken;
}

Centres::Centres(const RobustProblem& problem, const RobustTerms& terms, std::span<const double> x,
                 std::vector<InversePoint> points, std::vector<bool> taken, WorstPoint worst)
    : problem_(problem),
      terms_(terms),
      x_(x),
      points_(std::move(points)),
      taken_(std::move(taken)),
      worst_(std::move(worst)) {
  for (std::size_t j = 0; j < points_.size(); ++j)
    if (taken_[j]) centres_.push_back(drawn_about(points_[j].at.z));
}

// Measured rows are drawn as often as they occur, about every centre.
std::vector<double> Centres::drawn_about(std::vector<double> z) const {
  const std::size_t measured = problem_.measured.columns();
  std::fill(z.end() - static_cast<std::ptrdiff_t>(measured), z.end(), 0.0);
  z.resize(drawn_numbers(problem_), 0.0);
  return z;
}

void Centres::add(const std::vector<double>& z) {
  if (!near(z, kSameCentre)) centres_.push_back(z);
}

bool Centres::near(std::span<const double> z, double cosine) const {
  return std::any_of(centres_.begin(), centres_.end(), [&](const std::vector<double>& c) {
    return norm(c) > 0.0 && dot(c, z) >= cosine * norm(c) * norm(z);
  });
}

// The lightest failing product that is apart from every centre: the position, and the limit that it breaks. None if it has no
// answer, which breaks all limits.
std::optional<Centres::Missed> Centres::lightest_missed(const ImportanceSample& sample) const {
  std::optional<Missed> lightest;
  double least = kInfinity;
  for (std::size_t i = 0; i < sample.normals.size(); ++i) {
    const double size = norm(sample.normals[i]);
    if (size >= least || near(sample.normals[i], kApart)) continue;
    for (std::size_t j = 0; j < terms_.terms.size(); ++j) {
      const double margin = sample.margins[i][j];
      if (!terms_.terms[j].target || !(margin < 0.0)) continue;
      least = size;
      lightest = {i, std::isfinite(margin) ? std::optional(j) : std::nullopt};
      break;
    }
  }
  return lightest;
}

// U3.2 from there. Where products have no answer there is no worst one to search for: the product itself is the centre.
bool Centres::add_missing(const ImportanceSample& sample) {
  const std::optional<Missed> missed = lightest_missed(sample);
  if (!missed) return false;
  std::vector<double> start = sample.normals[missed->product];
  if (!missed->term) {
    centres_.push_back(std::move(start));
    return true;
  }
  const std::size_t failing = *missed->term;
  const double size = norm(start);
  for (double& c : start) c /= size;
  InversePoint found = worst_(failing, start);
  if (!found.at.failure.empty() || near(found.at.z, kSameCentre)) return false;
  centres_.push_back(found.at.z);
  taken_[failing] = true;
  if (found.at.value < points_[failing].at.value) points_[failing] = std::move(found);
  return true;
}

ImportanceSample Centres::sample(const SamplePlan& plan) {
  ImportanceSample sample;
  for (int draw = 0; draw < kMostDraws; ++draw) {
    sample = draw_importance(problem_, terms_, x_, centres_, plan);
    if (!problem_.measured.empty() || !add_missing(sample)) break;
  }
  return sample;
}

ImportanceSample Centres::sample_unchanged(const SamplePlan& plan) const {
  return draw_importance(problem_, terms_, x_, centres_, plan);
}

}  // namespace twum::inline v0_1::optim
