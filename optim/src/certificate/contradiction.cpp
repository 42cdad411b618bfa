// SPDX-License-Identifier: Apache-2.0
#include "certificate/contradiction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kLineStep = 1e-4;  // of the size of a variable
constexpr double kLonger = 10.0;
constexpr double kValueRounding =
    1e-10;  // of a value: those of solvers and series carry about ten digits
constexpr double kPartOfSlope = 1e-5;  // of the terms of a slope: less does not count
// The error of an extrapolated quotient that rounding causes is up to a few times the difference of the two quotients.
constexpr double kOfDifference = 5.0;

class Line {
 public:
  Line(Session& session, const Scaling& scaling, const KktPoint& point)
      : session_(session), scaling_(scaling), point_(point) {
    for (std::size_t k = 0; k < scaling.size(); ++k) step_.push_back(step(k));
  }

  // Evaluates the two points that end the pieces. False if one of them has no answer.
  bool walk(double stretch, bool gradient) {
    stretch_ = stretch;
    if (session_.left() < 2) return false;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      designs_[i] = at(stretch * static_cast<double>(i + 1));
      ends_[i] = session_.at(designs_[i], gradient);
      if (!ends_[i].ok()) return false;
    }
    return true;
  }

  // By values alone: the quotients extrapolated to the design, and the slope there.
  bool differs(std::size_t r) const {
    const double first = quotient(r, 0), second = quotient(r, 1);
    return !(std::abs(first + 0.5 * (first - second) - slope(r, 0)) <= negligible(r));
  }

  // Each quotient beside the mean slope of its piece. By how much the two pieces disagree is noise, the second difference of
  // the slopes bounds what a kink or the curvature of the slopes explains.
  bool contradicts(std::size_t r) const {
    const double here = slope(r, 0), near = slope(r, 1), far = slope(r, 2);
    const double first = quotient(r, 0) - 0.5 * (here + near);
    const double second = quotient(r, 1) - 0.5 * (near + far);
    const double slack = negligible(r) + kOfDifference * std::abs(first - second) +
                         std::abs(here - 2.0 * near + far);
    return std::min(std::abs(first), std::abs(second)) > slack;
  }

 private:
  // Towards the farther bound. The golden ratio makes steps differ, so that wrong entries do not cancel each other. A
  // variable near zero has a size of one unit, of which it needs a smaller part.
  double step(std::size_t k) const {
    constexpr double kLeast = 1e-2;
    const double width = scaling_.upper()[k] - scaling_.lower()[k];
    const double magnitude = std::abs(point_.design[scaling_.variable(k)]);
    const double size = std::clamp(magnitude / scaling_.slope(k, point_.design), kLeast, 1.0);
    const double turn = static_cast<double>(k + 1) * std::numbers::phi;
    const double length = kLineStep * size * (0.5 + 0.5 * (turn - std::floor(turn)));
    return (point_.nearer[k] == Side::lower ? 1.0 : -1.0) *
           std::min(length, 0.25 * width / kLonger);
  }

  std::vector<double> at(double steps) const {
    std::vector<double> unit = point_.unit;
    for (std::size_t k = 0; k < unit.size(); ++k) unit[k] += steps * step_[k];
    return scaling_.to_design(unit);
  }

  const Evaluation& evaluation(std::size_t i) const {
    return i == 0 ? point_.evaluation : ends_[i - 1];
  }

  // Along the line at its i-th point, for one piece.
  double slope(std::size_t r, std::size_t i) const {
    const auto& design = i == 0 ? point_.design : designs_[i - 1];
    double sum = 0.0;
    for (std::size_t k = 0; k < step_.size(); ++k)
      sum += stretch_ * step_[k] * derivative(evaluation(i), r, k, design);
    return sum;
  }

  // Of a kink that the evaluator reports, the side to which the line leads. Infinite slopes are no evidence.
  double derivative(const Evaluation& e, std::size_t r, std::size_t k,
                    std::span<const double> design) const {
    const std::size_t j = scaling_.variable(k);
    for (const KinkedEntry& kink : e.kinks) {
      if (kink.response != r || kink.variable != j) continue;
      if (kink.slope != Slope::one_sided) return std::numeric_limits<double>::quiet_NaN();
      return scaling_.factor(r) * scaling_.slope(k, design) *
             (step_[k] < 0.0 ? kink.left : kink.right);
    }
    return scaling_.derivative(e, r, k, design);
  }

  // Change of a response over a piece of the line.
  double quotient(std::size_t r, std::size_t piece) const {
    return scaling_.factor(r) * (ends_[piece].values[r] - evaluation(piece).values[r]);
  }

  double negligible(std::size_t r) const {
    double terms = 0.0;
    for (std::size_t k = 0; k < step_.size(); ++k)
      terms += std::abs(stretch_ * step_[k] * derivative(point_.evaluation, r, k, point_.design));
    return kValueRounding * std::abs(scaling_.factor(r) * point_.evaluation.values[r]) +
           kPartOfSlope * terms;
  }

  Session& session_;
  const Scaling& scaling_;
  const KktPoint& point_;
  std::vector<double> step_;
  double stretch_{1.0};
  std::array<std::vector<double>, 2> designs_;
  std::array<Evaluation, 2> ends_;
};

}  // namespace

std::string contradiction(Session& session, const Scaling& scaling, const KktPoint& point,
                          const std::function<bool(std::size_t)>& matters) {
  Line line(session, scaling, point);
  if (scaling.size() == 0 || !line.walk(1.0, false)) return "";
  std::vector<std::size_t> suspects;
  for (std::size_t r = 0; r < session.problem().responses(); ++r)
    if (matters(r) && line.differs(r)) suspects.push_back(r);
  for (const double stretch : {1.0, kLonger}) {
    if (suspects.empty() || !line.walk(stretch, true)) return "";
    std::erase_if(suspects, [&](std::size_t r) { return !line.contradicts(r); });
  }
  if (suspects.empty()) return "";
  return "differences of the values of '" + session.problem().response_name(suspects.front()) +
         "' contradict its derivatives";
}

}  // namespace twum::inline v0_1::optim
