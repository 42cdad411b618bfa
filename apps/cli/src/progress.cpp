// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace twum::cli {
namespace {

bool dumb_terminal() {
  const char* terminal = std::getenv("TERM");
  return terminal == nullptr || std::string(terminal) == "dumb";
}

}  // namespace

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0), begin_(Clock::now()), last_(begin_) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::size_t done, double fraction, const std::string& best) {
  const auto now = Clock::now();
  if (!counting_) {
    counting_ = true;
    done_before_ = done;
    fraction_before_ = fraction;
  }
  if (!terminal_ || dumb_terminal() || now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  shown_ = true;
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  const double rate = static_cast<double>(done - std::min(done, done_before_)) / seconds;
  std::string more;
  if (fraction > fraction_before_ && fraction <= 1) {
    const double left = seconds * (1 - fraction) / (fraction - fraction_before_);
    more = ", " + duration_text(left) + " left";
  }
  if (!best.empty()) more += ", best so far: " + best;
  std::fprintf(stderr, "\r\033[K%zu evaluations, %.0f/s%s", done, rate, more.c_str());
  std::fflush(stderr);
}

bool may_colour_errors() {
  const char* no_color = std::getenv("NO_COLOR");
  return (no_color == nullptr || *no_color == '\0') && isatty(STDERR_FILENO) != 0 &&
         !dumb_terminal();
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) return std::to_string(whole) + " s";
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + " min " + (rest.size() < 2 ? "0" : "") + rest + " s";
}

}  // namespace twum::cli
