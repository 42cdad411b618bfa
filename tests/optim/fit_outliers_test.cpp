// SPDX-License-Identifier: Apache-2.0
// Residuals that chance does not explain (L7.1, L7.2), and fits that they move little (L8.1 to L8.3). The models are linear.
#include "optim/normal.hpp"

#include <twum/optim/fit_profile.hpp>
#include <twum/optim/outliers.hpp>
#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace twum::optim;
using twum::test::normal;

namespace {

// y over x; the places listed in `marked` each have a parameter of their own.
struct Line {
  std::vector<double> x, y;
  std::vector<std::size_t> marked{};

  std::vector<Variable> parameters() const {
    std::vector<Variable> list{{"level", -1e3, 1e3, 0.0}, {"slope", -1e3, 1e3, 0.0}};
    for (std::size_t k = 0; k < marked.size(); ++k)
      list.push_back({"shift " + std::to_string(k), -1e3, 1e3, 0.0});
    return list;
  }
  Residuals residuals(std::span<const double> b) const {
    Residuals r;
    for (std::size_t i = 0; i < x.size(); ++i) {
      double value = b[0] + b[1] * x[i] - y[i];
      std::vector<double> row{1.0, x[i]};
      for (std::size_t k = 0; k < marked.size(); ++k) {
        row.push_back(marked[k] == i ? 1.0 : 0.0);
        value += row.back() * b[2 + k];
      }
      r.values.push_back(value);
      r.jacobian.insert(r.jacobian.end(), row.begin(), row.end());
    }
    return r;
  }
  LeastSquaresResult fit(const LeastSquaresOptions& options = {}) const {
    return least_squares(
        parameters(), [this](auto b) { return residuals(b); }, options);
  }
  std::vector<Outlier> outliers(const LeastSquaresResult& of, double deviation = std::nan(""),
                                double level = 0.01) const {
    std::vector<double> b;
    for (const Estimate& e : of.estimates) b.push_back(e.value);
    return find_outliers(residuals(b), of, deviation, level);
  }
};

// Twenty points of 5 + 7 x with errors of 1.
Line noisy(std::uint64_t seed) {
  Random random(seed, 0, 0);
  Line line;
  for (int i = 0; i < 20; ++i) {
    line.x.push_back(0.5 * i);
    line.y.push_back(5 + 7 * line.x.back() + normal(random));
  }
  return line;
}

LeastSquaresOptions huber(double deviation = std::nan("")) {
  LeastSquaresOptions options;
  options.loss = Loss::huber;
  options.deviation = deviation;
  return options;
}

// The place where a falling function is 0.
template <typename Function>
double falls_through_zero(Function f, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

TEST_CASE("a distance is what a parameter of its own says of a residual (L7.1)",
          "[optim][least_squares][outlier]") {
  Line line = noisy(1);
  line.y[13] -= 9;
  line.marked = {13};
  // The shift of point 13, a parameter that only it sees: the mean shift model of an outlier (Cook and Weisberg 1982).
  for (const double deviation : {std::nan(""), 1.3}) {
    LeastSquaresOptions options;
    options.deviation = deviation;
    const Estimate shift = line.fit(options).estimates[2];
    Line plain = line;
    plain.marked.clear();
    const auto found = plain.outliers(plain.fit(options), deviation);
    REQUIRE(found.size() == 1);
    CHECK(found[0].residual == 13);
    // Its residual is fitted less measured, and the shift is what has to be added to the fitted.
    CHECK(found[0].distance == Approx(-shift.value / shift.standard_deviation).epsilon(1e-9));
  }
}

TEST_CASE("a probability is Student's, times the number of residuals (L7.2)",
          "[optim][least_squares][outlier][closed_form]") {
  // Five points about a line: Student's law of 5 - 2 - 1 = 2 degrees of freedom has the tails 1 - t / sqrt(2 + t^2).
  const Line line{{0, 1, 2, 3, 4}, {0.1, 1.0, 12.0, 3.1, 3.9}};
  const auto found = line.outliers(line.fit(), std::nan(""), 0.5);
  REQUIRE(found.size() == 1);
  CHECK(found[0].residual == 2);
  const double t = std::fabs(found[0].distance);
  CHECK(found[0].p == Approx(5 * (1 - t / std::sqrt(2 + t * t))).epsilon(1e-6));
}

TEST_CASE("two outliers do not hide each other", "[optim][least_squares][outlier]") {
  Line line = noisy(2);
  line.y[18] += 12;
  line.y[19] += 12;
  // Each by itself is hidden by the other, which pulls the line up: its shift alone is not unlikely.
  Line one = line;
  one.marked = {18};
  const Estimate alone = one.fit().estimates[2];
  CHECK(alone.value / alone.standard_deviation > -4);
  const auto found = line.outliers(line.fit());
  REQUIRE(found.size() == 2);
  CHECK(std::min(found[0].residual, found[1].residual) == 18);
  CHECK(std::max(found[0].residual, found[1].residual) == 19);
}

TEST_CASE("each of many outliers has the distance that it has without those found before",
          "[optim][least_squares][outlier]") {
  Line line = noisy(3);
  for (int i = 0; i < 40; ++i) {
    line.x.push_back(10.0 + 0.5 * i);
    line.y.push_back(5 + 7 * line.x.back() + 0.3 * std::sin(1.7 * i));
  }
  // One of them far out, which the slope follows most: without it all others have other shares.
  line.x.push_back(300);
  line.y.push_back(5 + 7 * 300.0 + 400);
  for (const std::size_t far : {3, 22, 31, 47}) line.y[far] += 30 + 3.0 * static_cast<double>(far);
  const auto found = line.outliers(line.fit());
  REQUIRE(found.size() >= 5);
  for (const Outlier& one : found) {
    Line marked = line;
    for (const Outlier& other : found) {
      marked.marked.push_back(other.residual);
      if (other.residual == one.residual) break;
    }
    const Estimate shift = marked.fit().estimates.back();
    CHECK(one.distance == Approx(-shift.value / shift.standard_deviation).epsilon(1e-9));
  }
}

TEST_CASE("outliers are found where there are none as often as the level says",
          "[optim][least_squares][outlier]") {
  constexpr int kRuns = 2000;
  constexpr double kLevel = 0.05;
  for (const double deviation : {std::nan(""), 1.0}) {
    int some = 0;
    for (int k = 0; k < kRuns; ++k) {
      const Line line = noisy(100 + static_cast<std::uint64_t>(k));
      LeastSquaresOptions options;
      options.deviation = deviation;
      some += line.outliers(line.fit(options), deviation, kLevel).empty() ? 0 : 1;
    }
    // Three standard deviations of a binomial number. A second look after the first residual is taken out may add to the
    // level by as much as its square root does not allow for: the bound from below is half the level.
    const double sd = std::sqrt(kLevel * (1 - kLevel) / kRuns);
    CAPTURE(deviation, some);
    CHECK(some < kRuns * (kLevel + 3 * sd));
    CHECK(some > kRuns * 0.5 * kLevel);
  }
}

TEST_CASE("without freedom nothing is an outlier", "[optim][least_squares][outlier]") {
  const Line two{{0, 1}, {3, 4}};
  CHECK(two.outliers(two.fit(), std::nan(""), 0.99).empty());
  const Line four{{0, 1, 2, 3}, {0, 1, 2, 900}};
  CHECK(four.outliers(four.fit(), std::nan(""), 0.99).empty());
}

TEST_CASE("where bounds hold every parameter a residual is its own distance",
          "[optim][least_squares][outlier]") {
  Line line = noisy(3);
  auto held = line.fit();
  line.y[4] += 40;
  for (Estimate& e : held.estimates) e.at_bound = true;
  const auto found = line.outliers(held, 1.0);
  REQUIRE(found.size() == 1);
  const double fitted = held.estimates[0].value + held.estimates[1].value * line.x[4];
  CHECK(found[0].distance == Approx(fitted - line.y[4]));
}

TEST_CASE("Huber's fit solves his two equations (L8.1, L8.2)", "[optim][least_squares][huber]") {
  // A level alone. With the scale s known sum psi((y - b) / s) = 0; else sum psi^2 = (m - 1) beta as well, with beta the
  // mean of psi^2 for normal numbers, here by the midpoint rule. Both by nested halving.
  const std::vector<double> y{1.1, 0.7, 1.3, 0.9, 1.0, 1.2, 0.8, 9.0, 1.05, 7.5};
  static constexpr double kBend = 1.345;
  const auto psi = [](double u) { return std::clamp(u, -kBend, kBend); };
  const auto level_at = [&](double s) {
    return falls_through_zero(
        [&](double b) {
          double sum = 0;
          for (const double value : y) sum += psi((value - b) / s);
          return sum;
        },
        0, 10);
  };
  double beta = 0;
  constexpr int kSteps = 200000;
  for (int i = 0; i < kSteps; ++i) {
    const double z = -9 + 18 * (i + 0.5) / kSteps;
    beta +=
        psi(z) * psi(z) * std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi) * 18 / kSteps;
  }
  const double scale = falls_through_zero(
      [&](double s) {
        double sum = 0;
        for (const double value : y) sum += std::pow(psi((value - level_at(s)) / s), 2);
        return sum - 9 * beta;
      },
      0.01, 10);
  const auto residuals = [&](std::span<const double> b) {
    Residuals r;
    for (const double value : y) r.values.push_back(b[0] - value);
    r.jacobian.assign(y.size(), 1.0);
    return r;
  };
  const std::vector<Variable> level{{"level", 0, 10, 5}};
  const auto known = least_squares(level, residuals, huber(0.2));
  CHECK(known.outcome == Outcome::optimal);
  CHECK(known.estimates[0].value == Approx(level_at(0.2)).epsilon(1e-8));
  const auto found = least_squares(level, residuals, huber());
  CHECK(found.outcome == Outcome::optimal);
  CHECK(found.estimates[0].value == Approx(level_at(scale)).epsilon(1e-8));
  CHECK(found.residual_deviation == Approx(scale).epsilon(1e-7));
  CHECK(found.bend == Approx(kBend * scale).epsilon(1e-7));
  CHECK(found.share == Approx(0.8));  // 7.5 and 9 are beyond
}

TEST_CASE("Huber's intervals hold the truth as often as they say (L8.3)",
          "[optim][least_squares][huber]") {
  constexpr int kRuns = 1000;
  const double known = GENERATE(std::nan(""), 1.0);
  int inside = 0;
  double off = 0, off_squares = 0;
  for (int k = 0; k < kRuns; ++k) {
    Line line = noisy(3000 + static_cast<std::uint64_t>(k));
    line.y[static_cast<std::size_t>(k % 20)] += 8;
    const Estimate slope = line.fit(huber(known)).estimates[1];
    inside += slope.low <= 7 && 7 <= slope.high ? 1 : 0;
    off += std::fabs(slope.value - 7);
    off_squares += std::fabs(line.fit().estimates[1].value - 7);
  }
  // 95 % of 1000: 950 with a standard deviation of 6.9. The shifts are all to one side and move the slope by a part
  // of its interval, so that a few less are inside.
  CAPTURE(known, inside);
  CHECK(inside > 930);
  CHECK(inside < 971);
  CHECK(off < 0.7 * off_squares);
}

TEST_CASE("without residuals beyond the bend Huber's fit is that of least squares",
          "[optim][least_squares][huber]") {
  const Line line = noisy(4);
  const auto squares = line.fit();
  const auto fit = line.fit(huber(100.0));
  for (std::size_t j = 0; j < 2; ++j)
    CHECK(fit.estimates[j].value == Approx(squares.estimates[j].value).epsilon(1e-9));
}

TEST_CASE("an interval's end under Huber's loss is where the loss says (L3.1, L8.1)",
          "[optim][least_squares][huber]") {
  // A level alone: nothing is left to fit while it is held. The loss is written out as Huber has it.
  const std::vector<double> y{0.2, -0.4, 0.1, 0.5, -0.2, 0.3, 2.5, 2.9};
  constexpr double kBend = 1.345;
  const auto loss = [&](double b) {
    double sum = 0;
    for (const double value : y) {
      const double u = std::fabs(value - b) / 0.4;
      sum += 2 * 0.16 * (u < kBend ? 0.5 * u * u : kBend * u - 0.5 * kBend * kBend);
    }
    return sum;
  };
  const ResidualFunction residuals = [&](std::span<const double> b) {
    Residuals r;
    for (const double value : y) r.values.push_back(b[0] - value);
    r.jacobian.assign(y.size(), 1.0);
    return r;
  };
  const std::vector<Variable> level{{"level", -5, 5, 0}};
  const auto fit = least_squares(level, residuals, huber(0.4));
  const double centre = fit.estimates[0].value;
  const double rise = fit.share * std::pow(fit.student_t * fit.scatter, 2);
  const double half = fit.student_t * fit.estimates[0].standard_deviation;
  for (const double sign : {-1.0, 1.0}) {
    const double wanted = falls_through_zero(
        [&](double u) { return loss(centre) + rise - loss(centre + sign * u); }, 0, 4);
    const ProfileEnd end = profile_end(level, residuals, huber(0.4), fit, 0,
                                       sign < 0 ? IntervalEnd::low : IntervalEnd::high);
    const double stands = end.linear ? half : std::fabs(end.value - centre);
    // The linear end stands where it is right to a tenth; others are searched for to a thousandth.
    CHECK(stands == Approx(wanted).epsilon(end.linear ? 0.12 : 3e-3));
  }
}
