// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/held_traps.hpp"
#include "design/workspace.hpp"
#include "drive/drive.hpp"

#include <atomic>
#include <memory>

namespace twum::inline v0_1::core {

/// A value that is found when it is first asked for. Any number of threads may ask: two that ask at once both search, and find the
/// same.
template <typename T>
class Lazy {
 public:
  Lazy() = default;
  ~Lazy() { delete found_.load(); }
  Lazy(const Lazy&) = delete;
  Lazy& operator=(const Lazy&) = delete;

  /// @param make  gives a unique_ptr to the value
  template <typename Make>
  const T& get(Make make) const {
    if (const T* known = found_.load()) return *known;
    const HeldTraps traps;
    [[maybe_unused]] const WorkIn heap = WorkIn::heap();
    std::unique_ptr<const T> mine = make();
    const T* first = nullptr;
    return found_.compare_exchange_strong(first, mine.get()) ? *mine.release() : *first;
  }

 private:
  mutable std::atomic<const T*> found_{nullptr};
};

/// The drive of a motor. Following the running wave costs hundreds of points, and a motor whose drive follows does not need it; nor
/// do the voltages and frequencies at which waves at rest appear and vanish.
class LazyDrive {
 public:
  explicit LazyDrive(const MotorDesign& design) : design_(design) {}

  const DrivenWaves& waves() const {
    return waves_.get(
        [&] { return std::make_unique<const DrivenWaves>(Drive::waves_of(design_)); });
  }
  const WavesAtRest& at_rest() const { return *rest(); }
  const Drive& drive() const { return found().drive; }
  /// The motor under the wave with which the curve begins.
  const DrivenMotor<double>& model() const { return found().model; }

 private:
  using Rest = std::shared_ptr<const WavesAtRest>;
  struct Found {
    Found(const MotorDesign& design, const Rest& at_rest)
        : drive(design, at_rest), model(drive.first_motor()) {}
    Drive drive;
    DrivenMotor<double> model;
  };

  const Rest& rest() const {
    return rest_.get(
        [&] { return std::make_unique<const Rest>(std::make_shared<const WavesAtRest>(waves())); });
  }
  const Found& found() const {
    return found_.get([&] { return std::make_unique<const Found>(design_, rest()); });
  }

  MotorDesign design_;
  Lazy<DrivenWaves> waves_;
  Lazy<Rest> rest_;
  Lazy<Found> found_;
};

}  // namespace twum::inline v0_1::core
