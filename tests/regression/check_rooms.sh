#!/usr/bin/env bash
# Which folder may include which: check_rooms.sh SOURCE_DIR. A folder may use itself and what stands behind its colon, a
# room's name alone standing for all of its folders. Every folder has a line, and no folders include each other in a circle.
set -u
cd "$1" || exit 2
law='src/numerics src/input src/contact_laws src/lubrication src/scene'
cage='src/cage/mesh src/cage/solve src/cage/stress src/cage/table'
model="$law src/operation $cage src/model"
run="$model src/newton src/contacts src/dynamics src/statics src/integration src/quantities"
sweep='mc/study_file mc/host mc/ranks mc/study mc/run mc/sweep'
allowed=$(cat <<TABLE
src/input:
src/numerics:
src/contact_laws: src/input src/numerics
src/lubrication: src/contact_laws src/numerics
src/scene: src/contact_laws src/input
src/operation: src/lubrication src/scene
src/reading: src/input src/lubrication src/operation src/scene
src/cage/mesh: src/operation src/scene
src/cage/solve: src/cage/mesh
src/cage/stress: src/cage/mesh src/cage/solve
src/cage/table: src/cage/mesh src/cage/solve src/cage/stress src/operation src/scene
src/model: $law src/operation $cage
src/newton: $model
src/contacts: $model src/newton
src/dynamics: $model src/newton src/contacts
src/statics: $model src/newton src/contacts
src/integration: $model src/newton src/dynamics
src/quantities: $model src/integration src/statics
src/catalogue: src/input src/scene src/reading src/operation src/quantities
src: $run
distributions/basics:
distributions/laws: distributions/basics
distributions: distributions/basics distributions/laws
mc/study_file: distributions
mc/host: mc/study_file src/input src/quantities
mc/ranks: mc/study_file mc/host src/input src/quantities
mc/study: mc/study_file mc/host src distributions
mc/run: mc/study_file mc/host mc/ranks mc/study src distributions
mc/sweep: mc/study_file mc/host mc/ranks mc/study mc/run src distributions
mc/ladder: $sweep src
mc/benchmark: $sweep mc/ladder src distributions analysis
mc/commands: $sweep mc/ladder mc/benchmark src distributions analysis
mc: mc/commands mc/host src/input
analysis/study: mc/study_file distributions
analysis/statistics: analysis/study mc/study_file distributions
analysis/sensitivity: analysis/study analysis/statistics mc/study_file distributions
analysis/compare: analysis/study analysis/statistics mc/study_file distributions
analysis/tolerance: analysis/study analysis/statistics analysis/sensitivity analysis/compare mc/study_file distributions
analysis/fidelity: analysis/study analysis/statistics analysis/compare mc/study_file distributions
analysis/report: analysis/study analysis/statistics analysis/sensitivity analysis/compare analysis/tolerance analysis/fidelity mc/study_file distributions
TABLE
)
includes=$(find src mc analysis distributions -name '*.[hc]pp' -print0 |
  xargs -0 grep -HnoE '^[[:space:]]*#[[:space:]]*include[[:space:]]*["<](src|mc|analysis|distributions|tests)/[^">]*')
# Lines FOLDER INCLUDED-FOLDER PLACE, the folder's own left out.
edges=$(sed -E 's|^(.*)/([^/]*:[0-9]+):.*["<](.*)/[^/]*$|\1 \3 \1/\2|' <<< "$includes" | awk '$1 != $2')
faults=$(awk -v table="$allowed" '
  BEGIN {
    lines = split(table, line, "\n")
    for (i = 1; i <= lines; ++i) {
      n = split(line[i], word, " ")
      folder = substr(word[1], 1, length(word[1]) - 1)
      known[folder] = 1
      for (k = 2; k <= n; ++k) may[folder, word[k]] = 1
    }
  }
  function room(folder) { sub("/.*", "", folder); return folder }
  !($1 in known) { print $1 " has no line in check_rooms.sh: " $3; next }
  !(($1, $2) in may) && !(room($1) != room($2) && (($1, room($2)) in may)) {
    print $1 " includes what it must not know: " $3 " " $2 }' <<< "$edges")
circle=$(cut -d' ' -f1,2 <<< "$edges" | sort -u | tsort 2>&1 > /dev/null)
# A report comes from study files alone: it runs nothing.
runs=$(grep -nE '^#include "(mc|src)/' mc/commands/report.cpp | grep -vE '"(mc/study_file/|mc/host/|mc/study/document\.hpp|mc/commands/(bearing_facts|command|output_path)\.hpp|src/input/)')
outside=$(grep -nE '#include <(mpi|hdf5)' -r src distributions; grep -nE '#include <mpi' -r analysis
          grep -nE '#include <hdf5' -r mc analysis | grep -vE '^(mc/study_file|mc/host/build_info.cpp)')
status=0
say() { [ -z "$2" ] || { echo "$1"; echo "$2"; status=1; }; }
say 'Includes against the order of rooms:' "$faults"
say 'Folders include each other in a circle:' "$circle"
say 'mc/commands/report.cpp includes what runs a bearing:' "$runs"
say 'MPI belongs to mc, HDF5 to mc/study_file (its version to mc/host/build_info.cpp):' "$outside"
exit $status
