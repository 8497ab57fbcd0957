#!/bin/sh
# pictures.sh EPSNET SOURCES: makes all pictures of docs/images that epsnet draws again, by the commands of docs/gallery.md.
# pictures.sh --check EPSNET SOURCES: makes them elsewhere, and fails if they differ from those of docs/images.
# SVG pictures are compared; of PNG pictures only that they are made, as renderers differ in pixels.
set -eu
check=false
if [ "$1" = --check ]; then
  check=true
  shift
fi
programs=$(dirname "$(realpath "$1")")
images=$2/docs/images
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/made"

# All blocks of commands of the document, in order.
awk '/^```sh$/ { on = 1; next } /^```$/ { on = 0 } on' "$2/docs/gallery.md" >"$work/commands"
[ -s "$work/commands" ] || { echo "docs/gallery.md has no block of commands" >&2; exit 1; }
cd "$work/made"
PATH=$programs:$PATH sh -eu "$work/commands" >"$work/report" 2>&1 || { tail -n 5 "$work/report" >&2; exit 1; }
rm -f -- *.json

if ! $check; then
  cp -- * "$images"
  exit 0
fi

failures=0
complain() {
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}
for picture in *; do
  if [ ! -f "$images/$picture" ]; then
    complain "docs/images/$picture is missing: build the target 'pictures'"
  else
    case $picture in
      *.png) ;;
      *) cmp -s "$picture" "$images/$picture" || complain "docs/images/$picture is not what docs/gallery.md makes: build the target 'pictures'" ;;
    esac
  fi
done
cd "$images"
for picture in *.*; do
  [ -f "$work/made/$picture" ] || complain "no command of docs/gallery.md makes docs/images/$picture"
  grep -q "images/$picture)" ../gallery.md ../../README.md || complain "no document shows docs/images/$picture"
done
for shown in $(grep -Eho "images/[A-Za-z0-9./-]*[.](svg|png)" ../gallery.md ../../README.md | sort -u); do
  [ -f "../$shown" ] || complain "docs/$shown is shown and does not exist"
done
[ $failures = 0 ]
