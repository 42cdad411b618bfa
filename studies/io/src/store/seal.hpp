// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "store/sqlite.hpp"

#include <twum/io/column.hpp>
#include <twum/io/result_store.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Checksum of a database's content, written with every batch; internal.
namespace twum::inline v0_1::io {

/// How many rows a database must hold, and the sum (modulo 2^64) of the checksums of its rows, facts and columns.
/// SQLite itself detects neither an intact page in the place of another nor a missing row.
struct Seal {
  std::uint64_t rows{0};
  std::uint64_t sum{0};
  bool operator==(const Seal&) const = default;
};

using Facts = std::map<std::string, std::string>;

/// Checksum of a row, for a table of so many columns.
std::uint64_t checksum_of(const StoredRow& row, std::size_t columns);
std::uint64_t checksum_of_fact(std::string_view name, std::string_view value);
std::uint64_t checksum_of(const std::vector<StoredColumn>& columns);

/// The current row of a SELECT * FROM evaluations.
/// @throws StoreError if it is not what was written
StoredRow read_row(const sqlite::Connection& connection, const sqlite::Statement& select,
                   std::size_t columns);

/// The facts of a database.
Facts read_facts(sqlite::Connection& connection);

/// Reads the whole database. Costs about 1.2 us a row of eight columns.
/// @return its seal
/// @throws StoreError if its rows, facts and columns are not those of the seal
Seal checked_seal(sqlite::Connection& connection, const std::vector<StoredColumn>& columns,
                  const Facts& facts);

/// @throws StoreError that says that a file is damaged, and what to do
[[noreturn]] void fail_damaged(const std::string& path, const std::string& what);

}  // namespace twum::inline v0_1::io
