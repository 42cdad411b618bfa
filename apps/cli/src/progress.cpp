// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include "terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

std::string bar_text(const ProgressState& now) {
  constexpr std::size_t kCells = 10;
  const auto full = static_cast<std::size_t>(std::lround(kCells * now.fraction));
  return "[" + std::string(full, '#') + std::string(kCells - full, '-') + "] " +
         std::to_string(static_cast<int>(100 * now.fraction)) + " %" +
         (now.budget ? " of the budget" : "");
}

// A part of the progress line. If the line is too long, the part with the highest rank is dropped first.
struct Part {
  int rank;
  std::string text;
};

std::string joined(const std::vector<Part>& parts) {
  std::string text;
  for (const Part& part : parts) text += (text.empty() ? "" : ", ") + part.text;
  return text;
}

std::string fitting(std::vector<Part> parts, std::size_t width) {
  while (parts.size() > 1 && joined(parts).size() > width)
    parts.erase(std::max_element(parts.begin(), parts.end(),
                                 [](const Part& a, const Part& b) { return a.rank < b.rank; }));
  return joined(parts).substr(0, width);
}

}  // namespace

Progress::Progress() : begin_(Clock::now()), last_(begin_) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(const ProgressState& now) {
  const auto time = Clock::now();
  // A round that begins has its own rate and its own share of a budget.
  const bool anew = now.fraction < fraction_last_;
  if (anew) begin_ = time;
  if (anew || !counting_) {
    counting_ = true;
    done_before_ = now.done;
    fraction_before_ = now.fraction;
  }
  fraction_last_ = now.fraction;
  if (time - last_ < std::chrono::milliseconds(200) || dumb_terminal()) return;
  const std::optional<std::size_t> width = terminal_width(STDERR_FILENO);
  if (!width) return;
  last_ = time;
  shown_ = true;
  const double seconds = std::max(std::chrono::duration<double>(time - begin_).count(), 0.2);
  // The last column stays free, because some terminals wrap the line after it.
  std::fprintf(stderr, "\r\033[K%s", line(now, seconds, *width - 1).c_str());
  std::fflush(stderr);
}

std::string Progress::line(const ProgressState& now, double seconds, std::size_t width) const {
  std::vector<Part> parts;
  const bool known = now.fraction > 0 && now.fraction <= 1;
  if (known) parts.push_back({0, bar_text(now)});
  parts.push_back({known ? 3 : 0, std::to_string(now.done) + " evaluations"});
  const double rate = static_cast<double>(now.done - std::min(now.done, done_before_)) / seconds;
  parts.push_back({5, std::to_string(std::lround(rate)) + "/s"});
  if (known && now.fraction > fraction_before_) {
    const double left = seconds * (1 - now.fraction) / (now.fraction - fraction_before_);
    parts.push_back({2, (now.budget ? "at most " : "") + duration_text(left) + " left"});
  }
  if (!now.stage.empty()) parts.push_back({4, now.stage});
  if (!now.best.empty()) parts.push_back({1, "best " + now.best});
  return fitting(std::move(parts), width);
}

bool may_colour_errors() {
  const char* no_color = std::getenv("NO_COLOR");
  return (no_color == nullptr || *no_color == '\0') && isatty(STDERR_FILENO) != 0 &&
         !dumb_terminal();
}

// To the second an estimate would only look accurate.
std::string duration_text(double seconds) {
  const auto rounded = [seconds](double unit) { return std::lround(seconds / unit); };
  if (rounded(1) < 100) return std::to_string(rounded(1)) + " s";
  if (rounded(60) < 200) return std::to_string(rounded(60)) + " min";
  return std::to_string(rounded(3600)) + " h";
}

}  // namespace twum::inline v0_1::cli
