#!/usr/bin/env bash
# A part of a long nightly test, done once for each build: nightly_part.sh FOLDER NAME PROGRAM COMMAND...
# Success is noted in FOLDER under NAME and the hash of the file PROGRAM, so that a night that was cut short goes on with
# the parts that are left. Remove FOLDER to run all of them again.
set -eu
folder=$1 name=$2 program=$3; shift 3
hash=$(sha256sum "$program"); hash=${hash:0:16}
done_file=$folder/$name-$hash
if [ -e "$done_file" ]; then
  echo "nightly_part: $name is done for this build: $(cat "$done_file")"
  exit 0
fi
began=$(date +%s)
"$@"
mkdir -p "$folder"
echo "took $(($(date +%s) - began)) s" > "$done_file"
