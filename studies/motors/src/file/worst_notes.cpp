// SPDX-License-Identifier: Apache-2.0
#include "file/worst_notes.hpp"

#include <twum/io/words.hpp>

#include <algorithm>

namespace twum::inline v0_1::motors {

void WorstNotes::add(const std::vector<ModelNote>& notes, const std::string& what) {
  ++motors_;
  for (const ModelNote& note : notes) add({note, what, note.size, 0});
}

void WorstNotes::add(const WorstNotes& others) {
  motors_ += others.motors_;
  for (const Worst& one : others.worst_) add(one);
}

void WorstNotes::add(const Worst& one) {
  const auto known = std::find_if(worst_.begin(), worst_.end(), [&](const Worst& other) {
    return other.note.topic == one.note.topic;
  });
  if (known == worst_.end()) {
    worst_.push_back(one);
    return;
  }
  const Worst before = *known;
  if (one.note.size > before.note.size) *known = one;
  known->smallest = std::min(before.smallest, one.smallest);
  known->others = before.others + one.others + 1;
}

std::vector<std::string> WorstNotes::texts() const {
  std::vector<std::string> texts;
  for (const Worst& one : worst_) {
    std::string text = (motors_ == 1 ? "" : one.what + ": ") + one.note.text;
    if (one.others > 0)
      text += "; the same for " + counted(one.others, "other") +
              (one.smallest < one.note.size ? ", to a smaller extent" : "");
    texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace twum::inline v0_1::motors
