#!/bin/sh
# viewer_test.sh EPSNET CHROMIUM SCRIPT DATA: pages of `epsnet view` in a browser without a window. SCRIPT is run in each of them (viewer_test.js).
epsnet=$1
chromium=$2
script=$3
data=$4
failures=0
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 1
export HOME="$here"

# page NAME NET: the page of a net, clicked and dragged.
page() {
  "$epsnet" view "$2" -o "$1.html" --title "$1" >report || { echo "FAILED: epsnet view $2"; failures=$((failures + 1)); return; }
  { cat "$1.html"; echo '<script>'; cat "$script"; echo '</script>'; } >test.html
  timeout 200 "$chromium" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir="$here/profile" --window-size=1200,850 --dump-dom \
    "file://$here/test.html" >dom 2>messages
  if grep -q 'viewer-test: passed' dom; then
    echo "passed: $1"
  else
    echo "FAILED: $1: $(grep -o 'viewer-test: [^<]*' dom || tail -n 5 messages)"
    failures=$((failures + 1))
  fi
}

"$epsnet" surface octagon --seed 123 -o s.json
"$epsnet" net s.json --epsilon 0.25 -o net.json >report
page octagon net.json
page 'one vertex' "$data/certify/verified/octagon-1-vertex.json"
page 'regular, centre' "$data/certify/verified/regular-3-centre.json"
"$epsnet" surface fenchel-nielsen --genus 3 --lengths 1e-3,1,2,1e-2,1,2 --twists 0.2 -o thin.json --pants-graph chain
"$epsnet" net thin.json --epsilon 0.3 -o thin-net.json >report
page 'thin collars' thin-net.json
# A net that is wrong says so, and is shown.
"$epsnet" view "$data/certify/refuted/covering-epsilon-too-small.json" -o refuted.html >report
grep -q '"verdict": "REFUTED"' refuted.html || { echo 'FAILED: a refuted net'; failures=$((failures + 1)); }
[ $failures = 0 ]
