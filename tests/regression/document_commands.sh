#!/usr/bin/env bash
# Runs the command lines of README.md and docs as they stand, in that order, on studies made short; a line that stands
# in several documents runs once: document_commands.sh SOURCE_DIR PROGRAM. Long ones run with CAGETOL_NIGHTLY=1 alone.
set -eu
source=$(realpath "$1")
out=$(mktemp -d); trap 'rm -rf "$out"' EXIT
mkdir "$out/build" "$out/log"
ln -s "$source/inputs" "$out/inputs"
ln -s "$(realpath "$2")" "$out/build/cagetol"
export CAGETOL_CACHE=$out/cache
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
window="--set scene.window.settle_revolutions=0.5 --set scene.window.measure_revolutions=1"
one_point="--set operating_point=[] --set 'limit=[{quantity=\"driving_slip_ratio\", max=0.1, source=\"short\"}]'"
given="--set scene.temperature.balance=false --set scene.lubrication.temperature_C=70 --set scene.integration.tolerance=0.02"
few="--set screen.budget_samples=20 --set recommend.pilot_samples=32 --set recommend.budget_samples=190"
coarse="--set scene.cage.mesh_density=1 --set scene.cage.corner_radius_mm=0"
# shorter LINE: the settings that make it short
shorter() {
  case $1 in
    *" sweep "*) echo "--set samples=20 --set allowed_failure_share=0.1 $window $coarse $one_point" ;;
    *" rare "*) echo "$window $coarse $one_point $given --set rare.budget_samples=101" ;;
    *" screen "* | *" recommend "*) echo "$window $coarse $one_point $given $few --set tolerance.target_yield=0.8" ;;
    *" map "*) echo "$window $coarse $one_point $given --set scene.cage.model=rigid --set map.budget_samples=20 --set map.border_samples=20" ;;
    *" ladder "*--refine*) echo "--samples 2" ;;
    *" ladder "*) echo "--samples 3 --set cage.mesh_density=2 --set cage.corner_radius_mm=0 $window" ;;
    *" rig "*) echo "--starts 3 --starts-only ${window//scene./}" ;;
    *" cage "*) echo "--set cage.mesh_density=1 --set cage.corner_radius_mm=0" ;;
    *" simulate "*) echo "${window//scene./} ${coarse//scene./}" ;;
    *" compare "*) echo "|| [ \$? -eq 1 ]" ;; # so few pairs resolve no bias, which ends with 1
  esac
}
# Indented lines that call the program, and those that prepare its files; of lines joined by && others take care.
commands_of() { grep -hE '^    (.*build/cagetol |sed )' "$@" | grep -v '&&' | sed 's/ *#.*//; s/^ *//'; }
documents=("$source"/README.md "$source"/docs/*.md)
for document in "$source/README.md" "$source/docs/guide.md"; do
  [ -n "$(commands_of "$document")" ] || { echo "no command lines in $document" >&2; exit 1; }
done
mapfile -t lines < <(commands_of "${documents[@]}" | awk '!seen[$0]++')
[ -n "${CAGETOL_NIGHTLY:-}" ] || mapfile -t lines < <(printf '%s\n' "${lines[@]}" | grep -vE ' (rare|map|rig|ladder|history) |-tight|nu206')
cd "$out"
printf 'radial_N,speed_rpm,cage_order\n1000,500,0.3990\n' >nu206-rig.csv # as the guide has it
for line in "${lines[@]}"; do
  echo "+ $line"
  bash -c "$line $(shorter "$line")" </dev/null >log/last 2>&1 || { cat log/last; echo "failed: $line" >&2; exit 1; }
done
[ -n "${CAGETOL_NIGHTLY:-}" ] || exit 0
# The ladder that the guide puts below the recommendation is the one that its report looks for.
build/cagetol report out/nu208 --json >report.json
grep -A1 '"evidence": {' report.json | grep -q '"state": "measured"' || { echo "no error budget" >&2; exit 1; }
