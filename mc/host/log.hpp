// Messages about the progress of work, for people: on stderr, so that results on stdout stay clean.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace cagetol {

/// Sends all messages of spdlog to stderr as "cagetol: warning: TEXT"; plain information as
/// "cagetol: TEXT".
void log_to_stderr();

/// Opens what the caller closed of stdin, stdout and stderr, on /dev/null: else the next file that
/// is opened, a journal or its lock, would take its number and get what is printed.
void open_standard_streams();

/// Prints to stderr. What cannot be written there is lost and ends nothing.
template <class... T>
void say(fmt::format_string<T...> text, T&&... values) {
  std::fputs(fmt::format(text, std::forward<T>(values)...).c_str(), stderr);
}

}  // namespace cagetol
