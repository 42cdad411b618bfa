// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "parts.hpp"

#include <chrono>
#include <future>
#include <stop_token>
#include <utility>

namespace twum::python {

/// Runs work(stop_token) on a new thread without the GIL. Meanwhile the calling thread checks for Ctrl-C and calls
/// poll() now and then with the GIL. If either throws, the work is asked to stop and waited for; then the exception
/// is thrown.
template <typename Work, typename Poll>
auto run_interruptible(Work work, Poll poll) {
  std::stop_source stop;
  auto result = std::async(std::launch::async, [&] { return work(stop.get_token()); });
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
      poll();
    }
  } catch (...) {
    stop.request_stop();
    wait();
    throw;
  }
  return result.get();
}

}  // namespace twum::python
