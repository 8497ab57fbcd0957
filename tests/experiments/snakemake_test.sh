#!/bin/sh
# snakemake_test.sh SNAKEMAKE SNAKEFILE PROGRAMS: a small sweep by the workflow gives the files of the program sweep.
snakemake=$1
snakefile=$2
programs=$3
here=$(mktemp -d) || exit 1
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 1

workflow() {
  XDG_CACHE_HOME=$here/cache "$snakemake" -s "$snakefile" -d out --cores 2 --config programs="$programs" seeds=1-2 epsilons=0.50,0.30 >log 2>&1
}
workflow || {
  cat log
  exit 1
}
[ "$(ls -A out/records/main)" = 'octagon-001.csv
octagon-002.csv' ] || {
  echo "FAILED: $(ls -A out/records/main)"
  exit 1
}
# Finished, as the program sees it; and line by line the same but for the seconds.
mkdir again
"$programs/sweep" out/surfaces/*.json --epsilons 0.50,0.30 --insert flips --list A -o out/records/main | grep '^sweep: 2 surfaces, 2 finished before' || exit 1
"$programs/sweep" out/surfaces/*.json --epsilons 0.50,0.30 --insert flips --list A -o again >/dev/null || exit 1
for file in octagon-001.csv octagon-002.csv; do
  grep -v '^# complete' again/$file | cut -d , -f 1-22 >expected
  grep -v '^# complete' out/records/main/$file | cut -d , -f 1-22 | cmp - expected || exit 1
done
echo 'all passed'
