// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/textbook_parts.hpp"

namespace twum::test {
namespace {

using D = T20;

D banana(const D* x) { return 100.0 * sq(x[1] - sq(x[0])) + sq(1.0 - x[0]); }

}  // namespace

void add_hs_1_to_24(TextbookBuilder& b) {
  const double root3 = std::sqrt(3.0), pi = std::acos(-1.0);
  b.add("HS1", 0.0, {anywhere(-2), at_least(-1.5, 1)}, 0, 0,
        [](const D* x, D* r) { r[0] = banana(x); });
  b.add("HS2", 0.0504261879, {anywhere(-2), at_least(1.5, 1)}, 0, 0,
        [](const D* x, D* r) { r[0] = banana(x); });
  b.add("HS3", 0.0, {anywhere(10), at_least(0, 1)}, 0, 0,
        [](const D* x, D* r) { r[0] = x[1] + 1e-5 * sq(x[1] - x[0]); });
  b.add("HS4", 8.0 / 3.0, {at_least(1, 1.125), at_least(0, 0.125)}, 0, 0,
        [](const D* x, D* r) { r[0] = cube(x[0] + 1.0) / 3.0 + x[1]; });
  b.add("HS5", -root3 / 2.0 - pi / 3.0, {{-1.5, 4, 0}, {-3, 3, 0}}, 0, 0, [](const D* x, D* r) {
    r[0] = sine(x[0] + x[1]) + sq(x[0] - x[1]) - 1.5 * x[0] + 2.5 * x[1] + 1.0;
  });
  b.add("HS6", 0.0, {anywhere(-1.2), anywhere(1)}, 0, 1, [](const D* x, D* r) {
    r[0] = sq(1.0 - x[0]);
    r[1] = 10.0 * (x[1] - sq(x[0]));
  });
  b.add("HS7", -root3, times(2, anywhere(2)), 0, 1, [](const D* x, D* r) {
    r[0] = ln(1.0 + sq(x[0])) - x[1];
    r[1] = sq(1.0 + sq(x[0])) + sq(x[1]) - 4.0;
  });
  b.add("HS8", -1.0, {anywhere(2), anywhere(1)}, 0, 2, [](const D* x, D* r) {
    r[0] = D(-1.0);
    r[1] = sq(x[0]) + sq(x[1]) - 25.0;
    r[2] = x[0] * x[1] - 9.0;
  });
  b.add("HS9", -0.5, times(2, anywhere(0)), 0, 1, [pi](const D* x, D* r) {
    r[0] = sine(pi / 12.0 * x[0]) * cosine(pi / 16.0 * x[1]);
    r[1] = 4.0 * x[0] - 3.0 * x[1];
  });
  b.add("HS10", -1.0, {anywhere(-10), anywhere(10)}, 1, 0, [](const D* x, D* r) {
    r[0] = x[0] - x[1];
    r[1] = -3.0 * sq(x[0]) + 2.0 * x[0] * x[1] - sq(x[1]) + 1.0;
  });
  b.add("HS11", -8.498464223, {anywhere(4.9), anywhere(0.1)}, 1, 0, [](const D* x, D* r) {
    r[0] = sq(x[0] - 5.0) + sq(x[1]) - 25.0;
    r[1] = x[1] - sq(x[0]);
  });
  b.add("HS12", -30.0, times(2, anywhere(0)), 1, 0, [](const D* x, D* r) {
    r[0] = 0.5 * sq(x[0]) + sq(x[1]) - x[0] * x[1] - 7.0 * x[0] - 7.0 * x[1];
    r[1] = 25.0 - 4.0 * sq(x[0]) - sq(x[1]);
  });
  b.add("HS13", 1.0, times(2, at_least(0, -2)), 1, 0, [](const D* x, D* r) {
    r[0] = sq(x[0] - 2.0) + sq(x[1]);
    r[1] = cube(1.0 - x[0]) - x[1];
  });
  b.add("HS14", 9.0 - 2.875 * std::sqrt(7.0), times(2, anywhere(2)), 1, 1, [](const D* x, D* r) {
    r[0] = sq(x[0] - 2.0) + sq(x[1] - 1.0);
    r[1] = 1.0 - 0.25 * sq(x[0]) - sq(x[1]);
    r[2] = x[0] - 2.0 * x[1] + 1.0;
  });
  b.add("HS15", 306.5, {{-kFree, 0.5, -2}, anywhere(1)}, 2, 0, [](const D* x, D* r) {
    r[0] = banana(x);
    r[1] = x[0] * x[1] - 1.0;
    r[2] = x[0] + sq(x[1]);
  });
  b.add("HS16", 0.25, {{-0.5, 0.5, -2}, {-kFree, 1, 1}}, 2, 0, [](const D* x, D* r) {
    r[0] = banana(x);
    r[1] = x[0] + sq(x[1]);
    r[2] = sq(x[0]) + x[1];
  });
  b.add("HS17", 1.0, {{-0.5, 0.5, -2}, {-kFree, 1, 1}}, 2, 0, [](const D* x, D* r) {
    r[0] = banana(x);
    r[1] = sq(x[1]) - x[0];
    r[2] = sq(x[0]) - x[1];
  });
  b.add("HS18", 5.0, {{2, 50, 2}, {0, 50, 2}}, 2, 0, [](const D* x, D* r) {
    r[0] = 0.01 * sq(x[0]) + sq(x[1]);
    r[1] = x[0] * x[1] - 25.0;
    r[2] = sq(x[0]) + sq(x[1]) - 25.0;
  });
  b.add("HS19", -6961.81381, {{13, 100, 20.1}, {0, 100, 5.84}}, 2, 0, [](const D* x, D* r) {
    r[0] = cube(x[0] - 10.0) + cube(x[1] - 20.0);
    r[1] = sq(x[0] - 5.0) + sq(x[1] - 5.0) - 100.0;
    r[2] = 82.81 - sq(x[1] - 5.0) - sq(x[0] - 6.0);
  });
  b.add("HS20", 81.5 - 25.0 * root3, {{-0.5, 0.5, -2}, anywhere(1)}, 3, 0, [](const D* x, D* r) {
    r[0] = banana(x);
    r[1] = x[0] + sq(x[1]);
    r[2] = sq(x[0]) + x[1];
    r[3] = sq(x[0]) + sq(x[1]) - 1.0;
  });
  b.add("HS21", -99.96, {{2, 50, -1}, {-50, 50, -1}}, 1, 0, [](const D* x, D* r) {
    r[0] = 0.01 * sq(x[0]) + sq(x[1]) - 100.0;
    r[1] = 10.0 * x[0] - x[1] - 10.0;
  });
  b.add("HS22", 1.0, times(2, anywhere(2)), 2, 0, [](const D* x, D* r) {
    r[0] = sq(x[0] - 2.0) + sq(x[1] - 1.0);
    r[1] = 2.0 - x[0] - x[1];
    r[2] = x[1] - sq(x[0]);
  });
  b.add("HS23", 2.0, {{-50, 50, 3}, {-50, 50, 1}}, 5, 0, [](const D* x, D* r) {
    r[0] = sq(x[0]) + sq(x[1]);
    r[1] = x[0] + x[1] - 1.0;
    r[2] = sq(x[0]) + sq(x[1]) - 1.0;
    r[3] = 9.0 * sq(x[0]) + sq(x[1]) - 9.0;
    r[4] = sq(x[0]) - x[1];
    r[5] = sq(x[1]) - x[0];
  });
  b.add("HS24", -1.0, {at_least(0, 1), at_least(0, 0.5)}, 3, 0, [root3](const D* x, D* r) {
    r[0] = (sq(x[0] - 3.0) - 9.0) * cube(x[1]) / (27.0 * root3);
    r[1] = x[0] / root3 - x[1];
    r[2] = x[0] + root3 * x[1];
    r[3] = 6.0 - x[0] - root3 * x[1];
  });
}

}  // namespace twum::test
