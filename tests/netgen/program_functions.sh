# Functions for tests that drive the programs $epsnet and $certify, with files of $data, in a directory of their own. A job that succeeds has exit
# code 0; one that fails has the exit code expected, one line on standard error that starts with "epsnet: ", and leaves no file, not even a temporary one.
failures=0
runs=0
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 1
mkdir out
messages=$here/messages

complain() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# good ARGUMENTS...: the program succeeds, without a word on standard error.
good() {
  runs=$((runs + 1))
  "$epsnet" "$@" >output 2>"$messages"
  code=$?
  [ $code = 0 ] || complain "epsnet $*: exit code $code: $(cat "$messages")"
  [ ! -s "$messages" ] || complain "epsnet $*: standard error says $(cat "$messages")"
}

# bad CODE TEXT ARGUMENTS...: it fails with this exit code and one line with this text (grep), and leaves nothing in out/.
bad() {
  expected=$1
  text=$2
  shift 2
  runs=$((runs + 1))
  (
    # No run may need much memory: what a file claims is not what is there.
    [ -n "$no_memory_limit" ] || ulimit -v 4000000
    exec "$epsnet" "$@" >output 2>"$messages"
  )
  code=$?
  [ $code = "$expected" ] || complain "epsnet $*: exit code $code, expected $expected: $(cat "$messages")"
  [ "$(wc -l <"$messages")" = 1 ] || complain "epsnet $*: not one line on standard error: $(cat "$messages")"
  grep -q '^epsnet: ' "$messages" || complain "epsnet $*: the message does not start with 'epsnet: ': $(cat "$messages")"
  grep -q -e "$text" "$messages" || complain "epsnet $*: expected '$text' in $(cat "$messages")"
  [ -z "$(ls -A out)" ] || {
    complain "epsnet $*: leaves $(ls -A out)"
    rm -rf out
    mkdir out
  }
}

# says TEXT: the last run said this text (grep), on whatever stream.
says() { grep -q -e "$1" output "$messages" || complain "expected '$1' in $(cat output "$messages")"; }

verified() {
  runs=$((runs + 1))
  last=$("$certify" "$1" | tail -n 1)
  [ "$last" = VERIFIED ] || complain "certify $1: $last"
}

# claims_nothing FILE: certify says so.
claims_nothing() {
  runs=$((runs + 1))
  last=$("$certify" "$1" | tail -n 1)
  case $last in "NO CLAIM: "*) ;; *) complain "certify $1: $last" ;; esac
}

same() { cmp -s "$1" "$2" || complain "$1 and $2 differ"; }

# Address sanitizer needs terabytes of address space.
no_memory_limit=
if (ulimit -v 4000000 && "$epsnet" --help) >/dev/null 2>&1; then :; else no_memory_limit=yes; fi

