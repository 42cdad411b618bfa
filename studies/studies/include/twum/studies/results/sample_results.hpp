// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/curve_result.hpp>        // IWYU pragma: export
#include <twum/studies/results/frequency_result.hpp>    // IWYU pragma: export
#include <twum/studies/results/sensitivity_result.hpp>  // IWYU pragma: export
#include <twum/studies/results/sweep_result.hpp>        // IWYU pragma: export
#include <twum/studies/results/uncertainty_result.hpp>  // IWYU pragma: export
