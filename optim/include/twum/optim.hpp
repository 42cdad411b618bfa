// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Everything of twum::optim: problems, solvers, certificates, fronts, least squares.

/// @namespace twum::optim
/// Optimization without motors: problems in user units, solvers, certificates, fronts, least squares.
///
/// The rules of namespace twum on threads and errors hold here. A solve calls the given evaluator and passes its
/// exceptions on. Several solves may run at once, and an evaluator may itself solve. One at a time computes within Ipopt.

#include <twum/base/error.hpp>
#include <twum/base/same_containers.hpp>
#include <twum/base/version.hpp>
#include <twum/optim/certificate.hpp>
#include <twum/optim/certify.hpp>
#include <twum/optim/check_derivatives.hpp>
#include <twum/optim/correlation.hpp>
#include <twum/optim/distributions.hpp>
#include <twum/optim/estimate.hpp>
#include <twum/optim/failure_shares.hpp>
#include <twum/optim/fit_band.hpp>
#include <twum/optim/fit_moves.hpp>
#include <twum/optim/fit_profile.hpp>
#include <twum/optim/group_deviations.hpp>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/latin_hypercube.hpp>
#include <twum/optim/least_squares.hpp>
#include <twum/optim/library_versions.hpp>
#include <twum/optim/lost_rank.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/measured_rows.hpp>
#include <twum/optim/neighbour_test.hpp>
#include <twum/optim/offset_test.hpp>
#include <twum/optim/optimum_moves.hpp>
#include <twum/optim/options.hpp>
#include <twum/optim/outliers.hpp>
#include <twum/optim/own_solver.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/problem.hpp>
#include <twum/optim/random.hpp>
#include <twum/optim/random_input.hpp>
#include <twum/optim/reliability.hpp>
#include <twum/optim/replicates.hpp>
#include <twum/optim/result.hpp>
#include <twum/optim/robust.hpp>
#include <twum/optim/robust_front.hpp>
#include <twum/optim/robust_problem.hpp>
#include <twum/optim/sample_moments.hpp>
#include <twum/optim/sample_quantiles.hpp>
#include <twum/optim/scan.hpp>
#include <twum/optim/scrambled_sobol.hpp>
#include <twum/optim/serial_errors.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solver_process.hpp>
#include <twum/optim/solvers.hpp>
#include <twum/optim/yield_estimate.hpp>
