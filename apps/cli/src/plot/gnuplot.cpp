// SPDX-License-Identifier: Apache-2.0
#include "plot/gnuplot.hpp"

#include "child_process.hpp"
#include "formats.hpp"
#include "output.hpp"

#include <twum/base/error.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <CLI/CLI.hpp>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace twum::inline v0_1::cli {
namespace {

std::string picture(const std::string& script) {
  const File in = scratch_file();
  const File out = scratch_file();
  const File errors = scratch_file();
  if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() ||
      std::fflush(in.get()) != 0) {
    throw OutputError(std::string("the plot's temporary file cannot be written: ") +
                      std::strerror(errno));
  }
  std::rewind(in.get());
  // No start-up file of the user's: the script alone decides. From its standard input gnuplot reads a letter at a time, from a file by
  // blocks.
  const ChildEnd end =
      run_program({"gnuplot", "-d", "/dev/stdin"}, in.get(), out.get(), errors.get());
  if (!end.found) {
    throw OutputError(
        "gnuplot, which draws the plots, is not installed; install the Debian package gnuplot-nox");
  }
  std::string image = contents(out.get());
  if (end.status != 0 || image.empty()) {
    throw OutputError("gnuplot could not draw the plot: " + first_words(contents(errors.get())));
  }
  return image;
}

std::string terminal(bool vector_graphics, PlotSize size) {
  const auto pixels = [&](int factor) {
    return " size " + std::to_string(factor * size.width) + "," +
           std::to_string(factor * size.height);
  };
  if (vector_graphics)
    return "set terminal svg" + pixels(1) + " font 'Arial,12' background '#ffffff'\n";
  return "set terminal pngcairo" + pixels(2) + " font 'Arial,12' fontscale 2 linewidth 2 " +
         "dashlength 0.5 pointscale 2 background '#ffffff'\n";
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return a == b || std::filesystem::equivalent(a, b, ignored);
}

}  // namespace

PlotFile::PlotFile(std::string path, const std::vector<std::string>& inputs)
    : path_(std::move(path)), vector_graphics_(format_of(path_) == "svg") {
  if (!vector_graphics_ && format_of(path_) != "png") {
    throw InputError("--plot: " + studies::quoted(path_) +
                     " must end in .svg or .png; the ending selects the format");
  }
  for (const std::string& input : inputs) {
    if (same_file(path_, input))
      throw InputError(path_ + ": is another file of this command; choose a name for --plot");
  }
}

void PlotFile::draw(PlotSize size, const std::string& script) const {
  const std::string image =
      picture("set encoding utf8\n" + terminal(vector_graphics_, size) + script);
  Output output(path_);
  output.write(image);
  output.finish();
}

void add_plot_option(CLI::App& command, std::string& path) {
  command.add_option("--plot", path, "Draw the result into this file, .svg or .png")
      ->type_name("FILE.svg|.png");
}

std::optional<PlotFile> plot_file(const std::string& path, const std::vector<std::string>& inputs) {
  if (path.empty()) return std::nullopt;
  return PlotFile(path, inputs);
}

std::string plot_text(std::string_view text) {
  // Between single quotes gnuplot knows no escape and no substitution, only '' for '.
  std::string quoted = "'";
  for (const char letter : studies::printable(text, 200)) {
    quoted += letter;
    if (letter == '\'') quoted += letter;
  }
  return quoted + "'";
}

std::string plot_number(double value) {
  return std::isfinite(value) ? studies::number_text(value) : "NaN";
}

std::string plot_data(std::string_view name, const std::vector<std::vector<double>>& rows) {
  std::string text = "$" + std::string(name) + " << END\n";
  for (const std::vector<double>& row : rows) {
    for (const double value : row) text += plot_number(value) + " ";
    text += "\n";
  }
  return text + "END\n";
}

}  // namespace twum::inline v0_1::cli
