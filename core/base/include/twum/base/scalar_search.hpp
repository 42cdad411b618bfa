// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/function_ref.hpp>

#include <string_view>

namespace twum::inline v0_1 {

/// Two places between which a function changes its sign.
struct Bracket {
  double low;      ///< a place
  double high;     ///< another one, not below it
  double at_low;   ///< the value at the lower place
  double at_high;  ///< the value at the higher place

  /// The end at which the function is nearer to zero.
  double nearest() const;
};

/// Closes in on a change of sign by Algorithm 748 (Alefeld, Potra and Shi 1995), until both ends agree in so many bits or one of
/// them is an exact zero; then both are.
/// @param sought  what the root is, for the message of the error
/// @param ends    finite places; the values there differ in sign, or one of them is zero
/// @param bits    more than 51 are 51: neighbouring numbers, but for a few
/// @throws EvaluationError "no-bracket" if the ends are no such places, or a value of f inside is not a number
Bracket closed_in(std::string_view sought, FunctionRef<double(double)> f, const Bracket& ends,
                  int bits = 51);

/// The least value of a function.
struct LeastValue {
  double place;  ///< where
  double value;  ///< how much
};

/// Minimizes between two places by Brent's method.
/// @param sought  what the place is, for the message of the error
/// @param bits    of the larger place; more than half of a number's, 26, are 26
/// @throws EvaluationError "no-bracket" if the places are not finite or low > high
LeastValue least_between(std::string_view sought, FunctionRef<double(double)> f, double low,
                         double high, int bits = 26);

/// Where a function that begins at 0 or above reaches zero, or the last place at which it has a value (is not NaN).
/// @param sought  as closed_in(), as are `bits` and the errors
/// @param good    where it is not below 0
/// @param bad     a place above, where it is below 0 or has no value
double zero_or_last_value(std::string_view sought, FunctionRef<double(double)> f, double good,
                          double bad, int bits);

}  // namespace twum::inline v0_1
