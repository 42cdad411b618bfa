// SPDX-License-Identifier: Apache-2.0
#include "run/channel.hpp"

#include <twum/base/error.hpp>

#define OMPI_SKIP_MPICXX 1  // the C interface alone
#include <mpi.h>

#include <chrono>
#include <mutex>
#include <thread>

namespace twum::inline v0_1::studies {
namespace {

// Blocking in MPI uses a whole processor for each thread. So threads poll instead: at first continuously, since most
// answers come soon, then less and less often.
class Patience {
 public:
  void wait() {
    if (++asked_ < kAtOnce) return std::this_thread::yield();
    std::this_thread::sleep_for(pause_);
    if (pause_ < kLongest) pause_ *= 2;
  }

 private:
  static constexpr unsigned kAtOnce = 50;
  static constexpr std::chrono::microseconds kLongest{500};
  std::chrono::microseconds pause_{10};
  unsigned asked_{0};
};

}  // namespace

// MPI allows one call at a time, from any thread.
struct Channel::State {
  std::mutex mutex;
  int number{0}, count{1}, on_node{1};

  void await(MPI_Request request) {
    Patience patience;
    for (int done = 0;;) {
      {
        const std::lock_guard lock(mutex);
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      }
      if (done != 0) return;
      patience.wait();
    }
  }
};

Channel::Channel() : state_(std::make_unique<State>()) {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  if (provided < MPI_THREAD_SERIALIZED)
    throw InputError("this MPI library does not allow threads (MPI_THREAD_SERIALIZED)");
  MPI_Comm_rank(MPI_COMM_WORLD, &state_->number);
  MPI_Comm_size(MPI_COMM_WORLD, &state_->count);
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  MPI_Comm_size(node, &state_->on_node);
  MPI_Comm_free(&node);
}

Channel::~Channel() { MPI_Finalize(); }

unsigned Channel::number() const noexcept { return static_cast<unsigned>(state_->number); }
unsigned Channel::count() const noexcept { return static_cast<unsigned>(state_->count); }
unsigned Channel::on_node() const noexcept { return static_cast<unsigned>(state_->on_node); }

void Channel::send(unsigned to, int lane, const std::string& message) {
  MPI_Request request = MPI_REQUEST_NULL;
  {
    const std::lock_guard lock(state_->mutex);
    MPI_Isend(message.data(), static_cast<int>(message.size()), MPI_BYTE, static_cast<int>(to),
              lane, MPI_COMM_WORLD, &request);
  }
  state_->await(request);
}

std::string Channel::receive(unsigned from, int lane) {
  MPI_Message found = MPI_MESSAGE_NULL;
  MPI_Status status{};
  Patience patience;
  for (int there = 0;;) {
    {
      const std::lock_guard lock(state_->mutex);
      MPI_Improbe(static_cast<int>(from), lane, MPI_COMM_WORLD, &there, &found, &status);
    }
    if (there != 0) break;
    patience.wait();
  }
  int size = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  std::string message;
  {
    const std::lock_guard lock(state_->mutex);
    MPI_Get_count(&status, MPI_BYTE, &size);
    message.resize(static_cast<std::size_t>(size));
    MPI_Imrecv(message.data(), size, MPI_BYTE, &found, &request);
  }
  state_->await(request);
  return message;
}

}  // namespace twum::inline v0_1::studies
