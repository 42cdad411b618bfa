// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/low_discrepancy.hpp>

#include "fronts/front_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::optim {
namespace {

// Points within kSame of the front's size are equal; gaps above kWide may hide a piece of the front.
constexpr double kSame = 1e-7;
constexpr double kWide = 0.03;

class TwoObjectives {
 public:
  TwoObjectives(FrontSearch& search, const ParetoOptions& options)
      : search_(search), options_(options) {}

  std::vector<Solved> run() {
    front_ = {search_.ends()[0], search_.ends()[1]};
    tidy();
    if (front_.size() < 2) return std::move(front_);
    coarse();
    refine();
    return std::move(front_);
  }

 private:
  // Points all over the front, each from several starts, to find pieces that cannot be reached from neighbours.
  void coarse() {
    const std::size_t n = search_.runner().scaling().size();
    const auto far =
        sobol_points(n, options_.coarse * options_.coarse_starts + 1, options_.solve.seed + 7);
    for (std::size_t i = 1; i <= options_.coarse && !search_.exhausted(); ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(options_.coarse + 1);
      const std::vector<double> m{part, 1.0 - part};
      std::vector<std::vector<double>> starts{nearest(m).unit};
      if (auto known = search_.from_pool(m); !known.empty()) starts.push_back(std::move(known));
      for (std::size_t s = 0; s < options_.coarse_starts; ++s)
        starts.push_back(far[(i - 1) * options_.coarse_starts + s + 1]);
      auto found = search_.scalarize(m, {1.0, 1.0}, starts, true);
      if (found) front_.push_back(std::move(*found));
    }
    tidy();
  }

  const Solved& nearest(const std::vector<double>& y) const {
    const auto distance = [&](const Solved& s) { return std::hypot(s.y[0] - y[0], s.y[1] - y[1]); };
    return *std::min_element(front_.begin(), front_.end(), [&](const auto& a, const auto& b) {
      return distance(a) < distance(b);
    });
  }

  // Always halves the gap whose rectangle is largest: there the hypervolume has most to gain.
  void refine() {
    const std::size_t wanted = 2 * options_.points;
    while (front_.size() < wanted && !search_.exhausted()) {
      const std::size_t at = widest();
      if (at + 1 >= front_.size()) return;
      halve(at);
    }
  }

  bool closed(const Solved& a, const Solved& b) const {
    return std::any_of(closed_.begin(), closed_.end(),
                       [&](const auto& c) { return c.first == a.y && c.second == b.y; });
  }

  std::size_t widest() const {
    std::size_t best = front_.size();
    double largest = kSame * kSame;
    for (std::size_t i = 0; i + 1 < front_.size(); ++i) {
      const double area =
          (front_[i + 1].y[0] - front_[i].y[0]) * (front_[i].y[1] - front_[i + 1].y[1]);
      if (area <= largest || closed(front_[i], front_[i + 1])) continue;
      largest = area;
      best = i;
    }
    return best;
  }

  // Searches along the normal of the chord from its middle. In a hole of the front, the answer is exactly one end of
  // the hole; once both ends are known, the gap is closed.
  void halve(std::size_t at) {
    const Solved a = front_[at];
    const Solved b = front_[at + 1];
    const double dx = b.y[0] - a.y[0];
    const double dy = a.y[1] - b.y[1];
    const double length = std::hypot(dx, dy);
    const std::vector<double> m{0.5 * (a.y[0] + b.y[0]), 0.5 * (a.y[1] + b.y[1])};
    const std::vector<double> n{std::max(dy / length, 0.02), std::max(dx / length, 0.02)};
    std::vector<double> middle = a.unit;
    for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = 0.5 * (a.unit[k] + b.unit[k]);
    auto found = search_.scalarize_predicted(m, n, a, b);
    if (!found || !between(*found, a, b)) found = search_.scalarize(m, n, {middle}, false);
    // If the problem is steep at a bound, rounding there can make a solver fail. So first try with the variables held
    // that are at the same bound in both neighbours.
    for (const std::vector<double>* start : {&std::as_const(middle), &a.unit, &b.unit})
      if (!found || !between(*found, a, b)) found = search_.scalarize_within(m, n, *start, a, b);
    if (!found || !between(*found, a, b)) found = search_.scalarize(m, n, {a.unit, b.unit}, true);
    // In a wide gap, also start elsewhere, because its ends may belong to other local optima than its middle.
    if ((!found || !between(*found, a, b)) && length > kWide)
      found = search_.scalarize(m, n, elsewhere(m), true);
    if (found && between(*found, a, b)) {
      front_.push_back(std::move(*found));
      tidy();
      return;
    }
    close(a, b, std::move(found));
  }

  std::vector<std::vector<double>> elsewhere(const std::vector<double>& m) {
    constexpr std::size_t kStarts = 8;
    const std::size_t n = search_.runner().scaling().size();
    auto starts = sobol_points(n, kStarts, options_.solve.seed + 100 + closed_.size());
    if (auto known = search_.from_pool(m); !known.empty()) starts.push_back(std::move(known));
    return starts;
  }

  static bool between(const Solved& s, const Solved& a, const Solved& b) {
    const double dx = 1e-3 * (b.y[0] - a.y[0]);
    const double dy = 1e-3 * (a.y[1] - b.y[1]);
    return s.y[0] > a.y[0] + dx && s.y[0] < b.y[0] - dx && s.y[1] < a.y[1] - dy &&
           s.y[1] > b.y[1] + dy;
  }

  // Finds both ends of a hole. The piece on the right begins where the second objective falls below that of the left
  // end. The piece on the left ends where the second objective cannot be lowered further.
  void close(const Solved& a, const Solved& b, std::optional<Solved> found) {
    closed_.emplace_back(a.y, b.y);
    const double step = 10.0 * kSame;
    keep(std::move(found));
    const auto left = search_.scalarize({b.y[0] - step, 0.0}, {0.0, 1.0}, {a.unit}, false);
    const double level = std::min(a.y[1], left ? left->y[1] : a.y[1]);
    keep(left);
    const auto right = search_.scalarize({0.0, level - step}, {1.0, 0.0}, {b.unit}, false);
    keep(right);
    tidy();
    for (std::size_t i = 0; right && i + 1 < front_.size(); ++i)
      if (front_[i + 1].y == right->y) closed_.emplace_back(front_[i].y, right->y);
  }

  void keep(std::optional<Solved> s) {
    if (s && is_new(*s)) front_.push_back(std::move(*s));
  }

  // Whether the point improves on all known ones by more than the solver's accuracy.
  bool is_new(const Solved& s) const {
    return std::none_of(front_.begin(), front_.end(), [&](const Solved& f) {
      return f.y[0] <= s.y[0] + kSame && f.y[1] <= s.y[1] + kSame;
    });
  }

  // Sorts by the first objective and drops what is dominated or repeated.
  void tidy() {
    std::stable_sort(front_.begin(), front_.end(),
                     [](const auto& a, const auto& b) { return a.y < b.y; });
    std::vector<Solved> kept;
    for (Solved& s : front_)
      if (kept.empty() || s.y[1] < kept.back().y[1] - 1e-9) kept.push_back(std::move(s));
    front_ = std::move(kept);
  }

  FrontSearch& search_;
  const ParetoOptions& options_;
  std::vector<Solved> front_;
  std::vector<std::pair<std::vector<double>, std::vector<double>>> closed_;
};

}  // namespace

std::vector<Solved> two_objective_front(FrontSearch& search, const ParetoOptions& options) {
  return TwoObjectives(search, options).run();
}

}  // namespace twum::inline v0_1::optim
