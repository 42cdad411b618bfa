// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/load_shape.hpp"
#include "model/track.hpp"

#include <twum/base/gauss_rule.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace twum::inline v0_1::core {

/// What happens at a radius: the crest leaves the rotor (w = 0 in W2.2), or the valley of the wave reaches it (w = 2).
inline constexpr double kLiftOff = 0, kFull = 2;

/// p(0) h / E less `versine` A R: of the sign of w - versine (W2.2) [m].
template <typename S, typename R>
R clearance(const DrivenMotor<S>& m, const R& radius, const R& indentation, double versine) {
  const R excess = shape_excess(m, radius);
  const R crest = indentation + m.mean.amplitude * excess - (radius - m.r) * m.slope;
  return versine == 0 ? crest : R(crest - (versine * m.mean.amplitude) * (1.0 + excess));
}

/// Its slope along the radius, which does not depend on the indentation.
double clearance_slope(const DrivenMotor<double>& m, double radius, double versine);

/// Where a clearance changes sign between two radii.
double clearance_zero(const DrivenMotor<double>& m, double indentation, double versine, double low,
                      double high);

/// Radii from edge to edge between which neither clearance turns: then each has one zero at most between two of them.
Vector<double> radii_between_turns(const DrivenMotor<double>& m);

/// The zero of a clearance, with derivatives by the implicit function theorem.
template <typename S, typename R>
R break_radius(const DrivenMotor<S>& m, const DrivenMotor<double>& values, double radius,
               const R& indentation, double versine) {
  R result(radius);
  const double slope = clearance_slope(values, radius, versine);
  for (int i = 0; i < kDualDepth<R>; ++i) {
    const R gap = clearance(m, result, indentation, versine);
    result = with_value(R(result - with_value(gap, 0.0) / slope), radius);
  }
  return result;
}

/// A Gauss node on 0 .. 1 moved so that square roots at the ends become smooth (W4.1).
inline GaussRule::Node substituted(bool low, bool high, const GaussRule::Node& node) {
  const double u = node.place, v = 1 - u;
  if (low && high) return {u * u * (3 - 2 * u), 6 * u * v * node.weight};
  if (low) return {u * u, 2 * u * node.weight};
  if (high) return {1 - v * v, 2 * v * node.weight};
  return node;
}

/// Calls visit(radius, width) at the nodes of a piece or of a part of it. Those in its gap stand at the gap's end.
template <typename R, typename Visit>
void for_each_node(const Piece<R>& piece, int nodes, Visit visit) {
  const R length = piece.high - piece.low;
  const double from = piece.gap / value_of(length);
  for (const GaussRule::Node& node : gauss_rule(nodes).nodes) {
    const auto [place, weight] = substituted(piece.root_low, piece.root_high, node);
    visit(R(piece.low + length * std::max(place, from)), R(length * weight));
  }
}

/// What the normal contact takes of a motor, without its derivatives.
template <typename S>
DrivenMotor<double> values_of(const DrivenMotor<S>& m) {
  DrivenMotor<double> v;
  v.r = value_of(m.r), v.b = value_of(m.b), v.preload = value_of(m.preload);
  v.youngs = value_of(m.youngs), v.thickness = value_of(m.thickness);
  v.slope = value_of(m.slope);
  std::transform(m.shape_numbers.begin(), m.shape_numbers.end(), v.shape_numbers.begin(),
                 [](const S& number) { return value_of(number); });
  v.mean.amplitude = value_of(m.mean.amplitude), v.mean.peak = value_of(m.mean.peak),
  v.track = m.track;
  return v;
}

/// Nodes of a piece for the preload. Where a piece enters the track the rule changes, and so does what it leaves: with this
/// many it leaves 1e-7, which the slices' widths make good.
inline constexpr int kLeastNodes = 16;

/// The track of a motor: what does not depend on the rotor's position.
template <typename S>
class Track {
 public:
  explicit Track(const DrivenMotor<S>& motor)
      : m_(motor), values_(values_of(motor)), radii_(radii_between_turns(values_)) {}

  const DrivenMotor<double>& values() const { return values_; }

  /// Least indentation at which nothing touches [m].
  double lift_off() const {
    double most = -std::numeric_limits<double>::infinity();
    const auto look = [&](double radius) { most = std::max(most, crest_rise(values_, radius)); };
    if (worn_track(values_))
      for_each_node(whole<double>(), nodes_of_force(),
                    [&](double radius, double) { look(radius); });
    else
      std::for_each(radii_.begin(), radii_.end(), look);
    return -most;
  }

  /// The preload that an indentation takes (W2.3) [N].
  template <typename R>
  R axial_force(const R& indentation) const {
    R force(0.0);
    const auto add = [&](const R& radius, const R& width) {
      const R excess = shape_excess(m_, radius);
      const R amplitude = m_.mean.amplitude * (1.0 + excess);
      R crest = indentation + m_.mean.amplitude * excess - (radius - m_.r) * m_.slope;
      if (worn_track(m_)) crest = crest - worn_beyond_mean(m_, radius);
      force += 2.0 * radius * width * (m_.youngs / thickness_at(m_, radius)) * amplitude *
               contact::crest_contact(R(crest / amplitude)).load;
    };
    for (const Piece<R>& piece : pieces(indentation)) for_each_node(piece, nodes_of_force(), add);
    return force;
  }

  /// The same with its slope in the indentation (W2.4). The slope takes the nodes as fixed; they move a little with the ends
  /// of the pieces.
  struct ForceAndSlope {
    double force, slope;  ///< [N], [N/m]
  };
  ForceAndSlope force_and_slope(double indentation) const {
    ForceAndSlope sum{0, 0};
    const auto add = [&](double radius, double width) {
      const double excess = shape_excess(values_, radius);
      const double amplitude = values_.mean.amplitude * (1 + excess);
      double crest =
          indentation + values_.mean.amplitude * excess - (radius - values_.r) * values_.slope;
      if (worn_track(values_)) crest -= worn_beyond_mean(values_, radius);
      const contact::CrestContact<double> at = contact::crest_contact(crest / amplitude);
      const double stiffness = 2 * radius * width * values_.youngs / thickness_at(values_, radius);
      sum.force += stiffness * amplitude * at.load;
      sum.slope += stiffness * at.angle;
    };
    for (const Piece<double>& piece : pieces(indentation))
      for_each_node(piece, nodes_of_force(), add);
    return sum;
  }

  /// The stretches that touch.
  template <typename R>
  Vector<Piece<R>> pieces(const R& indentation) const {
    if (worn_track(m_)) return {whole<R>()};
    const double depth = value_of(indentation);
    Vector<R> ends;
    ends.reserve(2 * radii_.size());  // most pieces have one break or none
    ends.push_back(R(m_.r - 0.5 * m_.b));
    for (std::size_t k = 1; k < radii_.size(); ++k) {
      Vector<R> breaks;
      for (const double versine : {kLiftOff, kFull}) {
        const auto gap = [&](double radius) { return clearance(values_, radius, depth, versine); };
        if (gap(radii_[k - 1]) * gap(radii_[k]) < 0)
          breaks.push_back(break_radius(
              m_, values_, clearance_zero(values_, depth, versine, radii_[k - 1], radii_[k]),
              indentation, versine));
      }
      if (breaks.size() == 2 && value_of(breaks[1]) < value_of(breaks[0]))
        std::swap(breaks[0], breaks[1]);
      ends.insert(ends.end(), breaks.begin(), breaks.end());
    }
    ends.push_back(R(m_.r + 0.5 * m_.b));
    Vector<Piece<R>> touching;
    touching.reserve(ends.size() - 1);
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double middle = 0.5 * (value_of(ends[k - 1]) + value_of(ends[k]));
      if (!(clearance(values_, middle, depth, kLiftOff) > 0)) continue;
      const bool partial = clearance(values_, middle, depth, kFull) < 0;
      touching.push_back({ends[k - 1], ends[k], partial && k > 1, partial && k + 1 < ends.size()});
    }
    return touching;
  }

 private:
  // Nodes of an uneven track lie where its depths are known; those that do not touch carry nothing.
  template <typename R>
  Piece<R> whole() const {
    return {R(m_.r - 0.5 * m_.b), R(m_.r + 0.5 * m_.b), false, false};
  }
  int nodes_of_force() const {
    return worn_track(m_) ? m_.track.nodes : std::max(m_.track.nodes, kLeastNodes);
  }

  const DrivenMotor<S>& m_;
  DrivenMotor<double> values_;
  Vector<double> radii_;
};

}  // namespace twum::inline v0_1::core
