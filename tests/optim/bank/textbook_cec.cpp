// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/textbook_parts.hpp"

namespace twum::test {
namespace {

using D = T20;

Range middle(double lower, double upper) { return {lower, upper, 0.5 * (lower + upper)}; }

void add_g01_to_g08(TextbookBuilder& b) {
  std::vector<Range> g01 = times(13, middle(0, 1));
  for (int j = 9; j < 12; ++j) g01[static_cast<std::size_t>(j)] = middle(0, 100);
  b.add("G01", -15.0, g01, 9, 0, [](const D* x, D* r) {
    r[0] = 5.0 * (x[0] + x[1] + x[2] + x[3] - sq(x[0]) - sq(x[1]) - sq(x[2]) - sq(x[3]));
    for (int i = 4; i < 13; ++i) r[0] = r[0] - x[i];
    r[1] = 10.0 - 2.0 * x[0] - 2.0 * x[1] - x[9] - x[10];
    r[2] = 10.0 - 2.0 * x[0] - 2.0 * x[2] - x[9] - x[11];
    r[3] = 10.0 - 2.0 * x[1] - 2.0 * x[2] - x[10] - x[11];
    for (int i = 0; i < 3; ++i) {
      r[4 + i] = 8.0 * x[i] - x[9 + i];
      r[7 + i] = 2.0 * x[3 + 2 * i] + x[4 + 2 * i] - x[9 + i];
    }
  });
  b.add("G02", -0.80361910412559, times(20, middle(1e-8, 10)), 2, 0, [](const D* x, D* r) {
    D fourths(0.0), squares(1.0), product(1.0), sum(0.0), weighted(0.0);
    for (int i = 0; i < 20; ++i) {
      const D c = cosine(x[i]);
      fourths = fourths + fourth(c);
      squares = squares * sq(c);
      product = product * x[i];
      sum = sum + x[i];
      weighted = weighted + (i + 1.0) * sq(x[i]);
    }
    const D top = fourths - 2.0 * squares;
    r[0] = -(top.v < 0.0 ? -top : top) / root(weighted);
    r[1] = product - 0.75;
    r[2] = 150.0 - sum;
  });
  b.add("G03", -1.0, times(10, middle(0, 1)), 0, 1, [](const D* x, D* r) {
    D product(-std::pow(10.0, 5.0)), sum(-1.0);
    for (int i = 0; i < 10; ++i) {
      product = product * x[i];
      sum = sum + sq(x[i]);
    }
    r[0] = product;
    r[1] = sum;
  });
  b.add("G08", -0.0958250414, times(2, middle(1e-3, 10)), 2, 0, [](const D* x, D* r) {
    const double turn = 2.0 * std::acos(-1.0);
    r[0] = -cube(sine(turn * x[0])) * sine(turn * x[1]) / (cube(x[0]) * (x[0] + x[1]));
    r[1] = x[1] - sq(x[0]) - 1.0;
    r[2] = x[0] - 1.0 - sq(x[1] - 4.0);
  });
}

void add_g11_to_g24(TextbookBuilder& b) {
  b.add("G11", 0.75, times(2, {-1, 1, 0.5}), 0, 1, [](const D* x, D* r) {
    r[0] = sq(x[0]) + sq(x[1] - 1.0);
    r[1] = x[1] - sq(x[0]);
  });
  b.add("G21", 193.7869253,
        {middle(0, 1000), middle(0, 40), middle(0, 40), middle(100, 300), middle(6.3, 6.7),
         middle(5.9, 6.4), middle(4.5, 6.25)},
        1, 5, [](const D* x, D* r) {
          r[0] = x[0];
          r[1] = x[0] - 35.0 * power(x[1], 0.6) - 35.0 * power(x[2], 0.6);
          r[2] = -300.0 * x[2] + 7500.0 * x[4] - 7500.0 * x[5] - 25.0 * x[3] * x[4] +
                 25.0 * x[3] * x[5] + x[2] * x[3];
          r[3] = 100.0 * x[1] + 155.365 * x[3] + 2500.0 * x[6] - x[1] * x[3] - 25.0 * x[3] * x[6] -
                 15536.5;
          r[4] = -x[4] + ln(900.0 - x[3]);
          r[5] = -x[5] + ln(x[3] + 300.0);
          r[6] = -x[6] + ln(700.0 - 2.0 * x[3]);
        });
  b.add("G23", -400.0,
        {middle(0, 300), middle(0, 300), middle(0, 100), middle(0, 200), middle(0, 100),
         middle(0, 300), middle(0, 100), middle(0, 200), middle(0.01, 0.03)},
        2, 4, [](const D* x, D* r) {
          r[0] = -9.0 * x[4] - 15.0 * x[7] + 6.0 * x[0] + 16.0 * x[1] + 10.0 * (x[5] + x[6]);
          r[1] = -(x[8] * x[2]) - 0.02 * x[5] + 0.025 * x[4];
          r[2] = -(x[8] * x[3]) - 0.02 * x[6] + 0.015 * x[7];
          r[3] = x[0] + x[1] - x[2] - x[3];
          r[4] = 0.03 * x[0] + 0.01 * x[1] - x[8] * (x[2] + x[3]);
          r[5] = x[2] + x[5] - x[4];
          r[6] = x[3] + x[6] - x[7];
        });
  b.add("G24", -5.50801327, {middle(0, 3), middle(0, 4)}, 2, 0, [](const D* x, D* r) {
    r[0] = -x[0] - x[1];
    r[1] = 2.0 * fourth(x[0]) - 8.0 * cube(x[0]) + 8.0 * sq(x[0]) - x[1] + 2.0;
    r[2] = 4.0 * fourth(x[0]) - 32.0 * cube(x[0]) + 88.0 * sq(x[0]) - 96.0 * x[0] - x[1] + 36.0;
  });
}

}  // namespace

// The published values of G03, G11, G21 and G23 use up a tolerance of 1e-4 in each equality; these are without it.
// G04 to G07, G09, G10, G13, G15 and G18 are HS83, HS74, HS19, HS113, HS100, HS106, HS80, HS63 and HS108.
void add_cec_2006(TextbookBuilder& b) {
  add_g01_to_g08(b);
  add_g11_to_g24(b);
}

}  // namespace twum::test
