#!/bin/sh
# eigenvalues_test.sh PYTHON EIGENVALUES PROGRAMS: the tables of a few surfaces; what is finished is kept; what is not proved; bad input.
python=$1
script=$2
programs=$3
. "$(dirname "$0")/scratch.sh"
# make PROGRAMS DIR ARGUMENTS...
make() {
  from=$1
  to=$2
  shift 2
  "$python" "$script" --quick --programs "$from" -o "$to" "$@" >output 2>messages
}
# instead NAME COMMANDS: a directory NAME whose epsnet runs these commands before the real one, with the same arguments.
instead() {
  mkdir "$1"
  printf '#!/bin/sh\n%s\nexec "%s/epsnet" "$@"\n' "$2" "$programs" >"$1/epsnet"
  chmod +x "$1/epsnet"
}

make "$programs" out || complain "exit code $?: $(cat messages)"
for table in statistics octagons pinched covers named gaps; do [ -s out/$table.md ] || complain "no table $table"; done
# The ends are those that epsnet prints, rounded outward.
"$programs/epsnet" surface octagon --seed 2 -o s.json && "$programs/epsnet" eigenvalues s.json --count 1 --digits 2 --json >facts.json
grep -q '"first":1,"count":1,"in":\[2.[0-9]*,2.[0-9]*\]' facts.json || complain "octagon 2: $(cat facts.json)"
grep -q '^| 2 | \[2.[0-9]*, 2.[0-9]*\] | 1.7090 | 2.5102 |' out/octagons.md || complain "octagons: $(cat out/octagons.md)"
grep -q '^| 2 | λ_1 in \[0.4' out/pinched.md || complain "pinched: $(cat out/pinched.md)"
grep -q '^| 2 | 1 | 3 | λ_1 in \[0.9[0-9]*, 0.9[0-9]*\] | 0 |$' out/covers.md || complain "covers: $(cat out/covers.md)"
grep -q '^| Bolza | λ_1 to λ_3 in \[3.[78][0-9]*, 3.[89][0-9]*\] | [45].[0-9]* | 0 |$' out/named.md || complain "named: $(cat out/named.md)"
# λ_1 of covers of genus 10: the median is 0.240.
grep -q '^| 9 | 10 | 3 | 0.1[0-9]* | 0.2[0-9]* | 0.3[0-9]* | 1 | 2 |$' out/gaps.md || complain "gaps: $(cat out/gaps.md)"
[ "$(grep -c '^9,[123],10,0\.[0-9]*,0\.[0-9]*,[01]$' out/gaps.csv)" = 3 ] || complain "gaps: $(cat out/gaps.csv)"
if "$python" -c 'import matplotlib' 2>/dev/null; then [ -s out/gaps.svg ] || complain 'no picture gaps'; fi

# Once more: nothing is computed again.
instead idle 'case "$1" in eigenvalues | systole | diameter) echo "epsnet: computed again" >&2; exit 70 ;; esac'
cp out/pinched.md expected
make idle out || complain "again: exit code $?: $(cat messages)"
cmp -s expected out/pinched.md || complain 'the table differs when made again'

# What is not proved is said; what fails otherwise ends the run.
instead unproved 'case "$1" in eigenvalues) echo "epsnet: not certified" >&2; exit 1 ;; esac'
make unproved none --only octagons --only pinched || complain "not proved: exit code $?: $(cat messages)"
grep -q '^| 2 | not proved | 1.7090 |' none/octagons.md || complain "not proved: $(cat none/octagons.md)"
grep -q '^| 1 | not proved |' none/pinched.md || complain "not proved: $(cat none/pinched.md)"
# bad TEXT PROGRAMS ARGUMENTS...: one line on standard error that has the text.
bad() {
  text=$1
  from=$2
  shift 2
  make "$from" bad "$@" && complain "$text: it succeeds"
  [ "$(wc -l <messages)" = 1 ] && grep -q "^experiments/eigenvalues: .*$text" messages || complain "expected '$text' in $(cat messages)"
}
instead faulty 'case "$1" in eigenvalues) echo "epsnet: internal fault" >&2; exit 70 ;; esac'
bad 'eigenvalues: exit code 70: epsnet: internal fault' faulty --only pinched
instead wrong 'case "$1" in eigenvalues) echo "{\"verdict\":\"not certified\"}"; exit 0 ;; esac'
bad 'expected VERIFIED' wrong --only pinched
bad 'no-programs/epsnet: No such file' no-programs --only pinched
bad 'full run' "$programs" --docs

[ $failures = 0 ] && echo 'all passed'
[ $failures = 0 ]
