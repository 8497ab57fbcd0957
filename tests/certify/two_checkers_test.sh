#!/bin/sh
# two_checkers_test.sh CERTIFY CONTRARY EPSNET DATA: the output says whether the second checker agrees, does not run, or
# does not know the kind of file. CONTRARY is certify with a second checker whose verdict is EPSNET_SECOND_VERDICT.
certify=$1
contrary=$2
epsnet=$3
data=$4
failures=0
runs=0
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "$*"
  failures=$((failures + 1))
}
# expect CODE LINES COMMAND...: the exit code, and that each of the LINES is a line of stdout, the last one the last.
expect() {
  code=$1
  lines=$2
  shift 2
  runs=$((runs + 1))
  "$@" >"$folder/out" 2>&1
  found=$?
  [ "$found" = "$code" ] || fail "$*: exit code $found, expected $code"
  printf '%s\n' "$lines" >"$folder/lines"
  while IFS= read -r line; do
    grep -Fqx -- "$line" "$folder/out" || fail "$*: no line '$line'"
  done <"$folder/lines"
  [ "$(tail -n 1 "$folder/out")" = "$(tail -n 1 "$folder/lines")" ] || fail "$*: the last line is not '$line'"
}

good=$data/verified/octagon-9-vertices.json
regular=$data/verified/regular-2-10-vertices.json
refuted=$data/refuted/surface-torus.json
malformed=$data/malformed/empty.json
undecided=$data/undecided/packing-epsilon-is-the-edge-length-to-2600-digits.json

# The two agree; or the file is not for the second one.
expect 0 "second checker: VERIFIED
verified by: certify and certify-exact
VERIFIED" "$certify" "$good"
expect 0 "second checker: VERIFIED
verified by: certify and certify-exact
VERIFIED" "$certify" "$regular"
expect 0 "second checker: not asked, not for this checker: so many loops of such lengths
verified by: certify
VERIFIED" "$certify" "$data/../geodesics/one-cuff-of-1e-8.json"
for file in geodesics/three-cuffs isometries/octagon-5 isometries/bolza pants/bolza pants/octagon-5 eigenvalues/bolza \
  eigenvalues/octagon-5 eigenvalues/octagon-5-with-a-function forgeries/spectrum; do
  expect 0 "second checker: VERIFIED
verified by: certify and certify-exact
VERIFIED" "$certify" "$data/../$file.json"
done
"$certify" "$refuted" | grep -q '^second checker: REFUTED: surface: ' || fail "the torus is not refuted twice"
"$certify" "$refuted" | grep -q '^verified by: ' && fail "the torus is verified by somebody"

# Every pair of verdicts. They disagree where one verifies, and the other refutes or finds malformed.
why='the two checkers disagree: certify says'
report='; please report this, with the file, to the authors of epsnet'
second='REFUTED: delaunay: no edge is?Delaunay'
export EPSNET_SECOND_VERDICT
EPSNET_SECOND_VERDICT=VERIFIED
expect 0 "verified by: certify and certify-exact
VERIFIED" "$contrary" "$good"
"$contrary" --json "$refuted" | grep -q '^{"verdict": "UNDECIDED", .*"rule": "agreement", ' || fail "--json: no disagreement"
for file in "$refuted" "$malformed"; do
  "$contrary" "$file" >"$folder/out"
  [ $? = 4 ] || fail "$file: the exit code is not that of a disagreement"
  tail -n 1 "$folder/out" | grep -q "^UNDECIDED: agreement: $why .*; certify-exact says VERIFIED$report\$" ||
    fail "$file: no disagreement"
done
"$contrary" "$undecided" | tail -n 1 | grep -q '^UNDECIDED: packing: ' || fail "an undecided file is not undecided"
EPSNET_SECOND_VERDICT=REFUTED
expect 4 "second checker: $second
UNDECIDED: agreement: $why VERIFIED; certify-exact says $second$report" "$contrary" "$good"
expect 4 "UNDECIDED: \"$good\": agreement: $why VERIFIED; certify-exact says $second$report" "$contrary" "$good" "$regular"
"$contrary" --json "$good" | grep -q '^{"verdict": "UNDECIDED", .*"verified_by": \[\]' || fail "--json: verified by somebody"
EPSNET_SECOND_VERDICT=MALFORMED
expect 4 "UNDECIDED: agreement: $why VERIFIED; certify-exact says MALFORMED: not JSON$report" "$contrary" "$good"
for EPSNET_SECOND_VERDICT in REFUTED MALFORMED UNDECIDED; do
  for file in "$refuted" "$malformed" "$undecided"; do
    runs=$((runs + 1))
    "$certify" "$file" | tail -n 1 >"$folder/first"
    "$contrary" "$file" | tail -n 1 | cmp -s - "$folder/first" || fail "$file: $EPSNET_SECOND_VERDICT changes the verdict"
  done
done
EPSNET_SECOND_VERDICT=UNDECIDED
expect 0 "second checker: not asked, not for this checker: any
verified by: certify
VERIFIED" "$contrary" "$good"

# A fault of the program is no verdict, and has an exit code of its own; the other files are checked.
EPSNET_SECOND_VERDICT=FAULT
fault='a fault of this program: made for a test; please report this, with the file, to the authors of epsnet'
expect 71 "certify: \"$good\": $fault
ERROR: $fault" "$contrary" "$good"
expect 71 "\"$good\": ERROR: $fault
verified: 0 of 2 files
ERROR: \"$good\": $fault" "$contrary" "$good" "$refuted"
grep -q VERIFIED "$folder/out" && fail "a fault of the program verifies something"
"$contrary" --json "$good" 2>/dev/null | grep -q "^{\"verdict\": null, .*\"error\": \"$fault\"}\$" || fail "--json: no fault"

# For a large net the second checker only runs with --exact.
"$epsnet" surface octagon --seed 1 -o "$folder/s.json" >/dev/null
"$epsnet" net "$folder/s.json" --epsilon 0.027 -o "$folder/large.json" >/dev/null
EPSNET_SECOND_VERDICT=REFUTED
expect 0 "second checker: not asked, more than 20000 triangles or 4 MB; --exact asks it
verified by: certify
VERIFIED" "$contrary" "$folder/large.json"
"$contrary" --json "$folder/large.json" | grep -q '"second_checker": null, "verified_by": \["certify"\]' ||
  fail "--json: the second checker was asked"
expect 4 "UNDECIDED: agreement: $why VERIFIED; certify-exact says $second$report" "$contrary" --exact "$folder/large.json"
expect 0 "second checker: VERIFIED
verified by: certify and certify-exact
VERIFIED" "$certify" --exact "$folder/large.json"

echo "$runs runs, $failures failures"
[ "$failures" = 0 ]
