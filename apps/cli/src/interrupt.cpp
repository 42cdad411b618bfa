// SPDX-License-Identifier: Apache-2.0
#include "interrupt.hpp"

#include "exit_status.hpp"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>

namespace twum::inline v0_1::cli {
namespace {

constexpr long kMillisecond = 1000000;  // [ns]
// Time for work in progress to end after a signal, so that the program ends within a second [ns].
constexpr long kPatience = 800 * kMillisecond;
// timeout(1) signals the program and then its process group, which is the program again [ns].
constexpr long kSameRequest = 50 * kMillisecond;

// Written by a signal handler and read by threads: only an atomic without a lock may be both.
std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free);
timer_t patience;
bool has_timer = false;

// How far a study has come; read by a signal handler.
std::atomic<bool> study_runs = false;
std::atomic<std::uint64_t> evaluations_done = 0;
std::atomic<std::uint64_t> evaluations_total = 0;  // 0: not known
std::atomic<bool> total_is_budget = false;
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
bool errors_on_terminal = false;

// A text of limited length, put together without functions that a signal handler must not call.
class Line {
 public:
  Line& operator<<(const char* text) {
    const std::size_t length = std::min(std::strlen(text), text_.size() - size_);
    std::memcpy(text_.data() + size_, text, length);
    size_ += length;
    return *this;
  }

  Line& operator<<(std::uint64_t number) {
    std::array<char, 24> digits{};
    char* begin = digits.data() + digits.size() - 1;
    do {
      *--begin = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number > 0);
    return *this << begin;
  }

  void print() const {
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, text_.data(), size_);
  }

 private:
  std::array<char, 256> text_{};
  std::size_t size_{0};
};

// Handlers may call what POSIX lists as safe in them: write, strlen, memcpy and those below.
void say_study_interrupted(Line& line, bool written) {
  line << "twum: interrupted after " << evaluations_done.load();
  if (const std::uint64_t total = evaluations_total; total > 0)
    line << (total_is_budget ? " of at most " : " of ") << total;
  line << " evaluations" << (written ? "" : ", before all result files were written")
       << "; the same command resumes the study\n";
  line.print();
}

extern "C" void end_now(int /*signal*/) {
  Line line;
  if (errors_on_terminal) line << "\n";  // ends the line of the progress
  if (study_runs) {
    say_study_interrupted(line, false);
  } else {
    line << "twum: interrupted before the current step ended\n";
    line.print();
  }
  _exit(kInterrupted);
}

bool same_request() {
  struct itimerspec left {};
  return has_timer && timer_gettime(patience, &left) == 0 &&
         left.it_value.tv_nsec > kPatience - kSameRequest;
}

extern "C" void ask_to_stop(int signal) {
  if (!stop_asked.exchange(true)) {
    struct itimerspec once {};
    once.it_value.tv_nsec = kPatience;
    if (has_timer) timer_settime(patience, 0, &once, nullptr);
  } else if (!same_request()) {
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void install_interrupt_handler() {
  struct sigevent event {};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  has_timer = timer_create(CLOCK_MONOTONIC, &event, &patience) == 0;
  handle(SIGALRM, end_now);
  handle(SIGINT, ask_to_stop);
  handle(SIGTERM, ask_to_stop);
  errors_on_terminal = isatty(STDERR_FILENO) != 0;
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void ignore_interrupts() {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
}

bool interrupted() noexcept { return stop_asked; }

void note_study_progress(std::uint64_t done, std::uint64_t total, bool budget) noexcept {
  evaluations_done = done;
  evaluations_total = total;
  total_is_budget = budget;
  study_runs = true;
}

void say_study_interrupted(std::uint64_t done) {
  evaluations_done = done;
  Line line;
  say_study_interrupted(line, true);
}

// A signal handler may not request a stop, because that takes locks. So a thread watches the flag and requests it.
StopOnInterrupt::StopOnInterrupt()
    : watcher_([source = source_](const std::stop_token& end) mutable {
        while (!end.stop_requested() && !source.stop_requested()) {
          if (interrupted()) source.request_stop();
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
      }) {}

}  // namespace twum::inline v0_1::cli
