// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/error.hpp>
#include <twum/studies/store/column.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace twum::studies {

/// One evaluation. (stage, index) names it for ever: it is a function of the study and its seed, not
/// of threads or interruptions.
struct StoredRow {
  std::uint64_t stage{0};      ///< part of the run that it belongs to
  std::uint64_t index{0};      ///< its number there
  std::vector<double> values;  ///< one for each column, SI; NaN: no value
  std::string status{"ok"};    ///< or the short reason why there is no full answer
  std::string detail{};  ///< bytes that the kind needs to go on, such as a Jacobian; not exported
};

/// A result could not be written or read back: full disk, no permission, damaged database.
class StoreError : public Error {
 public:
  /// With its text, which names the file.
  using Error::Error;
};

/// The evaluations of a study in an SQLite database (write-ahead log, one writer, batched commits).
/// What was committed survives a kill at any moment; what the last batch held is computed again.
/// All functions may be called from several threads; they take turns.
class ResultStore {
 public:
  /// Opens a database, or makes one; an existing one must have these columns. Reads all of an existing
  /// one, and refuses it unless it holds what was written.
  /// @param path  ":memory:" keeps everything in memory
  /// @throws StoreError naming the file and the reason
  ResultStore(const std::string& path, const std::vector<StoredColumn>& columns);
  /// Opens an existing database, with the columns it has; an empty file has none.
  /// @throws StoreError likewise
  explicit ResultStore(const std::string& path);
  /// Commits what was added.
  ~ResultStore();
  ResultStore(const ResultStore&) = delete;
  ResultStore& operator=(const ResultStore&) = delete;

  /// What a row holds.
  const std::vector<StoredColumn>& columns() const noexcept;

  /// Adds a row; one that is already there stays as it is. Committed within about 0.2 s. A row
  /// without a value for a column has NaN there.
  /// @throws StoreError if it cannot be written, as every function below if it cannot be read
  void add(const StoredRow& row);
  /// Commits what was added.
  void flush();

  /// How many rows 0, 1, 2, ... of a stage are stored without a gap.
  std::uint64_t next_index(std::uint64_t stage) const;
  /// How many rows are stored.
  std::uint64_t rows() const;
  /// The stages that have rows, rising.
  std::vector<std::uint64_t> stages() const;

  /// Calls back with each row in the order of (stage, index); memory does not grow with the rows.
  void read(const std::function<void(const StoredRow&)>& visit) const;
  /// The rows of one stage.
  void read(std::uint64_t stage, const std::function<void(const StoredRow&)>& visit) const;

  /// A fact beside the rows, such as the study's hash; empty text if there is none.
  std::string fact(const std::string& name) const;
  /// Writes a fact, in place of what there was; committed at once.
  void set_fact(const std::string& name, const std::string& value);

 private:
  class Database;
  std::unique_ptr<Database> database_;
};

}  // namespace twum::studies
