#!/usr/bin/env bash
# Does the order of source files decide anything? Builds the program with all its sources in reversed order, and once more each source
# compiled alone, and runs six shipped scenes with each: every number is the same to the last bit. And no kernel has a function that
# the linker could take from another source.
# nightly_file_order.sh SOURCE_DIR BUILD_DIR PROGRAM OUTPUT_DIR
set -eu
source=$1 build=$2 program=$3 out=$4
mkdir -p "$out"
status=0
for kernel in $(grep -ohE '[a-z_/]+\.cpp' <<<"$(sed -n '/KERNELS/,/)/p' "$source/src/CMakeLists.txt")"); do
  object=$(find "$build/src" -path "*/$kernel.o")
  weak=$(nm -C "$object" | grep ' W ' || true)
  [ -z "$weak" ] || { echo "$kernel: functions that other sources may replace:"; head -n 5 <<<"$weak"; status=1; }
done

kept() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }
build() { # NAME OPTION: the program, otherwise built as the first one
  cmake -S "$source" -B "$out/$1" -G Ninja -DCAGETOL_TESTS=OFF "-D$2" "-DCMAKE_BUILD_TYPE=$(kept CMAKE_BUILD_TYPE)" \
    "-DCMAKE_CXX_COMPILER=$(kept CMAKE_CXX_COMPILER)" "-DCMAKE_CXX_FLAGS=$(kept CMAKE_CXX_FLAGS)" \
    "-DCAGETOL_PORTABLE=$(kept CAGETOL_PORTABLE)" >"$out/$1.log" 2>&1 &&
    cmake --build "$out/$1" --target cagetol >>"$out/$1.log" 2>&1 || { tail -n 30 "$out/$1.log"; exit 2; }
}
build reversed CAGETOL_REVERSE_SOURCES=ON
build alone CMAKE_UNITY_BUILD=OFF

short=(--set window.settle_revolutions=0.1 --set window.measure_revolutions=0.4)
numbers() { # PROGRAM SCENE SETTINGS...: of one run, without its time
  local program=$1 scene=$2; shift 2
  "$program" simulate "$source/inputs/scenes/$scene.toml" --json "$@" | grep -v '"wall_s"'
}
compare() { # SCENE SETTINGS...
  numbers "$program" "$@" >"$out/$1.json"
  local other
  for other in reversed alone; do
    numbers "$out/$other/cagetol" "$@" >"$out/$1-$other.json"
    cmp -s "$out/$1.json" "$out/$1-$other.json" && continue
    echo "$1 differs in the build '$other': $(diff "$out/$1.json" "$out/$1-$other.json" | grep -c '^<') numbers, the first of them"
    diff "$out/$1.json" "$out/$1-$other.json" | grep -m 2 '^[<>]'
    status=1
  done
}
export CAGETOL_CACHE=$out/cage-tables # each build makes its own
compare speed-z16                     # dry, rigid: what differs in one bit differs in all
compare speed-z16-skew
compare nu205 "${short[@]}"           # lubricated
compare nu205-thin "${short[@]}"      # with a flexible cage
compare nj308-axial "${short[@]}"     # with loaded flanges
compare nu2322-gearbox "${short[@]}"
[ "$status" = 0 ] && echo "six scenes, three builds: equal to the last bit"
exit "$status"
