// SPDX-License-Identifier: Apache-2.0
#include "fit/fit_space.hpp"

#include <twum/base/error.hpp>

namespace twum::inline v0_1::optim {

bool has_gsl() { return false; }

FitEnd gsl_fit(FitSpace& /*space*/) {
  throw InputError("this build was made without GSL (TWUM_WITH_GSL=OFF)");
}

}  // namespace twum::inline v0_1::optim
