// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::inline v0_1::core {

/// A complex number whose parts may carry derivatives, which std::complex does not allow.
template <typename S>
struct Phasor {
  S real, imaginary;

  S squared() const { return real * real + imaginary * imaginary; }
  Phasor conjugate() const { return {real, -imaginary}; }
};

template <typename S>
Phasor<S> operator+(const Phasor<S>& a, const Phasor<S>& b) {
  return {a.real + b.real, a.imaginary + b.imaginary};
}
template <typename S>
Phasor<S> operator-(const Phasor<S>& a, const Phasor<S>& b) {
  return {a.real - b.real, a.imaginary - b.imaginary};
}
template <typename S>
Phasor<S> operator*(const Phasor<S>& a, const Phasor<S>& b) {
  return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
}
template <typename S>
Phasor<S> operator*(const S& x, const Phasor<S>& a) {
  return {x * a.real, x * a.imaginary};
}
template <typename S>
Phasor<S> operator/(const Phasor<S>& a, const Phasor<S>& b) {
  return (1.0 / b.squared()) * (a * b.conjugate());
}

}  // namespace twum::inline v0_1::core
