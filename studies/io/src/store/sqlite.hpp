// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

/// A thin layer over SQLite that turns every failure into a StoreError; internal.
namespace twum::inline v0_1::io::sqlite {

/// An open database. Not safe from several threads at a time.
class Connection {
 public:
  /// Opens a database file and creates it if `make` is true; ":memory:" has no file.
  /// @param stop  ends a statement within milliseconds; it then throws Interrupted
  Connection(std::string path, bool make, std::stop_token stop = {});
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const std::string& path() const noexcept { return path_; }
  void execute(const std::string& sql);
  /// The first value of the first row, as text; empty if there is none.
  std::string text_of(const std::string& sql);
  std::int64_t number_of(const std::string& sql);
  bool in_transaction() const;
  /// Rows that the last statement inserted.
  int changes() const;
  /// True if the file at its path was removed or replaced.
  bool has_moved() const;
  /// When the connection is closed, leaves all files unchanged, as if the process had been killed.
  void abandon();

  /// @throws StoreError with the file and the meaning of the result code, unless it means success.
  void check(int code) const;
  [[noreturn]] void fail(int code) const;

 private:
  friend class Statement;
  std::string path_;
  std::stop_token stop_;
  sqlite3* handle_{nullptr};
};

/// A prepared statement; numbers of parameters and columns count from 1 and 0, as in SQLite.
class Statement {
 public:
  Statement(Connection& connection, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  void bind(int place, std::int64_t value);
  void bind(int place, double value);  ///< NaN becomes NULL
  /// The text has to stay valid until step().
  void bind_text(int place, std::string_view text);
  void bind_blob(int place, std::string_view bytes);  ///< empty becomes NULL

  /// Goes to the next row; false after the last one.
  bool step();
  /// Ready for new values.
  void reset();
  /// step() of a statement without rows, then reset().
  void run();

  /// The values of a row. @throws StoreError if a value has another type
  std::int64_t integer(int column) const;
  std::uint64_t count(int column) const;  ///< of an integer that is not negative
  double real(int column) const;          ///< NULL becomes NaN
  std::string_view text(int column) const;
  std::string_view blob(int column) const;

 private:
  void require(int column, bool right, const char* type) const;

  Connection& connection_;
  sqlite3_stmt* handle_{nullptr};
};

/// A name in quotation marks, as SQL wants it.
std::string quoted_name(std::string_view name);

}  // namespace twum::inline v0_1::io::sqlite
