// Messages about the progress of work, for people: on stderr, so that results on stdout stay clean.
#pragma once

namespace cagetol {

/// Sends all messages of spdlog to stderr as "cagetol: warning: TEXT"; plain information as
/// "cagetol: TEXT".
void log_to_stderr();

}  // namespace cagetol
