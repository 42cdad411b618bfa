// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

/// Boost's errors without the stream that formats their numbers, which would be an eighth of the module; included in every
/// source of it.
#define BOOST_MATH_DOMAIN_ERROR_POLICY user_error
#define BOOST_MATH_POLE_ERROR_POLICY user_error
#define BOOST_MATH_OVERFLOW_ERROR_POLICY user_error
#define BOOST_MATH_EVALUATION_ERROR_POLICY user_error
#define BOOST_MATH_ROUNDING_ERROR_POLICY user_error

namespace boost::math::policies {

template <class T>
T user_domain_error(const char* /*function*/, const char* message, const T& /*value*/) {
  throw std::domain_error(message);
}
template <class T>
T user_pole_error(const char* /*function*/, const char* message, const T& /*value*/) {
  throw std::domain_error(message);
}
template <class T>
T user_overflow_error(const char* /*function*/, const char* message, const T& /*value*/) {
  throw std::overflow_error(message);
}
template <class T>
T user_evaluation_error(const char* /*function*/, const char* message, const T& /*value*/) {
  throw std::runtime_error(message);
}
template <class T, class Target>
T user_rounding_error(const char* /*function*/, const char* message, const T& /*value*/,
                      const Target& /*target*/) {
  throw std::runtime_error(message);
}

}  // namespace boost::math::policies
