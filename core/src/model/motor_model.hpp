// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"
#include "contact/jump.hpp"
#include "design/radial_shape.hpp"
#include "design/workspace.hpp"
#include "model/scalars.hpp"
#include "model/worn_track.hpp"

#include <twum/base/dual.hpp>
#include <twum/core/normal_contact.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace twum::inline v0_1::core {

/// A value for each of kModelParameters, in their order, and for what more there is of a shape.
template <typename S>
using ModelArray = std::array<S, kModelNumbers>;

/// Radial slices of a track and their shape: what a design says of them without a derivative.
struct TrackRule {
  int nodes{1};                                ///< of each panel; 1: all at the contact radius
  std::shared_ptr<const ShapeSpline> table{};  ///< of the radial shape; null: exponent and root
  bool mode{false};                            ///< the shape is a mode of the plate
  bool splits{false};  ///< panels end where zones appear, too (W4.4); else a panel is a piece
  bool radial{false};  ///< the surface moves radially, too
  bool settled{
      true};  ///< more nodes would change nothing; false where `auto` has given up the search for so many
#ifndef __wasm__                            // see worn_track()
  std::shared_ptr<const WornTrack> worn{};  ///< null: the track is even
#endif
};

/// A stretch of the track that touches. theta_L leaves 0 or pi like a square root where a partial contact begins or ends.
template <typename S>
struct Piece {
  S low, high;
  bool root_low, root_high;
  double gap{0};  ///< no slice stands so close to the lower end [m]
};

/// Where a piece is split into panels, in parts of its length.
template <typename S>
struct SplitPlace {
  std::size_t piece;
  S place;
  double gap{0};  ///< no slice is to stand so close beyond it, as it would have no answer
};
/// The same with the jump of the means that is there, if there is one: the split moves with it.
struct Split : SplitPlace<double> {
  std::optional<contact::Jump> jump{};
};

/// The splits where they are, as if none moved.
inline Vector<SplitPlace<double>> fixed_places(std::span<const Split> splits) {
  return {splits.begin(), splits.end()};
}

/// What a design says to the contact model, whatever wave drives it (theory sections 1 and 2).
template <typename S>
struct MotorModel {
  S n, r, b, kappa;
  S tilt;  ///< kappa a, slope of the surface per amplitude of the wave
  S youngs, thickness, shear, viscosity, inertia;
  S kinetic, threshold, preload, stator_damping;
  /// Exponent and root (W1.3), or the coefficients of a mode's polynomial, from that of x on (P8.1).
  std::array<S, kShapeNumbers> shape_numbers;
  S slope;       ///< tan(taper) of the rotor's face
  S compliance;  ///< 1 / G
  TrackRule track;
};

/// Depths of an uneven track, else null. The page takes all tracks as even, which keeps it small.
template <typename S>
const WornTrack* worn_track(const MotorModel<S>& m) {
#ifdef __wasm__
  return nullptr;
#else
  return m.track.worn.get();
#endif
}

/// Depth worn off a radius beyond the mean (V3.1) [m]. The nodes stay with the material: it has no slope along the radius.
template <typename S, typename R>
double worn_beyond_mean(const MotorModel<S>& m, const R& radius) {
  const WornTrack* worn = worn_track(m);
  if (!worn) return 0;
  return worn->at((value_of(radius) - value_of(m.r)) / value_of(m.b) + 0.5);
}

/// h of the layer at a radius (V3.1) [m].
#ifdef __wasm__
template <typename S, typename R>
const S& thickness_at(const MotorModel<S>& m, const R& /*radius*/) {
  return m.thickness;
}
#else
template <typename S, typename R>
S thickness_at(const MotorModel<S>& m, const R& radius) {
  const WornTrack* worn = worn_track(m);
  if (!worn) return m.thickness;
  return m.thickness - worn->thickness_share * worn_beyond_mean(m, radius);
}
#endif

/// mu_0 > mu: released at once, the traction jumps.
template <typename S>
bool has_static_excess(const MotorModel<S>& m) {
  return value_of(m.threshold) > value_of(m.kinetic);
}

/// The torque may jump over speed and parameters: each slice jumps at its own speed. If the track is split at the jumps (W4.5),
/// their sum is continuous.
template <typename S>
bool may_jump(const MotorModel<S>& m) {
  return has_static_excess(m) && !m.track.splits;
}

/// The wave prescribed at an operating point, beside the design.
template <typename S>
struct Wave {
  S amplitude;  ///< A [m]
  S omega;      ///< [rad/s]
};

/// The contact at one radius of the track (W1.1, W1.2).
template <typename S>
struct Slice {
  S radius, width;   ///< rho and drho [m]
  S shape;           ///< R(rho) [1]
  S amplitude;       ///< A R(rho) [m]
  S crest_velocity;  ///< V0 = kappa a A R omega (T2.2)
  S load;            ///< its part of F_N [N]
  S share;           ///< its part of the area in contact [1]
  NormalContact<S> contact;
  S stick_gain;           ///< G V0 / (h P), s W of (E1.1)
  S peak;                 ///< p(0) / P = 1 - c
  contact::Trig<S> edge;  ///< of theta_L
  S pressure_force;       ///< of the contact on the wave, Re F_n (D1.3, D1.4) [N]
  S torque_scale;         ///< torque of one unit of mean traction, 2 pi r^2 b P (T4.5) [N m]
  /// Power of one unit of the contact's mean powers, 2 pi r b P V0 [W]; the largest that can occur is the scale of powers
  /// (T7.11).
  S power_scale;
  /// Force on the wave of one unit of the mean <t sin theta>, 2 pi r b kappa a P (D1.6), at the mean radius (W3.4) [N].
  S force_scale;
  S radial{
      0.0};  ///< q, radial motion of the surface per tangential one (R1.1); 0 where it is left out
};

/// A motor under a wave (theory section 3).
template <typename S>
struct DrivenMotor : MotorModel<S> {
  Slice<S> mean;  ///< the contact at the mean radius
  S omega;
  S lever;  ///< mean radius of the preload: mu F_N lever is the torque of a contact that slips all through
  S holding_lever;           ///< the same without a wave
  S indentation;             ///< of the layer by the crest at the mean radius (W2.1) [m]
  Vector<Piece<S>> pieces;   ///< of the track, that touch
  Vector<Slice<S>> annulus;  ///< nodes of the pieces; empty: all at the mean radius

  /// What the motor's numbers are sums over.
  std::span<const Slice<S>> slices() const {
    return annulus.empty() ? std::span(&mean, 1) : std::span(annulus);
  }
};

/// theta_L (T3.2) with its sine, cosine and versine, which the tangential contact takes, too.
template <typename S>
struct ContactEdge {
  S angle;
  contact::Trig<S> at;
};

/// @param known  the angle, if it is known; else it is solved for
inline ContactEdge<double> contact_edge(double load, std::optional<double> known) {
  const double angle = known ? *known : contact_half_angle(load);
  return {angle, contact::trig(angle)};
}
/// Derivatives by the implicit function theorem.
template <typename T, int N>
ContactEdge<Dual<T, N>> contact_edge(const Dual<T, N>& load, std::optional<double> known) {
  const ContactEdge<T> edge = contact_edge(load.v, known);
  const T slope = value_of(edge.angle) > 0 ? T(1.0 / (edge.angle * edge.at.sin)) : T(0.0);
  const Dual<T, N> angle = twum::detail::chain(load, edge.angle, slope);
  return {angle, contact::trig_near(angle, edge.at)};
}

/// A normal contact, and sine, cosine and versine of its edge.
template <typename S>
struct EdgedContact {
  NormalContact<S> contact;
  contact::Trig<S> edge;
};

/// Normal contact of a wave pressed by `preload` (T3.1, T3.2, T3.4), full contact included (T3.3).
/// @param half_angle  of a partial contact, if it is known
template <typename S>
EdgedContact<S> normal_contact(const S& preload, const S& n, const S& b, const S& kappa,
                               const S& pressure_amplitude, std::optional<double> half_angle) {
  constexpr double kPi = std::numbers::pi;
  const S mean_pressure = preload * kappa / (2 * kPi * n * b);
  EdgedContact<S> result{{}, {S(0.0), S(-1.0), S(2.0)}};
  auto& [c, edge] = result;
  c.pressure_amplitude = pressure_amplitude;
  c.load_ratio = mean_pressure / pressure_amplitude;
  c.full = !(value_of(mean_pressure) < value_of(pressure_amplitude));
  if (c.full) {
    c.half_angle = S(kPi);
    c.edge_cosine = -c.load_ratio;
    c.max_pressure = pressure_amplitude + mean_pressure;
  } else {
    const ContactEdge<S> found =
        contact_edge(S(kPi * mean_pressure / pressure_amplitude), half_angle);
    c.half_angle = found.angle, edge = found.at;
    c.edge_cosine = edge.cos;
    c.max_pressure = pressure_amplitude * edge.versine;
  }
  c.half_length = c.half_angle / kappa;
  c.ratio = c.half_angle / (2 * kPi);
  return result;
}

/// Coefficients of l_k(x) of (P8.1), from that of x on.
constexpr std::array<double, kShapeNumbers> shape_basis(std::size_t k) {
  std::array<double, kShapeNumbers> c{1 / kShapePoints[k]};
  for (std::size_t j = 0, degree = 1; j < kShapeNumbers; ++j) {
    if (j == k) continue;
    const double scale = 1 / (kShapePoints[k] - kShapePoints[j]);
    for (std::size_t i = degree + 1; i-- > 0;)
      c[i] = scale * ((i > 0 ? c[i - 1] : 0) - kShapePoints[j] * (i < degree ? c[i] : 0));
    ++degree;
  }
  return c;
}

/// R - 1 of a mode as a polynomial, from its values at kShapePoints (P8.1).
template <typename S>
std::array<S, kShapeNumbers> mode_coefficients(const std::array<S, kShapeNumbers>& values) {
  std::array<S, kShapeNumbers> c;
  c.fill(S(0.0));
  for (std::size_t k = 0; k < kShapeNumbers; ++k)
    for (std::size_t i = 0; i < kShapeNumbers; ++i) c[i] += (values[k] - 1.0) * shape_basis(k)[i];
  return c;
}

/// The model behind values of kModelParameters.
template <typename S>
MotorModel<S> motor_model(const ModelArray<S>& p, const TrackRule& track = {}) {
  using P = Parameter;
  const auto at = [&p](P parameter) -> const S& { return p[model_index(parameter)]; };
  MotorModel<S> m;
  m.n = at(P::wavelengths), m.r = at(P::contact_radius), m.b = at(P::contact_width);
  m.kappa = m.n / m.r;  // (T1.1)
  m.tilt = m.kappa * at(P::neutral_plane_distance);
  m.youngs = at(P::youngs_modulus), m.thickness = at(P::thickness);
  m.shear = at(P::shear_modulus), m.viscosity = at(P::shear_viscosity);
  m.inertia = at(P::inertia);
  m.kinetic = at(P::kinetic_friction), m.threshold = at(P::static_friction);
  m.preload = at(P::preload), m.stator_damping = at(P::modal_damping);
  m.compliance = 1.0 / m.shear;
  using std::cos, std::sin;
  const S taper = at(P::rotor_taper);
  m.slope = sin(taper) / cos(taper);
  std::copy_n(p.begin() + kShapeIndex, kShapeNumbers, m.shape_numbers.begin());
  if (track.mode) m.shape_numbers = mode_coefficients(m.shape_numbers);
  m.track = track;
  return m;
}

/// The wave that a design is made for.
template <typename S>
Wave<S> design_wave(const ModelArray<S>& p) {
  return {p[model_index(Parameter::amplitude)],
          2 * std::numbers::pi * p[model_index(Parameter::frequency)]};
}

/// Re F_n (D1.3, D1.4) of a contact, on the wave at the mean radius (W3.4).
template <typename S>
S pressure_force(const Slice<S>& s) {
  const NormalContact<S>& c = s.contact;
  if (c.full) return s.shape * (std::numbers::pi * s.radius * s.width * c.pressure_amplitude);
  if (value_of(c.half_angle) == 0) return s.shape * s.load;
  const S g = std::numbers::pi * c.load_ratio;  // (T3.2)
  return s.shape * (0.5 * s.load * (c.half_angle * s.edge.sin * s.edge.sin / g - s.edge.cos));
}

/// Of a slice whose normal contact and edge are known: what the tangential contact takes of them.
template <typename S>
void complete(Slice<S>& s, const MotorModel<S>& m) {
  s.stick_gain =
      m.shear * s.crest_velocity / (thickness_at(m, s.radius) * s.contact.pressure_amplitude);
  s.peak = s.contact.full ? S(1.0 - s.contact.edge_cosine) : s.edge.versine;
  s.pressure_force = pressure_force(s);
  const S P = s.contact.pressure_amplitude;
  const S circumference = 2 * std::numbers::pi * s.radius;
  s.torque_scale = circumference * s.radius * s.width * P;
  s.power_scale = circumference * s.width * P * s.crest_velocity;
  s.force_scale = circumference * s.width * (m.tilt * (m.r / s.radius)) * P * s.shape;
}

/// The motor whose contact at the mean radius alone is known, with that of the whole annulus (W2.1 to W2.4).
template <typename S>
DrivenMotor<S> over_annulus(DrivenMotor<S> motor);

/// q = rho R' / (n R), radial motion of the surface per tangential one at a radius (R1.1).
template <typename S>
S radial_ratio(const MotorModel<S>& model, const S& radius);

/// The slices that touch where the pieces are split (W4.1, W4.3), in rising order of radius.
template <typename S>
Vector<Slice<S>> annulus_of(const DrivenMotor<S>& motor, std::span<const SplitPlace<S>> splits);

/// Mean radius of the preload on some slices.
template <typename S>
S lever_of(std::span<const Slice<S>> slices, const S& preload) {
  S moment(0.0);
  for (const Slice<S>& s : slices) moment += s.load * s.radius;
  return moment / preload;
}

/// True if nothing moves or nothing rubs: no amplitude, no preload, no friction.
template <typename S>
bool is_trivial(const DrivenMotor<S>& m) {
  return value_of(m.mean.amplitude) == 0 || value_of(m.preload) == 0 ||
         value_of(m.threshold) == 0 ||
         (m.annulus.empty() && value_of(m.mean.contact.half_angle) == 0);
}

/// The motor under a wave: solves the normal contact.
/// @param half_angle  theta_L at the mean radius, if it is known
template <typename S>
DrivenMotor<S> driven(const MotorModel<S>& model, const Wave<S>& wave,
                      std::optional<double> half_angle = {}) {
  DrivenMotor<S> m;
  static_cast<MotorModel<S>&>(m) = model;
  m.mean.amplitude = wave.amplitude, m.omega = wave.omega;
  m.mean.crest_velocity = m.tilt * m.mean.amplitude * m.omega;
  const S P = m.youngs * m.mean.amplitude / m.thickness;
  const EdgedContact<S> pressed = normal_contact(m.preload, m.n, m.b, m.kappa, P, half_angle);
  m.mean.contact = pressed.contact, m.mean.edge = pressed.edge;
  m.mean.radius = m.r, m.mean.width = m.b, m.mean.shape = S(1.0);
  m.mean.load = m.preload, m.mean.share = S(1.0);
  complete<S>(m.mean, m);
  m.lever = m.holding_lever = m.r, m.indentation = S(0.0);
  if (contact::kHasRadialMotion && m.track.radial) m.mean.radial = radial_ratio<S>(m, m.r);
  if (m.track.nodes == 1) return m;
  return over_annulus(std::move(m));
}

/// The model's numbers of a design.
inline ModelArray<double> model_values(const MotorDesign& design) {
  ModelArray<double> values{};
  for (std::size_t i = 0; i < kModelParameters.size(); ++i)
    values[i] = get(design, kModelParameters[i]);
  if (!design.stator.geometry) return values;
  const auto plate = plate_numbers(design);
  for (std::size_t i = 0; i < kShapeNumbers; ++i)
    values[kShapeIndex + i] = plate[index_of(PlateNumber::shape) + i];
  return values;
}

/// True if the wave still meets the rotor at this speed: finite, and W > 0 in (T2.1).
inline bool wave_meets_rotor(const DrivenMotor<double>& m, double speed) {
  return std::isfinite(speed) && m.omega + m.kappa * (m.r * speed) > 0;
}

/// The contact's eight numbers (E1.1, R1.1) in a slice at rotor speed Omega, with W of (T2.1), which all slices share; R is S or
/// carries more derivatives than S.
template <typename S, typename R>
contact::ContactNumbers<R> contact_numbers(const DrivenMotor<S>& m, const Slice<S>& slice,
                                           const R& speed) {
  const R W = m.omega + m.kappa * R(m.r * speed);
  const R rate = W * m.compliance;
  return {m.inertia * W * rate,
          m.viscosity * rate,
          slice.stick_gain / W,
          slice.radius * speed / slice.crest_velocity,
          R(slice.contact.half_angle),
          R(slice.peak),
          R(m.kinetic),
          R(m.threshold),
          {R(slice.edge.sin), R(slice.edge.cos), R(slice.edge.versine)},
          slice.contact.full,
          R(slice.radial)};
}
/// Those of the contact at the mean radius.
template <typename S, typename R>
contact::ContactNumbers<R> contact_numbers(const DrivenMotor<S>& m, const R& speed) {
  return contact_numbers(m, m.mean, speed);
}

/// mu_0 F_N r (T7.8), over an annulus (W3.6): torque held at rest without drive [N m].
template <typename S>
S holding_torque(const DrivenMotor<S>& m) {
  return m.threshold * m.preload * m.holding_lever;
}

/// mu F_N r, over an annulus (W3.5): the torque of a contact that slips all through [N m].
template <typename S>
S slipping_torque(const DrivenMotor<S>& m) {
  return m.kinetic * m.preload * m.lever;
}

/// c_stator (omega A)^2 (T7.5) [W].
template <typename S>
S stator_loss(const DrivenMotor<S>& m) {
  const S velocity = m.omega * m.mean.amplitude;
  return m.stator_damping * velocity * velocity;
}

/// 2 pi r b, the track that the rotor rubs on [m^2].
template <typename S>
S track_area(const DrivenMotor<S>& m) {
  return 2 * std::numbers::pi * m.r * m.b;
}

}  // namespace twum::inline v0_1::core
