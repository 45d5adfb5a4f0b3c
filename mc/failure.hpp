// What an exception that is nobody's bad input says to people: memory, threads and open files that
// the system refuses become a message with a remedy.
#pragma once

#include <exception>
#include <string>

namespace cagetol {

/// Whether the system refused a resource: memory (std::bad_alloc, std::length_error, ENOMEM),
/// processes or threads (EAGAIN), open files (EMFILE, ENFILE). The same command may go on where
/// there is more of it.
bool is_want_of_resources(const std::exception& problem);

/// "out of memory\n  remedy: ..." and the like for those, else what the exception says.
std::string failure_text(const std::exception& problem);

}  // namespace cagetol
