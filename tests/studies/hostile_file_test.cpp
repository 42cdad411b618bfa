// SPDX-License-Identifier: Apache-2.0
// Files that were not written to be read: nothing but an InputError may come of them, and that soon.
#include "support/scratch_folder.hpp"

#include <twum/io/diagnostics.hpp>
#include <twum/motors/design_table.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>

#include <catch2/catch.hpp>

#include <fstream>
#include <random>

using namespace twum;
using namespace twum::studies;

namespace {

std::string example() {
  return read_source(TWUM_SOURCE_DIR "/examples/motors/ring-60.yaml").text();
}

// "" if the text is a motor file, else the first line of the error.
std::string outcome(const std::string& text) {
  try {
    read_motor(Source("m.yaml", text));
    return "";
  } catch (const FileError& error) {
    const std::string what = error.what();
    return what.substr(0, what.find('\n'));
  }
}

// A study of the example motor; `study` is what stands below `study:`.
StudyFile study_of(const std::string& study) {
  return read_study(Source("s.yaml", "twum: 1\nmotor: ring-60.yaml\nstudy:\n" + study),
                    TWUM_SOURCE_DIR "/examples/motors");
}

// The error of a run that has to be refused before it begins.
std::string refused_run(const StudyFile& file) {
  try {
    run_study(file);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

// A header of `count` columns of one name.
std::string header_of(const std::string& name, std::size_t count) {
  std::string header = name;
  for (std::size_t i = 1; i < count; ++i) header += "," + name;
  return header + "\n";
}

}  // namespace

TEST_CASE("bytes that are no text are refused where they stand", "[studies][yaml][error]") {
  using namespace std::string_literals;
  CHECK(outcome("a: x\0y\n"s) == "m.yaml:1:5: a control character; a file is UTF-8 text");
  CHECK(outcome("a: 1\nµ: \x1b[0m\n") == "m.yaml:2:4: a control character; a file is UTF-8 text");
  CHECK(outcome("a: \xff\n") == "m.yaml:1:4: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("a: \xC0\x80\n") == "m.yaml:1:4: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("a: \xED\xA0\x80\n") ==
        "m.yaml:1:4: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("a: \xF0\x9F\x98") == "m.yaml:1:4: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("\xFF\xFEt\0w\0"s) == "m.yaml:1:1: a byte that is not UTF-8; a file is UTF-8 text");
  CHECK(outcome("a: 1\rb: 2\r") == "m.yaml:1:5: a control character; a file is UTF-8 text");
  CHECK(outcome("a: 😀 b: c\n") ==
        "m.yaml:1:7: a ':' that cannot stand here; check the indentation, and put a blank after "
        "the ':' of each entry");
}

TEST_CASE("deep and wide files are refused at once", "[studies][yaml][error]") {
  const std::string brackets(1000000, '[');
  CHECK(outcome("motor: " + brackets).find("nested more than") != std::string::npos);
  std::string block;
  for (int i = 0; i < 100000; ++i) block += "- ";
  CHECK(outcome(block).find("nested more than") != std::string::npos);
  std::string wide = "motor: [";
  for (int i = 0; i < 200000; ++i) wide += "1, ";
  CHECK(outcome(wide + "1]\n").find("missing") != std::string::npos);
  std::string keys;
  for (int i = 0; i < 50000; ++i) keys += "key" + std::to_string(i) + ": 1\n";
  CHECK(outcome(keys).find("unknown entry") != std::string::npos);
  std::string words = "motor: ";
  for (int i = 0; i < 500000; ++i) words += "word ";
  CHECK(!outcome(words).empty());
  // Each is linear in its size and takes a second at most; a quadratic one would take an hour, which the
  // limit of every test ends.
}

TEST_CASE("mutilated motor files give a FileError or a motor, never anything else",
          "[studies][yaml][property]") {
  const std::string good = example();
  const std::string alphabet = "{}[]:,-?&*!|>'\"%@`#\n\t \r~<.0123456789eE+_azNm\xC2\xB5\xff";
  std::mt19937 random(42);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string text = good;
    for (std::size_t change = 0; change < 1 + below(4); ++change) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0: text.erase(at, 1 + below(20)); break;
        case 1: text.insert(at, 1, alphabet[below(alphabet.size())]); break;
        case 2: text[at] = alphabet[below(alphabet.size())]; break;
        default: text.insert(at, text.substr(below(text.size()), below(60))); break;
      }
    }
    CAPTURE(text);
    refused += outcome(text).empty() ? 0 : 1;
  }
  CHECK(refused > 1000);
}

TEST_CASE("lists and numbers beyond reason are refused or read at once",
          "[studies][study][error]") {
  CHECK_THROWS_WITH(study_of("  kind: sweep\n  sampling: grid\n  metrics: [stall_torque]\n"
                             "  variables: {wavelengths: {min: 5, max: 12, points: 1e300}}\n"),
                    Catch::Contains("study.variables.wavelengths.points"));
  std::string quantiles = "0.1";
  for (int i = 1; i < 40000; ++i) quantiles += ", 0.2" + std::to_string(100000 + i);
  const std::string tolerances =
      "  kind: uncertainty\n  metrics: [stall_torque]\n"
      "  variables: {preload: {distribution: normal, mean: 160 N, sd: 8 N}}\n  quantiles: [";
  CHECK(study_of(tolerances + quantiles + "]\n").kind() == StudyKind::uncertainty);
  CHECK_THROWS_WITH(study_of(tolerances + quantiles + ", 0.10]\n"),
                    Catch::Contains("'0.10' is given twice"));
  // A second where the time grows with the list; a comparison of all pairs took minutes, and the
  // points of the grid have no end, which the limit of every test ends.
}

TEST_CASE("headers of one column many times are refused in a few words",
          "[studies][design_table][error]") {
  const twum::test::ScratchFolder folder;
  std::ofstream(folder.path("points.csv")) << header_of("speed", 100000) << "1,2\n";
  const std::string points =
      refused_run(study_of("  kind: calibrate\n  data: " + folder.path("points.csv") +
                           "\n  variables: {kinetic_friction: {min: 0.1, max: 0.3}}\n"));
  CHECK(points.find("100000 columns; expected 100 at most") != std::string::npos);
  CHECK(points.size() < 1000);

  const std::string header = header_of("preload", 100000);
  std::size_t at = 0;
  CsvReader reader("designs.csv", [&](char* to, std::size_t size) {
    const std::size_t got = header.copy(to, size, at);
    at += got;
    return got;
  });
  CsvChunk chunk;
  REQUIRE(reader.read(chunk, 1));
  const MotorDesign base = read_motor(Source("m.yaml", example())).design;
  try {
    const DesignTable table(reader, chunk, base, parse_metric_list("preload"));
    FAIL_CHECK("not refused");
  } catch (const InputError& error) {
    const std::string what = error.what();
    CHECK(what.find("and 99899 more errors") != std::string::npos);
    CHECK(what.size() < 20000);
  }
}

TEST_CASE("weights whose sum is beyond the range of numbers weigh as their ratios",
          "[studies][calibrate]") {
  const twum::test::ScratchFolder folder;
  const auto residual = [&](const std::string& light, const std::string& heavy) {
    std::ofstream(folder.path("points.csv"))
        << "speed [rpm],torque [N.m],weight\n0,0.9," << light << "\n20,0.8," << heavy << "\n40,0.7,"
        << heavy << "\n";
    const StudyResult result =
        run_study(study_of("  kind: calibrate\n  starts: 1\n  data: " + folder.path("points.csv") +
                           "\n  variables: {kinetic_friction: {min: 0.1, max: 0.3}}\n"));
    return std::get<CalibrateResult>(result.answer).residual_rms;
  };
  const double usual = residual("1", "2");
  CHECK(usual > 0);
  // The ratio of the large weights is 2 but for rounding, which the fit's tolerance of 1e-8 covers.
  CHECK(residual("8e307", "1.6e308") == Approx(usual).epsilon(1e-6));
}

TEST_CASE("a damaged result to start from is refused", "[studies][study][error]") {
  const twum::test::ScratchFolder folder;
  for (const char* summary :
       {"{\"best\": {}}", "{\"front\": [{}]}", "{\"front\": [1]}", "[]", "{",
        "{\"best\": {\"design\": 3}}", "{\"estimates\": {\"preload\": []}}"}) {
    CAPTURE(summary);
    std::ofstream(folder.path("summary.json")) << summary;
    const std::string error = refused_run(
        study_of("  kind: optimize\n  maximize: peak_power\n  start: " + folder.folder() +
                 "\n  variables: {preload: {min: 60 N, max: 300 N}}\n"));
    CHECK(error.find("study.start: ") == 0);
  }
}
