// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/io/number.hpp>
#include <twum/motors/design_table.hpp>

#include <catch2/catch.hpp>

#include <cstring>

using namespace twum;
using namespace twum::studies;

namespace {

struct Result {
  std::string text;
  DesignCounts counts;
  std::vector<std::string> warnings;
};

Result evaluate_text(const std::string& table_text, const std::string& metrics, unsigned jobs = 1,
                     const MotorDesign& base = {}) {
  CsvReader reader("t.csv", [&table_text, at = std::size_t{0}](char* to, std::size_t size) mutable {
    const std::size_t count = std::min(size, table_text.size() - at);
    std::memcpy(to, table_text.data() + at, count);
    at += count;
    return count;
  });
  CsvChunk header;
  REQUIRE(reader.read(header, 1));
  const DesignTable table(reader, header, base, parse_metric_list(metrics));
  Result result;
  result.counts = evaluate_table(
      reader, table, jobs, [&](std::string_view text) { result.text += text; }, [] { return true; },
      [](const DesignCounts&) {});
  result.warnings = table.warnings();
  return result;
}

std::string result_of(const std::string& table, const std::string& metrics) {
  return evaluate_text(table, metrics).text;
}

}  // namespace

TEST_CASE("columns replace parameters in SI or in their unit, others are copied",
          "[studies][tables]") {
  CHECK(result_of("id,preload,thickness [mm],note\n7,100,0.25,\"a, b\"\n8,1.2e2,0.5,\n",
                  "preload, h") ==
        "id,preload,thickness [mm],note,preload [N],h [m],status\n"
        "7,100,0.25,\"a, b\",100,0.00025,ok\n"
        "8,1.2e2,0.5,,120,5e-04,ok\n");
}

TEST_CASE("a column replaces the alternative of its parameter", "[studies][tables]") {
  CHECK(result_of("G [GPa],h [m]\n2,1e-3\n", "shear_modulus") ==
        "G [GPa],h [m],shear_modulus [Pa],status\n2,1e-3,2e+09,ok\n");
}

TEST_CASE("a row that fails has empty metrics and a reason, and the others go on",
          "[studies][tables]") {
  const std::string text = result_of(
      "preload,mu\n"
      "100,0.2\n"
      "100\n"
      "100,0.2,3\n"
      "abc,0.2\n"
      ",0.2\n"
      "-5,0.2\n"
      "nan,0.2\n"
      "\"100\",0.2\n"
      "1\"0,0.2\n"
      "0.3 N,0.2\n"
      "100,0.1\n",
      "preload");
  CHECK(text ==
        "preload,mu,preload [N],status\n"
        "100,0.2,100,ok\n"
        "100,,,\"line 3: 1 cell, the header has 2\"\n"
        "100,0.2,,\"line 4: 3 cells, the header has 2\"\n"
        "abc,0.2,,line 5: preload: 'abc' is not a number\n"
        ",0.2,,line 6: preload: empty cell\n"
        "-5,0.2,,\"line 7: preload must be at least 0 N, but is -5 N\"\n"
        "nan,0.2,,line 8: preload: 'nan' is not a number\n"
        "\"100\",0.2,100,ok\n"
        "\"1\"\"0\",0.2,,line 10: a quotation mark that cannot stand there\n"
        "0.3 N,0.2,,line 11: preload: '0.3 N' is not a number\n"
        "100,0.1,100,ok\n");
}

TEST_CASE("a parameter's heading may have capitals, a symbol may not", "[studies][tables]") {
  CHECK(
      result_of("Preload (N),Thickness [um],Motor.Stator.Amplitude [um]\n100,200,1\n",
                "preload, thickness, amplitude") ==
      "Preload (N),Thickness [um],Motor.Stator.Amplitude [um],preload [N],thickness [m],amplitude "
      "[m],status\n100,200,1,100,2e-04,1e-06,ok\n");
  // H is no thickness.
  CHECK_THROWS_WITH(result_of("H [mm]\n0.2\n", "thickness"),
                    Catch::Contains("no column is a parameter"));
}

TEST_CASE("a metric without an answer is empty and named in the status", "[studies][tables]") {
  CHECK(result_of("preload\n160\n", "holding_torque, speed_at(100 N.m), max_efficiency") ==
        "preload,holding_torque [N.m],speed_at(100 N.m) [rad/s],max_efficiency [1],status\n160," +
            number_text(Motor{MotorDesign{}}.holding_torque()) +
            ",,,speed_at(100 N.m): unreachable; max_efficiency: undefined\n");
}

TEST_CASE("a wrong header is refused with all that is wrong", "[studies][tables][error]") {
  CHECK_THROWS_WITH(
      result_of("thickness [N],h [mm],nu,G [GPa],preload [foo]\n", "preload"),
      "t.csv:1: column 'thickness [N]': 'N' is a force [N]; expected a length [m] such as '0.3 "
      "mm'\n"
      "t.csv:1: column 'preload [foo]': 'foo': unknown unit 'foo'; expected a force [N] such as "
      "'160 N'\n"
      "t.csv:1: column 'G': cannot be given together with 'nu'; give one of the two");
  CHECK_THROWS_WITH(result_of("thickness,h [mm]\n", "preload"),
                    "t.csv:1: column 'h': the parameter is given twice; leave one of them out");
  CHECK_THROWS_WITH(result_of("id,colour\n", "preload"),
                    Catch::StartsWith("t.csv:1: no column is a parameter; name"));
  CHECK_THROWS_WITH(result_of("\"thickness\" x,preload\n", "preload"),
                    Catch::Contains("quotation mark"));
}

TEST_CASE("a column that looks like a mistyped parameter is warned about", "[studies][tables]") {
  const Result result = evaluate_text("thicknes [mm],preload [N]\n1,160\n", "preload");
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings[0] ==
        "column 'thicknes [mm]' is not a parameter and is only copied; did you mean 'thickness "
        "[m]'?");
}

TEST_CASE("the result is the same to the byte for any number of threads", "[studies][tables]") {
  std::string table = "preload,amplitude [um]\n";
  for (int i = 0; i < 2000; ++i)
    table += std::to_string(60 + i % 240) + "," + std::to_string(1 + i % 3) + "\n";
  table += "x,1\n";
  const Result one = evaluate_text(table, "stall_torque, torque_at(50 rpm)");
  CHECK(one.counts.rows == 2001);
  CHECK(one.counts.failed == 1);
  CHECK(evaluate_text(table, "stall_torque, torque_at(50 rpm)", 2).text == one.text);
  CHECK(evaluate_text(table, "stall_torque, torque_at(50 rpm)", 8).text == one.text);
}
