// SPDX-License-Identifier: Apache-2.0
#include "yaml/tree_builder.hpp"

#include "yaml/syntax_words.hpp"

#include <twum/io/words.hpp>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <unordered_map>
#include <vector>

namespace twum::inline v0_1::io {
namespace {

// Thrown through the parser to end reading; the reason is in the diagnostics already.
struct StopReading {};

// Builds the tree from the parser's events and refuses what a strict file must not contain.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  YamlNode take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override;
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override;
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override;
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override;
  void OnMapEnd() override { close(); }

 private:
  // A list or mapping that is being read.
  struct Open {
    YamlNode node;
    bool key_next{true};     // mapping: the next event is a key
    bool key_usable{false};  // mapping: the pending key was accepted
    std::string key;
    SourceMark key_mark;
    std::unordered_map<std::string, SourceMark> keys;
  };

  SourceMark place(const YAML::Mark& mark);
  std::string path() const;
  void refuse(SourceMark mark, std::string found, std::string expected);
  void check_extras(SourceMark mark, const std::string& tag, YAML::anchor_t anchor);
  void check_quotation(const YAML::Mark& mark);
  void open(YamlNode node, const std::string& tag, YAML::anchor_t anchor);
  void close();
  void attach(YamlNode node);
  void accept_key(Open& mapping, const YamlNode& key);

  Diagnostics& diagnostics_;
  std::vector<Open> open_;
  YamlNode root_;
  bool has_document_{false};
  // Place of the last event. Columns are counted from there, because a line may be long.
  int last_line_{0};
  int last_byte_{0};
  int last_column_{1};
};

constexpr std::size_t kDeepest = 24;  // limit of nested lists and mappings; files of twum need six

YamlNode make(YamlNode::Kind kind, SourceMark mark, std::string text = {}) {
  YamlNode node;
  node.kind = kind;
  node.mark = mark;
  node.scalar = std::move(text);
  return node;
}

SourceMark TreeBuilder::place(const YAML::Mark& mark) {
  if (mark.line != last_line_ || mark.column < last_byte_) {
    last_line_ = mark.line;
    last_byte_ = 0;
    last_column_ = 1;
  }
  const std::string_view line = diagnostics_.source().line(mark.line + 1);
  for (; last_byte_ < mark.column && static_cast<std::size_t>(last_byte_) < line.size();
       ++last_byte_) {
    last_column_ +=
        (static_cast<unsigned char>(line[static_cast<std::size_t>(last_byte_)]) & 0xC0U) == 0x80U
            ? 0
            : 1;
  }
  return {mark.line + 1, last_column_};
}

std::string TreeBuilder::path() const {
  std::string text;
  for (const Open& level : open_) {
    const bool list = level.node.kind == YamlNode::Kind::list;
    if (!list && level.key_next) break;  // the mapping itself is meant
    const std::string step = list ? "[" + std::to_string(level.node.items.size()) + "]" : level.key;
    text += (text.empty() || list ? "" : ".") + step;
  }
  return text;
}

void TreeBuilder::refuse(SourceMark mark, std::string found, std::string expected) {
  diagnostics_.add(mark, path(), std::move(found), std::move(expected));
}

void TreeBuilder::OnDocumentStart(const YAML::Mark& mark) {
  if (!has_document_) {
    has_document_ = true;
    return;
  }
  refuse(place(mark), "more text after the end of the document", "one file holds one document");
  throw StopReading{};
}

void TreeBuilder::check_extras(SourceMark mark, const std::string& tag, YAML::anchor_t anchor) {
  if (anchor != 0) refuse(mark, "an anchor (&)", "anchors are not used here, write the value out");
  if (!tag.empty() && tag != "?" && tag != "!") {
    refuse(mark, "a tag (" + printable(tag) + ")", "tags are not used here, leave it out");
  }
}

void TreeBuilder::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) {
  check_extras(place(mark), {}, anchor);
  attach(make(YamlNode::Kind::empty, place(mark)));
}

void TreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t) {
  refuse(place(mark), "an alias (*)", "aliases are not used here, write the value out");
  attach(make(YamlNode::Kind::refused, place(mark)));
}

void TreeBuilder::OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                           const std::string& value) {
  check_extras(place(mark), tag, anchor);
  check_quotation(mark);
  attach(make(YamlNode::Kind::scalar, place(mark), value));
}

// The parser accepts a quotation without an end as one that ends with the file.
void TreeBuilder::check_quotation(const YAML::Mark& mark) {
  const std::string_view text = diagnostics_.source().text();
  auto at = static_cast<std::size_t>(mark.pos);
  if (at >= text.size() || (text[at] != '"' && text[at] != '\'')) return;
  const char quote = text[at++];
  while (at < text.size() && text[at] != quote) at += quote == '"' && text[at] == '\\' ? 2 : 1;
  if (at < text.size()) return;
  refuse(place(mark), "a quotation that does not end", "close the text with its quotation mark");
  throw StopReading{};
}

void TreeBuilder::OnSequenceStart(const YAML::Mark& mark, const std::string& tag,
                                  YAML::anchor_t anchor, YAML::EmitterStyle::value) {
  open(make(YamlNode::Kind::list, place(mark)), tag, anchor);
}

void TreeBuilder::OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                             YAML::EmitterStyle::value) {
  open(make(YamlNode::Kind::mapping, place(mark)), tag, anchor);
}

void TreeBuilder::open(YamlNode node, const std::string& tag, YAML::anchor_t anchor) {
  check_extras(node.mark, tag, anchor);
  if (open_.size() == kDeepest) {
    diagnostics_.add(node.mark, {},
                     "lists or mappings nested more than " + std::to_string(kDeepest) + " deep",
                     "is a bracket missing?");
    throw StopReading{};
  }
  open_.emplace_back();
  open_.back().node = std::move(node);
}

void TreeBuilder::close() {
  YamlNode node = std::move(open_.back().node);
  open_.pop_back();
  attach(std::move(node));
}

void TreeBuilder::attach(YamlNode node) {
  if (open_.empty()) {
    root_ = std::move(node);
    return;
  }
  Open& parent = open_.back();
  if (parent.node.kind == YamlNode::Kind::list) {
    parent.node.items.push_back(std::move(node));
  } else if (parent.key_next) {
    accept_key(parent, node);
  } else {
    if (parent.key_usable) {
      parent.node.entries.push_back({std::move(parent.key), parent.key_mark, std::move(node)});
    }
    parent.key_next = true;
  }
}

void TreeBuilder::accept_key(Open& mapping, const YamlNode& key) {
  mapping.key_usable = false;
  if (key.kind == YamlNode::Kind::refused) {
  } else if (key.kind != YamlNode::Kind::scalar) {
    refuse(key.mark, "a key that is " + std::string(kind_phrase(key.kind)), "a key must be a word");
  } else if (key.scalar == "<<") {
    refuse(key.mark, "a merge key (<<)", "merging is not supported, write the entries out");
  } else if (const auto [first, fresh] = mapping.keys.emplace(key.scalar, key.mark); !fresh) {
    const std::string parent = path();
    diagnostics_.add({key.mark, (parent.empty() ? "" : parent + ".") + key.scalar, "given twice",
                      "leave one of them out", first->second, "first given here"});
  } else {
    mapping.key_usable = true;
  }
  mapping.key = key.scalar;
  mapping.key_mark = key.mark;
  mapping.key_next = false;
}

void add_syntax_error(Diagnostics& diagnostics, const YAML::Exception& error) {
  const SourceMark mark =
      diagnostics.source().mark(std::max(error.mark.line, 0), std::max(error.mark.column, 0));
  const std::string_view line = diagnostics.source().line(mark.line);
  const std::string_view indentation = line.substr(0, line.find_first_not_of(" \t"));
  if (const auto tab = indentation.find('\t'); tab != std::string_view::npos) {
    diagnostics.add({mark.line, static_cast<int>(tab) + 1}, {}, "a tab in the indentation",
                    "indent with blanks");
    return;
  }
  if (const SyntaxWords* words = syntax_words(error.msg)) {
    diagnostics.add(mark, {}, words->found, words->expected);
  } else {
    diagnostics.add(mark, {}, "not YAML (" + printable(error.msg) + ")", "check this place");
  }
}

}  // namespace

YamlNode build_tree(Diagnostics& diagnostics) {
  TreeBuilder builder(diagnostics);
  try {
    std::istringstream text(diagnostics.source().text());
    YAML::Parser parser(text);
    if (parser.HandleNextDocument(builder)) {
      parser.HandleNextDocument(builder);  // the builder refuses a second document
      return builder.take_root();
    }
    diagnostics.add({1, 1}, {}, "an empty file", "a file begins with 'twum: 1'");
  } catch (const YAML::Exception& error) {
    add_syntax_error(diagnostics, error);
  } catch (const StopReading&) {
  }
  YamlNode nothing;
  nothing.kind = YamlNode::Kind::refused;
  return nothing;
}

}  // namespace twum::inline v0_1::io
