// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/equivalent_circuit.hpp>
#include <twum/io/shape.hpp>

namespace twum::inline v0_1::motors {

/// Entries of `stator.equivalent_circuit`, all of them required.
const Shape<EquivalentCircuit>& circuit_shape();

/// Adds errors for modal data of the stator given beside its equivalent circuit, and for modal data from the circuit
/// that are out of range; false if there are any.
/// @param circuit  of the entry `equivalent_circuit`, if that has been read
bool check_circuit(const std::optional<EquivalentCircuit>& circuit, const Given& stator,
                   Diagnostics& diagnostics);

}  // namespace twum::inline v0_1::motors
