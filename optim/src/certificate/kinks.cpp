// SPDX-License-Identifier: Apache-2.0
#include "certificate/kinks.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace twum::inline v0_1::optim {

using Eigen::Index;

Kinks::Kinks(Session& session, const Scaling& scaling, const KktPoint& point)
    : session_(session),
      scaling_(scaling),
      point_(point),
      objectives_(session.problem().objectives.size()) {}

bool Kinks::undefined(const std::function<bool(std::size_t)>& matters) const {
  return std::ranges::any_of(point_.evaluation.kinks, [&](const KinkedEntry& k) {
    const auto at = position(k.variable);
    if (k.slope != Slope::undefined || !matters(k.response) || !at) return false;
    const std::size_t n = session_.problem().variables.size();
    const bool infinite = std::isinf(point_.evaluation.jacobian[k.response * n + k.variable]);
    return !infinite ||
           !std::isfinite(point_.jacobian(static_cast<Index>(k.response), static_cast<Index>(*at)));
  });
}

std::vector<Eigen::MatrixXd> Kinks::reported() {
  const Eigen::MatrixXd g = objective_gradients(point_, objectives_);
  std::vector<KinkedEntry> kinks;
  std::set<std::size_t> kinked;
  for (const KinkedEntry& kink : point_.evaluation.kinks) {
    const bool counts = kink.slope == Slope::one_sided && kink.response == 0 && objectives_ == 1;
    if (!counts || !position(kink.variable)) continue;
    kinks.push_back(kink);
    kinked.insert(kink.variable);
  }
  std::vector<Eigen::MatrixXd> all;
  for (const KinkedEntry& kink : kinks) add_candidates(kink, kinked.size() == 1, g, all);
  if (all.empty()) all.push_back(g);
  return all;
}

// At a convex kink, any slope between the two sides is a candidate. At a concave kink, both sides have to be
// stationary. The same holds for kinks in several variables, because the entries do not say which sides belong
// together. On a bound there is only one side.
void Kinks::add_candidates(const KinkedEntry& kink, bool mixes, const Eigen::MatrixXd& g,
                           std::vector<Eigen::MatrixXd>& all) {
  const std::size_t at = *position(kink.variable);
  note(name(at));
  const bool maximize = session_.problem().objectives[0].sense == Sense::maximize;
  const double scale =
      (maximize ? -1.0 : 1.0) * scaling_.factor(0) * scaling_.slope(at, point_.design);
  Eigen::MatrixXd left = g, right = g;
  left(static_cast<Index>(at), 0) = scale * kink.left;
  right(static_cast<Index>(at), 0) = scale * kink.right;
  const bool has_left = point_.unit[at] > scaling_.lower()[at];
  const bool has_right = point_.unit[at] < scaling_.upper()[at];
  if (mixes && kink.left * scale <= kink.right * scale && has_left && has_right) {
    left.conservativeResize(Eigen::NoChange, 2);
    left.col(1) = right.col(0);
    all.push_back(left);
    return;
  }
  if (has_left) all.push_back(left);
  if (has_right) all.push_back(right);
}

std::optional<Eigen::MatrixXd> Kinks::found_nearby() {
  constexpr double kNear = 1e-7;
  constexpr double kFurther = 100.0;
  Eigen::MatrixXd mixed = objective_gradients(point_, 1);
  std::vector<std::string> found;
  for (Index k = 0; k < point_.variables(); ++k) {
    const auto right = neighbour(k, kNear);
    const auto left = neighbour(k, -kNear);
    if (!right || !left || better(*right) || better(*left)) return std::nullopt;
    const double near = (right->jacobian.row(0) - left->jacobian.row(0)).cwiseAbs().maxCoeff();
    if (near <= 1e-3 * mixed.cwiseAbs().maxCoeff()) continue;
    // The gradients of a smooth function differ in proportion to the distance.
    const auto far = jump(k, kFurther * kNear);
    if (!far || *far > 0.1 * kFurther * near) continue;
    found.push_back(name(static_cast<std::size_t>(k)));
    mixed.conservativeResize(Eigen::NoChange, mixed.cols() + 2);
    mixed.col(mixed.cols() - 2) = left->jacobian.row(0).transpose();
    mixed.col(mixed.cols() - 1) = right->jacobian.row(0).transpose();
  }
  if (found.empty()) return std::nullopt;
  for (const std::string& variable : found) note(variable);
  return mixed;
}

std::optional<double> Kinks::jump(Index k, double step) {
  const auto right = neighbour(k, step);
  const auto left = neighbour(k, -step);
  if (!right || !left) return std::nullopt;
  return (right->jacobian.row(0) - left->jacobian.row(0)).cwiseAbs().maxCoeff();
}

std::optional<std::size_t> Kinks::position(std::size_t variable) const {
  for (std::size_t k = 0; k < scaling_.size(); ++k)
    if (scaling_.variable(k) == variable) return k;
  return std::nullopt;
}

const std::string& Kinks::name(std::size_t k) const {
  return session_.problem().variables[scaling_.variable(k)].name;
}

void Kinks::note(const std::string& variable) {
  if (std::ranges::find(names_, variable) == names_.end()) names_.push_back(variable);
}

double Kinks::objective(const KktPoint& p) const {
  const bool maximize = session_.problem().objectives[0].sense == Sense::maximize;
  return (maximize ? -1.0 : 1.0) * scaling_.factor(0) * p.evaluation.values[0];
}

bool Kinks::better(const KktPoint& p) const {
  const double here = objective(point_);
  return objective(p) < here - 1e-12 * std::abs(here) && p.violation <= point_.violation;
}

std::optional<KktPoint> Kinks::neighbour(Index k, double step) {
  std::vector<double> unit = point_.unit;
  const auto at = static_cast<std::size_t>(k);
  unit[at] = std::clamp(unit[at] + step, scaling_.lower()[at], scaling_.upper()[at]);
  return kkt_point(session_, scaling_, scaling_.to_design(unit));
}

}  // namespace twum::inline v0_1::optim
