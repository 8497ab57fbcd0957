#!/bin/sh
# batch_test.sh PYTHON BATCH PROGRAMS: both ways of proving give the same table; a net that is not verified gives none; bad input.
python=$1
batch=$2
programs=$3
. "$(dirname "$0")/scratch.sh"
# run ARGUMENTS...: nothing is left where temporary files are.
mkdir tmp
run() {
  TMPDIR=$here/tmp "$python" "$batch" --programs "$programs" "$@" >output 2>messages
  code=$?
  [ -z "$(ls -A tmp)" ] || complain "batch $*: left: $(ls tmp)"
  return $code
}
# bad TEXT ARGUMENTS...: one line on standard error, which starts with the name and has the text.
bad() {
  text=$1
  shift
  run "$@" && complain "batch $* succeeds"
  tail -n 1 messages | grep -q "^\(experiments/batch\|batch\): .*$text" || complain "batch $*: expected '$text' in $(cat messages)"
  ! grep -q Traceback messages || complain "batch $*: $(cat messages)"
}

run --seeds 2-4 --genus 3 --epsilons 0.5,0.4 -o a || complain "certify: $(cat messages)"
run --seeds 2-4 --genus 3 --epsilons 0.5,0.4 -o b --check sweep --threads 2 || complain "sweep: $(cat messages)"
head -n 1 a/batches/batch/2-4.csv | grep -q '^# epsnet .*, table 1, genus 3, seeds 2-4, insertion cavity, .*, epsilon 0.5 0.4$' ||
  complain "$(head -n 1 a/batches/batch/2-4.csv)"
[ "$(grep -c '^genus-3-0[234],0.[54],.*,VERIFIED,3,' a/batches/batch/2-4.csv)" = 6 ] || complain "$(cat a/batches/batch/2-4.csv)"
cmp a/batches/batch/2-4.csv b/batches/batch/2-4.csv || complain 'the two ways differ'

# Other epsilons, and all is made again; records cut short, and one is.
run --seeds 2-4 --genus 3 --epsilons 0.5 -o b || complain "other epsilons: $(cat messages)"
grep -q '# complete: 3 records' b/batches/batch/2-4.csv || complain 'records of other epsilons are taken for these'
before=$(cat a/records/batch/genus-3-02.csv)
head -c 600 a/records/batch/genus-3-03.csv >shortened
cp shortened a/records/batch/genus-3-03.csv
cp a/batches/batch/2-4.csv expected
run --seeds 2-4 --genus 3 --epsilons 0.5,0.4 -o a || complain "again: $(cat messages)"
cmp a/batches/batch/2-4.csv expected || complain 'another table after an interruption'
[ "$before" = "$(cat a/records/batch/genus-3-02.csv)" ] || complain 'a finished file was written again'

# A net that certify does not verify.
mkdir refusing
ln -s "$programs/epsnet" "$programs/sweep" refusing
printf '#!/bin/sh\ncase "$*" in *octagon-001*) echo "UNDECIDED: delaunay: so"; exit 2 ;; esac\nexec "%s/certify" "$@"\n' "$programs" >refusing/certify
chmod +x refusing/certify
bad '1 of 2 surfaces failed, the first one octagon-001: certify: exit code 2: UNDECIDED: delaunay: so' --seeds 1-2 --epsilons 0.5 -o c --programs refusing
[ "$(ls c/records/batch)" = octagon-002.csv ] || complain "of the other surface: $(ls c/records/batch)"
[ ! -e c/batches ] || complain 'a table of what is not verified'

bad 'invalid.*5-4' --seeds 5-4 --epsilons 0.5 -o c
bad 'invalid.*0-4' --seeds 0-4 --epsilons 0.5 -o c
bad 'invalid.*7' --seeds 7 --epsilons 0.5 -o c
bad 'epsnet: exit code 64.*positive' --seeds 1-1 --epsilons 0 -o c
bad 'sweep: exit code 64.*positive' --seeds 1-1 --epsilons 0 -o c --check sweep
bad 'no-programs/epsnet: No such file' --seeds 1-1 --epsilons 0.5 --programs no-programs -o c
touch file
bad 'file' --seeds 1-1 --epsilons 0.5 -o file

[ $failures = 0 ] && echo 'all passed'
[ $failures = 0 ]
