#!/usr/bin/env bash
# Every C++ file as clang-format 14 writes it, and no line of a header over 100 columns (comments are left as they
# are): check_format.sh SOURCE_DIR. Other versions of clang-format differ. Ends with 77, "skipped", without it.
set -u
cd "$1" || exit 2
status=0
files=$(find src distributions mc analysis tests -name '*.?pp' | LC_ALL=C sort)
long=$(grep -HnE '^.{101,}' $(grep '\.hpp$' <<<"$files") /dev/null)
[ -z "$long" ] || { echo "Lines of headers over 100 columns:"; cut -c1-150 <<<"$long"; status=1; }
if ! command -v clang-format-14 >/dev/null; then
  echo "Formatting not checked: clang-format-14 is not installed (Debian's package clang-format-14)."
  [ $status -ne 0 ] || status=77
else
  clang-format-14 --dry-run --Werror $files ||
    { echo "Not as .clang-format has it; remedy: clang-format-14 -i FILE"; status=1; }
fi
exit $status
