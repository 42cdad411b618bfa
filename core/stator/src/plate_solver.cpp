// SPDX-License-Identifier: Apache-2.0
#include "plate_solver.hpp"

#include <twum/base/error.hpp>

#include <Spectra/LinAlg/BKLDLT.h>
#include <Spectra/MatOp/DenseCholesky.h>
#include <Spectra/MatOp/DenseSymMatProd.h>
#include <Spectra/SymGEigsSolver.h>

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

struct Matrices {
  MatrixXd stiffness;
  MatrixXd mass;
};

// Of Lanczos' method: vectors beyond those of twice the modes, restarts, and what is left of a residual in parts of the
// eigenvalue. An eigenvalue is good to the square of it, a vector to it over the gap to the next eigenvalue.
constexpr Index kSpare = 20;
constexpr Index kRestarts = 1000;
constexpr double kConverged = 1e-14;

template <int Rows>
using Forms = Eigen::Matrix<double, Rows, Eigen::Dynamic>;

// Linear forms in the functions of an element at a Gauss point, field after field.
template <int Rows>
Forms<Rows> forms_at(const Element& element, std::size_t q, double half,
                     const std::vector<Term<double>>& terms) {
  const Basis& basis = element.table->basis;
  const auto functions = static_cast<Index>(basis.size());
  Forms<Rows> matrix = Forms<Rows>::Zero(Rows, functions * static_cast<Index>(element.dofs.size()));
  for (const Term<double>& term : terms) {
    const auto& shapes = element.table->values[term.order][q];
    const double scale = term.factor / std::pow(half, static_cast<double>(term.order));
    for (Index i = 0; i < functions; ++i) {
      const double slope = basis.is_slope(static_cast<int>(i)) ? half : 1;
      matrix(static_cast<Index>(term.row), static_cast<Index>(term.field) * functions + i) +=
          scale * slope * shapes[static_cast<std::size_t>(i)];
    }
  }
  return matrix;
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

Matrices element_matrices(const Mesh& mesh, const Element& element,
                          const std::vector<Segment>& segments) {
  const Section& section = segments[element.segment].section;
  const auto size = static_cast<Index>(element.dofs.size()) * element.table->basis.size();
  const auto points = static_cast<Index>(element.table->points.size());
  const Eigen::Matrix<double, 5, 5> elastic = elasticity(section);
  const Eigen::Vector3d inertia(section.mass, section.rotary_inertia, section.rotary_inertia);
  MatrixXd strains(5 * points, size), stresses(5 * points, size);  // of all points
  MatrixXd motions(3 * points, size), momenta(3 * points, size);
  for (Index q = 0; q < points; ++q) {
    const auto number = static_cast<std::size_t>(q);
    const auto at = plate_point(mesh, element, segments, number);
    const auto strain = forms_at<5>(element, number, at.half,
                                    strain_terms(mesh.theory, mesh.nodal_diameters, at.radius));
    const auto motion = forms_at<3>(element, number, at.half,
                                    motion_terms(mesh.theory, mesh.nodal_diameters, at.radius));
    strains.middleRows<5>(5 * q) = strain;
    stresses.middleRows<5>(5 * q) = at.weight * elastic.lazyProduct(strain);
    motions.middleRows<3>(3 * q) = motion;
    momenta.middleRows<3>(3 * q) = at.weight * inertia.asDiagonal() * motion;
  }
  // A blocked product takes more code than matrices of this size are worth.
  return {strains.transpose().lazyProduct(stresses), motions.transpose().lazyProduct(momenta)};
}

Matrices assembled(const Mesh& mesh, const std::vector<Segment>& segments) {
  Matrices plate{MatrixXd::Zero(mesh.unknowns, mesh.unknowns),
                 MatrixXd::Zero(mesh.unknowns, mesh.unknowns)};
  for (const Element& element : mesh.elements) {
    const Matrices own = element_matrices(mesh, element, segments);
    std::vector<Index> places;
    for (const auto& field : element.dofs) places.insert(places.end(), field.begin(), field.end());
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = 0; j < places.size(); ++j) {
        if (places[i] < 0 || places[j] < 0) continue;
        const auto row = static_cast<Index>(i);
        const auto column = static_cast<Index>(j);
        plate.stiffness(places[i], places[j]) += own.stiffness(row, column);
        plate.mass(places[i], places[j]) += own.mass(row, column);
      }
    }
  }
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
  using Spectra::DenseCholesky;
  using Spectra::DenseSymMatProd;
  const Matrices plate = assembled(mesh, segments);
  const double sigma = unit_eigenvalue(segments);
  const MatrixXd scaled_mass = sigma * plate.mass;
  const MatrixXd shifted = plate.stiffness + scaled_mass;
  DenseSymMatProd<double> mass(scaled_mass);
  DenseCholesky<double> stiffness(shifted);
  TWUM_ASSERT(stiffness.info() == Spectra::CompInfo::Successful);
  const Index wanted = std::min<Index>(count, mesh.unknowns - 1);
  Spectra::SymGEigsSolver<DenseSymMatProd<double>, DenseCholesky<double>,
                          Spectra::GEigsMode::Cholesky>
      solver(mass, stiffness, wanted, std::min<Index>(mesh.unknowns, 2 * wanted + kSpare));
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
  const VectorXd momentum = plate.mass * Eigen::Map<const VectorXd>(mode.data(), n);
  MatrixXd system = MatrixXd::Zero(n + 1, n + 1);
  system.topLeftCorner(n, n) = plate.stiffness - eigenvalue * plate.mass;
  system.bottomLeftCorner(1, n) =
      momentum.transpose();  // of a symmetric matrix the half below is read
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
