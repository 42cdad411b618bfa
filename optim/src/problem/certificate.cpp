// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/certificate.hpp>

namespace twum::inline v0_1::optim {

const char* to_string(Degeneracy degeneracy) {
  switch (degeneracy) {
    case Degeneracy::flat_direction: return "flat-direction";
    case Degeneracy::flat_objective: return "flat-objective";
    case Degeneracy::dependent_constraints: return "dependent-constraints";
    case Degeneracy::kink: return "kink";
    case Degeneracy::negative_curvature: return "negative-curvature";
    case Degeneracy::undefined_gradient: return "undefined-gradient";
  }
  return "unknown";
}

const char* to_string(Side side) {
  switch (side) {
    case Side::lower: return "lower";
    case Side::upper: return "upper";
    case Side::equal: return "equal";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::optim
