// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

/// The meaning of names and limits in a result, so that the page does not have to parse texts; internal.
namespace twum::studies {

/// {text: what it is} of every metric, statistic and limit that a summary or a list of columns names. SI: {"metric",
/// "argument": "speed" or "torque", "at"} of a metric at an argument; {"statistic": "mean", "sd", "quantile",
/// "probability" or "yield", "of": text, "probability"} of a statistic; {"of": text, "unit", "lower", "upper"} of a
/// limit, or {"sides": [text, text], "lower", "upper"} of two sides. Other names, such as a plain metric or a
/// formula, have no entry.
Json names_json(const Json& summary, const Json& columns);

/// {reason of a missing answer: what it means} of those in a summary
Json failures_json(const Json& summary);

}  // namespace twum::studies
