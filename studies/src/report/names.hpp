// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

/// What names in a result mean, so that the page does not have to parse texts; internal.
namespace twum::inline v0_1::studies {

/// {name: {"text": as one reads it}} of every parameter, metric and column; of a metric at a point also {"metric"}.
Json names_json(const Json& columns);

/// {reason of a missing answer: what it means} of those in a summary
Json failures_json(const Json& summary);

}  // namespace twum::inline v0_1::studies
