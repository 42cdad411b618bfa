// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/curve_result.hpp>        // IWYU pragma: export
#include <twum/studies/frequency_result.hpp>    // IWYU pragma: export
#include <twum/studies/heat_result.hpp>         // IWYU pragma: export
#include <twum/studies/life_result.hpp>         // IWYU pragma: export
#include <twum/studies/map_result.hpp>          // IWYU pragma: export
#include <twum/studies/motion_result.hpp>       // IWYU pragma: export
#include <twum/studies/sensitivity_result.hpp>  // IWYU pragma: export
#include <twum/studies/sweep_result.hpp>        // IWYU pragma: export
#include <twum/studies/uncertainty_result.hpp>  // IWYU pragma: export
