// SPDX-License-Identifier: Apache-2.0
#include "solvers/solver_thread.hpp"

#include <chrono>
#include <csignal>
#include <ctime>
#include <system_error>

namespace twum::optim {
namespace {

constexpr std::chrono::milliseconds kLook{20};
constexpr double kHurry = 0.05;  // CPU time [s]; a regular step takes microseconds

// The thread can be cancelled at any instruction, but only while the C code runs, so that no lock or allocation of
// twum is interrupted. A cancellation requested meanwhile takes effect in allow_end(). Cancellation unwinds the
// stack; if it starts at an instruction that cannot throw, in a function with destructors, C++ ends the program. So
// work() and post() have no destructors and call functions that are not inlined.
void allow_end() { pthread_setcancelstate(PTHREAD_CANCEL_ENABLE, nullptr); }
void forbid_end() { pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, nullptr); }

// Handlers of signals run in the threads of the program, not in this one.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

SolverThread::SolverThread(double most, std::function<bool()> hurried)
    : most_(most), hurried_(std::move(hurried)) {
  const SignalsBlocked blocked;
  const int failed = pthread_create(&thread_, nullptr, begin, this);
  if (failed != 0)
    throw std::system_error(failed, std::generic_category(), "cannot start a thread for a solver");
}

SolverThread::~SolverThread() { end(); }

bool SolverThread::run(const std::function<void()>& work) {
  if (ended_) return false;
  work_ = &work;
  working_ = true;
  try {
    working_ = !serve();
  } catch (...) {
    end();
    throw;
  }
  if (working_) end();
  return !ended_;
}

// The caller's part of a run: true once the work has come back.
bool SolverThread::serve() {
  do {
    pass(Turn::solver);
    if (!wait_for_solver()) return false;
    if (call_ != nullptr) call_(request_);
  } while (call_ != nullptr);
  return true;
}

bool SolverThread::wait_for_solver() {
  std::unique_lock<std::mutex> hold(lock_);
  double begun = -1.0;
  while (!passed_.wait_for(hold, kLook, [this] { return turn_ == Turn::caller; })) {
    const double now = computed();
    if (begun < 0.0) begun = now;
    if (now - begun > (hurried_() ? kHurry : most_)) return false;
  }
  return true;
}

void* SolverThread::begin(void* self) {
  static_cast<SolverThread*>(self)->work();
  return nullptr;
}

// The thread's part.
void SolverThread::work() {
  forbid_end();
  pthread_setcanceltype(PTHREAD_CANCEL_ASYNCHRONOUS, nullptr);
  while (wait_for_caller()) {
    allow_end();
    (*work_)();
    forbid_end();
    call_ = nullptr;
    pass(Turn::caller);
  }
}

void SolverThread::post(Call* call, const void* request) {
  forbid_end();
  call_ = call;
  request_ = request;
  pass(Turn::caller);
  wait_for_caller();
  allow_end();
}

// False if there is nothing to be done any more.
bool SolverThread::wait_for_caller() {
  std::unique_lock<std::mutex> hold(lock_);
  passed_.wait(hold, [this] { return turn_ != Turn::caller; });
  return turn_ == Turn::solver;
}

void SolverThread::pass(Turn to) {
  {
    const std::lock_guard<std::mutex> hold(lock_);
    if (turn_ != Turn::nobody) turn_ = to;
  }
  passed_.notify_one();  // there is one other thread
}

// Computing time of the thread [s].
double SolverThread::computed() const {
  clockid_t clock{};
  timespec time{};
  if (pthread_getcpuclockid(thread_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void SolverThread::end() {
  if (ended_) return;
  ended_ = true;
  if (working_) pthread_cancel(thread_);
  pass(Turn::nobody);
  pthread_join(thread_, nullptr);
}

}  // namespace twum::optim
