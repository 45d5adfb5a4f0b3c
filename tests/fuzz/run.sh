#!/usr/bin/env bash
# Fuzzes every reader of the program under ASan and UBSan: run.sh [RUNS [READER...]]
# RUNS inputs in all (1,000,000), shared out below, most of them to readers that are fast. Resumable: a reader that has had its
# share is passed over, an interrupted one goes on with the inputs it has collected. Needs Debian's clang-14, libclang-rt-14-dev and
# llvm-14. Exit code 1 when an input crashed a reader, took longer than 20 s or 2 GB; it then lies in the folder that is named.
set -u
cd "$(dirname "$0")/../.." || exit 2
runs=${1:-1000000}; shift
build=${CAGETOL_FUZZ_BUILD:-build-fuzz}
declare -A share=([scene]=13 [duty]=13 [study]=3 [resolved]=3 [settings]=2 [csv]=30 [journal]=20 [study_file]=3 [study_data]=3
                  [cage_table]=10)
# The sources whose coverage is printed.
declare -A sources=(
  [scene]="src/input/toml_file.cpp src/input/key_table.cpp src/reading/scene_keys.cpp src/reading/check_scene.cpp src/reading/oil_keys.cpp"
  [duty]="src/reading/duty_file.cpp src/reading/check_duty.cpp src/input/csv_records.cpp"
  [study]="mc/study/study.cpp mc/study/study_inputs.cpp mc/study/study_layers.cpp mc/study/study_limits.cpp mc/study/law_reader.cpp
           mc/study/operating_points.cpp mc/study/tolerance_filling.cpp"
  [resolved]="mc/study/study.cpp mc/study/resolved_study.cpp" [settings]="src/input/toml_file.cpp mc/study/study_layers.cpp"
  [csv]="src/input/csv_records.cpp src/input/csv_heading.cpp src/input/measurement_csv.cpp" [journal]="mc/sweep/journal.cpp mc/host/byte_stream.hpp"
  [study_file]="mc/sweep/stored_study.cpp mc/study_file/file_seal.cpp mc/study_file/hdf5_reader.cpp"
  [study_data]="analysis/study/study_data.cpp analysis/study/study_plan.cpp mc/study_file/hdf5_reader.cpp"
  [cage_table]="src/cage/table/cage_table_bytes.cpp")
all=(scene duty study resolved settings csv journal study_file study_data cage_table)
for tool in clang++-14 llvm-profdata-14 llvm-cov-14; do
  command -v $tool >/dev/null || { echo "$tool is missing: apt-get install clang-14 libclang-rt-14-dev llvm-14" >&2; exit 2; }
done
readers=("$@"); [ $# -gt 0 ] || readers=("${all[@]}")
cmake -S . -B "$build" -G Ninja -DCAGETOL_FUZZ=ON -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14 \
      -DCMAKE_BUILD_TYPE=Fuzz "-DCMAKE_CXX_FLAGS_FUZZ=-O1 -g1" >/dev/null && cmake --build "$build" --target "${readers[@]/#/fuzz_}" ||
  { echo "The fuzz targets do not build." >&2; exit 2; }
export ASAN_OPTIONS=allocator_may_return_null=0:detect_leaks=1 LSAN_OPTIONS=suppressions=$PWD/tests/fuzz/leaks.txt UBSAN_OPTIONS=print_stacktrace=1
status=0
for reader in "${readers[@]}"; do
  folder=$build/fuzz/$reader; corpus=$folder/corpus; done_file=$folder/runs
  mkdir -p "$corpus" "$folder/found" "$folder/profile"
  [ -e "$corpus/seed-0" ] || "$build/fuzz_$reader" --seeds "$corpus"
  wanted=$((runs * ${share[$reader]} / 100)); had=$(cat "$done_file" 2>/dev/null || echo 0)
  while [ "$had" -lt "$wanted" ]; do
    round=$((wanted - had < 20000 ? wanted - had : 20000))
    LLVM_PROFILE_FILE="$folder/profile/%m.profraw" nice "$build/fuzz_$reader" -runs=$round -seed=$((had + 1)) -timeout=20 \
      -rss_limit_mb=2048 -max_len=20000 -len_control=10 -dict=tests/fuzz/numbers.dict -artifact_prefix="$folder/found/" \
      -print_final_stats=1 "$corpus" >"$folder/log" 2>&1
    code=$?
    executed=$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/log")
    had=$((had + ${executed:-0})); echo $had >"$done_file"
    [ $code -eq 0 ] || { status=1; echo "$reader: exit code $code after $had inputs; see $folder/log"; break; }
  done
  echo "$reader: $had inputs, $(find "$corpus" -type f | wc -l) kept, $(find "$folder/found" -type f | wc -l) that crashed or hung"
  if llvm-profdata-14 merge -sparse "$folder"/profile/*.profraw -o "$folder/profdata" 2>/dev/null; then
    for source in ${sources[$reader]}; do
      llvm-cov-14 report "$build/fuzz_$reader" -instr-profile="$folder/profdata" "$PWD/$source" 2>/dev/null |
        awk -v name="$source" '/^TOTAL/ { print "  lines covered of " name ": " $(NF - 3) }'
    done
  fi
done
exit $status
