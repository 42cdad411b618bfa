// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace twum::studies {

/// The directory that a study's results are in, held by one process at a time.
class ResultFolder {
 public:
  /// Makes the directory if there is none, and takes it.
  /// @throws StoreError if it cannot be made or another process has it
  explicit ResultFolder(std::string path);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  std::string file(std::string_view name) const;
  bool has(std::string_view name) const;
  bool has_database() const { return has(kDatabase); }
  /// @throws StoreError if its database is empty although a study had begun: nobody made it so on purpose
  void check_not_emptied() const;

  /// @throws InputError if there are files named like results, those of a front included, but no
  ///         database of ours with them: they are someone else's, and nothing may write over them;
  ///         or a file where the folder of a front has to be.
  void check_ours() const;
  /// Removes the results, and nothing else.
  void discard() const;

  /// Writes a file whole or not at all: beside its place, then to it.
  /// @param fill  hands over the content piece by piece
  /// @throws StoreError naming the file and the reason
  void write(std::string_view name,
             const std::function<void(const std::function<void(std::string_view)>&)>& fill);
  void write(std::string_view name, const std::string& content);

  /// @throws StoreError if its path leads elsewhere by now, or a file that was written is gone or has
  ///         another size
  void check_in_place() const;

  static constexpr std::string_view kDatabase = "results.db";
  static constexpr std::string_view kStudy = "study.yaml";
  static constexpr std::string_view kTable = "results.csv";
  static constexpr std::string_view kSummary = "summary.json";
  static constexpr std::string_view kReport = "report.html";

 private:
  void discard_numbered() const;
  void check_held() const;

  std::string path_;
  int lock_{-1};
  std::map<std::string, std::uintmax_t> written_;  // sizes, by path [bytes]
};

}  // namespace twum::studies
