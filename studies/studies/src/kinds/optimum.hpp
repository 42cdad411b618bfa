// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/search_study.hpp"

namespace twum::studies {

/// A search for one best design: what optimize and size share.
class OptimumRun : public SearchRun {
 public:
  KindAnswer run(RunContext& context) override;

 protected:
  using SearchRun::SearchRun;
};

}  // namespace twum::studies
