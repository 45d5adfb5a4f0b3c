// Makes text from files and command lines safe to print. Such text must not move the cursor, hide a
// line or imitate a message of the program.
#pragma once

#include <string>
#include <string_view>

namespace cagetol {

enum class LineBreaks { kept, escaped };

/// `text` with control characters, marks of writing direction and bytes that are not UTF-8 written
/// as \xNN. `kept` leaves line breaks and tabs as they are, for messages of several lines.
std::string printable(std::string_view text, LineBreaks breaks = LineBreaks::escaped);

/// Length of the UTF-8 character at the start of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text);

/// `text` made printable and limited to `longest` bytes. A longer text is cut between characters
/// and ends in "...".
std::string excerpt(std::string_view text, std::size_t longest);

}  // namespace cagetol
