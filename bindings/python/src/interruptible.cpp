// SPDX-License-Identifier: Apache-2.0
#include "interruptible.hpp"

#include "conversions.hpp"

#include <twum/base/error.hpp>

#include <condition_variable>
#include <mutex>
#include <set>

namespace twum::inline v0_1::python {
namespace {

// The calls that run. It lives as long as the process.
struct Calls {
  std::mutex mutex;
  std::condition_variable ended;
  std::set<RunningCall*> running;
  std::atomic<bool> closing{false};
};

Calls& calls() {
  static auto* const all = new Calls;
  return *all;
}

// Called by the interpreter before it ends, with the GIL.
void end_all() {
  const py::gil_scoped_release release;
  Calls& all = calls();
  std::unique_lock lock(all.mutex);
  all.closing = true;
  for (RunningCall* call : all.running) call->stop().request_stop();
  all.ended.wait(lock, [&] { return all.running.empty(); });
}

}  // namespace

RunningCall::RunningCall() {
  Calls& all = calls();
  const std::lock_guard lock(all.mutex);
  if (all.closing) throw InputError("the interpreter is ending, so this cannot begin");
  all.running.insert(this);
}

RunningCall::~RunningCall() {
  Calls& all = calls();
  const std::lock_guard lock(all.mutex);
  all.running.erase(this);
  all.ended.notify_all();
}

bool RunningCall::closing() { return calls().closing; }

void add_end_of_calls() {
  py::module_::import("atexit").attr("register")(py::cpp_function(&end_all));
}

Watch::Watch(py::object stop, py::object progress, std::uint64_t total)
    : stop_(std::move(stop)), progress_(std::move(progress)), total_(total) {
  if (!stop_.is_none() && !py::hasattr(stop_, "is_set"))
    throw py::type_error("stop: expected an object with is_set(), such as threading.Event()");
  if (PyBool_Check(progress_.ptr())) {
    shown_ = progress_.is(py::bool_(true));
    progress_ = shown_ ? attribute_of_results("ProgressLine")() : py::none();
  }
  if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0)
    throw py::type_error("progress: expected True, or a function of (done, total, best)");
}

Watch::~Watch() {
  if (!shown_) return;
  try {
    progress_.attr("end")();
  } catch (py::error_already_set& error) {  // nobody can read the line
    error.discard_as_unraisable("twum: progress");
  }
}

void Watch::heed(RunningCall& call) const {
  if (!stop_.is_none() && py::cast<bool>(stop_.attr("is_set")())) call.stop().request_stop();
}

void Watch::tell(std::uint64_t done, std::uint64_t total, const std::string& best) const {
  if (!progress_.is_none()) progress_(done, total, best);
}

}  // namespace twum::inline v0_1::python
