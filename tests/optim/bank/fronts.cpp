// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/fronts.hpp"

#include "optim/bank/dual_problem.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace twum::test {
namespace {

constexpr double kPi = std::numbers::pi;
using D30 = Dual<double, 30>;
using D6 = Dual<double, 6>;
using D12 = Dual<double, 12>;
using Points = std::vector<std::vector<double>>;

template <int N>
Dual<double, N> mapped(const Dual<double, N>& x, double value, double slope) {
  Dual<double, N> r(value);
  for (int i = 0; i < N; ++i) r.d[i] = slope * x.d[i];
  return r;
}

// Powers below one have no derivative at zero, where these fronts have an end: a finite slope is
// used in its place.
template <int N>
Dual<double, N> power(const Dual<double, N>& x, double p) {
  const double base = std::max(x.v, 1e-6);
  return mapped(x, std::pow(std::max(x.v, 0.0), p), p * std::pow(base, p - 1.0));
}

template <typename T>
T sq(const T& x) {
  return x * x;
}

optim::Problem two_objectives(std::vector<optim::Variable> variables) {
  optim::Problem p;
  p.variables = std::move(variables);
  p.objectives = {{"f1", optim::Sense::minimize}, {"f2", optim::Sense::minimize}};
  return p;
}

template <typename G, typename H>
optim::Problem zdt(std::size_t n, G g, H second) {
  optim::Problem p = two_objectives(box(n, 0.0, 1.0));
  p.evaluate = dual_evaluator<30>(2, [n, g, second](const D30* x, D30* r) {
    r[0] = x[0];
    r[1] = second(x[0], g(x, n));
  });
  return p;
}

D30 mean_of_rest(const D30* x, std::size_t n) {
  D30 sum(0.0);
  for (std::size_t j = 1; j < n; ++j) sum = sum + x[j];
  return 1.0 + 9.0 * sum * (1.0 / static_cast<double>(n - 1));
}

Points curve(std::size_t density, double from, double to, double (*f2)(double)) {
  Points points;
  for (std::size_t i = 0; i <= density; ++i) {
    const double f1 = from + (to - from) * static_cast<double>(i) / static_cast<double>(density);
    points.push_back({f1, f2(f1)});
  }
  return points;
}

// Drops the dominated points of a curve.
Points pieces(Points points) {
  std::sort(points.begin(), points.end());
  Points kept;
  for (auto& p : points)
    if (kept.empty() || p[1] < kept.back()[1]) kept.push_back(std::move(p));
  return kept;
}

// As many as asked for, evenly by position.
Points thinned(const Points& points, std::size_t density) {
  Points kept;
  const double step =
      std::max(1.0, static_cast<double>(points.size() - 1) / static_cast<double>(density));
  for (double at = 0.0; at < static_cast<double>(points.size()) - 0.5; at += step)
    kept.push_back(points[static_cast<std::size_t>(at)]);
  kept.push_back(points.back());
  return kept;
}

double one_minus_root(double f) { return 1.0 - std::sqrt(f); }
double one_minus_square(double f) { return 1.0 - f * f; }
double zdt3_front(double f) { return 1.0 - std::sqrt(f) - f * std::sin(10.0 * kPi * f); }

D30 convex(const D30& f1, const D30& g) { return g * (1.0 - power(f1 / g, 0.5)); }

optim::Problem zdt4() {
  optim::Problem p = two_objectives(box(10, -5.0, 5.0));
  p.variables[0].lower = 0.0;
  p.variables[0].upper = 1.0;
  // The middle of the box would be the global front by luck: start elsewhere.
  for (std::size_t j = 1; j < 10; ++j) p.variables[j].start = 3.3 - 0.5 * static_cast<double>(j);
  p.evaluate = dual_evaluator<30>(2, [](const D30* x, D30* r) {
    D30 g(91.0);
    for (int j = 1; j < 10; ++j) g = g + sq(x[j]) - 10.0 * cos(4.0 * kPi * x[j]);
    r[0] = x[0];
    r[1] = convex(x[0], g);
  });
  return p;
}

// The fourth root is infinitely steep where its argument is zero, which is the whole front.
optim::Problem zdt6() {
  optim::Problem p = two_objectives(box(10, 0.0, 1.0));
  p.evaluate = [](std::span<const double> x, bool) {
    const double mean = std::accumulate(x.begin() + 1, x.end(), 0.0) / 9.0;
    const double s = std::sin(6.0 * kPi * x[0]), decay = std::exp(-4.0 * x[0]);
    const double f = 1.0 - decay * std::pow(s, 6.0), g = 1.0 + 9.0 * std::pow(mean, 0.25);
    const double df =
        decay * std::pow(s, 5.0) * (4.0 * s - 36.0 * kPi * std::cos(6.0 * kPi * x[0]));
    const double dg = 0.25 * std::pow(mean, -0.75);  // by each of the nine
    optim::Evaluation e;
    e.values = {f, g * (1.0 - sq(f / g))};
    e.jacobian.assign(20, 0.0);
    e.jacobian[0] = df;
    e.jacobian[10] = -2.0 * f / g * df;
    std::fill_n(e.jacobian.begin() + 11, 9, dg * (1.0 + sq(f / g)));
    return e;
  };
  return p;
}

void add_zdt(std::vector<KnownFront>& all, std::size_t density) {
  const std::vector<double> reference{1.1, 1.1};
  const auto zdt1 = zdt(30, mean_of_rest, convex);
  const auto zdt2 =
      zdt(30, mean_of_rest, [](const D30& f, const D30& g) { return g * (1.0 - sq(f / g)); });
  const auto zdt3 = zdt(30, mean_of_rest, [](const D30& f, const D30& g) {
    return g * (1.0 - power(f / g, 0.5) - f / g * sin(10.0 * kPi * f));
  });
  const double zdt6_end = 0.2807753191;  // smallest 1 - exp(-4x) sin(6 pi x)^6
  all.push_back({"ZDT1", zdt1, reference, 0.8766667, curve(density, 0, 1, one_minus_root), false});
  all.push_back(
      {"ZDT2", zdt2, reference, 0.5433333, curve(density, 0, 1, one_minus_square), false});
  all.push_back({"ZDT3", zdt3, reference, 1.33176,
                 thinned(pieces(curve(20 * density, 0, 1, zdt3_front)), density), false});
  all.push_back({"ZDT4", zdt4(), reference, 0.8766667, curve(density, 0, 1, one_minus_root), true});
  all.push_back(
      {"ZDT6", zdt6(), reference, 0.507877, curve(density, zdt6_end, 1, one_minus_square), false});
}

optim::Problem bnh() {
  optim::Problem p = two_objectives(box(2, 0.0, 5.0));
  p.variables[1].upper = 3.0;
  p.constraints = {{"c1", -optim::kInfinity, 25.0}, {"c2", 7.7, optim::kInfinity}};
  p.evaluate = dual_evaluator<6>(4, [](const D6* x, D6* r) {
    r[0] = 4.0 * sq(x[0]) + 4.0 * sq(x[1]);
    r[1] = sq(x[0] - 5.0) + sq(x[1] - 5.0);
    r[2] = sq(x[0] - 5.0) + sq(x[1]);
    r[3] = sq(x[0] - 8.0) + sq(x[1] + 3.0);
  });
  return p;
}

Points bnh_front(std::size_t density) {
  Points points;
  for (std::size_t i = 0; i <= density; ++i) {
    const double x = 5.0 * static_cast<double>(i) / static_cast<double>(density);
    if (x <= 3.0)
      points.push_back({8 * x * x, 2 * (x - 5) * (x - 5)});
    else
      points.push_back({4 * x * x + 36, (x - 5) * (x - 5) + 4});
  }
  return points;
}

optim::Problem srn() {
  optim::Problem p = two_objectives(box(2, -20.0, 20.0));
  p.constraints = {{"c1", -optim::kInfinity, 225.0}, {"c2", -optim::kInfinity, -10.0}};
  p.evaluate = dual_evaluator<6>(4, [](const D6* x, D6* r) {
    r[0] = 2.0 + sq(x[0] - 2.0) + sq(x[1] - 1.0);
    r[1] = 9.0 * x[0] - sq(x[1] - 1.0);
    r[2] = sq(x[0]) + sq(x[1]);
    r[3] = x[0] - 3.0 * x[1];
  });
  return p;
}

// The books give x1 = -2.5 alone, where no limit acts. The front goes on at both ends: along
// x1 - 3 x2 = -10 down to the least f1, at (1.1, 3.7), and along the circle to the least f2.
Points srn_front(std::size_t density) {
  Points points;
  const auto add = [&](double x, double y) {
    points.push_back({2 + (x - 2) * (x - 2) + (y - 1) * (y - 1), 9 * x - (y - 1) * (y - 1)});
  };
  const double last = std::sqrt(225.0 - 6.25);
  for (std::size_t i = 0; i <= density; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(density);
    add(-2.5, 2.5 + (last - 2.5) * t);
    add(1.1 - 3.6 * t, (11.1 - 3.6 * t) / 3.0);
    const double x = -2.5 - 3.0 * t;
    add(x, std::sqrt(225.0 - x * x));
  }
  return thinned(pieces(std::move(points)), density);
}

optim::Problem osy() {
  optim::Problem p = two_objectives(box(6, 0.0, 10.0));
  for (const std::size_t j : {2U, 4U}) p.variables[j].lower = 1.0, p.variables[j].upper = 5.0;
  p.variables[3].upper = 6.0;
  for (int i = 0; i < 6; ++i)
    p.constraints.push_back({numbered('c', static_cast<std::size_t>(i)), 0.0, optim::kInfinity});
  p.evaluate = dual_evaluator<6>(8, [](const D6* x, D6* r) {
    r[0] = -(25.0 * sq(x[0] - 2.0) + sq(x[1] - 2.0) + sq(x[2] - 1.0) + sq(x[3] - 4.0) +
             sq(x[4] - 1.0));
    r[1] = sq(x[0]) + sq(x[1]) + sq(x[2]) + sq(x[3]) + sq(x[4]) + sq(x[5]);
    r[2] = x[0] + x[1] - 2.0;
    r[3] = 6.0 - x[0] - x[1];
    r[4] = 2.0 - x[1] + x[0];
    r[5] = 2.0 - x[0] + 3.0 * x[1];
    r[6] = 4.0 - sq(x[2] - 3.0) - x[3];
    r[7] = sq(x[4] - 3.0) + x[5] - 4.0;
  });
  return p;
}

Points osy_front(std::size_t density) {
  Points points;
  const auto add = [&](double x1, double x2, double x3, double x5) {
    points.push_back({-(25 * (x1 - 2) * (x1 - 2) + (x2 - 2) * (x2 - 2) + (x3 - 1) * (x3 - 1) + 16 +
                        (x5 - 1) * (x5 - 1)),
                      x1 * x1 + x2 * x2 + x3 * x3 + x5 * x5});
  };
  const std::size_t n = density * 4;
  for (std::size_t i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    add(5, 1, 1 + 4 * t, 5);
    add(5, 1, 1 + 4 * t, 1);
    add(4.056 + 0.944 * t, (2.056 + 0.944 * t) / 3, 1, 1);
    add(0, 2, 1 + 2.732 * t, 1);
    add(t, 2 - t, 1, 1);
  }
  return thinned(pieces(std::move(points)), density);
}

optim::Problem tnk() {
  optim::Problem p = two_objectives(box(2, 0.0, kPi));
  p.constraints = {{"c1", 0.0, optim::kInfinity}, {"c2", -optim::kInfinity, 0.5}};
  p.evaluate = dual_evaluator<6>(4, [](const D6* x, D6* r) {
    r[0] = x[0];
    r[1] = x[1];
    // atan(x1 / x2) = angle; its gradient (x2, -x1) / (x1^2 + x2^2) has no value at the origin
    D6 angle(std::atan2(x[0].v, x[1].v));
    const double size = x[0].v * x[0].v + x[1].v * x[1].v;
    for (int i = 0; i < 6; ++i) angle.d[i] = (x[1].v * x[0].d[i] - x[0].v * x[1].d[i]) / size;
    r[2] = sq(x[0]) + sq(x[1]) - 1.0 - 0.1 * cos(16.0 * angle);
    r[3] = sq(x[0] - 0.5) + sq(x[1] - 0.5);
  });
  return p;
}

Points tnk_front(std::size_t density) {
  Points points;
  const std::size_t n = 50 * density;
  for (std::size_t i = 0; i <= n; ++i) {
    const double angle = 0.5 * kPi * static_cast<double>(i) / static_cast<double>(n);
    const double radius = std::sqrt(1.0 + 0.1 * std::cos(16.0 * angle));
    const double x = radius * std::sin(angle);
    const double y = radius * std::cos(angle);
    if ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5) <= 0.5) points.push_back({x, y});
  }
  return thinned(pieces(std::move(points)), density);
}

optim::Problem dtlz(std::size_t n) {
  optim::Problem p;
  p.variables = box(n, 0.0, 1.0);
  p.objectives = {{"f1"}, {"f2"}, {"f3"}};
  return p;
}

}  // namespace

std::vector<KnownFront> known_fronts(std::size_t density) {
  std::vector<KnownFront> all;
  add_zdt(all, density);
  all.push_back({"BNH", bnh(), {140, 50}, 5285.33, bnh_front(density), false});
  all.push_back({"SRN", srn(), {250, 50}, 41575.1, srn_front(density), false});
  all.push_back({"OSY", osy(), {-30, 80}, 14516.05, osy_front(density), false});
  all.push_back({"TNK", tnk(), {1.2, 1.2}, 0.6551, tnk_front(density), false});
  return all;
}

optim::Problem dtlz1() {
  optim::Problem p = dtlz(7);
  p.evaluate = dual_evaluator<12>(3, [](const D12* x, D12* r) {
    D12 g(500.0);
    for (int j = 2; j < 7; ++j) g = g + 100.0 * (sq(x[j] - 0.5) - cos(20.0 * kPi * (x[j] - 0.5)));
    const D12 size = 0.5 * (1.0 + g);
    r[0] = size * x[0] * x[1];
    r[1] = size * x[0] * (1.0 - x[1]);
    r[2] = size * (1.0 - x[0]);
  });
  return p;
}

optim::Problem dtlz2() {
  optim::Problem p = dtlz(12);
  p.evaluate = dual_evaluator<12>(3, [](const D12* x, D12* r) {
    D12 g(0.0);
    for (int j = 2; j < 12; ++j) g = g + sq(x[j] - 0.5);
    const D12 size = 1.0 + g;
    r[0] = size * cos(0.5 * kPi * x[0]) * cos(0.5 * kPi * x[1]);
    r[1] = size * cos(0.5 * kPi * x[0]) * sin(0.5 * kPi * x[1]);
    r[2] = size * sin(0.5 * kPi * x[0]);
  });
  return p;
}

// From the right: gain[j] is the largest area of the staircase from point j on with the number of
// points used so far, counted below the height of the ceiling, which is the point before.
double best_hypervolume(const Points& front, std::size_t count,
                        const std::vector<double>& reference) {
  Points inside;
  for (const auto& p : front)
    if (p[0] < reference[0] && p[1] < reference[1]) inside.push_back(p);
  const std::size_t m = inside.size();
  std::vector<double> gain(m, 0.0);
  for (std::size_t used = 1; used < count; ++used) {
    std::vector<double> next(m, 0.0);
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t k = j + 1; k < m; ++k)
        next[j] = std::max(next[j],
                           (reference[0] - inside[k][0]) * (inside[j][1] - inside[k][1]) + gain[k]);
    gain = std::move(next);
  }
  double best = 0.0;
  for (std::size_t j = 0; j < m; ++j)
    best = std::max(best, (reference[0] - inside[j][0]) * (reference[1] - inside[j][1]) + gain[j]);
  return best;
}

}  // namespace twum::test
