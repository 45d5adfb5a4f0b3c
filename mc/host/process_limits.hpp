// The limits that the shell or the batch system sets (ulimit): what a process cannot do with less
// of is said before it fails halfway, where no message is possible any more.
#pragma once

#include <cstddef>

namespace cagetol {

/// Least stack of the program [bytes] and least number of open files, with and without MPI; least
/// address space under MPI [bytes]. Measured: what works, with a margin of about a third.
inline constexpr std::size_t kMinimumStack = 256 << 10;
inline constexpr std::size_t kMinimumFiles = 12, kMinimumFilesOfMpi = 32;
inline constexpr std::size_t kMinimumSpaceOfMpi = std::size_t{384} << 20;

/// Raises the soft limits on stack and open files as far as the hard ones allow and sense asks.
/// A limit on file size is then met as a failed write, which has a message, not as a signal. Throws
/// InputError where they stay too small.
void require_process_limits();

/// To be called before MPI_Init, which ends the process by itself, or never ends, where it gets too
/// little. Throws InputError.
void require_limits_of_mpi();

}  // namespace cagetol
