// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <stdexcept>
#include <string_view>

/// What is fed with bytes nobody wrote on purpose: by libFuzzer, and by a test with the corpus.
namespace twum::fuzz {

/// A reader did what it never may.
class BrokenLaw : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Reads a text. Returns if it was refused as documented, or accepted and all laws hold; whatever is
/// thrown is a finding.
struct Target {
  std::string_view name;
  void (*feed)(std::string_view text);
};

std::span<const Target> targets();
/// @throws std::out_of_range if there is none of this name
const Target& target(std::string_view name);

}  // namespace twum::fuzz
