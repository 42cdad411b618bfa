// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace twum::inline v0_1::studies {

/// The directory of a study's results, locked by one process at a time.
class ResultFolder {
 public:
  /// Creates the directory if necessary, and locks it.
  /// @throws StoreError if it cannot be created, or if another process has locked it
  explicit ResultFolder(std::string path);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  std::string file(std::string_view name) const;
  bool has(std::string_view name) const;
  bool has_database() const { return has(kDatabase); }
  /// @throws StoreError if its database is empty although a study had begun, which is damage
  void check_not_emptied() const;

  /// @throws InputError if there are files named like results, but no database of twum: they must not be overwritten.
  ///         Also if there is a file where the folder of a front has to be.
  void check_ours() const;
  /// Removes the results, and nothing else.
  void discard() const;

  /// Writes a file completely or not at all: writes a temporary file and renames it.
  /// @param fill  passes on the content piece by piece
  /// @throws StoreError naming the file and the reason
  void write(std::string_view name,
             const std::function<void(const std::function<void(std::string_view)>&)>& fill);
  void write(std::string_view name, const std::string& content);

  /// @throws StoreError if the directory was moved, or if a file that was written is missing or has another size
  void check_in_place() const;

  static constexpr std::string_view kDatabase = "results.db";
  static constexpr std::string_view kStudy = "study.yaml";
  static constexpr std::string_view kTable = "results.csv";
  static constexpr std::string_view kMotion = "motion.csv";  // the table of a motion again
  static constexpr std::string_view kSummary = "summary.json";
  static constexpr std::string_view kReport = "report.html";

 private:
  void discard_numbered() const;
  void discard_copies() const;
  void check_held() const;

  std::string path_;
  int lock_{-1};
  std::map<std::string, std::uintmax_t> written_;  // sizes, by path [bytes]
};

}  // namespace twum::inline v0_1::studies
