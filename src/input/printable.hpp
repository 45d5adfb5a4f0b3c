// Text from files and command lines, fit for a terminal or a log: what such a text holds must not
// move a cursor, hide a line or look like a message of the program's own.
#pragma once

#include <string>
#include <string_view>

namespace cagetol {

enum class LineBreaks { kept, escaped };

/// `text` with control characters, marks of writing direction and bytes that are not UTF-8 as
/// \xNN. Line breaks and tabs stay where they are `kept`, as in a message of several lines.
std::string printable(std::string_view text, LineBreaks breaks = LineBreaks::escaped);

/// Length of the UTF-8 character at the start of `text`; 0 where none stands there.
std::size_t utf8_length(std::string_view text);

/// At most `longest` bytes of `text`, cut between characters and ended by "..." where something is
/// left out; printable.
std::string excerpt(std::string_view text, std::size_t longest);

}  // namespace cagetol
