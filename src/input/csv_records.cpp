#include "src/input/csv_records.hpp"

#include <algorithm>
#include <cstdint>

#include "src/input/printable.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kMostColumns = 100000;

/// Length of the blank at the start of `text`; 0 where none stands there.
std::size_t blank_length(std::string_view text) {
  for (const std::string_view blank : {" ", "\t", "\xc2\xa0", "\xef\xbb\xbf"})
    if (text.starts_with(blank)) return blank.size();
  return 0;
}

InputError not_text(const std::string& file, const std::string& problem) {
  return {{file, 0}, "", "", problem, "save the measurements as CSV with the encoding UTF-8"};
}

void append_utf8(std::string& text, std::uint32_t c) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (c < 0x80) {
    put(c);
  } else if (c < 0x800) {
    put(0xc0 | c >> 6), put(0x80 | (c & 0x3f));
  } else if (c < 0x10000) {
    put(0xe0 | c >> 12), put(0x80 | (c >> 6 & 0x3f)), put(0x80 | (c & 0x3f));
  } else {
    put(0xf0 | c >> 18), put(0x80 | (c >> 12 & 0x3f));
    put(0x80 | (c >> 6 & 0x3f)), put(0x80 | (c & 0x3f));
  }
}

std::string from_utf16(std::string_view bytes, bool little, const std::string& file) {
  if (bytes.size() % 2 != 0)
    throw not_text(file, "the file is UTF-16, but ends within a character");
  const auto unit = [&](std::size_t i) {
    const auto byte = [&](std::size_t k) {
      return std::uint32_t{static_cast<unsigned char>(bytes[k])};
    };
    return little ? byte(i) | byte(i + 1) << 8 : byte(i) << 8 | byte(i + 1);
  };
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    std::uint32_t c = unit(i);
    if (c >= 0xd800 && c < 0xe000) {
      const std::uint32_t low = i + 2 < bytes.size() ? unit(i + 2) : 0;
      if (c >= 0xdc00 || low < 0xdc00 || low >= 0xe000)
        throw not_text(file, "the file starts like UTF-16, but is none");
      c = 0x10000 + ((c - 0xd800) << 10) + (low - 0xdc00);
      i += 2;
    }
    append_utf8(text, c);
  }
  return text;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

std::string_view trimmed_field(std::string_view field) {
  while (const std::size_t length = blank_length(field)) field.remove_prefix(length);
  for (bool again = true; again;) {
    again = false;
    for (const std::string_view blank : {" ", "\t", "\xc2\xa0", "\xef\xbb\xbf"})
      if (field.ends_with(blank)) field.remove_suffix(blank.size()), again = true;
  }
  return field;
}

std::string csv_text(const std::string& bytes, const std::string& file) {
  using namespace std::string_view_literals;
  const std::string_view all = bytes;
  if (all.starts_with("\xff\xfe\0\0"sv) || all.starts_with("\0\0\xfe\xff"sv))
    throw not_text(file, "the file is UTF-32, which is not read");
  std::string text = all.starts_with("\xff\xfe")       ? from_utf16(all.substr(2), true, file)
                     : all.starts_with("\xfe\xff")     ? from_utf16(all.substr(2), false, file)
                     : all.starts_with("\xef\xbb\xbf") ? std::string(all.substr(3))
                                                       : bytes;
  const auto control = std::find_if(text.begin(), text.end(), [](unsigned char c) {
    return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7f;
  });
  if (control != text.end()) {
    const bool wide = *control == '\0';
    throw not_text(file, "this is no text: byte " + std::to_string(control - text.begin() + 1) +
                             " is a control character" +
                             (wide ? " (UTF-16 needs a byte order mark at its start)" : ""));
  }
  if (is_utf8(text)) return text;
  std::string latin;  // Latin-1: each byte is its character's number
  for (const unsigned char c : text) append_utf8(latin, c);
  return latin;
}

CsvRecords::CsvRecords(std::string_view text, std::string file, bool decimal_comma)
    : text_(text), file_(std::move(file)), decimal_comma_(decimal_comma) {}

bool CsvRecords::at_line_end() const {
  return at_ >= text_.size() || text_[at_] == '\n' || text_[at_] == '\r';
}

void CsvRecords::skip_line_end() {
  if (at_ >= text_.size()) return;
  at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
  ++line_;
}

bool CsvRecords::skip_blank() {
  const std::string_view rest = text_.substr(at_);
  const std::size_t length = blank_length(rest);
  if (length == 0 || rest[0] == separator_) return false;
  at_ += length;
  return true;
}

// At the start of the first line that is not a comment.
bool CsvRecords::take_separator_line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  std::string_view line = text_.substr(at_, end - at_);
  if (line.starts_with('"') && line.ends_with('"') && line.size() > 1)
    line = line.substr(1, line.size() - 2);
  if (line.size() != 5 || !line.starts_with("sep=") ||
      std::string_view(",;\t|:").find(line[4]) == std::string_view::npos)
    return false;
  separator_ = line[4];
  at_ = end;
  return true;
}

// At the start of the header.
void CsvRecords::choose_separator() {
  bool semicolon = false, tab = false, comma = false, quoted = false;
  for (const char c : text_.substr(at_)) {
    if (!quoted && (c == '\n' || c == '\r')) break;
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    semicolon |= c == ';', tab |= c == '\t', comma |= c == ',';
  }
  separator_ = semicolon ? ';' : tab ? '\t' : comma || !decimal_comma_ ? ',' : '\0';
}

std::string_view CsvRecords::quoted_field() {
  const std::string column = "column " + std::to_string(fields_.size() + 1);
  const int line = line_;
  const std::size_t begin = ++at_;
  bool doubled = false;
  for (;; ++at_) {
    if (at_ >= text_.size())
      throw InputError({file_, line}, column, "", "the quote that opens here is never closed",
                       "close it, or remove it");
    if (text_[at_] == '"') {
      if (at_ + 1 >= text_.size() || text_[at_ + 1] != '"') break;
      doubled = true, ++at_;
    } else if (text_[at_] == '\n' ||
               (text_[at_] == '\r' && !text_.substr(at_).starts_with("\r\n"))) {
      ++line_;
    }
  }
  std::string_view field = text_.substr(begin, at_++ - begin);
  if (doubled) {
    std::string& text = unquoted_.emplace_back();
    for (std::size_t i = 0; i < field.size(); ++i) {
      text += field[i];
      if (field[i] == '"') ++i;
    }
    field = text;
  }
  while (skip_blank()) {
  }
  if (!at_line_end() && text_[at_] != separator_)
    throw InputError({file_, line_}, column, "", "text follows the quote that ends the field",
                     "double quotes within a field (\"\"), and end the field with a separator");
  return field;
}

void CsvRecords::read_field() {
  while (skip_blank()) {
  }
  if (at_ < text_.size() && text_[at_] == '"') {
    fields_.push_back(trimmed_field(quoted_field()));
    return;
  }
  const std::size_t begin = at_;
  while (!at_line_end() && text_[at_] != separator_) ++at_;
  fields_.push_back(trimmed_field(text_.substr(begin, at_ - begin)));
}

bool CsvRecords::next() {
  while (at_ < text_.size()) {
    const std::size_t start = at_;
    while (skip_blank()) {
    }
    if (at_line_end() || text_[at_] == '#') {
      while (!at_line_end()) ++at_;
      skip_line_end();
      continue;
    }
    at_ = start;
    if (!first_line_passed_) {
      first_line_passed_ = true;
      if (take_separator_line()) continue;
    }
    if (separator_ == kUndecided) choose_separator();
    first_line_ = line_;
    fields_.clear();
    unquoted_.clear();
    for (;;) {
      read_field();
      if (fields_.size() > kMostColumns)
        throw InputError(place(), "", "",
                         "a line of more than " + std::to_string(kMostColumns) + " fields",
                         "check that this is the file you meant");
      if (at_line_end()) break;
      ++at_;
    }
    skip_line_end();
    if (std::any_of(fields_.begin(), fields_.end(), [](auto field) { return !field.empty(); }))
      return true;
  }
  return false;
}

}  // namespace cagetol
