// SPDX-License-Identifier: Apache-2.0
#include "robust/importance.hpp"

#include <twum/optim/distributions.hpp>
#include <twum/optim/scrambled_sobol.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <twum/base/error.hpp>
#include <twum/base/ordered.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kWideShare = 0.1;
constexpr double kShiftedShare = 1.0 - kPlainShare - kWideShare;
constexpr std::size_t kNeighbours = 40;

std::vector<double> margins_at(const RobustProblem& problem, const RobustTerms& terms,
                               std::span<const double> x, std::span<const double> z) {
  Evaluation answer;
  try {
    answer = problem.built(build(problem, x, z), {}, false);
  } catch (const EvaluationError& error) {
    answer.failure = error.reason();
  }
  std::vector<double> margins;
  for (const RobustTerm& term : terms.terms)
    margins.push_back(answer.ok() ? term.margin.sign *
                                        (answer.values[term.margin.response] - term.margin.end)
                                  : -kInfinity);
  return margins;
}

}  // namespace

std::vector<double> drawn_normals(std::span<const double> u, const NormalPoints& centres) {
  std::vector<double> z;
  for (std::size_t k = 0; k + 1 < u.size(); ++k) z.push_back(normal_quantile(u[k]));
  const double share = u.back();
  if (share < kPlainShare || centres.empty()) return z;
  if (share < kPlainShare + kWideShare) {
    for (double& c : z) c *= 2.0;
    return z;
  }
  const auto count = static_cast<double>(centres.size());
  const auto chosen =
      static_cast<std::size_t>((share - kPlainShare - kWideShare) / kShiftedShare * count);
  const auto& centre = centres[std::min(chosen, centres.size() - 1)];
  for (std::size_t k = 0; k < z.size(); ++k) z[k] += centre[k];
  return z;
}

double drawn_weight(std::span<const double> z, const NormalPoints& centres) {
  if (centres.empty()) return 1.0;
  const double square = dot(z, z);
  const auto m = static_cast<double>(z.size());
  double density = kPlainShare + kWideShare * std::exp2(-m) * std::exp(0.375 * square);
  for (const auto& c : centres)
    density +=
        kShiftedShare / static_cast<double>(centres.size()) * std::exp(dot(c, z) - 0.5 * dot(c, c));
  return 1.0 / density;
}

ImportanceSample draw_importance(const RobustProblem& problem, const RobustTerms& terms,
                                 std::span<const double> x, const NormalPoints& centres,
                                 const SamplePlan& plan) {
  const ScrambledSobol sobol(drawn_numbers(problem) + 1, plan.seed, plan.replicate);
  const auto count = static_cast<double>(plan.products);
  struct Product {
    std::vector<double> z;
    std::vector<double> margins;
  };
  ImportanceSample sample;
  const std::uint64_t made = run_indexed(
      {0, plan.products, plan.jobs, plan.proceed},
      [&](std::uint64_t index) {
        std::vector<double> u(sobol.dimension());
        sobol.point(index, u);
        Product product{drawn_normals(u, centres), {}};
        product.margins = margins_at(problem, terms, x, product.z);
        return product;
      },
      [&](std::uint64_t, std::vector<Product>& products) {
        for (Product& product : products) {
          sample.weights.push_back(drawn_weight(product.z, centres) / count);
          sample.margins.push_back(std::move(product.margins));
          sample.normals.push_back(std::move(product.z));
        }
        if (plan.sampled) plan.sampled(sample.weights.size(), plan.products);
      });
  sample.complete = made == plan.products;
  return sample;
}

SampledRisk sampled_risk(const ImportanceSample& sample, std::span<const std::size_t> terms) {
  SampledRisk risk{std::vector<double>(terms.size(), 0.0)};
  const auto count = static_cast<double>(sample.weights.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < sample.weights.size(); ++i) {
    const double w = sample.weights[i];
    bool any = false;
    for (std::size_t j = 0; j < terms.size(); ++j) {
      if (!(sample.margins[i][terms[j]] < 0.0)) continue;
      risk.of_term[j] += w;
      any = true;
    }
    if (!any) continue;
    risk.any += w;
    squares += w * w;
  }
  const double variance = std::max(0.0, count * squares - risk.any * risk.any);
  risk.error = std::sqrt(variance / count);
  return risk;
}

double weighted_quantile(const ImportanceSample& sample, std::size_t term, double beta) {
  std::vector<std::size_t> order(sample.weights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sample.margins[a][term] < sample.margins[b][term];
  });
  struct Point {
    double t;  // Phi^-1(F)
    double margin;
  };
  std::vector<Point> points;
  double below = 0.0;
  for (const std::size_t i : order) {
    const double share = below + 0.5 * sample.weights[i];
    below += sample.weights[i];
    const double margin = sample.margins[i][term];
    if (std::isfinite(margin) && share < 1.0) points.push_back({normal_quantile(share), margin});
  }
  const auto crossing = std::lower_bound(points.begin(), points.end(), -beta,
                                         [](const Point& p, double t) { return p.t < t; });
  const auto at = static_cast<std::size_t>(crossing - points.begin());
  const std::size_t first = at > kNeighbours / 2 ? at - kNeighbours / 2 : 0;
  const std::size_t last = std::min(points.size(), first + kNeighbours);
  if (last < first + 2) return std::numeric_limits<double>::quiet_NaN();
  double st = 0.0, sg = 0.0, stt = 0.0, stg = 0.0;
  const auto n = static_cast<double>(last - first);
  for (std::size_t i = first; i < last; ++i) {
    st += points[i].t;
    sg += points[i].margin;
  }
  for (std::size_t i = first; i < last; ++i) {
    const double dt = points[i].t - st / n;
    stt += dt * dt;
    stg += dt * (points[i].margin - sg / n);
  }
  const double slope = stt > 0.0 ? stg / stt : 0.0;
  return sg / n + slope * (-beta - st / n);
}

double weighted_spread(const ImportanceSample& sample, std::size_t term) {
  double weights = 0.0, sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < sample.weights.size(); ++i) {
    const double margin = sample.margins[i][term];
    if (!std::isfinite(margin)) continue;
    weights += sample.weights[i];
    sum += sample.weights[i] * margin;
    squares += sample.weights[i] * margin * margin;
  }
  if (!(weights > 0.0)) return 0.0;
  const double mean = sum / weights;
  return std::sqrt(std::max(0.0, squares / weights - mean * mean));
}

}  // namespace twum::inline v0_1::optim
