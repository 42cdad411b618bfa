// SPDX-License-Identifier: Apache-2.0
#include "store/database.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kRowsPerBatch = 20000;
constexpr auto kBatchTime = std::chrono::milliseconds(200);
constexpr std::size_t kRowsPerPage = 512;
constexpr int kApplication = 0x7477756d;  // "twum", in the head of the file
constexpr int kVersion = 2;
constexpr int kFirstPlace = 3;  // place of a row's first value in an INSERT

std::string heading(const StoredColumn& column) { return column.name + " [" + column.unit + "]"; }

bool same_name(std::string_view a, std::string_view b) {  // SQL ignores the case of names
  const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

// Headings made into distinct SQL names of columns: "a [m]" after "A [m]" becomes "a [m] 2".
std::vector<std::string> table_names(const std::vector<StoredColumn>& columns) {
  std::vector<std::string> names;
  for (const StoredColumn& column : columns) {
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

// The statements that define the tables, that of the evaluations last.
std::vector<std::string> tables_for(const std::vector<StoredColumn>& columns) {
  // Columns have no type, because type REAL would turn -0 into 0.
  std::string values;
  for (const std::string& name : table_names(columns)) values += ", " + sqlite::quoted_name(name);
  return {
      "CREATE TABLE seal (rows INTEGER NOT NULL, sum INTEGER NOT NULL)",
      "CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID",
      "CREATE TABLE columns (place INTEGER PRIMARY KEY, name TEXT NOT NULL, unit TEXT NOT NULL)",
      "CREATE TABLE evaluations (stage INTEGER NOT NULL, \"index\" INTEGER NOT NULL" + values +
          ", status TEXT NOT NULL, detail BLOB, checksum INTEGER NOT NULL, "
          "PRIMARY KEY (stage, \"index\")) WITHOUT ROWID"};
}

bool same(const std::vector<StoredColumn>& a, const std::vector<StoredColumn>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const StoredColumn& x, const StoredColumn& y) {
                      return x.name == y.name && x.unit == y.unit;
                    });
}

}  // namespace

ResultStore::Database::Database(const std::string& path, const std::vector<StoredColumn>& columns,
                                const std::stop_token& stop)
    : connection_(path, true, stop) {
  open(columns);
  require(columns);
}

ResultStore::Database::Database(const std::string& path, const std::stop_token& stop)
    : connection_(path, false, stop) {
  open({});
}

void ResultStore::Database::open(const std::vector<StoredColumn>& columns_of_new) {
  connection_.execute("PRAGMA busy_timeout = 5000");
  if (is_blank()) make_tables(columns_of_new);
  check_tables();
  read_content();
  prepare();
}

ResultStore::Database::~Database() {
  committer_.request_stop();
  if (committer_.joinable()) committer_.join();
  try {
    if (!failure_) commit_batch();
    insert_.reset();
    if (connection_.has_moved()) {  // the file at its path is another one
      connection_.abandon();
      return;
    }
    // A finished database is one plain file, which can be read from a folder without permission to write. If another
    // program is reading it now, it stays in write-ahead mode.
    connection_.execute("PRAGMA busy_timeout = 0; PRAGMA journal_mode = DELETE");
  } catch (const Error&) {
    // Errors are ignored here; call flush() to get them.
  }
}

void ResultStore::Database::require(const std::vector<StoredColumn>& columns) const {
  if (!same(columns_, columns))
    throw StoreError(connection_.path() + ": holds the rows of another study, with other columns");
}

// True for a database file that was created but never filled.
bool ResultStore::Database::is_blank() {
  return connection_.number_of("SELECT count(*) FROM sqlite_master") == 0;
}

void ResultStore::Database::make_tables(const std::vector<StoredColumn>& columns) {
  connection_.execute("BEGIN IMMEDIATE; PRAGMA application_id = " + std::to_string(kApplication) +
                      "; PRAGMA user_version = " + std::to_string(kVersion));
  for (const std::string& table : tables_for(columns)) connection_.execute(table);
  sqlite::Statement insert(connection_, "INSERT INTO columns VALUES (?, ?, ?)");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    insert.bind(1, static_cast<std::int64_t>(i));
    insert.bind_text(2, columns[i].name);
    insert.bind_text(3, columns[i].unit);
    insert.run();
  }
  sqlite::Statement seal(connection_, "INSERT INTO seal VALUES (0, ?)");
  seal.bind(1, static_cast<std::int64_t>(checksum_of(columns)));
  seal.run();
  connection_.execute("COMMIT");
}

void ResultStore::Database::check_tables() {
  if (connection_.number_of("PRAGMA application_id") != kApplication) {
    throw StoreError(connection_.path() + ": is a database of something else, not of twum");
  }
  if (connection_.number_of("PRAGMA user_version") != kVersion) {
    throw StoreError(connection_.path() +
                     ": was written by another version of twum; use that one, or run the study "
                     "again with --fresh");
  }
  check_schema();
  const std::string found = connection_.text_of("PRAGMA quick_check(1)");
  if (found != "ok") fail_damaged(connection_.path(), found);
}

// The database defines the four tables and nothing else. A view, a trigger or a virtual table in the place of one could compute
// for ever.
void ResultStore::Database::check_schema() {
  std::vector<std::string> found;
  sqlite::Statement select(connection_, "SELECT sql FROM sqlite_master ORDER BY rowid");
  while (select.step()) found.emplace_back(select.text(0));
  const auto holds = [&](const std::string& table) {
    return std::find(found.begin(), found.end(), table) != found.end();
  };
  const std::vector<std::string> fixed = tables_for({});
  const bool readable =
      found.size() == fixed.size() && std::all_of(fixed.begin(), fixed.end() - 1, holds);
  if (readable && holds(tables_for(stored_columns()).back())) return;
  fail_damaged(connection_.path(), "its tables are not those that twum writes");
}

std::vector<StoredColumn> ResultStore::Database::stored_columns() {
  std::vector<StoredColumn> columns;
  sqlite::Statement select(connection_, "SELECT name, unit FROM columns ORDER BY place");
  while (select.step())
    columns.push_back({std::string(select.text(0)), std::string(select.text(1))});
  return columns;
}

// In one transaction, because rows committed by another program meanwhile do not belong to this seal.
void ResultStore::Database::read_content() {
  connection_.execute("BEGIN");
  columns_ = stored_columns();
  facts_ = read_facts(connection_);
  seal_ = checked_seal(connection_, columns_, facts_);
  connection_.execute("COMMIT");
}

void ResultStore::Database::prepare() {
  std::string places = "?, ?";
  for (std::size_t i = 0; i < columns_.size(); ++i) places += ", ?";
  insert_.emplace(connection_,
                  "INSERT OR IGNORE INTO evaluations VALUES (" + places + ", ?, ?, ?)");
  select_page_ =
      "SELECT * FROM evaluations WHERE stage = ? AND \"index\" >= ? ORDER BY \"index\" LIMIT " +
      std::to_string(kRowsPerPage);
  committer_ = std::jthread([this](const std::stop_token& stop) { commit_in_time(stop); });
}

// Makes a change. After a failure no further changes are made.
template <typename Write>
void ResultStore::Database::write(Write change) {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  try {
    change();
  } catch (...) {
    failure_ = std::current_exception();
    throw;
  }
}

void ResultStore::Database::insert(const StoredRow& row) {
  const std::uint64_t sum = checksum_of(row, columns_.size());
  insert_->bind(1, static_cast<std::int64_t>(row.stage));
  insert_->bind(2, static_cast<std::int64_t>(row.index));
  int place = kFirstPlace;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    insert_->bind(place++,
                  i < row.values.size() ? row.values[i] : std::numeric_limits<double>::quiet_NaN());
  }
  insert_->bind_text(place++, row.status);
  insert_->bind_blob(place++, row.detail);
  insert_->bind(place, static_cast<std::int64_t>(sum));
  insert_->run();
  if (connection_.changes() == 0) return;  // the row existed
  ++seal_.rows;
  seal_.sum += sum;
}

void ResultStore::Database::begin_batch() {
  // Not earlier: in write-ahead mode the header of a new database is in the log, so the file could not be recognized.
  if (!in_log_) {
    connection_.execute(
        "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 4000");
    in_log_ = true;
  }
  connection_.execute("BEGIN IMMEDIATE");
  batch_begun_.notify_one();
}

void ResultStore::Database::commit_batch() {
  batch_ = 0;
  if (!connection_.in_transaction()) return;
  if (connection_.has_moved()) {
    throw StoreError(
        connection_.path() +
        ": was moved, replaced or removed while the study was running; the results are "
        "not there. Run the study again");
  }
  sqlite::Statement update(connection_, "UPDATE seal SET rows = ?, sum = ?");
  update.bind(1, static_cast<std::int64_t>(seal_.rows));
  update.bind(2, static_cast<std::int64_t>(seal_.sum));
  update.run();
  connection_.execute("COMMIT");
}

void ResultStore::Database::add(const StoredRow& row) {
  TWUM_ASSERT(row.values.size() <= columns_.size());
  write([&] {
    if (batch_++ == 0) begin_batch();
    insert(row);
    if (batch_ >= kRowsPerBatch) commit_batch();
  });
}

void ResultStore::Database::flush() {
  write([&] { commit_batch(); });
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
  return seal_.rows;
}

std::optional<std::uint64_t> ResultStore::Database::stage_from(std::uint64_t stage) {
  const std::lock_guard lock(mutex_);
  sqlite::Statement select(connection_,
                           "SELECT stage FROM evaluations WHERE stage >= ? ORDER BY stage LIMIT 1");
  select.bind(1, static_cast<std::int64_t>(stage));
  if (!select.step()) return {};
  return select.count(0);
}

std::vector<StoredRow> ResultStore::Database::page(std::uint64_t stage, std::uint64_t from) {
  const std::lock_guard lock(mutex_);
  sqlite::Statement select(connection_, select_page_);
  select.bind(1, static_cast<std::int64_t>(stage));
  select.bind(2, static_cast<std::int64_t>(from));
  std::vector<StoredRow> rows;
  while (select.step()) rows.push_back(read_row(connection_, select, columns_.size()));
  return rows;
}

std::string ResultStore::Database::fact(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = facts_.find(name);
  return found == facts_.end() ? std::string() : found->second;
}

void ResultStore::Database::set_fact(const std::string& name, const std::string& value) {
  write([&] {
    const auto before = facts_.find(name);
    if (before != facts_.end() && before->second == value) return;
    commit_batch();
    begin_batch();
    sqlite::Statement insert(connection_, "INSERT OR REPLACE INTO facts VALUES (?, ?)");
    insert.bind_text(1, name);
    insert.bind_text(2, value);
    insert.run();
    if (before != facts_.end()) seal_.sum -= checksum_of_fact(name, before->second);
    seal_.sum += checksum_of_fact(name, value);
    facts_[name] = value;
    commit_batch();
  });
}

}  // namespace twum::inline v0_1::io
