// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/fit_band.hpp>

#include <twum/base/error.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace twum::optim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kWidenings = 8;      // of the region, to all of it
constexpr int kMostSteps = 20;     // in each
constexpr double kSettled = 1e-3;  // step, in parts of the region's half width and of the band's
constexpr double kOutside = 0.5;   // most that a step may leave the region, in parts of its rise
constexpr double kMissed = 0.01;   // most that the end may be outside of it
constexpr double kRidge = 1e-12;   // keeps the squares positive where the data see no change

struct Place {
  VectorXd b, r, gradient;
  MatrixXd jacobian;
  double value{0};

  double squares() const { return r.squaredNorm(); }
};

VectorXd vector_of(std::span<const double> values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

class Way {
 public:
  Way(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
      const PredictionFunction& prediction, double rise, BandEnd end)
      : residuals_(residuals),
        prediction_(prediction),
        rise_(rise),
        sign_(end == BandEnd::high ? 1 : -1),
        low_(static_cast<Index>(parameters.size())),
        high_(low_.size()) {
    for (Index j = 0; j < low_.size(); ++j) {
      low_[j] = parameters[static_cast<std::size_t>(j)].lower;
      high_[j] = parameters[static_cast<std::size_t>(j)].upper;
    }
  }

  std::optional<Place> at(const VectorXd& b) const try {
    const std::vector<double> values(b.begin(), b.end());
    const Residuals found = residuals_(values);
    if (!found.failure.empty()) return {};
    const Prediction predicted = prediction_(values);
    if (predicted.gradient.empty()) return {};
    const auto rows = static_cast<Index>(found.values.size());
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Place place{b, vector_of(found.values), vector_of(predicted.gradient),
                Eigen::Map<const Rows>(found.jacobian.data(), rows, b.size()), predicted.value};
    if (!place.r.allFinite() || !place.jacobian.allFinite() || !place.gradient.allFinite())
      return {};
    return place;
  } catch (const EvaluationError&) {
    return {};
  }

  // The extreme in a region of this sum of squares, from a place in or near it. Nothing where the steps do not settle.
  std::optional<Place> extreme(Place from, double limit, double fitted) const {
    for (int i = 0; i < kMostSteps; ++i) {
      const VectorXd step = step_from(from, limit);
      auto next = shortened(from, step, limit);
      if (!next) return {};
      const bool settled =
          size_of(from, next->b - from.b) <= kSettled &&
          std::fabs(next->value - from.value) <= kSettled * std::fabs(next->value - fitted);
      from = std::move(*next);
      if (settled && from.squares() <= limit + kMissed * rise_) return from;
    }
    return {};
  }

 private:
  // Length of a step in parts of the region's half width, by the residuals to first order.
  double size_of(const Place& p, const VectorXd& step) const {
    return (p.jacobian * step).norm() / std::sqrt(rise_);
  }

  // Largest sign * g^T d where |r + J d|^2 <= limit; parameters that a bound holds end there.
  VectorXd step_from(const Place& p, double limit) const {
    VectorXd step = VectorXd::Zero(p.b.size());
    std::vector<Index> free;
    for (Index j = 0; j < p.b.size(); ++j) free.push_back(j);
    while (!free.empty()) {
      const VectorXd d = free_step(p, p.r + p.jacobian * step, free, limit);
      bool inside = true;
      std::vector<Index> left;
      for (std::size_t k = 0; k < free.size(); ++k) {
        const Index j = free[k];
        const double b = p.b[j] + d[static_cast<Index>(k)];
        if (b >= low_[j] && b <= high_[j]) {
          left.push_back(j);
          continue;
        }
        step[j] = std::clamp(b, low_[j], high_[j]) - p.b[j];
        inside = false;
      }
      if (inside) {
        for (std::size_t k = 0; k < free.size(); ++k) step[free[k]] = d[static_cast<Index>(k)];
        break;
      }
      free = left;
    }
    return step;
  }

  // In the columns J of the free parameters, H = J^T J: d = -H^-1 J^T r +- sqrt(room / g^T H^-1 g) H^-1 g. Room is what the limit
  // leaves above the least sum of squares to first order.
  VectorXd free_step(const Place& p, const VectorXd& r, const std::vector<Index>& free,
                     double limit) const {
    const MatrixXd j = p.jacobian(Eigen::all, free);
    const VectorXd g = p.gradient(free), jr = j.transpose() * r;
    MatrixXd h = j.transpose() * j;
    const VectorXd root = h.diagonal().cwiseSqrt().cwiseMax(1e-300);
    h = root.cwiseInverse().asDiagonal() * h * root.cwiseInverse().asDiagonal();
    h.diagonal().array() += kRidge;
    const Eigen::LDLT<MatrixXd> squares(h);
    const auto solved = [&](const VectorXd& v) -> VectorXd {
      return squares.solve(v.cwiseQuotient(root)).cwiseQuotient(root);
    };
    const VectorXd home = -solved(jr), way = solved(g);
    const double room = limit - (r.squaredNorm() + jr.dot(home)), reach = g.dot(way);
    if (!(room > 0) || !(reach > 0)) return home;
    return home + sign_ * std::sqrt(room / reach) * way;
  }

  // The first part of a step, halved again and again, that ends in the region or next to it.
  std::optional<Place> shortened(const Place& from, VectorXd step, double limit) const {
    constexpr int kHalvings = 8;
    for (int i = 0; i < kHalvings; ++i, step *= 0.5) {
      auto next = at((from.b + step).cwiseMax(low_).cwiseMin(high_));
      const double allowed = std::max(limit + kOutside * rise_, from.squares());
      if (next && next->squares() <= allowed) return next;
    }
    return {};
  }

  const ResidualFunction& residuals_;
  const PredictionFunction& prediction_;
  double rise_, sign_;
  VectorXd low_, high_;
};

}  // namespace

std::optional<std::vector<double>> band_end(const std::vector<Variable>& parameters,
                                            const ResidualFunction& residuals,
                                            const PredictionFunction& prediction,
                                            std::span<const double> estimates, double rise,
                                            BandEnd end, std::span<const double> near) {
  const Way way(parameters, residuals, prediction, rise, end);
  auto place = way.at(vector_of(estimates));
  if (!place) return {};
  const double least = place->squares(), fitted = place->value;
  std::optional<Place> found;
  if (!near.empty())
    if (auto start = way.at(vector_of(near)))
      found = way.extreme(std::move(*start), least + rise, fitted);
  for (int k = 1; k <= kWidenings && !found; ++k) {
    const double share = k / double{kWidenings};
    place = way.extreme(std::move(*place), least + rise * share * share, fitted);
    if (!place) return {};
    if (k == kWidenings) found = std::move(place);
  }
  return std::vector<double>(found->b.begin(), found->b.end());
}

}  // namespace twum::optim
