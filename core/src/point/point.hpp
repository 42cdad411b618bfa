// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/periodic_state.hpp"
#include "model/motor_model.hpp"
#include "model/zone_splits.hpp"

#include <twum/core/operating_point.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace twum::inline v0_1::core {

/// Numbers of an operating point, or of a slice of it, in S; the other powers follow from these (T7.1).
template <typename S>
struct PointNumbers {
  S torque, stator_power, friction_power, layer_loss, stick_fraction;
  S reactive_force;  ///< Re F, the contact's force on the wave in phase with its displacement (D1.1) [N]
};

/// Of two slices together (W3.1, W3.2, W3.3, W3.4).
template <typename S>
PointNumbers<S> operator+(const PointNumbers<S>& a, const PointNumbers<S>& b) {
  return {a.torque + b.torque,
          a.stator_power + b.stator_power,
          a.friction_power + b.friction_power,
          a.layer_loss + b.layer_loss,
          a.stick_fraction + b.stick_fraction,
          a.reactive_force + b.reactive_force};
}

/// What goes in and does not come out (T7.10) [W]; zero but for rounding.
inline double excess(const PointNumbers<double>& n, double speed) {
  return n.stator_power - n.torque * speed - n.friction_power - n.layer_loss;
}

/// True if an efficiency can be told from an input power: it is positive and the powers balance (T7.10) up to 1e-8 of it.
/// At no-load both powers of the quotient may vanish in rounding.
inline bool is_known(double input, double excess) {
  return input > 0 && std::fabs(excess) <= 1e-8 * input;
}

/// Where the search for a neighbouring point may begin: the layer as it enters the contact, in each slice, and where Newton's
/// method has already come close to the point, the ends of its zones.
class WarmStart {
 public:
  using Entry = contact::LapGuess;

  WarmStart() = default;
  /// Of the first slice, and of the others in their order.
  WarmStart(const Entry& first, Vector<Entry> others) : first_(first), others_(std::move(others)) {}

  const Entry& of_slice(std::size_t k) const { return k == 0 ? first_ : others_[k - 1]; }
  Entry& of_slice(std::size_t k) { return k == 0 ? first_ : others_[k - 1]; }
  /// Slices that it knows of. Under another wave another number of them may touch: then it says nothing.
  std::size_t size() const { return 1 + others_.size(); }

  /// From `a` on through `b`, by t times their distance beyond `b`.
  static WarmStart extrapolated(const WarmStart& a, const WarmStart& b, double t) {
    if (a.size() != b.size()) return b;
    WarmStart start(extrapolated(a.first_, b.first_, t), b.others_);
    for (std::size_t k = 0; k < start.others_.size(); ++k)
      start.others_[k] = extrapolated(a.others_[k], b.others_[k], t);
    return start;
  }
  static Entry extrapolated(const Entry& a, const Entry& b, double t) {
    const auto &p = a.layer, &q = b.layer;
    Entry entry = b;
    entry.layer = {q.e + t * (q.e - p.e), q.rate + t * (q.rate - p.rate)};
    const auto &u = a.across, &v = b.across;
    entry.across = {v.e + t * (v.e - u.e), v.rate + t * (v.rate - u.rate)};
    return entry;
  }

 private:
  Entry first_{};
  Vector<Entry> others_;  // none where the motor is one slice: then a start costs no memory
};

/// How the layer's periodic states move, slice by slice; empty where one of them does not: it is locked, or in closed form.
using MovingStates = Vector<contact::StateSlopes>;

/// The numbers of a point with derivatives in speed and amplitude.
struct MovingPoint {
  PointNumbers<contact::MotionDual> numbers;
  MovingStates states;
};

/// Result of SolvedPoint::newton_turn(): nearly a periodic state.
struct NewtonTurn {
  PointNumbers<double>
      numbers;     ///< those of the wave's balance are the periodic state's, to first order
  WarmStart next;  ///< the state to which the turn's gap points
  double gap{0};   ///< how far the turn moved the layer's state, in parts of mu_0 p at the crest
};

/// The slices of a motor at an operating point: its own, or those of a track that is split there.
template <typename S>
class PointSlices {
 public:
  PointSlices(const DrivenMotor<S>& motor, std::span<const SplitPlace<S>> splits)
      : own_(splits.empty() ? Vector<Slice<S>>() : annulus_of(motor, splits)),
        all_(splits.empty() ? motor.slices() : std::span<const Slice<S>>(own_)) {}
  PointSlices(const PointSlices&) = delete;
  PointSlices& operator=(const PointSlices&) = delete;

  std::size_t size() const { return all_.size(); }
  const Slice<S>& operator[](std::size_t k) const { return all_[k]; }

 private:
  Vector<Slice<S>> own_;
  std::span<const Slice<S>> all_;
};

/// The contact of one slice at an operating point.
struct SolvedSlice {
  // With `= default`, a list of slices would first fill each of them (300 bytes) with zeros.
  SolvedSlice() {}
  /// @param guess  where the search may begin; null if nothing is known
  SolvedSlice(const DrivenMotor<double>& m, const Slice<double>& slice, double speed,
              const contact::LayerMotion<double>& layer, const WarmStart::Entry* guess,
              double accuracy);

  bool locked{false};            ///< sticks all round at rest, in closed form
  contact::PeriodicState state;  ///< undefined where it is locked

  bool slips_one_way() const { return !locked && state.lap.one_slip; }
  /// The search for a neighbouring slice is quicker if it starts here. A layer that enters at rest needs no search, and one
  /// that slips all through has a start in closed form.
  bool helps() const { return !locked && state.remembers && !state.lap.one_slip; }
  WarmStart::Entry start() const { return {state.entry, state.lap.sequence}; }
};

/// What one slice does by itself at a speed, as with mu_0 > mu, where neighbours tell it nothing.
struct SliceAnswer {
  std::optional<std::uint64_t> signature;  ///< of its zones; none without a periodic state
  long lost{0};                            ///< zones followed in vain
};
SliceAnswer slice_answer(const DrivenMotor<double>& motor, double speed, std::size_t slice);
/// True if a slice, of the sum or an edge of the track, slips and drives all through at a speed.
bool slice_drives(const DrivenMotor<double>& motor, const Slice<double>& slice, double speed);

/// The contact at one operating point. Of how many slices it is made only its members know.
class SolvedPoint {
 public:
  SolvedPoint() = default;

  PointNumbers<double> numbers;
  PointStatus status{PointStatus::ok};
  /// Trivial or locked at rest: in closed form, no periodic state behind it.
  bool special{false};
  std::optional<double> half_angle;  ///< theta_L of a motor that is one slice [rad]

  /// The whole contact slips one way.
  bool slips_one_way() const;
  /// The whole contact slips and drives: the torque is on its plateau.
  bool drives() const { return slips_one_way() && first_.state.lap.first == ZoneState::slip_plus; }
  /// Some of the contact is locked at rest.
  bool locks_in_part() const;
  /// Fingerprint of the sequences of zones.
  std::uint64_t signature() const;
  /// Length of the shortest zone [rad].
  double shortest_zone() const;
  /// Another sequence of zones holds at a speed nearby. Where there is no answer, it is not known.
  bool changes_zones_at(const DrivenMotor<double>& motor, double speed) const;
  /// The means of the contact jump somewhere along the track, which is split there.
  bool jumps() const;
  /// Zones followed to find it: what the search cost.
  long zones_followed() const;
  WarmStart start() const;
  /// A step of Newton's method at a point nearby: one turn of the layer through the zones of this point (E6.5), and the
  /// states to which its gaps lead (E6.2). It takes a fifth of the work of solve_point() and proves nothing. Slices that no
  /// longer have these zones are searched. Nothing if there are none to follow.
  /// @param states  how the states move near it; of as many slices as there are here
  std::optional<NewtonTurn> newton_turn(const DrivenMotor<double>& motor, double speed,
                                        const WarmStart& entry, const MovingStates& states) const;

  /// The numbers with derivatives in kModelParameters and the speed; S is ModelDual or ModelDual2. The contact is
  /// differentiated in its own eight numbers and chained.
  template <typename S>
  PointNumbers<S> differentiated(const DrivenMotor<S>& motor, const S& speed) const;
  /// The same of each slice by itself, in their order; none for a point without a periodic state behind it.
  Vector<PointNumbers<ModelDual>> differentiated_slices(const DrivenMotor<ModelDual>& motor,
                                                        const ModelDual& speed) const;
  /// The numbers, friction power and layer loss only if all means are wanted, with derivatives in speed under the same wave;
  /// those in amplitude are zero.
  PointNumbers<contact::MotionDual> differentiated(const DrivenMotor<double>& motor,
                                                   const contact::MotionDual& speed,
                                                   contact::Means means) const;
  MovingPoint moving(const DrivenMotor<contact::MotionDual>& motor,
                     const contact::MotionDual& speed) const;

 private:
  friend SolvedPoint solve_point(const DrivenMotor<double>&, double, const WarmStart*, double);
  friend SolvedPoint solve_point_near(const DrivenMotor<double>&, double, const SolvedPoint&,
                                      const WarmStart&);
  SolvedPoint(const DrivenMotor<double>& motor, double speed, const WarmStart* guess,
              double accuracy);
  bool follows_steps() const;
  bool changes_followed_zones_at(const DrivenMotor<double>& motor, double speed) const;
  static SolvedPoint of_special(const DrivenMotor<double>& motor, double speed);

  /// Mean radius of the preload on the slices.
  double lever(const DrivenMotor<double>& motor) const {
    return splits_.empty() ? motor.lever : lever_;
  }
  /// Solves the slices and adds them, up to the first without an answer.
  /// @param may_skip  goes on beyond it; then the sum means nothing
  void solve(const DrivenMotor<double>& motor, std::span<const Slice<double>> slices, double speed,
             const contact::LayerMotion<double>& layer, const WarmStart* guess, double accuracy,
             bool may_skip);
  /// Solves those of the next slices from `from` on whose laps can be made in step.
  void solve_in_step(const DrivenMotor<double>& motor, std::span<const Slice<double>> slices,
                     std::size_t from, double speed, const contact::LayerMotion<double>& layer);
  /// Solves the track anew where it is split.
  void split(const DrivenMotor<double>& motor, double speed,
             const contact::LayerMotion<double>& layer, double accuracy);
  /// Solves the track with its splits. Its slices.
  Vector<Slice<double>> solve_split(const DrivenMotor<double>& motor, double speed,
                                    const contact::LayerMotion<double>& layer,
                                    const WarmStart* guess, double accuracy);
  /// The same with the splits of a point nearby. False if those at jumps cannot be followed; then this point means nothing.
  bool follow(const DrivenMotor<double>& motor, double speed,
              const contact::LayerMotion<double>& layer, Vector<Split> splits,
              const WarmStart& guess, double accuracy);
  Vector<SliceZones> zones_of_slices() const;
  class Queries;
  bool has_pieces_of_splits(const DrivenMotor<double>& motor) const;
  void check(const DrivenMotor<double>& motor, double speed, double accuracy);
  /// Where the search at a radius may begin: what the nearest slice says.
  std::optional<WarmStart::Entry> entry_at(std::span<const Slice<double>> slices,
                                           double radius) const;

  std::size_t size() const { return 1 + others_.size(); }
  const SolvedSlice& slice(std::size_t k) const { return k == 0 ? first_ : others_[k - 1]; }
  SolvedSlice& slice(std::size_t k) { return k == 0 ? first_ : others_[k - 1]; }
  /// Where the search in slice k may begin: what its neighbours in speed or radius say.
  std::optional<WarmStart::Entry> entry_near(std::span<const Slice<double>> slices, std::size_t k,
                                             const WarmStart* guess) const;
  template <typename S, typename R, typename Differentiate>
  PointNumbers<R> summed(const DrivenMotor<S>& motor, const R& speed,
                         Differentiate differentiate) const;

  SolvedSlice first_;           // undefined for special points
  Vector<SolvedSlice> others_;  // none where the motor is one slice: a point then costs no memory
  double lever_{0};             // of a split track
  Vector<Split> splits_;        // none: the slices are those of the motor
};

/// Accuracy of the periodic states from which on a track is not split.
inline constexpr double kWithoutSplits = 1e-6;

/// Solves one operating point.
/// @param guess     what a neighbouring point says; null: the layer enters at rest
/// @param accuracy  of the periodic state, as find_periodic_state(); see kWithoutSplits
SolvedPoint solve_point(const DrivenMotor<double>& motor, double speed,
                        const WarmStart* guess = nullptr, double accuracy = 0);

/// Solves a point for which Newton's method has already led speed, wave and layer together to their solution, as on the running
/// branch. One lap verifies the state: it has to return within 1e-12.
/// @param near   a point with nearly the same speed and wave: if its track is split, this one is split at the same radii,
///               without a search for them
/// @param guess  the state that Newton's method has found; from a state that is farther off, laps follow until it is reached
SolvedPoint solve_point_near(const DrivenMotor<double>& motor, double speed,
                             const SolvedPoint& near, const WarmStart& guess);

/// True if the whole contact sticks at rest (theory section 10).
bool locks_at_rest(const DrivenMotor<double>& motor);

/// True if a slice does.
template <typename S>
bool locks_at_rest(const DrivenMotor<S>& motor, const Slice<S>& slice);

/// Numbers of a slice that is locked at rest, in the limit of a rotor that begins to turn forward.
template <typename S, typename R>
PointNumbers<R> locked_slice(const DrivenMotor<S>& motor, const Slice<S>& slice, const R& speed);

/// Points without a periodic state to search for: trivial motors at any speed, locked ones at rest.
template <typename S, typename R>
PointNumbers<R> special_point(const DrivenMotor<S>& motor, const R& speed);

/// Numbers of a slice from the means of its contact. Where it slips all through one way its torque is +-mu F_N r, whatever
/// the layer does: then the derivatives of all else are exactly zero.
template <typename S, typename R>
PointNumbers<R> slice_numbers(const DrivenMotor<S>& m, const Slice<S>& s,
                              const contact::Lap<double>& lap,
                              const contact::ContactMeans<R>& means) {
  const S power = s.power_scale;
  R torque = s.torque_scale * means.traction;
  if (lap.one_slip) torque = R(static_cast<double>(lap.first) * (m.kinetic * s.load * s.radius));
  return {torque,
          power * means.stator_power,
          power * means.friction_power,
          power * means.layer_loss,
          s.share * (means.stick_length / (2.0 * s.contact.half_angle)),
          s.pressure_force + s.force_scale * means.reactive_force};
}

}  // namespace twum::inline v0_1::core
