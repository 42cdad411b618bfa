// SPDX-License-Identifier: Apache-2.0
#include "notes.hpp"

#include <twum/studies/metrics/reasons.hpp>
#include <twum/studies/motor/model_notes.hpp>

#include <cstdio>

namespace twum::cli {

void print_model_notes(const MotorDesign& design) {
  for (const studies::ModelNote& note : studies::model_notes_at_length(design))
    std::fprintf(stderr, "note: %s\n", note.text.c_str());
}

void explain_reasons(const std::set<std::string>& reasons) {
  for (const studies::Reason& reason : studies::reasons()) {
    const char* word = to_string(reason.status);
    if (reasons.contains(word)) std::fprintf(stderr, "note: %s: %s\n", word, reason.meaning);
  }
}

}  // namespace twum::cli
