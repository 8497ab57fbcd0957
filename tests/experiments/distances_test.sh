#!/bin/sh
# distances_test.sh PYTHON RUN PROGRAMS: systoles, disks, radii and diameters of a few octagons; what is finished is kept; a row
# that fails stays, with its error; intervals that contradict each other end the run.
python=$1
run=$2
programs=$3
. "$(dirname "$0")/scratch.sh"
# measure PROGRAMS DIR
measure() { "$python" "$run" --quick --only distances --programs "$1" -o "$2" >output 2>messages; }
# instead NAME COMMANDS: a directory NAME whose epsnet runs these commands before the real one, with the same arguments.
instead() {
  mkdir "$1"
  printf '#!/bin/sh\n%s\nexec "%s/epsnet" "$@"\n' "$2" "$programs" >"$1/epsnet"
  chmod +x "$1/epsnet"
}
without_seconds() { cut -d , -f 1-14,19- "$1"; }
# without NAME N: a directory NAME where all is finished but octagon-00N.
without() {
  cp -r out "$1"
  rm "$1/records/distances/octagon-00$2.json"
}
csv=tables/distances.csv

measure "$programs" out || complain "exit code $?: $(cat messages)"
grep -q '^3 results, all VERIFIED' output || complain "the last line: $(tail -n 1 output)"
[ "$(wc -l <out/$csv)" = 4 ] || complain "the table: $(cat out/$csv)"
[ "$(grep -c '^octagon-00[123],VERIFIED,2,.*,$' out/$csv)" = 3 ] || complain "the rows: $(cat out/$csv)"
for table in distances correlations octagons; do [ -s out/tables/$table.md ] || complain "no table $table"; done
if "$python" -c 'import matplotlib' 2>/dev/null; then
  for plot in systole-diameter systole-disk diameter-radius distances; do
    grep -q '</svg>' out/plots/$plot.svg || complain "no plot $plot"
  done
fi
# The cells are the ends that epsnet prints.
"$programs/epsnet" diameter out/surfaces/octagon-002.json --json >diameter.json || complain 'epsnet diameter'
ends=$(sed 's/.*"diameter":\[\([^]]*\)\].*/\1/' diameter.json)
[ "$(sed -n 3p out/$csv | cut -d , -f 10,11)" = "$ends" ] || complain "octagon-002 has $ends, not $(sed -n 3p out/$csv)"

# Once more: only the file is made again that an interruption cut short.
without_seconds out/$csv >expected
head -c 300 out/records/distances/octagon-002.json >cut
cp cut out/records/distances/octagon-002.json
measure "$programs" out || complain "again: exit code $?: $(cat messages)"
grep -q '^distances: 3 surfaces, 2 finished before' output || complain "after an interruption: $(cat output)"
without_seconds out/$csv | cmp -s - expected || complain "the table differs after an interruption: $(cat out/$csv)"

# A limit is reached: the row is kept.
instead limited 'case "$1 $2" in radius*002*) echo "epsnet: not enclosed, with 5 cells" >&2; exit 1 ;; esac'
without kept 2
measure limited kept || complain "with a limit: exit code $?: $(cat messages)"
grep -q '^3 results, 1 of them incomplete' output || complain "with a limit: $(tail -n 1 output)"
grep -q '^octagon-002,incomplete,2,1.709[^,]*,1.709[^,]*,1.57[^,]*,1.57[^,]*,,,2.51.*,"radius: not enclosed, with 5 cells"$' kept/$csv ||
  complain "with a limit: $(cat kept/$csv)"
grep -q '^| radius | 2 |' kept/tables/distances.md || complain "with a limit: $(cat kept/tables/distances.md)"
grep -q '^| 2 | 1.709070 | 1.573843 | ? | 2.510253 |' kept/tables/octagons.md || complain "with a limit: $(cat kept/tables/octagons.md)"
measure limited kept || complain "with a limit, again: exit code $?: $(cat messages)"
grep -q '^distances: 3 surfaces, 3 finished before' output || complain "with a limit, again: $(cat output)"
# Nothing at all is enclosed: tables of nothing.
instead useless 'case "$1" in systole | embedded-disk | radius | diameter) echo "epsnet: no" >&2; exit 2 ;; esac'
measure useless nothing || complain "nothing enclosed: exit code $?: $(cat messages)"
grep -q '^3 results, 3 of them incomplete' output || complain "nothing enclosed: $(tail -n 1 output)"

# bad NAME COMMANDS TEXT: with these commands the run ends with one line that has the text, and leaves no record of octagon-003.
bad() {
  instead "$1" "$2"
  without "out-$1" 3
  measure "$1" "out-$1" && complain "$1: it succeeds"
  tail -n 1 messages | grep -q "^experiments/run: .*$3" || complain "$1: expected '$3' in $(cat messages)"
  ! grep -q Traceback messages || complain "$1: $(cat messages)"
  [ ! -e "out-$1/records/distances/octagon-003.json" ] || complain "$1: a record is left"
}
bad faulty 'case "$1 $2" in diameter*003*) echo "epsnet: internal fault" >&2; exit 70 ;; esac' 'diameter: exit code 70: internal fault'
bad killed 'case "$1 $2" in systole*003*) kill -9 $$ ;; esac' 'systole: exit code -9'
bad unproved 'case "$1 $2" in diameter*003*) echo "{\"verdict\":\"not certified\"}"; exit 0 ;; esac' 'expected VERIFIED'
bad wrong 'case "$1 $2" in diameter*003*) echo "{\"verdict\":\"VERIFIED\",\"diameter\":[2,2],\"cells\":1}"; exit 0 ;; esac' \
  'octagon-003: not radius <= diameter: \[2'

# The bounds are the radii of the disks in and around the regular (12g - 6)-gon, and the checks see a contradiction in each of them.
"$python" -c "
import math, sys
sys.path.insert(0, '$(dirname "$run")')
import distances, kept
for genus in range(2, 9):
    r, R = distances.disk_bound(genus), distances.radius_bound(genus)
    assert math.isclose(math.tanh(r), math.cos(math.pi / (12 * genus - 6)) * math.tanh(R)), genus
good = {'surface': 's', 'genus': 2, 'systole': 1.7, 'disk': 1.57, 'radius': 1.94, 'diameter': 2.5}
def check(**changes):
    values = {**good, **changes}
    row = {**values, **{f'{q}_{end}': values[q] for q in distances.QUANTITIES for end in ('lower', 'upper')}}
    distances.check_together(row)
check()
for changes in ({'systole': 3.2}, {'disk': 0.84}, {'disk': 1.72}, {'radius': 1.85}, {'diameter': 1.93}, {'diameter': 3.89}):
    try:
        check(**changes)
    except kept.Failure:
        continue
    sys.exit(f'{changes} passes')
" || complain 'bounds and checks'

[ $failures = 0 ] && echo 'all passed'
[ $failures = 0 ]
