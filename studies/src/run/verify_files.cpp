// SPDX-License-Identifier: Apache-2.0
#include "entries/resolved_study.hpp"
#include "kinds/sample/found_motors.hpp"
#include "results/row_pass.hpp"
#include "run/verify_checks.hpp"

#include <twum/base/error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

using Json = nlohmann::ordered_json;

// Compares a file with a text that comes in pieces.
class TextComparison {
 public:
  explicit TextComparison(const std::string& path) : file_(path, std::ios::binary) {}

  void see(std::string_view piece) {
    buffer_.resize(piece.size());
    file_.read(buffer_.data(), static_cast<std::streamsize>(piece.size()));
    const auto got = static_cast<std::size_t>(file_.gcount());
    same_ = same_ && got == piece.size() && std::equal(piece.begin(), piece.end(), buffer_.begin());
  }

  bool same() { return same_ && file_.peek() == std::ifstream::traits_type::eof(); }

 private:
  std::ifstream file_;
  std::vector<char> buffer_;
  bool same_{true};
};

void compare_motor(const MotorDesign& there, const FoundMotor& now, Verification& found) {
  for (const ParameterInfo& row : parameter_table()) {
    if (!is_given(now.motor.design, row.parameter)) continue;
    const double value = get(now.motor.design, row.parameter);
    if (note_deviation(found, get(there, row.parameter), value)) continue;
    complain(found, now.file + ": " + std::string(row.name) + " is not that of the " + now.what);
  }
}

}  // namespace

FailureCount verify_table(const StudyKindRun& kind, const ResultStore& store,
                          const std::string& path, Verification& found) {
  TextComparison table(path);
  FailureCount failures = write_rows(store, kind.columns(), kind.variables(),
                                     [&](std::string_view piece) { table.see(piece); });
  if (!table.same())
    complain(found,
             std::filesystem::path(path).filename().string() + ": is not what results.db holds");
  return failures;
}

void verify_study_hash(const StudyFile& file, const Json& summary, Verification& found) {
  const std::string there = summary.value("hash", "");
  const std::string now = resolve(file).hash();
  if (there == now) return;
  complain(found,
           "study.yaml: is not the study that was run, or a file that it names has changed: "
           "its hash is " +
               now + ", in summary.json " + studies::quoted(there));
}

void verify_motor_files(const StudyFile& file, const StudyResult& result,
                        const std::string& directory, Verification& found) {
  for (const FoundMotor& now : found_motors(file, result)) {
    try {
      const std::string path = (std::filesystem::path(directory) / now.file).string();
      compare_motor(read_motor_file(path).design, now, found);
    } catch (const InputError& error) {  // the file is missing or no longer a valid motor file
      complain(found, now.file + ": " + error.what());
    }
  }
}

}  // namespace twum::inline v0_1::studies
