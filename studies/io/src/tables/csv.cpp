// SPDX-License-Identifier: Apache-2.0
#include <twum/io/csv.hpp>

#include <twum/base/error.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18U;  // bytes read at a time, and of a chunk
constexpr std::size_t kLongestRecord = std::size_t{1} << 26U;

// Follows quotation marks through the bytes of a record: a mark opens a quotation only where a cell
// begins, and a doubled one inside stands for itself (it closes and opens again).
class QuoteState {
 public:
  // Place of the line feed that ends the record, npos if it is not in the text from `from` on.
  std::size_t find_end(std::string_view text) {
    for (; at_ < text.size(); ++at_) {
      const char c = text[at_];
      if (c == '"') {
        if (inside_ || cell_begins_) inside_ = !inside_;
      } else if (c == '\n' && !inside_) {
        return at_;
      }
      // A mark right after a closing mark is a doubled one and reopens the quotation.
      cell_begins_ = !inside_ && (c == ',' || c == '"');
    }
    return std::string_view::npos;
  }
  bool inside() const { return inside_; }

 private:
  std::size_t at_{0};
  bool inside_{false};
  bool cell_begins_{true};
};

}  // namespace

bool CsvReader::fill() {
  if (at_end_) return false;
  std::memmove(buffer_.data(), buffer_.data() + at_, end_ - at_);
  end_ -= at_;
  at_ = 0;
  // The block grows with a long record, which is then not copied repeatedly.
  const std::size_t room = std::max(kBlock, end_);
  if (buffer_.size() < end_ + room) buffer_.resize(end_ + room);
  const std::size_t got = bytes_(buffer_.data() + end_, room);
  end_ += got;
  bytes_read_ += got;
  at_end_ = got == 0;
  if (at_start_ && !at_end_) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    // A stream may come byte by byte.
    if (rest().size() < kMark.size() && kMark.starts_with(rest())) return fill();
    at_start_ = false;
    if (rest().starts_with(kMark)) at_ = kMark.size();
  }
  return !at_end_;
}

// Finds the record that begins at at_: its length with the line end, and its number of lines.
bool CsvReader::find_record(std::size_t& length, std::size_t& lines) {
  QuoteState quotes;
  while (true) {
    const std::string_view text = rest();
    const std::size_t feed = text.find('\n');
    const bool remark = text.starts_with('#');  // whose quotation marks mean nothing
    const bool simple = remark || (feed != std::string_view::npos &&
                                   text.substr(0, feed).find('"') == std::string_view::npos);
    const std::size_t end = simple ? feed : quotes.find_end(text);
    if (end != std::string_view::npos) {
      length = end + 1;
      break;
    }
    if (text.size() > kLongestRecord) {
      throw InputError(name_ + ":" + std::to_string(line_) +
                       ":1: a row longer than 64 MiB; is a quotation mark missing?");
    }
    if (!fill()) {
      length = rest().size();
      break;
    }
  }
  if (quotes.inside()) {
    throw InputError(name_ + ":" + std::to_string(line_) +
                     ":1: a quotation that does not end; close it with '\"'");
  }
  lines = 0;
  for (std::size_t i = 0; i < length; ++i) lines += buffer_[at_ + i] == '\n' ? 1 : 0;
  return length > 0;
}

// Appends the next record to the chunk; false at the end.
bool CsvReader::next(CsvChunk& chunk) {
  std::size_t length = 0;
  std::size_t lines = 0;
  while (find_record(length, lines)) {
    std::string_view record = rest().substr(0, length);
    if (record.ends_with('\n')) record.remove_suffix(1);
    if (record.ends_with('\r')) record.remove_suffix(1);
    const std::size_t line = line_;
    const bool blank = trimmed(record).empty() || record.starts_with('#');
    if (!blank) {
      chunk.records.push_back({chunk.text.size(), record.size(), line});
      chunk.text.append(record);
    }
    at_ += length;
    line_ += lines;
    if (!blank) return true;
  }
  return false;
}

bool CsvReader::read(CsvChunk& chunk, std::size_t most) {
  chunk.text.clear();
  chunk.records.clear();
  if (failure_) std::rethrow_exception(failure_);
  try {
    while (chunk.records.size() < most && chunk.text.size() < kBlock) {
      if (!next(chunk)) break;
    }
  } catch (const InputError&) {
    if (chunk.records.empty()) throw;
    failure_ = std::current_exception();  // records before the failure are returned first
  }
  return !chunk.records.empty();
}

CsvReader::Bytes bytes_of(std::FILE* file, const std::string& name) {
  return [file, name](char* to, std::size_t size) {
    const std::size_t got = std::fread(to, 1, size, file);
    if (got == 0 && std::ferror(file) != 0) {
      throw InputError(name + ": cannot be read: " + std::strerror(errno));
    }
    return got;
  };
}

bool split_record(std::string_view record, std::vector<std::string_view>& cells, char separator) {
  cells.clear();
  std::size_t begin = 0;
  if (record.find('"') == std::string_view::npos) {
    for (std::size_t end = record.find(separator); end != std::string_view::npos;
         end = record.find(separator, begin)) {
      cells.push_back(record.substr(begin, end - begin));
      begin = end + 1;
    }
    cells.push_back(record.substr(begin));
    return true;
  }
  bool well_formed = true;
  bool inside = false;
  bool closed = false;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const char c = record[i];
    if (c == '"') {
      const bool may = inside || i == begin || (closed && record[i - 1] == '"');
      if (may) {
        closed = inside;
        inside = !inside;
      } else {
        well_formed = false;
      }
    } else if (c == separator && !inside) {
      cells.push_back(record.substr(begin, i - begin));
      begin = i + 1;
      closed = false;
    } else if (closed && !inside) {
      well_formed = false;
    }
  }
  cells.push_back(record.substr(begin));
  return well_formed && !inside;
}

std::string cell_text(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() < 2 || !cell.starts_with('"') || !cell.ends_with('"')) return std::string(cell);
  std::string text;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    text += cell[i];
    if (cell[i] == '"' && cell[i + 1] == '"' && i + 2 < cell.size()) ++i;
  }
  return std::string(trimmed(text));
}

bool is_formula(std::string_view text) {
  constexpr std::string_view kBegins = "=+-@\t\r";
  return !text.empty() && kBegins.find(text.front()) != std::string_view::npos &&
         !parse_number(text);
}

void append_own_cell(std::string& out, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

void append_cell(std::string& out, std::string_view text) {
  append_own_cell(out, is_formula(text) ? "'" + std::string(text) : std::string(text));
}

}  // namespace twum::inline v0_1::io
