#!/bin/sh
# batch_test.sh PYTHON BATCH PROGRAMS: one table, wherever and however often it is made; a net that is not verified gives none; bad input.
python=$1
batch=$2
programs=$3
. "$(dirname "$0")/scratch.sh"
run() { "$python" "$batch" --programs "$programs" "$@" >output 2>messages; }
# bad TEXT ARGUMENTS...: one line on standard error, which starts with the name and has the text.
bad() {
  text=$1
  shift
  run "$@" && complain "batch $* succeeds"
  tail -n 1 messages | grep -q "^\(experiments/batch\|batch\): .*$text" || complain "batch $*: expected '$text' in $(cat messages)"
  ! grep -q Traceback messages || complain "batch $*: $(cat messages)"
}

run --seeds 2-4 --genus 3 --epsilons 0.5,0.4 -o a || complain "one thread: $(cat messages)"
run --seeds 2-4 --genus 3 --epsilons 0.5,0.4 -o b --threads 2 || complain "two threads: $(cat messages)"
[ "$(grep -c '^genus-3-0[234],0.[54],.*,VERIFIED,3,' a/batches/batch/2-4.csv)" = 6 ] || complain "$(cat a/batches/batch/2-4.csv)"
cmp a/batches/batch/2-4.csv b/batches/batch/2-4.csv || complain 'threads change the table'

# Other epsilons, and all is made again; records cut short, and one is.
run --seeds 2-4 --genus 3 --epsilons 0.5 -o b || complain "other epsilons: $(cat messages)"
grep -q '^batch: 3 surfaces, 0 finished before' output || complain "records of other epsilons are taken for these: $(cat output)"
[ "$(wc -l <b/batches/batch/2-4.csv)" = 4 ] || complain "other epsilons: $(cat b/batches/batch/2-4.csv)"
before=$(cat a/records/batch/genus-3-02.json)
head -c 600 a/records/batch/genus-3-03.json >shortened
cp shortened a/records/batch/genus-3-03.json
cp a/batches/batch/2-4.csv expected
run --seeds 2-4 --genus 3 --epsilons 0.5,0.4 -o a || complain "again: $(cat messages)"
grep -q '^batch: 3 surfaces, 2 finished before' output || complain "after an interruption: $(cat output)"
cmp a/batches/batch/2-4.csv expected || complain 'another table after an interruption'
[ "$before" = "$(cat a/records/batch/genus-3-02.json)" ] || complain 'a finished file was written again'

# instead NAME COMMANDS: programs where variant is these commands, before the real one.
instead() {
  mkdir "$1"
  ln -s "$programs/epsnet" "$1"
  printf '#!/bin/sh\n%s\nexec "%s/variant" "$@"\n' "$2" "$programs" >"$1/variant"
  chmod +x "$1/variant"
}
# A net that is not verified, and one that is said to be refuted.
instead refusing 'case "$*" in *octagon-001*) echo "variant: the net was not verified: delaunay: so" >&2; exit 1 ;; esac'
bad '1 of 2 surfaces failed, the first one octagon-001: variant: exit code 1: .*delaunay: so' --seeds 1-2 --epsilons 0.5 -o c --programs refusing
[ "$(ls c/records/batch)" = octagon-002.json ] || complain "of the other surface: $(ls c/records/batch)"
[ ! -e c/batches ] || complain 'a table of what is not verified'
instead refuted 'printf "epsilon,verdict\n0.5,REFUTED\n"; exit 0'
bad 'octagon-001: a net is missing or not verified' --seeds 1-2 --epsilons 0.5 -o d --programs refuted

bad 'invalid.*5-4' --seeds 5-4 --epsilons 0.5 -o c
bad 'invalid.*0-4' --seeds 0-4 --epsilons 0.5 -o c
bad 'invalid.*7' --seeds 7 --epsilons 0.5 -o c
bad 'variant: exit code 64.*positive' --seeds 1-1 --epsilons 0 -o c
bad 'no-programs/epsnet: No such file' --seeds 1-1 --epsilons 0.5 --programs no-programs -o c
touch file
bad 'file' --seeds 1-1 --epsilons 0.5 -o file

[ $failures = 0 ] && echo 'all passed'
[ $failures = 0 ]
