// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "store/seal.hpp"
#include "store/sqlite.hpp"

#include <twum/io/result_store.hpp>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace twum::inline v0_1::io {

/// Implementation of ResultStore: one connection, one open batch, and a thread that commits it within a time limit.
/// Every member function takes the lock.
class ResultStore::Database {
 public:
  Database(const std::string& path, const std::vector<StoredColumn>& columns,
           const std::stop_token& stop);
  /// An existing database, with the columns it has.
  explicit Database(const std::string& path, const std::stop_token& stop);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::vector<StoredColumn>& columns() const noexcept { return columns_; }
  void require(const std::vector<StoredColumn>& columns) const;
  void add(const StoredRow& row);
  void flush();
  std::uint64_t next_index(std::uint64_t stage);
  std::uint64_t rows();
  /// The first stage from this one on that has rows.
  std::optional<std::uint64_t> stage_from(std::uint64_t stage);
  /// Some rows of a stage from an index on; none if there are none.
  std::vector<StoredRow> page(std::uint64_t stage, std::uint64_t from);
  std::string fact(const std::string& name);
  void set_fact(const std::string& name, const std::string& value);

 private:
  void open(const std::vector<StoredColumn>& columns_of_new);
  bool is_blank();
  void make_tables(const std::vector<StoredColumn>& columns);
  void check_tables();
  void check_schema();
  std::vector<StoredColumn> stored_columns();
  void read_content();
  void prepare();
  template <typename Write>
  void write(Write change);
  void insert(const StoredRow& row);
  void begin_batch();
  void commit_batch();
  void commit_in_time(const std::stop_token& stop);

  sqlite::Connection connection_;
  std::vector<StoredColumn> columns_;
  Facts facts_;
  std::optional<sqlite::Statement> insert_;
  std::string select_page_;

  std::mutex mutex_;  // guards the connection and what follows
  std::size_t batch_{0};
  bool in_log_{false};  // true once the first batch has switched to write-ahead mode
  Seal seal_;
  // next_index() by stage, for the stages that were asked for
  std::map<std::uint64_t, std::uint64_t> next_;
  std::exception_ptr failure_;  // failure of a write, after which nothing is written
  std::condition_variable_any batch_begun_;
  std::jthread committer_;  // declared last, so that it ends before the other members are destroyed
};

}  // namespace twum::inline v0_1::io
