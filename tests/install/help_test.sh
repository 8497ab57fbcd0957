#!/usr/bin/env bash
# help_test.sh HELP PROGRAM...: the manual pages and the completion in the folder HELP agree with `--help` of every command: they have exactly its
# options, its commands, the named values of an option, and files where files are expected.
set -u
help=$1
shift
failures=0
complain() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}
sorted() { tr ' ' '\n' | grep -v '^$' | sort | tr '\n' ' '; }
# same WHAT EXPECTED FOUND: two lists of words.
same() { [ "$(sorted <<<"$2")" = "$(sorted <<<"$3")" ] || complain "$1: expected $2, found $3"; }

# The words that bash offers after the given words.
offered_by_bash() {
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  COMPREPLY=()
  "_${1//-/_}"
  echo "${COMPREPLY[*]}"
}
# The same for zsh, whose own functions are replaced by ones that print how they are called.
offered_by_zsh() {
  zsh -f -c '
    _arguments() { for spec; do case $spec in "*:"*) ;; *) spec=${spec#\(*\)}; print -- ${spec%%\[*} ;; esac; done }
    _describe() { for entry in ${(P)2}; do print -- ${entry%%:*}; done }
    words=("${@[2,-1]}")
    CURRENT=$#words
    complete() { source "$1" }
    complete "$1"' zsh "$help/zsh/_$1" "$@"
}

# check PATH NAME...: a command, and its own commands.
check() {
  local path=$1 text page options commands sub
  shift
  text=$("$path" "${@:2}" --help)
  page=$(tr ' ' '-' <<<"$*")
  # An option's line starts with two spaces and a dash; the names end at the first space.
  options=$(grep -oE '^  -[^ ]+' <<<"$text" | tr ',' ' ' | tr '\n' ' ')
  # The line of a command starts with two spaces and a letter; it is in a group that is not of options or examples.
  commands=$(awk '/^[^ ]/ { inside = /^[A-Z][a-z ]*:$/ && !/^Examples?:$/ } inside && /^  [a-z]/ { print $1 }' <<<"$text" | tr '\n' ' ')
  expected=$((expected + 1))
  [ -f "$help/man1/$page.1" ] || complain "there is no page $page"
  same "options in the page $page" "$options" \
    "$(sed -n '/^[.]SH OPTIONS/,/^[.]SH [^O]/p' "$help/man1/$page.1" | grep -oE '^[.]BR "\\-[^ "]+' | sed 's/^.BR "//; s/\\-/-/g' | tr ',\n' '  ')"
  if [ -n "$options" ]; then
    same "bash, options of $*" "$options" "$(offered_by_bash "$@" -)"
    [ "$zsh" = no ] || same "zsh, options of $*" "$options" "$(offered_by_zsh "$@" -)"
  fi
  if [ -n "$commands" ]; then
    same "bash, commands of $*" "$commands" "$(offered_by_bash "$@" "")"
    [ "$zsh" = no ] || same "zsh, commands of $*" "$commands" "$(offered_by_zsh "$@" "")"
  else
    case $text in
      *Positionals:*"COMMAND ..."* | *"a name of --list"*) ;;  # Below.
      *Positionals:* | *": certify-exact FILE"*) same "bash, files for $*" "net.json other.json" "$(offered_by_bash "$@" "")" ;;
    esac
  fi
  for sub in $commands; do check "$path" "$@" "$sub"; done
}

zsh=$(command -v zsh || echo no)
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
mkdir "$here/files" && cd "$here/files" && touch net.json other.json || exit 1
expected=0
for path in "$@"; do
  name=$(basename "$path")
  # shellcheck disable=SC1090  # Made by the build.
  source "$help/bash/$name" || complain "bash cannot read the completion of $name"
  check "$path" "$name"
done 2>"$here/errors"
grep -v "compopt: " "$here/errors" && complain "the messages above"
[ "$expected" -ge 10 ] || complain "only $expected commands were found"
same "pages" "$expected" "$(find "$help/man1" -name '*.1' | wc -l)"

same "bash, values of --order" "weight bfs" "$(offered_by_bash epsnet draw net.json --order "")"
same "bash, commands for help" "diameter dirichlet distance distances draw" "$(offered_by_bash epsnet help d)"
same "bash, named surfaces" "bolza bring" "$(offered_by_bash epsnet surface named b)"
same "bash, files for -o" "net.json other.json" "$(offered_by_bash epsnet net s.json -o "" 2>/dev/null)"
same "bash, files that begin with n" "net.json" "$(offered_by_bash epsnet draw n 2>/dev/null)"
same "bash, a number" "" "$(offered_by_bash epsnet net s.json --epsilon "")"
same "bash, an option begun" "--pseudo" "$(offered_by_bash epsnet net s.json --ps)"
same "bash, a command begun" "octagon" "$(offered_by_bash epsnet surface oc)"

if command -v man >/dev/null; then
  for page in "$help"/man1/*.1; do
    LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings=all -l "$page" 2>&1 >/dev/null | grep . && complain "$page: the warnings above"
  done
fi
[ $failures -eq 0 ] && echo "the pages and the completion say what --help says"
