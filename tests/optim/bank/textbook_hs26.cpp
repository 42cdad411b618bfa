// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/textbook_parts.hpp"

namespace twum::test {
namespace {

using D = T20;

// Objective of HS51 and HS53, without its first term.
D last_terms(const D* x) { return sq(x[1] + x[2] - 2.0) + sq(x[3] - 1.0) + sq(x[4] - 1.0); }

void add_three_variables(TextbookBuilder& b) {
  b.add("HS26", 0.0, {anywhere(-2.6), anywhere(2), anywhere(2)}, 0, 1, [](const D* x, D* r) {
    r[0] = sq(x[0] - x[1]) + fourth(x[1] - x[2]);
    r[1] = (1.0 + sq(x[1])) * x[0] + fourth(x[2]) - 3.0;
  });
  b.add("HS27", 0.04, times(3, anywhere(2)), 0, 1, [](const D* x, D* r) {
    r[0] = 0.01 * sq(x[0] - 1.0) + sq(x[1] - sq(x[0]));
    r[1] = x[0] + sq(x[2]) + 1.0;
  });
  b.add("HS28", 0.0, {anywhere(-4), anywhere(1), anywhere(1)}, 0, 1, [](const D* x, D* r) {
    r[0] = sq(x[0] + x[1]) + sq(x[1] + x[2]);
    r[1] = x[0] + 2.0 * x[1] + 3.0 * x[2] - 1.0;
  });
  b.add("HS29", -16.0 * std::sqrt(2.0), times(3, anywhere(1)), 1, 0, [](const D* x, D* r) {
    r[0] = -(x[0] * x[1] * x[2]);
    r[1] = 48.0 - sq(x[0]) - 2.0 * sq(x[1]) - 4.0 * sq(x[2]);
  });
  b.add("HS30", 1.0, {{1, 10, 1}, {-10, 10, 1}, {-10, 10, 1}}, 1, 0, [](const D* x, D* r) {
    r[0] = sq(x[0]) + sq(x[1]) + sq(x[2]);
    r[1] = sq(x[0]) + sq(x[1]) - 1.0;
  });
  b.add("HS31", 6.0, {{-10, 10, 1}, {1, 10, 1}, {-10, 1, 1}}, 1, 0, [](const D* x, D* r) {
    r[0] = 9.0 * sq(x[0]) + sq(x[1]) + 9.0 * sq(x[2]);
    r[1] = x[0] * x[1] - 1.0;
  });
  b.add("HS32", 1.0, {at_least(0, 0.1), at_least(0, 0.7), at_least(0, 0.2)}, 1, 1,
        [](const D* x, D* r) {
          r[0] = sq(x[0] + 3.0 * x[1] + x[2]) + 4.0 * sq(x[0] - x[1]);
          r[1] = 6.0 * x[1] + 4.0 * x[2] - cube(x[0]) - 3.0;
          r[2] = 1.0 - x[0] - x[1] - x[2];
        });
  b.add("HS33", std::sqrt(2.0) - 6.0, {at_least(0, 0), at_least(0, 0), {0, 5, 3}}, 2, 0,
        [](const D* x, D* r) {
          r[0] = (x[0] - 1.0) * (x[0] - 2.0) * (x[0] - 3.0) + x[2];
          r[1] = sq(x[2]) - sq(x[1]) - sq(x[0]);
          r[2] = sq(x[0]) + sq(x[1]) + sq(x[2]) - 4.0;
        });
  b.add("HS34", -std::log(std::log(10.0)), {{0, 100, 0}, {0, 100, 1.05}, {0, 10, 2.9}}, 2, 0,
        [](const D* x, D* r) {
          r[0] = -x[0];
          r[1] = x[1] - expo(x[0]);
          r[2] = x[2] - expo(x[1]);
        });
  b.add("HS35", 1.0 / 9.0, times(3, at_least(0, 0.5)), 1, 0, [](const D* x, D* r) {
    r[0] = 9.0 - 8.0 * x[0] - 6.0 * x[1] - 4.0 * x[2] + 2.0 * sq(x[0]) + 2.0 * sq(x[1]) + sq(x[2]) +
           2.0 * x[0] * x[1] + 2.0 * x[0] * x[2];
    r[1] = 3.0 - x[0] - x[1] - 2.0 * x[2];
  });
  b.add("HS36", -3300.0, {{0, 20, 10}, {0, 11, 10}, {0, 42, 10}}, 1, 0, [](const D* x, D* r) {
    r[0] = -(x[0] * x[1] * x[2]);
    r[1] = 72.0 - x[0] - 2.0 * x[1] - 2.0 * x[2];
  });
  b.add("HS37", -3456.0, times(3, {0, 42, 10}), 2, 0, [](const D* x, D* r) {
    r[0] = -(x[0] * x[1] * x[2]);
    r[1] = 72.0 - x[0] - 2.0 * x[1] - 2.0 * x[2];
    r[2] = x[0] + 2.0 * x[1] + 2.0 * x[2];
  });
}

void add_four_variables(TextbookBuilder& b) {
  b.add("HS38", 0.0, {{-10, 10, -3}, {-10, 10, -1}, {-10, 10, -3}, {-10, 10, -1}}, 0, 0,
        [](const D* x, D* r) {
          r[0] = 100.0 * sq(x[1] - sq(x[0])) + sq(1.0 - x[0]) + 90.0 * sq(x[3] - sq(x[2])) +
                 sq(1.0 - x[2]) + 10.1 * (sq(x[1] - 1.0) + sq(x[3] - 1.0)) +
                 19.8 * (x[1] - 1.0) * (x[3] - 1.0);
        });
  b.add("HS39", -1.0, times(4, anywhere(2)), 0, 2, [](const D* x, D* r) {
    r[0] = -x[0];
    r[1] = x[1] - cube(x[0]) - sq(x[2]);
    r[2] = sq(x[0]) - x[1] - sq(x[3]);
  });
  b.add("HS40", -0.25, times(4, anywhere(0.8)), 0, 3, [](const D* x, D* r) {
    r[0] = -(x[0] * x[1] * x[2] * x[3]);
    r[1] = cube(x[0]) + sq(x[1]) - 1.0;
    r[2] = sq(x[0]) * x[3] - x[2];
    r[3] = sq(x[3]) - x[1];
  });
  b.add("HS41", 52.0 / 27.0, {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 2, 2}}, 0, 1,
        [](const D* x, D* r) {
          r[0] = 2.0 - x[0] * x[1] * x[2];
          r[1] = x[0] + 2.0 * x[1] + 2.0 * x[2] - x[3];
        });
  b.add("HS42", 28.0 - 10.0 * std::sqrt(2.0), times(4, anywhere(1)), 0, 2, [](const D* x, D* r) {
    r[0] = sq(x[0] - 1.0) + sq(x[1] - 2.0) + sq(x[2] - 3.0) + sq(x[3] - 4.0);
    r[1] = x[0] - 2.0;
    r[2] = sq(x[2]) + sq(x[3]) - 2.0;
  });
  b.add("HS43", -44.0, times(4, anywhere(0)), 3, 0, [](const D* x, D* r) {
    r[0] = sq(x[0]) + sq(x[1]) + 2.0 * sq(x[2]) + sq(x[3]) - 5.0 * x[0] - 5.0 * x[1] - 21.0 * x[2] +
           7.0 * x[3];
    r[1] = 8.0 - sq(x[0]) - sq(x[1]) - sq(x[2]) - sq(x[3]) - x[0] + x[1] - x[2] + x[3];
    r[2] = 10.0 - sq(x[0]) - 2.0 * sq(x[1]) - sq(x[2]) - 2.0 * sq(x[3]) + x[0] + x[3];
    r[3] = 5.0 - 2.0 * sq(x[0]) - sq(x[1]) - sq(x[2]) - 2.0 * x[0] + x[1] + x[3];
  });
  b.add("HS44", -15.0, times(4, at_least(0, 0)), 6, 0, [](const D* x, D* r) {
    r[0] = x[0] - x[1] - x[2] - x[0] * x[2] + x[0] * x[3] + x[1] * x[2] - x[1] * x[3];
    r[1] = 8.0 - x[0] - 2.0 * x[1];
    r[2] = 12.0 - 4.0 * x[0] - x[1];
    r[3] = 12.0 - 3.0 * x[0] - 4.0 * x[1];
    r[4] = 8.0 - 2.0 * x[2] - x[3];
    r[5] = 8.0 - x[2] - 2.0 * x[3];
    r[6] = 5.0 - x[2] - x[3];
  });
}

void add_more_variables(TextbookBuilder& b) {
  b.add("HS45", 1.0, {{0, 1, 2}, {0, 2, 2}, {0, 3, 2}, {0, 4, 2}, {0, 5, 2}}, 0, 0,
        [](const D* x, D* r) { r[0] = 2.0 - x[0] * x[1] * x[2] * x[3] * x[4] / 120.0; });
  b.add("HS46", 0.0,
        {anywhere(std::sqrt(0.5)), anywhere(1.75), anywhere(0.5), anywhere(2), anywhere(2)}, 0, 2,
        [](const D* x, D* r) {
          r[0] = sq(x[0] - x[1]) + sq(x[2] - 1.0) + fourth(x[3] - 1.0) + sq(cube(x[4] - 1.0));
          r[1] = sq(x[0]) * x[3] + sine(x[3] - x[4]) - 1.0;
          r[2] = x[1] + fourth(x[2]) * sq(x[3]) - 2.0;
        });
  b.add("HS48", 0.0, {anywhere(3), anywhere(5), anywhere(-3), anywhere(2), anywhere(-2)}, 0, 2,
        [](const D* x, D* r) {
          r[0] = sq(x[0] - 1.0) + sq(x[1] - x[2]) + sq(x[3] - x[4]);
          r[1] = x[0] + x[1] + x[2] + x[3] + x[4] - 5.0;
          r[2] = x[2] - 2.0 * (x[3] + x[4]) + 3.0;
        });
  b.add("HS49", 0.0, {anywhere(10), anywhere(7), anywhere(2), anywhere(-3), anywhere(0.8)}, 0, 2,
        [](const D* x, D* r) {
          r[0] = sq(x[0] - x[1]) + sq(x[2] - 1.0) + fourth(x[3] - 1.0) + sq(cube(x[4] - 1.0));
          r[1] = x[0] + x[1] + x[2] + 4.0 * x[3] - 7.0;
          r[2] = x[2] + 5.0 * x[4] - 6.0;
        });
  b.add("HS50", 0.0, {anywhere(35), anywhere(-31), anywhere(11), anywhere(5), anywhere(-5)}, 0, 3,
        [](const D* x, D* r) {
          r[0] = sq(x[0] - x[1]) + sq(x[1] - x[2]) + fourth(x[2] - x[3]) + sq(x[3] - x[4]);
          for (int i = 0; i < 3; ++i) r[1 + i] = x[i] + 2.0 * x[i + 1] + 3.0 * x[i + 2] - 6.0;
        });
  b.add("HS51", 0.0, {anywhere(2.5), anywhere(0.5), anywhere(2), anywhere(-1), anywhere(0.5)}, 0, 3,
        [](const D* x, D* r) {
          r[0] = sq(x[0] - x[1]) + last_terms(x);
          r[1] = x[0] + 3.0 * x[1] - 4.0;
          r[2] = x[2] + x[3] - 2.0 * x[4];
          r[3] = x[1] - x[4];
        });
  b.add("HS52", 1859.0 / 349.0, times(5, anywhere(2)), 0, 3, [](const D* x, D* r) {
    r[0] = sq(4.0 * x[0] - x[1]) + last_terms(x);
    r[1] = x[0] + 3.0 * x[1];
    r[2] = x[2] + x[3] - 2.0 * x[4];
    r[3] = x[1] - x[4];
  });
  b.add("HS53", 176.0 / 43.0, times(5, {-10, 10, 2}), 0, 3, [](const D* x, D* r) {
    r[0] = sq(x[0] - x[1]) + last_terms(x);
    r[1] = x[0] + 3.0 * x[1];
    r[2] = x[2] + x[3] - 2.0 * x[4];
    r[3] = x[1] - x[4];
  });
  b.add("HS55", 19.0 / 3.0,
        {{0, 1, 1}, at_least(0, 2), at_least(0, 0), {0, 1, 0}, at_least(0, 0), at_least(0, 2)}, 0,
        6, [](const D* x, D* r) {
          r[0] = x[0] + 2.0 * x[1] + 4.0 * x[4] + expo(x[0] * x[3]);
          r[1] = x[0] + 2.0 * x[1] + 5.0 * x[4] - 6.0;
          r[2] = x[0] + x[1] + x[2] - 3.0;
          r[3] = x[3] + x[4] + x[5] - 2.0;
          r[4] = x[0] + x[3] - 1.0;
          r[5] = x[1] + x[4] - 2.0;
          r[6] = x[2] + x[5] - 2.0;
        });
  const double a = std::asin(std::sqrt(1.0 / 4.2)), c = std::asin(std::sqrt(5.0 / 7.2));
  b.add("HS56", -3.456,
        {anywhere(1), anywhere(1), anywhere(1), anywhere(a), anywhere(a), anywhere(a), anywhere(c)},
        0, 4, [](const D* x, D* r) {
          r[0] = -(x[0] * x[1] * x[2]);
          for (int i = 0; i < 3; ++i) r[1 + i] = x[i] - 4.2 * sq(sine(x[3 + i]));
          r[4] = x[0] + 2.0 * x[1] + 2.0 * x[2] - 7.2 * sq(sine(x[6]));
        });
}

}  // namespace

void add_hs_26_to_56(TextbookBuilder& b) {
  add_three_variables(b);
  add_four_variables(b);
  add_more_variables(b);
}

}  // namespace twum::test
