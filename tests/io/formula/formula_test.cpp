// SPDX-License-Identifier: Apache-2.0
#include <twum/io/formula.hpp>
#include <twum/io/value_error.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace twum::io;
using Catch::Contains;

namespace {

struct Known {
  const char* name;
  const char* unit;
  double value;
};

// A force and a length besides two numbers.
constexpr std::array<Known, 4> kKnown{
    {{"x", "1", 1.7}, {"y", "1", 0.3}, {"force", "N", 160}, {"length", "m", 0.02}}};

const FormulaNames kNames{[](std::string_view reference, bool /*alone*/) -> FormulaName {
                            for (std::size_t i = 0; i < kKnown.size(); ++i) {
                              if (reference == kKnown[i].name)
                                return {std::string(reference), Dimension(kKnown[i].unit), i};
                            }
                            throw ValueError("unknown name", "expected one of x, y, force, length");
                          },
                          "expected a name"};

std::vector<double> values() {
  std::vector<double> list;
  for (const Known& known : kKnown) list.push_back(known.value);
  return list;
}

Formula read(const std::string& text) { return read_formula(text, kNames); }
double value(const std::string& text) { return read(text).value(values()); }

std::string refusal(const std::string& text) {
  try {
    read(text);
    return "";
  } catch (const ValueError& error) {
    return std::to_string(error.position()) + ": " + error.what();
  }
}

}  // namespace

TEST_CASE("powers bind before signs, signs before products, products before sums",
          "[files][formula]") {
  CHECK(value("2 + 3 * 4") == 14);
  CHECK(value("(2 + 3) * 4") == 20);
  CHECK(value("10 - 4 - 3") == 3);
  CHECK(value("24 / 4 / 3") == 2);
  CHECK(value("2^3^2") == 512);
  CHECK(value("-2^2") == -4);
  CHECK(value("(-2)^2") == 4);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("2 * -3") == -6);
  CHECK(value("+x") == 1.7);
  CHECK(value("max(2, 3) - min(2, 3)") == 1);
  CHECK(value("sqrt(16) + abs(-3) + log(exp(2))") == 9);
}

TEST_CASE("a unit extends to the next blank, bracket or comma", "[files][formula]") {
  CHECK(value("5 W/h") == 5.0 / 3600);
  CHECK(read("5 W/h").dimension() == Dimension("W/s"));
  CHECK(value("max(3 mm, 20 um)") == 0.003);
  CHECK(value("(3 mm)^2") == Approx(9e-6).epsilon(1e-15));
  CHECK(value("3 mm^2") == Approx(3e-6).epsilon(1e-15));
  CHECK(value("force / (2 kN)") == 0.08);
  CHECK(value("2 W/(m.K)") == 2);
  CHECK(value("50 % * x") == 0.85);
  CHECK(value("100rpm") == value("100 rpm"));
}

TEST_CASE("dimensions follow from the operations", "[files][formula]") {
  CHECK(read("force * length").dimension() == Dimension("N.m"));
  CHECK(read("force / length^2").dimension() == Dimension("Pa"));
  CHECK(read("sqrt(length^2)").dimension() == Dimension("m"));
  CHECK(read("(force^(1 / 3))^3").dimension() == Dimension("N"));
  CHECK(read("force / (2 N)").dimension().none());
  CHECK(read("force * length * 100 rpm").dimension().unit() == "W");
  CHECK(read("(force * length)^2").dimension().unit() == "(N.m)^2");
  CHECK(read("x^y").dimension().none());
}

TEST_CASE("sides of different dimension are both named", "[files][formula][error]") {
  CHECK(refusal("force + length") ==
        "6: 'force' is a force [N], but 'length' is a length [m]; '+' needs the same dimension on "
        "both sides");
  CHECK(refusal("max(force, 2)") ==
        "0: 'force' is a force [N], but '2' is a number without unit; 'max' needs the same "
        "dimension on both sides");
  CHECK(refusal("5 kHz - 100 rpm") ==
        "6: '5 kHz' is a frequency [Hz], but '100 rpm' is an angular speed [rad/s]; '-' needs the "
        "same dimension on both "
        "sides; these differ by an angle: multiply or divide by '1 rad'");
  CHECK(refusal("log(force)") ==
        "0: 'force' is a force [N]; log takes a number without unit; divide by a reference value "
        "such as '1 N'");
  CHECK(refusal("x^force") == "1: 'force' is a force [N]; an exponent is a number without unit");
  CHECK(refusal("force^x") ==
        "5: 'force' is a force [N] with the exponent 'x'; a quantity with a unit takes a number as "
        "its exponent");
}

TEST_CASE("what is no formula is refused at its place", "[files][formula][error]") {
  CHECK(refusal("") == "0: empty; expected a name");
  CHECK(refusal("x +") == "3: ends too early; expected a name");
  CHECK(refusal("x * / y") == "4: found '/'; expected a name");
  CHECK(refusal("(x") == "2: '(x' has no ')'; close the parenthesis");
  CHECK(refusal("x)") ==
        "1: found ')' after 'x'; it closes no parenthesis; in a YAML list, quote text that holds a "
        "comma");
  CHECK(refusal("x y") ==
        "2: found 'y' after 'x'; expected an operator: '+', '-', '*', '/' or '^'");
  CHECK(refusal("x ** 2") == "2: found '**'; write a power with '^'");
  CHECK(refusal("2 x") == "2: '2 x': unknown unit 'x'; write '*' between a number and a name");
  CHECK(refusal("2 mm+x") ==
        "2: 'mm+x' is not a unit; a unit extends to the next blank; put blanks round an operator "
        "that follows it");
  CHECK(refusal("max(x)") ==
        "5: 'max(x' has one value; expected 'max(A, B)'; in a YAML list, quote text that holds a "
        "comma");
  CHECK(refusal("sqrt x") == "5: 'sqrt' needs a value in parentheses; expected 'sqrt(A)'");
  CHECK(refusal("1 / (2 - 2) + x") == "2: '1 / (2 - 2)' has no finite value; correct this part");
  CHECK(refusal("x + z") == "4: unknown name; expected one of x, y, force, length");
  CHECK_THAT(refusal(std::string(1000, '(')), Contains("more than 200 levels"));
  CHECK_THAT(refusal(std::string(1000, '-') + "x"), Contains("more than 200 levels"));
  std::string sum = "x";
  for (int i = 0; i < 1000; ++i) sum += "+x";
  CHECK_THAT(refusal(sum), Contains("more than 1000 operations"));
}

TEST_CASE("a formula without a value has none, whatever part it is of", "[files][formula]") {
  for (const char* text :
       {"1 / (x - x)", "sqrt(y - x)", "log(y - x)", "exp(1e9 * x)", "(y - x)^0.5",
        "1 / (1 / (x - x))", "min(x, 1 / (x - x))", "0 * log(y - x)"}) {
    CAPTURE(text);
    CHECK(std::isnan(value(text)));
    const FormulaDerivative derivative = read(text).differentiate(values());
    CHECK(std::isnan(derivative.value));
    CHECK(std::isnan(derivative.by_name[0]));
  }
}

TEST_CASE("derivatives of every operation agree with differences", "[files][formula]") {
  const char* const kTexts[] = {"-x",
                                "x + y",
                                "x - y",
                                "x * y",
                                "x / y",
                                "x^3",
                                "x^-0.5",
                                "2^x",
                                "x^y",
                                "sqrt(x)",
                                "abs(x)",
                                "abs(y - x)",
                                "exp(x)",
                                "log(x)",
                                "min(x, y)",
                                "max(x, y)",
                                "x * x * x",
                                "x / (x + y)",
                                "(-x)^2",
                                "(y - x)^3",
                                "exp(x * y) / (1 + sqrt(x) * log(y)^2)",
                                "max(x * y, y) - min(y, 2 * x)^1.5"};
  for (const char* text : kTexts) {
    const Formula formula = read(text);
    const FormulaDerivative derivative = formula.differentiate(values());
    CHECK(derivative.value == formula.value(values()));
    CHECK_FALSE(derivative.kinked);
    for (std::size_t i = 0; i < 2; ++i) {
      CAPTURE(text, i);
      const auto central = [&](double step) {
        std::vector<double> left = values();
        std::vector<double> right = values();
        left[i] -= step;
        right[i] += step;
        return (formula.value(right) - formula.value(left)) / (2 * step);
      };
      // Richardson: what is left of the truncation is of fourth order, 1e-12 times a fifth derivative of up to some 1e2
      // here, and rounding is 1e-16 / 1e-3.
      const double expected = (4 * central(0.5e-3) - central(1e-3)) / 3;
      CHECK(derivative.by_name[i] == Approx(expected).epsilon(1e-8).margin(1e-10));
    }
  }
}

TEST_CASE("kinks and missing derivatives are reported", "[files][formula]") {
  const auto at = [](const char* text, double x, double y) {
    return read(text).differentiate(std::vector<double>{x, y, 0, 0});
  };
  CHECK(at("abs(x - y)", 2, 2).kinked);
  CHECK(at("abs(x - y)", 2, 2 + 1e-12).kinked);
  CHECK_FALSE(at("abs(x - y)", 2, 2 + 1e-6).kinked);
  CHECK(at("max(x, y)", 2, 2).kinked);
  CHECK(at("min(x, y) * 3", 2, 2).kinked);
  CHECK_FALSE(at("abs(x - y)^2", 2, 2).kinked);  // smooth in spite of its part
  CHECK(std::isnan(at("sqrt(x)", 0, 1).by_name[0]));
  CHECK(at("sqrt(x)", 0, 1).value == 0);
  CHECK(std::isnan(at("x^0.5", 0, 1).by_name[0]));
  CHECK(at("x^2", 0, 1).by_name[0] == 0);
  CHECK(at("(x - y)^3", 1, 2).by_name[0] == 3);
  CHECK(std::isnan(at("x^y", -2, 3).by_name[1]));  // only powers of whole numbers there
}
