#!/usr/bin/env bash
# What the tolerance of the default scene does to means: the lubricated NU 205 with a flexible cage, the same samples as
# run and by a tight tolerance, compared pair by pair. Ends with 1 where the limit of a judged quantity's bias is not
# below one standard error of a 1000-sample study, and with 75 where MINUTES were not enough: the same command goes on.
# nightly_bias.sh SOURCE_DIR PROGRAM OUTPUT_DIR [SAMPLES [SEED [MINUTES [KEY=VALUE...]]]]. The table in ACCURACY.md is of such a run:
# bias.json beside the sweeps, made a result by tests/validation/page/bias_results.py.
set -eu
source=$1 program=$2 out=$3 samples=${4:-12000} seed=${5:-960} minutes=${6:-0} more=("${@:7}")
judged=cage_stress_rms_MPa,cage_stress_peak_MPa,driving_slip_ratio,friction_torque_Nmm,pocket_force_rms_N
cd "$source"
. .ci/setup.sh
build=$(sha256sum "$program"); out=$out/${build:0:12}-$samples-$seed # sweeps go on by the same build only
mkdir -p "$out"
ends=$(($(date +%s) + 60 * minutes))
sweep() { # NAME KEY=VALUE...: a sweep into the directory NAME, which goes on where it ended
  local name=$1 keys=() limit=(); shift
  for key in "$@" "${more[@]}" "samples=$samples" "seed=$seed" extra_replicates=0; do keys+=(--set "$key"); done
  [ "$minutes" = 0 ] || limit=(timeout -s TERM $((ends > $(date +%s) ? ends - $(date +%s) : 1)))
  local code=0
  "${limit[@]}" mpirun -n "$(nproc)" "$program" sweep inputs/studies/nu205-rated.toml -o "$out/$name" --progress plain "${keys[@]}" || code=$?
  case $code in
    0) ;;
    1 | 2 | 3 | 70) exit "$code" ;;
    *) echo "$name: not done, the same command goes on"; exit 75 ;;
  esac
}
sweep default
sweep tight scene.integration.method='"rodasp"' scene.integration.tolerance=0.0005
biases=("$program" compare "$out/tight" "$out/default" --despite-keys --bias 1000 --judge $judged)
"${biases[@]}" --json > "$out/bias.json" || [ $? = 1 ]
"${biases[@]}"
