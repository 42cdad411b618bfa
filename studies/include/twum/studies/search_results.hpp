// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/calibrate_result.hpp>  // IWYU pragma: export
#include <twum/studies/optimize_result.hpp>   // IWYU pragma: export
#include <twum/studies/pareto_result.hpp>     // IWYU pragma: export
