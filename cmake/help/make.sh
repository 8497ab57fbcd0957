#!/bin/sh
# make.sh FOLDER VERSION EPSNET CERTIFY CERTIFY-EXACT: manual pages and completion, made from the --help texts of the programs:
# FOLDER/man1/*.1, FOLDER/bash/NAME, FOLDER/zsh/_NAME. An older FOLDER is replaced.
set -eu
here=$(dirname "$0")
out=$1 version=$2
shift 2
rm -rf "$out"
mkdir -p "$out/man1" "$out/bash" "$out/zsh" "$out/rows"

# rows PATH NAME...: the rows of a command, and of its subcommands.
rows() {
  path=$1
  shift
  file="$out/rows/$(echo "$*" | tr ' ' '-')"
  # The name of the program is not part of what it is asked.
  (shift && exec "$path" "$@" --help) >"$file.help"
  awk -f "$here/rows.awk" "$file.help" >"$file"
  rm "$file.help"
  echo "$*" >>"$out/commands"
  for sub in $(awk -F '\t' '$1 == "subcommand" { print $2 }' "$file"); do
    (rows "$path" "$@" "$sub")
  done
}

# values COMMAND WORD...: rows of what an argument of the command may be, as its help does not list it.
values() {
  command=$1
  shift
  printf 'value\t%s\n' "$@" >>"$out/rows/$(echo "$command" | tr ' ' '-')"
}

for path in "$@"; do
  name=$(basename "$path")
  rows "$path" "$name"
  if [ "$name" = epsnet ]; then
    values "epsnet help" $(awk -F '\t' '$1 == "subcommand" { print $2 }' "$out/rows/epsnet")
    values "epsnet surface named" $("$path" surface named --list | grep '^[^ ]')
  fi
  for shell in bash zsh; do
    prefix=
    [ $shell = bash ] || prefix=_
    grep -E "^$name( |\$)" "$out/commands" | while read -r command; do
      awk -v command="$command" '{ print command "\t" $0 }' "$out/rows/$(echo "$command" | tr ' ' '-')"
    done | awk -v PROGRAM="$name" -f "$here/$shell.awk" >"$out/$shell/$prefix$name"
  done
done

while read -r command; do
  page=$(echo "$command" | tr ' ' '-')
  parent=$(echo "$command" | sed 's/ [^ ]*$//; s/ /-/g')
  see=
  for other in "$parent" certify certify-exact epsnet; do
    case " $page $see " in *" $other "*) ;; *) see="$see $other" ;; esac
  done
  awk -v NAME="$command" -v VERSION="$version" -v SEE="${see# }" -f "$here/man.awk" "$out/rows/$page" >"$out/man1/$page.1"
done <"$out/commands"
rm -r "$out/rows" "$out/commands"
