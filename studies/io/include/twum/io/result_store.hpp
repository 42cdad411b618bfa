// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/error.hpp>
#include <twum/base/namespaces.hpp>
#include <twum/io/column.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace twum::inline v0_1::io {

/// One evaluation. It is identified by (stage, index), which depends on the study and its seed, not on threads or
/// interruptions.
struct StoredRow {
  std::uint64_t stage{0};      ///< part of the run
  std::uint64_t index{0};      ///< number of the evaluation in its stage
  std::vector<double> values;  ///< one for each column, SI; NaN: no value
  std::string status{"ok"};    ///< or the short reason why there is no full answer
  /// bytes that the study kind needs to resume, such as a Jacobian; not exported
  std::string detail{};
};

/// A result could not be written or read back: full disk, no permission, damaged database.
class StoreError : public Error {
 public:
  /// The constructors of Error; the text names the file.
  using Error::Error;
};

/// What was asked for ended early because a stop was requested.
class Interrupted : public Error {
 public:
  /// The text says so.
  Interrupted() : Error("interrupted") {}
};

/// The evaluations of a study in an SQLite database (write-ahead log, one writer, batched commits). Committed rows
/// survive if the process is killed at any moment; rows of an unfinished batch are computed again. All functions are
/// thread-safe.
class ResultStore {
 public:
  /// Opens or creates a database. An existing one must have these columns; all of it is read and its checksum is
  /// verified.
  /// @param path  ":memory:" keeps everything in memory
  /// @param stop  ends reading and checking within milliseconds; they then throw Interrupted
  /// @throws StoreError naming the file and the reason
  ResultStore(const std::string& path, const std::vector<StoredColumn>& columns,
              const std::stop_token& stop = {});
  /// Opens an existing database, with the columns it has; an empty file has none.
  /// @param stop  as above
  /// @throws StoreError likewise
  explicit ResultStore(const std::string& path, const std::stop_token& stop = {});
  /// Commits all added rows.
  ~ResultStore();
  ResultStore(const ResultStore&) = delete;
  ResultStore& operator=(const ResultStore&) = delete;

  /// Columns of a row.
  const std::vector<StoredColumn>& columns() const noexcept;

  /// @throws StoreError unless these are the columns
  void require(const std::vector<StoredColumn>& columns) const;

  /// Adds a row; one that is already there stays as it is. Committed within about 0.2 s. A row
  /// without a value for a column has NaN there.
  /// @throws StoreError if it cannot be written. Every function below throws StoreError if it cannot read or write.
  void add(const StoredRow& row);
  /// Commits all added rows.
  void flush();

  /// The number of rows 0, 1, 2, ... of a stage that are stored without a gap.
  std::uint64_t next_index(std::uint64_t stage) const;
  /// How many rows are stored.
  std::uint64_t rows() const;
  /// The stages that have rows, rising.
  std::vector<std::uint64_t> stages() const;

  /// Calls `visit` with each row in the order of (stage, index). Memory does not grow with the number of rows.
  void read(const std::function<void(const StoredRow&)>& visit) const;
  /// The rows of one stage.
  void read(std::uint64_t stage, const std::function<void(const StoredRow&)>& visit) const;

  /// A named text beside the rows, such as the study's hash; empty if there is none.
  std::string fact(const std::string& name) const;
  /// Writes or replaces such a text; committed at once.
  void set_fact(const std::string& name, const std::string& value);

 private:
  class Database;
  std::unique_ptr<Database> database_;
};

}  // namespace twum::inline v0_1::io
