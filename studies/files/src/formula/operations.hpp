// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/formula/formula.hpp>

namespace twum::studies {

/// Value of one step of a formula from those of its operands, the second of which a function of one does not look at. Not a
/// finite number where there is none.
double apply(Formula::Operation operation, double left, double right);

}  // namespace twum::studies
