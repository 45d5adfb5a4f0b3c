// A program under MPI that starts another: mpi_parent PROGRAM ARGUMENT... Ends with its exit code.
#include <mpi.h>
#include <sys/wait.h>
#include <unistd.h>

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const pid_t child = fork();
  if (child == 0) execv(argv[1], argv + 1);
  int status = 0;
  waitpid(child, &status, 0);
  MPI_Finalize();
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}
