#!/usr/bin/env bash
# A Slurm cluster of one host, for the length of this test: slurm_requeue.sh SOURCE_DIR STANDIN_SWEEP SAME_STUDY
# The batch script drains, is queued again and ends with the study file of a serial run, to the bit; srun with a PMI that
# Open MPI cannot join is refused. Packages: slurm-wlm, munge. Exit code 77: skipped.
set -eu
source=$1 sweep=$2 same=$3
skip() { echo "slurm_requeue: skipped: $1"; exit 77; }
fail() {
  echo "slurm_requeue: $1" >&2
  for log in *.log; do echo "== $log"; tail -n 20 "$log"; done >&2
  exit 1
}
[ "$(id -u)" -eq 0 ] || skip "only root may run slurmd for others"
for program in slurmctld slurmd sbatch munged mpirun; do
  PATH=$PATH:/usr/sbin command -v "$program" >/dev/null || skip "no $program (packages slurm-wlm, munge, openmpi-bin)"
done
export PATH=$PATH:/usr/sbin
place=$(mktemp -d); chmod 755 "$place"
pids=()
end() {
  scancel --full --signal=KILL --state=RUNNING 2>/dev/null || true
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  sleep 1
  for pid in "${pids[@]}"; do kill -9 "$pid" 2>/dev/null || true; done
  rm -rf "$place"
}
trap end EXIT
cd "$place"
mkdir state spool munge build; chmod 711 munge
host=$(hostname -s)
base=$((20000 + $$ % 20000))
cat > slurm.conf <<END
ClusterName=cagetol
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$place/munge/socket
StateSaveLocation=$place/state
SlurmdSpoolDir=$place/spool
SlurmctldPidFile=$place/slurmctld.pid
SlurmdPidFile=$place/slurmd.pid
SlurmctldPort=$base
SlurmdPort=$((base + 1))
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=5
SchedulerParameters=sched_interval=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=4 RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$place/slurm.conf
dd if=/dev/urandom of=munge/key bs=1024 count=1 2>/dev/null; chmod 400 munge/key
munged --foreground --force --key-file munge/key --socket "$place/munge/socket" --pid-file munge/pid \
  --log-file "$place/munge.log" --seed-file munge/seed >munged.log 2>&1 & pids+=($!)
sleep 1
slurmctld -D -f "$SLURM_CONF" >slurmctld.log 2>&1 & pids+=($!)
slurmd -D -f "$SLURM_CONF" >slurmd.log 2>&1 & pids+=($!)
for _ in $(seq 60); do sinfo -h -o %T 2>/dev/null | grep -q idle && break; sleep 1; done
sinfo -h -o %T 2>/dev/null | grep -q idle || skip "slurmd does not come up here: $(tail -n 1 slurmd.log)"

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none
# What the batch script calls as "build/cagetol sweep STUDY -o DIRECTORY ...".
printf '#!/usr/bin/env bash\nexec %q "$4" --samples 200 --mean-ms 150\n' "$sweep" > build/cagetol
chmod +x build/cagetol
state() { squeue -h -j "$1" -o %T 2>/dev/null || true; }
restarts() { scontrol show job "$1" | grep -o 'Restarts=[0-9]*' | cut -d= -f2; }
submit() {
  sbatch --parsable --ntasks=2 --mem-per-cpu=100M --time=30 --output="$place/job-%j.log" --job-name=test \
    "$source/mc/slurm/study.sbatch" sweep study.toml "$1"
}
wait_for() { # wait_for TEXT COMMAND...: until the command holds
  local what=$1; shift
  for _ in $(seq 400); do "$@" && return 0; sleep 0.5; done
  fail "waited in vain for: $what"
}
is() { [ "$(state "$1")" = "$2" ]; }
begun() { [ -n "$(find "$1" -name '*.journal' -size +2k 2>/dev/null)" ]; }
requeued() { [ "$(restarts "$1")" = "$2" ]; }

"$sweep" serial --samples 200 --mean-ms 0.1 2>/dev/null
job=$(submit "out put")
wait_for "samples" begun "out put"
scancel --batch --signal=USR1 "$job" # what --signal=B:USR1@120 sends
wait_for "the first requeue" requeued "$job" 1
# Slurm would wait two minutes.
started_now() { scontrol update jobid="$job" starttime=now 2>/dev/null; is "$job" RUNNING; }
wait_for "the second start" started_now
scancel --batch --signal=USR1 "$job" # at once, before its ranks are up
wait_for "the second requeue" requeued "$job" 2
wait_for "the third start" started_now
finished() { [ -z "$(state "$job")" ] || is "$job" COMPLETED; }
wait_for "the end" finished
[ "$(scontrol show job "$job" | grep -o 'ExitCode=[0-9]*')" = ExitCode=0 ] || fail "the job did not end with 0"
"$same" serial/study.h5 "out put/study.h5" || fail "going on after a requeue changed a bit"
echo "slurm_requeue: drained and queued again twice, 200 samples equal to the bit"

for pmi in none pmi2; do
  code=0
  srun --mpi=$pmi -n 2 "$sweep" "foreign-$pmi" 2>srun.log || code=$?
  [ "$code" -eq 2 ] || fail "srun --mpi=$pmi: exit code $code, not 2"
  grep -q 'srun started 2 tasks' srun.log && grep -q -- '--mpi=pmix' srun.log || fail "srun --mpi=$pmi: no message"
  [ ! -e "foreign-$pmi" ] || fail "srun --mpi=$pmi: a directory was made"
done
echo "slurm_requeue: srun with a foreign PMI is refused with code 2"
srun --mpi=none -n 1 "$sweep" one --samples 5 2>srun.log || fail "one task of srun needs no MPI"
if srun --mpi=list 2>&1 | grep -qw pmix; then
  srun --mpi=pmix -n 2 "$sweep" pmix --samples 200 --mean-ms 0.1 2>srun.log || fail "srun --mpi=pmix failed"
  "$same" serial/study.h5 pmix/study.h5 || fail "srun --mpi=pmix changed a bit"
  echo "slurm_requeue: srun --mpi=pmix equal to the bit"
fi
