// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pthread.h>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>

namespace twum::optim {

/// A thread for C code that may compute forever between two requests, such as the inner loop of a solver. Requests
/// are answered by the thread that called run(), which waits meanwhile. The two threads never run at the same time,
/// so the evaluator sees one thread only, and results do not depend on timing. If the code computes for too long
/// without a request, its thread is ended. The limit is CPU time of that thread, which does not depend on the load of
/// the machine.
class SolverThread {
 public:
  /// @param most     CPU time between two requests after which the thread is ended [s]
  /// @param hurried  called about fifty times a second while the code computes. If it returns true, the thread is
  ///                 ended after 0.05 s of CPU time. It must not throw.
  /// @throws std::system_error if no thread can be started
  SolverThread(double most, std::function<bool()> hurried);
  ~SolverThread();
  SolverThread(const SolverThread&) = delete;
  SolverThread& operator=(const SolverThread&) = delete;

  /// Runs `work` in the thread. True when it has returned; false if the thread had to be ended, now or before. All
  /// stack frames between `work` and ask() must be C frames, without destructors; memory that they hold is lost.
  /// @throws the exception of a request, after the thread was ended
  bool run(const std::function<void()>& work);

  /// To be called within `work`: lets the thread in run() execute the request and waits for it.
  template <class Request>
  void ask(const Request& request) {
    post([](const void* r) { (*static_cast<const Request*>(r))(); }, &request);
  }

 private:
  enum class Turn : std::uint8_t { caller, solver, nobody };
  using Call = void(const void*);  // not a std::function, which has a destructor

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
  Call* call_{nullptr};  // current request; null when the work has returned
  const void* request_{nullptr};
};

}  // namespace twum::optim
