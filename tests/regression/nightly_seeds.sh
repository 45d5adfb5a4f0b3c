#!/usr/bin/env bash
# Does another seed give another verdict? `recommend` on the default study with several seeds; ends with 1 unless at least 8 of 10
# name the same grades and every other one says that it was close. With MINUTES not enough it ends with 75: the same command goes on.
# nightly_seeds.sh SOURCE_DIR PROGRAM OUTPUT_DIR [SEEDS [MINUTES]]
set -eu
source=$1 program=$2 out=$3 seeds=${4:-10} minutes=${5:-0}
cd "$source"
. .ci/setup.sh
build=$(sha256sum "$program"); out=$out/${build:0:12} # runs go on by the same build only
mkdir -p "$out"
ends=$(($(date +%s) + 60 * minutes))
for seed in $(seq 1 "$seeds"); do
  limit=()
  [ "$minutes" = 0 ] || limit=(timeout -s TERM $((ends > $(date +%s) ? ends - $(date +%s) : 1)))
  code=0
  "${limit[@]}" mpirun -n "$(nproc)" "$program" recommend inputs/studies/nu205.toml -o "$out/$seed" --progress off --set "seed=$seed" >"$out/$seed.log" 2>&1 || code=$?
  case $code in
    0) ;;
    1 | 2 | 3 | 70) tail -n 20 "$out/$seed.log"; exit "$code" ;;
    *) echo "seed $seed: not done, the same command goes on"; exit 75 ;;
  esac
done
/usr/bin/env python3 - "$out" "$seeds" <<'PYTHON'
import collections, json, sys
out, seeds = sys.argv[1], int(sys.argv[2])
grades, close = [], []
for seed in range(1, seeds + 1):
    verdict = json.load(open(f"{out}/{seed}/report.json"))["verdict"]
    grades.append(", ".join(f"{key} {tolerance['grade']}" for key, tolerance in sorted(verdict["tolerances"].items())))
    close.append(bool(verdict["close"]))
    print(f"seed {seed}: {grades[-1]}{', close' if close[-1] else ''}: {verdict['statement'][:160]}")
most, count = collections.Counter(grades).most_common(1)[0]
unmarked = [seed for seed in range(seeds) if grades[seed] != most and not close[seed]]
print(f"{count} of {seeds} seeds: {most}; {len(unmarked)} others not marked as close")
sys.exit(0 if count >= 0.8 * seeds and not unmarked else 1)
PYTHON
