// Page faults cost a short run a tenth of its time (src/DECISIONS.md, Speed): a process takes the
// memory that every run needs at its start, and keeps it.
#pragma once

namespace cagetol {

/// Maps the first megabytes of heap, in large pages where they fit, the program's code and the
/// upper part of the stack: one by one, as they are touched, pages would cost a fault each. Freed
/// memory then stays with the process: every sample of a flexible cage takes some megabytes and
/// frees them, and new pages would cost as much again as computing what they hold. Throws
/// std::bad_alloc where not even a megabyte is left.
void avoid_page_faults();

}  // namespace cagetol
