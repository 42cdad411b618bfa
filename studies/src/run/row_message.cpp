// SPDX-License-Identifier: Apache-2.0
#include "run/row_message.hpp"

#include "kinds/rows/row_bytes.hpp"

namespace twum::inline v0_1::studies {

std::string row_message(std::span<const StoredRow> rows) {
  std::string bytes;
  append_bytes(bytes, static_cast<std::uint64_t>(rows.size()));
  for (const StoredRow& row : rows) {
    append_bytes(bytes, row.stage);
    append_bytes(bytes, row.index);
    append_numbers(bytes, row.values);
    append_text(bytes, row.status);
    append_text(bytes, row.detail);
  }
  return bytes;
}

std::vector<StoredRow> rows_of(const std::string& message) {
  RowBytes bytes(message);
  std::vector<StoredRow> rows(bytes.take<std::uint64_t>());
  for (StoredRow& row : rows) {
    row.stage = bytes.take<std::uint64_t>();
    row.index = bytes.take<std::uint64_t>();
    row.values = bytes.numbers();
    row.status = bytes.text();
    row.detail = bytes.text();
  }
  return rows;
}

}  // namespace twum::inline v0_1::studies
