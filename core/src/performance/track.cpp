// SPDX-License-Identifier: Apache-2.0
// The normal contact over the annulus: where the rotor stands, which radii touch, and the slices there.
#include "performance/track.hpp"

#include "contact/load_shape.hpp"
#include "performance/gauss_rule.hpp"

#include <twum/base/error.hpp>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace twum::performance {
namespace {

constexpr double kPi = std::numbers::pi;
// Nodes of a piece for the preload. Where a piece enters the track the rule changes, and so does what it leaves: with this
// many it leaves 1e-7, which the slices' widths make good.
constexpr int kLeastNodes = 16;
constexpr int kLooksPerRow = 4;  // of a table: its spline turns at most twice between two rows

using RadiusDual = Dual<double, 1>;

// ---- where the wave lifts off, and where it touches all round ----------------------------------

/// What happens at a radius: the crest leaves the rotor (w = 0 in W2.2), or the trough reaches it (w = 2).
constexpr double kLiftOff = 0, kFull = 2;

// p(0) h / E less `versine` A R: of the sign of w - versine (W2.2) [m].
template <typename S, typename R>
R clearance(const DrivenMotor<S>& m, const R& radius, const R& indentation, double versine) {
  const R excess = shape_excess(m, radius);
  const R crest = indentation + m.amplitude * excess - (radius - m.r) * m.slope;
  return versine == 0 ? crest : R(crest - (versine * m.amplitude) * (1.0 + excess));
}

double clearance_slope(const DrivenMotor<double>& m, double radius, double versine) {
  return clearance(m, RadiusDual::variable(radius, 0), RadiusDual(0.0), versine).d[0];
}

template <typename F>
double zero_between(F f, double low, double high) {
  const double at_low = f(low), at_high = f(high);
  if (at_low == 0) return low;
  if (at_high == 0) return high;
  boost::uintmax_t limit = 200;
  const auto found = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(52), limit);
  return 0.5 * (found.first + found.second);
}

// Radii from edge to edge between which neither clearance turns: then each has one zero at most between two of them.
std::vector<double> looks(const DrivenMotor<double>& m) {
  const double inner = m.r - 0.5 * m.b, outer = m.r + 0.5 * m.b;
  std::vector<double> radii{inner};
  if (m.track.table) {
    double before = inner;
    for (const double row : m.track.table->knots()) {
      if (!(row > inner && row < outer)) continue;
      for (int i = 1; i <= kLooksPerRow; ++i)
        radii.push_back(before + (row - before) * i / kLooksPerRow);
      before = row;
    }
    for (int i = 1; i < kLooksPerRow; ++i)
      radii.push_back(before + (outer - before) * i / kLooksPerRow);
  }
  radii.push_back(outer);
  std::vector<double> turns;
  for (std::size_t k = 1; k < radii.size(); ++k) {
    for (const double versine : {kLiftOff, kFull}) {
      const auto slope = [&](double radius) { return clearance_slope(m, radius, versine); };
      if (slope(radii[k - 1]) * slope(radii[k]) < 0)
        turns.push_back(zero_between(slope, radii[k - 1], radii[k]));
    }
  }
  radii.insert(radii.end(), turns.begin(), turns.end());
  std::sort(radii.begin(), radii.end());
  return radii;
}

// ---- pieces of the track and their nodes --------------------------------------------------------

/// A stretch of the track that touches. theta_L leaves 0 or pi like a square root where a partial contact begins or ends.
template <typename R>
struct Piece {
  R low, high;
  bool root_low, root_high;
};

// The zero of a clearance, with derivatives by the implicit function theorem.
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

// What the normal contact takes of a motor, without its derivatives.
template <typename S>
DrivenMotor<double> values_of(const DrivenMotor<S>& m) {
  DrivenMotor<double> v;
  v.r = value_of(m.r), v.b = value_of(m.b), v.preload = value_of(m.preload);
  v.youngs = value_of(m.youngs), v.thickness = value_of(m.thickness);
  v.exponent = value_of(m.exponent), v.root = value_of(m.root), v.slope = value_of(m.slope);
  v.amplitude = value_of(m.amplitude), v.peak = value_of(m.peak), v.track = m.track;
  return v;
}

/// The track of a motor: what does not depend on the rotor's position.
template <typename S>
class Track {
 public:
  explicit Track(const DrivenMotor<S>& motor)
      : m_(motor), values_(values_of(motor)), looks_(looks(values_)) {}

  /// Least indentation at which nothing touches [m].
  double lift_off() const {
    double most = -std::numeric_limits<double>::infinity();
    for (const double radius : looks_) most = std::max(most, crest_rise(values_, radius));
    return -most;
  }

  /// Calls visit(radius, width) at each of the nodes of the pieces that touch.
  template <typename R, typename Visit>
  void for_each_node(int nodes, const R& indentation, Visit visit) const {
    const GaussRule& rule = gauss_rule(nodes);
    for (const Piece<R>& piece : pieces(indentation)) {
      const R length = piece.high - piece.low;
      for (const GaussRule::Node& node : rule.nodes) {
        const auto [place, weight] = substituted(piece.root_low, piece.root_high, node);
        visit(R(piece.low + length * place), R(length * weight));
      }
    }
  }

  /// The preload that an indentation takes (W2.3) [N].
  template <typename R>
  R axial_force(const R& indentation) const {
    R force(0.0);
    for_each_node(std::max(m_.track.nodes, kLeastNodes), indentation, [&](const R& radius, const R& width) {
      const R excess = shape_excess(m_, radius);
      const R amplitude = m_.amplitude * (1.0 + excess);
      const R crest = indentation + m_.amplitude * excess - (radius - m_.r) * m_.slope;
      force += 2.0 * radius * width * (m_.youngs / m_.thickness) * amplitude *
               contact::load_of_peak(R(crest / amplitude));
    });
    return force;
  }

 private:
  // A Gauss node on 0 .. 1 moved so that square roots at the ends become smooth (W4.1).
  static GaussRule::Node substituted(bool low, bool high, const GaussRule::Node& node) {
    const double u = node.place, v = 1 - u;
    if (low && high) return {u * u * (3 - 2 * u), 6 * u * v * node.weight};
    if (low) return {u * u, 2 * u * node.weight};
    if (high) return {1 - v * v, 2 * v * node.weight};
    return node;
  }

  template <typename R>
  std::vector<Piece<R>> pieces(const R& indentation) const {
    const double depth = value_of(indentation);
    std::vector<R> ends{R(m_.r - 0.5 * m_.b)};
    for (std::size_t k = 1; k < looks_.size(); ++k) {
      std::vector<R> breaks;
      for (const double versine : {kLiftOff, kFull}) {
        const auto gap = [&](double radius) { return clearance(values_, radius, depth, versine); };
        if (gap(looks_[k - 1]) * gap(looks_[k]) < 0)
          breaks.push_back(break_radius(
              m_, values_, zero_between(gap, looks_[k - 1], looks_[k]), indentation, versine));
      }
      if (breaks.size() == 2 && value_of(breaks[1]) < value_of(breaks[0]))
        std::swap(breaks[0], breaks[1]);
      ends.insert(ends.end(), breaks.begin(), breaks.end());
    }
    ends.push_back(R(m_.r + 0.5 * m_.b));
    std::vector<Piece<R>> touching;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double middle = 0.5 * (value_of(ends[k - 1]) + value_of(ends[k]));
      if (!(clearance(values_, middle, depth, kLiftOff) > 0)) continue;
      const bool partial = clearance(values_, middle, depth, kFull) < 0;
      touching.push_back(
          {ends[k - 1], ends[k], partial && k > 1, partial && k + 1 < ends.size()});
    }
    return touching;
  }

  const DrivenMotor<S>& m_;
  DrivenMotor<double> values_;
  std::vector<double> looks_;
};

// ---- the rotor's position -----------------------------------------------------------------------

constexpr int kMostSteps = 200;

// The indentation that carries the preload, by Newton's method in a bracket: the force rises strictly and is convex but for
// full contact, where it is linear.
double indentation_of(const DrivenMotor<double>& m) {
  const Track<double> track(m);
  const double stiffness = 2 * kPi * m.r * m.b * m.youngs / m.thickness;
  double low = track.lift_off();
  // In full contact the mean indentation tells the force; elsewhere the layer only pushes more.
  double high = std::max(low, m.amplitude + m.preload / stiffness + m.slope * m.b * m.b / (12 * m.r));
  while (track.axial_force(high) < m.preload) high += (high - low) + m.preload / stiffness;
  double depth = std::clamp(m.amplitude * m.peak, low, high);
  for (int i = 0; i < kMostSteps; ++i) {
    const RadiusDual force = track.axial_force(RadiusDual::variable(depth, 0));
    if (force.v == m.preload) break;
    (force.v < m.preload ? low : high) = depth;
    const double step = -(force.v - m.preload) / force.d[0];
    if (std::fabs(step) <= 1e-16 * std::fabs(depth)) break;  // less than rounding of the depth
    const double next = depth + step;
    depth = next > low && next < high ? next : 0.5 * (low + high);
    if (!(low < depth && depth < high)) break;
  }
  return depth;
}

// The same in S, its derivatives by the implicit function theorem (W2.3).
template <typename S>
S indentation_in(const DrivenMotor<S>& m) {
  const DrivenMotor<double> values = values_of(m);
  const double depth = indentation_of(values);
  S result(depth);
  if constexpr (kDualDepth<S> > 0) {
    const Track<S> track(m);
    const double slope =
        Track<double>(values).axial_force(RadiusDual::variable(depth, 0)).d[0];
    for (int i = 0; i < kDualDepth<S>; ++i) {
      const S excess = track.axial_force(result) - m.preload;
      result = with_value(S(result - with_value(excess, 0.0) / slope), depth);
    }
  }
  return result;
}

// Without a wave the rotor presses a layer whose indentation falls linearly along the radius, by `fall` per length: on all of
// the track, or on `length` from one edge (W3.6).
template <typename S>
struct Pressed {
  S lever, indentation;
};
template <typename S>
Pressed<S> pressed_without_wave(const DrivenMotor<S>& m) {
  const S moment = m.preload * m.thickness / (2 * kPi * m.youngs);  // of the indentation, about the axis
  const S depth = moment / (m.r * m.b) + m.slope * m.b * m.b / (12.0 * m.r);
  if (!(value_of(depth) < 0.5 * std::fabs(value_of(m.slope)) * value_of(m.b)))
    return {S((depth * m.b * (m.r * m.r + m.b * m.b / 12.0) -
               m.slope * m.r * m.b * m.b * m.b / 6.0) /
              moment),
            depth};
  const double side = value_of(m.slope) > 0 ? 1 : -1;
  const S fall = side * m.slope, edge = m.r - (0.5 * side) * m.b, wanted = moment / fall;
  using std::sqrt;
  S length = sqrt(S(2.0 * wanted / edge));
  for (int i = 0; i < kMostSteps; ++i) {
    const S excess = length * length * (0.5 * edge + (side / 6) * length) - wanted;
    const S step = excess / (length * (edge + (0.5 * side) * length));
    length = length - step;
    if (i > 3 && std::fabs(value_of(step)) <= 1e-15 * value_of(length)) break;
  }
  return {S(length * length *
            (0.5 * edge * edge + (side / 3) * edge * length + length * length / 12.0) / wanted),
          S(fall * (length - 0.5 * m.b))};
}

// Normal contact of a crest `depth` deep in the layer (W2.2).
template <typename S>
NormalContact<S> contact_of(const DrivenMotor<S>& m, const S& kappa, const S& amplitude,
                            const S& depth) {
  NormalContact<S> c;
  c.pressure_amplitude = m.youngs * amplitude / m.thickness;
  const S peak = depth / amplitude;
  c.full = !(value_of(peak) < 2);
  c.half_angle = contact::contact_angle_of(peak);
  c.edge_cosine = value_of(peak) > 0 ? S(1.0 - peak) : S(1.0);
  c.load_ratio = contact::load_of_peak(peak) / kPi;
  c.max_pressure = value_of(peak) > 0 ? S(m.youngs * depth / m.thickness) : S(0.0);
  c.half_length = c.half_angle / kappa;
  c.ratio = c.half_angle / (2 * kPi);
  return c;
}

// The same without a wave.
template <typename S>
NormalContact<S> flat_contact(const DrivenMotor<S>& m, const S& depth) {
  NormalContact<S> c = m.contact;
  c.full = value_of(depth) > 0;
  c.half_angle = S(c.full ? kPi : 0.0);
  c.max_pressure = c.full ? S(m.youngs * depth / m.thickness) : S(0.0);
  return c;
}

// <p> [Pa]
template <typename S>
S mean_pressure(const NormalContact<S>& c) {
  const bool flat = value_of(c.pressure_amplitude) == 0;
  return flat ? c.max_pressure : S(c.pressure_amplitude * c.load_ratio);
}

// Radius in S: an edge moves with the track; elsewhere the radius of a maximum may be held fixed.
template <typename S>
S radius_in(const DrivenMotor<S>& m, double radius) {
  const S inner = m.r - 0.5 * m.b, outer = m.r + 0.5 * m.b;
  if (radius == value_of(inner)) return inner;
  return radius == value_of(outer) ? outer : S(radius);
}

double mean_pressure_at(const DrivenMotor<double>& m, double radius) {
  return mean_pressure(slice_at(m, radius, 0.0).contact);
}

// Radius of the largest pressure averaged over a wave.
double most_pressed_radius(const DrivenMotor<double>& m) {
  constexpr int kLooks = 64;
  const auto at = [&](int i) { return i == kLooks ? m.r + 0.5 * m.b : m.r - 0.5 * m.b + m.b * i / kLooks; };
  int top = 0;
  for (int i = 1; i <= kLooks; ++i)
    if (mean_pressure_at(m, at(i)) > mean_pressure_at(m, at(top))) top = i;
  if (top == 0 || top == kLooks) return at(top);
  const auto less = [&](double radius) { return -mean_pressure_at(m, radius); };
  return boost::math::tools::brent_find_minima(less, at(top - 1), at(top + 1), 26).first;
}

}  // namespace

template <typename S>
Slice<S> slice_at(const DrivenMotor<S>& m, const S& radius, const S& width) {
  if (m.track.nodes == 1) return m;
  Slice<S> s;
  s.radius = radius, s.width = width;
  s.shape = 1.0 + shape_excess(m, radius);
  s.amplitude = m.amplitude * s.shape;
  s.crest_velocity = m.tilt * m.r / radius * s.amplitude * m.omega;
  const S depth = m.indentation + crest_rise(m, radius);
  s.contact = value_of(m.amplitude) == 0 ? flat_contact(m, depth)
                                         : contact_of(m, S(m.n / radius), s.amplitude, depth);
  s.load = 2 * kPi * radius * width * mean_pressure(s.contact), s.share = S(1.0);
  return completed<S>(s, m);
}

template <typename S>
DrivenMotor<S> over_annulus(DrivenMotor<S> m) {
  if (value_of(m.preload) == 0 || value_of(m.contact.half_angle) == 0) return m;
  const Pressed<S> flat = pressed_without_wave(m);
  m.lever = m.holding_lever = flat.lever, m.indentation = flat.indentation;
  if (value_of(m.amplitude) == 0) return m;
  m.indentation = indentation_in(m);
  static_cast<Slice<S>&>(m) = slice_at(m, m.r, m.b);
  std::vector<Slice<S>> slices;
  S load(0.0), area(0.0), moment(0.0);
  Track<S>(m).for_each_node(
      m.track.nodes, m.indentation, [&](const S& radius, const S& width) {
        Slice<S> slice = slice_at(m, radius, width);
        if (!(value_of(slice.contact.half_angle) > 0)) return;  // within rounding of lift-off
        load += slice.load;
        area += slice.contact.half_angle * radius * width;
        slices.push_back(std::move(slice));
      });
  const S factor = m.preload / load;  // (W4.3)
  for (Slice<S>& s : slices) {
    s.share = s.contact.half_angle * s.radius * s.width / area;
    s.width = factor * s.width, s.load = factor * s.load;
    s.pressure_force = factor * s.pressure_force;
    moment += s.load * s.radius;
  }
  m.annulus = std::move(slices);
  for (const S& radius : {S(m.r - 0.5 * m.b), S(m.r + 0.5 * m.b)}) {
    Slice<S> edge = slice_at(m, radius, m.b);
    if (value_of(edge.contact.half_angle) > 0) m.edges.push_back(std::move(edge));
  }
  m.lever = moment / m.preload;
  return m;
}

template <typename S>
S largest_pressure(const DrivenMotor<S>& m) {
  if (m.annulus.empty()) return m.contact.max_pressure;
  const DrivenMotor<double> values = values_of(m);
  const std::vector<double> radii = looks(values);
  const double top = *std::max_element(radii.begin(), radii.end(), [&](double a, double b) {
    return crest_rise(values, a) < crest_rise(values, b);
  });
  return m.youngs / m.thickness * (m.indentation + crest_rise(m, radius_in(m, top)));
}

template <typename S>
S pressure_nonuniformity(const DrivenMotor<S>& m) {
  if (m.annulus.empty()) return S(1.0);
  DrivenMotor<double> values = values_of(m);
  values.indentation = value_of(m.indentation), values.n = value_of(m.n);
  values.tilt = values.omega = values.shear = 1;  // what does not act on the normal contact
  const double radius = most_pressed_radius(values);
  return mean_pressure(slice_at(m, radius_in(m, radius), m.b).contact) * track_area(m) / m.preload;
}

#define TWUM_INSTANTIATE(S, R)                                          \
  template Slice<S> slice_at(const DrivenMotor<S>&, const S&, const S&); \
  template DrivenMotor<S> over_annulus(DrivenMotor<S>);                 \
  template S largest_pressure(const DrivenMotor<S>&);                   \
  template S pressure_nonuniformity(const DrivenMotor<S>&);
TWUM_FOR_EACH_MODEL_SCALAR(TWUM_INSTANTIATE)
TWUM_INSTANTIATE(contact::SpeedDual, contact::SpeedDual)
#undef TWUM_INSTANTIATE

}  // namespace twum::performance
