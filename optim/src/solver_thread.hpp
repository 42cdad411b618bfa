// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pthread.h>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>

namespace twum::optim {

/// A thread for C code that may go on for ever between two requests, such as a solver in its inner loop. The code asks
/// its questions of the thread that called run(), which waits meanwhile: the two never run at once, so whoever answers
/// sees one thread only, and answers do not depend on any timing. Where the code computes for too long without a
/// question its thread is ended. What counts is the computing time of that thread, which the load of the machine does
/// not change.
class SolverThread {
 public:
  /// @param most     computing time between two questions after which the thread is ended [s]
  /// @param hurried  asked some fifty times a second while the code computes: whether the caller wants the end, which
  ///                 then comes after 0.05 s of computing. It must not throw.
  /// @throws std::system_error if there is no thread to be had
  SolverThread(double most, std::function<bool()> hurried);
  ~SolverThread();
  SolverThread(const SolverThread&) = delete;
  SolverThread& operator=(const SolverThread&) = delete;

  /// Runs `work` in the thread. True once it has come back; false where the thread had to be ended, now or before.
  /// Between `work` and ask() stand C frames only, and none of ours with a destructor; memory that they hold is lost.
  /// @throws what a request throws, after the thread was ended
  bool run(const std::function<void()>& work);

  /// From within `work`: has the request done by the thread in run(), and waits for it.
  template <class Request>
  void ask(const Request& request) {
    post([](const void* r) { (*static_cast<const Request*>(r))(); }, &request);
  }

 private:
  enum class Turn : std::uint8_t { caller, solver, nobody };
  using Call = void(const void*);  // no std::function: it has a destructor

  static void* begin(void* self);
  void work();
  void post(Call* call, const void* request);
  bool serve();
  [[gnu::noinline]] bool wait_for_caller();
  bool wait_for_solver();
  [[gnu::noinline]] void pass(Turn to);
  double computed() const;
  void end();

  double most_;
  std::function<bool()> hurried_;
  pthread_t thread_{};
  bool ended_{false};
  bool working_{false};
  std::mutex lock_;
  std::condition_variable passed_;
  Turn turn_{Turn::caller};
  const std::function<void()>* work_{nullptr};
  Call* call_{nullptr};  // what was asked for; null: the work has come back
  const void* request_{nullptr};
};

}  // namespace twum::optim
