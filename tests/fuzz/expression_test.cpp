// SPDX-License-Identifier: Apache-2.0
// The reader of expressions and limits on texts made of their own pieces, which random bytes rarely are.
#include "fuzz/readers.hpp"
#include "fuzz/targets.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <random>
#include <string>

using namespace twum::fuzz;

namespace {

constexpr std::array kPieces{"stall_torque",
                             "peak_power",
                             "torque_at(100 rpm)",
                             "speed_at(0.5 N.m)",
                             "preload",
                             "thickness",
                             "h",
                             "contact_half_length",
                             "5 W",
                             "5 W/h",
                             "0.1",
                             "1e-3",
                             "100 rpm",
                             "3 %",
                             "5 kW/m^2",
                             "2 mm",
                             " + ",
                             " - ",
                             " * ",
                             " / ",
                             "^",
                             "+",
                             "-",
                             "*",
                             "/",
                             "(",
                             ")",
                             ",",
                             ", ",
                             "sqrt(",
                             "abs(",
                             "exp(",
                             "log(",
                             "min(",
                             "max(",
                             " <= ",
                             " >= ",
                             " == ",
                             " +- ",
                             "<",
                             ">",
                             "=",
                             "  ",
                             "\xC2\xA0",
                             "\xC2\xB5m",
                             "2",
                             "0",
                             "1 N",
                             "^0.5",
                             "^-1",
                             "N.m",
                             "kinetic_friction",
                             ".",
                             "e",
                             "%",
                             "\""};

class Texts {
 public:
  explicit Texts(std::uint64_t seed) : random_(seed) {}

  // Up to nine pieces; one text in three with a byte that is lost, changed or added.
  std::string next() {
    std::string text;
    for (std::size_t count = 1 + below(9); count > 0; --count)
      text += kPieces[below(kPieces.size())];
    if (below(3) != 0) return text;
    const std::size_t at = below(text.size());
    switch (below(3)) {
      case 0: text.erase(at, 1 + below(3)); break;
      case 1: text[at] = static_cast<char>(below(256)); break;
      default: text.insert(at, 1, static_cast<char>(32 + below(95)));
    }
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % limit; }

  std::mt19937_64 random_;
};

// A law that does not hold, or an exception that no reader documents, comes out of feed_metrics().
void feed_many(long count, std::uint64_t seed) {
  Texts texts(seed);
  std::string text;
  try {
    for (long i = 0; i < count; ++i) feed_metrics(text = texts.next());
  } catch (const std::exception& error) {
    FAIL(error.what() << " of '" << text << "'");
  }
  SUCCEED();
}

}  // namespace

TEST_CASE("expressions and limits made of their own pieces are refused, or keep the reader's laws",
          "[fuzz]") {
  feed_many(20000, 1);
}

TEST_CASE("ten million such texts keep these laws", "[.long][fuzz]") { feed_many(10000000, 2); }
