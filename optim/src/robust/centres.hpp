// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/importance.hpp"

#include <functional>
#include <optional>

namespace twum::inline v0_1::optim {

/// The worst point of a term, searched from a direction in which it fails.
using WorstPoint = std::function<InversePoint(std::size_t term, std::span<const double> direction)>;

/// Which terms take part in the risk of their target: those whose index is at most the least one and 1.5.
std::vector<bool> take_part(const RobustTerms& terms, std::span<const double> beta);

/// The centres of an importance sample, U4.1: the worst points of the limits that take part in the risk, and those that a
/// sample shows to be missing.
class Centres {
 public:
  /// Keeps references.
  /// @param points  of each term
  /// @param taken   whether the point of a term is a centre
  Centres(const RobustProblem& problem, const RobustTerms& terms, std::span<const double> x,
          std::vector<InversePoint> points, std::vector<bool> taken, WorstPoint worst);

  /// One more centre, unless there is one in this direction.
  void add(const std::vector<double>& z);

  /// Draws a sample. If failing products lie away from every centre, adds a centre there and draws again; not with measured
  /// rows, of which a failing one lies nowhere.
  ImportanceSample sample(const SamplePlan& plan);
  /// Draws a sample about the centres as they are. Only such samples give an unbiased risk: one that is drawn again where it
  /// shows a new way to fail, and kept where it misses it, is one-sided.
  ImportanceSample sample_unchanged(const SamplePlan& plan) const;

  /// True if the worst point of the term is a centre.
  bool holds(std::size_t term) const { return taken_[term]; }
  /// Worst points of all terms; of two points for a term, the worse one.
  const std::vector<InversePoint>& points() const noexcept { return points_; }
  const NormalPoints& centres() const noexcept { return centres_; }

 private:
  struct Missed {
    std::size_t product;
    std::optional<std::size_t> term;
  };

  std::vector<double> drawn_about(std::vector<double> z) const;
  bool near(std::span<const double> z, double cosine) const;
  std::optional<Missed> lightest_missed(const ImportanceSample& sample) const;
  bool add_missing(const ImportanceSample& sample);

  const RobustProblem& problem_;
  const RobustTerms& terms_;
  std::span<const double> x_;
  std::vector<InversePoint> points_;
  std::vector<bool> taken_;
  WorstPoint worst_;
  NormalPoints centres_;
};

}  // namespace twum::inline v0_1::optim
