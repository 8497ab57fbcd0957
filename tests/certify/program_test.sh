#!/bin/sh
# program_test.sh CERTIFY CERTIFY-EXACT DATA: every file of DATA/VERDICT/ gives that verdict's exit code and last line; so do several
# files, usage errors and a full disk. Exit code 0 exactly if the last line is VERIFIED.
certify=$1
certify_exact=$2
data=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
runs=0

# expect CODE LAST-LINE-PREFIX ARGUMENTS...
expect() {
  code=$1
  prefix=$2
  shift 2
  output=$("$certify" "$@" 2>/dev/null)
  found=$?
  last=$(printf '%s\n' "$output" | tail -n 1)
  runs=$((runs + 1))
  case $last in
    "$prefix"*) ;;
    *) found="$found with '$last'" ;;
  esac
  if [ "$found" != "$code" ]; then
    echo "certify $*: exit code $found, expected $code with '$prefix'"
    failures=$((failures + 1))
  fi
}

for file in "$data"/verified/*; do
  expect 0 VERIFIED "$file"
  expect 0 '{"verdict": "VERIFIED"' --json "$file"
done
for file in "$data"/../geodesics/*; do
  expect 0 VERIFIED "$file"
  expect 0 '{"verdict": "VERIFIED"' --json "$file"
  expect 2 'UNDECIDED: complete: ' --max-visits 10 "$file"
done
for file in "$data"/refuted/*; do expect 1 'REFUTED: ' "$file"; done
for file in "$data"/undecided/*; do expect 2 'UNDECIDED: ' "$file"; done
for file in "$data"/malformed/*; do expect 3 'MALFORMED: ' "$file"; done
expect 64 ''
expect 64 '' --no-such-option
expect 64 '' --json --print-parsed "$data"/verified/octagon-1-vertex.json
expect 64 '' "$data"/no-such-file.json
expect 64 '' "$data"
expect 64 '' /dev/zero
expect 0 'please report it' --help
expect 0 'certify ' --version
"$certify" --help | awk 'length($0) > 80' | grep . && {
  echo "certify --help has lines of more than 80 columns"
  failures=$((failures + 1))
}

good=$data/verified/octagon-1-vertex.json
other=$data/verified/octagon-9-vertices.json
refuted=$data/refuted/surface-torus.json
malformed=$data/malformed/empty.json
undecided=$data/undecided/packing-epsilon-is-the-edge-length-to-2600-digits.json
missing=no/such/file.json

fail() {
  echo "$*"
  failures=$((failures + 1))
}
# says TEXT ARGUMENTS...: what certify prints, on whatever channel, has a line that is TEXT.
says() {
  text=$1
  shift
  runs=$((runs + 1))
  "$certify" "$@" 2>&1 | grep -Fqx -- "$text" || fail "certify $*: no line '$text'"
}

if [ "$("$certify" "$good" | tail -n 1)" != VERIFIED ]; then fail "VERIFIED does not stand alone on the last line"; fi

# Numbers in options are digits.
for option in --threads --max-precision --max-visits; do
  for value in -1 +1 1.0 1e2 0x10 ' 1' '1 ' x 18446744073709551616 99999999999999999999; do
    expect 64 '' $option "$value" "$good"
    expect 64 '' "$option=$value" "$good"
    says "$option: \"$value\" is not an integer from $(
      case $option in
        --threads) echo 0 to 1024 ;;
        --max-precision) echo 64 to 1048576 ;;
        *) echo 1 to 18446744073709551615 ;;
      esac
    )" $option "$value" "$good"
  done
done
expect 64 '' --threads 1025 "$good"
expect 64 '' --max-precision 63 "$good"
expect 64 '' --max-precision 1048577 "$good"
expect 64 '' --max-visits 0 "$good"
expect 0 VERIFIED --threads 1 --max-precision 64 --max-visits 18446744073709551615 "$good"
expect 0 VERIFIED --threads 08 --max-precision 0064 "$good"

says '--thread: no such option, did you mean --threads?' --thread 2 "$good"
says '--max-precison: no such option, did you mean --max-precision?' --max-precison=100 "$good"
says '--jsn: no such option, did you mean --json?' --jsn
says '--frobnicate: no such option' --frobnicate "$good"
says "certify: \"$missing\": no such file" "$missing"
says "certify: \"$data\": is a directory, expected a file" "$data"
says "certify: \"/dev/zero\": is a device, expected a file" /dev/zero
far=$data/malformed/vertex-chart-out-of-range.json
says "MALFORMED: \"$far\": vertices[0]: chart 1 does not exist, expected less than 1" "$far"

# The SHA-256 is that of the bytes. Of a malformed file nothing is counted and nothing claimed.
for file in "$good" "$malformed" "$refuted"; do
  sum=$(sha256sum <"$file" | cut -d ' ' -f 1)
  says "sha256: $sum" "$file"
  "$certify" --json "$file" | grep -q "\"sha256\": \"$sum\"" || fail "--json $file: not the sum of sha256sum"
done
for file in "$data"/malformed/*; do
  "$certify" "$file" | grep -v -e '^sha256: ' -e '^MALFORMED: ' && fail "$file: more than that it is malformed"
  "$certify" --json "$file" | grep -e '"counts"' -e '"claim"' -e '"rules"' && fail "--json $file: counts or claims"
done

# A surface file claims nothing, which is no fault of the file; a broken one is malformed.
surface=$data/../surfaces/cuff-1e-28.json
no_claim='this is a surface file, which claims nothing; epsnet net FILE --epsilon 0.1 -o net.json makes a net of it'
expect 5 "NO CLAIM: \"$surface\": $no_claim" "$surface"
expect 5 "NO CLAIM: standard input: $no_claim" - <"$surface"
expect 5 "NO CLAIM: \"$surface\": $no_claim" "$good" "$surface" "$malformed"
# However large: what is read in chunks, and not kept for the second checker, likewise.
large=$scratch/large.json
{ cat "$surface"; head -c 5000000 /dev/zero | tr '\0' ' '; } >"$large"
expect 5 "NO CLAIM: \"$large\": $no_claim" "$large"
expect 5 "NO CLAIM: standard input: $no_claim" - <"$large"
{ cat "$large"; echo x; } >"$scratch/large-malformed.json"
expect 3 "MALFORMED: \"$scratch/large-malformed.json\": " "$scratch/large-malformed.json"
expect 5 '{"verdict": null, "file": ' --json "$surface"
"$certify" --json "$surface" | grep -Fq "\"no_claim\": \"$no_claim\"}" || fail "--json of a surface file"
"$certify" "$surface" | grep -v -e '^sha256: ' -e '^NO CLAIM: ' && fail "$surface: more than that it claims nothing"
sed 's/"version":1/"version":2/' "$surface" >"$scratch/broken.json"
expect 3 "MALFORMED: \"$scratch/broken.json\": surface file: version 2 is not" "$scratch/broken.json"
exact() {
  code=$1
  line=$2
  runs=$((runs + 1))
  [ "$("$certify_exact" "$3"; echo $?)" = "$line
$code" ] || fail "certify-exact $3: not '$line' and $code"
}
exact 5 "NO CLAIM: $no_claim" "$surface"
exact 0 "$("$certify" --version | sed 's/certify/certify-exact/')" --version
# No text of a file is a line of output.
printf '{"a\\nVERIFIED":1,"format":"epsnet-net","version":1}' >"$scratch/two-lines.json"
exact 3 'MALFORMED: unknown member "a?VERIFIED"' "$scratch/two-lines.json"

# So do other files that epsnet writes, by their beginnings; with another one they are broken.
claims_nothing() {
  printf "$1" >"$scratch/other"
  why="this begins as $2, which claims nothing; files of nets and of answers do"
  expect 5 "NO CLAIM: \"$scratch/other\": $why" "$scratch/other"
  exact 5 "NO CLAIM: $why" "$scratch/other"
  printf "x$1" >"$scratch/other"
  expect 3 "MALFORMED: \"$scratch/other\": " "$scratch/other"
}
claims_nothing '{"format": "epsnet-dirichlet", "version": 1, "sides": []}' "a Dirichlet domain"
claims_nothing '{"format": "epsnet-matrices", "version": 1}' "a file of matrices"
claims_nothing '{"format": "epsnet-mesh", "version": 1}' "a mesh"
claims_nothing '<svg xmlns="http://www.w3.org/2000/svg"></svg>' "an SVG picture"
claims_nothing '\211PNG\r\n' "a PNG picture"
claims_nothing '<!DOCTYPE html>\n' "an HTML page"
claims_nothing '<?xml version="1.0"?>\n<VTKFile>' "a file of XML, such as VTU"
claims_nothing 'OFF\n3 1 0\n' "a mesh"
claims_nothing '$MeshFormat\n4.1 0 8\n' "a mesh"
claims_nothing 'MeshVersionFormatted 2\n' "a mesh"
claims_nothing 'MFEM mesh v1.0\n' "a mesh"
claims_nothing '%%%%MatrixMarket matrix' "a MatrixMarket matrix"
claims_nothing '\223NUMPY\1' "a NumPy array"
claims_nothing '2 no\n' "a text of numbers, as of CGAL"
claims_nothing 'u\tv\tlength\n' "a table"
claims_nothing 'from,to,distance\n' "a table"
claims_nothing 'step,0\n' "a table"
exact 3 "MALFORMED: unexpected value for the format" "$scratch/broken.json"

# Standard input and pipes are read once.
expect 0 VERIFIED - <"$good"
for input in - /dev/stdin; do
  if [ "$(sed '' "$good" | "$certify" "$input" | tail -n 1)" != VERIFIED ]; then fail "a pipe as $input is not read"; fi
done
expect 64 '' - - <"$good"
expect 64 '' - </dev/zero
: | "$certify" - | grep -q '^MALFORMED: standard input: ' || fail "standard input is not named"

# Several files: the last line and the exit code are those of the first that is not verified.
expect 0 VERIFIED "$good" "$other" "$good"
expect 1 "REFUTED: \"$refuted\": surface: " "$good" "$refuted" "$undecided" "$malformed" "$missing" "$other"
expect 2 "UNDECIDED: \"$undecided\": packing: " "$undecided" "$refuted" "$good"
expect 3 "MALFORMED: \"$malformed\": document: " "$good" "$malformed" "$refuted"
expect 64 "ERROR: \"$missing\": no such file" "$good" "$missing" "$refuted" "$other"
says 'verified: 2 of 4 files' "$good" "$missing" "$refuted" "$other"
says "\"$missing\": ERROR: no such file" "$good" "$missing"
says "\"$good\": VERIFIED" "$good" "$refuted"
"$certify" "$good" "$refuted" "$other" | grep -qx VERIFIED && fail "of several files, not all verified, a line is VERIFIED"
lines=$("$certify" --json "$good" "$refuted" "$missing" "$other" 2>/dev/null | grep -c '^{"verdict": .*}$')
if [ "$lines" != 4 ]; then fail "--json of four files has $lines objects"; fi
expect 1 '{"verdict": "VERIFIED", "file": ' --json "$refuted" "$other"

# An interval contains its number, in JSON as in lines: 2 arcosh of a square root and 4 pi are no decimals.
for file in "$good" "$other"; do
  json=$("$certify" --json "$file")
  "$certify" "$file" | grep '^[a-z ]*: \[' | {
    count=0
    while IFS= read -r line; do
      count=$((count + 1))
      key=$(echo "${line%%: *}" | tr ' ' _)
      case $json in
        *"\"$key\": ${line#*: }"[,}]*) ;;
        *) echo "--json $file has not the line '$line'" ; exit 1 ;;
      esac
    done
    [ "$count" -ge 4 ] || { echo "$file: $count intervals"; exit 1; }
  } || fail "--json $file: intervals"
done
# 4 pi is 12.566370614359172953…, which is not below the nearest binary64.
area='12.566370614359172, 12.566370614359175'
says "area: [$area]" "$good"
"$certify" --json "$good" | grep -q "\"area\": \[$area\]" || fail "--json $good: the area does not lie in [$area]"

if [ -w /dev/full ]; then
  "$certify" "$good" >/dev/full 2>/dev/null
  if [ $? != 70 ]; then fail "a full disk does not give exit code 70"; fi
fi
# A limit on the size of files is a full disk, not a death by signal.
output=$(mktemp)
(
  ulimit -f 0
  exec "$certify" "$good" >"$output" 2>/dev/null
)
if [ $? != 70 ]; then fail "a limit on the size of files does not give exit code 70"; fi
rm -f "$output"
# A stack that runs out gives exit code 70. How much is enough depends on the machine: too little for the loader kills
# by signal, enough is verified; there is a size between.
size=12
code=0
{
  while [ $size -lt 400 ] && [ "$code" != 70 ]; do
    (
      # shellcheck disable=SC3045  # dash and bash have it.
      ulimit -s $size
      exec "$certify" --threads 1 "$other" >/dev/null 2>&1
    )
    code=$?
    size=$((size + 1))
  done
} 2>/dev/null
if [ "$code" != 70 ]; then fail "a stack that runs out does not give exit code 70"; fi
parsed=$(mktemp)
"$certify" --print-parsed "$good" | sed '/^surface: /,$d' >"$parsed"
if ! cmp -s "$parsed" "$good" && ! "$certify" "$parsed" >/dev/null; then
  fail "what --print-parsed prints is not the document"
fi
rm -f "$parsed"

if [ "$runs" -lt 200 ]; then
  fail "only $runs runs: are the data there?"
fi
echo "$runs runs, $failures failures"
[ "$failures" = 0 ]
