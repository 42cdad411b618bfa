// SPDX-License-Identifier: Apache-2.0
#include <twum/io/number.hpp>

#include <rapidcheck/catch.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <locale>

using namespace twum::io;

TEST_CASE("a number is read whole or not at all", "[studies][text]") {
  CHECK(parse_number("1.5") == 1.5);
  CHECK(parse_number("+2") == 2.0);
  CHECK(parse_number(".5") == 0.5);
  CHECK(parse_number("5.") == 5.0);
  CHECK(parse_number("-1E-6") == -1e-6);
  CHECK(parse_number("017") == 17.0);
  for (const char* wrong :
       {"",     "+",   "-",   ".",    "e5",    "1e",  "1e+", "1,5",   "1 ",  " 1", "1_0",
        "0x1F", "inf", "nan", ".inf", "1e400", "--1", "+-1", "1.5.2", "1d3", "٣"}) {
    CAPTURE(wrong);
    CHECK_FALSE(parse_number(wrong).has_value());
  }
}

TEST_CASE("a decimal unit moves the point and rounds once", "[studies][text]") {
  CHECK(parse_decimal("26.5", -3) == 0.0265);
  CHECK(parse_decimal("1.6", -6) == 1.6e-6);
  CHECK(parse_decimal("3", 9) == 3e9);
  CHECK(parse_decimal("+2.5e3", -3) == 2.5);
  CHECK(parse_decimal("4e-3", 3) == 4.0);
  CHECK_FALSE(parse_decimal("1e308", 3).has_value());
  CHECK_FALSE(parse_decimal("1e99999999999", -3).has_value());
  CHECK(parse_decimal("0." + std::string(200, '3'), 3).value() ==
        Approx(1000.0 / 3).epsilon(1e-15));
}

TEST_CASE("every double survives being written and read", "[studies][text][property]") {
  rc::prop("number_text and parse_number are inverse", [](double value) {
    RC_PRE(std::isfinite(value));
    RC_ASSERT(parse_number(number_text(value)) == value);
  });
  CHECK(number_text(std::numeric_limits<double>::quiet_NaN()).empty());
  CHECK(parse_number(number_text(5e-324)) == 5e-324);
}

TEST_CASE("a size in a sentence has two digits, or is whole", "[studies][text]") {
  CHECK(about(0.123) == "0.12");
  CHECK(about(-3.16) == "-3.2");
  CHECK(about(99.4) == "99");
  CHECK(about(99.6) == "100");
  CHECK(about(1234.4) == "1234");
  CHECK(about(1e20) == "1e+20");
  CHECK(about(std::numeric_limits<double>::infinity()) == "inf");
}

TEST_CASE("numbers do not depend on the locale", "[studies][text]") {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  CHECK(parse_number("1.5") == 1.5);
  CHECK(number_text(1234567.5) == "1234567.5");
  CHECK(rounded_text(0.25, 3) == "0.25");
  std::locale::global(before);
}
