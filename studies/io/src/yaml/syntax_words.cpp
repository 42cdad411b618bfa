// SPDX-License-Identifier: Apache-2.0
#include "yaml/syntax_words.hpp"

namespace twum::inline v0_1::io {
namespace {

constexpr SyntaxWords kWords[] = {
    {"illegal map value", "a ':' that cannot stand here",
     "check the indentation, and put a blank after the ':' of each entry"},
    {"end of map not found", "an entry that does not fit its neighbours",
     "indent the entries of one mapping alike, 'name: value' each"},
    {"end of sequence not found", "an item that does not fit its neighbours",
     "indent the items of one list alike, '- value' each"},
    {"end of sequence flow not found", "a '[' without its ']'", "close the list with ']'"},
    {"end of map flow not found", "a '{' without its '}'", "close the mapping with '}'"},
    {"illegal tab when looking for indentation", "a tab in the indentation", "indent with blanks"},
    {"illegal EOF in scalar", "a quotation that does not end",
     "close the text with its quotation mark"},
    {"unknown token", "a character that cannot begin a value",
     "put the text between quotation marks"},
    {"illegal block entry", "a '-' that cannot stand here", "check the indentation of the list"},
    {"illegal map key", "a '?' that cannot stand here", "write entries as 'name: value'"},
    {"illegal flow end", "a bracket that was never opened", "remove it, or open it"},
    {"bad file", "lists or mappings nested too deep", "is a bracket missing?"},
};

}  // namespace

const SyntaxWords* syntax_words(std::string_view parser_message) {
  for (const SyntaxWords& words : kWords) {
    if (words.parser == parser_message) return &words;
  }
  return nullptr;
}

}  // namespace twum::inline v0_1::io
