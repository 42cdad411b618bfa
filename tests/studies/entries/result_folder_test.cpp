// SPDX-License-Identifier: Apache-2.0
// A directory of results: whose it is, and what cannot be written there.
#include "stored/result_folder.hpp"
#include "entries_support.hpp"

#include <twum/base/error.hpp>
#include <twum/io/result_store.hpp>

#include <sys/resource.h>
#include <catch2/catch.hpp>

#include <csignal>
#include <filesystem>
#include <string>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

namespace fs = std::filesystem;

// Makes it a directory of ours.
void make_database(const std::string& folder) {
  const ResultStore store((fs::path(folder) / ResultFolder::kDatabase).string(), {{"x", "1"}});
}

}  // namespace

TEST_CASE("a directory is made with those above it, and a file is none", "[studies][run]") {
  const ScratchFolder folder;
  { const ResultFolder results(folder.path("a/b/c")); }
  CHECK(fs::is_directory(folder.path("a/b/c")));
  write(folder.path("file"), "x");
  CHECK_THROWS_WITH(ResultFolder(folder.path("file")),
                    StartsWith(folder.path("file") + ": cannot be "));
  CHECK_THROWS_WITH(ResultFolder(folder.path("file/below")),
                    Contains("cannot be created as a directory: Not a directory"));
}

TEST_CASE("one directory is for one run at a time", "[studies][run]") {
  const ScratchFolder folder;
  {
    const ResultFolder first(folder.path("out"));
    CHECK_THROWS_WITH(ResultFolder(folder.path("out")),
                      Contains("another twum process is using this directory"));
  }
  CHECK_NOTHROW(ResultFolder(folder.path("out")));
}

TEST_CASE("files that are not known as results are left alone", "[studies][run]") {
  const ScratchFolder folder;
  const ResultFolder results(folder.folder());
  CHECK_NOTHROW(results.check_ours());
  const std::string name =
      GENERATE("study.yaml", "results.csv", "summary.json", "report.html", "best.yaml",
               "fitted.yaml", "front/07.yaml", "front/007.yaml.part");
  fs::create_directory(folder.path("front"));
  write(folder.path(name), "somebody's");
  CHECK_THROWS_WITH(results.check_ours(), Contains(folder.path(name)) &&
                                              Contains("is not a result of twum") &&
                                              Contains("there is no results.db with it"));
  CHECK_THROWS_AS(results.discard(), InputError);
  CHECK(content(folder.path(name)) == "somebody's");
}

TEST_CASE("a database of another program and a file called front are refused", "[studies][run]") {
  const ScratchFolder folder;
  const ResultFolder results(folder.folder());
  const auto complaint = Contains("exists already and is not a result of twum; choose");
  SECTION("a short file") { write(folder.path("results.db"), "mine"); }
  SECTION("an SQLite file without our mark") {
    write(folder.path("results.db"), "SQLite format 3" + std::string(200, '\0'));
  }
  SECTION("a long file") { write(folder.path("results.db"), std::string(200, 'x')); }
  SECTION("front") {
    make_database(folder.folder());
    write(folder.path("front"), "mine");
  }
  CHECK_THROWS_WITH(results.check_ours(), complaint);
}

TEST_CASE("to discard results removes what is ours and nothing else", "[studies][run]") {
  const ScratchFolder folder;
  const ResultFolder results(folder.folder());
  make_database(folder.folder());
  fs::create_directory(folder.path("front"));
  for (const char* name : {"summary.json", "results.csv.part", "results.db-wal", "best.yaml",
                           "front/01.yaml", "front/002.yaml.part"})
    write(folder.path(name), "ours");
  const std::vector<std::string> foreign{"notes.txt",      "front/notes.yaml", "front/01.yml",
                                         "front/01.yaml2", "front/12",         "front/.yaml"};
  for (const std::string& name : foreign) write(folder.path(name), "theirs");
  results.discard();
  for (const std::string& name : foreign) CHECK(content(folder.path(name)) == "theirs");
  std::size_t left = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.folder()))
    left += entry.is_regular_file() ? 1 : 0;
  CHECK(left == foreign.size());

  // With nothing of others in it the folder of the front goes too.
  make_database(folder.folder());
  for (const std::string& name : foreign) fs::remove(folder.path(name));
  write(folder.path("front/01.yaml"), "ours");
  results.discard();
  CHECK_FALSE(fs::exists(folder.path("front")));
}

TEST_CASE("what cannot be removed is named with the reason", "[studies][run]") {
  const ScratchFolder folder;
  const ResultFolder results(folder.folder());
  make_database(folder.folder());
  SECTION("a directory in place of a result") {
    fs::create_directories(folder.path("summary.json/full"));
    CHECK_THROWS_WITH(results.discard(),
                      folder.path("summary.json") + ": cannot be removed: Directory not empty");
  }
  SECTION("a directory in place of a point of the front") {
    fs::create_directories(folder.path("front/01.yaml/full"));
    CHECK_THROWS_WITH(results.discard(),
                      folder.path("front/01.yaml") + ": cannot be removed: Directory not empty");
  }
  CHECK(results.has_database());  // it goes last, so that the others are still known as ours
}

TEST_CASE("a file appears whole or not at all", "[studies][run]") {
  const ScratchFolder folder;
  ResultFolder results(folder.folder());
  results.write("summary.json", std::string("{}"));
  CHECK(content(folder.path("summary.json")) == "{}");
  CHECK_FALSE(results.has("summary.json.part"));
  results.write("front/01.yaml", std::string("twum: 1\n"));
  CHECK(results.has("front/01.yaml"));

  fs::create_directories(folder.path("report.html/full"));
  CHECK_THROWS_WITH(results.write("report.html", std::string("x")),
                    folder.path("report.html") + ": cannot be written: Is a directory");
  CHECK_FALSE(results.has("report.html.part"));
  fs::create_directory(folder.path("best.yaml.part"));
  CHECK_THROWS_WITH(results.write("best.yaml", std::string("x")),
                    folder.path("best.yaml") + ": cannot be written: Is a directory");
}

namespace {

// While it lives no file may have more than four bytes: a write then fails as on a full disk.
class SmallestFiles {
 public:
  SmallestFiles() {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{4, before_.rlim_max};
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallestFiles() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallestFiles(const SmallestFiles&) = delete;
  SmallestFiles& operator=(const SmallestFiles&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace

TEST_CASE("a full disk leaves what was there before", "[studies][run]") {
  const ScratchFolder folder;
  ResultFolder results(folder.folder());
  results.write("summary.json", std::string("before"));
  const SmallestFiles limit;
  const std::size_t size =
      GENERATE(std::size_t{10}, std::size_t{1000000});  // less and more than is kept in memory
  CHECK_THROWS_WITH(results.write("summary.json", std::string(size, 'x')),
                    folder.path("summary.json") + ": cannot be written: File too large");
  CHECK(content(folder.path("summary.json")) == "before");
  CHECK_FALSE(fs::exists(fs::symlink_status(folder.path("summary.json.part"))));
}

TEST_CASE("what was written has to be there in the end", "[studies][run]") {
  const ScratchFolder folder;
  const std::string out = folder.path("out");
  ResultFolder results(out);
  results.write("summary.json", std::string("{}"));
  results.write("summary.json", std::string("[1]"));  // the last one counts
  CHECK_NOTHROW(results.check_in_place());
  SECTION("a file that is gone") {
    fs::remove(out + "/summary.json");
    CHECK_THROWS_WITH(results.check_in_place(),
                      out +
                          "/summary.json: was written, but cannot be read back: No such file or "
                          "directory");
  }
  SECTION("a file of another size") {
    write(out + "/summary.json", "{}");
    CHECK_THROWS_WITH(results.check_in_place(), Contains("2 bytes instead of 3"));
  }
  SECTION("a directory that is gone or another one") {
    fs::rename(out, folder.path("moved"));
    if (GENERATE(false, true)) fs::create_directory(out);
    CHECK_THROWS_WITH(results.check_in_place(), StartsWith(out + ": was moved, replaced"));
    CHECK_THROWS_AS(results.write("report.html", std::string("x")), StoreError);
    CHECK_FALSE(fs::exists(out + "/report.html"));
  }
}

TEST_CASE("an empty database is begun anew only where nothing was stored", "[studies][run]") {
  const ScratchFolder folder;
  const ResultFolder results(folder.folder());
  CHECK_NOTHROW(results.check_not_emptied());
  write(folder.path("results.db"), "");
  CHECK_NOTHROW(results.check_not_emptied());  // a run that was killed before its first byte
  write(folder.path("study.yaml"), "twum: 1\n");
  CHECK_THROWS_WITH(results.check_not_emptied(),
                    StartsWith(folder.path("results.db") + ": is empty") && Contains("--fresh"));
}
