#!/usr/bin/env bash
# The checks of rooms, format and documents find what they are there for: checks_fail.sh SOURCE_DIR. Each is provoked in
# a small tree of its own.
set -u
source=$1
tree=$(mktemp -d); trap 'rm -rf "$tree" "$tree.out"' EXIT
status=0
fresh() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/{src/{input,numerics,scene,reading,cage/{mesh,table},model,contacts,dynamics,statics,quantities,catalogue},tests} \
           "$tree"/{distributions/laws,mc/{benchmark,commands,host,run,sweep,study_file},analysis/{statistics,fidelity,report}}
  for folder in $(cd "$tree" && find src distributions mc analysis tests -type d ! -path src/cage ! -path analysis); do
    printf '#include "%s/own.hpp"\n' "$folder" > "$tree/$folder/own.cpp"
    printf '#pragma once\n' > "$tree/$folder/own.hpp"
  done
  printf '#include "src/cage/mesh/own.hpp"\n' >> "$tree/src/cage/table/own.cpp"
  printf '#include "mc/study_file/own.hpp"\n' >> "$tree/analysis/statistics/own.cpp" # all of mc that analysis may use
  printf '#include "analysis/statistics/own.hpp"\n' >> "$tree/mc/benchmark/own.cpp"
  printf '#include "analysis/report/own.hpp"\n' > "$tree/mc/commands/report.cpp"
  cp "$source/.clang-format" "$tree"
  mkdir "$tree/docs"
  printf '[docs](docs/own.md)\n' > "$tree/README.md"
  printf '[up](../README.md)\n' > "$tree/docs/own.md"
}
passes() { # CHECK: it finds nothing, or nothing in what it can check
  local code=0
  "$source/tests/regression/$1" "$tree" > "$tree.out" 2>&1 || code=$?
  [ $code -eq 0 ] || [ $code -eq 77 ]
}
expect_failure() { # CHECK WORDS FILE LINE: the check passes, and fails with these words once FILE has LINE
  fresh
  passes "$1" || { echo "$1 fails on a sound tree:"; cat "$tree.out"; status=1; }
  mkdir -p "$(dirname "$tree/$3")"
  printf '%s\n' "$4" >> "$tree/$3"
  if passes "$1"; then echo "$1 lets pass, in $3: $4"; status=1
  elif ! grep -q "$2" "$tree.out" || ! grep -q "$3" "$tree.out"; then echo "$1 does not name $2 and $3:"; cat "$tree.out"; status=1
  fi
}
rooms() { expect_failure check_rooms.sh "$@"; }
rooms '^src/dynamics includes' src/dynamics/own.cpp '#include "mc/own.hpp"'
rooms '^src includes' src/own.hpp '#include "distributions/own.hpp"'
rooms '^src includes' src/own.hpp '#  include <mc/own.hpp>'
rooms '^src/input includes' src/input/own.cpp '#include "src/scene/own.hpp"'
rooms '^src/numerics includes' src/numerics/own.hpp '#include "src/input/own.hpp"'
rooms '^src/scene includes' src/scene/own.cpp '#include "src/reading/own.hpp"'
rooms '^src/cage/mesh includes' src/cage/mesh/own.cpp '#include "src/cage/table/own.hpp"'
rooms '^src/model includes' src/model/own.hpp '#include "src/contacts/own.hpp"'
rooms '^src/contacts includes' src/contacts/own.hpp '#include "src/dynamics/own.hpp"'
rooms '^src/dynamics includes' src/dynamics/own.cpp '#include "src/statics/own.hpp"'
rooms '^src/dynamics includes' src/dynamics/own.cpp '#include "src/quantities/own.hpp"'
rooms '^src/catalogue includes' src/catalogue/own.cpp '#include "src/model/own.hpp"'
rooms '^src includes' src/own.cpp '#include "src/catalogue/own.hpp"'
rooms '^distributions includes' distributions/own.cpp '#include "src/own.hpp"'
rooms '^distributions/laws includes' distributions/laws/own.cpp '#include "distributions/own.hpp"'
rooms '^analysis/statistics includes' analysis/statistics/own.cpp '#include "src/own.hpp"'
rooms '^analysis/statistics includes' analysis/statistics/own.cpp '#include "mc/own.hpp"'
rooms '^analysis/fidelity includes' analysis/fidelity/own.cpp '#include "analysis/report/own.hpp"'
rooms '^mc/study_file includes' mc/study_file/own.cpp '#include "analysis/statistics/own.hpp"'
rooms '^mc/study_file includes' mc/study_file/own.cpp '#include "src/own.hpp"'
rooms '^mc/sweep includes' mc/sweep/own.cpp '#include "analysis/statistics/own.hpp"'
rooms '^mc/run includes' mc/run/own.cpp '#include "mc/sweep/own.hpp"'
rooms '^mc/sweep includes' mc/sweep/own.hpp '#include "mc/benchmark/own.hpp"'
rooms '^mc/benchmark includes' mc/benchmark/own.cpp '#include "mc/commands/own.hpp"'
rooms 'what runs a bearing' mc/commands/report.cpp '#include "mc/sweep/own.hpp"'
rooms 'MPI belongs to mc' src/own.cpp '#include <mpi.h>'
rooms 'MPI belongs to mc' analysis/statistics/own.cpp '#include <hdf5.h>'
rooms 'has no line' src/elsewhere/own.cpp '#include "src/input/own.hpp"'
rooms 'in a circle' src/cage/mesh/own.hpp '#include "src/cage/table/own.hpp"'
documents() { expect_failure check_documents.sh "$@"; }
documents 'links to missing.md' docs/own.md '[page](missing.md)'
documents 'links to own.md' README.md '[page](own.md#chapter)'
documents 'README.md has 1001 words' README.md "$(printf 'word %.0s' {1..1000})"
documents 'over 120 columns' docs/own.md "$(printf 'word %.0s' {1..25})"
format() { expect_failure check_format.sh "$@"; }
format 'over 100 columns' src/own.hpp "// $(printf 'word %.0s' {1..20})"
if command -v clang-format-14 >/dev/null; then
  format 'clang-format-violations' mc/host/own.cpp 'int  spaced_out = 1;'
  format 'clang-format-violations' tests/own.hpp 'inline int f() { int long_name = 1; return long_name + long_name + long_name + long_name + 1; }'
else
  fresh
  code=0; "$source/tests/regression/check_format.sh" "$tree" > /dev/null || code=$?
  [ $code -eq 77 ] || { echo "check_format.sh ends with $code, not 77, without clang-format-14"; status=1; }
fi
exit $status
