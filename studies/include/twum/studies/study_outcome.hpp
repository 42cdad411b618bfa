// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>

#include <ostream>
#include <string>
#include <string_view>

namespace twum::inline v0_1::studies {

/// How a study ended.
enum class StudyOutcome : unsigned char {
  interrupted,   ///< a stop was requested
  optimal,       ///< of a search, as optim::Outcome
  feasible,      ///< likewise
  infeasible,    ///< likewise
  budget,        ///< likewise
  failed,        ///< likewise; of other kinds: nothing could be evaluated
  fitted,        ///< of a calibration: the motor follows the points
  poor,          ///< the motor does not follow the points
  at_bounds,     ///< every parameter is at an end of its range
  several,       ///< different motors fit equally well
  undetermined,  ///< the points do not determine every parameter
  done           ///< of kinds without a search
};

/// The outcome's word as in summary.json, such as "at-bounds"; static lifetime.
const char* to_string(StudyOutcome outcome) noexcept;
/// That of a search.
StudyOutcome outcome_of(optim::Outcome search) noexcept;

/// An outcome that reads as its word, too: `switch (result.outcome)` and `result.outcome == "optimal"`.
class OutcomeWord {
 public:
  /// From an outcome.
  OutcomeWord(StudyOutcome outcome = StudyOutcome::done) : outcome_(outcome) {}
  /// From its word. @throws InputError for a word that is none of an outcome
  /// @{
  OutcomeWord(std::string_view word);
  OutcomeWord(const char* word) : OutcomeWord(std::string_view(word)) {}
  OutcomeWord(const std::string& word) : OutcomeWord(std::string_view(word)) {}
  /// @}

  /// The outcome, or its word; static lifetime.
  /// @{
  operator StudyOutcome() const noexcept { return outcome_; }
  operator std::string() const { return c_str(); }
  const char* c_str() const noexcept { return to_string(outcome_); }
  /// @}

  /// True if both are the same outcome, or the word is its own.
  /// @{
  friend bool operator==(const OutcomeWord& a, const OutcomeWord& b) {
    return a.outcome_ == b.outcome_;
  }
  friend bool operator==(const OutcomeWord& a, StudyOutcome b) { return a.outcome_ == b; }
  friend bool operator==(const OutcomeWord& a, std::string_view b) { return a.c_str() == b; }
  friend bool operator==(const OutcomeWord& a, const char* b) { return a == std::string_view(b); }
  friend bool operator==(const OutcomeWord& a, const std::string& b) {
    return a == std::string_view(b);
  }
  /// @}
  /// Prints its word.
  friend std::ostream& operator<<(std::ostream& out, const OutcomeWord& word) {
    return out << word.c_str();
  }

 private:
  StudyOutcome outcome_;
};

}  // namespace twum::inline v0_1::studies
