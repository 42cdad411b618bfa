// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlopt.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace twum::inline v0_1::optim {

/// One call of nlopt_optimize() as plain values, so that it can be made here or in another process.
struct NloptJob {
  nlopt_algorithm id{};                              ///< what to run
  nlopt_algorithm subsidiary{NLOPT_NUM_ALGORITHMS};  ///< what it needs, or NLOPT_NUM_ALGORITHMS
  std::vector<double> lower{};                       ///< box
  std::vector<double> upper{};                       ///< box
  std::vector<double> start{};                       ///< within the box
  std::vector<double> inequalities{};                ///< tolerances of g_i(z) <= 0, which it keeps
  std::vector<double> equalities{};                  ///< tolerances of h_i(z) = 0, which it keeps
  double xtol_rel{0};                                ///< relative step that ends it
  double ftol_rel{0};                   ///< relative change of the objective that ends it
  int calls{0};                         ///< of the objective, at most
  int inner_calls{0};                   ///< of each search of the subsidiary, at most
  int population{0};                    ///< 0: NLopt's own
  int vector_storage{0};                ///< 0: NLopt's own
  std::vector<double> steps{};          ///< first steps; empty: NLopt's own
  std::optional<std::uint64_t> seed{};  ///< of the random numbers of this thread from here on
};

/// How it ended.
struct NloptEnd {
  nlopt_result code{NLOPT_FORCED_STOP};  ///< as returned
  std::vector<double> z{};               ///< final point
  std::string error{};                   ///< of NLopt, for invalid arguments
};

/// Answers what NLopt asks for. Nothing is thrown.
class NloptRequests {
 public:
  enum class Rows : std::uint8_t { inequalities, equalities };

  virtual ~NloptRequests() = default;
  /// @param gradient  null if it is not needed
  virtual double objective(std::span<const double> z, double* gradient) = 0;
  /// @param result  the values of the rows  @param jacobian  by rows; null if it is not needed
  virtual void limits(Rows rows, std::span<const double> z, std::span<double> result,
                      double* jacobian) = 0;
  /// True when the search has to end.
  virtual bool halted() const = 0;
};

/// Runs NLopt in this thread.
NloptEnd run_job(const NloptJob& job, NloptRequests& requests);

}  // namespace twum::inline v0_1::optim
