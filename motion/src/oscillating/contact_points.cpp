// SPDX-License-Identifier: Apache-2.0
// Nearly all time of an oscillating motion is spent here. Points go through the same operations two by two, and values are chosen
// in place of branches.
#include "oscillating/contact_points.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kApart = 1;  // [m]: no stator reaches a rotor at this height

// Two points beside one another: the vector that every processor of 64 bits has.
using Pair [[gnu::vector_size(16)]] = double;
constexpr std::size_t kPair = 2;

Pair pair_at(const std::vector<double>& numbers, std::size_t at) {
  Pair pair;
  std::memcpy(&pair, numbers.data() + at, sizeof pair);
  return pair;
}
void put(std::vector<double>& numbers, std::size_t at, const Pair& pair) {
  std::memcpy(numbers.data() + at, &pair, sizeof pair);
}
Pair both(double value) { return Pair{value, value}; }
Pair larger(const Pair& a, const Pair& b) { return a > b ? a : b; }
Pair smaller(const Pair& a, const Pair& b) { return a < b ? a : b; }
Pair within(const Pair& value, const Pair& limit) { return smaller(larger(value, -limit), limit); }

// The share of a step in which a point is in contact that comes into it. It alone divides the error of a step by four.
Pair share_in_contact(const Pair& before, const Pair& after) {
  const Pair none = both(0), all = both(1);
  const Pair span = after - before;
  const auto enters = (before < none) & (after > none);
  const Pair share = after / (enters ? span : all);
  return enters ? share : all;
}

// Face of the stator and its sliding at two points.
struct Faces {
  Pair cosine, sine, indentation, slide;

  Faces(const PointsMove& m, double height, const Pair& c, const Pair& s)
      : cosine(c),
        sine(s),
        indentation(m.lift_cos * c + m.lift_sin * s - height),
        slide(m.slide_cos * c + m.slide_sin * s - m.rotor) {}
};

// Sums over the points.
class PointsSums {
 public:
  void add(const Faces& at, const Pair& p, const Pair& tau, const Pair& work, const Pair& margin) {
    p_ += p, pc_ += p * at.cosine, ps_ += p * at.sine;
    t_ += tau, tc_ += tau * at.cosine, ts_ += tau * at.sine;
    work_ += work, margin_ = smaller(margin_, margin);
  }

  PointsMeans means(std::size_t count) const {
    const auto mean = [=](const Pair& sum) {
      return (sum[0] + sum[1]) / static_cast<double>(count);
    };
    return {mean(p_),  mean(pc_), mean(ps_),   mean(t_),
            mean(tc_), mean(ts_), mean(work_), std::min(margin_[0], margin_[1])};
  }

 private:
  Pair p_{}, pc_{}, ps_{}, t_{}, tc_{}, ts_{}, work_{};
  Pair margin_ = both(1e300);
};

}  // namespace

LayerLaw::LayerLaw(const MotorDesign& design)
    : stiffness(design.layer.youngs_modulus / design.layer.thickness),
      thickness(design.layer.thickness),
      shear(shear_modulus(design)),
      viscosity(shear_viscosity(design)),
      inertia(twum::inertia(design)),
      friction(design.friction.kinetic),
      pressure(design.preload / (2 * std::numbers::pi * design.stator.contact_radius *
                                 design.stator.contact_width)) {
  if (design.stator.radial_slices != 1)
    throw InputError(
        "the oscillating engine has its contact at one radius, but radial_slices is not 1; write "
        "'radial_slices: 1' under stator");
  if (design.rotor.taper != 0)
    throw InputError(
        "the oscillating engine has its contact at one radius, but rotor_taper is not 0; leave it "
        "out");
  if (design.friction.threshold > design.friction.kinetic)
    throw InputError(
        "the oscillating engine has one friction coefficient, but static_friction is above "
        "kinetic_friction; leave out friction.static");
}

ContactPoints::ContactPoints(const LayerLaw& law, int count)
    : law_(law),
      count_(static_cast<std::size_t>(count)),
      cosine_(count_),
      sine_(count_),
      indentation_(count_, law.pressure / law.stiffness),
      traction_(count_, 0.0),
      strain_(count_, 0.0),
      strain_rate_(count_, 0.0) {
  TWUM_ASSERT(count_ > 0 && count_ % kPair == 0);
  for (std::size_t j = 0; j < count_; ++j) {
    const double xi = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(count_);
    cosine_[j] = std::cos(xi), sine_[j] = std::sin(xi);
  }
}

// The mean of max(w - z, 0) falls with z and is convex, so that Newton's method rises to the solution after its first step.
double ContactPoints::balanced_height(const PointsMove& move, double near) const {
  const double needed = law_.pressure / law_.stiffness * static_cast<double>(count_);
  if (needed == 0) return kApart;
  const Pair none = both(0), one = both(1);
  double height = near;
  for (int iteration = 0; iteration < 100; ++iteration) {
    Pair sum = none, points = none;
    for (std::size_t j = 0; j < count_; j += kPair) {
      const Pair q =
          move.lift_cos * pair_at(cosine_, j) + move.lift_sin * pair_at(sine_, j) - height;
      sum += larger(q, none);
      points += q > none ? one : none;
    }
    const double in_contact = points[0] + points[1];
    if (in_contact == 0) {  // begin where all of them are, below the solution
      height = -needed / static_cast<double>(count_);
      continue;
    }
    const double missing = (needed - (sum[0] + sum[1])) / in_contact;
    height -= missing;
    if (std::abs(missing) < 1e-13 * needed) break;  // rounding of the sum
  }
  return height;
}

PointsMeans ContactPoints::step(const PointsMove& move, double height) {
  return law_.is_elastic() ? elastic_step(move, height) : viscous_step(move, height);
}

// Stick raises the traction by G / h times the way; friction limits it.
PointsMeans ContactPoints::elastic_step(const PointsMove& move, double height) {
  const double per_speed = law_.shear * move.duration / law_.thickness;
  const double stiffness = law_.stiffness, friction = law_.friction;
  PointsSums sums;
  for (std::size_t j = 0; j < count_; j += kPair) {
    const Faces at(move, height, pair_at(cosine_, j), pair_at(sine_, j));
    const Pair share = share_in_contact(pair_at(indentation_, j), at.indentation);
    const Pair p = stiffness * larger(at.indentation, both(0)), limit = friction * p;
    const Pair before = pair_at(traction_, j);
    const Pair trial = before + per_speed * share * at.slide;
    const Pair tau = within(trial, limit);
    put(indentation_, j, at.indentation), put(traction_, j, tau);
    sums.add(at, p, tau, (before + tau) * (trial - tau), limit - larger(trial, -trial));
  }
  PointsMeans means = sums.means(count_);
  // The work of the mean traction on the way of the faces that is not stored as tau^2 h / 2 G.
  means.slip_work *= law_.thickness / (2 * law_.shear);
  return means;
}

// m e'' + gamma e' + G e = tau by implicit Euler. A point that sticks has the strain rate of the faces. The traction that this
// needs is limited by friction; if that is not enough, the strain rate follows from the traction.
PointsMeans ContactPoints::viscous_step(const PointsMove& move, double height) {
  const LayerLaw law = law_;
  const double dt = move.duration, inertia = law.inertia / dt;
  PointsSums sums;
  for (std::size_t j = 0; j < count_; j += kPair) {
    const Faces at(move, height, pair_at(cosine_, j), pair_at(sine_, j));
    const Pair in_contact = dt * share_in_contact(pair_at(indentation_, j), at.indentation);
    const Pair p = law.stiffness * larger(at.indentation, both(0)), limit = law.friction * p;
    const Pair strain = pair_at(strain_, j);
    const Pair rest = law.shear * strain - inertia * pair_at(strain_rate_, j);
    const Pair resistance = inertia + law.viscosity + law.shear * in_contact;
    const Pair trial = resistance * at.slide / law.thickness + rest;
    const Pair tau = within(trial, limit);
    const Pair rate = (tau - rest) / resistance;
    put(indentation_, j, at.indentation), put(strain_rate_, j, rate);
    put(strain_, j, strain + in_contact * rate);
    sums.add(at, p, tau, tau * (at.slide - law.thickness * rate) * in_contact,
             limit - larger(trial, -trial));
  }
  return sums.means(count_);
}

}  // namespace twum::inline v0_1::motion
