// SPDX-License-Identifier: Apache-2.0
// Tables of designs and of measured points, doubts about a motor, and numbers known from few samples.
#include "entries_support.hpp"
#include "tables/measured_points.hpp"

#include <twum/base/error.hpp>
#include <twum/io/csv.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/motors/design_table.hpp>
#include <twum/motors/model_notes.hpp>
#include <twum/studies/estimate.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;
using P = Parameter;

namespace {

using Lines = std::vector<std::string>;

CsvReader reader_of(const std::string& text) {
  return {"t.csv", [text, at = std::size_t{0}](char* to, std::size_t size) mutable {
            const std::size_t count = std::min(size, text.size() - at);
            std::copy_n(text.data() + at, count, to);
            at += count;
            return count;
          }};
}

DesignTable table_of(const std::string& header, const std::string& metrics = "preload") {
  CsvReader reader = reader_of(header + "\n");
  CsvChunk chunk;
  reader.read(chunk, 1);
  return {reader, chunk, MotorDesign{}, parse_metric_list(metrics)};
}

// "line:column: column: found; expected" of all that is wrong with points.
Lines wrong_points(const std::string& csv) {
  Lines lines;
  try {
    read_measured_points(Source("points.csv", csv));
  } catch (const FileError& error) {
    for (const Diagnostic& one : error.diagnostics())
      lines.push_back(std::to_string(one.mark.line) + ":" + std::to_string(one.mark.column) + ": " +
                      one.entry + ": " + one.found + "; " + one.expected);
  }
  return lines;
}

// What is said of one topic; empty if nothing is.
std::string note_on(const MotorDesign& motor, const std::string& topic, double* size = nullptr) {
  for (const ModelNote& note : model_notes(motor)) {
    if (note.topic != topic) continue;
    if (size != nullptr) *size = note.size;
    return note.text;
  }
  return {};
}

}  // namespace

TEST_CASE("a table knows which parameters it replaces", "[studies][tables]") {
  const DesignTable table = table_of("F_N [kN],id,thickness");
  CHECK(table.columns() == 3);
  CHECK(table.has(P::preload));
  CHECK(table.has(P::thickness));
  CHECK_FALSE(table.has(P::amplitude));
  // Wherever its column stands.
  for (int before = 0; before <= 5; ++before) {
    for (int after = 0; after <= 5; ++after) {
      std::string header;
      for (int i = 0; i < before; ++i) header += "a" + std::to_string(i) + ",";
      header += "preload";
      for (int i = 0; i < after; ++i) header += ",b" + std::to_string(i);
      CHECK(table_of(header).has(P::preload));
      CHECK_FALSE(table_of(header).has(P::inertia));
    }
  }
}

TEST_CASE("a design counts as empty if none of its metrics has a value", "[studies][tables]") {
  // No motor carries loads of 1000 N.m and more.
  for (int count = 1; count <= 6; ++count) {
    for (int place = -1; place < count; ++place) {
      std::string metrics;
      for (int i = 0; i < count; ++i)
        metrics +=
            (i == 0 ? "" : ", ") + (i == place ? std::string("stall_torque")
                                               : "speed_at(" + std::to_string(1000 + i) + " N.m)");
      CAPTURE(metrics);
      CsvReader reader = reader_of("preload\n100\n");
      CsvChunk header;
      reader.read(header, 1);
      const DesignTable table(reader, header, MotorDesign{}, parse_metric_list(metrics));
      const DesignCounts counts = evaluate_table(
          reader, table, 1, [](std::string_view) {}, [] { return true; },
          [](const DesignCounts&) {});
      CHECK(counts.rows == 1);
      CHECK(counts.failed == (place >= 0 && count == 1 ? 0 : 1));
      CHECK(counts.empty == (place >= 0 ? 0 : 1));
    }
  }
}

TEST_CASE("a cell that is quoted is read without its marks", "[studies][tables]") {
  const DesignTable table = table_of("preload");
  DesignTable::Scratch scratch;
  const auto result = [&](const std::string& record) {
    std::string out;
    table.append_result(record, 2, scratch, out);
    return out;
  };
  CHECK(result("\" 100 \"") == "\" 100 \",100,ok\n");
  CHECK(result("\"\"") == "\"\",,line 2: preload: empty cell\n");
  CHECK(result("\"100") == "\"\"\"100\",,line 2: a quotation mark that cannot stand there\n");
}

TEST_CASE("a file that cannot be read is an error with the reason", "[studies][csv]") {
  const ScratchFolder folder;  // a folder can be opened, and not be read
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      std::fopen(folder.folder().c_str(), "rb"), &std::fclose);
  REQUIRE(file);
  CsvReader reader("it.csv", bytes_of(file.get(), "it.csv"));
  CsvChunk chunk;
  CHECK_THROWS_WITH(reader.read(chunk, 1), "it.csv: cannot be read: Is a directory");
}

TEST_CASE("what is wrong with measured points is said at its place",
          "[studies][calibrate][error]") {
  CHECK(wrong_points("speed,torque\n1,0.5\n").empty());
  CHECK(wrong_points("speed,torque\n1,\n") == Lines{"2:3: torque: empty cell; expected a number"});
  CHECK(wrong_points("speed [rpm],torque [mN.m]\nx, y\n") ==
        Lines{"2:1: speed: 'x' is not a number; expected a number in rpm",
              "2:4: torque: 'y' is not a number; expected a number in mN.m"});
  CHECK(wrong_points("speed,torque,weight\n1,0.5,0\n") ==
        Lines{"2:7: weight: '0'; must be more than 0; to ignore a point leave out its line"});
  CHECK(wrong_points("speed,torque [kg]\n").at(0).starts_with("1:7: torque: 'kg' is a mass"));
  CHECK(wrong_points("speed\n1\n") ==
        Lines{"1:1: : no column 'torque'; expected one such as 'torque [N.m]'"});
  CHECK(wrong_points("torque\n1\n") ==
        Lines{"1:1: : no column 'speed'; expected one such as 'speed [rpm]'"});
  // An unknown column may be the one that seems to be missing.
  CHECK(wrong_points("speed,torqe\n") ==
        Lines{"1:7: : unknown column 'torqe'; did you mean 'torque'?"});
  CHECK(wrong_points("speed,torque,speed\n") ==
        Lines{"1:14: speed: the column is given twice; leave one of them out"});
  CHECK(wrong_points("speed,torque,amplitude,voltage\n") ==
        Lines{"1:24: voltage: cannot be set together with 'amplitude'; leave out one of the two "
              "columns"});
  CHECK(wrong_points("speed,torque,weight,torque_sd\n").size() == 1);
  CHECK(wrong_points("speed,torque\n1\n") == Lines{"2:1: : 1 cell; the header has 2"});
  CHECK(wrong_points("speed,torque\n1,2,3\n") == Lines{"2:1: : 3 cells; the header has 2"});
  CHECK(wrong_points("speed;torque\n1;2\n").empty());
  CHECK(wrong_points("speed,Md\n1,2\n") ==
        Lines{"1:1: : no column 'torque'; expected one such as 'torque [N.m]'; if another heading "
              "stands "
              "for it, say so in the study: columns: {torque: 'Md'}"});
  CHECK(wrong_points("speed;torque\n1;1,200\n") ==
        Lines{"2:3: torque: '1,200' has a comma, which may stand for a decimal point or separate "
              "thousands; write '1.200' or '1200'"});
  CHECK(wrong_points("speed,torque\n") ==
        Lines{"1:1: : no points below the header; expected one on each line"});
  CHECK(wrong_points("# a remark\n") ==
        Lines{"1:1: : an empty file; expected a header such as 'speed [rpm],torque'"});
}

TEST_CASE("weights have a mean of 1, and a deviation gives the inverse of its square",
          "[studies][calibrate]") {
  const auto [points, without_unit, by_letter, set, unused, instrument] =
      read_measured_points(Source("p", "speed,torque,torque_sd [mN.m]\n1,0.5,1\n# no\n2,0.4,2\n"));
  CHECK(without_unit == Lines{"speed [rad/s]", "torque [N.m]"});
  CHECK(set.empty());
  CHECK(by_letter.empty());
  CHECK(unused.empty());
  CHECK(instrument.empty());
  REQUIRE(points.size() == 2);
  // 1 to 1/4, of mean 1.
  CHECK(points[0].weight == Approx(1.6).epsilon(1e-15));
  CHECK(points[1].weight == Approx(0.4).epsilon(1e-15));
  CHECK(points[1].deviation == 2e-3);
}

TEST_CASE("a motor beyond what is tested is doubted on either side of the range",
          "[studies][motor]") {
  const MotorDesign usual;
  CHECK(model_notes(usual).empty());
  double size = 0;
  CHECK(
      note_on(with(usual, P::amplitude, 10e-6), "amplitude", &size) ==
      "amplitude 10 um is outside 50 nm to 5 um, where the solver is tested (is its unit right?)");
  CHECK(size == Approx(2).epsilon(1e-12));
  CHECK_THAT(note_on(with(usual, P::amplitude, 25e-9), "amplitude", &size),
             Contains("amplitude 25 nm is outside"));
  CHECK(size == Approx(2).epsilon(1e-12));
  CHECK(note_on(with(usual, P::amplitude, 5e-6), "amplitude").empty());  // the end itself
  CHECK(note_on(with(usual, P::amplitude, 0), "amplitude").empty());     // has tests of its own
  CHECK(note_on(with(usual, P::kinetic_friction, 1.5), "kinetic_friction") ==
        "kinetic_friction 1.5 is outside 0 to 1, where the solver is tested");
  CHECK(note_on(with(usual, P::loss_factor, 3), "loss_factor") ==
        "loss_factor 3 is outside 0 to 2, where the solver is tested");
  // A density counts where it is given, not where the inertia is.
  CHECK_FALSE(note_on(with(usual, P::density, 2e4), "density").empty());
  CHECK(note_on(with(usual, P::inertia, 2e4 * 0.3e-3 * 0.3e-3 / 3), "density").empty());
}

TEST_CASE("ratios of a motor are doubted as its parameters are", "[studies][motor]") {
  const MotorDesign usual;  // 4 mm on 26.5 mm
  double size = 0;
  CHECK(note_on(with(usual, P::contact_width, 21.2e-3), "contact_width", &size) ==
        "contact_width / contact_radius is 0.8, outside 0.02 to 0.4, where the solver is tested");
  CHECK(size == Approx(2).epsilon(1e-12));
  CHECK_FALSE(note_on(with(usual, P::contact_width, 0.265e-3), "contact_width", &size).empty());
  CHECK(size == Approx(2).epsilon(1e-12));
  CHECK(note_on(with(usual, P::static_friction, 0.5), "static_friction", &size) ==
        "static_friction / kinetic_friction is 2.5, outside 1 to 2, where the solver is tested");
  CHECK(size == Approx(1.25).epsilon(1e-12));
  MotorDesign frictionless = usual;
  frictionless.friction = {0, 0.1};
  CHECK(note_on(frictionless, "static_friction").empty());  // there is no ratio
}

TEST_CASE("a thick layer and a contact that never opens are doubted", "[studies][motor]") {
  const MotorDesign usual;
  CHECK_THAT(note_on(with(usual, P::thickness, 4e-3), "thick layer"),
             Contains("thickness 4 mm is") && Contains("% of the contact length"));
  CHECK(note_on(with(usual, P::preload, 0), "thick layer").empty());  // there is no contact
  CHECK_THAT(note_on(with(usual, P::preload, 1e6), "full contact"),
             Contains("touches the stator all round"));
  CHECK(note_on(usual, "full contact").empty());
}

TEST_CASE("an interval needs samples enough", "[studies][statistics]") {
  Moments moments;
  CHECK(std::isnan(moments.mean_estimate(0.95).value));
  CHECK(std::isnan(moments.sd()));
  moments.add(2);
  CHECK(moments.mean_estimate(0.95).value == 2);
  CHECK(std::isnan(moments.mean_estimate(0.95).low));
  for (int i = 0; i < 2; ++i) moments.add(2);
  CHECK(moments.sd_estimate(0.95).value == 0);
  CHECK(std::isnan(moments.sd_estimate(0.95).low));  // of three draws
  moments.add(2);
  CHECK(moments.sd_estimate(0.95).low == 0);  // four equal ones have no spread
  // Six draws, and a level whose normal quantile is more than three: the correction makes no sense.
  moments.add(3);
  moments.add(4);
  CHECK(std::isnan(moments.sd_estimate(0.999).low));
  CHECK_FALSE(std::isnan(moments.sd_estimate(0.95).low));
  // Two values, equally often: a kurtosis of 1, the least there is.
  Moments two;
  for (int i = 0; i < 20; ++i) two.add(i % 2);
  CHECK(two.sd() == Approx(std::sqrt(5.0 / 19)).epsilon(1e-14));
  CHECK(two.sd_estimate(0.95).low < two.sd());
  CHECK(two.sd_estimate(0.95).high > two.sd());
}

TEST_CASE("a quantile of no draws is none, and of one is that one", "[studies][quantiles]") {
  CHECK(std::isnan(quantile_estimate({}, 0.5, 0.95).value));
  CHECK(std::isnan(proportion_estimate(0, 0, 0.95).value));
  const std::vector<double> one{7};
  CHECK(quantile_estimate(one, 0.5, 0.95).value == 7);
  CHECK(std::isnan(quantile_estimate(one, 0.5, 0.95).low));
  CHECK(std::isnan(quantile_estimate(one, 0.5, 0.95).high));
  const std::vector<double> list{1, 2, 3};
  CHECK(quantile_estimate(list, 0.5, 0.95).value == 2);
  CHECK(quantile_estimate(list, 0.25, 0.95).value == 1.5);
  // Of two draws either lies on each side of the median half of the time: 1/4 below, 1/4 above.
  const std::vector<double> two{1, 2};
  CHECK(quantile_estimate(two, 0.5, 0.5).low == 1);
  CHECK(quantile_estimate(two, 0.5, 0.5).high == 2);
  // No hit of n has the upper bound 1 - tail^(1/n), all of n have the lower bound tail^(1/n).
  const double end = std::pow(0.025, 0.1);
  CHECK(proportion_estimate(0, 10, 0.95).low == 0);
  CHECK(proportion_estimate(0, 10, 0.95).high == Approx(1 - end).epsilon(1e-12));
  CHECK(proportion_estimate(10, 10, 0.95).low == Approx(end).epsilon(1e-12));
  CHECK(proportion_estimate(10, 10, 0.95).high == 1);
}
