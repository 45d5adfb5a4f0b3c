#!/usr/bin/env bash
# The charts of ACCURACY.md: error against cost of the methods with error control on the lubricated NU 205, rigid at three
# loads and flexible. accuracy_charts.sh SOURCE_DIR PROGRAM OUT [CHART OPTIONS]: charts go to OUT, figures to SOURCE_DIR/tests/figures.
# Ten minutes on one core; times mean something on a quiet machine only.
set -eu
source=$1 program=$2 out=$3; shift 3
chart() { # NAME SETTING...
  local name=$1 keys=(); shift
  for key in "$@"; do keys+=(--set "$key"); done
  "$program" chart "$source/inputs/scenes/nu205.toml" -o "$out/$name" --methods rodas3,rodasp,cvode-bdf --horizon-ms 0.5 \
    --replicas 0 --threads 1 "${keys[@]}" "${options[@]+"${options[@]}"}"
  cp "$out/$name/figures/chart.svg" "$source/tests/figures/chart-nu205-$name.svg"
}
options=("$@")
chart 150-N load.radial_N=150
chart 1000-N load.radial_N=1000
chart 10000-N load.radial_N=10000
chart 1000-N-flexible load.radial_N=1000 'cage.model="flexible"'
