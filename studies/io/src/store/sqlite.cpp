// SPDX-License-Identifier: Apache-2.0
#include "store/sqlite.hpp"

#include <twum/io/result_store.hpp>

#include <sqlite3.h>

#include <cstring>
#include <limits>

namespace twum::inline v0_1::io::sqlite {
namespace {

// The meaning of a result code with advice; `system` is errno, if any.
std::string reason(int code, int system, const char* text) {
  const std::string why = system != 0 ? std::string(": ") + std::strerror(system) : std::string();
  switch (code & 0xff) {
    case SQLITE_FULL:
      return "cannot be written" + (why.empty() ? ": the disk is full" : why) +
             "; what was stored before is kept, make room and run it again";
    case SQLITE_CANTOPEN: return "cannot be opened" + why;
    case SQLITE_READONLY: return "cannot be written: no permission, or a read-only folder";
    case SQLITE_PERM: return "cannot be opened: no permission";
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return "is in use by another program; wait for it or end it";
    case SQLITE_NOTADB: return "is damaged, or no SQLite database at all";
    case SQLITE_CORRUPT: return "is damaged";
    case SQLITE_IOERR: return "cannot be read or written" + why;
    case SQLITE_NOMEM: return "needs more memory than there is";
    default: return std::string("SQLite says: ") + text;
  }
}

constexpr int kStepsBetweenLooks = 10000;  // steps of SQLite's virtual machine: about 0.1 ms

int asked_to_stop(void* stop) {
  return static_cast<const std::stop_token*>(stop)->stop_requested() ? 1 : 0;
}

}  // namespace

Connection::Connection(std::string path, bool make, std::stop_token stop)
    : path_(std::move(path)), stop_(std::move(stop)) {
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE |
                    (make ? SQLITE_OPEN_CREATE : 0);
  const int code = sqlite3_open_v2(path_.c_str(), &handle_, flags, nullptr);
  if (code == SQLITE_OK) {
    // A schema that somebody else has written may call nothing, and an ordinary statement may not change the schema's text.
    sqlite3_db_config(handle_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    if (stop_.stop_possible())
      sqlite3_progress_handler(handle_, kStepsBetweenLooks, &asked_to_stop, &stop_);
    return;
  }
  const int system = handle_ == nullptr ? 0 : sqlite3_system_errno(handle_);
  sqlite3_close(handle_);
  throw StoreError(path_ + ": " + reason(code, system, sqlite3_errstr(code)));
}

Connection::~Connection() { sqlite3_close(handle_); }

void Connection::fail(int code) const {
  if ((code & 0xff) == SQLITE_INTERRUPT) throw Interrupted();
  throw StoreError(path_ + ": " +
                   reason(code, sqlite3_system_errno(handle_), sqlite3_errmsg(handle_)));
}

void Connection::check(int code) const {
  if (code != SQLITE_OK) fail(code);
}

void Connection::execute(const std::string& sql) {
  check(sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr));
}

std::string Connection::text_of(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.step() ? std::string(statement.text(0)) : std::string();
}

std::int64_t Connection::number_of(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.step() ? statement.integer(0) : 0;
}

bool Connection::in_transaction() const { return sqlite3_get_autocommit(handle_) == 0; }

int Connection::changes() const { return sqlite3_changes(handle_); }

bool Connection::has_moved() const {
  int moved = 0;  // stays, for a database in memory
  sqlite3_file_control(handle_, "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  return moved != 0;
}

void Connection::abandon() {
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

Statement::Statement(Connection& connection, const std::string& sql) : connection_(connection) {
  connection_.check(sqlite3_prepare_v2(connection_.handle_, sql.c_str(),
                                       static_cast<int>(sql.size()), &handle_, nullptr));
}

Statement::~Statement() { sqlite3_finalize(handle_); }

void Statement::bind(int place, std::int64_t value) {
  connection_.check(sqlite3_bind_int64(handle_, place, value));
}

void Statement::bind(int place, double value) {
  connection_.check(sqlite3_bind_double(handle_, place, value));
}

void Statement::bind_text(int place, std::string_view text) {
  connection_.check(
      sqlite3_bind_text64(handle_, place, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8));
}

void Statement::bind_blob(int place, std::string_view bytes) {
  connection_.check(bytes.empty() ? sqlite3_bind_null(handle_, place)
                                  : sqlite3_bind_blob64(handle_, place, bytes.data(), bytes.size(),
                                                        SQLITE_STATIC));
}

bool Statement::step() {
  const int code = sqlite3_step(handle_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) {
    const int system = sqlite3_system_errno(connection_.handle_);
    const std::string text = sqlite3_errmsg(connection_.handle_);
    sqlite3_reset(handle_);
    if ((code & 0xff) == SQLITE_INTERRUPT) throw Interrupted();
    throw StoreError(connection_.path() + ": " + reason(code, system, text.c_str()));
  }
  return code == SQLITE_ROW;
}

void Statement::reset() { sqlite3_reset(handle_); }

void Statement::run() {
  step();
  reset();
}

// A value of another type than was written would be converted without a word, and a row that is not a number compares as larger
// than all numbers.
void Statement::require(int column, bool right, const char* type) const {
  if (right) return;
  throw StoreError(connection_.path() + ": is damaged: column " +
                   std::string(sqlite3_column_name(handle_, column)) +
                   " holds a value that is not " + type +
                   "; restore it from a copy, or run the study again with --fresh");
}

std::int64_t Statement::integer(int column) const {
  require(column, sqlite3_column_type(handle_, column) == SQLITE_INTEGER, "a whole number");
  return sqlite3_column_int64(handle_, column);
}

std::uint64_t Statement::count(int column) const {
  const std::int64_t value = integer(column);
  require(column, value >= 0, "a count");
  return static_cast<std::uint64_t>(value);
}

double Statement::real(int column) const {
  const int type = sqlite3_column_type(handle_, column);
  if (type == SQLITE_NULL) return std::numeric_limits<double>::quiet_NaN();
  require(column, type == SQLITE_FLOAT, "a number");
  return sqlite3_column_double(handle_, column);
}

std::string_view Statement::text(int column) const {
  const int type = sqlite3_column_type(handle_, column);
  require(column, type == SQLITE_TEXT || type == SQLITE_NULL, "a text");
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
  return text == nullptr
             ? std::string_view()
             : std::string_view(text,
                                static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)));
}

std::string_view Statement::blob(int column) const {
  const int type = sqlite3_column_type(handle_, column);
  require(column, type == SQLITE_BLOB || type == SQLITE_NULL, "a sequence of bytes");
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(handle_, column));
  return bytes == nullptr
             ? std::string_view()
             : std::string_view(bytes,
                                static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)));
}

std::string quoted_name(std::string_view name) {
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

}  // namespace twum::inline v0_1::io::sqlite
