// SPDX-License-Identifier: Apache-2.0
#include "curve/crossings.hpp"

#include "contact/load_shape.hpp"
#include "curve/goal.hpp"
#include "curve/speed_roots.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

constexpr double kTorqueJump = 1e-7;  // of the holding torque, between neighbouring speeds
constexpr double kNextSpeed = 1e-13;  // of a speed
constexpr double kLeastStep = 2e-16;  // of a speed
constexpr int kTriedBeside = 2;
constexpr double kRise =
    1.01;  // of a falling torque: ten times what the speed takes from the wave's turn (E6.7)
constexpr int kAboutPeak =
    2;  // nodes on each side of the best one which the search for the peak looks at

// Where to begin, and the torque's slope there.
struct UsualNoLoad {
  double speed, slope;
};

// A layer that sticks all through has no torque at V = sin theta_L / theta_L, the mean of the wave's velocity, and its mean
// traction falls by s theta_L^2 / pi (E2.3); the ends that slip raise the speed by about a tenth of what is left to V = 1.
UsualNoLoad usual_no_load(const Curve& curve) {
  const contact::ContactNumbers<double> n = contact_numbers(curve.motor(), 0.0);
  const double V = std::pow(n.edge.sin / n.half_angle, 0.9), L2 = n.half_angle * n.half_angle;
  const double load = contact::load_shape(n.half_angle, n.edge);
  return {V * curve.crest(),
          -curve.holding() * n.stick_rate * L2 / (n.threshold * load * curve.crest())};
}

}  // namespace

// The zero of a smooth stretch by inverse interpolation; nothing if that does not settle at once.
std::optional<double> CurveCrossings::zero_near(double torque, const CurvePoint& low,
                                                const CurvePoint& high) {
  Walk walk(points_);
  walk.pass(low);
  walk.pass(high);
  InverseInterpolation line(points_.curve().crest(), 1e-16);
  for (const CurvePoint& end : {low, high}) {
    const bool in_doubt = scan_.in_doubt(end.torque - torque);
    line.add(end.speed, (in_doubt ? walk.answered(end.speed).torque : end.torque) - torque);
  }
  for (int i = 0; i < 8; ++i) {
    const double speed = line.zero();
    if (!(speed > low.speed && speed < high.speed)) return {};
    if (line.has_converged()) return speed;
    const double excess = walk.answered(speed).torque - torque;
    if (excess == 0) return speed;
    line.add(speed, excess);
  }
  return {};
}

// The no-load speed where no scan is needed for it, or nothing. Each point tells on which side of it the zero lies.
std::optional<double> CurveCrossings::zero_of_falling() {
  scan_.require_drive();
  const Curve& curve = points_.curve();
  if (!scan_.falls_smoothly()) return {};
  Walk walk(points_);
  InverseInterpolation line(curve.crest(), 1e-16);
  double low = scan_.first().speed, high = curve.crest();
  const UsualNoLoad usual = usual_no_load(curve);
  double speed = usual.speed;
  for (int i = 0; i < 12; ++i) {
    if (!(speed > low && speed < high)) speed = 0.5 * (low + high);
    const CurvePoint p = i < 2 ? scan_.node(speed, walk) : walk.at(speed);
    if (!p.ok()) return {};
    if (p.torque == 0) return speed;
    (p.torque > 0 ? low : high) = speed;
    line.add(speed, p.torque);
    if (line.has_converged()) return line.zero();
    speed = line.count() == 1 ? speed - p.torque / usual.slope : line.zero();
  }
  return {};
}

// With mu_0 > mu single speeds may have no periodic state. Then the next speeds, a few roundings further, stand for them.
CurvePoint CurveCrossings::answered_beside(double speed) const {
  CurvePoint p = points_.at(speed);
  for (int i = 1; !p.ok() && i <= kTriedBeside; ++i) p = points_.at(speed * (1 + i * kNextSpeed));
  if (!p.ok()) throw SearchFailure{p.status};
  return p;
}

Crossing CurveCrossings::falls_through(double torque, const CurvePoint& low,
                                       const CurvePoint& high) {
  if (!points_.curve().may_jump()) {
    if (const std::optional<double> zero = zero_near(torque, low, high)) return {*zero, false};
  }
  const auto excess = [&](double speed) { return answered_beside(speed).torque - torque; };
  const Bracket b =
      close_in(excess, {low.speed, high.speed, low.torque - torque, high.torque - torque});
  const bool jump = b.at_low - b.at_high > kTorqueJump * points_.curve().holding();
  return {jump ? b.low : b.nearest(), jump};
}

Crossing CurveCrossings::no_load() {
  if (no_load_) return *no_load_;
  if (points_.curve().begin() > 0) scan_.require_drive();
  if (!scan_.drives()) return *(no_load_ = Crossing{0, false});
  if (const auto zero = zero_of_falling()) return *(no_load_ = Crossing{*zero, false});
  const Vector<CurvePoint>& nodes = scan_.nodes();
  return *(no_load_ = falls_through(0, nodes.end()[-2], nodes.back()));
}

Vector<CurvePoint> CurveCrossings::working_nodes() {
  const Vector<CurvePoint>& all = all_nodes();
  Vector<CurvePoint> nodes(all.begin(), all.end() - 1);
  const double end = no_load().speed;
  if (!(end > nodes.back().speed)) return nodes;
  const bool may_jump = points_.curve().may_jump();
  CurvePoint last = may_jump ? points_.answered(end) : all.back();
  if (!may_jump) last.speed = end, last.torque = 0;
  nodes.push_back(last);
  return nodes;
}

Vector<CurvePoint> CurveCrossings::powerful_nodes() {
  const Vector<CurvePoint>& few = powerful_of_falling();
  return few.empty() ? working_nodes() : few;
}

const Vector<CurvePoint>& CurveCrossings::powerful_of_falling() {
  if (!powerful_) powerful_ = scan_.falls_smoothly() ? from_no_load_down() : Vector<CurvePoint>{};
  return *powerful_;
}

// The scan goes on from them, so that its points are the same whatever is asked first.
const Vector<CurvePoint>& CurveCrossings::all_nodes() {
  powerful_of_falling();
  return scan_.nodes();
}

// To where even the torque of the first point is too little for the power, and no hump can be worth a look.
Vector<CurvePoint> CurveCrossings::from_no_load_down() {
  const double end = no_load().speed, most = kRise * scan_.first().torque;
  Vector<CurvePoint> nodes{{.speed = end}};
  double best = 0;
  int below_best = 0;
  for (int k = scan_.below(end); k >= 0; --k) {
    const CurvePoint& next = k == 0 ? scan_.first() : scan_.on_grid(k);
    if (!next.ok()) return {};
    if (!(next.torque > 0)) continue;  // beside no-load
    nodes.push_back(next);
    const double power = next.torque * next.speed;
    below_best = power > best ? 0 : below_best + 1;
    best = std::max(best, power);
    if (below_best >= kAboutPeak && most * next.speed <= GoalCurve::kNearly * best) break;
  }
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

double CurveCrossings::plateau_end() {
  if (plateau_end_) return *plateau_end_;
  const Curve& curve = points_.curve();
  if (!scan_.drives() || !scan_.starts_on_plateau()) return *(plateau_end_ = 0.0);
  const Vector<CurvePoint>& nodes = all_nodes();
  const auto beyond =
      std::find_if(nodes.begin(), nodes.end(), [](const CurvePoint& n) { return !n.plateau; });
  const double low = beyond[-1].speed, high = beyond->speed;
  const double slack = 1e-4 * curve.crest();  // nodes are not exact
  double speed = margin_end(std::max(low - slack, curve.begin()), high + slack);
  // With mu_0 > mu the layer may hold on to sticking where slipping all through would be possible too.
  if (curve.has_static_excess()) {
    if (!on_plateau(speed * (1 - 1e-9))) speed = last_on_plateau(low, speed);
  } else if (!curve.falls()) {  // its wave takes derivatives from the point
    speed = just_before(speed);
  }
  return *(plateau_end_ = speed);
}

// Where the margin of slipping all through is used up.
double CurveCrossings::margin_end(double low, double high) const {
  const Curve& curve = points_.curve();
  double speed = low;
  for (int i = 0; i < 60; ++i) {
    const Margin margin = plateau_margin(curve.motor(), speed);
    (margin.value > 0 ? low : high) = speed;
    double next = speed - margin.value / margin.slope;
    const bool inside = next >= low && next <= high;
    if (!inside) next = 0.5 * (low + high);
    const double step = std::fabs(next - speed);
    speed = next;
    // The margin is nearly linear in speed: after a step of 1e-9 the next would be lost in rounding.
    if ((inside && step <= 1e-9 * curve.crest()) || high - low <= 1e-15 * curve.crest()) break;
  }
  return speed;
}

// A few roundings back to where it is on the plateau: zones that have just begun there would be all
// rounding, and so would their derivatives.
double CurveCrossings::just_before(double end) const {
  double speed = end;
  for (double step = kLeastStep; step < kNextSpeed && !points_.at(speed).plateau; step *= 8)
    speed = end * (1 - step);
  return speed;
}

// True if every slice slips and drives. The edges of a track are left out: track_plateau_end() looks at them. On the plateau the
// wave is the same at every speed, so the motor under the first wave tells.
bool CurveCrossings::on_plateau(double speed) const {
  const SolvedPoint solved = solve_point(points_.curve().motor(), speed, nullptr, kWithoutSplits);
  return solved.status == PointStatus::ok && solved.drives();
}

double CurveCrossings::last_on_plateau(double low, double high) const {
  while (high - low > 1e-15 * points_.curve().crest()) {
    const double middle = 0.5 * (low + high);
    (on_plateau(middle) ? low : high) = middle;
  }
  return low;
}

bool CurveCrossings::leaves_plateau_at(double speed) {
  return scan_.starts_on_plateau() &&
         std::fabs(speed - plateau_end()) <= 1e-8 * points_.curve().crest();
}

}  // namespace twum::inline v0_1::core
