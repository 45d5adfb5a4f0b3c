// What an exception that ends a command becomes: a message for people and an exit code. Memory,
// threads and open files that the system refuses become a message with a remedy.
#pragma once

#include <exception>
#include <string>

#include "mc/study_file/exit_code.hpp"

namespace cagetol {

/// Whether the system refused a resource: memory (std::bad_alloc, std::length_error, ENOMEM),
/// processes or threads (EAGAIN), open files (EMFILE, ENFILE). The same command may go on where
/// there is more of it.
bool is_want_of_resources(const std::exception& problem);

/// "out of memory\n  remedy: ..." and the like for those, else what the exception says.
std::string failure_text(const std::exception& problem);

/// Exit code of a command that `problem` ends: kBadInput where the user has a remedy (InputError,
/// StudyFileError, WriteError, want of resources), kUnexpected for anything else.
ExitCode exit_code_for(const std::exception& problem);

/// failure_text, preceded by "unexpected: " where the program is at fault.
std::string ending_text(const std::exception& problem);

}  // namespace cagetol
