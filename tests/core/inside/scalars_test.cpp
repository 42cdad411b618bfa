// SPDX-License-Identifier: Apache-2.0
#include "contact/scalars.hpp"
#include "contact/periodic_state.hpp"
#include "in_scalar.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <type_traits>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

template <typename S>
ContactMeans<S> means_in(const ContactNumbers<double>& n, const PeriodicState& state) {
  return periodic_means(in_scalar<S>(n), n, state);
}
template <>
ContactMeans<MotionDual> means_in(const ContactNumbers<double>& n, const PeriodicState& state) {
  return moving_means(in_scalar<MotionDual>(n), state, Means::all).means;
}

template <typename S>
void check_same_bits(const ContactNumbers<double>& n) {
  const PeriodicState state = find_periodic_state(n, LayerMotion<double>(n.inertia, n.damping));
  if (state.status != PeriodicStatus::ok) return;
  const ContactMeans<S> m = means_in<S>(n, state);
  const ContactMeans<double>& d = state.lap.means;
  CHECK(value_of(m.traction) == d.traction);
  CHECK(value_of(m.stator_power) == d.stator_power);
  if (!std::is_same_v<S, NumbersDual2>) {  // its laps leave them out
    CHECK(value_of(m.friction_power) == d.friction_power);
    CHECK(value_of(m.layer_loss) == d.layer_loss);
  }
  CHECK(value_of(m.stick_length) == d.stick_length);
  CHECK(value_of(m.reactive_force) == d.reactive_force);
}

// The return map alone: its laps have no means.
void check_same_return(const ContactNumbers<double>& n) {
  const PeriodicState state = find_periodic_state(n, LayerMotion<double>(n.inertia, n.damping));
  if (state.status != PeriodicStatus::ok) return;
  const ContactNumbers<StateDual> k = in_scalar<StateDual>(n);
  const LapEntry<StateDual> entry{
      {StateDual(state.entry.layer.e), StateDual(state.entry.layer.rate)},
      state.entry.carried,
      state.entry.zone};
  const LayerState<StateDual> next =
      run_lap(k, {k.inertia, k.damping}, entry, &state.lap.sequence).next.layer;
  CHECK(value_of(next.e) == state.lap.next.layer.e);
  CHECK(value_of(next.rate) == state.lap.next.layer.rate);
}

}  // namespace

TEST_CASE("the derivative path gives the bits of the double path", "[core][derivative][identity]") {
  Dice dice(51);
  for (int i = 0; i < 600; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i, i % 3 == 0);
    check_same_bits<MotionDual>(n);
    check_same_return(n);
    check_same_bits<NumbersDual>(n);
    check_same_bits<NumbersDual2>(n);
  }
}

TEST_CASE("dual numbers obey the rules of differentiation", "[core][derivative][closed_form]") {
  using D = Dual<double, 2>;
  const D x = D::variable(0.7, 0), y = D::variable(1.3, 1);
  const auto check = [](const D& f, double value, double dx, double dy) {
    // One or two roundings of numbers of order one.
    CHECK(std::fabs(f.v - value) < 4e-16);
    CHECK(std::fabs(f.d[0] - dx) < 1e-15);
    CHECK(std::fabs(f.d[1] - dy) < 1e-15);
  };
  check(x * y, 0.91, 1.3, 0.7);
  check(x / y, 0.7 / 1.3, 1 / 1.3, -0.7 / (1.3 * 1.3));
  check(1.0 / x - y, 1 / 0.7 - 1.3, -1 / 0.49, -1);
  check(sin(x) * exp(y), std::sin(0.7) * std::exp(1.3), std::cos(0.7) * std::exp(1.3),
        std::sin(0.7) * std::exp(1.3));
  check(sqrt(x) + cos(y) * 2.0, std::sqrt(0.7) + 2 * std::cos(1.3), 0.5 / std::sqrt(0.7),
        -2 * std::sin(1.3));
  check(-(3.0 - x) + y / 2.0, -2.3 + 0.65, 1, 0.5);
  check(x + 2.0, 2.7, 1, 0);
  check(y - 2.0, -0.7, 0, 1);
  D z = x;
  z += y, z *= 2.0, z -= x;
  check(z, 0.7 + 2.6, 1, 2);
}

TEST_CASE("nested dual numbers carry second derivatives", "[core][derivative][closed_form]") {
  using D = Dual<Dual<double, 1>, 1>;
  const double a = 0.6;
  D x;
  x.v = Dual<double, 1>::variable(a, 0);
  x.d[0] = 1.0;
  const D f = exp(x) * sin(x);
  // (e^x sin x)'' = 2 e^x cos x
  CHECK(std::fabs(f.d[0].d[0] - 2 * std::exp(a) * std::cos(a)) < 2e-15);
}
