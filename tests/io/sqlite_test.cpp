// SPDX-License-Identifier: Apache-2.0
// What the store says when SQLite says no, and what it does with a failure.
#include "store/sqlite.hpp"
#include "support/file_text.hpp"
#include "support/scratch_folder.hpp"

#include <twum/io/result_store.hpp>

#include <catch2/catch.hpp>

#include <sqlite3.h>

#include <cmath>
#include <string>

using namespace twum;
using namespace twum::io;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const std::vector<StoredColumn> kColumns{{"preload", "N"}};

std::string said(int code) {
  sqlite::Connection connection(":memory:", true);
  try {
    connection.fail(code);
  } catch (const StoreError& error) {
    return error.what();
  }
  return {};
}

std::string complaint_of(ResultStore& store, std::uint64_t index) {
  try {
    store.add({0, index, {1}});
  } catch (const StoreError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("every result code is a sentence about the file", "[studies][store]") {
  CHECK(said(SQLITE_FULL) ==
        ":memory:: cannot be written: the disk is full; what was stored before is kept, make room "
        "and run it again");
  CHECK(said(SQLITE_CANTOPEN) == ":memory:: cannot be opened");
  CHECK_THAT(said(SQLITE_READONLY), Contains("no permission, or a read-only folder"));
  CHECK(said(SQLITE_PERM) == ":memory:: cannot be opened: no permission");
  CHECK_THAT(said(SQLITE_BUSY), Contains("is in use by another program"));
  CHECK(said(SQLITE_LOCKED) == said(SQLITE_BUSY));
  CHECK_THAT(said(SQLITE_NOTADB), Contains("no SQLite database"));
  CHECK(said(SQLITE_CORRUPT) == ":memory:: is damaged");
  CHECK(said(SQLITE_IOERR) == ":memory:: cannot be read or written");
  CHECK_THAT(said(SQLITE_NOMEM), Contains("needs more memory than there is"));
  CHECK_THAT(said(SQLITE_MISUSE), StartsWith(":memory:: SQLite says: "));
  // The low byte decides; the rest is detail.
  CHECK(said(SQLITE_READONLY_ROLLBACK) == said(SQLITE_READONLY));
}

TEST_CASE("a statement that cannot be done is an error, and the next one works",
          "[studies][store]") {
  sqlite::Connection connection(":memory:", true);
  connection.execute("CREATE TABLE t (a INTEGER PRIMARY KEY)");
  sqlite::Statement insert(connection, "INSERT INTO t VALUES (?)");
  insert.bind(1, std::int64_t{7});
  insert.run();
  insert.bind(1, std::int64_t{7});
  CHECK_THROWS_WITH(insert.run(), Contains("SQLite says: UNIQUE constraint failed: t.a"));
  insert.bind(1, std::int64_t{8});
  insert.run();
  CHECK(connection.number_of("SELECT count(*) FROM t") == 2);
  CHECK_THROWS_AS(insert.bind(2, 1.0), StoreError);  // there is no second place
  CHECK_THROWS_WITH(connection.execute("SELEKT"), Contains("syntax error"));
}

TEST_CASE("nothing asked for is nothing", "[studies][store]") {
  sqlite::Connection connection(":memory:", true);
  connection.execute("CREATE TABLE t (a, b)");
  CHECK(connection.text_of("SELECT a FROM t").empty());
  CHECK(connection.number_of("SELECT a FROM t") == 0);
  connection.execute("INSERT INTO t VALUES (NULL, 'word')");
  CHECK(connection.text_of("SELECT b FROM t") == "word");
  sqlite::Statement select(connection, "SELECT a FROM t");
  REQUIRE(select.step());
  CHECK(select.text(0).empty());
  CHECK(select.blob(0).empty());
  CHECK(std::isnan(select.real(0)));
  CHECK_FALSE(select.step());
}

TEST_CASE("a name is quoted as SQL wants it", "[studies][store]") {
  CHECK(sqlite::quoted_name("stall_torque [N.m]") == "\"stall_torque [N.m]\"");
  CHECK(sqlite::quoted_name("a\"b") == "\"a\"\"b\"");
  sqlite::Connection connection(":memory:", true);
  connection.execute("CREATE TABLE t (" + sqlite::quoted_name("a\"b") + ")");
  CHECK(connection.text_of("SELECT name FROM pragma_table_info('t')") == "a\"b");
}

TEST_CASE("a database of something else and one of another version are told apart",
          "[studies][store]") {
  const ScratchFolder folder;
  const std::string path = folder.path("results.db");
  { const ResultStore store(path, kColumns); }
  const auto set = [&](const std::string& pragma) {
    sqlite::Connection(path, false).execute("PRAGMA " + pragma);
  };
  set("user_version = 77");
  CHECK_THROWS_WITH(ResultStore(path, kColumns),
                    StartsWith(path + ": was written by another version of twum"));
  CHECK_THROWS_AS(ResultStore(path), StoreError);
  set("application_id = 5");
  CHECK_THROWS_WITH(ResultStore(path), path + ": is a database of something else, not of twum");
}

TEST_CASE("columns of other names are those of another study", "[studies][store]") {
  const ScratchFolder folder;
  const std::string path = folder.path("results.db");
  { const ResultStore store(path, kColumns); }
  for (const std::vector<StoredColumn>& other : {std::vector<StoredColumn>{{"prelaod", "N"}},
                                                 {{"preload", "m"}},
                                                 {},
                                                 {{"preload", "N"}, {"x", "1"}}})
    CHECK_THROWS_WITH(ResultStore(path, other), Contains("with other columns"));
  CHECK_NOTHROW(ResultStore(path, kColumns));
}

TEST_CASE("a row that is missing and a fact that was changed are damage", "[studies][store]") {
  const ScratchFolder folder;
  const std::string path = folder.path("results.db");
  {
    ResultStore store(path, kColumns);
    for (std::uint64_t i = 0; i < 100; ++i) store.add({0, i, {1}});
    store.set_fact("hash", "12ab");
  }
  CHECK(ResultStore(path).rows() == 100);
  // Another program may change the content and leave every page intact.
  const std::string change =
      GENERATE("DELETE FROM evaluations WHERE \"index\" = 99", "UPDATE facts SET value = '12ac'",
               "DELETE FROM facts", "UPDATE columns SET unit = 'kN'", "DELETE FROM seal");
  CAPTURE(change);
  sqlite::Connection(path, false).execute(change);
  CHECK_THROWS_WITH(ResultStore(path), StartsWith(path + ": is damaged") && Contains("--fresh"));
}

TEST_CASE("what could not be stored fails again, and nothing is stored after it",
          "[studies][store]") {
  const ScratchFolder folder;
  const std::string path = folder.path("results.db");
  ResultStore store(path, kColumns);
  store.add({0, 0, {1}});
  store.flush();
  sqlite::Connection(path, false).execute("DROP TABLE evaluations");
  const std::string first = complaint_of(store, 1);
  CHECK_THAT(first, StartsWith(path + ": ") && Contains("no such table: evaluations"));
  CHECK(complaint_of(store, 2) == first);
  CHECK_THROWS_WITH(store.flush(), first);
}

TEST_CASE("rows of many batches are all there", "[studies][store]") {
  // A batch ends at 20000 rows, or after 0.2 s.
  const ScratchFolder folder;
  constexpr std::uint64_t kCount = 45000;
  {
    ResultStore store(folder.path("results.db"), kColumns);
    for (std::uint64_t i = 0; i < kCount; ++i) store.add({0, i, {static_cast<double>(i)}});
  }
  const ResultStore store(folder.path("results.db"));
  CHECK(store.rows() == kCount);
  double sum = 0;
  store.read([&](const StoredRow& row) { sum += row.values[0]; });
  CHECK(sum ==
        0.5 * static_cast<double>(kCount) * static_cast<double>(kCount - 1));  // of 0 to n - 1
}
