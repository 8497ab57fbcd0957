#!/bin/sh
# filter_test.sh CERTIFY DATA: certify prints the same for every file with and without the filter, byte for byte; but for the
# work of bound files, whose cells are asked in intervals of binary64 first.
certify=$1
data=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
find "$data/certify" "$data/nets" "$data/geodesics" "$data/distances" "$data/bounds" -name '*.json' 2>/dev/null | sort >"$folder/files"
failures=0
runs=0
while IFS= read -r file; do
  runs=$((runs + 1))
  "$certify" --json "$file" >"$folder/with" 2>&1
  with=$?
  "$certify" --json --no-filter "$file" >"$folder/without" 2>&1
  [ "$with" = "$?" ] || echo "$file: other exit codes"
  if grep -q '"epsnet-cover"' "$file"; then sed -i 's/"work": [0-9]*//' "$folder/with" "$folder/without"; fi
  if ! cmp -s "$folder/with" "$folder/without"; then
    echo "$file: with and without the filter differ"
    failures=$((failures + 1))
  fi
done <"$folder/files"
echo "$runs files, $failures differ"
[ "$runs" -gt 100 ] && [ "$failures" = 0 ]
