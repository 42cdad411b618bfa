// SPDX-License-Identifier: Apache-2.0
#include "entries/repeats.hpp"

#include <twum/io/words.hpp>

namespace twum::inline v0_1::studies {

void Repeats::see(const YamlNode& item, const std::string& meaning) {
  const auto [first, added] = first_.emplace(meaning, item.mark);
  if (added) return;
  diagnostics_.add({item.mark, path_, studies::quoted(item.scalar) + " is given twice", remedy_,
                    first->second, "first given here"});
}

}  // namespace twum::inline v0_1::studies
