// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/textbook_parts.hpp"

#include <tuple>

namespace twum::test {
namespace {

using D = T20;

void add_hs60_to_66(TextbookBuilder& b) {
  const double root2 = std::sqrt(2.0);
  b.add("HS60", 0.03256820025, times(3, {-10, 10, 2}), 0, 1, [root2](const D* x, D* r) {
    r[0] = sq(x[0] - 1.0) + sq(x[0] - x[1]) + fourth(x[1] - x[2]);
    r[1] = x[0] * (1.0 + sq(x[1])) + fourth(x[2]) - 4.0 - 3.0 * root2;
  });
  b.add("HS61", -143.6461422, times(3, anywhere(0)), 0, 2, [](const D* x, D* r) {
    r[0] =
        4.0 * sq(x[0]) + 2.0 * sq(x[1]) + 2.0 * sq(x[2]) - 33.0 * x[0] + 16.0 * x[1] - 24.0 * x[2];
    r[1] = 3.0 * x[0] - 2.0 * sq(x[1]) - 7.0;
    r[2] = 4.0 * x[0] - sq(x[2]) - 11.0;
  });
  b.add("HS62", -26272.51448, {{0, 1, 0.7}, {0, 1, 0.2}, {0, 1, 0.1}}, 0, 1, [](const D* x, D* r) {
    const D one = x[0] + x[1] + x[2] + 0.03, two = x[1] + x[2] + 0.03, three = x[2] + 0.03;
    r[0] =
        -32.174 * (255.0 * ln(one / (0.09 * x[0] + two)) + 280.0 * ln(two / (0.07 * x[1] + three)) +
                   290.0 * ln(three / (0.13 * x[2] + 0.03)));
    r[1] = x[0] + x[1] + x[2] - 1.0;
  });
  b.add("HS63", 961.7151721, times(3, at_least(0, 2)), 0, 2, [](const D* x, D* r) {
    r[0] = 1000.0 - sq(x[0]) - 2.0 * sq(x[1]) - sq(x[2]) - x[0] * x[1] - x[0] * x[2];
    r[1] = 8.0 * x[0] + 14.0 * x[1] + 7.0 * x[2] - 56.0;
    r[2] = sq(x[0]) + sq(x[1]) + sq(x[2]) - 25.0;
  });
  b.add("HS64", 6299.842428, times(3, at_least(1e-5, 1)), 1, 0, [](const D* x, D* r) {
    r[0] =
        5.0 * x[0] + 50000.0 / x[0] + 20.0 * x[1] + 72000.0 / x[1] + 10.0 * x[2] + 144000.0 / x[2];
    r[1] = 1.0 - 4.0 / x[0] - 32.0 / x[1] - 120.0 / x[2];
  });
  b.add("HS65", 0.9535288567, {{-4.5, 4.5, -5}, {-4.5, 4.5, 5}, {-5, 5, 0}}, 1, 0,
        [](const D* x, D* r) {
          r[0] = sq(x[0] - x[1]) + sq(x[0] + x[1] - 10.0) / 9.0 + sq(x[2] - 5.0);
          r[1] = 48.0 - sq(x[0]) - sq(x[1]) - sq(x[2]);
        });
  b.add("HS66", 0.5181632741, {{0, 100, 0}, {0, 100, 1.05}, {0, 10, 2.9}}, 2, 0,
        [](const D* x, D* r) {
          r[0] = 0.2 * x[2] - 0.8 * x[0];
          r[1] = x[1] - expo(x[0]);
          r[2] = x[2] - expo(x[1]);
        });
}

void add_hs71_to_76(TextbookBuilder& b) {
  b.add("HS71", 17.0140173, {{1, 5, 1}, {1, 5, 5}, {1, 5, 5}, {1, 5, 1}}, 1, 1,
        [](const D* x, D* r) {
          r[0] = x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2];
          r[1] = x[0] * x[1] * x[2] * x[3] - 25.0;
          r[2] = sq(x[0]) + sq(x[1]) + sq(x[2]) + sq(x[3]) - 40.0;
        });
  b.add("HS72", 727.67937, {{1e-3, 4e5, 1}, {1e-3, 3e5, 1}, {1e-3, 2e5, 1}, {1e-3, 1e5, 1}}, 2, 0,
        [](const D* x, D* r) {
          r[0] = 1.0 + x[0] + x[1] + x[2] + x[3];
          r[1] = 0.0401 - 4.0 / x[0] - 2.25 / x[1] - 1.0 / x[2] - 0.25 / x[3];
          r[2] = 0.010085 - 0.16 / x[0] - 0.36 / x[1] - 0.64 / x[2] - 0.64 / x[3];
        });
  b.add("HS73", 29.894378, times(4, at_least(0, 1)), 2, 1, [](const D* x, D* r) {
    r[0] = 24.55 * x[0] + 26.75 * x[1] + 39.0 * x[2] + 40.5 * x[3];
    r[1] = 2.3 * x[0] + 5.6 * x[1] + 11.1 * x[2] + 1.3 * x[3] - 5.0;
    r[2] = 12.0 * x[0] + 11.9 * x[1] + 41.8 * x[2] + 52.1 * x[3] - 21.0 -
           1.645 * root(0.28 * sq(x[0]) + 0.19 * sq(x[1]) + 20.5 * sq(x[2]) + 0.62 * sq(x[3]));
    r[3] = x[0] + x[1] + x[2] + x[3] - 1.0;
  });
  for (const auto& [name, a, best] :
       {std::tuple{"HS74", 0.55, 5126.4981}, std::tuple{"HS75", 0.48, 5174.4127}})
    b.add(name, best, {{0, 1200, 0}, {0, 1200, 0}, {-a, a, 0}, {-a, a, 0}}, 2, 3,
          [a = a](const D* x, D* r) {
            r[0] = 3.0 * x[0] + 1e-6 * cube(x[0]) + 2.0 * x[1] + 2e-6 / 3.0 * cube(x[1]);
            r[1] = x[3] - x[2] + a;
            r[2] = x[2] - x[3] + a;
            r[3] = 1000.0 * (sine(-x[2] - 0.25) + sine(-x[3] - 0.25)) + 894.8 - x[0];
            r[4] = 1000.0 * (sine(x[2] - 0.25) + sine(x[2] - x[3] - 0.25)) + 894.8 - x[1];
            r[5] = 1000.0 * (sine(x[3] - 0.25) + sine(x[3] - x[2] - 0.25)) + 1294.8;
          });
  b.add("HS76", -103.0 / 22.0, times(4, at_least(0, 0.5)), 3, 0, [](const D* x, D* r) {
    r[0] = sq(x[0]) + 0.5 * sq(x[1]) + sq(x[2]) + 0.5 * sq(x[3]) - x[0] * x[2] + x[2] * x[3] -
           x[0] - 3.0 * x[1] + x[2] - x[3];
    r[1] = 5.0 - x[0] - 2.0 * x[1] - x[2] - x[3];
    r[2] = 4.0 - 3.0 * x[0] - x[1] - 2.0 * x[2] + x[3];
    r[3] = x[1] + 4.0 * x[2] - 1.5;
  });
}

// Constraints of HS78, HS80 and HS81.
void product_limits(const D* x, D* r) {
  r[1] = sq(x[0]) + sq(x[1]) + sq(x[2]) + sq(x[3]) + sq(x[4]) - 10.0;
  r[2] = x[1] * x[2] - 5.0 * x[3] * x[4];
  r[3] = cube(x[0]) + cube(x[1]) + 1.0;
}

void add_hs77_to_83(TextbookBuilder& b) {
  const double root2 = std::sqrt(2.0);
  b.add("HS77", 0.24150513, times(5, anywhere(2)), 0, 2, [root2](const D* x, D* r) {
    r[0] = sq(x[0] - 1.0) + sq(x[0] - x[1]) + sq(x[2] - 1.0) + fourth(x[3] - 1.0) +
           sq(cube(x[4] - 1.0));
    r[1] = sq(x[0]) * x[3] + sine(x[3] - x[4]) - 2.0 * root2;
    r[2] = x[1] + fourth(x[2]) * sq(x[3]) - 8.0 - root2;
  });
  b.add("HS78", -2.91970041, {anywhere(-2), anywhere(1.5), anywhere(2), anywhere(-1), anywhere(-1)},
        0, 3, [](const D* x, D* r) {
          r[0] = x[0] * x[1] * x[2] * x[3] * x[4];
          product_limits(x, r);
        });
  b.add("HS79", 0.0787768209, times(5, anywhere(2)), 0, 3, [root2](const D* x, D* r) {
    r[0] = sq(x[0] - 1.0) + sq(x[0] - x[1]) + sq(x[1] - x[2]) + fourth(x[2] - x[3]) +
           fourth(x[3] - x[4]);
    r[1] = x[0] + sq(x[1]) + cube(x[2]) - 2.0 - 3.0 * root2;
    r[2] = x[1] - sq(x[2]) + x[3] + 2.0 - 2.0 * root2;
    r[3] = x[0] * x[4] - 2.0;
  });
  const std::vector<Range> ranges{
      {-2.3, 2.3, -2}, {-2.3, 2.3, 2}, {-3.2, 3.2, 2}, {-3.2, 3.2, -1}, {-3.2, 3.2, -1}};
  b.add("HS80", 0.0539498478, ranges, 0, 3, [](const D* x, D* r) {
    r[0] = expo(x[0] * x[1] * x[2] * x[3] * x[4]);
    product_limits(x, r);
  });
  b.add("HS81", 0.0539498478, ranges, 0, 3, [](const D* x, D* r) {
    r[0] = expo(x[0] * x[1] * x[2] * x[3] * x[4]) - 0.5 * sq(cube(x[0]) + cube(x[1]) + 1.0);
    product_limits(x, r);
  });
  b.add("HS83", -30665.53867,
        {{78, 102, 78}, {33, 45, 33}, {27, 45, 27}, {27, 45, 27}, {27, 45, 27}}, 6, 0,
        [](const D* x, D* r) {
          r[0] = 5.3578547 * sq(x[2]) + 0.8356891 * x[0] * x[4] + 37.293239 * x[0] - 40792.141;
          r[1] = 85.334407 + 0.0056858 * x[1] * x[4] + 0.0006262 * x[0] * x[3] -
                 0.0022053 * x[2] * x[4];
          r[3] = 80.51249 + 0.0071317 * x[1] * x[4] + 0.0029955 * x[0] * x[1] +
                 0.0021813 * sq(x[2]) - 90.0;
          r[5] = 9.300961 + 0.0047026 * x[2] * x[4] + 0.0012547 * x[0] * x[2] +
                 0.0019085 * x[2] * x[3] - 20.0;
          r[2] = 92.0 - r[1];
          r[4] = 20.0 - r[3];
          r[6] = 5.0 - r[5];
        });
}

}  // namespace

void add_hs_60_to_83(TextbookBuilder& b) {
  add_hs60_to_66(b);
  add_hs71_to_76(b);
  add_hs77_to_83(b);
}

}  // namespace twum::test
