// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/hock_schittkowski.hpp"

#include "optim/bank/dual_problem.hpp"

#include <cmath>
#include <stdexcept>

namespace twum::test {
namespace {

using D = Dual<double, 10>;

D sq(const D& x) { return x * x; }

D natural_log(const D& x) {
  D r(std::log(x.v));
  for (int i = 0; i < 10; ++i) r.d[i] = x.d[i] / x.v;
  return r;
}

// Constraints are written as in the book: `inequalities` of the form c >= 0, then equalities.
struct Builder {
  std::vector<KnownProblem> all;

  template <typename F>
  void add(const std::string& name, double best, std::vector<optim::Variable> variables,
           std::size_t inequalities, std::size_t equalities, F f) {
    optim::Problem p;
    p.variables = std::move(variables);
    p.objectives = {{"f", optim::Sense::minimize}};
    for (std::size_t i = 0; i < inequalities + equalities; ++i)
      p.constraints.push_back({numbered('c', i), 0.0, i < inequalities ? optim::kInfinity : 0.0});
    p.evaluate = dual_evaluator<10>(1 + inequalities + equalities, f);
    all.push_back({name, std::move(p), best, equalities > 0});
  }
};

std::vector<optim::Variable> bounds(std::vector<optim::Variable> v, std::size_t j, double lower,
                                    double upper) {
  v[j].lower = lower;
  v[j].upper = upper;
  return v;
}

void add_two_variables(Builder& b) {
  b.add("HS1", 0.0, bounds(box(2, -10, 10, {-2, 1}), 1, -1.5, 10), 0, 0,
        [](const D* x, D* r) { r[0] = 100.0 * sq(x[1] - sq(x[0])) + sq(1.0 - x[0]); });
  b.add("HS6", 0.0, box(2, -10, 10, {-1.2, 1}), 0, 1, [](const D* x, D* r) {
    r[0] = sq(1.0 - x[0]);
    r[1] = 10.0 * (x[1] - sq(x[0]));
  });
  b.add("HS7", -std::sqrt(3.0), box(2, -10, 10, {2, 2}), 0, 1, [](const D* x, D* r) {
    r[0] = natural_log(1.0 + sq(x[0])) - x[1];
    r[1] = sq(1.0 + sq(x[0])) + sq(x[1]) - 4.0;
  });
  b.add("HS10", -1.0, box(2, -20, 20, {-10, 10}), 1, 0, [](const D* x, D* r) {
    r[0] = x[0] - x[1];
    r[1] = -3.0 * sq(x[0]) + 2.0 * x[0] * x[1] - sq(x[1]) + 1.0;
  });
  b.add("HS11", -8.498464223, box(2, -10, 10, {4.9, 0.1}), 1, 0, [](const D* x, D* r) {
    r[0] = sq(x[0] - 5.0) + sq(x[1]) - 25.0;
    r[1] = x[1] - sq(x[0]);
  });
  b.add("HS12", -30.0, box(2, -20, 20, {0, 0}), 1, 0, [](const D* x, D* r) {
    r[0] = 0.5 * sq(x[0]) + sq(x[1]) - x[0] * x[1] - 7.0 * x[0] - 7.0 * x[1];
    r[1] = 25.0 - 4.0 * sq(x[0]) - sq(x[1]);
  });
  b.add("HS14", 1.3934649807, box(2, -10, 10, {2, 2}), 1, 1, [](const D* x, D* r) {
    r[0] = sq(x[0] - 2.0) + sq(x[1] - 1.0);
    r[1] = 1.0 - 0.25 * sq(x[0]) - sq(x[1]);
    r[2] = x[0] - 2.0 * x[1] + 1.0;
  });
  b.add("HS24", -1.0, box(2, 0, 10, {1, 0.5}), 3, 0, [](const D* x, D* r) {
    const double root = std::sqrt(3.0);
    r[0] = (sq(x[0] - 3.0) - 9.0) * x[1] * sq(x[1]) / (27.0 * root);
    r[1] = x[0] / root - x[1];
    r[2] = x[0] + root * x[1];
    r[3] = 6.0 - x[0] - root * x[1];
  });
}

void add_three_variables(Builder& b) {
  b.add("HS26", 0.0, box(3, -10, 10, {-2.6, 2, 2}), 0, 1, [](const D* x, D* r) {
    r[0] = sq(x[0] - x[1]) + sq(sq(x[1] - x[2]));
    r[1] = (1.0 + sq(x[1])) * x[0] + sq(sq(x[2])) - 3.0;
  });
  b.add("HS29", -16.0 * std::sqrt(2.0), box(3, -10, 10, {1, 1, 1}), 1, 0, [](const D* x, D* r) {
    r[0] = -(x[0] * x[1] * x[2]);
    r[1] = 48.0 - sq(x[0]) - 2.0 * sq(x[1]) - 4.0 * sq(x[2]);
  });
  b.add("HS35", 1.0 / 9.0, box(3, 0, 10, {0.5, 0.5, 0.5}), 1, 0, [](const D* x, D* r) {
    r[0] = 9.0 - 8.0 * x[0] - 6.0 * x[1] - 4.0 * x[2] + 2.0 * sq(x[0]) + 2.0 * sq(x[1]) + sq(x[2]) +
           2.0 * x[0] * x[1] + 2.0 * x[0] * x[2];
    r[1] = 3.0 - x[0] - x[1] - 2.0 * x[2];
  });
  b.add("HS36", -3300.0, bounds(bounds(box(3, 0, 20, {10, 10, 10}), 1, 0, 11), 2, 0, 42), 1, 0,
        [](const D* x, D* r) {
          r[0] = -(x[0] * x[1] * x[2]);
          r[1] = 72.0 - x[0] - 2.0 * x[1] - 2.0 * x[2];
        });
  b.add("HS65", 0.9535288567, bounds(box(3, -4.5, 4.5, {-5, 5, 0}), 2, -5, 5), 1, 0,
        [](const D* x, D* r) {
          r[0] = sq(x[0] - x[1]) + sq(x[0] + x[1] - 10.0) / 9.0 + sq(x[2] - 5.0);
          r[1] = 48.0 - sq(x[0]) - sq(x[1]) - sq(x[2]);
        });
}

void add_four_variables(Builder& b) {
  b.add("HS39", -1.0, box(4, -10, 10, {2, 2, 2, 2}), 0, 2, [](const D* x, D* r) {
    r[0] = -x[0];
    r[1] = x[1] - x[0] * sq(x[0]) - sq(x[2]);
    r[2] = sq(x[0]) - x[1] - sq(x[3]);
  });
  b.add("HS40", -0.25, box(4, -10, 10, {0.8, 0.8, 0.8, 0.8}), 0, 3, [](const D* x, D* r) {
    r[0] = -(x[0] * x[1] * x[2] * x[3]);
    r[1] = x[0] * sq(x[0]) + sq(x[1]) - 1.0;
    r[2] = sq(x[0]) * x[3] - x[2];
    r[3] = sq(x[3]) - x[1];
  });
  b.add("HS43", -44.0, box(4, -10, 10, {0, 0, 0, 0}), 3, 0, [](const D* x, D* r) {
    r[0] = sq(x[0]) + sq(x[1]) + 2.0 * sq(x[2]) + sq(x[3]) - 5.0 * x[0] - 5.0 * x[1] - 21.0 * x[2] +
           7.0 * x[3];
    r[1] = 8.0 - sq(x[0]) - sq(x[1]) - sq(x[2]) - sq(x[3]) - x[0] + x[1] - x[2] + x[3];
    r[2] = 10.0 - sq(x[0]) - 2.0 * sq(x[1]) - sq(x[2]) - 2.0 * sq(x[3]) + x[0] + x[3];
    r[3] = 5.0 - 2.0 * sq(x[0]) - sq(x[1]) - sq(x[2]) - 2.0 * x[0] + x[1] + x[3];
  });
  b.add("HS71", 17.0140173, box(4, 1, 5, {1, 5, 5, 1}), 1, 1, [](const D* x, D* r) {
    r[0] = x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2];
    r[1] = x[0] * x[1] * x[2] * x[3] - 25.0;
    r[2] = sq(x[0]) + sq(x[1]) + sq(x[2]) + sq(x[3]) - 40.0;
  });
  b.add("HS76", -4.681818181, box(4, 0, 10, {0.5, 0.5, 0.5, 0.5}), 3, 0, [](const D* x, D* r) {
    r[0] = sq(x[0]) + 0.5 * sq(x[1]) + sq(x[2]) + 0.5 * sq(x[3]) - x[0] * x[2] + x[2] * x[3] -
           x[0] - 3.0 * x[1] + x[2] - x[3];
    r[1] = 5.0 - x[0] - 2.0 * x[1] - x[2] - x[3];
    r[2] = 4.0 - 3.0 * x[0] - x[1] - 2.0 * x[2] + x[3];
    r[3] = x[1] + 4.0 * x[2] - 1.5;
  });
}

void add_more_variables(Builder& b) {
  b.add("HS93", 135.075961, box(6, 0, 20, {5.54, 4.4, 12.02, 11.82, 0.702, 0.852}), 2, 0,
        [](const D* x, D* r) {
          const D left = x[0] * x[3] * (x[0] + x[1] + x[2]);
          const D right = x[1] * x[2] * (x[0] + 1.57 * x[1] + x[3]);
          r[0] =
              0.0204 * left + 0.0187 * right + 0.0607 * left * sq(x[4]) + 0.0437 * right * sq(x[5]);
          r[1] = 0.001 * x[0] * x[1] * x[2] * x[3] * x[4] * x[5] - 2.07;
          r[2] = 1.0 - 0.00062 * left * sq(x[4]) - 0.00058 * right * sq(x[5]);
        });
  b.add("HS100", 680.6300573, box(7, -10, 20, {1, 2, 0, 4, 0, 1, 1}), 4, 0, [](const D* x, D* r) {
    r[0] = sq(x[0] - 10.0) + 5.0 * sq(x[1] - 12.0) + sq(sq(x[2])) + 3.0 * sq(x[3] - 11.0) +
           10.0 * sq(x[4]) * sq(sq(x[4])) + 7.0 * sq(x[5]) + sq(sq(x[6])) - 4.0 * x[5] * x[6] -
           10.0 * x[5] - 8.0 * x[6];
    r[1] = 127.0 - 2.0 * sq(x[0]) - 3.0 * sq(sq(x[1])) - x[2] - 4.0 * sq(x[3]) - 5.0 * x[4];
    r[2] = 282.0 - 7.0 * x[0] - 3.0 * x[1] - 10.0 * sq(x[2]) - x[3] + x[4];
    r[3] = 196.0 - 23.0 * x[0] - sq(x[1]) - 6.0 * sq(x[5]) + 8.0 * x[6];
    r[4] =
        -4.0 * sq(x[0]) - sq(x[1]) + 3.0 * x[0] * x[1] - 2.0 * sq(x[2]) - 5.0 * x[5] + 11.0 * x[6];
  });
  b.add("HS113", 24.3062091, box(10, -20, 20, {2, 3, 5, 5, 1, 2, 7, 3, 6, 10}), 8, 0,
        [](const D* x, D* r) {
          r[0] = sq(x[0]) + sq(x[1]) + x[0] * x[1] - 14.0 * x[0] - 16.0 * x[1] + sq(x[2] - 10.0) +
                 4.0 * sq(x[3] - 5.0) + sq(x[4] - 3.0) + 2.0 * sq(x[5] - 1.0) + 5.0 * sq(x[6]) +
                 7.0 * sq(x[7] - 11.0) + 2.0 * sq(x[8] - 10.0) + sq(x[9] - 7.0) + 45.0;
          r[1] = 105.0 - 4.0 * x[0] - 5.0 * x[1] + 3.0 * x[6] - 9.0 * x[7];
          r[2] = -10.0 * x[0] + 8.0 * x[1] + 17.0 * x[6] - 2.0 * x[7];
          r[3] = 8.0 * x[0] - 2.0 * x[1] - 5.0 * x[8] + 2.0 * x[9] + 12.0;
          r[4] = -3.0 * sq(x[0] - 2.0) - 4.0 * sq(x[1] - 3.0) - 2.0 * sq(x[2]) + 7.0 * x[3] + 120.0;
          r[5] = -5.0 * sq(x[0]) - 8.0 * x[1] - sq(x[2] - 6.0) + 2.0 * x[3] + 40.0;
          r[6] = -0.5 * sq(x[0] - 8.0) - 2.0 * sq(x[1] - 4.0) - 3.0 * sq(x[4]) + x[5] + 30.0;
          r[7] = -sq(x[0]) - 2.0 * sq(x[1] - 2.0) + 2.0 * x[0] * x[1] - 14.0 * x[4] + 6.0 * x[5];
          r[8] = 3.0 * x[0] - 6.0 * x[1] - 12.0 * sq(x[8] - 8.0) + 7.0 * x[9];
        });
}

}  // namespace

const std::vector<KnownProblem>& hock_schittkowski() {
  static const std::vector<KnownProblem> all = [] {
    Builder b;
    add_two_variables(b);
    add_three_variables(b);
    add_four_variables(b);
    add_more_variables(b);
    return b.all;
  }();
  return all;
}

const KnownProblem& hock_schittkowski(const std::string& name) {
  for (const auto& p : hock_schittkowski())
    if (p.name == name) return p;
  throw std::out_of_range(name);
}

}  // namespace twum::test
