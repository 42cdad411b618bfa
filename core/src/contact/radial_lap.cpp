// SPDX-License-Identifier: Apache-2.0
#include "contact/radial_lap.hpp"

#include "contact/first_zero.hpp"
#include "contact/layer_motion.hpp"
#include "contact/slip_step_solve.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace twum::contact {
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

// Strain of a layer that sticks from here on: e' = s (cos theta - V, q sin theta) (R2.2).
template <typename S>
PlaneWave<S> carried_strain(const ContactNumbers<S>& n, const S& theta, const Trig<S>& at,
                            const Plane<S>& e) {
  const S& s = n.stick_rate;
  const S zero(0.0), drift = -(s * n.speed_ratio);
  PlaneWave<S> wave{{zero, zero}, {drift, zero}, {zero, -(s * n.radial)}, {s, zero}};
  wave.constant = e - wave.at(theta, at);
  return wave;
}

// Its traction, M e'' + C e' + e.
template <typename S>
PlaneWave<S> carried_traction(const ContactNumbers<S>& n, const PlaneWave<S>& e) {
  const S rest = 1.0 - n.inertia;
  return {e.constant + n.damping * e.drift, e.drift, rest * e.cosine + n.damping * e.sine,
          rest * e.sine - n.damping * e.cosine};
}

// What is left to the threshold, f = mu_0^2 p^2 - |t|^2 (R3.2), along a stick zone, with bounds of its derivatives as long as it is
// positive: there |t| <= mu_0 p.
class Reserve {
 public:
  Reserve(const ContactNumbers<double>& n, const PlaneWave<double>& t, double theta,
          const Trig<double>& at)
      : n_(n), t_(t), theta_(theta), at_(at) {
    const double swing = length(t.cosine) + length(t.sine), rate = length(t.drift) + swing;
    const double square = n.threshold * n.threshold, size = n.threshold * n.peak;
    second_ = 2 * square * (1 + n.peak) + 2 * (rate * rate + size * swing);
    third_ = 2 * square * (3 + n.peak) + 2 * (3 * rate * swing + size * swing);
  }

  CurveSample first() const { return sample_at(theta_, at_); }
  CurveSample sample(double x) const { return sample_at(theta_ + x, trig(theta_ + x)); }
  CurveSample terms(double x) const { return sample(x); }

 private:
  CurveSample sample_at(double theta, const Trig<double>& a) const {
    const double k = n_.threshold * n_.threshold, p = n_.peak - a.versine;
    const Plane<double> t = t_.at(theta, a), t1 = t_.slope(a), t2 = t_.bend(a), t3 = t_.drift - t1;
    return {k * p * p - dot(t, t),
            2 * (-k * p * a.sin - dot(t, t1)),
            2 * (k * (a.sin * a.sin - p * a.cos) - dot(t1, t1) - dot(t, t2)),
            second_,
            third_,
            0,
            2 * (k * a.sin * (3 * a.cos + p) - 3 * dot(t1, t2) - dot(t, t3))};
  }

  const ContactNumbers<double>& n_;
  PlaneWave<double> t_;
  double theta_;
  Trig<double> at_;
  double second_, third_;
};

template <typename S>
class RadialRunner {
 public:
  RadialRunner(const ContactNumbers<S>& numbers, std::vector<RadialPiece>* trace, Lap<S>& lap)
      : n_(numbers), values_(twum::contact::values_of(numbers)), trace_(trace), lap_(lap) {}

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
  static constexpr double kStalled = 1e-10;  // [rad]
  static constexpr double kLastTerm = 1e-4;  // of mu p(0), of a step as long as the contact

  bool elastic() const { return values_.inertia == 0 && values_.damping == 0; }

  // Without inertia and damping the layer enters at rest and sticks where the wave shears it slower than the threshold grows.
  bool sticks_at_entry() const {
    if (!elastic()) return false;
    const Plane<double> v = surface_motion(values_, trig_here()).velocity;
    return values_.stick_rate * length(v) <= values_.kinetic * values_.edge.sin;
  }

  // An elastic layer snaps from mu_0 p to mu p when it is released (T4.4). It sticks again if slip would be backward.
  bool sticks_again() {
    if (!elastic() || !(values_.threshold > values_.kinetic)) return false;
    const S p = n_.peak - at_.versine;
    const S before = n_.threshold * p, after = n_.kinetic * p;
    lap_.means.friction_power += 0.5 * (before * before - after * after) / n_.stick_rate;
    lap_.itinerary = marked(lap_.itinerary, 7);
    layer_.e = S(after / before) * layer_.e;
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
    x == kNoZero ? reach_exit() : advance(released(t, x));
    add_stick(t, e, from, at_from);
    if (trace_)
      trace_->push_back(
          {value_of(from),
           value_of(theta_),
           ZoneState::stick,
           {values_of(e.constant), values_of(e.drift), values_of(e.cosine), values_of(e.sine)},
           {},
           {},
           {}});
    layer_ = {e.at(theta_, at_), e.slope(at_)};
  }

  // To where the traction reaches its threshold, kNoZero if it does not. Events that pile up within rounding of one place, where
  // it only touches, are passed by.
  double stick_length(const PlaneWave<double>& t, StartOrder order) const {
    long work = 0;
    const auto length_from = [&](double skipped, StartOrder known) {
      const double from = value_of(theta_) + skipped;
      const Trig<double> at = skipped > 0 ? trig(from) : trig_here();
      return first_zero(Reserve(values_, t, from, at), left() - skipped, known, work, 100'000);
    };
    const double x = length_from(0, order);
    const double passed = stalled_ > 4 ? std::ldexp(kStalled, std::min(stalled_ - 4, 30)) : 0;
    if (!(x < passed)) return x;
    return passed < left() ? passed + length_from(passed, StartOrder::positive) : kNoZero;
  }

  // Where the traction reaches its threshold, in S.
  S released(const PlaneWave<S>& t, double x) const {
    S length(x);
    for (int i = 0; i < kDualDepth<S>; ++i) {
      const S theta = theta_ + length;
      const Trig<S> a = trig(theta);
      const S p = n_.peak - a.versine, k = n_.threshold * n_.threshold;
      const Plane<S> traction = t.at(theta, a);
      const S f = k * p * p - dot(traction, traction);
      const S slope = -2.0 * (k * p * a.sin + dot(traction, t.slope(a)));
      length = with_value(S(length - with_value(f, 0.0) / value_of(slope)), x);
    }
    return length;
  }

  // Means of a stick zone. Its tractions are waves, so that Gauss' rule would do; the closed forms are shorter.
  void add_stick(const PlaneWave<S>& t, const PlaneWave<S>& e, const S& from,
                 const Trig<S>& at_from) {
    ContactMeans<S>& m = lap_.means;
    const S span = theta_ - from;
    m.stick_length += span;
    // Integrals of 1, theta, cos, sin times 1, cos, sin.
    const S d_sin = at_.sin - at_from.sin, d_cos = at_.cos - at_from.cos;
    const S cos_cos = 0.5 * (span + at_.sin * at_.cos - at_from.sin * at_from.cos);
    const S sin_sin = span - cos_cos,
            sin_cos = 0.5 * (at_.sin * at_.sin - at_from.sin * at_from.sin);
    const S theta_1 = 0.5 * (theta_ * theta_ - from * from);
    const S theta_cos = theta_ * at_.sin - from * at_from.sin + d_cos;
    const S theta_sin = d_sin - (theta_ * at_.cos - from * at_from.cos);
    const auto with_one = [&](const S& c, const S& b, const S& k, const S& s) {
      return c * span + b * theta_1 + k * d_sin - s * d_cos;
    };
    const auto with_cos = [&](const S& c, const S& b, const S& k, const S& s) {
      return c * d_sin + b * theta_cos + k * cos_cos + s * sin_cos;
    };
    const auto with_sin = [&](const S& c, const S& b, const S& k, const S& s) {
      return b * theta_sin - c * d_cos + k * sin_cos + s * sin_sin;
    };
    const auto along = [&t](const auto& integral) {
      return integral(t.constant.along, t.drift.along, t.cosine.along, t.sine.along);
    };
    const auto across = [&t](const auto& integral) {
      return integral(t.constant.across, t.drift.across, t.cosine.across, t.sine.across);
    };
    m.traction += along(with_one);
    m.stator_power += along(with_cos) + n_.radial * across(with_sin);
    m.reactive_force += along(with_sin) - n_.radial * across(with_cos);
    if (values_.damping == 0) return;
    // e' of e, squared.
    const S b = e.drift.along, k = e.sine.along, q = e.cosine.across;
    m.layer_loss += (n_.damping / n_.stick_rate) *
                    (b * b * span + 2.0 * b * k * d_sin + k * k * cos_cos + q * q * sin_sin);
  }

  void slip() {
    std::optional<Angles> last;
    double last_length = 0, length = std::fmin(left(), first_length_);
    for (int i = 0; i < kMostSteps; ++i) {
      const double rest = left();
      const bool to_exit = length >= rest * (1 - 1e-12);
      if (to_exit) length = rest;
      SlipStep<double> step = step_of(length, to_exit);
      const bool solved = (last && step.solve(angles_at(*last, 1, length / last_length))) ||
                          step.solve(step.euler_angles());
      if (!solved) {
        length *= 0.25;
        if (length < 1e-13) return fail();
        continue;
      }
      const double error = step.last_term() * length / (2 * value_of(n_.half_angle)) / kLastTerm;
      if (error > 1 && length > 1e-9) {
        length *= std::fmax(0.1, 0.85 * std::pow(error, -0.2));
        continue;
      }
      const double place = end_of_slip(step);
      if (place == 0) {
        length *= Collocation::points().place[0];
        if (length < kStalled) return;  // it hardly begins
        continue;
      }
      if (place < 1) return finish(step, length, place);
      accept(step, length, to_exit);
      if (to_exit) return;
      last = step.angles(), last_length = length;
      first_length_ = length;
      length =
          std::fmin(length * std::fmin(3.0, 0.85 * std::pow(std::fmax(error, 1e-4), -0.2)), left());
    }
    fail();
  }

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
  // zone begins with no slip, so a zero there may be its start.
  static double end_of_slip(const SlipStep<double>& step) {
    const Collocation& c = Collocation::points();
    Angles slip;
    for (std::size_t i = 0; i < Collocation::N; ++i) slip[i] = step.slip(i);
    const auto below = std::find_if(slip.begin(), slip.end(), [](double x) { return x < 0; });
    if (below == slip.end()) return 1;
    if (below == slip.begin()) return 0;
    const auto i = static_cast<std::size_t>(below - slip.begin());
    double low = c.place[i - 1], high = c.place[i];
    while (high - low > 1e-6) {
      const double middle = 0.5 * (low + high);
      const Collocation::Row w = c.weights_at(middle);
      double f = 0;
      for (std::size_t j = 0; j < Collocation::N; ++j) f += w[j] * slip[j];
      (f < 0 ? high : low) = middle;
    }
    return 0.5 * (low + high);
  }

  // The step that ends where slip does.
  void finish(const SlipStep<double>& whole, double length, double place) {
    const Collocation& c = Collocation::points();
    double end = place * length;
    Angles guess = angles_at(whole.angles(), 0, place);
    for (int i = 0; i < 20; ++i) {
      SlipStep<double> step = step_of(end, false);
      if (!step.solve(guess) && !step.solve(step.euler_angles())) return fail();
      double slope = 0;
      for (std::size_t j = 0; j < Collocation::N; ++j) slope += c.slope_at_end[j] * step.slip(j);
      const double move = -step.slip(Collocation::N - 1) / slope * end;
      if (std::fabs(move) <= 1e-13 * end || i == 19) return accept_end(step, end, slope / end);
      guess = step.angles();
      end += std::clamp(move, -0.5 * end, 0.5 * end);
    }
  }

  void accept(const SlipStep<double>& step, double length, bool to_exit) {
    trace(step, length);
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
    trace(step, length);
    S span(length);
    if constexpr (kDualDepth < S >> 0) {
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

  void trace(const SlipStep<double>& step, double length) {
    if (!trace_) return;
    const double from = value_of(theta_);
    const ZoneState side = std::cos(step.angles()[Collocation::N / 2]) < 0 ? ZoneState::slip_minus
                                                                           : ZoneState::slip_plus;
    trace_->push_back(
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
  std::vector<RadialPiece>* trace_;
  Lap<S>& lap_;
  S theta_;
  Trig<S> at_;
  PlaneState<S> layer_;
  double first_length_{0.3};
  int stalled_{0};
  bool sticks_{true}, done_{false};
};

}  // namespace

RadialSample sample_of(const RadialPiece& piece, const ContactNumbers<double>& n, double theta) {
  const Trig<double> at = trig(theta);
  if (piece.zone == ZoneState::stick) {
    const Plane<double> strain = piece.strain.at(theta, at);
    return {strain, piece.strain.slope(at), carried_traction(n, piece.strain).at(theta, at)};
  }
  const Collocation& c = Collocation::points();
  const double length = piece.to - piece.from, place = (theta - piece.from) / length;
  const Collocation::Row here = c.weights_at(place);
  RadialSample sample{piece.start.e, {0, 0}, {0, 0}};
  double angle = 0;
  for (std::size_t i = 0; i < Collocation::N; ++i) {
    angle += here[i] * piece.angles[i];
    sample.rate = sample.rate + here[i] * piece.rates[i];
    // The polynomial's integral is one of degree N, which the points integrate exactly over a part of the step.
    const Collocation::Row part = c.weights_at(place * c.place[i]);
    for (std::size_t j = 0; j < Collocation::N; ++j)
      sample.strain =
          sample.strain +
          (length * place * c.integral[Collocation::N - 1][i] * part[j]) * piece.rates[j];
  }
  const double size = n.kinetic * std::fmax(n.peak - at.versine, 0.0);
  sample.traction = {size * std::cos(angle), size * std::sin(angle)};
  return sample;
}

template <typename S>
Lap<S> run_radial_lap(const ContactNumbers<S>& numbers, const LapEntry<S>& entry,
                      std::vector<RadialPiece>* trace) {
  Lap<S> lap;
  RadialRunner<S>(numbers, trace, lap).run(entry);
  return lap;
}

#define TWUM_INSTANTIATE(S)                                                    \
  template Lap<S> run_radial_lap(const ContactNumbers<S>&, const LapEntry<S>&, \
                                 std::vector<RadialPiece>*);
TWUM_FOR_EACH_CONTACT_SCALAR(TWUM_INSTANTIATE)
TWUM_INSTANTIATE(PlaneDual)
TWUM_INSTANTIATE(WithPlaneState<MotionDual>::Type)
TWUM_INSTANTIATE(WithPlaneState<NumbersDual>::Type)
#undef TWUM_INSTANTIATE

}  // namespace twum::contact
