#!/usr/bin/env bash
# The animations of a sample's page and of the report play, in a browser without a window: animation.sh PROGRAM
# Without Debian's chromium it is skipped (77).
set -eu
program=$1
command -v chromium >/dev/null || exit 77
place=$(mktemp -d); trap 'rm -rf "$place"' EXIT
fail() { echo "animation: $1" >&2; exit 1; }
"$program" sweep "$(dirname "$0")/../../inputs/studies/nu205-rated.toml" -o "$place/out" --set samples=4 --set extra_replicates=0 \
  --set scene.cage.model=rigid --set scene.window.settle_revolutions=0.2 --set scene.window.measure_revolutions=0.5 \
  >"$place/log" 2>&1 || { cat "$place/log"; fail "no sweep"; }
"$program" report "$place/out" >"$place/log" 2>&1 || { cat "$place/log"; fail "no report"; }
"$program" animate "$place/out" --sample 2 >"$place/log" 2>&1 || { cat "$place/log"; fail "no page"; }
played() { # PAGE MOTIONS: so many motions, each beyond its first frame after two seconds of the page's time
  chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=2000 --dump-dom "file://$1" 2>"$place/log" |
    grep -o 'data-frame="[0-9]*"' | grep -vc 'data-frame="0"' | grep -qx "$2" || { tail -n 5 "$place/log"; fail "$1 does not play"; }
}
played "$place/out/motion-2.html" 1
played "$place/out/report.html" 2
