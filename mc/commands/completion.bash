# bash completion of cagetol: commands, options, keys, designations and quantities as the program names them.
_cagetol() {
  local program=$1 word=$2 before=$3 command=${COMP_WORDS[1]} words=
  if [ "$before" = --set ]; then
    compopt -o nospace
    words=$("$program" --dump-default keys | sed -n 's/^| `\([a-z][^`]*\)` .*/\1=/p')
    [[ $word == scene.* ]] && words=$(sed 's/^/scene./' <<<"$words")
  elif [[ $word == -* ]]; then
    [ "$COMP_CWORD" -eq 1 ] && command=
    words=$("$program" $command --help | grep -oE -- '--[a-z][a-z-]*')
  elif [ "$COMP_CWORD" -eq 1 ]; then
    words=$("$program" --help | sed -n 's/^  \([a-z]*\)   .*/\1/p')
  elif [ "$command" = scene ]; then
    word=${word^^}
    words=$("$program" scene --list | sed -n 's/   .*//; s/ //g; /^N/p')
  elif [ "$command" = quantities ]; then
    words=$("$program" quantities | grep -oE '^[a-z][A-Za-z0-9_]*')
  else
    compopt -o filenames
    words=$(compgen -f -- "$word")
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -F _cagetol cagetol
