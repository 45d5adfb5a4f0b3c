// What the launcher (mpirun, srun) says about this process: known before MPI starts, and not always
// what MPI finds.
#pragma once

namespace cagetol {

/// Place in the team as the launcher announces it.
struct Launch {
  int rank = 0;
  int size = 1;  ///< 0: not announced
  bool under_mpi = false;
};

/// Throws InputError where srun started several tasks without a way for Open MPI to join them:
/// each would be a sweep of its own; and where another rank of MPI started this process.
Launch launch_from_environment();

/// Throws InputError when the place that MPI gave this process is not the announced one.
void check_launch(const Launch& launch, int mpi_rank, int mpi_size);

/// Ends the launcher (mpirun, or its daemon on this host) should it still run when `seconds` have
/// passed, whatever becomes of this process: with a host out of reach it may wait for ever. Does
/// nothing where the parent of this process is no launcher.
void end_launcher_after(double seconds);

}  // namespace cagetol
