// SPDX-License-Identifier: Apache-2.0
#include "contact/radial_lap.hpp"

#include "contact/first_zero.hpp"
#include "contact/layer_motion.hpp"
#include "contact/plane_stick.hpp"
#include "contact/slip_step_solve.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace twum::inline v0_1::contact {
namespace {

using std::numbers::pi;

template <typename S>
Plane<double> values_of(const Plane<S>& x) {
  return {value_of(x.along), value_of(x.across)};
}
template <typename S>
PlaneState<double> values_of(const PlaneState<S>& x) {
  return {values_of(x.e), values_of(x.rate)};
}

template <typename S>
class RadialRunner {
 public:
  RadialRunner(const ContactNumbers<S>& numbers, const RadialSteps& steps, Lap<S>& lap)
      : n_(numbers), values_(twum::contact::values_of(numbers)), steps_(steps), lap_(lap) {}

  void run(const LapEntry<S>& entry) {
    theta_ = -n_.half_angle;
    at_ = {-n_.edge.sin, n_.edge.cos, n_.edge.versine};
    layer_ = {{entry.layer.e, entry.across.e}, {entry.layer.rate, entry.across.rate}};
    bool sticks = entry.carried ? entry.zone == ZoneState::stick : sticks_at_entry();
    lap_.first = sticks ? ZoneState::stick : ZoneState::slip_plus;
    StartOrder order = entry.carried ? StartOrder::positive : StartOrder::double_zero;
    while (!done_ && lap_.status == LapStatus::ok) {
      if (++lap_.zones > kMostZones) return fail();
      const double from = value_of(theta_);
      lap_.itinerary =
          marked(lap_.itinerary, mark_of(sticks ? ZoneState::stick : ZoneState::slip_plus));
      sticks_ = sticks;
      if (sticks) {
        stick(order);
        sticks = !done_ && sticks_again();
        order = StartOrder::positive;
      } else {
        slip();
        sticks = true;
        order = after_slip();
      }
      const double length = value_of(theta_) - from;
      stalled_ = length < kStalled ? stalled_ + 1 : 0;
      lap_.shortest = std::fmin(lap_.shortest, length);
    }
    leave();
  }

 private:
  using Angles = SlipStep<double>::Stages<double>;
  static constexpr int kMostZones = 1000;
  // Lengths [rad]: of zones that count as none, of steps that are taken whatever their error is, and of those that are none.
  static constexpr double kStalled = 1e-10, kShortest = 1e-9, kNoStep = 1e-13;
  static constexpr double kMostLonger = 3, kMostShorter = 0.1;
  // Of the largest slip of a step: a lower place may be beside a dip below zero, and what of such a dip is no more than the error of
  // the step.
  static constexpr double kDip = 0.3, kRounded = 1e-7;
  static constexpr double kResolved =
      1e-2;  // last term of a polynomial that tells what is between its points
  static constexpr double kLastTerm = 1e-4;  // of mu p(0), of a step as long as the contact

  bool elastic() const { return values_.inertia == 0 && values_.damping == 0; }

  // Without inertia and damping the layer enters at rest and sticks where the wave shears it slower than the threshold grows.
  bool sticks_at_entry() const {
    if (!elastic()) return false;
    const Plane<double> v = surface_motion(values_, trig_here()).velocity;
    return values_.stick_rate * length(v) <= values_.kinetic * values_.edge.sin;
  }

  // An elastic layer snaps from mu_0 p to mu p when it is released (T4.4). It sticks again where (R2.7) says that slip would be backward.
  bool sticks_again() {
    if (!elastic() || !(values_.threshold > values_.kinetic)) return false;
    const S p = n_.peak - at_.versine;
    const S before = n_.threshold * p, after = n_.kinetic * p;
    lap_.means.friction_power += 0.5 * (before * before - after * after) / n_.stick_rate;
    lap_.itinerary = marked(lap_.itinerary, 7);
    layer_.e = S(n_.kinetic / n_.threshold) * layer_.e;
    const Plane<double> e = values_of(layer_.e);
    const Plane<double> v = surface_motion(values_, trig_here()).velocity;
    return dot(v, e) / length(e) + values_.kinetic * value_of(at_.sin) / values_.stick_rate <= 0;
  }

  // What is known of the reserve where stick begins.
  StartOrder after_slip() const {
    if (values_.threshold > values_.kinetic || values_.inertia > 0) return StartOrder::positive;
    return elastic() ? StartOrder::double_zero : StartOrder::zero;
  }

  Trig<double> trig_here() const {
    return {value_of(at_.sin), value_of(at_.cos), value_of(at_.versine)};
  }
  double left() const { return value_of(n_.half_angle) - value_of(theta_); }

  void stick(StartOrder order) {
    const PlaneWave<S> e = carried_strain(n_, theta_, at_, layer_.e);
    const PlaneWave<S> t = carried_traction(n_, e);
    const PlaneWave<double> t_value{values_of(t.constant), values_of(t.drift), values_of(t.cosine),
                                    values_of(t.sine)};
    const double x = stick_length(t_value, order);
    if (std::isnan(x)) return fail();
    const S from = theta_;
    const Trig<S> at_from = at_;
    x == kNoZero ? reach_exit() : advance(released(n_, t, theta_, x));
    add_stick(n_, t, e, {from, at_from}, {theta_, at_}, lap_.means);
    if (steps_.trace)
      steps_.trace->push_back(
          {value_of(from),
           value_of(theta_),
           ZoneState::stick,
           {values_of(e.constant), values_of(e.drift), values_of(e.cosine), values_of(e.sine)},
           {},
           {},
           {}});
    layer_ = {e.at(theta_, at_), e.slope(at_)};
  }

  // To where the traction reaches its threshold, kNoZero if it does not. Steps over places where it only touches the threshold.
  double stick_length(const PlaneWave<double>& t, StartOrder order) const {
    long work = 0;
    const auto length_from = [&](double skipped, StartOrder known) {
      const double from = value_of(theta_) + skipped;
      const Trig<double> at = skipped > 0 ? trig(from) : trig_here();
      return first_zero(PlaneReserve(values_, t, from, at), left() - skipped, known, work, 100'000);
    };
    const double x = length_from(0, order);
    const double passed = stalled_ > 4 ? std::ldexp(kStalled, std::min(stalled_ - 4, 30)) : 0;
    if (!(x < passed)) return x;
    return passed < left() ? passed + length_from(passed, StartOrder::positive) : kNoZero;
  }

  void slip() {
    if (left() < kNoStep)
      return reach_exit();  // a layer that sticks to the exit, as where all sticks
    std::optional<Angles> last;
    double last_length = 0, length = std::fmin(left(), first_length_);
    for (int i = 0; i < kMostSteps; ++i) {
      if (const RadialStep* known = next_known()) {
        switch (follow(*known, i == 0)) {
          case Followed::on: last = known->angles, last_length = known->length; continue;
          case Followed::to_end: return;
          case Followed::not_at_all: followed_ = steps_.known.size();
        }
      }
      const double rest = left();
      const bool to_exit = length >= rest * (1 - 1e-12);
      if (to_exit) length = rest;
      SlipStep<double> step = step_of(length, to_exit);
      const bool solved = (last && step.solve(angles_at(*last, 1, length / last_length))) ||
                          step.solve(step.euler_angles());
      if (!solved) {
        if (!shorten(length)) return fail();
        continue;
      }
      const double error = step.last_term() * length / (2 * value_of(n_.half_angle)) / kLastTerm;
      if (error > 1 && length > kShortest) {
        length *= std::fmax(kMostShorter, share_for(error));
        continue;
      }
      const double place = end_of_slip(step, i == 0);
      if (place == 0) {
        length *= Collocation::points().place[0];
        if (length < kStalled) return;  // it hardly begins
        continue;
      }
      if (place < 1) {
        if (finish(angles_at(step.angles(), 0, place), place * length)) return;
        if (!shorten(length)) return fail();
        continue;
      }
      accept(step, length, to_exit);
      if (to_exit) return;
      last = step.angles(), last_length = length;
      first_length_ = length;
      length = std::fmin(length * std::fmin(kMostLonger, share_for(error)), left());
    }
    fail();
  }

  // The next step that is known of this zone.
  const RadialStep* next_known() {
    const auto& known = steps_.known;
    while (followed_ < known.size() && known[followed_].zone < lap_.zones) ++followed_;
    const bool is_here = followed_ < known.size() && known[followed_].zone == lap_.zones;
    return is_here ? &known[followed_++] : nullptr;
  }

  // Derivatives follow a lap exactly; other laps are sought beside it, with its accuracy.
  enum class Followed : std::uint8_t { on, to_end, not_at_all };
  Followed follow(const RadialStep& known, [[maybe_unused]] bool begins) {
    const double length = known.to_exit ? left() : known.length;
    if (!known.to_exit && !(length < left())) return Followed::not_at_all;
    if constexpr (kDualDepth<S> != 0) {
      SlipStep<double> step = step_of(length, known.to_exit);
      step.take(known.angles);
      if (known.last)
        accept_end(step, length, slope_at_end(step) / length);
      else
        accept(step, length, known.to_exit);
      return known.last || known.to_exit ? Followed::to_end : Followed::on;
    } else {
      if (known.last) return finish(known.angles, length) ? Followed::to_end : Followed::not_at_all;
      SlipStep<double> step = step_of(length, known.to_exit);
      if (!step.solve(known.angles) || end_of_slip(step, begins) < 1) return Followed::not_at_all;
      accept(step, length, known.to_exit);
      return known.to_exit ? Followed::to_end : Followed::on;
    }
  }

  // Of a step without a solution; false if there is none of any length.
  static bool shorten(double& length) {
    length *= 0.25;
    return length >= kNoStep;
  }

  // By which a step may be longer than one with this error, which goes with the fifth power of the length.
  static double share_for(double error) { return 0.85 * std::pow(std::fmax(error, 1e-4), -0.2); }

  SlipStep<double> step_of(double length, bool to_exit) const {
    SlipStep<double> step(values_, value_of(theta_), values_of(layer_), length);
    if (to_exit) step.ends_at(values_.edge);
    return step;
  }

  // Angles of a step's polynomial at the points of another.
  static Angles angles_at(const Angles& of, double from, double scale) {
    const Collocation& c = Collocation::points();
    Angles angles;
    for (std::size_t i = 0; i < Collocation::N; ++i) {
      const Collocation::Row w = c.weights_at(from + scale * c.place[i]);
      angles[i] = 0;
      for (std::size_t j = 0; j < Collocation::N; ++j) angles[i] += w[j] * of[j];
    }
    return angles;
  }

  // Where the slip velocity falls to zero within a step, in parts of it: 1 if it does not, 0 if that is before the first point. A
  // zone begins with no slip, so a zero there may be its start. It may also dip below zero between two places.
  static double end_of_slip(const SlipStep<double>& step, bool begins) {
    const Collocation& c = Collocation::points();
    Angles slip;
    for (std::size_t i = 0; i < Collocation::N; ++i) slip[i] = step.slip(i);
    if (slip[0] < 0) return 0;
    const auto weighed = [&slip](const Collocation::Row& w) {
      double f = 0;
      for (std::size_t j = 0; j < Collocation::N; ++j) f += w[j] * slip[j];
      return f;
    };
    const auto at = [&](double place) { return weighed(c.weights_at(place)); };
    std::array<double, Collocation::kLooks> seen;
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = weighed(c.look_weights[i]);
    const double most = *std::max_element(seen.begin(), seen.end());
    // The polynomial tells what is between the points, unless a short step at the exit leaves it open.
    const double surely = step.last_term() < kResolved ? -kRounded * most : -HUGE_VAL;
    for (std::size_t i = begins ? 2 : 1; i < seen.size(); ++i) {
      const bool is_point = i % 2 == 1;
      if (seen[i] < (is_point ? 0 : surely)) return zero_between(at, c.look[i - 1], c.look[i]);
      const bool falls_here = seen[i] <= seen[i - 1], ends = i + 1 == seen.size();
      const bool dips = falls_here && seen[i] < kDip * most &&
                        (ends ? weighed(c.slope_at_end) > 0 : seen[i + 1] >= seen[i]);
      if (!dips) continue;
      const LeastValue bottom =
          least_between("the least slip of a step", at, c.look[i - 1], c.look[ends ? i : i + 1]);
      if (bottom.value < surely) return zero_between(at, c.look[i - 1], bottom.place);
    }
    return 1;
  }

  // Of a function that is positive at `low` and negative at `high`.
  template <typename F>
  static double zero_between(F f, double low, double high) {
    while (high - low > 1e-6) {
      const double middle = 0.5 * (low + high);
      (f(middle) < 0 ? high : low) = middle;
    }
    return 0.5 * (low + high);
  }

  // The change of the slip velocity in a step, at its end.
  static double slope_at_end(const SlipStep<double>& step) {
    const Collocation& c = Collocation::points();
    double slope = 0;
    for (std::size_t j = 0; j < Collocation::N; ++j) slope += c.slope_at_end[j] * step.slip(j);
    return slope;
  }

  // The step that ends where slip does, near this end; false if there is none, as where the step that told it went astray.
  bool finish(Angles guess, double end) {
    for (int i = 0; i < 20; ++i) {
      SlipStep<double> step = step_of(end, false);
      if (!step.solve(guess) && !step.solve(step.euler_angles())) return false;
      const double slope = slope_at_end(step);
      const double move = -step.slip(Collocation::N - 1) / slope * end;
      if (std::fabs(move) <= 1e-13 * end || i == 19) {
        accept_end(step, end, slope / end);
        return true;
      }
      guess = step.angles();
      end += std::clamp(move, -0.5 * end, 0.5 * end);
    }
    return false;
  }

  void accept(const SlipStep<double>& step, double length, bool to_exit) {
    record(step, length, to_exit, false);
    const double end = value_of(theta_) + length;
    const S span = to_exit ? S(n_.half_angle - theta_) : S(end - theta_);
    take(step, span, to_exit);
    if (to_exit) {
      reach_exit();
    } else {
      theta_ = S(end), at_ = trig(theta_);
    }
  }

  void accept_end(const SlipStep<double>& step, double length, double slope) {
    record(step, length, false, true);
    S span(length);
    if constexpr (kDualDepth<S> != 0) {
      // Where slip ends moves with the start of the zone and all else. The slope is that of a polynomial: two steps more.
      span = S(value_of(theta_) + length) - theta_;
      for (int i = 0; i < kDualDepth<S> + 2; ++i) {
        SlipStep<S> lifted(n_, theta_, layer_, span);
        lifted.lift(step);
        span =
            with_value(S(span - with_value(lifted.slip(Collocation::N - 1), 0.0) / slope), length);
      }
    }
    take(step, span, false);
    theta_ = theta_ + span, at_ = trig(theta_);
    if (!(left() > 0)) reach_exit();
  }

  void take(const SlipStep<double>& step, const S& span, bool to_exit) {
    if constexpr (kDualDepth<S> == 0) {
      step.add_to(lap_.means);
      layer_ = step.end();
    } else {
      SlipStep<S> lifted(n_, theta_, layer_, span);
      if (to_exit) lifted.ends_at(n_.edge);
      lifted.lift(step);
      lifted.add_to(lap_.means);
      layer_ = lifted.end();
    }
  }

  void record(const SlipStep<double>& step, double length, bool to_exit, bool last) {
    if (steps_.taken) steps_.taken->push_back({lap_.zones, length, to_exit, last, step.angles()});
    if (!steps_.trace) return;
    const double from = value_of(theta_);
    const ZoneState side = std::cos(step.angles()[Collocation::N / 2]) < 0 ? ZoneState::slip_minus
                                                                           : ZoneState::slip_plus;
    steps_.trace->push_back(
        {from, from + length, side, {}, values_of(layer_), step.angles(), step.rates()});
  }

  void advance(const S& length) {
    theta_ = theta_ + length, at_ = trig(theta_);
    if (!(left() > 0)) reach_exit();
  }
  void reach_exit() { theta_ = n_.half_angle, at_ = n_.edge, done_ = true; }
  void fail() { lap_.status = LapStatus::unresolved, done_ = true; }

  // Free flight to the next entry; the energy that the layer does not bring back is lost.
  void leave() {
    ContactMeans<S>& m = lap_.means;
    lap_.next = {{layer_.e.along, layer_.rate.along},
                 n_.full,
                 sticks_ ? ZoneState::stick : ZoneState::slip_plus,
                 {layer_.e.across, layer_.rate.across}};
    lap_.exit = lap_.next.layer;
    lap_.sequence.count = ZoneSequence::kCapacity + 1;  // no lap follows this one
    if (!n_.full) {
      const LayerMotion<S> motion(n_.inertia, n_.damping);
      const S flight = 2 * pi - 2.0 * n_.half_angle;
      const bool rests = enters_at_rest(n_, motion);
      for (LayerState<S>* layer : {&lap_.next.layer, &lap_.next.across}) {
        const LayerState<S> out = *layer;
        *layer = rests ? LayerState<S>{S(0.0), S(0.0)} : motion.at(motion.start(out), flight);
        m.layer_loss +=
            0.5 * (motion.energy(motion.own_part(out)) - motion.energy(*layer)) / n_.stick_rate;
      }
    }
    if (values_.damping == 0) m.layer_loss = S(0.0);
    const double mean = 1 / (2 * pi);
    m.traction *= mean, m.stator_power *= mean, m.friction_power *= mean, m.layer_loss *= mean;
    m.reactive_force *= mean;
  }

  static constexpr int kMostSteps = 100'000;

  const ContactNumbers<S>& n_;
  ContactNumbers<double> values_;
  const RadialSteps& steps_;
  std::size_t followed_{0};  // of the known steps
  Lap<S>& lap_;
  S theta_;
  Trig<S> at_;
  PlaneState<S> layer_;
  double first_length_{0.3};
  int stalled_{0};
  bool sticks_{true}, done_{false};
};

}  // namespace

template <typename S>
Lap<S> run_radial_lap(const ContactNumbers<S>& numbers, const LapEntry<S>& entry,
                      const RadialSteps& steps) {
  Lap<S> lap;
  RadialRunner<S>(numbers, steps, lap).run(entry);
  return lap;
}

#define TWUM_INSTANTIATE(S) \
  template Lap<S> run_radial_lap(const ContactNumbers<S>&, const LapEntry<S>&, const RadialSteps&);
TWUM_FOR_EACH_CONTACT_SCALAR(TWUM_INSTANTIATE)
TWUM_INSTANTIATE(PlaneDual)
TWUM_INSTANTIATE(WithPlaneState<MotionDual>::Type)
TWUM_INSTANTIATE(WithPlaneState<NumbersDual>::Type)
#undef TWUM_INSTANTIATE

}  // namespace twum::inline v0_1::contact
