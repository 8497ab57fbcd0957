#!/bin/sh
# viewer_test.sh EPSNET CHROMIUM SCRIPTS DATA: pages of `epsnet view` in a browser without a window, with the scripts of the folder SCRIPTS in them:
# viewer_test.js uses the page, viewer_layout_test.js looks at it on screens of several sizes.
epsnet=$1
chromium=$2
scripts=$3
data=$4
failures=0
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 1
export HOME="$here"

# verdict NAME FILE: the page's own verdict on itself, once it is loaded.
verdict() {
  timeout 600 "$chromium" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir="$here/profile" --window-size=1200,850 \
    --allow-file-access-from-files --dump-dom "file://$here/$2" >dom 2>/dev/null
  if grep -q 'viewer-test: passed' dom; then
    echo "passed: $1"
  else
    echo "FAILED: $1: $(grep -o 'viewer-test: [^<]*' dom || echo 'the page does not answer')"
    failures=$((failures + 1))
  fi
}

# page NAME NET [OPTIONS]: the page of a net, clicked and dragged.
page() {
  name=$1
  net=$2
  shift 2
  "$epsnet" view "$net" -o page.html --title "$name" "$@" >report || { echo "FAILED: epsnet view $net"; failures=$((failures + 1)); return; }
  { cat page.html; echo '<script>'; cat "$scripts/viewer_test.js"; echo '</script>'; } >test.html
  verdict "$name" test.html
}

# layout: the last page, on a phone upright and lying, on a desk.
layout() {
  { cat page.html; echo '<script>'; cat "$scripts/viewer_layout_test.js"; echo '</script>'; } >framed.html
  {
    for size in '390px; height: 844px' '320px; height: 568px' '844px; height: 390px' '1280px; height: 800px' '1920px; height: 1080px'; do
      echo "<iframe src=\"framed.html\" style=\"border: 0; width: $size\"></iframe>"
    done
    cat <<'END'
<script>
addEventListener('load', () => {
  const answers = [...document.querySelectorAll('iframe')].map(frame => frame.contentDocument.body.dataset.failures);
  const failures = answers.map(answer => answer === undefined ? 'a frame without an answer' : answer).filter(answer => answer !== '');
  document.body.textContent = 'viewer-' + 'test: ' + (failures.length === 0 ? 'passed' : failures.join('; ').slice(0, 2000));
});
</script>
END
  } >frames.html
  verdict "layout of $name" frames.html
}

"$epsnet" surface octagon --seed 123 -o s.json
"$epsnet" net s.json --epsilon 0.25 -o net.json >report
"$epsnet" spectrum s.json --up-to 3 -o spectrum.json >report
page octagon net.json --geodesics spectrum.json
layout
page 'one vertex' "$data/certify/verified/octagon-1-vertex.json"
page 'regular, centre' "$data/certify/verified/regular-3-centre.json"
"$epsnet" surface fenchel-nielsen --genus 3 --lengths 3e-2,1,2,1e-1,1,2 --twists 0.2 -o thin.json --pants-graph chain
"$epsnet" net thin.json --epsilon 0.5 -o thin-net.json >report
page 'thin collars' thin-net.json
"$epsnet" surface fenchel-nielsen --pants-graph "0-0 0-1 1-1" --lengths 1.3,0.1,2 --seed 1 -o collar.json
"$epsnet" net collar.json --epsilon 0.2 --pseudo -o pseudo.json >report
"$epsnet" thick-thin collar.json -o curves.json >report
page 'pseudo net' pseudo.json --geodesics curves.json
layout
# A net that is wrong says so, and is shown.
"$epsnet" view "$data/certify/refuted/covering-epsilon-too-small.json" -o refuted.html >report
grep -q '"verdict": "REFUTED"' refuted.html || { echo 'FAILED: a refuted net'; failures=$((failures + 1)); }
[ $failures = 0 ]
