// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor.hpp>
#include <twum/io/result_store.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// What is said about an answer, before anybody decides how it looks. Terminal, page, Markdown and pictures are
/// renderers of this: what is said, what is marked and how many digits a number has is decided here and nowhere else.
/// @cond  Parts of the program itself, its pages and pictures; no promise to other programs.
namespace twum::inline v0_1::studies::telling {

/// What a word means for the reader.
enum class Tone : unsigned char { none, good, bad };

/// A part of a sentence or of a cell.
struct Part {
  enum class Kind : unsigned char {
    words,   ///< `text` as it is
    name,    ///< a parameter, a metric or a statistic, as typed in `text`
    a_name,  ///< the same behind its article: "a peak power", "an output power"
    limit,   ///< a limit, as typed in `text`
    value,   ///< `value` in the SI unit `text`
    share,   ///< `value` in per cent
  };
  Kind kind{Kind::words};
  std::string text;
  double value{std::numeric_limits<double>::quiet_NaN()};  ///< SI; NaN: there is none
  int digits{4};                                           ///< significant ones of `value`
  Tone tone{Tone::none};                                   ///< of a word that judges
  bool strong{false};                                      ///< stands out
  bool change{false};  ///< `value` is a change: "+1.2 W", "nothing"

  Part(const char* words) : text(words) {}
  Part(std::string words) : text(std::move(words)) {}
  Part(Kind what, std::string of, double number = std::numeric_limits<double>::quiet_NaN(),
       int shown = 4)
      : kind(what), text(std::move(of)), value(number), digits(shown) {}
};

/// A sentence, a cell, a title.
using Phrase = std::vector<Part>;

/// Parts of a phrase.
/// @{
Part name_part(const std::string& name);
Part a_name_part(const std::string& name);
Part limit_part(const std::string& text);
Part value_part(double value, const std::string& unit, int digits = 4);
Part share_part(double share, int digits = 4);
Part strong(Part part);
Part change(Part part);
Part good(Part part);
Part bad(Part part);
/// @}

/// How names, limits and units are written.
enum class Writing : unsigned char {
  typed,  ///< as in files: stall_torque >= 800 mN.m
  read,   ///< as in books: stall torque ≥ 800 mN·m
  page,   ///< as in books, without a line break between a number and its unit
};

std::string written(const Part& part, Writing writing);
std::string written(const Phrase& phrase, Writing writing);

/// Cells under their heads. The first columns name the row.
struct Table {
  std::string name;  ///< of the file that it is saved to
  std::vector<Phrase> heads;
  std::vector<std::vector<Phrase>> rows;
  /// How many columns, from the first, a terminal shows; the others repeat what the sentences say. 0: all.
  std::size_t typed{0};
  std::size_t keys{1};  ///< how many columns name the row
  bool shaded{false};   ///< a cell is the darker, the nearer its number is to 1 or -1
};

/// Numbers of a chart.
struct Numbers {
  /// Where they stand in summary.json: "robust/densities/0/motors", "robust/price_over_yield/*/yield"; among the curves of
  /// a page: "motors/0/torque"; or a column of the rows: "rows/preload". A page takes them from there. Empty: they stand
  /// nowhere else.
  std::string where{};
  std::vector<double> values{};  ///< SI
};

/// How a series is drawn.
enum class Stroke : unsigned char {
  line,     ///< through its points, from left to right
  dashes,   ///< likewise, broken
  dots,     ///< at its points
  steps,    ///< from left to right, level up to the next point
  path,     ///< through its points in their order, wherever they lie
  contour,  ///< likewise, thin
  outline,  ///< over bins: x has one more than y
  bars,     ///< likewise
  area,     ///< filled, within its points
  cells,    ///< of a grid, each in the colour of its value
  stack,  ///< a part of a whole, filled, on top of the series before; nothing where a part is negative
};

/// A line or a row of marks of a chart.
struct Series {
  std::string name{};  ///< in the key; empty: not there
  Stroke stroke{Stroke::line};
  Numbers x{}, y{};
  std::string colour{"c0"};  ///< "c0" to "c6", "ink", "soft" or "faint"
  Numbers low{}, high{};     ///< edges of a band about a line
  std::string band{};        ///< name of the band in the key
  /// A state in which it is broad, in the key, such as "squeals"; and between which places of x it holds.
  /// @{
  std::string state{};
  std::vector<std::array<double, 2>> broad{};
  /// @}
  Numbers z{};  ///< of cells
};

/// An axis of a chart.
struct Axis {
  Phrase name{};
  std::string unit{};                                    ///< SI; "%" for a share
  bool zero{false};                                      ///< zero belongs to it
  double low{std::numeric_limits<double>::quiet_NaN()};  ///< ends; NaN: those of the values
  double high{std::numeric_limits<double>::quiet_NaN()};
};

/// A line across a chart.
struct Guide {
  enum class Kind : unsigned char {
    limit,     ///< at a value of the horizontal axis
    quantile,  ///< likewise
    level,     ///< at a value of the vertical axis
  };
  double at;
  Phrase text{};
  Kind kind{Kind::limit};
};

/// A range of the horizontal axis that is shaded.
struct Stretch {
  double from, to;
  std::string name{};  ///< in the key
};

/// A point of a chart with a text beside it.
struct Mark {
  double x, y;
  Phrase text{};
  std::string colour{"c1"};
  bool dot{true};    ///< false: the text alone
  bool line{false};  ///< with a dotted upright line through it
};

/// A limit at a point of a chart: a bar with teeth on the side of worse values.
struct Bound {
  double x, y;
  bool upright{false};  ///< it limits x
  bool least{true};     ///< larger values keep it
  bool broken{false};
  Phrase text{};
};

/// Bands of values over the plane of a chart, each in one colour.
struct Field {
  Phrase name{};
  std::string unit{};            ///< SI; "%" for a share
  std::vector<double> levels{};  ///< rising; band i lies between levels i and i + 1
  std::size_t columns{0}, rows{0};
  double left{0}, right{0}, bottom{0}, top{0};  ///< middles of the outermost cells
  std::vector<signed char> bands{};  ///< of the cells, row by row from the bottom; -1: no value
};

/// A picture of series over one axis.
struct Chart {
  std::string name{};  ///< of its file
  Phrase title{};
  Axis x{}, y{};
  std::vector<Series> series{};
  std::vector<Guide> guides{};
  std::vector<Mark> marks{};
  /// Values within keep the limit; infinite ends are open.
  double least{-std::numeric_limits<double>::infinity()};
  double most{std::numeric_limits<double>::infinity()};
  bool one_scale{false};  ///< both axes have the same length for the same step, as a circle needs
  Field field{};          ///< behind the series; without levels there is none
  Axis colours{};         ///< of cells
  std::vector<Bound> bounds{};
  std::vector<Series> more{};  ///< that a page adds when its reader asks for it
  std::string asked{};         ///< says the button for them
  std::vector<Stretch> shaded{};
};

/// Quantities of many designs in parallel coordinates: a line for each design.
struct Parallel {
  struct Quantity {
    Phrase name;
    std::string unit;  ///< SI
    Numbers values;
  };
  std::string name{};  ///< of the picture's file
  std::vector<Quantity> axes{};
};

/// More lines than these would be a grey block; a random sample is drawn.
inline constexpr std::size_t kMostLines = 1500;

/// A bar for each row of the section's first table. Columns by position; 0: none.
struct Bars {
  std::string name{};  ///< of the picture's file
  Phrase title{}, axis{};
  std::string unit{};        ///< SI; "%" for a share
  std::size_t of{0};         ///< column of the lengths
  std::size_t inner{0};      ///< of a part of the bar, which is dark
  std::size_t low{0};        ///< of the lower ends of intervals
  std::size_t high{0};       ///< of the upper ends
  bool both_ways{false};     ///< negative ones reach to the left; otherwise the sign is left out
  double full{0};            ///< value of a whole bar; 0: the longest
  std::string of_name{};     ///< in the key, if there are inner parts
  std::string inner_name{};  ///< likewise
};

/// One thing that is said about an answer.
struct Section {
  Phrase heading{};
  Phrase note{};                ///< how to read what follows
  std::vector<Chart> charts{};  ///< several are one picture
  std::string picture{};        ///< in which they are panels, with those of other sections
  std::size_t columns{
      0};  ///< charts in a row, where they are a matrix; one without series is a gap
  Bars bars{};
  Parallel parallel{};
  std::vector<Phrase> sentences{};
  std::vector<Phrase> remarks{};  ///< one thing each, below the sentences
  std::vector<Table> tables{};
  bool folded{false};  ///< a page shows the tables when asked for
  bool wide{true};     ///< takes the whole width of a page
  bool on_page{true};  ///< false: in pictures alone; a page lets its reader choose the axes
  /// What a page and its pictures add below the sentences, which needs a reader who points at it or chooses. Without a
  /// heading it takes the place of the section.
  std::string hook{};
};

/// The answer in a word and in two sentences, and how far it can be relied on.
struct Headline {
  enum class Look : unsigned char {
    good,   ///< answered, and shown to be so
    bad,    ///< no answer, or none that can be relied on
    plain,  ///< nothing to judge
  };
  Look look{Look::plain};
  std::string badge{};  ///< the answer in a word
  std::vector<Phrase> sentences{};
  std::vector<Phrase> remarks{};                   ///< one thing each, below the sentences
  std::string title{};                             ///< what was asked: "optimization of ring-60"
  std::string rows{"motors"};                      ///< what was evaluated
  std::string unanswered{"failed or incomplete"};  ///< what evaluations without an answer are
};

Headline headline(const StudyResult& result);

/// A motor of an answer with points of its curve.
struct MotorCurve {
  std::string name;
  Motor motor;
  std::vector<OperatingPoint> points{};  ///< in the order of their speeds
  std::size_t place{0};                  ///< among the curves of a page, which has its columns
  bool whole{true};  ///< a page has all of its columns, or speed and torque alone
};

/// The curve of a motor at so many equally spaced speeds, with some of its parameters replaced [SI]; nothing if the
/// values make no motor.
std::optional<MotorCurve> motor_curve(const std::string& name, const MotorDesign& base,
                                      const std::vector<NamedValue>& values, std::size_t points);

/// Which points of a front have a curve.
enum class FrontCurves : unsigned char {
  ends,  ///< its ends and its knee
  all,
};

/// The motors whose curves an answer shows, the one asked for last. Each costs as many operating points.
std::vector<MotorCurve> motor_curves(const StudyResult& result, std::size_t points,
                                     FrontCurves front = FrontCurves::all);

/// Charts over the speed of these motors: torque, power, efficiency, and what else there is for each of them.
std::vector<Chart> curve_charts(std::span<const MotorCurve> curves);

/// Pressure, traction and velocities over the phase of the wave: axes, and names and colours of the lines. Their numbers
/// are those of a speed, which a page takes from its cursor.
std::vector<Chart> contact_charts();

/// What a study was asked, and what it has computed, as far as it is known.
struct Sources {
  const StudyFile* study{nullptr};
  const ResultStore* rows{nullptr};
  const std::vector<MotorCurve>* curves{nullptr};  ///< see motor_curves()
};

/// What is said about an answer below its headline, in this order.
/// @param sources  ranges, curves through measured points, charts of rows and of motors are left out without them
std::vector<Section> sections(const StudyResult& result, const Sources& sources = {});

/// What a point is on its front, such as "largest peak power, knee"; empty for the others.
Phrase role_phrase(const ParetoResult& answer, std::size_t point);

}  // namespace twum::inline v0_1::studies::telling
/// @endcond
