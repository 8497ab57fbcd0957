#!/bin/sh
# hostile_test.sh CERTIFY EPSNET DATA PYTHON: files below 1 MB that are made to take long or much memory (hostile_files.py) get
# their verdict within the work that docs/format.md allows them and within 1 GB.
certify=$1
epsnet=$2
data=$3
python=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
runs=0

fail() {
  echo "$1"
  failures=$((failures + 1))
}

# expect KIND LAST-LINE-PREFIX OPTIONS...
expect() {
  kind=$1
  prefix=$2
  shift 2
  runs=$((runs + 1))
  "$python" "$(dirname "$0")/hostile_files.py" "$data" "$epsnet" "$folder" "$kind" || fail "$kind: no file"
  output=$(ulimit -v 1000000 && "$certify" --threads 1 "$@" "$folder/$kind.json")
  last=$(printf '%s\n' "$output" | tail -n 1)
  work=$(printf '%s\n' "$output" | sed -n 's/^work: //p')
  case $last in
    "$prefix"*) ;;
    *) fail "$kind $*: '$last', expected '$prefix'" ;;
  esac
  [ "${work:-99999999999}" -le 23000000000 ] || fail "$kind $*: $work units of work"
  rm -f "$folder/$kind.json"
}

