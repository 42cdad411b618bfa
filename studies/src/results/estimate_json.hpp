// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/studies/estimate.hpp>

namespace twum::inline v0_1::studies {

/// {value, low, high}
inline Json estimate_json(const Estimate& estimate) {
  return {{"value", number_json(estimate.value)},
          {"low", number_json(estimate.low)},
          {"high", number_json(estimate.high)}};
}

/// {low, high}
inline Json interval_json(const Estimate& estimate) {
  return {{"low", number_json(estimate.low)}, {"high", number_json(estimate.high)}};
}

}  // namespace twum::inline v0_1::studies
