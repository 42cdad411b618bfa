// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/offset_test.hpp>

#include <twum/base/error.hpp>
#include <twum/optim/distributions.hpp>

#include "fit/fitted_space.hpp"

#include <Eigen/Core>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Parameters that leave less of an offset than this part of its squares take it up.
constexpr double kTakenUp = 1e-6;

VectorXd chosen(const VectorXd& all, std::span<const std::size_t> rows) {
  VectorXd some(static_cast<Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    some[static_cast<Index>(i)] = all[static_cast<Index>(rows[i])];
  return some;
}

}  // namespace

OffsetTest offset_test(const Residuals& at, const LeastSquaresResult& fit, const OffsetRows& asked,
                       double deviation) {
  TWUM_ASSERT(asked.rows.size() == asked.slopes.size());
  const auto count = static_cast<Index>(at.values.size());
  const VectorXd all = Eigen::Map<const VectorXd>(at.values.data(), count);
  const Eigen::MatrixXd q = fitted_space(free_jacobian(at, fit));
  const auto left_of = [&](const VectorXd& x) { return VectorXd(x - q * (q.transpose() * x)); };
  VectorXd step = VectorXd::Zero(count);
  for (std::size_t i = 0; i < asked.rows.size(); ++i)
    step[static_cast<Index>(asked.rows[i])] = asked.slopes[i];
  const VectorXd seen = left_of(step);
  const double squares = seen.squaredNorm();
  OffsetTest test;
  if (!(squares > kTakenUp * step.squaredNorm())) return test;
  test.offset = seen.dot(all) / squares;
  if (std::isfinite(deviation)) {
    test.deviation = deviation / std::sqrt(squares);
    test.p = student_tails(kInfinity, std::abs(test.offset) / test.deviation);
    return test;
  }
  const VectorXd rest = left_of(all) - test.offset * seen;
  double freedom = static_cast<double>(count - q.cols()) - 1.0;
  double scatter = rest.squaredNorm();
  if (asked.own_scatter) {
    freedom =
        static_cast<double>(asked.rows.size()) - chosen(seen, asked.rows).squaredNorm() / squares;
    for (Index k = 0; k < q.cols(); ++k) freedom -= chosen(q.col(k), asked.rows).squaredNorm();
    scatter = chosen(rest, asked.rows).squaredNorm();
  }
  if (!(freedom >= 1.0 && scatter > 0.0)) return test;
  test.deviation = std::sqrt(scatter / (freedom * squares));
  test.p = student_tails(freedom, std::abs(test.offset) / test.deviation);
  return test;
}

}  // namespace twum::inline v0_1::optim
