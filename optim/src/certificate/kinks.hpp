// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/kkt.hpp"

#include <functional>

namespace twum::inline v0_1::optim {

/// Kinks at one design: those that the evaluator reports, and those that gradients at its neighbours show.
class Kinks {
 public:
  Kinks(Session& session, const Scaling& scaling, const KktPoint& point);

  /// Whether a derivative does not exist, of a response that matters by a variable that may vary.
  bool undefined(const std::function<bool(std::size_t response)>& matters) const;

  /// Candidate gradients of the objective at the reported kinks. For each matrix, some convex combination of its
  /// columns has to be stationary. Without kinks, the gradients themselves.
  std::vector<Eigen::MatrixXd> reported();

  /// A point that is not stationary may lie on a kink. Then gradients on its two sides differ at any distance, and some
  /// convex combination of them is stationary. Returns these gradients; nothing if there is no kink, or if a neighbour
  /// is better. @throws Stop
  std::optional<Eigen::MatrixXd> found_nearby();

  /// Variables whose one-sided derivatives of the objective differ, in the order they were found.
  const std::vector<std::string>& names() const { return names_; }

 private:
  void add_candidates(const KinkedEntry& kink, bool mixes, const Eigen::MatrixXd& g,
                      std::vector<Eigen::MatrixXd>& all);
  std::optional<std::size_t> position(std::size_t variable) const;
  const std::string& name(std::size_t k) const;
  void note(const std::string& variable);
  double objective(const KktPoint& p) const;
  bool better(const KktPoint& p) const;
  std::optional<KktPoint> neighbour(Eigen::Index k, double step);
  std::optional<double> jump(Eigen::Index k, double step);

  Session& session_;
  const Scaling& scaling_;
  const KktPoint& point_;
  std::size_t objectives_;
  std::vector<std::string> names_;
};

}  // namespace twum::inline v0_1::optim
