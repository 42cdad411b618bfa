// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/held_traps.hpp"
#include "drive/drive.hpp"

#include <atomic>
#include <memory>

namespace twum::core {

/// The drive of a motor, found when it is first asked for: following the running wave costs hundreds of points, and a motor whose
/// drive follows does not need it. Any number of threads may ask.
class LazyDrive {
 public:
  explicit LazyDrive(const MotorDesign& design) : design_(design) {}
  ~LazyDrive() { delete found_.load(); }
  LazyDrive(const LazyDrive&) = delete;
  LazyDrive& operator=(const LazyDrive&) = delete;

  const Drive& drive() const { return found().drive; }
  /// The motor under the wave with which the curve begins.
  const DrivenMotor<double>& model() const { return found().model; }

 private:
  struct Found {
    explicit Found(const MotorDesign& design) : drive(design), model(drive.first_motor()) {}
    Drive drive;
    DrivenMotor<double> model;
  };

  // Two threads that ask at once both search, and find the same.
  const Found& found() const {
    if (const Found* known = found_.load()) return *known;
    const HeldTraps traps;
    auto mine = std::make_unique<const Found>(design_);
    const Found* first = nullptr;
    return found_.compare_exchange_strong(first, mine.get()) ? *mine.release() : *first;
  }

  MotorDesign design_;
  mutable std::atomic<const Found*> found_{nullptr};
};

}  // namespace twum::core
