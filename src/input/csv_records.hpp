// The text of a CSV file as records of fields (RFC 4180, and what shops make of it).
//
// Separators are semicolons or tabs where the header has any, else commas; a first line like
// "sep=;" names another one. Fields in double quotes may hold separators, line breaks and doubled
// quotes. Lines end with LF, CRLF or CR. Empty lines, records of empty fields and lines that start
// with # are passed over.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "src/input/input_error.hpp"

namespace cagetol {

/// The bytes of a text file as UTF-8 without a byte order mark: from UTF-8, from UTF-16 with such a
/// mark, and from Latin-1 where they are no UTF-8. Throws InputError for what is no text.
std::string csv_text(const std::string& bytes, const std::string& file);

class CsvRecords {
 public:
  /// `text` must outlive the reader; `file` names it in messages. With decimal commas a comma
  /// separates columns only where the header has commas outside quotes.
  CsvRecords(std::string_view text, std::string file, bool decimal_comma);

  /// Goes to the next record; false behind the last one. Throws InputError with line and column
  /// where quotes are wrong.
  bool next();
  const std::vector<std::string_view>& fields() const { return fields_; }
  SourcePlace place() const { return {file_, first_line_}; }

 private:
  bool at_line_end() const;
  void skip_line_end();
  bool skip_blank();
  bool take_separator_line();
  void choose_separator();
  void read_field();
  std::string_view quoted_field();

  std::string_view text_;
  std::string file_;
  bool decimal_comma_;
  std::size_t at_ = 0;
  int line_ = 1, first_line_ = 0;
  static constexpr char kUndecided = '\n';
  char separator_ = kUndecided;  ///< NUL: one column
  bool first_line_passed_ = false;
  std::vector<std::string_view> fields_;
  std::deque<std::string> unquoted_;  ///< fields of this record with doubled quotes
};

/// `field` without blanks around it: spaces, tabs, no-break spaces.
std::string_view trimmed_field(std::string_view field);

}  // namespace cagetol
