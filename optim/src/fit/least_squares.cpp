// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/least_squares.hpp>

#include <twum/base/error.hpp>

#include "fit/fit_space.hpp"
#include "fit/huber_fit.hpp"
#include "solvers/optimizer.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

// Levenberg and Marquardt's method, with steps cut off at the bounds.
class ProjectedFit {
 public:
  explicit ProjectedFit(FitSpace& space) : space_(space) {}

  FitEnd run() {
    double damping = 1e-3;
    double growth = 2.0;
    int small = 0;
    while (true) {
      if (space_.options().stop.stop_requested()) return {"stopped on request", true};
      if (space_.out_of_evaluations()) return {"too many evaluations", true};
      update_scale();
      const auto free = space_.free_parameters();
      if (free.empty()) return {"every parameter is held by a bound"};
      const Eigen::VectorXd d = step(free, damping);
      const Eigen::VectorXd next =
          (space_.t() + d).cwiseMax(space_.lower()).cwiseMin(space_.upper());
      const Eigen::VectorXd moved = next - space_.t();
      if (moved.cwiseProduct(scale_).norm() <= 1e-16 * space_.t().cwiseProduct(scale_).norm())
        return {"no step changes the parameters"};
      Eigen::VectorXd r;
      Eigen::MatrixXd jacobian;
      const double before = space_.r().squaredNorm();
      const bool ok = space_.evaluate(next, r, jacobian);
      const double after = ok ? r.squaredNorm() : kInfinity;
      const double predicted = before - (space_.r() + space_.j() * moved).squaredNorm();
      const double ratio = predicted > 0.0 ? (before - after) / predicted : -1.0;
      if (ok && after <= before && (ratio > 1e-4 || predicted <= 1e-13 * before)) {
        const bool tiny = before - after <= space_.options().tolerance * before &&
                          moved.cwiseProduct(scale_).norm() <=
                              1e-9 * (space_.t().cwiseProduct(scale_).norm() + 1e-300);
        space_.move(next, r, jacobian);
        damping *= std::max(1.0 / 5.0, 1.0 - std::pow(2.0 * ratio - 1.0, 3));
        damping = std::max(damping, 1e-30);
        growth = 2.0;
        small = tiny ? small + 1 : 0;
        if (small >= 3 || after == 0.0) return {"converged"};
      } else {
        damping *= growth;
        growth *= 2.0;
        if (damping > 1e30) return {"no step lowers the sum of squares"};
      }
    }
  }

 private:
  // min |J d + r|^2 + damping |D d|^2 by QR of the stacked matrix.
  Eigen::VectorXd step(const std::vector<Index>& free, double damping) const {
    const Index k = static_cast<Index>(free.size());
    const Index m = space_.r().size();
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(m + k, k);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(m + k);
    b.head(m) = -space_.r();
    for (Index i = 0; i < k; ++i) {
      const Index j = free[static_cast<std::size_t>(i)];
      a.block(0, i, m, 1) = space_.j().col(j) / scale_[j];
      a(m + i, i) = std::sqrt(damping);
    }
    const Eigen::VectorXd y = a.colPivHouseholderQr().solve(b);
    Eigen::VectorXd d = Eigen::VectorXd::Zero(space_.t().size());
    for (Index i = 0; i < k; ++i) {
      const Index j = free[static_cast<std::size_t>(i)];
      d[j] = y[i] / scale_[j];
    }
    return d;
  }

  // Column norms, never shrinking (More 1978): the method is then blind to the parameters' units.
  void update_scale() {
    if (scale_.size() == 0) scale_ = Eigen::VectorXd::Zero(space_.t().size());
    for (Index j = 0; j < space_.t().size(); ++j)
      scale_[j] = std::max(scale_[j], space_.j().col(j).norm());
    for (Index j = 0; j < space_.t().size(); ++j)
      if (scale_[j] == 0.0) scale_[j] = 1.0;
  }

  FitSpace& space_;
  Eigen::VectorXd scale_;
};

FitEnd search(FitSpace& space, const std::string& solver) {
  if (!space.start()) return {"the start cannot be evaluated"};
  return solver == kGslFit ? gsl_fit(space) : ProjectedFit(space).run();
}

}  // namespace

const std::vector<SolverInfo>& least_squares_solvers() {
  static const std::vector<SolverInfo> list = [] {
    SolverInfo own, gsl;
    own.name = kOwnFit;
    own.description =
        "fits measurements: Levenberg and Marquardt's method, steps cut off at the bounds";
    gsl.name = kGslFit;
    gsl.description =
        has_gsl()
            ? "fits measurements: GSL's trust region method on parameters that are not at a bound"
            : "this build was made without GSL (TWUM_WITH_GSL=OFF)";
    gsl.available = has_gsl();
    for (SolverInfo* one : {&own, &gsl}) {
      one->gradient = true;
      one->on_failure = FailurePolicy::shorter_step;
    }
    return std::vector{own, gsl};
  }();
  return list;
}

LeastSquaresResult least_squares(const std::vector<Variable>& parameters,
                                 const ResidualFunction& residuals,
                                 const LeastSquaresOptions& options) {
  const auto& known = least_squares_solvers();
  const auto solver = std::find_if(known.begin(), known.end(),
                                   [&](const auto& one) { return one.name == options.solver; });
  if (solver == known.end())
    throw InputError("unknown solver '" + options.solver + "' of a fit; there are " +
                     std::string(kOwnFit) + " and " + std::string(kGslFit));
  require_available(*solver);
  if (parameters.empty()) throw InputError("least squares: there is no parameter");
  for (std::size_t j = 0; j < parameters.size(); ++j)
    for (std::size_t i = 0; i <= j; ++i)
      if (parameters[j].name.empty() || (i < j && parameters[i].name == parameters[j].name))
        throw InputError("parameter '" + parameters[j].name +
                         "': the name is empty or given twice");
  if (options.loss == Loss::huber) return huber_fit(parameters, residuals, options);
  FitSpace space(parameters, residuals, options);
  return space.result(search(space, options.solver));
}

const char* to_string(Loss value) noexcept {
  switch (value) {
    case Loss::squares: return "squares";
    case Loss::huber: return "huber";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::optim
