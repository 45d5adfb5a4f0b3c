#include "src/input/printable.hpp"

namespace cagetol {
namespace {

unsigned char byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// C0 and C1 controls and DEL; marks of writing direction (U+200E, U+200F, U+202A to U+202E, U+2066
/// to U+2069), line and paragraph separators (U+2028, U+2029).
bool acts_on_terminals(std::string_view character) {
  const unsigned char first = byte_at(character, 0);
  if (character.size() == 1) return first < 0x20 || first == 0x7f;
  if (character.size() == 2) return first == 0xc2 && byte_at(character, 1) < 0xa0;
  if (character.size() != 3 || first != 0xe2) return false;
  const unsigned char second = byte_at(character, 1), third = byte_at(character, 2);
  return (second == 0x80 && (third == 0x8e || third == 0x8f || (third >= 0xa8 && third <= 0xae))) ||
         (second == 0x81 && third >= 0xa6 && third <= 0xa9);
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const unsigned char first = byte_at(text, 0);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xc2 && first < 0xe0 ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte_at(text, i) & 0xc0) != 0x80) return 0;
  if (length < 3) return length;
  // Forms that are too long, surrogates, and what lies behind the last character.
  const unsigned char second = byte_at(text, 1);
  const bool wrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
                     (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
  return wrong ? 0 : length;
}

std::string printable(std::string_view text, LineBreaks breaks) {
  static const char* digits = "0123456789abcdef";
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, length == 0 ? 1 : length);
    const bool kept = (character == "\n" || character == "\t") && breaks == LineBreaks::kept;
    if (length > 0 && (kept || !acts_on_terminals(character))) {
      shown += character;
    } else {
      for (std::size_t i = 0; i < character.size(); ++i) {
        const unsigned char byte = byte_at(character, i);
        shown += {'\\', 'x', digits[byte >> 4], digits[byte & 0xf]};
      }
    }
    text.remove_prefix(character.size());
  }
  return shown;
}

std::string excerpt(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return printable(text);
  std::size_t end = longest > 3 ? longest - 3 : 0;
  while (end > 0 && (byte_at(text, end) & 0xc0) == 0x80) --end;
  return printable(text.substr(0, end)) + "...";
}

}  // namespace cagetol
