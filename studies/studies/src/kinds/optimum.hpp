// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/search_study.hpp"

namespace twum::studies {

/// A search for one best design: what optimize and size share.
class OptimumStudy : public SearchStudy {
 public:
  KindAnswer run(RunContext& context) override;

 protected:
  using SearchStudy::SearchStudy;
};

}  // namespace twum::studies
