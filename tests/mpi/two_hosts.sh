#!/usr/bin/env bash
# Two hosts in network namespaces with a cable between them: two_hosts.sh STANDIN_SWEEP COMPARE
# One sweep on both equals a serial one to the bit; with the cable cut the run ends within the stated time.
# STANDIN_SWEEP is the program to run; COMPARE A.h5 B.h5 exits with 0 where two study files are equal to the bit.
# Exit code 77: skipped.
set -eu
sweep=$1 compare=$2
skip() { echo "two_hosts: skipped: $1"; exit 77; }
fail() { echo "two_hosts: $1" >&2; [ ! -e log ] || tail -n 30 log >&2; exit 1; }
[ "$(id -u)" -eq 0 ] || skip "only root may make network namespaces"
command -v ip >/dev/null || skip "no ip command (package iproute2)"
command -v mpirun >/dev/null || skip "no mpirun"
place=$(mktemp -d) a=cagetol-a-$$ b=cagetol-b-$$
end() {
  for host in "$a" "$b"; do
    for p in $(ip netns pids "$host" 2>/dev/null); do kill -9 "$p" 2>/dev/null || true; done
    ip netns del "$host" 2>/dev/null || true
  done
  rm -rf "$place"
}
trap end EXIT
cd "$place"
ip netns add "$a" 2>/dev/null || skip "this kernel or container allows no network namespaces"
ip netns add "$b"
ip link add cable-a netns "$a" type veth peer name cable-b netns "$b" || skip "no veth devices"
ip -n "$a" addr add 10.9.8.1/24 dev cable-a
ip -n "$b" addr add 10.9.8.2/24 dev cable-b
for device in lo cable-a; do ip -n "$a" link set "$device" up; done
for device in lo cable-b; do ip -n "$b" link set "$device" up; done

# on HOST NAME COMMAND...: with a host name of its own and both names known.
printf '127.0.0.1 localhost\n10.9.8.1 host-a\n10.9.8.2 host-b\n' > hosts
cat > on <<'END'
#!/usr/bin/env bash
space=$1 name=$2 hosts=$3; shift 3
exec ip netns exec "$space" unshare --uts --mount --propagation private bash -c \
  'hostname "$0"; mount --bind "$1" /etc/hosts; shift; exec "$@"' "$name" "$hosts" "$@"
END
# What mpirun calls in place of ssh: AGENT HOST COMMAND...
printf '#!/usr/bin/env bash\nshift\nexec %q/on %q host-b %q/hosts bash -c "$*"\n' "$place" "$b" "$place" > agent
chmod +x on agent

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none
on_both() {
  "$place/on" "$a" host-a "$place/hosts" mpirun --mca plm_rsh_agent "$place/agent" --mca btl tcp,self \
    --mca btl_tcp_if_include 10.9.8.0/24 --mca oob_tcp_if_include 10.9.8.0/24 --host host-a:2,host-b:2 -n 4 \
    -x CAGETOL_SILENCE_S "$@"
}
export CAGETOL_SILENCE_S=10

"$sweep" serial --samples 80 --mean-ms 1 2>log || fail "the serial sweep failed"
on_both "$sweep" both --samples 80 --mean-ms 40 2>log || fail "the sweep on two hosts failed"
"$compare" serial/study.h5 both/study.h5 || fail "two hosts and one differ"
echo "two_hosts: 80 samples on 2 hosts x 2 ranks equal to the bit"

# A host that has a directory of its own is named.
mkdir -p own/journal alone
on_both bash -c 'cd "$0/$([ "$(hostname)" = host-a ] && echo alone || echo own)" && exec "$1" out --samples 8' \
  "$place" "$sweep" 2>log && fail "a directory that hosts do not share went unnoticed"
grep -q 'on host-b than to rank 0 on host-a' log || fail "the hosts are not named"
echo "two_hosts: a directory that is not shared is refused"

code=0
on_both "$sweep" cut --samples 400 --mean-ms 500 2>log & job=$!
for _ in $(seq 300); do [ -n "$(find cut/journal -name '*.journal' -size +2k 2>/dev/null)" ] && break; sleep 0.1; done
sleep 3
ip -n "$a" link set cable-a down
cut=$(date +%s)
wait "$job" || code=$?
took=$(($(date +%s) - cut))
[ "$code" -ne 0 ] || fail "exit code 0 after the cut" # mpirun's own: it does not survive the loss of a host
grep -q 'on host-b.* silent for 10 s' log || fail "no message names the silent host"
# 10 s of silence, 15 s and 5 s for mpirun to end, and what a busy machine adds.
[ "$took" -le 90 ] || fail "the run ended $took s after the cut"
for _ in $(seq 60); do # the other side ends by itself
  [ -n "$(ip netns pids "$b")" ] || break
  sleep 1
done
[ -z "$(ip netns pids "$b")" ] || fail "processes are left on host-b: $(ip netns pids "$b" | xargs -n 1 ps -o args= -p)"
ip -n "$a" link set cable-a up
echo "two_hosts: cut: ended after $took s (exit code $code), host-b empty after $(($(date +%s) - cut)) s"
on_both "$sweep" cut --samples 400 --mean-ms 1 2>log || fail "the sweep does not go on after the cut"
"$sweep" whole --samples 400 --mean-ms 0.1 2>log
"$compare" whole/study.h5 cut/study.h5 || fail "going on after a cut changed a bit"
echo "two_hosts: gone on after the cut: 400 samples equal to the bit"
