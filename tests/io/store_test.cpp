// SPDX-License-Identifier: Apache-2.0
#include <twum/io/result_store.hpp>

#include "support/scratch_folder.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

using namespace twum::io;
using twum::test::ScratchFolder;

namespace {

const std::vector<StoredColumn> kColumns{{"preload", "N"}, {"stall_torque", "N.m"}};

StoredRow row(std::uint64_t stage, std::uint64_t index, std::vector<double> values,
              const std::string& status = "ok", const std::string& detail = "") {
  StoredRow result;
  result.stage = stage;
  result.index = index;
  result.values = std::move(values);
  result.status = status;
  result.detail = detail;
  return result;
}

std::vector<StoredRow> all_rows(const ResultStore& store) {
  std::vector<StoredRow> rows;
  store.read([&](const StoredRow& one) { rows.push_back(one); });
  return rows;
}

void fill(const std::string& path, std::uint64_t count) {
  ResultStore store(path, kColumns);
  for (std::uint64_t i = 0; i < count; ++i)
    store.add(row(0, i, {static_cast<double>(i), 1.0 / (static_cast<double>(i) + 1)}));
}

std::string complaint_about(const std::string& path) {
  try {
    ResultStore store(path, kColumns);
    all_rows(store);
  } catch (const StoreError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("the store gives back every double to the bit", "[studies][store]") {
  const ScratchFolder folder;
  const double bits_of_many = std::bit_cast<double>(std::uint64_t{0x3fb999999999999a});
  const std::vector<double> values{0.0,
                                   -0.0,
                                   1.0,
                                   -3.0,
                                   bits_of_many,
                                   std::numeric_limits<double>::denorm_min(),
                                   -std::numeric_limits<double>::denorm_min(),
                                   std::numeric_limits<double>::min(),
                                   std::numeric_limits<double>::max(),
                                   std::numeric_limits<double>::lowest(),
                                   std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity(),
                                   9007199254740993.0,
                                   1e300};
  {
    ResultStore store(folder.path("results.db"), kColumns);
    for (std::size_t i = 0; i < values.size(); ++i) store.add(row(3, i, {values[i], std::nan("")}));
  }
  ResultStore store(folder.path("results.db"), kColumns);
  const std::vector<StoredRow> rows = all_rows(store);
  REQUIRE(rows.size() == values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    CAPTURE(values[i]);
    CHECK(std::bit_cast<std::uint64_t>(rows[i].values[0]) ==
          std::bit_cast<std::uint64_t>(values[i]));
    CHECK(std::isnan(rows[i].values[1]));
  }
}

TEST_CASE("the store gives back texts and bytes as they were", "[studies][store]") {
  const ScratchFolder folder;
  const std::string bytes("\0\1\xff'\"\n", 6);
  const std::string status = "stall_torque: no-periodic-state; \"quoted\", 'single', \xc2\xb5";
  {
    ResultStore store(folder.path("results.db"), kColumns);
    store.add(row(0, 0, {1}, status, bytes));  // the second column gets no value
    store.set_fact("hash", "12ab");
    CHECK(store.fact("hash") == "12ab");
  }
  ResultStore store(folder.path("results.db"), kColumns);
  const StoredRow stored = all_rows(store).at(0);
  CHECK(stored.status == status);
  CHECK(stored.detail == bytes);
  CHECK(stored.values[0] == 1);
  CHECK(std::isnan(stored.values[1]));
  CHECK(store.fact("hash") == "12ab");
  CHECK(store.fact("nothing").empty());
}

TEST_CASE("rows come in the order of stage and index, however they were added",
          "[studies][store]") {
  ResultStore store(":memory:", kColumns);
  store.add(row(2, 1, {21}));
  store.add(row(0, 700, {700}));
  store.add(row(2, 0, {20}));
  store.add(row(0, 1, {1}));
  std::vector<double> seen;
  store.read([&](const StoredRow& one) { seen.push_back(one.values[0]); });
  CHECK(seen == std::vector<double>{1, 700, 20, 21});
  seen.clear();
  store.read(2, [&](const StoredRow& one) { seen.push_back(one.values[0]); });
  CHECK(seen == std::vector<double>{20, 21});
}

TEST_CASE("a row that is there stays as it is", "[studies][store]") {
  ResultStore store(":memory:", kColumns);
  store.add(row(0, 0, {1}));
  store.add(row(0, 0, {2}));
  CHECK(store.rows() == 1);
  CHECK(all_rows(store).at(0).values[0] == 1);
}

TEST_CASE("the next index is the first gap", "[studies][store]") {
  ResultStore store(":memory:", kColumns);
  CHECK(store.next_index(0) == 0);
  store.add(row(0, 1, {1}));
  CHECK(store.next_index(0) == 0);
  store.add(row(0, 0, {0}));
  CHECK(store.next_index(0) == 2);
  store.add(row(0, 3, {3}));
  CHECK(store.next_index(0) == 2);
  store.add(row(0, 2, {2}));
  CHECK(store.next_index(0) == 4);
  CHECK(store.next_index(1) == 0);
}

TEST_CASE("columns may have names that differ in capitals only", "[studies][store]") {
  const ScratchFolder folder;
  const std::vector<StoredColumn> columns{{"A", "m"}, {"a", "m"}, {"A", "m"}, {"status", "1"}};
  {
    ResultStore store(folder.path("results.db"), columns);
    store.add(row(0, 0, {1, 2, 3, 4}));
  }
  ResultStore store(folder.path("results.db"));
  REQUIRE(store.columns().size() == 4);
  CHECK(store.columns()[1].name == "a");
  CHECK(store.columns()[3].unit == "1");
  CHECK(all_rows(store).at(0).values == std::vector<double>{1, 2, 3, 4});
}

TEST_CASE("rows added from several threads are all there", "[studies][store]") {
  ResultStore store(":memory:", kColumns);
  std::vector<std::thread> threads;
  for (std::uint64_t t = 0; t < 4; ++t) {
    threads.emplace_back([&store, t] {
      for (std::uint64_t i = 0; i < 1000; ++i) store.add(row(t, i, {static_cast<double>(i)}));
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(store.rows() == 4000);
  for (std::uint64_t t = 0; t < 4; ++t) CHECK(store.next_index(t) == 1000);
}

TEST_CASE("a lone row reaches the file by itself", "[studies][store]") {
  const ScratchFolder folder;
  ResultStore store(folder.path("results.db"), kColumns);
  store.add(row(0, 0, {1}));
  // A second connection sees what is committed and nothing else. The batch lasts 0.2 s; fifty times
  // that is for a machine that is busy with other things.
  std::uint64_t rows = 0;
  for (int i = 0; i < 1000 && rows == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    rows = ResultStore(folder.path("results.db")).rows();
  }
  CHECK(rows == 1);
}

TEST_CASE("a database of other columns is refused", "[studies][store]") {
  const ScratchFolder folder;
  const std::string path = folder.path("results.db");
  fill(path, 3);
  CHECK_THROWS_WITH(ResultStore(path, {{"preload", "N"}}),
                    Catch::Contains(path) && Catch::Contains("other columns"));
  CHECK_THROWS_WITH(ResultStore(path, {{"preload", "N"}, {"stall_torque", "1"}}),
                    Catch::Contains("other columns"));
}

TEST_CASE("what cannot be opened is named with the reason", "[studies][store]") {
  const ScratchFolder folder;
  const std::string nowhere = folder.path("no/such/folder/results.db");
  CHECK_THROWS_WITH(ResultStore(nowhere, kColumns),
                    Catch::Contains(nowhere) && Catch::Contains("No such file or directory"));
  CHECK_THROWS_AS(ResultStore(folder.path("absent.db")), StoreError);
  const std::string text = folder.path("text.db");
  std::ofstream(text) << std::string(5000, 'x');
  CHECK_THROWS_WITH(ResultStore(text, kColumns),
                    Catch::Contains(text) && Catch::Contains("no SQLite database"));
}

TEST_CASE("a truncated database is an error wherever it was cut", "[studies][store]") {
  const ScratchFolder folder;
  const std::string path = folder.path("results.db");
  fill(path, 3000);
  const auto size = std::filesystem::file_size(path);
  for (const double part : {0.9, 0.7, 0.5, 0.3, 0.1}) {
    std::filesystem::resize_file(path,
                                 static_cast<std::uintmax_t>(part * static_cast<double>(size)));
    CAPTURE(part);
    const std::string complaint = complaint_about(path);
    CHECK_THAT(complaint, Catch::Contains(path) && Catch::Contains("damaged"));
  }
}

TEST_CASE("a flipped bit is never read as a number", "[studies][store]") {
  const ScratchFolder folder;
  const std::string path = folder.path("results.db");
  fill(path, 2000);
  std::vector<StoredRow> rows;
  {
    ResultStore store(path, kColumns);
    rows = all_rows(store);
  }
  const auto size = std::filesystem::file_size(path);
  std::size_t noticed = 0;
  // Places spread over the file; 7919 is prime, so they fall everywhere within a page.
  for (std::uintmax_t place = 50; place < size; place += 7919) {
    const std::string copy = folder.path("copy.db");
    std::filesystem::copy_file(path, copy, std::filesystem::copy_options::overwrite_existing);
    std::fstream file(copy, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(place));
    const char byte = static_cast<char>(file.get() ^ 0x10);
    file.seekp(static_cast<std::streamoff>(place));
    file.put(byte);
    file.close();
    CAPTURE(place);
    try {
      // Either the bit is in no row, and all rows are what they were, or it is noticed.
      const ResultStore store(copy, kColumns);
      const std::vector<StoredRow> found = all_rows(store);
      REQUIRE(found.size() == rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i) REQUIRE(found[i].values == rows[i].values);
    } catch (const StoreError& error) {
      ++noticed;
      CHECK_THAT(error.what(), Catch::StartsWith(copy + ": "));
    }
  }
  CHECK(noticed > 0);
}

TEST_CASE("a page in the place of another is damage", "[studies][store]") {
  const ScratchFolder folder;
  const std::string path = folder.path("results.db");
  fill(path, 2000);
  constexpr std::streamoff kPage = 4096;  // bytes, the default of SQLite
  const auto read_page = [](std::fstream& file, std::streamoff number) {
    std::string page(kPage, '\0');
    file.seekg(number * kPage);
    file.read(page.data(), kPage);
    return page;
  };
  const auto write_page = [](std::fstream& file, std::streamoff number, const std::string& page) {
    file.seekp(number * kPage);
    file.write(page.data(), kPage);
  };
  const auto pages = static_cast<std::streamoff>(std::filesystem::file_size(path)) / kPage;
  REQUIRE(pages > 20);  // leaves of rows from the tenth on: each holds about 60 of the 2000
  const auto from = GENERATE(10, 15);
  const auto to = GENERATE(11, 19);
  const bool both_ways = GENERATE(false, true);
  CAPTURE(from, to, both_ways);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  const std::string one = read_page(file, from);
  const std::string other = read_page(file, to);
  write_page(file, to, one);
  if (both_ways) write_page(file, from, other);
  file.close();
  CHECK_THAT(complaint_about(path), Catch::StartsWith(path + ": is damaged"));
}

TEST_CASE("facts and rows added in any order have one seal", "[studies][store]") {
  const ScratchFolder folder;
  const std::string path = folder.path("results.db");
  {
    ResultStore store(path, kColumns);
    store.set_fact("seconds", "1");
    store.add(row(1, 5, {1, 2}));
    store.set_fact("seconds", "2");
    store.add(row(0, 7, {3, 4}));
    store.add(row(1, 5, {9, 9}));  // it is there already
    store.set_fact("seconds", "2");
  }
  const ResultStore store(path);
  CHECK(store.rows() == 2);
  CHECK(store.fact("seconds") == "2");
}

TEST_CASE("a page of rows may be read while others are added", "[studies][store]") {
  ResultStore store(":memory:", kColumns);
  for (std::uint64_t i = 0; i < 2000; ++i) store.add(row(0, i, {1}));
  std::uint64_t seen = 0;
  store.read(0, [&](const StoredRow& one) {
    ++seen;
    store.add(row(1, one.index, {2}));
  });
  CHECK(seen == 2000);
  CHECK(store.next_index(1) == 2000);
}
