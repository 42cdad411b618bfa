// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>

#include <catch2/catch.hpp>

#include <stdexcept>
#include <string>

using namespace twum;

TEST_CASE("a broken assertion says where it stands, and asks to be reported",
          "[core][errors][range]") {
  std::string text;
  try {
    detail::assertion_failed("a > b", "f.cpp", 7);
  } catch (const std::logic_error& error) {
    text = error.what();
  }
  CHECK(text == "internal error, please report it: f.cpp:7: a > b");
  // A mistake of ours is none of what callers are told to expect.
  CHECK_THROWS_AS(TWUM_ASSERT(1 > 2), std::logic_error);
  CHECK_NOTHROW(TWUM_ASSERT(2 > 1));
}
