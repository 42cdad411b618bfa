// SPDX-License-Identifier: Apache-2.0
// Random formulas against arithmetic that is done while their text is written.
#include <twum/io/formula.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace twum::io;

namespace {

// A text, what it is worth, and its powers of newton and metre.
struct Made {
  std::string text;
  double value{0};
  int newtons{0};
  int metres{0};
};

const std::array<Made, 4> kNamed{
    {{"x", 1.7, 0, 0}, {"y", 0.3, 0, 0}, {"force", 160, 1, 0}, {"length", 0.02, 0, 1}}};

Dimension dimension_of(const Made& made) {
  return Dimension("N").power(made.newtons).times(Dimension("m").power(made.metres));
}

const FormulaNames kNames{[](std::string_view reference, bool /*alone*/) -> FormulaName {
                            for (std::size_t i = 0; i < kNamed.size(); ++i) {
                              if (reference == kNamed[i].text)
                                return {std::string(reference), dimension_of(kNamed[i]), i};
                            }
                            throw ValueError("unknown name", "expected another");
                          },
                          "expected a name"};

class Writer {
 public:
  explicit Writer(unsigned seed) : random_(seed) {}

  Made formula(int depth) {
    if (depth == 0 || below(6) == 0) return operand();
    switch (below(7)) {
      case 0: return sum(formula(depth - 1), formula(depth - 1));
      case 1: return difference(formula(depth - 1), formula(depth - 1));
      case 2: return product(formula(depth - 1), formula(depth - 1));
      case 3: return quotient(formula(depth - 1), formula(depth - 1));
      case 4: return power(formula(depth - 1));
      case 5: return negated(formula(depth - 1));
      default: return larger(formula(depth - 1), formula(depth - 1));
    }
  }

  Made operand() {
    static const std::array<Made, 6> kNumbers{{{"2", 2, 0, 0},
                                               {".5", 0.5, 0, 0},
                                               {"1e1", 10, 0, 0},
                                               {"3 N", 3, 1, 0},
                                               {"4 m", 4, 0, 1},
                                               {"25 %", 0.25, 0, 0}}};
    if (below(2) == 0) return kNamed[below(kNamed.size())];
    return kNumbers[below(kNumbers.size())];
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % limit; }
  std::string blank() { return std::string(1 + below(2), ' '); }

  static Made bracketed(const Made& made) {
    return {"(" + made.text + ")", made.value, made.newtons, made.metres};
  }

  // The second times what makes it a quantity like the first.
  static Made like(const Made& first, const Made& second) {
    const int newtons = first.newtons - second.newtons;
    const int metres = first.metres - second.metres;
    if (newtons == 0 && metres == 0) return second;
    return {"(" + second.text + ") * (1 N)^" + std::to_string(newtons) + " * (1 m)^(" +
                std::to_string(metres) + ")",
            second.value, first.newtons, first.metres};
  }

  Made sum(const Made& a, const Made& b) {
    const Made c = like(a, b);
    return {"(" + a.text + ")" + blank() + "+" + blank() + "(" + c.text + ")", a.value + c.value,
            a.newtons, a.metres};
  }
  Made difference(const Made& a, const Made& b) {
    const Made c = like(a, b);
    return {a.text + " -" + blank() + "(" + c.text + ")", a.value - c.value, a.newtons, a.metres};
  }
  Made product(const Made& a, const Made& b) {
    return {"(" + a.text + ")*(" + b.text + ")", a.value * b.value, a.newtons + b.newtons,
            a.metres + b.metres};
  }
  Made quotient(const Made& a, const Made& b) {
    return {"(" + a.text + ") /(" + b.text + ")", a.value / b.value, a.newtons - b.newtons,
            a.metres - b.metres};
  }
  Made power(const Made& a) {
    const int exponent = static_cast<int>(below(4)) - 1;
    return {"(" + a.text + ") ^ " + std::to_string(exponent), std::pow(a.value, exponent),
            a.newtons * exponent, a.metres * exponent};
  }
  Made negated(const Made& a) { return {"-(" + a.text + ")", -a.value, a.newtons, a.metres}; }
  Made larger(const Made& a, const Made& b) {
    const Made c = like(a, b);
    return {"max( " + a.text + "," + c.text + " )", std::max(a.value, c.value), a.newtons,
            a.metres};
  }

  std::mt19937 random_;
};

std::vector<double> values() {
  std::vector<double> list;
  for (const Made& known : kNamed) list.push_back(known.value);
  return list;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// The reader refuses parts of constants that have no finite value, such as 1 / (2 - 2).
void check_formula(const Made& made) {
  const std::vector<double> at = values();
  try {
    const Formula formula = read_formula(made.text, kNames);
    const double value = formula.value(at);
    // The same operations in the same order, so the same bits; a formula with an infinite part has no value.
    CHECK((std::isnan(value) || value == made.value));
    CHECK((!std::isnan(value) || !std::isfinite(made.value) ||
           made.text.find('/') != std::string::npos ||
           made.text.find("^ -1") != std::string::npos));
    CHECK(formula.dimension() == dimension_of(made));
    const Formula again = read_formula(formula.text(), kNames);
    CHECK(again.text() == formula.text());
    CHECK(same(again.value(at), value));
    CHECK(again.dimension() == formula.dimension());
  } catch (const ValueError& error) {
    CHECK(error.found().find("has no finite value") != std::string::npos);
  }
}

// Sums of two different dimensions name both.
void check_refusal(const Made& a, const Made& b) {
  if (a.newtons == b.newtons && a.metres == b.metres) return;
  try {
    read_formula(a.text + " + " + b.text, kNames);
    FAIL_CHECK("not refused");
  } catch (const ValueError& error) {
    CHECK(error.found().find(quoted(a.text)) != std::string::npos);
    CHECK(error.found().find(quoted(b.text)) != std::string::npos);
  }
}

void check_many(int count) {
  Writer writer(1);
  for (int i = 0; i < count; ++i) {
    const Made made = writer.formula(1 + i % 4);
    CAPTURE(made.text);
    check_formula(made);
    check_refusal(writer.operand(), writer.operand());
  }
}

}  // namespace

TEST_CASE(
    "a random formula has the value of its operations, and its canonical text reads back as itself",
    "[files][formula][random]") {
  check_many(2000);
}

TEST_CASE("a million random formulas keep these laws", "[.long][files][formula][random]") {
  check_many(1000000);
}
