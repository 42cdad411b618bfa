// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

namespace twum::inline v0_1 {

namespace core {
class WorkBlocks;
class WorkIn;
}  // namespace core

/// Memory that evaluations use again, so that they take nothing from the heap: for control loops and simulators.
///
///     Workspace workspace;
///     for (const double speed : speeds) take(motor.operating_point(speed, workspace));
///
/// The values are those of the call without a workspace, to the bit. A call that needs more memory than any before takes it from
/// the heap; size() tells. For one thread at a time; it serves any number of motors.
class Workspace {
 public:
  /// Takes memory from the heap.
  /// @param bytes  the default is eight times what the points of drive-60 with `auto` slices need, and enough for its metrics [byte]
  explicit Workspace(std::size_t bytes = std::size_t{1} << 20);
  /// A workspace that was moved from holds no memory: calls with it use the heap.
  /// @{
  Workspace(Workspace&& other) noexcept;
  Workspace& operator=(Workspace&& other) noexcept;
  ~Workspace();
  /// @}

  /// What it has taken from the heap so far [byte].
  std::size_t size() const noexcept;

 private:
  friend class core::WorkIn;
  std::unique_ptr<core::WorkBlocks> blocks_;
};

}  // namespace twum::inline v0_1
