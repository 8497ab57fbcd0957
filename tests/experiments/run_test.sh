#!/bin/sh
# run_test.sh PYTHON RUN PROGRAMS: all experiments, quickly; what is finished is kept; bad input.
python=$1
run=$2
programs=$3
. "$(dirname "$0")/scratch.sh"
quick() { "$python" "$run" --quick --programs "$programs" "$@" >output 2>messages; }
# bad TEXT ARGUMENTS...: one line on standard error at the end, which starts with the name and has the text.
bad() {
  text=$1
  shift
  quick "$@" && complain "experiments/run $* succeeds"
  tail -n 1 messages | grep -q -e "$text" || complain "experiments/run $*: expected '$text' in $(cat messages)"
  ! grep -q Traceback messages || complain "experiments/run $*: $(cat messages)"
}

quick -o out || complain "exit code $?: $(cat messages)"
grep -q '^138 results, all VERIFIED' output || complain "the last line: $(tail -n 1 output)"
for table in walks lists points ratios behaviour fits systoles distances correlations octagons thin genus-3 higher-genus; do
  [ -s out/tables/$table.md ] || complain "no table $table"
done
grep -q '^| 0.40 | 54 | 5[0-9]' out/tables/points.md || complain "Table IV.3: $(cat out/tables/points.md)"
if "$python" -c 'import matplotlib' 2>/dev/null; then
  for plot in points walks flips seconds lists thin genera systoles systole-diameter systole-disk diameter-radius distances; do
    grep -q '</svg>' out/plots/$plot.svg || complain "no plot $plot"
  done
fi
cp out/tables/points.md points.md

# Once more: nothing is computed but the file that an interruption cut short.
head -c 600 out/records/main/octagon-002.json >cut
cp cut out/records/main/octagon-002.json
quick -o out --only main || complain "again: exit code $?: $(cat messages)"
[ "$(grep 'finished before' output)" = 'main: 3 surfaces, 2 finished before
main-cavity: 3 surfaces, 3 finished before' ] || complain "after an interruption: $(cat output)"
cmp -s points.md out/tables/points.md || complain 'the table differs after an interruption'
[ "$(grep -c '^octagon-00[123],0.[345]0,flips,visibility,A,VERIFIED,2,' out/tables/main.csv)" = 9 ] || complain "main.csv: $(cat out/tables/main.csv)"

# Records of another version, of another surface, of another way are not those of these.
for change in 's/"version": "epsnet/"version": "older/' 's/"surface": "/"surface": " /' 's/"visibility", "--list"/"straight", "--list"/'; do
  sed "$change" out/records/main/octagon-002.json >changed
  cmp -s changed out/records/main/octagon-002.json && complain "nothing to change by $change"
  cp changed out/records/main/octagon-002.json
  quick -o out --only main || complain "$change: exit code $?: $(cat messages)"
  grep -q '^main: 3 surfaces, 2 finished before' output || complain "$change: $(cat output)"
done

bad 'invalid choice' --only nonsense -o out
bad 'invalid.*-1' --threads -1 -o out
bad 'full run' --docs -o out
full() { "$python" "$run" --programs "$programs" "$@" >output 2>messages; }
full --docs --only genus-3 -o out && complain 'half a plot goes into the document'
grep -q 'share a plot' messages || complain "half a plot: $(cat messages)"
bad 'no-programs/epsnet: No such file' --programs no-programs -o out
touch file
bad 'file/' -o file/below
bad 'file' -o file

[ $failures = 0 ] && echo 'all passed'
[ $failures = 0 ]
