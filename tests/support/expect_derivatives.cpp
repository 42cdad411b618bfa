// SPDX-License-Identifier: Apache-2.0
#include "support/expect_derivatives.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace twum::test {
namespace {

constexpr std::size_t kRows = 8;
constexpr double kShrink = 1.6;
using Quotients = std::array<double, kRows>;

// `order` is the power of the step by which neighbouring columns differ.
DifferenceQuotient extrapolate(const Quotients& quotients, int order) {
  std::array<Quotients, kRows> table{};
  DifferenceQuotient best;
  for (std::size_t i = 0; i < kRows; ++i) {
    table[i][0] = quotients[i];
    for (std::size_t j = 1; j <= i; ++j) {
      const double factor = std::pow(kShrink, order * static_cast<int>(j));
      const double left = table[i][j - 1];
      const double up = table[i - 1][j - 1];
      table[i][j] = (left * factor - up) / (factor - 1);
      const double error = std::max(std::abs(table[i][j] - left), std::abs(table[i][j] - up));
      if (error < best.error) best = {table[i][j], error};
    }
  }
  return best;
}

// quotients(step) gives one quotient for each function
template <typename QuotientsOf>
void try_first_step(std::vector<DifferenceQuotient>& best, QuotientsOf quotients, double step,
                    int order) {
  std::vector<Quotients> rows;
  for (std::size_t i = 0; i < kRows; ++i) {
    const std::vector<double> found = quotients(step * std::pow(kShrink, -static_cast<double>(i)));
    rows.resize(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) rows[k][i] = found[k];
  }
  best.resize(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const DifferenceQuotient found = extrapolate(rows[k], order);
    if (found.error < best[k].error) best[k] = found;
  }
}

std::vector<double> quotients_of(const std::vector<double>& high, const std::vector<double>& low,
                                 double distance) {
  std::vector<double> quotients(high.size());
  for (std::size_t k = 0; k < high.size(); ++k) quotients[k] = (high[k] - low[k]) / distance;
  return quotients;
}

}  // namespace

std::vector<DifferenceQuotient> central_differences(const Functions& functions, double x,
                                                    double scale) {
  std::vector<DifferenceQuotient> best;
  const auto quotients = [&](double h) {
    return quotients_of(functions(x + h), functions(x - h), 2 * h);
  };
  for (const double first : {3e-2, 3e-3, 3e-4}) try_first_step(best, quotients, first * scale, 2);
  return best;
}

std::vector<DifferenceQuotient> one_sided_differences(const Functions& functions, double x,
                                                      double scale, int side) {
  std::vector<DifferenceQuotient> best;
  const std::vector<double> here = functions(x);
  const auto quotients = [&](double h) {
    return quotients_of(functions(x + side * h), here, side * h);
  };
  for (const double first : {1e-2, 1e-3, 1e-4}) try_first_step(best, quotients, first * scale, 1);
  return best;
}

}  // namespace twum::test
