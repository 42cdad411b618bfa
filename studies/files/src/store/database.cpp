// SPDX-License-Identifier: Apache-2.0
#include "store/database.hpp"

#include "text/checksum.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

namespace twum::studies {
namespace {

constexpr std::size_t kRowsPerBatch = 20000;
constexpr auto kBatchTime = std::chrono::milliseconds(200);
constexpr std::size_t kRowsPerPage = 512;
constexpr int kApplication = 0x7477756d;  // "twum", in the head of the file
constexpr int kVersion = 1;
// Index of a row's first value among the columns of the table, and of what the values stand between.
constexpr int kFirstValue = 2;

std::string heading(const Column& column) { return column.name + " [" + column.unit + "]"; }

bool same_name(std::string_view a, std::string_view b) {  // to SQL, capitals make no difference
  const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

// Headings as names of columns, which SQL wants to differ: "a [m]" after "A [m]" becomes "a [m] 2".
std::vector<std::string> table_names(const std::vector<Column>& columns) {
  std::vector<std::string> names;
  for (const Column& column : columns) {
    std::string name = heading(column);
    for (int n = 2; std::any_of(names.begin(), names.end(),
                                [&](const std::string& other) { return same_name(name, other); });
         ++n) {
      name = heading(column) + " " + std::to_string(n);
    }
    names.push_back(std::move(name));
  }
  return names;
}

std::string bytes_of(double value) {
  if (std::isnan(value)) return "NaN";
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

// Of what a row says: a stored row whose sum differs is not what was written.
std::int64_t sum_of(const Row& row, std::size_t columns) {
  std::uint64_t sum = checksum(bytes_of(static_cast<double>(row.stage)));
  sum = checksum(bytes_of(static_cast<double>(row.index)), sum);
  for (std::size_t i = 0; i < columns; ++i) {
    sum = checksum(
        bytes_of(i < row.values.size() ? row.values[i] : std::numeric_limits<double>::quiet_NaN()),
        sum);
  }
  sum = checksum(row.status, sum);
  sum = checksum(std::string_view("\0", 1), sum);
  return static_cast<std::int64_t>(checksum(row.detail, sum));
}

}  // namespace

ResultStore::Database::Database(const std::string& path, std::vector<Column> columns)
    : connection_(path, true), columns_(std::move(columns)) {
  connection_.execute("PRAGMA busy_timeout = 5000");
  if (is_blank()) {
    make_tables();
  } else {
    check_tables();
    const std::vector<Column> stored = stored_columns();
    const auto same = [](const Column& a, const Column& b) {
      return a.name == b.name && a.unit == b.unit;
    };
    if (!std::equal(columns_.begin(), columns_.end(), stored.begin(), stored.end(), same)) {
      throw StoreError(path + ": holds the rows of another study, with other columns");
    }
  }
  // Only now: in write-ahead mode the head of a young database would be in the log, and the file not be
  // known as one of ours.
  connection_.execute(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 4000");
  prepare();
}

ResultStore::Database::Database(const std::string& path) : connection_(path, false) {
  connection_.execute("PRAGMA busy_timeout = 5000");
  if (is_blank()) make_tables();
  check_tables();
  columns_ = stored_columns();
  prepare();
}

ResultStore::Database::~Database() {
  committer_.request_stop();
  if (committer_.joinable()) committer_.join();
  try {
    commit_batch();
    insert_.reset();
    // A finished database is one plain file, which can be read from a folder without permission to
    // write. Where another program is reading just now it stays as it is.
    connection_.execute("PRAGMA busy_timeout = 0; PRAGMA journal_mode = DELETE");
  } catch (const StoreError&) {
    // Whoever needs to know has called flush().
  }
}

// A file that was made, but left before anything was in it.
bool ResultStore::Database::is_blank() {
  return connection_.number_of("SELECT count(*) FROM sqlite_master") == 0;
}

void ResultStore::Database::make_tables() {
  std::string sql =
      "BEGIN IMMEDIATE; PRAGMA application_id = " + std::to_string(kApplication) +
      "; PRAGMA user_version = " + std::to_string(kVersion) +
      "; CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL)"
      "; CREATE TABLE columns (place INTEGER PRIMARY KEY, name TEXT NOT NULL, unit TEXT NOT NULL)"
      "; CREATE TABLE evaluations (stage INTEGER NOT NULL, \"index\" INTEGER NOT NULL";
  // Without a type a value is kept as it is; a column of type REAL makes 0 of -0.
  for (const std::string& name : table_names(columns_)) sql += ", " + sqlite::quoted_name(name);
  sql +=
      ", status TEXT NOT NULL, detail BLOB, checksum INTEGER NOT NULL, "
      "PRIMARY KEY (stage, \"index\")) WITHOUT ROWID";
  connection_.execute(sql);
  sqlite::Statement insert(connection_, "INSERT INTO columns VALUES (?, ?, ?)");
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    insert.bind(1, static_cast<std::int64_t>(i));
    insert.bind_text(2, columns_[i].name);
    insert.bind_text(3, columns_[i].unit);
    insert.run();
  }
  connection_.execute("COMMIT");
}

void ResultStore::Database::check_tables() {
  if (connection_.number_of("PRAGMA application_id") != kApplication) {
    throw StoreError(connection_.path() + ": is a database of something else, not of twum");
  }
  if (connection_.number_of("PRAGMA user_version") != kVersion) {
    throw StoreError(connection_.path() + ": was written by another version of twum");
  }
  const std::string found = connection_.text_of("PRAGMA quick_check(1)");
  if (found != "ok") throw StoreError(connection_.path() + ": is damaged: " + found);
}

std::vector<Column> ResultStore::Database::stored_columns() {
  std::vector<Column> columns;
  sqlite::Statement select(connection_, "SELECT name, unit FROM columns ORDER BY place");
  while (select.step())
    columns.push_back({std::string(select.text(0)), std::string(select.text(1))});
  return columns;
}

void ResultStore::Database::prepare() {
  std::string places = "?, ?";
  for (std::size_t i = 0; i < columns_.size(); ++i) places += ", ?";
  insert_.emplace(connection_,
                  "INSERT OR IGNORE INTO evaluations VALUES (" + places + ", ?, ?, ?)");
  select_page_ =
      "SELECT * FROM evaluations WHERE stage = ? AND \"index\" >= ? ORDER BY \"index\" LIMIT " +
      std::to_string(kRowsPerPage);
  rows_ = static_cast<std::uint64_t>(connection_.number_of("SELECT count(*) FROM evaluations"));
  committer_ = std::jthread([this](const std::stop_token& stop) { commit_in_time(stop); });
}

void ResultStore::Database::insert(const Row& row) {
  insert_->bind(1, static_cast<std::int64_t>(row.stage));
  insert_->bind(2, static_cast<std::int64_t>(row.index));
  int place = kFirstValue + 1;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    insert_->bind(place++,
                  i < row.values.size() ? row.values[i] : std::numeric_limits<double>::quiet_NaN());
  }
  insert_->bind_text(place++, row.status);
  insert_->bind_blob(place++, row.detail);
  insert_->bind(place, sum_of(row, columns_.size()));
  insert_->run();
  rows_ += static_cast<std::uint64_t>(connection_.changes());
}

void ResultStore::Database::begin_batch() {
  connection_.execute("BEGIN IMMEDIATE");
  batch_begun_.notify_one();
}

void ResultStore::Database::commit_batch() {
  batch_ = 0;
  if (connection_.in_transaction()) connection_.execute("COMMIT");
}

void ResultStore::Database::add(const Row& row) {
  TWUM_ASSERT(row.values.size() <= columns_.size());
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  try {
    if (batch_++ == 0) begin_batch();
    insert(row);
    if (batch_ >= kRowsPerBatch) commit_batch();
  } catch (...) {
    failure_ = std::current_exception();
    throw;
  }
}

void ResultStore::Database::flush() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  commit_batch();
}

void ResultStore::Database::commit_in_time(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (batch_begun_.wait(lock, stop, [&] { return batch_ > 0 && !failure_; })) {
    batch_begun_.wait_for(lock, stop, kBatchTime, [] { return false; });
    try {
      if (!failure_) commit_batch();
    } catch (...) {
      failure_ = std::current_exception();
    }
  }
}

std::uint64_t ResultStore::Database::next_index(std::uint64_t stage) {
  const std::lock_guard lock(mutex_);
  std::uint64_t& next = next_[stage];
  sqlite::Statement select(connection_,
                           "SELECT \"index\" FROM evaluations WHERE stage = ? AND \"index\" >= ? "
                           "ORDER BY \"index\"");
  select.bind(1, static_cast<std::int64_t>(stage));
  select.bind(2, static_cast<std::int64_t>(next));
  while (select.step() && select.integer(0) == static_cast<std::int64_t>(next)) ++next;
  return next;
}

std::uint64_t ResultStore::Database::rows() {
  const std::lock_guard lock(mutex_);
  return rows_;
}

std::optional<std::uint64_t> ResultStore::Database::stage_from(std::uint64_t stage) {
  const std::lock_guard lock(mutex_);
  sqlite::Statement select(connection_,
                           "SELECT stage FROM evaluations WHERE stage >= ? ORDER BY stage LIMIT 1");
  select.bind(1, static_cast<std::int64_t>(stage));
  if (!select.step()) return {};
  return static_cast<std::uint64_t>(select.integer(0));
}

bool ResultStore::Database::page(std::uint64_t stage, std::uint64_t from, std::vector<Row>& page) {
  const std::lock_guard lock(mutex_);
  sqlite::Statement select(connection_, select_page_);
  select.bind(1, static_cast<std::int64_t>(stage));
  select.bind(2, static_cast<std::int64_t>(from));
  const int after_values = kFirstValue + static_cast<int>(columns_.size());
  page.resize(kRowsPerPage);
  std::size_t count = 0;
  for (; select.step(); ++count) {
    Row& row = page[count];
    row.stage = stage;
    row.index = static_cast<std::uint64_t>(select.integer(1));
    row.values.resize(columns_.size());
    for (int i = kFirstValue; i < after_values; ++i)
      row.values[static_cast<std::size_t>(i - kFirstValue)] = select.real(i);
    row.status = select.text(after_values);
    row.detail = select.blob(after_values + 1);
    if (select.integer(after_values + 2) != sum_of(row, columns_.size())) {
      throw StoreError(connection_.path() + ": is damaged: row " + std::to_string(row.index) +
                       " of stage " + std::to_string(stage) + " is not what was written");
    }
  }
  page.resize(count);
  return count > 0;
}

std::string ResultStore::Database::fact(const std::string& name) {
  const std::lock_guard lock(mutex_);
  sqlite::Statement select(connection_, "SELECT value FROM facts WHERE name = ?");
  select.bind_text(1, name);
  return select.step() ? std::string(select.text(0)) : std::string();
}

void ResultStore::Database::set_fact(const std::string& name, const std::string& value) {
  const std::lock_guard lock(mutex_);
  commit_batch();
  sqlite::Statement insert(connection_, "INSERT OR REPLACE INTO facts VALUES (?, ?)");
  insert.bind_text(1, name);
  insert.bind_text(2, value);
  insert.run();
}

}  // namespace twum::studies
