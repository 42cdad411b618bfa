// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motors/model_notes.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1::motors {

/// The notes on several motors: for each topic the most severe one, and the number of the others.
class WorstNotes {
 public:
  /// Adds the notes on one motor.
  /// @param what  names the motor: "best design", "line 17"
  void add(const std::vector<ModelNote>& notes, const std::string& what);
  /// Adds those of other motors, which come after these.
  void add(const WorstNotes& others);

  /// A sentence for each topic, in the order in which they came up; it names the motor if there were several.
  std::vector<std::string> texts() const;

 private:
  struct Worst {
    ModelNote note;
    std::string what;
    double smallest;
    std::size_t others;
  };
  void add(const Worst& one);

  std::vector<Worst> worst_;
  std::size_t motors_{0};
};

}  // namespace twum::inline v0_1::motors
