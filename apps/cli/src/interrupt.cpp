// SPDX-License-Identifier: Apache-2.0
#include "interrupt.hpp"

#include <atomic>
#include <chrono>
#include <csignal>

namespace twum::cli {
namespace {

// Written by a signal handler and read by threads: only an atomic without a lock may be both.
std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void ask_to_stop(int /*signal*/) { stop_asked = true; }

}  // namespace

void install_interrupt_handler() {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
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
