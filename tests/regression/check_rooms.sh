#!/usr/bin/env bash
# Which room, and which folder of src, may include which: check_rooms.sh SOURCE_DIR. The roof, mc/commands and
# mc/main.cpp, may use every room.
set -u
cd "$1" || exit 2
status=0
ours='(src|distributions|mc|analysis|tests)/' # in angle brackets, too: the project's root is an include directory
check() { # WHO ALLOWED-REGEX FILES...
  local who=$1 allowed=$2; shift 2
  local bad
  bad=$(grep -HnE "^[[:space:]]*#[[:space:]]*include[[:space:]]*(\"|<$ours)" "$@" | grep -vE "include[[:space:]]*[\"<]($allowed)")
  [ -z "$bad" ] || { echo "$who includes what it must not know:"; echo "$bad"; status=1; }
}
sources() { find "$@" -name '*.?pp' ! -path 'mc/commands/*' ! -path 'mc/benchmark/*' ! -path 'mc/main.cpp'; }
check src 'src/' $(sources src)
check src/input 'src/input/' $(sources src/input)
check src/numerics 'src/numerics/' $(sources src/numerics)
check src/scene 'src/(scene|input|lubrication)/' $(sources src/scene)
check src/cage 'src/(cage|scene)/' $(sources src/cage)
# The way of a state, and no arrow runs back up: model -> contacts -> dynamics -> integration, with the matrix beside.
laws='numerics|scene|cage|contact_laws|lubrication'
check src/contact_laws 'src/(contact_laws|numerics|scene)/' $(sources src/contact_laws)
check src/lubrication 'src/(lubrication|contact_laws|numerics|scene)/' $(sources src/lubrication)
check src/model "src/($laws|model)/" $(sources src/model)
check src/newton "src/($laws|model|newton)/" $(sources src/newton)
check src/contacts "src/($laws|model|newton|contacts)/" $(sources src/contacts)
check src/dynamics "src/($laws|model|newton|contacts|dynamics)/" $(sources src/dynamics)
check src/statics "src/($laws|model|newton|contacts|statics)/" $(sources src/statics)
check src/integration "src/($laws|model|newton|dynamics|integration)/" $(sources src/integration)
# What a run amounts to stands above how it is computed.
check 'what is below src/quantities' 'src/[a-pr-z][a-z_]*/' $(find src -mindepth 2 -name '*.?pp' ! -path 'src/quantities/*' ! -path 'src/catalogue/*')
# Bearings by designation end in a scene; nothing of src knows where a scene is from.
check src/catalogue 'src/(catalogue|scene|input|lubrication|quantities/load_rating)' $(sources src/catalogue)
check 'what is below src/catalogue' 'src/(cage|c[b-z][a-z_]*|[abd-z][a-z_]*)[./]' $(find src -name '*.?pp' ! -path 'src/catalogue/*')
check distributions 'distributions/' $(sources distributions)
check mc/study_file 'mc/study_file/|distributions/' $(sources mc/study_file)
check analysis 'analysis/|distributions/|mc/study_file/' $(sources analysis)
check mc 'mc/(study_file/|ladder/)?[a-z_0-9]+\.hpp|src/|distributions/|cagetol_build.hpp' $(sources mc)
check mc/benchmark 'mc/(study_file/|ladder/|benchmark/)?[a-z_0-9]+\.hpp|src/|distributions/|analysis/' $(find mc/benchmark -name '*.?pp')
# A report comes from study files alone: it runs nothing.
check mc/commands/report.cpp 'analysis/|mc/study_file/|mc/commands/(bearing_facts|command|output_path)\.hpp|src/input/' mc/commands/report.cpp
outside=$(grep -nE '#include <(mpi|hdf5)' -r src distributions; grep -nE '#include <mpi' -r analysis
          grep -nE '#include <hdf5' -r mc analysis | grep -vE '^(mc/study_file|mc/host/build_info.cpp)')
[ -z "$outside" ] || { echo "MPI belongs to mc, HDF5 to mc/study_file (its version to mc/host/build_info.cpp):"; echo "$outside"; status=1; }
exit $status
