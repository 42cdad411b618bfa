// SPDX-License-Identifier: Apache-2.0
#include "metrics/heat_sensitivity.hpp"

#include "curve/curve.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using P = Parameter;

constexpr double kBetweenError = 1e-5;  // of the states between [K]
// A step has at most an eighth of the time in which a mode moves: the quadratic between its three states then leaves some
// (1/8)^4 / 2880 of the result, 1e-7.
constexpr double kFine = 8;

Vector3 column_of(const std::array<std::array<double, kParameterCount + kMasses>, kMasses>& rows,
                  std::size_t column) {
  return {rows[0][column], rows[1][column], rows[2][column]};
}

}  // namespace

CourseSensitivity::CourseSensitivity(const MotorDesign& design, const HeatCourse& course,
                                     const HeatCourse::Lap& lap, bool fixed_static_friction)
    : design_(design),
      course_(course),
      lap_(lap),
      fixed_(fixed_static_friction),
      numbers_(network_numbers(design, network_of(design), fixed_static_friction)),
      still_(course.phases().front().solver.matrices()),
      ends_(1),
      walks_(lap.size()) {
  for (std::size_t i = 0; i < kMasses; ++i) ends_[0].theta[i][kParameterCount + i] = 1;
}

// Derivatives of the losses at temperatures of the nodes that stay.
std::array<CourseSensitivity::Column, kSources> CourseSensitivity::losses(std::size_t phase,
                                                                          const HeatState& state) {
  std::array<Column, kSources> found{};
  const CoursePhase& now = course_.phases()[phase];
  if (!now.losses) return found;
  const auto of_warm = now.losses->gradients(state.x, fixed_, state.wave);
  if (!of_warm) throw SearchFailure{MetricStatus::undefined};
  const DriftRule rule(design_, fixed_);
  for (std::size_t k = 0; k < kSources; ++k) {
    const Gradient direct = rule.at_fixed_temperatures((*of_warm)[k], state.x);
    std::copy(direct.begin(), direct.end(), found[k].begin());
    if (now.own_voltage) found[k][index_of(P::voltage)] = 0;
  }
  return found;
}

// By the numbers of the network, and by the ambient temperature, which all parts follow.
void CourseSensitivity::add_network(std::size_t phase, const HeatState& s, Local& into) const {
  const HeatSolver& solver = course_.phases()[phase].solver;
  const Vector3 rate = solver.rate(s);
  for (const NetworkNumber& number : numbers_) {
    const PartValues<double> parts = parts_at(number.slope, s.theta, s.p);
    for (std::size_t q = 0; q < kParameterCount; ++q) {
      for (std::size_t i = 0; i < kParts; ++i) into.parts[i][q] += parts[i] * number.by[q];
      for (std::size_t i = 0; i < kMasses; ++i)
        into.rate[i][q] += (dot(number.slope.B[i], s.p) - dot(number.slope.K[i], s.theta) -
                            number.capacities[i] * rate[i]) /
                           solver.capacities()[i] * number.by[q];
    }
  }
  for (Column& part : into.parts) part[index_of(P::ambient_temperature)] += 1;
}

CourseSensitivity::Local CourseSensitivity::local(std::size_t phase, const HeatState& state) {
  const HeatSolver& solver = course_.phases()[phase].solver;
  Local at{state, {}, losses(phase, state), solver.settling(state), solver.jacobian(state), {}};
  add_network(phase, state, at);
  for (std::size_t c = 0; c < kParameterCount; ++c) {
    const Sources<double> p = losses(at, c, {});
    for (std::size_t i = 0; i < kMasses; ++i)
      at.rate[i][c] += dot(still_.B[i], p) / solver.capacities()[i];
  }
  return at;
}

// How the nodes move with a column: with the masses, with the network, and with the losses that follow.
Vector3 CourseSensitivity::nodes(const Local& at, std::size_t c, const Vector3& theta) const {
  Vector3 off;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t node = kNodeParts[i];
    off[i] = at.parts[node][c] + dot(still_.M[node], theta);
    for (std::size_t k = 0; k < kSources; ++k) off[i] += still_.D[node][k] * at.losses[k][c];
  }
  return at.settle * off;
}

Sources<double> CourseSensitivity::losses(const Local& at, std::size_t c,
                                          const Vector3& theta) const {
  const Vector3 x = nodes(at, c, theta);
  Sources<double> p;
  for (std::size_t k = 0; k < kSources; ++k) p[k] = at.losses[k][c] + dot(at.state.slope[k], x);
  return p;
}

// S' = J S + F with F quadratic between the three states and J that of the first; what J differs by is part of F (H6.4).
CourseSensitivity::Moves CourseSensitivity::step(const Moves& from, const Local& a,
                                                 const Local& middle, const Local& b,
                                                 double h) const {
  constexpr int kPasses = 3;
  const Exponential whole = exponential(plus(Matrix3{}, h, a.jacobian)),
                    half = exponential(plus(Matrix3{}, h / 2, a.jacobian));
  const Matrix3 in_middle = plus(middle.jacobian, -1, a.jacobian),
                at_end = plus(b.jacobian, -1, a.jacobian);
  Moves to = from;
  for (std::size_t c = 0; c < kColumns; ++c) {
    const Vector3 S = column_of(from.theta, c), f0 = column_of(a.rate, c);
    Vector3 Sm = S, Se = S;
    for (int pass = 0; pass < kPasses; ++pass) {
      const Vector3 fm = plus(column_of(middle.rate, c), 1, in_middle * Sm),
                    f1 = plus(column_of(b.rate, c), 1, at_end * Se);
      const Vector3 bend = plus(plus(f0, -2, fm), 1, f1),
                    slope = plus(plus(plus(Vector3{}, -3, f0), 4, fm), -1, f1);
      Sm = plus(half.exp * S, h / 2,
                plus(plus(half.phi * f0, 0.5, half.phi2 * slope), 1, half.phi3 * bend));
      Se = plus(whole.exp * S, h,
                plus(plus(whole.phi * f0, 1, whole.phi2 * slope), 4, whole.phi3 * bend));
    }
    const Sources<double> p0 = losses(a, c, S), pm = losses(middle, c, Sm), p1 = losses(b, c, Se);
    for (std::size_t k = 0; k < kSources; ++k) to.heat[k][c] += h / 6 * (p0[k] + 4 * pm[k] + p1[k]);
    for (std::size_t i = 0; i < kMasses; ++i) to.theta[i][c] = Se[i];
  }
  return to;
}

double CourseSensitivity::next_step(std::size_t phase, double done) const {
  return std::max(course_.phases()[phase].solver.fastest(), done) / kFine;
}

// One more step of the walk through a phase, whose lengths follow from its beginning alone.
void CourseSensitivity::take_next_step(std::size_t phase) {
  std::vector<Place>& walk = walks_[phase];
  if (walk.empty()) {
    walk.push_back({0, local(phase, lap_[phase].front()), to(phase)});
    return;
  }
  const double done = walk.back().done;
  walk.push_back(take_step(phase, walk.back(), next_step(phase, done)));
}

CourseSensitivity::Place CourseSensitivity::take_step(std::size_t phase, const Place& from,
                                                      double h) {
  const HeatSolver& solver = course_.phases()[phase].solver;
  const HeatState middle = solver.advanced(from.at.state, h / 2, kBetweenError),
                  end = solver.advanced(middle, h / 2, kBetweenError);
  for (const HeatState& state : {middle, end})
    if (state.status != MetricStatus::ok) throw SearchFailure{state.status};
  Local b = local(phase, end);
  Moves moves = step(from.moves, from.at, local(phase, middle), b, h);
  return {from.done + h, std::move(b), std::move(moves)};
}

// From the last place of the walk before, which other moments share.
CourseSensitivity::Moves CourseSensitivity::through(std::size_t phase, double duration) {
  std::vector<Place>& walk = walks_[phase];
  if (walk.empty()) take_next_step(phase);
  while (walk.back().done + next_step(phase, walk.back().done) <= duration) take_next_step(phase);
  const auto after = std::ranges::upper_bound(walk, duration, {}, &Place::done);
  const Place& last = *(after - 1);
  return duration > last.done ? take_step(phase, last, duration - last.done).moves : last.moves;
}

const CourseSensitivity::Moves& CourseSensitivity::to(std::size_t phases) {
  for (std::size_t i = ends_.size() - 1; i < phases; ++i)
    ends_.push_back(through(i, course_.phases()[i].time));
  return ends_[phases];
}

CourseSensitivity::Moves CourseSensitivity::to(const HeatCourse::Moment& moment) {
  to(moment.phase);
  return through(moment.phase, moment.time - lap_[moment.phase].front().time);
}

// The lap returns: S_0 = E S_0 + S, with E the columns of the masses.
CourseSensitivity::Moves CourseSensitivity::returning() {
  const Moves& whole = to(lap_.size());
  Matrix3 left = kIdentity3;
  for (std::size_t i = 0; i < kMasses; ++i)
    for (std::size_t j = 0; j < kMasses; ++j) left[i][j] -= whole.theta[i][kParameterCount + j];
  const Matrix3 settle = inverse(left);
  Moves start;
  for (std::size_t q = 0; q < kParameterCount; ++q) {
    const Vector3 S = settle * column_of(whole.theta, q);
    for (std::size_t i = 0; i < kMasses; ++i) start.theta[i][q] = S[i];
  }
  return start;
}

// The columns of the parameters, for a course whose beginning moves.
void CourseSensitivity::begin_with(const std::array<Gradient, kMasses>& start, Moves& moves) {
  const auto follow = [&](Column& column) {
    for (std::size_t q = 0; q < kParameterCount; ++q)
      for (std::size_t i = 0; i < kMasses; ++i)
        column[q] += column[kParameterCount + i] * start[i][q];
  };
  for (Column& column : moves.theta) follow(column);
  for (Column& column : moves.heat) follow(column);
}

std::array<Gradient, kParts> CourseSensitivity::parts(const HeatCourse::Moment& moment,
                                                      const Moves& moves) {
  const Local at = local(moment.phase, moment.state);
  std::array<Gradient, kParts> found{};
  for (std::size_t q = 0; q < kParameterCount; ++q) {
    const Vector3 theta = column_of(moves.theta, q);
    const Sources<double> p = losses(at, q, theta);
    for (std::size_t i = 0; i < kParts; ++i)
      found[i][q] = at.parts[i][q] + dot(still_.M[i], theta) + dot(still_.D[i], p);
  }
  return found;
}

namespace {

std::array<Gradient, kMasses> gradients_of(
    const std::array<std::array<double, kParameterCount + kMasses>, kMasses>& rows) {
  std::array<Gradient, kMasses> gradients;
  for (std::size_t i = 0; i < kMasses; ++i)
    std::copy_n(rows[i].begin(), kParameterCount, gradients[i].begin());
  return gradients;
}

}  // namespace

std::array<Gradient, kParts> CourseSensitivity::from_cold(const HeatCourse::Moment& moment) {
  return parts(moment, to(moment));
}

std::array<Gradient, kParts> CourseSensitivity::in_cycle(const HeatCourse::Moment& moment) {
  Moves moves = to(moment);
  begin_with(gradients_of(returning().theta), moves);
  return parts(moment, moves);
}

// K mean(theta) = B mean(p) (H5.2).
std::array<Gradient, kParts> CourseSensitivity::of_mean() {
  Moves moves = to(lap_.size());
  begin_with(gradients_of(returning().theta), moves);
  Sources<double> heat{};
  double period = 0;
  for (std::size_t i = 0; i < lap_.size(); ++i) {
    for (std::size_t k = 0; k < kSources; ++k) heat[k] += lap_[i].back().heat[k];
    period += course_.phases()[i].time;
  }
  for (double& one : heat) one /= period;
  Masses<double> watts;
  for (std::size_t i = 0; i < kMasses; ++i) watts[i] = dot(still_.B[i], heat);
  const Vector3 theta = solved(still_.K, watts);
  std::array<Gradient, kParts> found{};
  for (std::size_t q = 0; q < kParameterCount; ++q) {
    Sources<double> p;
    for (std::size_t k = 0; k < kSources; ++k) p[k] = moves.heat[k][q] / period;
    const PartValues<double> by_losses = steady_parts(still_, p);
    for (std::size_t i = 0; i < kParts; ++i) found[i][q] = by_losses[i];
  }
  const auto by_network = steady_moves(numbers_, still_, theta, heat);
  for (std::size_t i = 0; i < kParts; ++i)
    for (std::size_t q = 0; q < kParameterCount; ++q) found[i][q] += by_network[i][q];
  for (Gradient& part : found) part[index_of(P::ambient_temperature)] += 1;
  return found;
}

std::array<Gradient, 3> CourseSensitivity::nodes_at_mean(std::size_t phase, const HeatState& state,
                                                         const std::array<Gradient, kParts>& mean) {
  const Local at = local(phase, state);
  std::array<Gradient, 3> found;
  for (std::size_t q = 0; q < kParameterCount; ++q) {
    const double ambient = q == index_of(P::ambient_temperature) ? 1 : 0;
    const Vector3 theta{mean[0][q] - ambient, mean[1][q] - ambient, mean[2][q] - ambient};
    const Vector3 x = nodes(at, q, theta);
    for (std::size_t i = 0; i < 3; ++i) found[i][q] = x[i];
  }
  return found;
}

}  // namespace twum::inline v0_1::core
