// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/correlation.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace twum::optim {
namespace {

// What is left of the variance of an input whose others are given. Less would make its number follow from theirs.
constexpr double kLeast = 1e-10;

struct Factor {
  std::vector<double> rows;  // L, row by row
  std::size_t failed;        // the first row that cannot be; the number of rows if there is none
};

Factor factor_of(std::size_t n, std::vector<double> matrix) {
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix[i * n + j];
      for (std::size_t k = 0; k < j; ++k) rest -= matrix[i * n + k] * matrix[j * n + k];
      if (i == j && !(rest > kLeast)) return {{}, i};
      matrix[i * n + j] = i == j ? std::sqrt(rest) : rest / matrix[j * n + j];
    }
  return {std::move(matrix), n};
}

std::vector<double> matrix_of(std::size_t n, std::span<const CorrelatedPair> pairs) {
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 1.0;
  for (const CorrelatedPair& pair : pairs)
    matrix[pair.a * n + pair.b] = matrix[pair.b * n + pair.a] = pair.coefficient;
  return matrix;
}

bool same(const CorrelatedPair& one, const CorrelatedPair& other) {
  return (one.a == other.a && one.b == other.b) || (one.a == other.b && one.b == other.a);
}

}  // namespace

std::optional<std::size_t> Correlation::wrong_pair(std::size_t inputs,
                                                   std::span<const CorrelatedPair> pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const CorrelatedPair& pair = pairs[i];
    bool wrong = pair.a >= inputs || pair.b >= inputs || pair.a == pair.b;
    for (std::size_t j = 0; j < i; ++j) wrong = wrong || same(pair, pairs[j]);
    if (wrong) return i;
  }
  const std::size_t failed = factor_of(inputs, matrix_of(inputs, pairs)).failed;
  for (std::size_t i = pairs.size(); i-- > 0;)
    if (failed < inputs && std::max(pairs[i].a, pairs[i].b) == failed) return i;
  return {};
}

Correlation::Correlation(std::size_t inputs, std::span<const CorrelatedPair> pairs)
    : inputs_(inputs) {
  if (const auto wrong = wrong_pair(inputs, pairs))
    throw InputError("the correlation of the inputs " + std::to_string(pairs[*wrong].a) + " and " +
                     std::to_string(pairs[*wrong].b) + " contradicts the others");
  if (!pairs.empty()) factor_ = factor_of(inputs, matrix_of(inputs, pairs)).rows;
}

std::vector<double> Correlation::correlated(std::vector<double> z) const {
  if (independent()) return z;
  for (std::size_t i = inputs_; i-- > 0;) {  // from the last: those before it are still z
    double y = 0;
    for (std::size_t k = 0; k <= i; ++k) y += factor_[i * inputs_ + k] * z[k];
    z[i] = y;
  }
  return z;
}

std::vector<double> Correlation::slopes(std::vector<double> g) const {
  if (independent()) return g;
  for (std::size_t k = 0; k < inputs_; ++k) {
    double slope = 0;
    for (std::size_t i = k; i < inputs_; ++i) slope += factor_[i * inputs_ + k] * g[i];
    g[k] = slope;
  }
  return g;
}

std::vector<double> Correlation::parts(std::span<const double> z) const {
  std::vector<double> solved(z.begin(), z.end());  // L^T solved = z
  if (!independent())
    for (std::size_t k = inputs_; k-- > 0;) {
      for (std::size_t i = k + 1; i < inputs_; ++i)
        solved[k] -= factor_[i * inputs_ + k] * solved[i];
      solved[k] /= factor_[k * inputs_ + k];
    }
  std::vector<double> parts = correlated({z.begin(), z.end()});
  for (std::size_t k = 0; k < parts.size(); ++k) parts[k] *= solved[k];
  return parts;
}

}  // namespace twum::optim
