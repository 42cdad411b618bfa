// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/hypervolume.hpp>

#include <algorithm>
#include <numeric>

namespace twum::inline v0_1::optim {
namespace {

using Points = std::vector<std::vector<double>>;

void check_sizes(const Points& points, std::size_t dimension) {
  if (dimension != 2 && dimension != 3)
    throw InputError("hypervolume: there are " + std::to_string(dimension) +
                     " objectives; 2 or 3 are possible");
  for (const auto& p : points)
    if (p.size() != dimension)
      throw InputError("hypervolume: a point and the reference differ in size");
}

Points inside(const Points& points, const std::vector<double>& reference) {
  Points kept;
  for (const auto& p : points) {
    bool all = true;
    for (std::size_t k = 0; k < p.size(); ++k) all = all && p[k] < reference[k];
    if (all) kept.push_back(p);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

// Area under a staircase; points sorted by the first objective.
double area(const Points& sorted, double right, double top) {
  double sum = 0.0;
  for (const auto& p : sorted) {
    if (p[1] >= top) continue;
    sum += (right - p[0]) * (top - p[1]);
    top = p[1];
  }
  return sum;
}

// Slices along the third objective: between two levels the section is the staircase of all points
// at or below the lower one.
double volume(Points points, const std::vector<double>& reference) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a[2] < b[2]; });
  double sum = 0.0;
  Points section;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = std::upper_bound(section.begin(), section.end(), points[i]);
    section.insert(at, points[i]);
    const double next = i + 1 < points.size() ? points[i + 1][2] : reference[2];
    if (next > points[i][2])
      sum += (next - points[i][2]) * area(section, reference[0], reference[1]);
  }
  return sum;
}

}  // namespace

double hypervolume(const Points& points, const std::vector<double>& reference) {
  check_sizes(points, reference.size());
  const Points kept = inside(points, reference);
  return reference.size() == 2 ? area(kept, reference[0], reference[1]) : volume(kept, reference);
}

bool dominates(const std::vector<double>& a, const std::vector<double>& b) {
  bool better = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] > b[k]) return false;
    better = better || a[k] < b[k];
  }
  return better;
}

std::vector<std::size_t> nondominated(const Points& points) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool stays = true;
    for (std::size_t j = 0; j < points.size() && stays; ++j)
      stays = !(dominates(points[j], points[i]) || (j < i && points[j] == points[i]));
    if (stays) kept.push_back(i);
  }
  return kept;
}

// best[c][j]: largest area with c + 1 points of which j is the last (rightmost), counted up to the
// reference on the right of j only when j is the last of all. Adding point j to the right of i adds
// the rectangle right of j between their heights: (right - x_j) (y_i - y_j).
std::vector<std::size_t> best_subset(const Points& front, std::size_t count,
                                     const std::vector<double>& reference) {
  const std::size_t m = front.size();
  std::vector<std::size_t> order(m);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return front[a] < front[b]; });
  if (m <= count || count < 2) return order;
  const auto x = [&](std::size_t j) { return std::min(front[order[j]][0], reference[0]); };
  const auto y = [&](std::size_t j) { return std::min(front[order[j]][1], reference[1]); };
  std::vector<std::vector<double>> best(count, std::vector<double>(m, -1.0));
  std::vector<std::vector<std::size_t>> from(count, std::vector<std::size_t>(m, 0));
  best[0][0] = (reference[0] - x(0)) * (reference[1] - y(0));
  for (std::size_t c = 1; c < count; ++c) {
    for (std::size_t j = c; j < m; ++j) {
      for (std::size_t i = c - 1; i < j; ++i) {
        if (best[c - 1][i] < 0.0) continue;
        const double sum = best[c - 1][i] + (reference[0] - x(j)) * std::max(y(i) - y(j), 0.0);
        if (sum > best[c][j]) {
          best[c][j] = sum;
          from[c][j] = i;
        }
      }
    }
  }
  std::vector<std::size_t> chosen(count);
  std::size_t j = m - 1;
  for (std::size_t c = count; c-- > 0;) {
    chosen[c] = order[j];
    j = from[c][j];
  }
  return chosen;
}

// A point's gain only shrinks as others are chosen, so an old gain is a bound: only the candidates
// at the top need to be looked at again.
std::vector<std::size_t> greedy_subset(const Points& front, std::size_t count,
                                       const std::vector<double>& reference) {
  std::vector<std::pair<double, std::size_t>> bounds;
  for (std::size_t i = 0; i < front.size(); ++i)
    bounds.emplace_back(hypervolume({front[i]}, reference), i);
  Points chosen;
  std::vector<std::size_t> order;
  double total = 0.0;
  while (order.size() < std::min(count, front.size())) {
    std::sort(bounds.begin(), bounds.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    double best = -1.0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < bounds.size() && bounds[i].first > best; ++i) {
      chosen.push_back(front[bounds[i].second]);
      bounds[i].first = hypervolume(chosen, reference) - total;
      chosen.pop_back();
      if (bounds[i].first <= best) continue;
      best = bounds[i].first;
      at = i;
    }
    total += best;
    chosen.push_back(front[bounds[at].second]);
    order.push_back(bounds[at].second);
    bounds.erase(bounds.begin() + static_cast<std::ptrdiff_t>(at));
  }
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace twum::inline v0_1::optim
