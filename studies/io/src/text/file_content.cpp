// SPDX-License-Identifier: Apache-2.0
#include "text/file_content.hpp"

#include <twum/base/error.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace twum::inline v0_1::io {
namespace {

constexpr int kWriterWait =
    2000;  // [ms]: a program that is started together with this one has opened its pipe by then
constexpr int kWriterLook = 10;  // [ms]

[[noreturn]] void unreadable(const std::string& path, const std::string& why) {
  throw InputError(path + ": cannot be read: " + why);
}

// An open file; standard input stays open.
class Input {
 public:
  explicit Input(const std::string& path) : path_(path), standard_(path == "-") {
    descriptor_ =
        standard_ ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor_ < 0 || ::fstat(descriptor_, &state_) != 0)
      unreadable(path_, std::strerror(errno));
  }
  ~Input() {
    if (!standard_ && descriptor_ >= 0) ::close(descriptor_);
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  bool is(mode_t type) const { return (state_.st_mode & S_IFMT) == type; }

  std::string content(std::size_t most) {
    if (is(S_IFDIR)) unreadable(path_, "it is a directory");
    if (is(S_IFIFO) && !standard_) wait_for_writer();
    if (!standard_) ::fcntl(descriptor_, F_SETFL, ::fcntl(descriptor_, F_GETFL) & ~O_NONBLOCK);
    while (const std::size_t got = read()) {
      text_.append(buffer_.data(), got);
      if (text_.size() > most)
        unreadable(path_, "it is larger than " + std::to_string(most >> 20U) + " MiB");
    }
    return std::move(text_);
  }

 private:
  std::size_t read() {
    ssize_t got = 0;
    do got = ::read(descriptor_, buffer_.data(), buffer_.size());
    while (got < 0 && errno == EINTR);
    if (got < 0) unreadable(path_, std::strerror(errno));
    return static_cast<std::size_t>(got);
  }

  // Reading a pipe without a writer would take for ever. While nothing is waited for, read() fails with EAGAIN if there is a
  // writer, and returns nothing if there is none; poll() knows whether there has been one.
  void wait_for_writer() {
    for (int waited = 0; waited < kWriterWait; waited += kWriterLook) {
      const ssize_t got = ::read(descriptor_, buffer_.data(), buffer_.size());
      if (got > 0) text_.append(buffer_.data(), static_cast<std::size_t>(got));
      if (got > 0 || (got < 0 && errno == EAGAIN)) return;
      pollfd state{descriptor_, POLLIN, 0};
      if (::poll(&state, 1, kWriterLook) > 0) return;
    }
    unreadable(path_, "it is a pipe that no program writes to");
  }

  const std::string& path_;
  bool standard_;
  int descriptor_{-1};
  struct stat state_ {};
  std::string text_;
  std::array<char, 1 << 16> buffer_{};
};

}  // namespace

std::string file_content(const std::string& path, std::size_t most) {
  return Input(path).content(most);
}

std::string plain_file_content(const std::string& path, std::size_t most) {
  Input file(path);
  if (!file.is(S_IFREG)) unreadable(path, "it is not an ordinary file");
  return file.content(most);
}

}  // namespace twum::inline v0_1::io
