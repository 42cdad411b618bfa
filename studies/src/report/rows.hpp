// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/core/motor_design.hpp>
#include <twum/io/result_store.hpp>

/// Stored evaluations for the page; internal.
namespace twum::inline v0_1::studies {

/// At most 100,000 rows: where there are more, one of each "every" of the "total", which one by
/// "offsets": {"count", "every", "offsets": base64 of the place of each row among its "every",
/// empty where all are there, "total", "columns", "values": base64 of each column, "statuses":
/// words, "status": base64 of which, "densities": densities_json() where some are left out, else null}.
Json rows_json(const ResultStore& store);

/// Two-dimensional histograms of all rows, for pictures of more rows than a page holds: {"cells": n along either
/// side, "ranges": [[lowest, highest] of each column], "counts": {"i,j": base64 of n * n counts of the columns i < j,
/// that of i slower}}. A row without a number in one of two columns is not counted for them; a column of one value
/// has no counts.
Json densities_json(const ResultStore& store);

/// Small torque-speed curves of these rows, of every k-th one where there are many: {"every",
/// "points", "speed": last speeds, "torque": largest torques, "shape": shares of it}.
Json row_curves_json(const ResultStore& store, const MotorDesign& base);

}  // namespace twum::inline v0_1::studies
