// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/low_discrepancy.hpp>

#include "fronts/front_search.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

// Directions (i, j, h - i - j) / h, ordered such that neighbours follow each other. Zero entries are replaced by
// small ones, since they would force their objective exactly to the ideal.
std::vector<std::vector<double>> lattice(std::size_t points) {
  constexpr double kRoom = 1e-6;
  std::size_t h = 1;
  while ((h + 1) * (h + 2) / 2 < points) ++h;
  std::vector<std::vector<double>> directions;
  for (std::size_t i = 0; i <= h; ++i) {
    for (std::size_t step = 0; step <= h - i; ++step) {
      const std::size_t j = i % 2 == 0 ? step : h - i - step;
      std::vector<double> d;
      for (const std::size_t part : {i, j, h - i - j})
        d.push_back(std::max(static_cast<double>(part) / static_cast<double>(h), kRoom));
      directions.push_back(std::move(d));
    }
  }
  return directions;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

std::vector<double> direction_of(const Solved& s) {
  std::vector<double> d;
  double sum = 1e-12;
  for (const double y : s.y) sum += std::max(y, 0.0);
  for (const double y : s.y) d.push_back(std::max(y, 0.0) / sum);
  return d;
}

const Solved& nearest(const std::vector<Solved>& known, const std::vector<double>& direction) {
  return *std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return distance(direction_of(a), direction) < distance(direction_of(b), direction);
  });
}

}  // namespace

std::vector<Solved> three_objective_front(FrontSearch& search, const ParetoOptions& options) {
  std::vector<Solved> known = search.ends();
  // More candidates than points: the best of them are chosen by hypervolume.
  const auto directions = lattice(5 * options.points / 2);
  const std::size_t n = search.runner().scaling().size();
  if (n == 0) return {known.front()};
  const auto far =
      sobol_points(n, options.coarse * options.coarse_starts + 1, options.solve.seed + 7);
  const std::size_t stride =
      std::max<std::size_t>(1, directions.size() / std::max<std::size_t>(options.coarse, 1));
  std::size_t used = 1;
  for (std::size_t i = 0; i < directions.size() && !search.exhausted(); ++i) {
    std::vector<std::vector<double>> starts{nearest(known, directions[i]).unit};
    if (auto pooled = search.from_pool(directions[i]); !pooled.empty())
      starts.push_back(std::move(pooled));
    const bool coarse = i % stride == stride / 2;
    for (std::size_t s = 0; coarse && s < options.coarse_starts && used < far.size(); ++s)
      starts.push_back(far[used++]);
    auto found = search.scalarize({0.0, 0.0, 0.0}, directions[i], starts, coarse);
    if (found) known.push_back(std::move(*found));
  }
  std::vector<std::vector<double>> values;
  for (const auto& s : known) values.push_back(s.y);
  std::vector<Solved> front;
  for (const std::size_t i : nondominated(values)) front.push_back(known[i]);
  std::sort(front.begin(), front.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  return front;
}

}  // namespace twum::inline v0_1::optim
