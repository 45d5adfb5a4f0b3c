#!/usr/bin/env bash
# The Slurm script without Slurm, with a program that drains as the real one does: slurm_script.sh SOURCE_DIR
set -eu
source=$1
place=$(mktemp -d); trap 'rm -rf "$place"' EXIT
cd "$place"
mkdir bin build
cat > bin/mpirun <<'EOF'
#!/usr/bin/env bash
echo "$*" > called
trap 'touch drained; exit 75' USR1
for _ in $(seq 100); do [ -e short ] && exit 0; sleep 0.05; done
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
[ "$(cat called)" = "build/cagetol recommend a.toml -o out/a --progress plain" ] || fail "called: $(cat called)"

rm requeued; touch short
printf 'a.toml out/a\nb.toml out/b\n' > list
SLURM_ARRAY_TASK_ID=2 bash "$script" sweep list || fail "exit code $? of a run that ends by itself"
[ "$(cat called)" = "build/cagetol sweep b.toml -o out/b --progress plain" ] || fail "called: $(cat called)"
[ ! -e requeued ] || fail "a finished job was queued again"
code=0; SLURM_ARRAY_TASK_ID=3 bash "$script" sweep list 2>/dev/null || code=$?
[ "$code" -eq 2 ] || fail "exit code $code, not 2, for a line that is not there"
