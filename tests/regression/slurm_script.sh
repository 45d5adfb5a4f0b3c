#!/usr/bin/env bash
# The Slurm script without Slurm, with a program that drains as the real one does: slurm_script.sh SOURCE_DIR
set -eu
source=$1
place=$(mktemp -d); trap 'rm -rf "$place"' EXIT
cd "$place"
mkdir bin build
cat > bin/mpirun <<'EOF'
#!/usr/bin/env bash
printf '%s|' "$@" > called
[ ! -e lost ] || { mkdir -p out/a/journal; cat lost >> out/a/journal/0-1.journal; touch -d 2001-01-01 out/a/journal/*; kill -9 $$; }
[ ! -e deaf ] || { trap '' USR1; sleep 1; rm deaf; } # ranks that are not up yet
[ -e mortal ] || trap 'touch drained; exit 75' USR1
for _ in $(seq 300); do [ -e short ] && exit 0; sleep 0.05; done
EOF
printf '#!/usr/bin/env bash\necho "$*" > requeued\n' > bin/scontrol
chmod +x bin/*
export PATH="$place/bin:$PATH" SLURM_JOB_ID=42
script=$source/mc/slurm/study.sbatch
fail() { echo "slurm_script: $1" >&2; exit 1; }

bash "$script" recommend a.toml out/a & job=$!
until [ -e called ]; do sleep 0.05; done
sleep 0.2
kill -USR1 "$job"
code=0; wait "$job" || code=$?
[ "$code" -eq 75 ] || fail "exit code $code, not 75, after the signal"
[ -e drained ] || fail "the program was not asked to drain"
[ "$(cat requeued)" = "requeue 42" ] || fail "the job was not queued again"
[ "$(cat called)" = "build/cagetol|recommend|a.toml|-o|out/a|--progress|plain|" ] || fail "called: $(cat called)"

# The signal comes before anybody watches for it: lost, it is repeated; deadly, nothing is lost.
for start in deaf mortal; do
  rm -f called drained requeued; touch "$start"
  bash "$script" sweep a.toml out/a & job=$!
  until [ -e called ]; do sleep 0.05; done
  sleep 0.2
  kill -USR1 "$job"
  code=0; wait "$job" || code=$?
  [ "$code" -eq 75 ] || fail "$start: exit code $code, not 75"
  [ "$(cat requeued)" = "requeue 42" ] || fail "$start: the job was not queued again"
  [ "$start" = mortal ] || [ -e drained ] || fail "the program was not asked again"
  rm -f "$start"
done

# A host is lost: the job goes on while its starts finish samples, told by the journals and by no clock.
for found in sample "" sample; do
  rm -f requeued; printf %s "$found" > lost
  code=0; bash "$script" sweep a.toml out/a 2>/dev/null || code=$?
  if [ -n "$found" ]; then
    [ "$code" -eq 75 ] && [ -e requeued ] || fail "exit code $code: not queued again although a sample was finished"
  else
    [ "$code" -eq 137 ] && [ ! -e requeued ] || fail "exit code $code: queued again although nothing was finished"
  fi
done
rm -f lost

rm -f requeued; touch short

# Lists: blanks where names hold none, a tab where they do.
printf 'a.toml out/a\nb.toml out/b\nmy study.toml\tour results/c d\r\nmy study.toml our results\n\nc.toml\n' > list
called_with() {
  code=0; SLURM_ARRAY_TASK_ID=$1 bash "$script" sweep list || fail "line $1: exit code $? of a run that ends by itself"
  [ "$(cat called)" = "build/cagetol|sweep|$2|-o|$3|--progress|plain|" ] || fail "called: $(cat called)"
}
called_with 2 b.toml out/b
called_with 3 "my study.toml" "our results/c d"
[ ! -e requeued ] || fail "a finished job was queued again"
for line in 4 5 6 7; do # ambiguous, empty, no directory, not there
  code=0; SLURM_ARRAY_TASK_ID=$line bash "$script" sweep list 2>message || code=$?
  [ "$code" -eq 2 ] || fail "exit code $code, not 2, for line $line"
  grep -q "list:$line: " message && grep -q remedy message || fail "line $line: $(cat message)"
done
