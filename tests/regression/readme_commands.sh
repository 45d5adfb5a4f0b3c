#!/usr/bin/env bash
# Runs the command lines of the README as they stand, on a study made short: readme_commands.sh SOURCE_DIR PROGRAM
set -eu
cd "$1"
program=$2
out=$(mktemp -d); trap 'rm -rf "$out"' EXIT
export CAGETOL_CACHE=$out/cache
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
short="--set samples=20 --set scene.window.settle_revolutions=0.5 --set scene.window.measure_revolutions=1"
lines=$(grep -E '^    .*build/cagetol ' README.md | grep -v '&&' | sed 's/ *#.*//')
[ "$(wc -l <<<"$lines")" -ge 5 ] || { echo "expected at least five command lines in README.md" >&2; exit 1; }
while read -r line; do
  command=${line//build\/cagetol/$program}
  command=${command//out\/nu205/$out\/nu205}
  command=${command//nu208.toml/$out\/nu208.toml}
  [[ $line == *" sweep "* ]] && command="$command $short --set scene.cage.mesh_density=1 --set scene.cage.corner_radius_mm=0"
  [[ $line == *" limits "* ]] && command="$command --samples 6 ${short/--set samples=20/} --set scene.cage.mesh_density=1 --set scene.cage.corner_radius_mm=0"
  [[ $line == *" cage "* ]] && command="$command --set cage.corner_radius_mm=0"
  [[ $line == *" ladder "* ]] && command="$command --samples $([[ $line == *--refine* ]] && echo 2 || echo 3)"
  [[ $line == *" ladder inputs/"* ]] && command="$command --set cage.mesh_density=2 --set cage.corner_radius_mm=0 ${short/--set samples=20/}"
  [[ $line == *" recommend "* ]] && command="$command ${short/samples=20/samples=100} --set recommend.pilot_samples=32 --set recommend.budget_samples=180 --set tolerance.target_yield=0.8 --set scene.cage.mesh_density=1 --set scene.cage.corner_radius_mm=0"
  # So few pairs resolve no bias, which ends with 1.
  [[ $line == *" compare "* ]] && command="$command || [ \$? -eq 1 ]"
  echo "+ $line"
  bash -c "$command" </dev/null >"$out/log" 2>&1 || { cat "$out/log"; echo "failed: $line" >&2; exit 1; }
  ran=$((${ran:-0} + 1))
done <<<"$lines"
[ "$ran" -eq "$(wc -l <<<"$lines")" ]
# The ladder that the README puts below the sweep is the one that its report looks for.
"$program" report "$out/nu205" --json >"$out/report.json"
grep -A1 '"evidence": {' "$out/report.json" | grep -q '"state": "measured"' || { echo "no error budget" >&2; exit 1; }
