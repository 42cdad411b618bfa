// SPDX-License-Identifier: Apache-2.0
#include "tables/heading.hpp"

#include <twum/studies/text/words.hpp>

namespace twum::studies {

Heading split_heading(std::string_view text) {
  text = trimmed(text);
  const std::size_t open = text.find('[');
  if (open == std::string_view::npos || !text.ends_with(']')) return {text, {}, false};
  return {trimmed(text.substr(0, open)), trimmed(text.substr(open + 1, text.size() - open - 2)),
          true};
}

}  // namespace twum::studies
