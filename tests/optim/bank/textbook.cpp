// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/textbook.hpp"

#include "optim/bank/textbook_parts.hpp"

#include <algorithm>

namespace twum::test {

std::vector<Textbook> textbook() {
  TextbookBuilder b;
  add_hs_1_to_24(b);
  add_hs_26_to_56(b);
  add_hs_60_to_83(b);
  add_hs_86_to_113(b);
  add_cec_2006(b);
  return std::move(b.all);
}

optim::Problem boxed(const Textbook& book, double width) {
  optim::Problem p = book.problem;
  for (optim::Variable& v : p.variables) {
    if (std::isinf(v.lower))
      v.lower = std::min(-width, std::isinf(v.upper) ? 0.0 : v.upper - width);
    if (std::isinf(v.upper)) v.upper = std::max(width, v.lower + width);
    v.start = std::clamp(v.start, v.lower, v.upper);
  }
  return p;
}

}  // namespace twum::test
