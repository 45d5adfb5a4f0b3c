#!/usr/bin/env bash
# Documents: every relative link leads to a file, README.md has fewer than 1000 words, and prose of README.md and docs
# stays within 120 columns (tables cannot be broken): check_documents.sh SOURCE_DIR
set -u
cd "$1" || exit 2
status=0
while read -r document; do
  while read -r link; do
    [ -e "$(dirname "$document")/${link%%#*}" ] || { echo "$document links to $link, which is not there"; status=1; }
  done < <(grep -oE '\]\([^)]+\)' "$document" | sed 's/^](//; s/)$//' | grep -vE '^(https?:|mailto:|#)')
done < <(find . -name '*.md' -not -path './build*' -not -path './out/*' | LC_ALL=C sort)
words=$(wc -w <README.md)
[ "$words" -lt 1000 ] || { echo "README.md has $words words; at most 999: move what is not for everyone into docs"; status=1; }
long=$(awk 'length > 120 && !/^\|/ { print FILENAME ":" FNR ": " length " columns" }' README.md $(find docs -name '*.md'))
[ -z "$long" ] || { echo "Lines over 120 columns:"; echo "$long"; status=1; }
exit $status
