// SPDX-License-Identifier: Apache-2.0
#include "kinds/calibrate/answer_moves.hpp"

#include "entries/plate_derivatives.hpp"

#include <twum/optim/fit_moves.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

// Columns of the residuals' Jacobian that are not zero.
std::vector<std::size_t> seen(const optim::Residuals& residuals, std::size_t begin,
                              std::size_t columns) {
  std::vector<std::size_t> list;
  for (std::size_t k = begin; k < columns; ++k) {
    bool any = false;
    for (std::size_t i = 0; i < residuals.values.size(); ++i)
      any = any || residuals.jacobian[i * columns + k] != 0;
    if (any) list.push_back(k);
  }
  return list;
}

}  // namespace

bool may_move(const MotorDesign& motor, const ParameterInfo& row) {
  return !row.integer && row.parameter != Parameter::static_friction &&
         in_use(motor, row.parameter) && get(motor, row.parameter) != 0;
}

std::vector<Move> moves_of(const MeasuredFit& fit, const optim::LeastSquaresResult& best) {
  std::vector<Parameter> held;
  for (const ParameterInfo& row : parameter_table())
    if (may_move(fit.motor(), row) && !fit.sets(row.parameter) &&
        !equal_radius(fit.motor(), row.parameter, {}))
      held.push_back(row.parameter);
  std::vector<double> at;
  for (const optim::Estimate& e : best.estimates) at.push_back(e.value);
  const std::size_t n = at.size();
  for (const Parameter parameter : held) at.push_back(get(fit.motor(), parameter));
  const optim::Residuals here = fit.varying(held).residuals(at);
  if (!here.failure.empty()) return {};
  std::vector<Parameter> used;
  for (const std::size_t k : seen(here, n, at.size())) used.push_back(held[k - n]);

  const MeasuredFit wider = fit.varying(used);
  std::vector<double> values;
  for (const Parameter parameter : used) values.push_back(get(fit.motor(), parameter));
  const std::vector<double> slopes = optim::answer_moves(
      [&](std::span<const double> b) { return wider.residuals(b); }, best, values);
  std::vector<Move> moves;
  for (std::size_t k = 0; k < used.size(); ++k) {
    const ParameterInfo& row = info(used[k]);
    Move move{{std::string(row.name), std::string(row.unit), values[k]}, {}};
    for (std::size_t j = 0; j < n; ++j) move.slopes.push_back(slopes[j * used.size() + k]);
    moves.push_back(std::move(move));
  }
  return moves;
}

}  // namespace twum::inline v0_1::studies
