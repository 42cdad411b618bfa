// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/formula.hpp>

namespace twum::inline v0_1::io {

/// Value of one step of a formula from the values of its operands; a function of one operand ignores the second. Not
/// finite if it is not defined.
double apply(Formula::Operation operation, double left, double right);

}  // namespace twum::inline v0_1::io
