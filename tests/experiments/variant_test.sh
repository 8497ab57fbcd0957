#!/bin/sh
# variant_test.sh EPSNET VARIANT: nets in the ways of the thesis are verified, and what is measured of them is right; bad input.
epsnet=$1
variant=$2
. "$(dirname "$0")/scratch.sh"

# bad CODE TEXT ARGUMENTS...: it fails with this exit code and one line, which starts with "variant: " and has the text.
bad() {
  expected=$1
  text=$2
  shift 2
  "$variant" "$@" >output 2>messages
  code=$?
  [ $code = "$expected" ] || complain "variant $*: exit code $code, expected $expected: $(cat messages)"
  grep -q -e "^variant: .*$text" messages || complain "variant $*: expected '$text' in $(cat messages)"
}
# field NAME LINE: a column of a line of out.csv, where line 1 is the first net.
field() {
  column=$(head -n 1 out.csv | tr , '\n' | grep -n -x "$1" | cut -d : -f 1)
  sed -n "$(($2 + 1))p" out.csv | cut -d , -f "$column"
}
# is TEST...: a test of `[` about out.csv.
is() { [ "$@" ] || complain "not $*: $(cat out.csv)"; }

"$epsnet" surface octagon --seed 9 -o s.json || complain 'octagon'
"$variant" s.json --epsilons 1/5,20 --insert flips --locate straight --list B >out.csv || complain "flips: exit code $?"
is "$(wc -l <out.csv)" = 3
is "$(cut -d , -f 1-6 out.csv | tail -n 2)" = '1/5,flips,straight,B,VERIFIED,2
20,flips,straight,B,VERIFIED,2'
is "$(field vertices 1)" = $(($(field insertions 1) + 1))
is "$(field located 1)" = "$(field insertions 1)"
is "$(field located_at_start 1)" -le "$(field located 1)"
is "$(field vertices 2)" = 1
is -z "$(field shortest_edge_lower 2)"
is -n "$(field shortest_loop_upper 2)"
# The net and its enclosures are those of epsnet and certify, whatever the way.
"$variant" s.json --epsilons 0.2 >out.csv || complain "cavity: exit code $?"
is "$(cut -d , -f 1-6 out.csv | tail -n 1)" = '0.2,cavity,,C,VERIFIED,2'
is "$(field located 1)" = 0
"$epsnet" net s.json --epsilon 0.2 -o net.json --json >net.txt || complain 'epsnet net'
grep -q "\"vertices\":$(field vertices 1)," net.txt || complain "another number of vertices: $(cat net.txt)"
grep -q "\"largest_circumradius\":\[[0-9.]*,$(field largest_circumradius_upper 1)\]" net.txt || complain "another circumradius: $(cat net.txt)"
grep -q "\"shortest_edge\":\[$(field shortest_edge_lower 1)," net.txt || complain "another shortest edge: $(cat net.txt)"

bad 64 'SURFACE' --epsilons 0.5
bad 64 'epsilons' s.json
bad 64 'positive number' s.json --epsilons 0.5,0
bad 64 'positive number' s.json --epsilons 0.5,nan
bad 64 'list' s.json --epsilons 0.5 --list E
bad 64 'insert' s.json --epsilons 0.5 --insert magic
bad 1 'nothing.json.*no such file' nothing.json --epsilons 0.5
bad 1 'net.txt' net.txt --epsilons 0.5
bad 1 '1e-9 needs more than' s.json --epsilons 1e-9

[ $failures = 0 ] && echo 'all passed'
[ $failures = 0 ]
