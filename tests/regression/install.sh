#!/usr/bin/env bash
# An installed program that was moved: a small study, its report, manual page, completion. install.sh BUILD_DIR
set -eu
build=$1
place=$(mktemp -d); trap 'rm -rf "$place"' EXIT
fail() { echo "install: $1" >&2; exit 1; }
export CAGETOL_CACHE=$place/cache OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
cmake --install "$build" --prefix "$place/first" >"$place/log" || { cat "$place/log"; fail "does not install"; }
mkdir "$place/moved by hand"
mv "$place/first" "$place/moved by hand/cagetol"
home="$place/moved by hand/cagetol"
program=$home/bin/cagetol
short=(--set samples=8 --set scene.cage.model=rigid --set scene.window.settle_revolutions=0.2
       --set scene.window.measure_revolutions=0.5)
"$program" sweep "$home/share/cagetol/inputs/studies/nu205-rated.toml" -o "$place/out" "${short[@]}" >"$place/log" 2>&1 ||
  { cat "$place/log"; fail "no sweep"; }
"$program" report "$place/out" >"$place/log" 2>&1 || { cat "$place/log"; fail "no report"; }
grep -q '<svg\|image/svg' "$place/out/report.html" || fail "the report has no figures"
# Its own scripts draw, not those of the tree it was built from.
echo 'raise SystemExit("drawn by the moved one")' >"$home/share/cagetol/analysis/figures/draw.py"
"$program" report "$place/out" >"$place/log" 2>&1 || true
grep -rq 'drawn by the moved one' "$place/log" "$place/out/figures/draw.log" 2>/dev/null || fail "draws with other scripts than its own"
"$(dirname "$0")/check_documents.sh" "$home/share/doc/cagetol" || fail "its documents are not whole"

# Without its scripts it says where they should be, and takes no others.
mv "$home/share/cagetol" "$home/away"
"$program" report "$place/out" >"$place/log" 2>&1 || true
grep -q "share/cagetol" "$place/log" || fail "does not say that its scripts are missing: $(cat "$place/log")"
mv "$home/away" "$home/share/cagetol"

man -l "$home/share/man/man1/cagetol.1" >"$place/manual" 2>/dev/null || cp "$home/share/man/man1/cagetol.1" "$place/manual"
for command in check simulate sweep recommend scene; do
  grep -q "$command" "$place/manual" || fail "the manual page leaves out $command"
done
completed() { # WORD... : what the completion offers for the last of these words
  bash -c 'compopt() { :; }; . "$1"; program=$2; shift 2; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
           _cagetol "$program" "${@: -1}" "${@: -2:1}"; printf "%s\n" "${COMPREPLY[@]}"' - \
       "$home/share/bash-completion/completions/cagetol" "$program" "$@"
}
completed cagetol rec | grep -qx recommend || fail "completes no command"
completed cagetol scene nu208 | grep -qx NU208ECP || fail "completes no designation"
completed cagetol sweep --pro | grep -qx -- --progress || fail "completes no option"
completed cagetol sweep --set scene.load.rad | grep -qx scene.load.radial_N= || fail "completes no key"
