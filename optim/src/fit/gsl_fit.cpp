// SPDX-License-Identifier: Apache-2.0
// GSL's trust region method for nonlinear least squares, under bounds.
#include "fit/fit_space.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <cmath>
#include <exception>
#include <memory>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;
using Vector = Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<>>;

Vector vector_of(const gsl_vector* v) {
  return {v->data, static_cast<Index>(v->size),
          Eigen::InnerStride<>(static_cast<Index>(v->stride))};
}

// A point that cannot be evaluated gets residuals this many times those of the current point; the method then rejects
// it and shortens its step.
constexpr double kFailed = 1e6;
// Smallest relative step; below it the parameters change in their last digits only.
constexpr double kSmallestStep = 1e-14;

// One run of GSL's method over some of the parameters. Beyond a bound the residuals stay those at the bound.
class GslRun {
 public:
  GslRun(FitSpace& space, const std::vector<Index>& free)
      : space_(space), free_(free), asked_(space.t()), r_(space.r()), j_(space.j()) {
    gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
    settings.solver = gsl_multifit_nlinear_solver_qr;
    work_.reset(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings,
                                           static_cast<std::size_t>(r_.size()), free.size()));
    system_.f = [](const gsl_vector* x, void* self, gsl_vector* f) {
      return static_cast<GslRun*>(self)->residuals(x, f);
    };
    system_.df = [](const gsl_vector* x, void* self, gsl_matrix* j) {
      return static_cast<GslRun*>(self)->jacobian(x, j);
    };
    system_.n = static_cast<std::size_t>(r_.size());
    system_.p = free.size();
    system_.params = this;
  }

  FitEnd run() {
    std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> begin(gsl_vector_alloc(free_.size()),
                                                                  &gsl_vector_free);
    for (std::size_t i = 0; i < free_.size(); ++i)
      gsl_vector_set(begin.get(), i, space_.t()[free_[i]]);
    int status = gsl_multifit_nlinear_init(begin.get(), &system_, work_.get());
    FitEnd end;
    while (end.word.empty()) {
      if (space_.options().stop.stop_requested()) return {"stopped on request", true};
      if (space_.out_of_evaluations()) return {"too many evaluations", true};
      status = gsl_multifit_nlinear_iterate(work_.get());
      if (thrown_) std::rethrow_exception(thrown_);
      settle();
      int reason = 0;
      if (status == GSL_ENOPROG)
        end.word = "no step lowers the sum of squares";
      else if (status != GSL_SUCCESS)
        end.word = gsl_strerror(status);
      else if (gsl_multifit_nlinear_test(kSmallestStep, 0, 0, &reason, work_.get()) == GSL_SUCCESS)
        end.word = "converged";
    }
    return end;
  }

 private:
  // The requested parameters, clamped into the box.
  Eigen::VectorXd place(const gsl_vector* x) const {
    Eigen::VectorXd t = space_.t();
    const Vector values = vector_of(x);
    for (std::size_t i = 0; i < free_.size(); ++i) t[free_[i]] = values[static_cast<Index>(i)];
    return t.cwiseMax(space_.lower()).cwiseMin(space_.upper());
  }

  // Residuals and Jacobian are computed together; GSL requests the Jacobian at the point of the residuals.
  int look(const gsl_vector* x) {
    const Eigen::VectorXd t = place(x);
    if (t == asked_) return GSL_SUCCESS;
    asked_ = t;
    try {
      ok_ = space_.evaluate(t, r_, j_);
    } catch (...) {  // no exception may pass through a C library
      thrown_ = std::current_exception();
      return GSL_EFAILED;
    }
    return GSL_SUCCESS;
  }

  int residuals(const gsl_vector* x, gsl_vector* f) {
    if (look(x) != GSL_SUCCESS) return GSL_EFAILED;
    for (Index i = 0; i < space_.r().size(); ++i)
      gsl_vector_set(f, static_cast<std::size_t>(i),
                     ok_ ? r_[i] : kFailed * (1 + space_.r().norm()));
    return GSL_SUCCESS;
  }

  int jacobian(const gsl_vector* x, gsl_matrix* j) {
    if (look(x) != GSL_SUCCESS || !ok_) return GSL_EFAILED;
    const Vector values = vector_of(x);
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const bool inside = values[static_cast<Index>(i)] == asked_[free_[i]];
      for (Index k = 0; k < j_.rows(); ++k)
        gsl_matrix_set(j, static_cast<std::size_t>(k), i, inside ? j_(k, free_[i]) : 0.0);
    }
    return GSL_SUCCESS;
  }

  // Moves the fit to the final point of GSL.
  void settle() {
    const Eigen::VectorXd t = place(gsl_multifit_nlinear_position(work_.get()));
    if (t == space_.t()) return;
    if (t == asked_ && ok_) space_.move(t, r_, j_);
  }

  struct Free {
    void operator()(gsl_multifit_nlinear_workspace* work) const { gsl_multifit_nlinear_free(work); }
  };

  FitSpace& space_;
  const std::vector<Index>& free_;
  Eigen::VectorXd asked_, r_;
  Eigen::MatrixXd j_;
  bool ok_{true};
  std::exception_ptr thrown_;
  gsl_multifit_nlinear_fdf system_{};
  std::unique_ptr<gsl_multifit_nlinear_workspace, Free> work_;
};

// Puts a parameter just short of a bound onto it if the sum of squares decreases towards it. Steps across a bound are
// shortened, so a run may only come close.
void press_to_bounds(FitSpace& space) {
  constexpr double kClose = 1e-8;
  Eigen::VectorXd t = space.t();
  for (const Index j : space.free_parameters()) {
    const double slope = space.j().col(j).dot(space.r());
    const double bound = slope > 0 ? space.lower()[j] : space.upper()[j];
    if (std::abs(t[j] - bound) <= kClose * std::abs(t[j])) t[j] = bound;
  }
  Eigen::VectorXd r;
  Eigen::MatrixXd jacobian;
  if (t != space.t() && space.evaluate(t, r, jacobian) &&
      r.squaredNorm() <= space.r().squaredNorm())
    space.move(t, r, jacobian);
}

}  // namespace

bool has_gsl() { return true; }

// Repeats runs. A parameter that ends at a bound is held there in the next run, and one that would leave its bound is
// released. Ends when the same parameters are held and the sum of squares no longer changes.
FitEnd gsl_fit(FitSpace& space) {
  // GSL's default error handler ends the program; each status is checked here instead.
  static const auto off = gsl_set_error_handler_off();
  static_cast<void>(off);
  std::vector<Index> before;
  double sum = kInfinity;
  while (true) {
    const std::vector<Index> free = space.free_parameters();
    if (free.empty()) return {"every parameter is held by a bound"};
    const double now = space.r().squaredNorm();
    if (free == before && !(now < sum)) return {"converged"};
    before = free;
    sum = now;
    const FitEnd end = GslRun(space, free).run();
    if (!end.cut_short) press_to_bounds(space);
    if (end.cut_short || space.free_parameters() == free) return end;
  }
}

}  // namespace twum::inline v0_1::optim
