// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "parts.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <stop_token>
#include <utility>

namespace twum::inline v0_1::python {

/// A long call of the module while it runs, from its first line to its return. The interpreter's end asks all of them
/// to stop and waits for them: a thread of C++ that were still within one when the interpreter is gone would end the
/// program with an abort.
class RunningCall {
 public:
  /// @throws InputError once the interpreter ends
  RunningCall();
  ~RunningCall();
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;

  /// Asks the work of this call to stop.
  std::stop_source& stop() { return stop_; }
  /// True once the interpreter ends.
  static bool closing();

 private:
  std::stop_source stop_;
};

/// Registers the end of all calls with the interpreter.
void add_end_of_calls();

/// What the caller gave to watch and to stop a call: `progress`, called as progress(done, total, best), or True for a line
/// that shows it, and `stop`, with a method is_set() such as that of threading.Event. Each may be None.
class Watch {
 public:
  /// @throws TypeError for a stop without is_set(), and for a progress that cannot be called
  Watch(py::object stop, py::object progress, std::uint64_t total = 0);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Counts finished parts of the work; on any thread.
  void count(std::uint64_t done) { done_ += done; }
  /// Tells the count, and asks the call to stop if the caller wants so. Holds the GIL.
  void poll(RunningCall& call) {
    heed(call);
    const std::uint64_t done = done_;
    if (done != std::exchange(told_, done)) tell(done, total_, "");
  }
  /// Asks the call to stop if the caller wants so.
  void heed(RunningCall& call) const;
  /// Calls `progress`, if there is one.
  void tell(std::uint64_t done, std::uint64_t total, const std::string& best) const;

 private:
  py::object stop_, progress_;
  bool shown_{false};  // by a line of the module, which ends with this call
  std::uint64_t total_;
  std::atomic<std::uint64_t> done_{0};
  std::uint64_t told_{0};
};

/// Runs work(stop_token) on a new thread without the GIL. Meanwhile the calling thread checks for Ctrl-C and calls
/// poll() now and then with the GIL, the last time behind the work. If either throws, the work is asked to stop and waited for; then the exception
/// is thrown. SystemExit once the interpreter ends.
template <typename Work, typename Poll>
auto run_interruptible(RunningCall& call, Work work, Poll poll) {
  if (!RunningCall::closing()) poll();  // a stop that is asked for already counts
  auto result = std::async(std::launch::async, [&] { return work(call.stop().get_token()); });
  const auto is_ready = [&] {
    const py::gil_scoped_release release;
    return result.wait_for(std::chrono::milliseconds(50)) == std::future_status::ready;
  };
  const auto wait = [&] {
    const py::gil_scoped_release release;
    result.wait();
  };
  try {
    while (!is_ready()) {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!RunningCall::closing()) poll();
    }
    if (!RunningCall::closing()) poll();
  } catch (...) {
    call.stop().request_stop();
    wait();
    throw;
  }
  if (RunningCall::closing()) {
    PyErr_SetNone(PyExc_SystemExit);
    throw py::error_already_set();
  }
  return result.get();
}

}  // namespace twum::inline v0_1::python
