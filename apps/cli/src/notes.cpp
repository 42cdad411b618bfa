// SPDX-License-Identifier: Apache-2.0
#include "notes.hpp"

#include "message.hpp"

#include <twum/motors/model_notes.hpp>
#include <twum/motors/reasons.hpp>

#include <algorithm>

namespace twum::inline v0_1::cli {

void print_model_notes(const MotorDesign& design, std::span<const std::string> said) {
  for (const studies::ModelNote& note : studies::model_notes_at_length(design)) {
    const bool known = std::any_of(said.begin(), said.end(), [&](const std::string& one) {
      return one.starts_with(note.text);
    });
    if (!known) say("note: " + note.text);
  }
}

void explain_reasons(const std::set<std::string>& reasons) {
  for (const studies::Reason& reason : studies::reasons()) {
    const char* word = to_string(reason.status);
    if (reasons.contains(word)) say("note: " + std::string(word) + ": " + reason.meaning);
  }
}

}  // namespace twum::inline v0_1::cli
