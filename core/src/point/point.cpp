// SPDX-License-Identifier: Apache-2.0
#include "point/point.hpp"

#include "contact/lane_laps.hpp"
#include "contact/radial_lock.hpp"
#include "contact/radial_state.hpp"
#include "contact/return_map.hpp"
#include "contact/zone_curves.hpp"
#include "model/scalars.hpp"
#include "model/track.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using contact::LayerMotion;
using contact::PeriodicStatus;

// Accuracy for a guess that Newton's method has already led to the periodic state. An error of the state changes torque and
// powers by about as much of their scale, and of all laws that are then checked the strictest is the balance of the drive
// (1e-11).
constexpr double kConfirmed = 1e-12;

PointStatus point_status(PeriodicStatus status) {
  switch (status) {
    case PeriodicStatus::ok: return PointStatus::ok;
    case PeriodicStatus::no_periodic_state: return PointStatus::no_periodic_state;
    case PeriodicStatus::not_converged: return PointStatus::not_converged;
    case PeriodicStatus::resonance: return PointStatus::resonance;
    case PeriodicStatus::unresolved: return PointStatus::unresolved;
  }
  return PointStatus::unresolved;
}

// Of the scale of powers (T7.11). A million random motors balance to 3e-11; in nearly rigid layers, far from any motor, the
// powers are small differences and balance to 1e-7, while the torque is still that of the rigid limit.
constexpr double kBalance = 1e-6, kBeyond = 1e-9;

// The laws that rounding may break: balance of powers (T7.10), signs of losses, bound of the torque (C8.1, W3.5). A number
// that is not finite breaks them too.
bool keeps_laws(const DrivenMotor<double>& m, const PointNumbers<double>& n, double speed,
                double lever) {
  const double most = m.threshold * m.preload * lever;
  double fastest = std::fabs(speed);
  for (const Slice<double>& s : m.slices())
    fastest = std::max(s.crest_velocity / s.radius, fastest);
  const double scale = most * fastest;
  const double share = n.stick_fraction;
  return std::isfinite(n.reactive_force) && std::fabs(excess(n, speed)) <= kBalance * scale &&
         n.friction_power >= -kBeyond * scale && n.layer_loss >= -kBeyond * scale &&
         std::fabs(n.torque) <= most * (1 + kBeyond) && share >= 0 && share <= 1 + kBeyond;
}

// Without a wave the rotor drags the layer over a flat stator. Released at mu_0 p it slips steadily,
// unless its own vibration brings it back to rest on the stator: then it sticks and slips in a rhythm
// that has nothing to do with the turns of the wave.
bool drags_steadily(const DrivenMotor<double>& m, double speed) {
  if (!has_static_excess(m) || m.inertia == 0 || speed == 0) return true;
  const double W = m.omega + m.kappa * m.r * speed;
  const double pressure = m.mean.contact.max_pressure;
  const LayerMotion<double> layer(m.inertia * W * W / m.shear, m.viscosity * W / m.shear);
  const double sigma = speed > 0 ? 1 : -1;
  const double drift = m.shear * m.r * speed / (m.thickness * W * pressure);
  const contact::FreeMotion<double> motion =
      layer.start({-sigma * (m.threshold - m.kinetic), -drift});
  const contact::SlipCurve curve(layer, motion, {drift, 0, 0, 0}, sigma, 0, {0, 1, 0}, 1e300,
                                 {0, 1, 0});
  long samples = 0;
  return contact::first_zero(curve, 1e300, contact::StartOrder::zero, samples, 1'000'000) ==
         contact::kNoZero;
}

// Mean traction of a locked layer as the rotor just begins to drag it forward: the constant part falls
// until the traction touches -mu_0 p somewhere. Units of P, at rest W = omega.
template <typename S>
struct Lock {
  S low, high, damping_work;
  S reactive_force;  // <t sin theta> (C20.3)

  Lock(const DrivenMotor<S>& m, const Slice<S>& slice) {
    using std::sqrt;
    const contact::ContactNumbers<S> n = contact_numbers(m, slice, S(0.0));
    const S mean = n.threshold * (n.peak - 1.0), swing = (1.0 - n.inertia) * n.stick_rate;
    const S forward = n.threshold + n.damping * n.stick_rate,
            back = n.threshold - n.damping * n.stick_rate;
    low = sqrt(forward * forward + swing * swing) - mean;
    high = mean - sqrt(back * back + swing * swing);
    damping_work = 0.5 * n.damping * n.stick_rate;
    reactive_force = 0.5 * swing;
    if constexpr (contact::kHasRadialMotion) {
      if (value_of(n.radial) == 0) return;
      const S motion = 1.0 + n.radial * n.radial;  // of both components
      damping_work = motion * damping_work, reactive_force = motion * reactive_force;
      const contact::RadialLock<S> lock(n);
      low = lock.low, high = lock.high;
    }
  }
};

}  // namespace

template <typename S>
bool locks_at_rest(const DrivenMotor<S>& m, const Slice<S>& slice) {
  if (!slice.contact.full) return false;
  const Lock<S> lock(m, slice);
  return value_of(lock.low) <= value_of(lock.high);
}

bool locks_at_rest(const DrivenMotor<double>& m) {
  if (m.threshold == 0 || m.preload == 0) return false;
  if (m.mean.amplitude == 0) return true;
  const auto slices = m.slices();
  return std::all_of(slices.begin(), slices.end(),
                     [&m](const Slice<double>& s) { return locks_at_rest(m, s); });
}

// At rest the limit of forward speeds, as everywhere; at -0 that of backward ones.
template <typename R>
bool turns_back(const R& speed) {
  return std::signbit(value_of(speed));
}

template <typename S, typename R>
PointNumbers<R> locked_slice(const DrivenMotor<S>& m, const Slice<S>& s, const R& speed) {
  const R zero(0.0);
  const Lock<S> lock(m, s);
  const R power = s.power_scale * lock.damping_work + zero;
  return {s.torque_scale * (turns_back(speed) ? lock.high : lock.low) + zero,
          power,
          zero,
          power,
          s.share + zero,
          s.pressure_force + zero + s.force_scale * lock.reactive_force};
}

template <typename S, typename R>
PointNumbers<R> special_point(const DrivenMotor<S>& m, const R& speed) {
  const R zero(0.0);
  const auto slices = m.slices();
  R force = slices[0].pressure_force + zero;
  for (const Slice<S>& s : slices.subspan(1)) force = force + s.pressure_force;
  if (value_of(m.threshold) == 0 || value_of(m.preload) == 0)
    return {zero, zero, zero, zero, zero, force};
  if (value_of(m.mean.amplitude) == 0) {
    const R drag = (turns_back(speed) ? 1.0 : -1.0) * slipping_torque(m) + zero;
    return {drag, zero, -(drag * speed), zero, zero, force};
  }
  PointNumbers<R> sum = locked_slice(m, slices[0], speed);
  for (const Slice<S>& s : slices.subspan(1)) sum = sum + locked_slice(m, s, speed);
  return sum;
}

bool SolvedPoint::slips_one_way() const {
  if (special || !first_.slips_one_way()) return false;
  return std::all_of(others_.begin(), others_.end(), [this](const SolvedSlice& s) {
    return s.slips_one_way() && s.state.lap.first == first_.state.lap.first;
  });
}

bool SolvedPoint::locks_in_part() const {
  return first_.locked ||
         std::any_of(others_.begin(), others_.end(), [](const SolvedSlice& s) { return s.locked; });
}

std::uint64_t SolvedPoint::signature() const {
  if (special) return 0;
  std::uint64_t mark = first_.state.lap.itinerary;
  for (const SolvedSlice& s : others_) mark = (mark ^ s.state.lap.itinerary) * 0x100000001b3ull;
  return mark;
}

bool SolvedPoint::changes_zones_at(const DrivenMotor<double>& m, double speed) const {
  if (contact::kHasRadialMotion && follows_steps()) return changes_followed_zones_at(m, speed);
  const WarmStart from = start();
  const SolvedPoint near = solve_point(m, speed, &from);
  return near.status == PointStatus::ok && near.signature() != signature();
}

bool SolvedPoint::follows_steps() const {
  const auto has_steps = [](const SolvedSlice& s) { return !s.locked && !s.state.steps.empty(); };
  return splits_.empty() && has_steps(first_) &&
         std::all_of(others_.begin(), others_.end(), has_steps);
}

// Laps through the steps of these take half of the time.
bool SolvedPoint::changes_followed_zones_at(const DrivenMotor<double>& m, double speed) const {
  const PointSlices<double> slices(m, {});
  for (std::size_t k = 0; k < size(); ++k) {
    const contact::PeriodicState& known = slice(k).state;
    const contact::PeriodicState near =
        contact::radial_state_beside(contact_numbers(m, slices[k], speed), known);
    if (near.status == PeriodicStatus::ok && near.lap.itinerary != known.lap.itinerary) return true;
  }
  return false;
}

double SolvedPoint::shortest_zone() const {
  double shortest = first_.state.lap.shortest;
  for (const SolvedSlice& s : others_) shortest = std::fmin(shortest, s.state.lap.shortest);
  return shortest;
}

bool SolvedPoint::jumps() const {
  return std::any_of(splits_.begin(), splits_.end(),
                     [](const Split& s) { return s.jump.has_value(); });
}

long SolvedPoint::zones_followed() const {
  long zones = first_.state.zones;
  for (const SolvedSlice& s : others_) zones += s.state.zones;
  return zones;
}

WarmStart SolvedPoint::start() const {
  Vector<WarmStart::Entry> others;
  others.reserve(others_.size());
  for (const SolvedSlice& s : others_) others.push_back(s.start());
  return {first_.start(), std::move(others)};
}

std::optional<WarmStart::Entry> SolvedPoint::entry_near(std::span<const Slice<double>> slices,
                                                        std::size_t k,
                                                        const WarmStart* guess) const {
  if (guess) return guess->of_slice(k);
  if (k == 0 || !slice(k - 1).helps()) return {};
  const WarmStart::Entry last = slice(k - 1).start();
  if (k == 1 || !slice(k - 2).helps()) return last;
  const double t =
      (slices[k].radius - slices[k - 1].radius) / (slices[k - 1].radius - slices[k - 2].radius);
  return WarmStart::extrapolated(slice(k - 2).start(), last, t);
}

SolvedSlice::SolvedSlice(const DrivenMotor<double>& m, const Slice<double>& slice, double speed,
                         const LayerMotion<double>& layer, const WarmStart::Entry* guess,
                         double accuracy)
    : locked(speed == 0 && locks_at_rest(m, slice)),
      state(locked ? contact::PeriodicState{}
                   : contact::find_periodic_state(contact_numbers(m, slice, speed), layer, guess,
                                                  accuracy)) {}

namespace {

// How the layer moves is the same in all slices: W is.
LayerMotion<double> layer_of(const DrivenMotor<double>& m, double speed) {
  const double W = m.omega + m.kappa * (m.r * speed), rate = W * m.compliance;
  return {m.inertia * W * rate, m.viscosity * rate};
}

// What is the matter with a slice. With mu_0 > mu a locked one is torn loose.
PointStatus status_of(const DrivenMotor<double>& m, const SolvedSlice& s) {
  if (!s.locked) return point_status(s.state.status);
  return has_static_excess(m) ? PointStatus::no_periodic_state : PointStatus::ok;
}

PointNumbers<double> numbers_of(const DrivenMotor<double>& m, const Slice<double>& slice,
                                const SolvedSlice& s, double speed) {
  return s.locked ? locked_slice(m, slice, speed)
                  : slice_numbers(m, slice, s.state.lap, s.state.lap.means);
}

}  // namespace

SliceAnswer slice_answer(const DrivenMotor<double>& m, double speed, std::size_t slice) {
  const SolvedSlice solved(m, m.slices()[slice], speed, layer_of(m, speed), nullptr, 0);
  if (status_of(m, solved) != PointStatus::ok) return {{}, solved.state.zones};
  return {solved.state.lap.itinerary};
}

bool slice_drives(const DrivenMotor<double>& m, const Slice<double>& slice, double speed) {
  const SolvedSlice solved(m, slice, speed, layer_of(m, speed), nullptr, kWithoutSplits);
  return status_of(m, solved) == PointStatus::ok && solved.slips_one_way() &&
         solved.state.lap.first == ZoneState::slip_plus;
}

SolvedPoint::SolvedPoint(const DrivenMotor<double>& m, double speed, const WarmStart* guess,
                         double accuracy)
    : first_(m.annulus.empty() ? SolvedSlice(m, m.mean, speed, layer_of(m, speed),
                                             guess ? &guess->of_slice(0) : nullptr, accuracy)
                               : SolvedSlice()) {
  if (m.annulus.empty()) {
    status = status_of(m, first_);
    numbers = numbers_of(m, m.mean, first_, speed);
    half_angle = m.mean.contact.half_angle;
    return;
  }
  const LayerMotion<double> layer = layer_of(m, speed);
  const bool splits = m.track.splits && accuracy < kWithoutSplits;
  // With mu_0 > mu a slice may have no answer, and those beside it have.
  const bool may_skip = splits && has_static_excess(m);
  solve(m, m.slices(), speed, layer, guess, accuracy, may_skip);
  if (splits && (status == PointStatus::ok || may_skip)) split(m, speed, layer, accuracy);
}

void SolvedPoint::solve(const DrivenMotor<double>& m, std::span<const Slice<double>> slices,
                        double speed, const LayerMotion<double>& layer, const WarmStart* guess,
                        double accuracy, bool may_skip) {
  others_ = Vector<SolvedSlice>(slices.size() - 1);
  for (std::size_t k = 0; k < slices.size() && (status == PointStatus::ok || may_skip); ++k) {
    SolvedSlice& s = slice(k);
    if (contact::kHasLanes && !m.track.radial && k % contact::kLanes == 0)
      solve_in_step(m, slices, k, speed, layer);
    if (s.state.laps == 0) {
      const auto entry = entry_near(slices, k, guess);
      s = {m, slices[k], speed, layer, entry ? &*entry : nullptr, accuracy};
    }
    if (const PointStatus own = status_of(m, s); own != PointStatus::ok) status = own;
    const PointNumbers<double> own = numbers_of(m, slices[k], s, speed);
    numbers = k == 0 ? own : numbers + own;
  }
}

void SolvedPoint::solve_in_step(const DrivenMotor<double>& m, std::span<const Slice<double>> slices,
                                std::size_t from, double speed, const LayerMotion<double>& layer) {
  std::array<contact::ContactNumbers<double>, contact::kLanes> contacts;
  std::array<contact::LaneLap, contact::kLanes> laps;
  std::array<std::size_t, contact::kLanes> which;
  std::size_t count = 0;
  for (std::size_t k = from; k < slices.size() && k < from + laps.size(); ++k) {
    contacts[count] = contact_numbers(m, slices[k], speed);
    if (!contact::goes_in_step(contacts[count], layer)) continue;
    laps[count] = {&contacts[count], &slice(k).state.lap};
    which[count++] = k;
  }
  if (count < 2) return;
  contact::run_in_step(layer, std::span(laps).first(count));
  for (std::size_t i = 0; i < count; ++i) {
    if (!laps[i].found) continue;
    contact::PeriodicState& state = slice(which[i]).state;
    state.laps = 1, state.zones = state.lap.zones;
  }
}

// What a gap at entry changes in a mean over the turn.
static double gained(const contact::LayerState<double>& slope,
                     const contact::LayerState<double>& d) {
  return slope.e * d.e + slope.rate * d.rate;
}

std::optional<NewtonTurn> SolvedPoint::newton_turn(const DrivenMotor<double>& m, double speed,
                                                   const WarmStart& entry,
                                                   const MovingStates& states) const {
  if (contact::kHasRadialMotion && m.track.radial) return {};  // no zones in closed form to follow
  const PointSlices<double> slices(m, fixed_places(splits_));
  if (special || is_trivial(m) || slices.size() != size() || entry.size() != size() ||
      states.size() != size())
    return {};
  const LayerMotion<double> layer = layer_of(m, speed);
  NewtonTurn turn{{}, entry, 0};
  for (std::size_t k = 0; k < size(); ++k) {
    WarmStart::Entry& at = turn.next.of_slice(k);
    const Slice<double>& s = slices[k];
    const contact::ContactNumbers<double> n = contact_numbers(m, s, speed);
    if (n.full) return {};
    auto lap = contact::follow_lap(n, layer, at, at.zones);
    if (lap.status != contact::LapStatus::ok) lap = contact::prove_lap(n, layer, at, {});
    if (lap.status != contact::LapStatus::ok) return {};
    at.zones = lap.sequence, at.followed = true;
    const double gap = contact::distance(layer, at.layer, lap.next.layer);
    turn.gap = std::fmax(turn.gap, gap / (n.threshold * n.peak));
    const contact::StateSlopes& moves = states[k];
    const contact::LayerState<double> d =
        moves.resolvent * contact::difference(lap.next.layer, at.layer);
    at.layer = {at.layer.e + d.e, at.layer.rate + d.rate};
    lap.means.stator_power += gained(moves.of_power, d);
    lap.means.reactive_force += gained(moves.of_force, d);
    turn.numbers = turn.numbers + slice_numbers(m, s, lap, lap.means);
  }
  return turn;
}

SolvedPoint SolvedPoint::of_special(const DrivenMotor<double>& m, double speed) {
  SolvedPoint point;
  point.special = true;
  point.numbers = special_point(m, speed);
  const bool steady = is_trivial(m) ? (m.mean.amplitude != 0 || drags_steadily(m, speed))
                                    : m.threshold == m.kinetic;
  if (!steady) point.status = PointStatus::no_periodic_state;
  return point;
}

SolvedPoint solve_point(const DrivenMotor<double>& m, double speed, const WarmStart* guess,
                        double accuracy) {
  const bool special = is_trivial(m) || (speed == 0 && locks_at_rest(m));
  if (guess && guess->size() != m.slices().size()) guess = nullptr;
  SolvedPoint point =
      special ? SolvedPoint::of_special(m, speed) : SolvedPoint(m, speed, guess, accuracy);
  point.check(m, speed, accuracy);
  return point;
}

SolvedPoint solve_point_near(const DrivenMotor<double>& m, double speed, const SolvedPoint& near,
                             const WarmStart& guess) {
  SolvedPoint point;
  if (near.splits_.empty() || !near.has_pieces_of_splits(m) ||
      !point.follow(m, speed, layer_of(m, speed), near.splits_, guess, kConfirmed))
    return solve_point(m, speed, &guess, kConfirmed);
  point.check(m, speed, kConfirmed);
  return point;
}

void SolvedPoint::check(const DrivenMotor<double>& m, double speed, double accuracy) {
  const bool lawful = accuracy > kConfirmed ? std::isfinite(numbers.torque + numbers.stator_power)
                                            : keeps_laws(m, numbers, speed, lever(m));
  if (status == PointStatus::ok && !lawful) status = PointStatus::inaccurate;
}

#define TWUM_INSTANTIATE(S, R)                                                             \
  template bool locks_at_rest(const DrivenMotor<S>&, const Slice<S>&);                     \
  template PointNumbers<R> locked_slice(const DrivenMotor<S>&, const Slice<S>&, const R&); \
  template PointNumbers<R> special_point(const DrivenMotor<S>&, const R&);
TWUM_FOR_EACH_MODEL_SCALAR(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE
template PointNumbers<contact::MotionDual> locked_slice(const DrivenMotor<double>&,
                                                        const Slice<double>&,
                                                        const contact::MotionDual&);
template PointNumbers<contact::MotionDual> special_point(const DrivenMotor<double>&,
                                                         const contact::MotionDual&);
template bool locks_at_rest(const DrivenMotor<contact::MotionDual>&,
                            const Slice<contact::MotionDual>&);
template PointNumbers<contact::MotionDual> locked_slice(const DrivenMotor<contact::MotionDual>&,
                                                        const Slice<contact::MotionDual>&,
                                                        const contact::MotionDual&);
template PointNumbers<contact::MotionDual> special_point(const DrivenMotor<contact::MotionDual>&,
                                                         const contact::MotionDual&);

}  // namespace twum::inline v0_1::core
