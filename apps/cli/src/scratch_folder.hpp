// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace twum::inline v0_1::cli {

/// A private folder among the temporary files, removed with all that is in it.
class ScratchFolder {
 public:
  /// @param user  who needs it, for the message
  /// @throws OutputError if it cannot be made
  explicit ScratchFolder(const std::string& user);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace twum::inline v0_1::cli
