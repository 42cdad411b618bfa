// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

/// What the names and limits in a result stand for, so that the page takes no text apart; internal.
namespace twum::studies {

/// {text: what it is} of every metric, statistic and limit that a summary or a list of columns names. SI:
/// {"metric", "argument": "speed" or "torque", "at"} of a metric at an argument;
/// {"statistic": "mean", "sd", "quantile", "probability" or "yield", "of": text, "probability"} of a statistic;
/// {"of": text, "unit", "lower", "upper"} of a limit, or {"sides": [text, text], "lower", "upper"} of two sides.
/// What is none of them, such as a plain metric or a formula, has no entry.
Json names_json(const Json& summary, const Json& columns);

/// {reason of a missing answer: what it means} of those in a summary
Json failures_json(const Json& summary);

}  // namespace twum::studies
