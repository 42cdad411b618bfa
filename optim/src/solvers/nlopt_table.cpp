// SPDX-License-Identifier: Apache-2.0
#include "solvers/nlopt_table.hpp"

namespace twum::inline v0_1::optim {
namespace {

constexpr nlopt_algorithm kNone = NLOPT_NUM_ALGORITHMS;
constexpr const char* kCxx = "it needs the C++ build of NLopt (nlopt_cxx), which is not linked";
constexpr const char* kCrashes =
    "NLopt reads invalid memory if this algorithm is stopped early; use nlopt:direct";
constexpr bool y = true;
constexpr bool n = false;

// name, id, description, gradient, inequality, equality, global, stochastic, compares only,
// subsidiary, refusal
constexpr NloptAlgorithm kAlgorithms[] = {
    {"slsqp", NLOPT_LD_SLSQP, "sequential quadratic programming; fast for small smooth problems", y,
     y, y, n, n, n, kNone, ""},
    {"mma", NLOPT_LD_MMA, "method of moving asymptotes", y, y, n, n, n, n, kNone, ""},
    {"ccsaq", NLOPT_LD_CCSAQ, "conservative convex separable quadratic approximations", y, y, n, n,
     n, n, kNone, ""},
    {"cobyla", NLOPT_LN_COBYLA, "linear approximations without derivatives", n, y, y, n, n, n,
     kNone, ""},
    {"bobyqa", NLOPT_LN_BOBYQA, "quadratic model without derivatives", n, n, n, n, n, n, kNone, ""},
    {"newuoa_bound", NLOPT_LN_NEWUOA_BOUND,
     "quadratic model without derivatives, older than bobyqa", n, n, n, n, n, n, kNone,
     "its inner search may never end (issue 117 of NLopt); use nlopt:bobyqa"},
    {"newuoa", NLOPT_LN_NEWUOA, "quadratic model without derivatives or bounds", n, n, n, n, n, n,
     kNone, "it does not support bounds; use nlopt:bobyqa"},
    {"praxis", NLOPT_LN_PRAXIS, "principal axes without derivatives", n, n, n, n, y, n, kNone, ""},
    {"neldermead", NLOPT_LN_NELDERMEAD, "simplex of Nelder and Mead", n, n, n, n, n, y, kNone, ""},
    {"sbplx", NLOPT_LN_SBPLX, "Nelder-Mead on subspaces", n, n, n, n, n, y, kNone, ""},
    {"lbfgs", NLOPT_LD_LBFGS, "limited-memory BFGS", y, n, n, n, n, n, kNone, ""},
    {"lbfgs_nocedal", NLOPT_LD_LBFGS_NOCEDAL, "limited-memory BFGS by Nocedal", y, n, n, n, n, n,
     kNone, "this NLopt contains only its name; use nlopt:lbfgs"},
    {"var1", NLOPT_LD_VAR1, "shifted limited-memory variable metric, rank 1", y, n, n, n, n, n,
     kNone, ""},
    {"var2", NLOPT_LD_VAR2, "shifted limited-memory variable metric, rank 2", y, n, n, n, n, n,
     kNone, ""},
    {"tnewton", NLOPT_LD_TNEWTON, "truncated Newton", y, n, n, n, n, n, kNone, ""},
    {"tnewton_restart", NLOPT_LD_TNEWTON_RESTART, "truncated Newton, restarting", y, n, n, n, n, n,
     kNone, ""},
    {"tnewton_precond", NLOPT_LD_TNEWTON_PRECOND, "truncated Newton, preconditioned", y, n, n, n, n,
     n, kNone, ""},
    {"tnewton_precond_restart", NLOPT_LD_TNEWTON_PRECOND_RESTART,
     "truncated Newton, preconditioned and restarting", y, n, n, n, n, n, kNone, ""},
    {"isres", NLOPT_GN_ISRES, "evolution strategy with stochastic ranking", n, y, y, y, y, y, kNone,
     ""},
    {"crs2_lm", NLOPT_GN_CRS2_LM, "controlled random search with local mutation", n, n, n, y, y, y,
     kNone, ""},
    {"esch", NLOPT_GN_ESCH, "evolutionary algorithm", n, n, n, y, y, y, kNone, ""},
    {"direct", NLOPT_GN_DIRECT, "dividing rectangles", n, n, n, y, n, n, kNone, ""},
    {"direct_l", NLOPT_GN_DIRECT_L, "dividing rectangles, locally biased", n, n, n, y, n, n, kNone,
     ""},
    {"direct_l_rand", NLOPT_GN_DIRECT_L_RAND, "dividing rectangles, locally biased and randomized",
     n, n, n, y, y, n, kNone, ""},
    {"direct_noscal", NLOPT_GN_DIRECT_NOSCAL, "dividing rectangles, unscaled", n, n, n, y, n, n,
     kNone, ""},
    {"direct_l_noscal", NLOPT_GN_DIRECT_L_NOSCAL, "dividing rectangles, locally biased, unscaled",
     n, n, n, y, n, n, kNone, ""},
    {"direct_l_rand_noscal", NLOPT_GN_DIRECT_L_RAND_NOSCAL,
     "dividing rectangles, locally biased, randomized, unscaled", n, n, n, y, y, n, kNone, ""},
    {"orig_direct", NLOPT_GN_ORIG_DIRECT, "dividing rectangles, first implementation", n, n, n, y,
     n, n, kNone, kCrashes},
    {"orig_direct_l", NLOPT_GN_ORIG_DIRECT_L,
     "dividing rectangles, first implementation, locally biased", n, n, n, y, n, n, kNone,
     kCrashes},
    {"mlsl", NLOPT_GN_MLSL, "many local searches (bobyqa) from random starts", n, n, n, y, y, n,
     NLOPT_LN_BOBYQA, ""},
    {"mlsl_lds", NLOPT_GN_MLSL_LDS, "many local searches (bobyqa) from low-discrepancy starts", n,
     n, n, y, y, n, NLOPT_LN_BOBYQA, ""},
    {"gd_mlsl", NLOPT_GD_MLSL, "many local searches (lbfgs) from random starts", y, n, n, y, y, n,
     NLOPT_LD_LBFGS, ""},
    {"gd_mlsl_lds", NLOPT_GD_MLSL_LDS, "many local searches (lbfgs) from low-discrepancy starts", y,
     n, n, y, y, n, NLOPT_LD_LBFGS, ""},
    {"auglag", NLOPT_LD_LBFGS, "augmented Lagrangian over lbfgs", y, n, n, n, n, n, kNone, ""},
    {"auglag_eq", NLOPT_LD_MMA, "augmented Lagrangian for equalities over mma", y, y, n, n, n, n,
     kNone, ""},
    {"stogo", NLOPT_GD_STOGO, "branch and bound with local searches", y, n, n, y, n, n, kNone,
     kCxx},
    {"stogo_rand", NLOPT_GD_STOGO_RAND, "branch and bound with local searches, randomized", y, n, n,
     y, y, n, kNone, kCxx},
    {"ags", NLOPT_GN_AGS, "space-filling curve with constraints", n, y, n, y, n, n, kNone, kCxx}};

}  // namespace

std::span<const NloptAlgorithm> nlopt_algorithms() { return kAlgorithms; }

bool may_turn_for_ever(const NloptAlgorithm& a) {
  const nlopt_algorithm id = a.subsidiary == kNone ? a.id : a.subsidiary;
  return id == NLOPT_LN_COBYLA || id == NLOPT_LN_BOBYQA || id == NLOPT_LN_PRAXIS;
}

}  // namespace twum::inline v0_1::optim
