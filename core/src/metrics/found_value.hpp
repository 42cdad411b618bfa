// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/curve.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/core/metric_value.hpp>

#include <cmath>

namespace twum::inline v0_1::core {

/// What a search finds, or why it finds nothing.
/// @param find  returns a number; may throw SearchFailure, and EvaluationError for a search without a bracket
template <typename Find>
MetricValue found_value(Find find) {
  try {
    const double found = find();
    return std::isfinite(found) ? MetricValue{found, MetricStatus::ok}
                                : MetricValue{kNoValue, MetricStatus::inaccurate};
  } catch (const SearchFailure& failure) {
    return {kNoValue, failure.status};
  } catch (const EvaluationError&) {
    return {kNoValue, MetricStatus::unresolved};
  }
}

/// The way back: the number, or a SearchFailure.
inline double known(const MetricValue& found) {
  if (found.status != MetricStatus::ok) throw SearchFailure{found.status};
  return found.value;
}

}  // namespace twum::inline v0_1::core
