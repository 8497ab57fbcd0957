#!/usr/bin/env bash
# setup_test.sh SETUP: what .ci/setup asks for, where apt says what Debian 12 and Debian 13 say, to a user, to root, and before the first `apt-get update`.
set -u
setup=$1
failures=0
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
mkdir "$here/bin"

# fake NAME: standard input is what the command NAME does instead.
fake() {
  { echo '#!/bin/sh'; cat; } >"$here/bin/$1"
  chmod +x "$here/bin/$1"
}

# run UID ARB GROUP...: nothing is installed, and ARB says what the archive says of libflint-arb-dev: real, virtual or unknown.
run() {
  export FAKE_UID=$1 FAKE_ARB=$2 FAKE_LOG=$here/apt-get
  shift 2
  : >"$FAKE_LOG"
  PATH=$here/bin:$PATH "$setup" "$@" >"$here/output" 2>&1
  code=$?
  asked=$(cat "$here/output" "$FAKE_LOG")
}

# expect CODE: of the last run; expect_asked NAME, expect_not_asked NAME: whether it asked for the package.
complain() {
  echo "FAILED: $1: exit code $code, $asked"
  failures=$((failures + 1))
}
expect() { [ "$code" = "$1" ] || complain "exit code $1 expected"; }
expect_asked() { [[ " ${asked//$'\n'/ } " == *" $1 "* ]] || complain "$1 expected"; }
expect_not_asked() { [[ " ${asked//$'\n'/ } " != *" $1 "* ]] || complain "$1 not expected"; }

fake dpkg-query <<<'exit 1'
fake id <<<'echo "$FAKE_UID"'
fake sudo <<<'exit 1'
fake apt-get <<<'echo "$@" >>"$FAKE_LOG"'
fake apt-cache <<'END'
case $FAKE_ARB/$1/$2 in
  unknown/policy/*) exit 0 ;;
  unknown/*) exit 100 ;;
  virtual/policy/libflint-arb-dev) printf '%s:\n  Installed: (none)\n  Candidate: (none)\n  Version table:\n' "$2" ;;
  */policy/*) printf '%s:\n  Installed: (none)\n  Candidate: 2.9.0-5\n  Version table:\n     2.9.0-5 500\n' "$2" ;;
  virtual/show/libflint-arb-dev) exit 0 ;;
  */show/*) echo "Package: $2" ;;
esac
END

for user in 0 1000; do
  [ $user = 0 ] && code_expected=0 || code_expected=1
  run $user virtual build # FLINT 3 contains Arb.
  expect $code_expected
  expect_asked g++
  expect_asked libflint-dev
  expect_not_asked libflint-arb-dev
  run $user real build
  expect $code_expected
  expect_asked libflint-arb-dev
  expect_asked libflint-dev
  # The tests' libraries are a group of their own.
  expect_not_asked libgtest-dev
  expect_not_asked libgmock-dev
  expect_not_asked librapidcheck-dev
  run $user virtual test
  expect $code_expected
  expect_asked libgtest-dev
  expect_asked libgmock-dev
  expect_asked librapidcheck-dev
  expect_not_asked g++
done
run 1000 unknown build # Nothing is known of the archive: everything is named.
expect 1
expect_asked libflint-arb-dev
run 1000 real no-such-group
expect 64

[ $failures -eq 0 ] && echo "setup asks for what it should"
