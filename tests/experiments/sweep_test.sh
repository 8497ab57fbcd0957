#!/bin/sh
# sweep_test.sh EPSNET SWEEP: the records of a sweep are complete and certified; what is finished is kept, anything else is done again; bad input.
epsnet=$1
sweep=$2
. "$(dirname "$0")/scratch.sh"

# finds N: a sweep of the three surfaces finds N of them finished, and all are complete and certified afterwards.
finds() {
  "$sweep" s1.json s2.json s3.json --epsilons 0.5,0.3,1/5 -o out >output 2>messages || complain "exit code $?: $(cat messages)"
  grep -q "^sweep: 3 surfaces, $1 finished before" output || complain "expected $1 finished surfaces: $(cat output)"
  [ ! -s messages ] || complain "standard error: $(cat messages)"
  for i in 1 2 3; do
    [ "$(grep -c "^s$i,.*,VERIFIED,2," out/s$i.csv)" = 3 ] || complain "records of s$i: $(cat out/s$i.csv)"
    tail -n 1 out/s$i.csv | grep -q '^# complete: 3 records, CRC-32 [0-9a-f]\{8\}$' || complain "last line of s$i.csv"
  done
  [ "$(ls -A out)" = 's1.csv
s2.csv
s3.csv' ] || complain "in the directory: $(ls -A out)"
}

# bad CODE TEXT ARGUMENTS...: it fails with this exit code and one line, which starts with "sweep: " and has the text.
bad() {
  expected=$1
  text=$2
  shift 2
  "$sweep" "$@" >output 2>messages
  code=$?
  [ $code = "$expected" ] || complain "sweep $*: exit code $code, expected $expected: $(cat messages)"
  [ "$(grep -c '^sweep: ' messages)" -ge 1 ] && grep -q -e "$text" messages || complain "sweep $*: expected '$text' in $(cat messages)"
}

without_seconds() { grep -v '^# complete' "$1" | cut -d , -f 1-22; }

for i in 1 2 3; do "$epsnet" surface octagon --seed $i -o s$i.json || complain "octagon $i"; done
mkdir out
finds 0
without_seconds out/s2.csv >expected
before=$(cat out/*.csv)
finds 3
[ "$before" = "$(cat out/*.csv)" ] || complain 'finished files were written again'

# The same numbers come out of the program epsnet.
"$epsnet" net s2.json --epsilon 1/5 -o net.json --record record.csv >output || complain "epsnet net --record"
[ "$(tail -n 1 record.csv | cut -d , -f 1-22)" = "$(tail -n 1 expected)" ] || complain "epsnet net --record: $(cat record.csv)"

# Half a file, one without its last line, one with another digit, an empty one, one record twice.
for damage in 'head -c 700' 'head -c 500' 'head -n 5' 'sed s/VERIFIED,2/VERIFIED,3/' 'head -c 0' 'sed 3p'; do
  $damage out/s2.csv >damaged
  cp damaged out/s2.csv
  finds 2
  without_seconds out/s2.csv | cmp -s - expected || complain "after '$damage' the records differ"
done
# Other parameters, another surface.
"$sweep" s1.json --epsilons 0.5,0.3,0.2 -o out >output || complain 'other epsilons'
grep -q ' 0 finished before' output || complain 'records of other epsilons are taken for these'
finds 2
"$sweep" s1.json --epsilons 0.5,0.3,1/5 --insert flips --list D -o out >output || complain 'another way'
grep -q ' 0 finished before' output || complain 'records of another way are taken for these'
cp s1.json kept.json
cp s3.json s1.json
finds 2
cp kept.json s1.json
finds 2

# Systoles instead of nets.
rm out/*
for finished in 0 2; do
  "$sweep" s1.json s2.json --systoles -o out >output 2>messages || complain "systoles: exit code $?: $(cat messages)"
  grep -q "^sweep: 2 surfaces, $finished finished before" output || complain "systoles: $(cat output)"
done
[ "$(grep -c '^s1,VERIFIED,2,[0-9.]*,[0-9.]*,yes,' out/s1.csv)" = 1 ] || complain "the systole of s1: $(cat out/s1.csv)"

# Killed between two surfaces: what is there is complete.
rm out/*
"$sweep" s1.json s2.json s3.json --epsilons 0.5,0.3,1/5,0.02 -o out --threads 1 >output 2>messages &
process=$!
until [ -e out/s1.csv ]; do kill -0 $process 2>/dev/null || break; done
kill -9 $process 2>/dev/null
wait $process 2>/dev/null
for file in out/*.csv; do tail -n 1 "$file" | grep -q '^# complete: 4 records' || complain "$file is not complete"; done
"$sweep" s1.json s2.json s3.json --epsilons 0.5,0.3,1/5,0.02 -o out >output 2>messages || complain "exit code $?: $(cat messages)"
grep -q '^sweep: 3 surfaces, [123] finished before' output || complain "after an interruption: $(cat output)"
rm -rf out
mkdir out

bad 64 'SURFACE' --epsilons 0.5 -o out
bad 64 'either' s1.json -o out
bad 64 'either' s1.json --epsilons 0.5 --systoles -o out
bad 64 'positive number' s1.json --epsilons 0.5,0 -o out
bad 64 'positive number' s1.json --epsilons 0.5,nan -o out
bad 64 'list' s1.json --epsilons 0.5 --list E -o out
bad 64 'two surfaces are called s1' s1.json ./s1.json --epsilons 0.5 -o out
bad 1 'nowhere: no such directory' s1.json --epsilons 0.5 -o nowhere
bad 1 'nothing.json: cannot be read' nothing.json --epsilons 0.5 -o out
bad 1 'record.csv' record.csv --epsilons 0.5 -o out
bad 1 '1e-9 needs more than' s1.json --epsilons 0.5,1e-9 -o out
[ -z "$(ls -A out)" ] || complain "bad input leaves $(ls -A out)"
mkdir out/s1.csv
bad 1 's1.csv' s1.json --epsilons 0.5 -o out

[ $failures = 0 ] && echo 'all passed'
[ $failures = 0 ]
