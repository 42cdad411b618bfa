// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace twum::inline v0_1::studies {

/// Messages between the processes that a launcher has started together. Each pair of processes has lanes, numbered from 0;
/// the messages of a lane arrive in the order of sending. Safe from any number of threads, one for each end of a lane.
/// Waiting costs next to no processor time.
class Channel {
 public:
  /// Joins the other processes and waits for them.
  /// @throws InputError if this build has no MPI
  Channel();
  /// Waits until all processes have left.
  ~Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  unsigned number() const noexcept;   ///< of this process, from 0
  unsigned count() const noexcept;    ///< of all processes
  unsigned on_node() const noexcept;  ///< processes on this machine, this one among them

  /// Returns when the message has been handed over.
  void send(unsigned to, int lane, const std::string& message);
  /// Waits for a message.
  std::string receive(unsigned from, int lane);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace twum::inline v0_1::studies
