#!/bin/sh
# program_test.sh CERTIFY DATA: every file of DATA/VERDICT/ gives that verdict's exit code and last line; so do usage errors
# and a full disk. Exit code 0 exactly if the last line is VERIFIED.
certify=$1
data=$2
failures=0
runs=0

# expect CODE LAST-LINE-PREFIX ARGUMENTS...
expect() {
  code=$1
  prefix=$2
  shift 2
  output=$("$certify" "$@" 2>/dev/null)
  found=$?
  last=$(printf '%s\n' "$output" | tail -n 1)
  runs=$((runs + 1))
  case $last in
    "$prefix"*) ;;
    *) found="$found with '$last'" ;;
  esac
  if [ "$found" != "$code" ]; then
    echo "certify $*: exit code $found, expected $code with '$prefix'"
    failures=$((failures + 1))
  fi
}

for file in "$data"/verified/*; do
  expect 0 VERIFIED "$file"
  expect 0 '{"verdict": "VERIFIED"' --json "$file"
done
for file in "$data"/../geodesics/*; do
  expect 0 VERIFIED "$file"
  expect 0 '{"verdict": "VERIFIED"' --json "$file"
  expect 2 'UNDECIDED: complete: ' --max-visits 10 "$file"
done
for file in "$data"/refuted/*; do expect 1 'REFUTED: ' "$file"; done
for file in "$data"/undecided/*; do expect 2 'UNDECIDED: ' "$file"; done
for file in "$data"/malformed/*; do expect 3 'MALFORMED: ' "$file"; done
expect 64 ''
expect 64 '' --no-such-option
expect 64 '' --threads -1 "$data"/verified/octagon-1-vertex.json
expect 64 '' "$data"/no-such-file.json
expect 64 '' "$data"
expect 64 '' /dev/zero
expect 64 'Exit codes' --help

good=$data/verified/octagon-1-vertex.json
if [ "$("$certify" "$good" | tail -n 1)" != VERIFIED ]; then
  echo "VERIFIED does not stand alone on the last line"
  failures=$((failures + 1))
fi
if [ -w /dev/full ]; then
  "$certify" "$good" >/dev/full 2>/dev/null
  if [ $? != 70 ]; then
    echo "a full disk does not give exit code 70"
    failures=$((failures + 1))
  fi
fi
parsed=$(mktemp)
"$certify" --print-parsed "$good" | sed '/^surface: /,$d' >"$parsed"
if ! cmp -s "$parsed" "$good" && ! "$certify" "$parsed" >/dev/null; then
  echo "what --print-parsed prints is not the document"
  failures=$((failures + 1))
fi
rm -f "$parsed"

if [ "$runs" -lt 80 ]; then
  echo "only $runs runs: are the data there?"
  failures=$((failures + 1))
fi
echo "$runs runs, $failures failures"
[ "$failures" = 0 ]
