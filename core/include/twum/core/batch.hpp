// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>

#include <twum/base/error.hpp>
#include <twum/base/ordered.hpp>

#include <exception>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace twum::inline v0_1 {

/// Why a design of a batch has no answer at all.
struct DesignFailure {
  /// Kinds of reasons.
  enum class Kind : unsigned char {
    refused,  ///< no motor can have these values; the text is that of the InputError
    /// the motor has no answer; the text is the reason of the EvaluationError, "internal-error" for another exception
    error
  };
  Kind kind{Kind::refused};  ///< of the reason
  std::string text;          ///< what was wrong
};

/// Result of one design of a batch. An answer counts as one even if each of its numbers has a status that is not ok.
template <typename Answer>
using DesignOutcome = std::variant<Answer, DesignFailure>;

/// Calls a function and turns every std::exception into a DesignFailure.
template <typename Compute>
auto outcome_of(Compute&& compute) -> DesignOutcome<std::invoke_result_t<Compute&>> {
  try {
    return compute();
  } catch (const InputError& error) {
    return DesignFailure{DesignFailure::Kind::refused, error.what()};
  } catch (const EvaluationError& error) {
    return DesignFailure{DesignFailure::Kind::error, error.reason()};
  } catch (const Error& error) {
    return DesignFailure{DesignFailure::Kind::error, error.what()};
  } catch (const std::exception&) {  // words of a library, which say nothing to a user
    return DesignFailure{DesignFailure::Kind::error, "internal-error"};
  }
}

/// Builds one motor and asks it. Turns every std::exception of either step into a DesignFailure.
/// @param make  `MotorDesign make()`, which may throw an InputError for values that no motor can have
/// @param ask   `Answer ask(const Motor&)`
template <typename Make, typename Ask>
auto ask_design(Make&& make, Ask&& ask) -> DesignOutcome<std::invoke_result_t<Ask&, const Motor&>> {
  return outcome_of([&] { return ask(Motor(make())); });
}

/// Asks many designs on several threads by run_indexed(). The outcomes come in the order of the designs and do not
/// depend on the number of threads.
///
///     MotorDesign make(std::uint64_t index)     on any thread; see ask_design()
///     Answer ask(const Motor&)                  on any thread
///     void take(std::uint64_t first, std::vector<DesignOutcome<Answer>>& outcomes)   one call at a time
///
/// @return the first design that was not asked: `range.end`, unless range.proceed said no
/// @throws what `take` throws
template <typename Make, typename Ask, typename Take>
std::uint64_t ask_designs(const IndexRange& range, Make make, Ask ask, Take take) {
  return run_indexed(
      range, [&](std::uint64_t index) { return ask_design([&] { return make(index); }, ask); },
      std::move(take));
}

/// Metrics of many designs on several threads. Row i holds the metrics of design i in the order asked,
/// bit for bit those of evaluate(), whatever `jobs` is. Cost: that of evaluate() per design, shared by
/// the threads, and 16 bytes a metric.
///
/// @param jobs  threads; 0 takes one for each core.
/// @param proceed  asked again and again, on any thread; once it says no, the call ends within a few designs a thread, and the
///                 answer has the rows of the first designs only. Empty: to the end. Of a std::stop_token `stop` it is
///                 [&] { return !stop.stop_requested(); }
/// @throws InputError naming the first design that is not admissible, before anything is computed.
std::vector<std::vector<MetricValue>> evaluate_designs(std::span<const MotorDesign> designs,
                                                       std::span<const MetricRequest> requests,
                                                       unsigned jobs = 0,
                                                       const std::function<bool()>& proceed = {});

/// Metrics with exact derivatives (SI) of many designs on several threads. Row i holds those of design i in the order
/// asked, bit for bit those of differentiate(), whatever `jobs` is. The Smoothness of each says what its derivatives
/// can be used for. Cost: that of differentiate() per design, shared by the threads, and about 500 bytes a metric.
///
/// @param fixed_static_friction  holds mu_0 while mu moves, see differentiate()
/// @param jobs                   threads; 0 takes one for each core.
/// @param proceed                as of evaluate_designs()
/// @throws InputError naming the first design that is not admissible, before anything is computed.
std::vector<std::vector<MetricDerivative>> differentiate_designs(
    std::span<const MotorDesign> designs, std::span<const MetricRequest> requests,
    bool fixed_static_friction = false, unsigned jobs = 0,
    const std::function<bool()>& proceed = {});

}  // namespace twum::inline v0_1
