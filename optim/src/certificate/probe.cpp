// SPDX-License-Identifier: Apache-2.0
#include "certificate/probe.hpp"

#include "certificate/newton.hpp"

#include <algorithm>
#include <cmath>

namespace twum::optim {
namespace {

using Eigen::Index;

class Probe {
  static constexpr int kCorrections = 4;  // Newton's steps back to curved limits

 public:
  Probe(Session& session, const Scaling& scaling, const ProbeBase& base)
      : session_(session), scaling_(scaling), base_(base) {}

  std::optional<std::vector<double>> along(const Eigen::VectorXd& direction) {
    double longest = 0.0;
    for (Index k = 0; k < direction.size(); ++k)
      longest = std::max(longest, std::abs(direction[k]) / base_.point.reach[at(k)]);
    if (!(longest > 0.0)) return std::nullopt;
    for (const double step : {1e-2, 1e-1, 1e-3}) {
      if (session_.left() < 1) return std::nullopt;
      auto there = moved(session_, scaling_, base_.point, step / longest * direction);
      for (int i = 0; there && there->jacobian.allFinite(); ++i) {
        if (better(*there)) return there->design;
        if ((i > 0 && keeps_limits(*there)) || i == kCorrections || session_.left() < 1) break;
        there = moved(session_, scaling_, *there, correction(*there, direction));
      }
    }
    return std::nullopt;
  }

 private:
  static std::size_t at(Index k) { return static_cast<std::size_t>(k); }

  Eigen::VectorXd correction(const KktPoint& there, const Eigen::VectorXd& direction) const {
    Multipliers m = base_.multipliers;
    m.active = active_columns(there, 1, m);
    Equations equations = active_equations(there, m);
    equations.add(direction.normalized(), 0.0, 0.0);
    const Eigen::VectorXd step = newton_step(base_.hessian, objective_gradients(there, 1),
                                             Eigen::VectorXd::Ones(1), equations, 1e-7)
                                     .unit;
    return step.allFinite() ? step : Eigen::VectorXd::Zero(step.size()).eval();
  }

  double objective(const KktPoint& p) const {
    const bool maximize = session_.problem().objectives[0].sense == Sense::maximize;
    return (maximize ? -1.0 : 1.0) * scaling_.factor(0) * p.evaluation.values[0];
  }

  bool keeps_limits(const KktPoint& p) const {
    return p.violation <=
           std::max(base_.point.violation, 0.01 * session_.options().feasibility_tolerance);
  }

  bool better(const KktPoint& p) const {
    return keeps_limits(p) && objective(p) < objective(base_.point) - base_.enough;
  }

  Session& session_;
  const Scaling& scaling_;
  const ProbeBase& base_;
};

}  // namespace

std::optional<std::vector<double>> descent(Session& session, const Scaling& scaling,
                                           const ProbeBase& base,
                                           const Eigen::VectorXd& direction) {
  return Probe(session, scaling, base).along(direction);
}

}  // namespace twum::optim
