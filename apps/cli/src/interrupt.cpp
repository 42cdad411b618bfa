// SPDX-License-Identifier: Apache-2.0
#include "interrupt.hpp"

#include "exit_status.hpp"

#include <unistd.h>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>

namespace twum::cli {
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

// Handlers may call what POSIX lists as safe in them, such as these: write, _exit, signal, raise,
// timer_settime, timer_gettime.
extern "C" void end_now(int /*signal*/) {
  constexpr const char* kText =
      "\ntwum: interrupted before the current step ended; the stored results of a study are kept, "
      "and the same command resumes it\n";
  [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, kText, std::strlen(kText));
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
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void ignore_interrupts() {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
}

bool interrupted() noexcept { return stop_asked; }

// A signal handler may not request a stop: it would have to take locks. So a thread looks after it.
StopOnInterrupt::StopOnInterrupt()
    : watcher_([source = source_](const std::stop_token& end) mutable {
        while (!end.stop_requested() && !source.stop_requested()) {
          if (interrupted()) source.request_stop();
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
      }) {}

}  // namespace twum::cli
