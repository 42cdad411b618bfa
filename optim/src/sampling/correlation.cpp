// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/correlation.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <string>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What is left of the variance of an input whose others are given. Less would make its number follow from theirs.
constexpr double kLeast = 1e-10;

MatrixXd matrix_of(std::size_t inputs, std::span<const CorrelatedPair> pairs) {
  MatrixXd matrix = MatrixXd::Identity(static_cast<Index>(inputs), static_cast<Index>(inputs));
  for (const CorrelatedPair& pair : pairs) {
    const auto a = static_cast<Index>(pair.a), b = static_cast<Index>(pair.b);
    matrix(a, b) = matrix(b, a) = pair.coefficient;
  }
  return matrix;
}

// The first input whose number the others would determine or contradict; the number of inputs if there is none.
std::size_t first_impossible(const MatrixXd& matrix) {
  for (Index k = 0; k < matrix.rows(); ++k) {
    const Eigen::LLT<MatrixXd> part(matrix.topLeftCorner(k + 1, k + 1));
    const bool possible =
        part.info() == Eigen::Success && part.matrixLLT()(k, k) * part.matrixLLT()(k, k) > kLeast;
    if (!possible) return static_cast<std::size_t>(k);
  }
  return static_cast<std::size_t>(matrix.rows());
}

bool same(const CorrelatedPair& one, const CorrelatedPair& other) {
  return (one.a == other.a && one.b == other.b) || (one.a == other.b && one.b == other.a);
}

Eigen::Map<const VectorXd> vector_of(std::span<const double> v) {
  return {v.data(), static_cast<Index>(v.size())};
}

std::vector<double> numbers_of(const VectorXd& v) { return {v.begin(), v.end()}; }

// L as it is kept.
auto lower(const std::vector<double>& factor, std::size_t inputs) {
  const auto n = static_cast<Index>(inputs);
  return Eigen::Map<const MatrixXd>(factor.data(), n, n);
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
  const std::size_t failed = first_impossible(matrix_of(inputs, pairs));
  for (std::size_t i = pairs.size(); i-- > 0;)
    if (std::max(pairs[i].a, pairs[i].b) == failed) return i;
  return {};
}

Correlation::Correlation(std::size_t inputs, std::span<const CorrelatedPair> pairs)
    : inputs_(inputs) {
  if (const auto wrong = wrong_pair(inputs, pairs))
    throw InputError("the correlation of the inputs " + std::to_string(pairs[*wrong].a) + " and " +
                     std::to_string(pairs[*wrong].b) + " contradicts the others");
  if (pairs.empty()) return;
  const MatrixXd L = matrix_of(inputs, pairs).llt().matrixL();
  factor_.assign(L.data(), L.data() + L.size());
}

std::vector<double> Correlation::correlated(std::vector<double> z) const {
  if (independent()) return z;
  return numbers_of(lower(factor_, inputs_) * vector_of(z));
}

std::vector<double> Correlation::slopes(std::vector<double> g) const {
  if (independent()) return g;
  return numbers_of(lower(factor_, inputs_).transpose() * vector_of(g));
}

std::vector<double> Correlation::parts(std::span<const double> z) const {
  const auto numbers = vector_of(z);
  if (independent()) return numbers_of(numbers.cwiseAbs2());
  const auto L = lower(factor_, inputs_);
  const VectorXd solved = L.triangularView<Eigen::Lower>().transpose().solve(numbers);
  return numbers_of((L * numbers).cwiseProduct(solved));
}

}  // namespace twum::inline v0_1::optim
