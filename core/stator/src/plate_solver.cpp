// SPDX-License-Identifier: Apache-2.0
#include "plate_solver.hpp"

#include <twum/base/error.hpp>

#include <Spectra/LinAlg/BKLDLT.h>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsSolver.h>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <limits>

namespace twum::inline v0_1::stator {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Eigenvalues mu below this share of the largest are rounding: modes of very narrow rings, whose frequencies
// are some 1e7 times the lowest. They are left out; no other mode feels them.
constexpr double kUnknown = 1e-15;

// Functions of elements that do not touch have no common entry, which leaves most of them zero.
struct Matrices {  // their lower halves
  Eigen::SparseMatrix<double> stiffness;
  Eigen::SparseMatrix<double> mass;
};

// Factors L L' for Lanczos' method. Elements are numbered from the inner edge outwards, which leaves few entries to fill;
// Spectra's own class seeks a better order for longer than the factors take.
class Cholesky {
 public:
  using Scalar = double;

  explicit Cholesky(const Eigen::SparseMatrix<double>& matrix)
      : size_(matrix.rows()), factors_(matrix) {
    TWUM_ASSERT(factors_.info() == Eigen::Success);
  }
  Index rows() const { return size_; }
  Index cols() const { return size_; }
  void lower_triangular_solve(const double* x, double* y) const { solve(factors_.matrixL(), x, y); }
  void upper_triangular_solve(const double* x, double* y) const { solve(factors_.matrixU(), x, y); }

 private:
  template <typename Factor>
  void solve(const Factor& factor, const double* x, double* y) const {
    Eigen::Map<VectorXd> answer(y, size_);
    answer = Eigen::Map<const VectorXd>(x, size_);
    factor.solveInPlace(answer);
  }

  Index size_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
      factors_;
};

// Of Lanczos' method: vectors beyond three for each mode, which rarely need a restart; restarts; and the residual that is left, in
// parts of the eigenvalue. An eigenvalue is good to the square of it, a vector to it over the gap to the next eigenvalue.
constexpr Index kSpare = 8;
constexpr Index kRestarts = 1000;
constexpr double kConverged = 1e-14;

// Derivatives of the fields: those of field f begin at f * kOrders.
constexpr Index kOrders = 3;
constexpr Index kDerivatives = 3 * kOrders;

// Rows of linear forms in the derivatives of the fields with respect to the place in an element, from -1 to 1.
template <int Rows>
Eigen::Matrix<double, Rows, kDerivatives> linear_forms(const std::vector<Term<double>>& terms,
                                                       double half) {
  Eigen::Matrix<double, Rows, kDerivatives> forms;
  forms.setZero();
  for (const Term<double>& term : terms) {
    const auto derivative =
        static_cast<Index>(term.field) * kOrders + static_cast<Index>(term.order);
    forms(static_cast<Index>(term.row), derivative) +=
        term.factor / std::pow(half, static_cast<double>(term.order));
  }
  return forms;
}

// The stress resultants of unit strains.
Eigen::Matrix<double, 5, 5> elasticity(const Section& section) {
  Eigen::Matrix<double, 5, 5> matrix;
  for (Index column = 0; column < 5; ++column) {
    std::array<double, 5> unit{};
    unit[static_cast<std::size_t>(column)] = 1;
    const auto stress = stresses(section, unit);
    matrix.col(column) = Eigen::Map<const Eigen::Matrix<double, 5, 1>>(stress.data());
  }
  return matrix;
}

// Energies at a Gauss point, as quadratic forms in the derivatives of the fields.
struct Energies {
  Eigen::Matrix<double, kDerivatives, kDerivatives> strain, motion;
};

Energies energies_at(const Mesh& mesh, const Element& element, const std::vector<Segment>& segments,
                     std::size_t q) {
  const Section& section = segments[element.segment].section;
  const Eigen::Vector3d inertia(section.mass, section.rotary_inertia, section.rotary_inertia);
  const auto at = plate_point(mesh, element, segments, q);
  const auto strains =
      linear_forms<5>(strain_terms(mesh.theory, mesh.nodal_diameters, at.radius), at.half);
  const auto motions =
      linear_forms<3>(motion_terms(mesh.theory, mesh.nodal_diameters, at.radius), at.half);
  return {at.weight * strains.transpose() * elasticity(section) * strains,
          at.weight * motions.transpose() * inertia.asDiagonal() * motions};
}

// Derivatives of an element's functions at its Gauss points, one after another in rows.
std::array<MatrixXd, kOrders> functions_of(const Element& element, double half) {
  const Basis& basis = element.table->basis;
  const auto points = static_cast<Index>(element.table->points.size());
  std::array<MatrixXd, kOrders> functions;
  for (std::size_t order = 0; order < orders(element); ++order) {
    MatrixXd& values = functions[order];
    values.resize(points, basis.size());
    for (Index q = 0; q < points; ++q)
      for (Index i = 0; i < basis.size(); ++i)
        values(q, i) =
            element.table->values[order][static_cast<std::size_t>(q)][static_cast<std::size_t>(i)] *
            (basis.is_slope(static_cast<int>(i)) ? half : 1);
  }
  return functions;
}

// What an element adds to a matrix for two of its fields: the sum over their derivatives o, p of V_o' D V_p, D the quadratic form
// at the Gauss points. Empty where that is zero, as in most cases.
template <typename Form>
MatrixXd added(const std::array<MatrixXd, kOrders>& functions, Index field, Index other,
               Form form) {
  const Index points = functions[0].rows();
  MatrixXd block;
  for (Index o = 0; o < kOrders; ++o) {
    for (Index p = 0; p < kOrders; ++p) {
      VectorXd density(points);
      for (Index q = 0; q < points; ++q)
        density(q) = form(q)(field * kOrders + o, other * kOrders + p);
      if (density.isZero(0)) continue;
      if (block.size() == 0) block = MatrixXd::Zero(functions[0].cols(), functions[0].cols());
      block += functions[static_cast<std::size_t>(o)].transpose().lazyProduct(
          density.asDiagonal() * functions[static_cast<std::size_t>(p)]);
    }
  }
  return block;
}

// The lower half of a matrix.
template <typename Form>
void add(std::vector<Eigen::Triplet<double>>& entries, const Element& element,
         const std::array<MatrixXd, kOrders>& functions, Form form) {
  for (std::size_t f = 0; f < element.dofs.size(); ++f) {
    for (std::size_t g = 0; g <= f; ++g) {
      const MatrixXd block = added(functions, static_cast<Index>(f), static_cast<Index>(g), form);
      const auto& rows = element.dofs[f];
      const auto& columns = element.dofs[g];
      for (Index i = 0; i < block.rows(); ++i) {
        const int row = rows[static_cast<std::size_t>(i)];
        for (Index j = 0; j < (f == g ? i + 1 : block.cols()); ++j) {
          const int column = columns[static_cast<std::size_t>(j)];
          if (row >= 0 && column >= 0)
            entries.emplace_back(std::max(row, column), std::min(row, column), block(i, j));
        }
      }
    }
  }
}

Matrices assembled(const Mesh& mesh, const std::vector<Segment>& segments) {
  std::vector<Eigen::Triplet<double>> stiffness, mass;
  for (const Element& element : mesh.elements) {
    std::vector<Energies> energies;
    for (std::size_t q = 0; q < element.table->points.size(); ++q)
      energies.push_back(energies_at(mesh, element, segments, q));
    const auto functions = functions_of(element, plate_point(mesh, element, segments, 0).half);
    const auto at = [&](Index q) -> const Energies& {
      return energies[static_cast<std::size_t>(q)];
    };
    add(
        stiffness, element, functions, [&](Index q) -> auto& { return at(q).strain; });
    add(
        mass, element, functions, [&](Index q) -> auto& { return at(q).motion; });
  }
  Matrices plate{Eigen::SparseMatrix<double>(mesh.unknowns, mesh.unknowns),
                 Eigen::SparseMatrix<double>(mesh.unknowns, mesh.unknowns)};
  plate.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  plate.mass.setFromTriplets(mass.begin(), mass.end());
  return plate;
}

}  // namespace

double unit_eigenvalue(const std::vector<Segment>& segments) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Segment& segment : segments) {
    smallest = std::min(smallest, segment.section.bending_stiffness / segment.section.mass);
  }
  return smallest / std::pow(segments.back().outer, 4);
}

// (P3.4). mu = sigma / (lambda + sigma) has no unit. Rounding is a share of the largest mu, so that the lowest modes are the
// most accurate ones, and rigid-body modes, mu = 1, do no harm.
Spectrum solve(const Mesh& mesh, const std::vector<Segment>& segments, int count) {
  using Spectra::SparseSymMatProd;
  const Matrices plate = assembled(mesh, segments);
  const double sigma = unit_eigenvalue(segments);
  const Eigen::SparseMatrix<double> scaled_mass = sigma * plate.mass;
  const Eigen::SparseMatrix<double> shifted = plate.stiffness + scaled_mass;
  SparseSymMatProd<double> mass(scaled_mass);
  Cholesky stiffness(shifted);
  const Index wanted = std::min<Index>(count, mesh.unknowns - 1);
  Spectra::SymGEigsSolver<SparseSymMatProd<double>, Cholesky, Spectra::GEigsMode::Cholesky> solver(
      mass, stiffness, wanted, std::min<Index>(mesh.unknowns, 3 * wanted + kSpare));
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge, kRestarts, kConverged);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw EvaluationError("not-converged",
                          "the modes of the stator with " + std::to_string(mesh.nodal_diameters) +
                              " nodal diameters were not found: Lanczos' method did not converge");
  const VectorXd mu = solver.eigenvalues();
  const MatrixXd vectors = solver.eigenvectors();
  Spectrum spectrum;
  for (Index i = 0; i < mu.size() && mu(i) >= kUnknown * mu(0); ++i) {
    const VectorXd vector = vectors.col(i) * std::sqrt(sigma / mu(i));
    spectrum.eigenvalues.push_back(sigma * (1 - mu(i)) / mu(i));
    spectrum.vectors.emplace_back(vector.begin(), vector.end());
  }
  return spectrum;
}

// Bordered by c' M x, the system has one solution.
std::vector<std::vector<double>> answers_beside_mode(const Mesh& mesh,
                                                     const std::vector<Segment>& segments,
                                                     const std::vector<double>& mode,
                                                     double eigenvalue,
                                                     const std::vector<ModeLoad>& loads) {
  const Matrices plate = assembled(mesh, segments);
  const Index n = mesh.unknowns;
  const VectorXd momentum =
      plate.mass.selfadjointView<Eigen::Lower>() * Eigen::Map<const VectorXd>(mode.data(), n);
  MatrixXd system = MatrixXd::Zero(n + 1, n + 1);
  system.topLeftCorner(n, n) = plate.stiffness - eigenvalue * plate.mass;  // the lower half is read
  system.bottomLeftCorner(1, n) = momentum.transpose();
  const Spectra::BKLDLT<double> factors(system);
  std::vector<std::vector<double>> answers;
  for (const ModeLoad& load : loads) {
    VectorXd right(n + 1);
    right << Eigen::Map<const VectorXd>(load.force.data(), n), load.share;
    factors.solve_inplace(right);
    answers.emplace_back(right.begin(), right.end() - 1);
  }
  return answers;
}

}  // namespace twum::inline v0_1::stator
