#!/bin/sh
# regular_maps_test.sh PROGRAM TABLE GENUS: the table of regular maps has what the program finds up to a genus; bad input.
program=$1
table=$2
genus=$3
. "$(dirname "$0")/scratch.sh"

"$program" "$genus" >found || complain "regular_maps $genus: exit code $?"
grep '^  {"' found >rows
awk -F, -v most="$genus" '/^  \{"/ && $2 <= most' "$table" >expected
[ -s rows ] && cmp -s rows expected || complain "$(diff rows expected)"

for arguments in '' 1 x 100 '3 3'; do
  # shellcheck disable=SC2086
  "$program" $arguments >found 2>messages
  code=$?
  [ $code = 64 ] || complain "regular_maps $arguments: exit code $code, expected 64"
  grep -q -x 'regular_maps: expected GENUS, from 2 to 99' messages || complain "regular_maps $arguments: $(cat messages)"
done

[ $failures = 0 ] && echo 'all passed'
[ $failures = 0 ]
