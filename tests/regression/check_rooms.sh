#!/usr/bin/env bash
# Which room may include which: check_rooms.sh SOURCE_DIR. The roof, mc/commands and mc/main.cpp, may use every room.
set -u
cd "$1" || exit 2
status=0
check() { # ROOM ALLOWED-REGEX FILES...
  local room=$1 allowed=$2; shift 2
  local bad
  bad=$(grep -nE '^#include "' "$@" | grep -vE "#include .($allowed)")
  [ -z "$bad" ] || { echo "$room includes what it must not know:"; echo "$bad"; status=1; }
}
sources() { find "$@" -name '*.?pp' ! -path 'mc/commands/*' ! -path 'mc/main.cpp'; }
check src 'src/' $(sources src)
check distributions 'distributions/' $(sources distributions)
check analysis/format 'analysis/format/' $(sources analysis/format)
check analysis 'analysis/|distributions/' $(sources analysis)
check mc 'mc/|src/|distributions/|analysis/format/|cagetol_build.hpp' $(sources mc)
outside=$(grep -nE '#include <(mpi|hdf5)' -r src distributions; grep -nE '#include <mpi' -r analysis
          grep -nE '#include <hdf5' -r mc analysis | grep -vE '^(analysis/format|mc/build_info.cpp)')
[ -z "$outside" ] || { echo "MPI belongs to mc, HDF5 to analysis/format (its version to mc/build_info.cpp):"; echo "$outside"; status=1; }
exit $status
