// SPDX-License-Identifier: Apache-2.0
#include "certificate/probe.hpp"

#include "certificate/newton.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;

class Probe {
  static constexpr int kCorrections = 4;  // Newton's steps back to curved limits

 public:
  Probe(Session& session, const Scaling& scaling, const ProbeBase& base)
      : session_(session), scaling_(scaling), base_(base) {}

  Probed along(const Eigen::VectorXd& direction) {
    constexpr double kLongest = 1e-1;
    double longest = 0.0;
    for (Index k = 0; k < direction.size(); ++k)
      longest = std::max(longest, std::abs(direction[k]) / base_.point.reach[at(k)]);
    Probed found;
    if (!(longest > 0.0)) return found;
    for (const double step : {1e-2, kLongest, 1e-3}) {
      const auto there = across(step / longest * direction, direction);
      if (!there) continue;
      if (better(*there)) return {there->design, false};
      if (step == kLongest) found.rises = worse(*there);
    }
    return found;
  }

 private:
  // A step, then Newton's across the direction until the limits are kept or the design is better.
  std::optional<KktPoint> across(const Eigen::VectorXd& step, const Eigen::VectorXd& direction) {
    if (session_.left() < 1) return std::nullopt;
    auto there = moved(session_, scaling_, base_.point, step);
    for (int i = 0; there && there->jacobian.allFinite(); ++i) {
      const bool done = better(*there) || (i > 0 && keeps_limits(*there));
      if (done || i == kCorrections || session_.left() < 1) return there;
      there = moved(session_, scaling_, *there, correction(*there, direction));
    }
    return std::nullopt;
  }

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

  bool worse(const KktPoint& p) const {
    return keeps_limits(p) && objective(p) > objective(base_.point) + base_.enough;
  }

  Session& session_;
  const Scaling& scaling_;
  const ProbeBase& base_;
};

}  // namespace

Probed probe(Session& session, const Scaling& scaling, const ProbeBase& base,
             const Eigen::VectorXd& direction) {
  return Probe(session, scaling, base).along(direction);
}

}  // namespace twum::inline v0_1::optim
