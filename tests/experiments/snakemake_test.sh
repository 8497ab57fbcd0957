#!/bin/sh
# snakemake_test.sh SNAKEMAKE SNAKEFILE PROGRAMS: a small sweep by the workflow gives the records of the program variant; one whose jobs were
# cut short goes on, and ends with the same table.
snakemake=$1
snakefile=$2
programs=$3
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 1

fail() {
  echo "FAILED: $*"
  cat log
  exit 1
}
# workflow DIR PROGRAMS: batches of two surfaces, and a last one of one.
workflow() {
  XDG_CACHE_HOME=$here/cache "$snakemake" -s "$snakefile" -d "$1" --cores 2 --keep-going --rerun-incomplete \
    --config programs="$2" seeds=1-5 batch=2 epsilons=0.50,0.30 >log 2>&1
}
workflow out "$programs" || fail 'the workflow'
[ "$(cd out && find batches records tables -type f | sort)" = 'batches/main/1-2.csv
batches/main/3-4.csv
batches/main/5-5.csv
records/main/octagon-001.json
records/main/octagon-002.json
records/main/octagon-003.json
records/main/octagon-004.json
records/main/octagon-005.json
tables/main.csv' ] || fail "$(find out)"
# The table has all of the records but their seconds, in the order of the seeds.
[ "$(grep -c '^octagon-00[1-5],0.[35]0,flips,visibility,A,VERIFIED,2,' out/tables/main.csv)" = 10 ] || fail "$(cat out/tables/main.csv)"
for i in 1 2 3 4 5; do
  "$programs/variant" "out/surfaces/octagon-00$i.json" --epsilons 0.50,0.30 --insert flips --list A | tail -n 2 | sed "s/^/octagon-00$i,/" | cut -d , -f 1-22
done >expected
tail -n +2 out/tables/main.csv | cmp - expected || fail 'the table has other records'

# The fourth surface ends its job.
mkdir cut
ln -s "$programs/epsnet" cut
printf '#!/bin/sh\ncase "$*" in *octagon-004*) kill -TERM $PPID; sleep 1 ;; esac\nexec "%s/variant" "$@"\n' "$programs" >cut/variant
chmod +x cut/variant
workflow resumed "$here/cut" && fail 'the end of a job goes unnoticed'
grep -q 'terminated; the same command continues' log || fail 'no word of the end'
[ -e resumed/records/main/octagon-003.json ] && [ ! -e resumed/batches/main/3-4.csv ] && [ ! -e resumed/tables/main.csv ] || fail "$(find resumed)"
cp resumed/records/main/octagon-003.json kept
workflow resumed "$programs" || fail 'it does not go on'
grep -q '3 of 3 steps' log || fail 'more is done again than the batch, the table and the end'
cmp kept resumed/records/main/octagon-003.json || fail 'a finished surface is made again'
cmp out/tables/main.csv resumed/tables/main.csv || fail 'the table is another one after an interruption'
echo 'all passed'
