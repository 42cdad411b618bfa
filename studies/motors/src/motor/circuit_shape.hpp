// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/equivalent_circuit.hpp>
#include <twum/studies/schema/shape.hpp>

namespace twum::studies {

/// Entries of `stator.equivalent_circuit`, all of them needed.
const Shape<EquivalentCircuit>& circuit_shape();

/// Says which modal data of the stator stand beside its equivalent circuit, and which of those that follow from the circuit are
/// out of range; false if any.
/// @param circuit  of the entry `equivalent_circuit`, if that has been read
bool check_circuit(const std::optional<EquivalentCircuit>& circuit, const Given& stator,
                   Diagnostics& diagnostics);

}  // namespace twum::studies
