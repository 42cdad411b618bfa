// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/calibrate_result.hpp>  // IWYU pragma: export
#include <twum/studies/results/optimize_result.hpp>   // IWYU pragma: export
#include <twum/studies/results/pareto_result.hpp>     // IWYU pragma: export
