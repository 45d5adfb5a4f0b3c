#!/usr/bin/env bash
# What the default tolerance does to means: the lively scene, its rollers started anywhere within half a pitch, the same
# samples by the default and by a tenth of its tolerance, compared pair by pair. Ends with 1 where the limit of any
# quantity's bias is not below one standard error of a 1000-sample study: nightly_bias.sh SOURCE_DIR PROGRAM OUTPUT_DIR
# [SAMPLES [SEED]]. The table in ACCURACY.md is of such runs.
set -eu
source=$1 program=$2 out=$3 samples=${4:-64000} seed=${5:-950}
cd "$source"
. .ci/setup.sh
rm -rf "$out/default" "$out/tight"
mkdir -p "$out"
sweep() { # NAME KEY=VALUE...: a sweep into the directory NAME
  local name=$1 keys=(); shift
  for key in "$@" "samples=$samples" "seed=$seed"; do keys+=(--set "$key"); done
  mpirun -n "$(nproc)" "$program" sweep inputs/scenes/speed-z16-skew.toml -o "$out/$name" --progress plain "${keys[@]}" \
    --set "start.cage_phase_deg={ noise = { law = 'normal', sigma = 8 } }"
}
sweep default
sweep tight integration.tolerance=0.0001
"$program" compare "$out/tight" "$out/default" --despite-keys --bias 1000
