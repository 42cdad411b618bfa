// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/result_store.hpp>

#include <span>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Rows as the bytes of a message between processes of one program; numbers arrive to the bit.
std::string row_message(std::span<const StoredRow> rows);
/// The rows that a message holds.
std::vector<StoredRow> rows_of(const std::string& message);

}  // namespace twum::inline v0_1::studies
