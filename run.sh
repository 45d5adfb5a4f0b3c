#!/usr/bin/env bash
# A study, from a bare Debian 12 to its report: ./run.sh [STUDY [OUTPUT_DIR]]. Candidate tolerances are decided and confirmed.
set -euo pipefail
cd "$(dirname "$0")"
. .ci/setup.sh
study=${1:-inputs/studies/nu205.toml}
case $study in -*) sed -n '2s/^# //p' "$0"; [ "$study" = --help ] && exit 0 || exit 2 ;; esac
[ -f "$study" ] || { echo "$study: there is no such file; give the path of a study" >&2; exit 2; }
out=${2:-out/$(basename "$study" .toml)}
ranks=$(cores)
progress=plain; [ -t 2 ] && progress=line
times=
timed() { # timed NAME COMMAND...: adds the command's seconds to the last line of output
  local name=$1 began=$SECONDS; shift
  "$@"
  times+="${times:+, }$name $((SECONDS - began)) s"
}
study_and_report() {
  if grep -q '^\[\[tolerance\.dimension\]\]' "$study"; then
    echo "Looking for the tolerance of $study with $ranks ranks"
    mpirun -n "$ranks" build/cagetol recommend "$study" -o "$out" --progress "$progress"
  else
    echo "Sweeping $study with $ranks ranks"
    mpirun -n "$ranks" build/cagetol sweep "$study" -o "$out" --progress "$progress"
    build/cagetol report "$out"
  fi
}
timed packages need_packages "${program_packages[@]}" "${figure_packages[@]}"
timed build build cagetol
timed study study_and_report
echo "$times; the report is $out/report.html"
