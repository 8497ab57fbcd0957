#!/bin/sh
# hostile_test.sh CERTIFY CERTIFY-EXACT EPSNET DATA PYTHON: both checkers give their verdicts on files below 1 MB that demand
# much time or memory (hostile_files.py), within the work that docs/format.md allows and within 1 GB.
certify=$1
exact=$2
epsnet=$3
data=$4
python=$5
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
  case $last in
    MALFORMED*) ;;  # No work is counted.
    *) [ "${work:-99999999999}" -le 23000000000 ] || fail "$kind $*: $work units of work" ;;
  esac
  # The second checker does not count work, so its processor time is limited to minutes.
  second=$(ulimit -v 1000000 && ulimit -t 300 && "$exact" "$folder/$kind.json")
  code=$?
  [ "$code" -le 3 ] || fail "$kind: certify-exact ends with $code"
  case ${last%%:*},${second%%:*} in
    UNDECIDED,* | *,UNDECIDED | VERIFIED,VERIFIED | REFUTED,REFUTED | MALFORMED,MALFORMED) ;;
    *) fail "$kind: certify-exact says '$second'" ;;
  esac
  rm -f "$folder/$kind.json"
}

expect chart-of-50000-digits-and-collinear-vertices 'REFUTED: orientation'
expect chart-of-200000-digits VERIFIED
expect charts-of-their-own-for-all-vertices VERIFIED
expect circumradii-all-epsilon-in-a-chart-of-many-digits UNDECIDED
expect label-that-cancels VERIFIED
expect label-random 'REFUTED: gluing'
expect tile-of-random-long-coordinates 'REFUTED: surface'
expect field-of-large-products ''
expect field-of-larger-products ''
expect field-of-large-coefficients ''
expect field-of-nearly-equal-roots ''
expect field-of-many-factors VERIFIED
expect epsilon-of-900000-digits VERIFIED
expect collar-core-that-cancels VERIFIED
expect collar-core-that-cancels-in-450000-letters VERIFIED
expect collar-in-a-tile-of-long-coordinates 'REFUTED: collars'
expect geodesics-300-of-250-letters ''
expect spectrum-up-to-9999-digits UNDECIDED
expect eigenvalues-of-many-counts VERIFIED
expect eigenvalues-of-many-counts-by-vertices VERIFIED
expect eigenvalues-of-many-intervals 'REFUTED: enclosures'
expect eigenvalues-of-a-matrix-that-an-order-fills UNDECIDED
expect eigenvalues-of-a-matrix-in-the-order-of-its-sides ''
expect sections-of-a-matrix-in-the-order-of-its-sides ''
expect sections-with-phases-of-huge-denominators MALFORMED
expect sections-along-long-words 'REFUTED: enclosures'
expect eigenvalues-of-many-functions 'REFUTED: enclosures'
expect eigenvalues-of-a-thousand-functions-of-order-1 ''
expect eigenvalues-of-many-rows-of-functions UNDECIDED
expect isometries-of-many-rows VERIFIED
expect isometries-of-long-words UNDECIDED
expect isometries-of-long-paths UNDECIDED
expect isometries-of-many-geodesics UNDECIDED
expect isometries-of-powers UNDECIDED
expect comparison-of-long-words UNDECIDED
expect comparison-of-long-paths UNDECIDED
expect comparison-by-a-far-lift VERIFIED
expect comparison-of-many-geodesics UNDECIDED
expect curves-of-long-words UNDECIDED
expect curves-of-many-letters UNDECIDED
expect curves-of-large-powers UNDECIDED
expect curves-that-cancel-to-nothing 'REFUTED: lengths'
expect curves-around-a-vertex 'REFUTED: lengths'
expect curves-many 'REFUTED: intersections'
expect curves-of-genus-80 UNDECIDED
expect curves-of-many-sets VERIFIED
expect pants-of-a-random-path 'REFUTED: pants'
expect pants-of-a-path-that-cancels UNDECIDED
expect pants-of-a-path-that-cancels-to-nothing UNDECIDED
expect pants-around-a-cuff UNDECIDED
expect pants-around-a-cuff-of-1e-12 UNDECIDED
expect pants-many 'REFUTED: pants'
expect pants-of-genus-100 UNDECIDED
expect pants-of-an-exact-length-of-400000-digits 'REFUTED: lengths'
expect pants-in-a-tile-of-long-coordinates 'REFUTED: surface'
expect pants-nested-deeply MALFORMED
expect distance-of-many-paths ''
expect bound-of-many-triangulations ''
expect bound-of-many-cells ''
expect bound-of-many-splits ''
expect bound-of-a-domain-of-many-sides 'UNDECIDED: isometries'
expect bound-of-a-domain-along-a-long-path 'UNDECIDED: isometries'
expect bound-of-far-elements 'REFUTED: cells'
expect thick-thin-without-its-shortest-geodesic ''
expect thick-thin-of-long-words VERIFIED
expect thick-thin-of-a-long-conjugate ''
expect spectrum-at-a-vertex-of-many-edges VERIFIED
expect thick-thin-of-powers VERIFIED
expect empty-arrays-many MALFORMED
expect members-many MALFORMED
expect isometries-of-one-cycle-of-corners 'REFUTED: surface'
expect spectrum-up-to-a-number-of-many-digits 'REFUTED: distinct'
expect spectrum-of-a-geodesic-around-a-short-core 'REFUTED: complete'
expect bound-of-cells-nested-deeply 'REFUTED: cells'
expect tile-of-two-long-corners 'REFUTED: surface'
expect distance-to-a-point-of-many-digits 'REFUTED: equal'

echo "$runs runs, $failures failures"
[ "$failures" = 0 ]
