#!/usr/bin/env bash
# Counts code lines, which are neither blank nor comments alone, of each language in each room:
#   count_lines.sh SOURCE_DIR [--write]
# Compares them with most_lines.txt, so that growth shows in a diff; --write writes that file anew,
# rounded up to hundreds.
set -u
here=$(cd "$(dirname "$0")" && pwd)
cd "$1" || exit 2
limits=$here/most_lines.txt
count() { # LANGUAGE ROOM: a language's files and its comments
  local files comment
  case $1 in
    C++) files='\.(cpp|hpp)$' comment='//' ;;
    Python) files='\.py$' comment='#' ;;
    templates) files='\.(j2|css)$' comment='(\{#.*#\}|/\*.*\*/)[[:space:]]*$' ;;
    JavaScript) files='\.js$' comment='//' ;;
  esac
  find "$2" -type f | grep -E "$files" | tr '\n' '\0' | xargs -0 -r cat | grep -avcE "^[[:space:]]*($comment.*)?\$"
}
counted() {
  local room language product=0 n
  for room in src mc analysis distributions tests; do
    for language in C++ Python templates JavaScript; do
      n=$(count $language $room)
      [ "$n" -eq 0 ] && continue
      echo "$room $language $n"
      [ $room != tests ] && [ $language = C++ ] && product=$((product + n))
    done
  done
  echo "product C++ $product"
}
now=$(counted)
if [ "${2:-}" = --write ]; then
  echo "$now" | awk '{print $1, $2, 100 * int(($3 + 99) / 100)}' > "$limits"
  exit 0
fi
status=0
while read -r room language n; do
  most=$(awk -v r="$room" -v l="$language" '$1 == r && $2 == l {print $3}' "$limits")
  echo "$room $language: $n of at most ${most:-0} lines"
  if [ "$n" -gt "${most:-0}" ]; then
    echo "  more than $limits allows: take lines out, or raise the number there and say why in the commit" >&2
    status=1
  fi
done <<< "$now"
exit $status
