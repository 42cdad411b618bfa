// SPDX-License-Identifier: Apache-2.0
// The normal contact over the annulus: where the rotor stands, and the slices there.
#include "model/track.hpp"

#include "model/track_pieces.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <numbers>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

using std::numbers::pi;

using RadiusDual = Dual<double, 1>;

constexpr int kMostNewtonSteps = 200;
// of the distance from lift-off. After a step of this length the error is rounding: Newton's method leaves a quarter of the
// square, and 1e-5 of the step remains because the slope takes the nodes as fixed
constexpr double kLastStep = 1e-11;
constexpr double kQuadrature = 1e-6;  // of the force, more than its nodes leave

// The indentation that carries the preload, by Newton's method in a bracket: the force rises strictly and is convex but for
// full contact, where it is linear.
double indentation_of(const Track<double>& track) {
  const DrivenMotor<double>& m = track.values();
  const double lift_off = track.lift_off();
  const double rigid = m.preload * m.thickness / (2 * pi * m.r * m.b * m.youngs);
  // In full contact the mean indentation tells the force; elsewhere the layer only pushes more.
  const double most =
      std::max(lift_off, m.mean.amplitude + rigid + m.slope * m.b * m.b / (12 * m.r)) +
      (worn_track(m) ? worn_track(m)->spread() : 0);
  double low = lift_off, high = most + kQuadrature * (most - lift_off + rigid);
  double depth = std::clamp(m.mean.amplitude * m.mean.peak, low, high);
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    const auto [force, slope] = track.force_and_slope(depth);
    const double step = (m.preload - force) / slope;
    if (std::fabs(step) <= kLastStep * (depth - lift_off)) return depth + step;
    (force < m.preload ? low : high) = depth;
    const double next = depth + step;
    depth = next > low && next < high ? next : 0.5 * (low + high);
    if (!(low < depth && depth < high)) break;
  }
  return depth;
}

// The same in S, its derivatives by the implicit function theorem (W2.3).
template <typename S>
S indentation_in(const Track<S>& track, const S& preload) {
  if constexpr (kDualDepth<S> == 0) {
    return indentation_of(track);
  } else {
    const Track<double> values(track.values());
    const double depth = indentation_of(values);
    const double slope = values.axial_force(RadiusDual::variable(depth, 0)).d[0];
    S result(depth);
    for (int i = 0; i < kDualDepth<S>; ++i) {
      const S excess = track.axial_force(result) - preload;
      result = with_value(S(result - with_value(excess, 0.0) / slope), depth);
    }
    return result;
  }
}

// Without a wave the rotor presses a layer whose indentation falls linearly along the radius, by `fall` per length: on all of
// the track, or on `length` from one edge (W3.6).
template <typename S>
struct Pressed {
  S lever, indentation;
};

// The same of an uneven track, on its nodes. The force is piecewise linear and convex in the indentation: from above, where all
// nodes touch, Newton's method lets go of one node after the other.
template <typename S>
Pressed<S> pressed_on_nodes(const DrivenMotor<S>& m) {
  struct Node {
    S radius, stiffness, rise;
  };
  Vector<Node> nodes;
  const Piece<S> track{S(m.r - 0.5 * m.b), S(m.r + 0.5 * m.b), false, false};
  for_each_node(track, m.track.nodes, [&](const S& radius, const S& width) {
    nodes.push_back({radius, 2 * pi * radius * width * m.youngs / thickness_at(m, radius),
                     (m.r - radius) * m.slope - worn_beyond_mean(m, radius)});
  });
  S indentation(std::numeric_limits<double>::infinity()), moment(0.0);
  for (std::size_t touching = 0, before = nodes.size() + 1; touching != before;) {
    before = touching, touching = 0;
    S stiffness(0.0), missing = m.preload;
    moment = S(0.0);
    for (const Node& node : nodes) {
      if (!(value_of(indentation) + value_of(node.rise) > 0)) continue;
      ++touching;
      stiffness += node.stiffness, missing -= node.stiffness * node.rise;
    }
    indentation = missing / stiffness;
    for (const Node& node : nodes)
      if (value_of(indentation) + value_of(node.rise) > 0)
        moment += node.stiffness * (indentation + node.rise) * node.radius;
  }
  return {S(moment / m.preload), indentation};
}

template <typename S>
Pressed<S> pressed_without_wave(const DrivenMotor<S>& m) {
  if (worn_track(m)) return pressed_on_nodes(m);
  const S moment =
      m.preload * m.thickness / (2 * pi * m.youngs);  // of the indentation, about the axis
  const S depth = moment / (m.r * m.b) + m.slope * m.b * m.b / (12.0 * m.r);
  if (!(value_of(depth) < 0.5 * std::fabs(value_of(m.slope)) * value_of(m.b)))
    return {
        S((depth * m.b * (m.r * m.r + m.b * m.b / 12.0) - m.slope * m.r * m.b * m.b * m.b / 6.0) /
          moment),
        depth};
  const double side = value_of(m.slope) > 0 ? 1 : -1;
  const S fall = side * m.slope, edge = m.r - (0.5 * side) * m.b, wanted = moment / fall;
  using std::sqrt;
  S length = sqrt(S(2.0 * wanted / edge));
  for (int i = 0; i < kMostNewtonSteps; ++i) {
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
EdgedContact<S> contact_of(const DrivenMotor<S>& m, const S& kappa, const S& amplitude,
                           const S& depth, const S& thickness) {
  NormalContact<S> c;
  c.pressure_amplitude = m.youngs * amplitude / thickness;
  const S peak = depth / amplitude;
  const contact::CrestContact<S> crest = contact::crest_contact(peak);
  c.full = !(value_of(peak) < 2);
  c.half_angle = crest.angle;
  c.edge_cosine = value_of(peak) > 0 ? S(1.0 - peak) : S(1.0);
  c.load_ratio = crest.load / pi;
  c.max_pressure = value_of(peak) > 0 ? S(m.youngs * depth / thickness) : S(0.0);
  c.half_length = c.half_angle / kappa;
  c.ratio = c.half_angle / (2 * pi);
  return {c, crest.edge};
}

// The same without a wave.
template <typename S>
EdgedContact<S> flat_contact(const DrivenMotor<S>& m, const S& depth, const S& thickness) {
  NormalContact<S> c = m.mean.contact;
  c.full = value_of(depth) > 0;
  c.half_angle = S(c.full ? pi : 0.0);
  c.max_pressure = c.full ? S(m.youngs * depth / thickness) : S(0.0);
  return {c, {S(0.0), S(c.full ? -1.0 : 1.0), S(c.full ? 2.0 : 0.0)}};
}

// <p> [Pa]
template <typename S>
S mean_pressure(const NormalContact<S>& c) {
  const bool flat = value_of(c.pressure_amplitude) == 0;
  return flat ? c.max_pressure : S(c.pressure_amplitude * c.load_ratio);
}

// The largest value that a number of the contact has at a node.
template <typename S, typename Number>
S largest_of_nodes(const DrivenMotor<S>& m, Number number) {
  S most = number(m.annulus.front().contact);
  for (const Slice<S>& s : m.annulus) {
    const S here = number(s.contact);
    if (value_of(here) > value_of(most)) most = here;
  }
  return most;
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
  const auto at = [&](int i) {
    return i == kLooks ? m.r + 0.5 * m.b : m.r - 0.5 * m.b + m.b * i / kLooks;
  };
  int top = 0;
  for (int i = 1; i <= kLooks; ++i)
    if (mean_pressure_at(m, at(i)) > mean_pressure_at(m, at(top))) top = i;
  if (top == 0 || top == kLooks) return at(top);
  const auto less = [&](double radius) { return -mean_pressure_at(m, radius); };
  return least_between("the highest place of the track", less, at(top - 1), at(top + 1)).place;
}

}  // namespace

template <typename S>
S radial_ratio(const MotorModel<S>& m, const S& radius) {
  if constexpr (!contact::kHasRadialMotion) return S(0.0);
  return radius / m.n * shape_slope(m, radius);
}

template <typename S>
Slice<S> slice_at(const DrivenMotor<S>& m, const S& radius, const S& width) {
  if (m.track.nodes == 1) return m.mean;
  Slice<S> s;
  s.radius = radius, s.width = width;
  s.shape = 1.0 + shape_excess(m, radius);
  s.amplitude = m.mean.amplitude * s.shape;
  s.crest_velocity = m.tilt * m.r / radius * s.amplitude * m.omega;
  const S depth = m.indentation + crest_rise(m, radius);
  const auto& thickness = thickness_at(m, radius);
  const EdgedContact<S> c = value_of(m.mean.amplitude) == 0
                                ? flat_contact(m, depth, thickness)
                                : contact_of(m, S(m.n / radius), s.amplitude, depth, thickness);
  s.contact = c.contact, s.edge = c.edge;
  if (contact::kHasRadialMotion && m.track.radial) s.radial = radial_ratio<S>(m, radius);
  s.load = 2 * pi * radius * width * mean_pressure(s.contact), s.share = S(1.0);
  complete<S>(s, m);
  return s;
}

namespace {

// A piece cut at its splits. What follows from the zones is not smooth there: its powers have a root in the distance, as at
// the ends of a contact.
template <typename S>
Vector<Piece<S>> panels_of(const Piece<S>& piece, std::size_t index,
                           std::span<const SplitPlace<S>> splits) {
  const S length = piece.high - piece.low;
  Vector<Piece<S>> panels;
  Piece<S> rest = piece;
  for (const SplitPlace<S>& split : splits) {
    if (split.piece != index) continue;
    const S end = piece.low + split.place * length;
    panels.push_back({rest.low, end, rest.root_low, true, rest.gap});
    rest.low = end, rest.root_low = true, rest.gap = split.gap * value_of(length);
  }
  panels.push_back(rest);
  return panels;
}

}  // namespace

template <typename S>
Vector<Slice<S>> annulus_of(const DrivenMotor<S>& m, std::span<const SplitPlace<S>> splits) {
  Vector<Slice<S>> slices;
  slices.reserve((m.pieces.size() + splits.size()) * static_cast<std::size_t>(m.track.nodes));
  S load(0.0), area(0.0);
  const auto add = [&](const S& radius, const S& width) {
    Slice<S> slice = slice_at(m, radius, width);
    if (!(value_of(slice.contact.half_angle) > 0)) return;  // within rounding of lift-off
    load += slice.load;
    area += slice.contact.half_angle * radius * width;
    slices.push_back(std::move(slice));
  };
  for (std::size_t k = 0; k < m.pieces.size(); ++k)
    for (const Piece<S>& panel : panels_of(m.pieces[k], k, splits))
      for_each_node(panel, m.track.nodes, add);
  const S factor = m.preload / load;  // (W4.3)
  for (Slice<S>& s : slices) {
    s.share = s.contact.half_angle * s.radius * s.width / area;
    s.width = factor * s.width, s.load = factor * s.load;
    s.pressure_force = factor * s.pressure_force;
    s.torque_scale = factor * s.torque_scale, s.power_scale = factor * s.power_scale;
    s.force_scale = factor * s.force_scale;
  }
  return slices;
}

template <typename S>
DrivenMotor<S> over_annulus(DrivenMotor<S> m) {
  if (value_of(m.preload) == 0 || value_of(m.mean.contact.half_angle) == 0) return m;
  const Pressed<S> flat = pressed_without_wave(m);
  m.lever = m.holding_lever = flat.lever, m.indentation = flat.indentation;
  if (value_of(m.mean.amplitude) == 0) return m;
  const Track<S> track(m);
  m.indentation = indentation_in(track, m.preload);
  m.pieces = track.pieces(m.indentation);
  m.mean = slice_at(m, m.r, m.b);
  m.annulus = annulus_of<S>(m, {});
  m.lever = lever_of<S>(m.annulus, m.preload);
  return m;
}

template <typename S>
Vector<Slice<S>> edges_of(const DrivenMotor<S>& m) {
  Vector<Slice<S>> edges;
  if (m.annulus.empty()) return edges;
  for (const S& radius : {S(m.r - 0.5 * m.b), S(m.r + 0.5 * m.b)}) {
    Slice<S> edge = slice_at(m, radius, m.b);
    if (value_of(edge.contact.half_angle) > 0) edges.push_back(std::move(edge));
  }
  return edges;
}

template <typename S>
S largest_pressure(const DrivenMotor<S>& m) {
  if (m.annulus.empty()) return m.mean.contact.max_pressure;
  if (worn_track(m))
    return largest_of_nodes(m, [](const NormalContact<S>& c) { return c.max_pressure; });
  const DrivenMotor<double> values = values_of(m);
  const Vector<double> radii = radii_between_turns(values);
  const double top = *std::max_element(radii.begin(), radii.end(), [&](double a, double b) {
    return crest_rise(values, a) < crest_rise(values, b);
  });
  return m.youngs / m.thickness * (m.indentation + crest_rise(m, radius_in(m, top)));
}

template <typename S>
S pressure_nonuniformity(const DrivenMotor<S>& m) {
  if (m.annulus.empty()) return S(1.0);
  if (worn_track(m)) return largest_of_nodes(m, mean_pressure<S>) * track_area(m) / m.preload;
  DrivenMotor<double> values = values_of(m);
  values.indentation = value_of(m.indentation), values.n = value_of(m.n);
  values.tilt = values.omega = values.shear = 1;  // what does not act on the normal contact
  const double radius = most_pressed_radius(values);
  return mean_pressure(slice_at(m, radius_in(m, radius), m.b).contact) * track_area(m) / m.preload;
}

#define TWUM_INSTANTIATE(S, R)                                                                 \
  template S radial_ratio(const MotorModel<S>&, const S&);                                     \
  template Slice<S> slice_at(const DrivenMotor<S>&, const S&, const S&);                       \
  template Vector<Slice<S>> annulus_of(const DrivenMotor<S>&, std::span<const SplitPlace<S>>); \
  template DrivenMotor<S> over_annulus(DrivenMotor<S>);                                        \
  template Vector<Slice<S>> edges_of(const DrivenMotor<S>&);                                   \
  template S largest_pressure(const DrivenMotor<S>&);                                          \
  template S pressure_nonuniformity(const DrivenMotor<S>&);
TWUM_FOR_EACH_MODEL_SCALAR(TWUM_INSTANTIATE)
TWUM_INSTANTIATE(contact::MotionDual, contact::MotionDual)
#undef TWUM_INSTANTIATE

}  // namespace twum::inline v0_1::core
