// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"
#include "support/constants.hpp"
#include "telling/renderers.hpp"

#include <string>

/// Answers made by hand, for tests of what is said of them.
namespace twum::test {

using namespace twum::studies;

/// A result that holds an answer.
inline StudyResult result_of(const Answer& answer, const std::string& outcome = "done") {
  StudyResult result;
  result.outcome = outcome;
  result.answer = answer;
  return result;
}

/// What the terminal says of an answer: its headline, and what follows.
/// @{
inline std::string headline_text(const Answer& answer, const std::string& outcome = "done") {
  return telling::terminal_text(telling::headline(result_of(answer, outcome)));
}
inline std::string sections_text(const Answer& answer) {
  return telling::terminal_text(telling::sections(result_of(answer)));
}
/// @}

/// The text with a bar in place of the blanks between the columns of its tables.
inline std::string barred(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t blanks = 0;
    while (i + blanks < text.size() && text[i + blanks] == ' ') ++blanks;
    if (blanks > 1)
      out += " | ";
    else
      out.append(text, i, 1);
    i += blanks > 0 ? blanks : 1;
  }
  return out;
}

}  // namespace twum::test
