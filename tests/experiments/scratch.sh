# Sourced by the tests of this folder: goes to a folder that is removed at the end, and counts what is wrong.
failures=0
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 1

complain() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}
