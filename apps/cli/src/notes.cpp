// SPDX-License-Identifier: Apache-2.0
#include "notes.hpp"

#include <twum/studies/motor/model_notes.hpp>

#include <cstdio>
#include <utility>

namespace twum::cli {

void print_model_notes(const MotorDesign& design) {
  for (const studies::ModelNote& note : studies::model_notes(design))
    std::fprintf(stderr, "note: %s\n", note.text.c_str());
}

void explain_reasons(const std::set<std::string>& reasons) {
  static const std::pair<const char*, const char*> kMeanings[] = {
      {"undefined",
       "it has no meaning for this motor (efficiencies need modal_damping, peaks a stall torque)"},
      {"no-periodic-state",
       "the contact never repeats itself from wave to wave, usual with static friction above the "
       "kinetic one"},
      {"not-converged", "no steady state was found, usual for a layer without damping"},
      {"resonance", "the layer has no damping and is driven at its own resonance"},
      {"unresolved", "more zones of stick and slip than can be followed"}};
  for (const auto& [reason, meaning] : kMeanings) {
    if (reasons.contains(reason)) std::fprintf(stderr, "note: %s: %s\n", reason, meaning);
  }
}

}  // namespace twum::cli
