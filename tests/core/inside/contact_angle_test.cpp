// SPDX-License-Identifier: Apache-2.0
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <twum/core/normal_contact.hpp>

#include <cmath>
#include <numbers>

using namespace twum;
using namespace twum::test;

namespace {

// sin t - t cos t by its power series in long double, the sum of (-1)^(k+1) 2 k t^(2k+1) / (2k+1)!: up to pi
// 40 terms leave nothing of it, and its largest term, 5, costs one digit of 19.
long double load_of(long double t) {
  long double term = t * t * t / 6, sum = 0;  // t^(2k+1) / (2k+1)! with its sign
  for (int k = 1; k <= 40; ++k) {
    sum += 2 * static_cast<long double>(k) * term;
    term *= -t * t / static_cast<long double>((2 * k + 2) * (2 * k + 3));
  }
  return sum;
}

}  // namespace

TEST_CASE("the half angle carries its load (T3.2) however near that is to full contact",
          "[core][contact][closed_form]") {
  Dice dice(61);
  for (int i = 0; i < 2000; ++i) {
    const double load = std::numbers::pi * (1 - dice.log_uniform(1e-10, 0.3));
    const double angle = contact_half_angle(load);
    CAPTURE(i, load, angle);
    CHECK(angle > 0);
    CHECK(angle <= std::numbers::pi);
    // The program sees the load as sin t - t cos t, three roundings of numbers up to pi, 1e-15 in all. It stops where what it
    // sees is right to 5e-16, 1.6e-15 of pi, or after a step whose third power is nothing.
    CHECK(std::fabs(static_cast<double>(load_of(angle) - static_cast<long double>(load))) <=
          2.6e-15);
  }
}

TEST_CASE("the half angles of the load's series (T3.2) are good to rounding",
          "[core][contact][closed_form]") {
  Dice dice(62);
  for (int i = 0; i < 2000; ++i) {
    const double exact = dice.uniform(0.3, 0.7);
    const double angle = contact_half_angle(static_cast<double>(load_of(exact)));
    CAPTURE(i, exact);
    // A relative error of the load makes a third of it in the angle: 1.1e-16 of rounding it and some 6 roundings
    // and 5e-16 of dropped terms in the program's own series are 6e-16 in all. The angle's last sum adds 1.1e-16.
    CHECK(std::fabs(angle - exact) <= 1e-15 * exact);
  }
}
