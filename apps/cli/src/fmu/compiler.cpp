// SPDX-License-Identifier: Apache-2.0
#include "fmu/compiler.hpp"

#include "child_process.hpp"
#include "scratch_folder.hpp"

#include <fstream>
#include <iterator>

namespace twum::inline v0_1::cli {
namespace {

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

Compiled compile_shared_library(const std::vector<SourceFile>& files) {
  const ScratchFolder folder("the compiler");
  const std::string library = folder.file("unit.so");
  std::vector<std::string> words{
      "cc", "-std=c99", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-s", "-o", library};
  for (const auto& [name, text] : files) {
    std::ofstream(folder.file(name), std::ios::binary) << text;
    if (name.ends_with(".c")) words.push_back(folder.file(name));
  }
  words.emplace_back("-lm");
  const File messages = scratch_file();
  const ChildEnd end = run_program(words, nullptr, messages.get(), messages.get());
  if (!end.found) return {"", "no C compiler 'cc' was found (Debian package gcc)"};
  if (end.status != 0)
    return {"", "the C compiler failed: " + first_words(contents(messages.get()))};
  return {bytes_of(library), ""};
}

}  // namespace twum::inline v0_1::cli
