// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace twum::inline v0_1::cli {

/// A picture's size on the page [points]; a PNG has two pixels for each.
struct PlotSize {
  int width;
  int height;
};

/// The file of a --plot option: format by its ending, .svg or .png.
class PlotFile {
 public:
  /// @param inputs  files being read or written by the command, which the picture must not overwrite
  /// @throws InputError for another ending, or one of the inputs
  PlotFile(std::string path, const std::vector<std::string>& inputs);

  /// Draws what a gnuplot script says and writes the picture.
  /// @throws OutputError if gnuplot is missing or fails, or the file cannot be written
  void draw(PlotSize size, const std::string& script) const;

 private:
  std::string path_;
  bool vector_graphics_;
};

/// Adds --plot.
void add_plot_option(CLI::App& command, std::string& path);

/// The file of the option, nothing if it was not given. @throws InputError as PlotFile
std::optional<PlotFile> plot_file(const std::string& path, const std::vector<std::string>& inputs);

/// A text for gnuplot: quoted such that nothing in it is a command, a markup or an escape.
std::string plot_text(std::string_view text);

/// The data block `name`: rows of numbers, NaN where there is none.
std::string plot_data(std::string_view name, const std::vector<std::vector<double>>& rows);

/// A number for a script.
std::string plot_number(double value);

}  // namespace twum::inline v0_1::cli
