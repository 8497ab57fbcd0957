#!/bin/sh
# import_net_test.sh EPSNET CERTIFY DATA: a triangulation as a net file, as it is, in all formats of CGAL; octagons by their coordinates.
epsnet=$1
certify=$2
data=$3
. "$(dirname "$0")/program_functions.sh"

# certified CODE LINE FILE: what certify says last.
certified() {
  last=$("$certify" "$3")
  code=$?
  [ $code = "$1" ] || complain "certify $3: exit code $code, expected $1"
  echo "$last" | tail -n 1 | grep -q -e "$2" || complain "certify $3: expected '$2', found $(echo "$last" | tail -n 1)"
}

without_anchor() { awk 'NR == 2 {print "no"; next} NR >= 3 && NR <= 6 {next} {print}' "$1"; }

# A net there and back: as many vertices, and still a net.
good surface octagon --seed 123 -o s.json
good net s.json --epsilon 0.26 -o net.json
says 'VERIFIED'
vertices=$(grep '^vertices: ' output)
good export net.json --format triangulation -o t.txt
good import-net t.txt --epsilon 0.26 -o imported.json
says '^verdict: VERIFIED$'
grep -q "^$vertices\$" output || complain "import-net changed the number of vertices: $(cat output), expected $vertices"
certified 0 '^VERIFIED$' imported.json
good export imported.json --format triangulation -o again.txt
[ "$(tail -n +7 t.txt)" = "$(tail -n +7 again.txt)" ] || complain "the triangulation of the imported net is another one"

# Without its anchor it is the same net.
without_anchor t.txt >bare.txt
good import-net bare.txt --epsilon 0.26 -o bare.json
says '^verdict: VERIFIED$'
certified 0 '^VERIFIED$' bare.json
good surface import bare.txt -o bare-surface.json
good info bare-surface.json
says '^genus: 2$'

# What is no net is written all the same, with the culprit.
bad 1 '^epsnet: t.txt: REFUTED: covering: triangle ' import-net t.txt --epsilon 0.25 -o small.json
certified 1 '^REFUTED: covering' small.json
bad 1 '^epsnet: t.txt: REFUTED: packing: ' import-net t.txt --epsilon 0.28 -o large.json
certified 1 '^REFUTED: packing' large.json
good surface import "$data/polygons/polygon-g3-rnd0.txt" -o g3.json
good export g3.json --format triangulation -o fan.txt
bad 1 'REFUTED: delaunay' import-net fan.txt --epsilon 0.5 -o fan.json
says '^why: delaunay: .*dart'
certified 1 '^REFUTED: delaunay' fan.json
for rule in covering packing; do
  file=$(ls "$data/certify/undecided/$rule"-*.json)
  epsilon=$(tr ',' '\n' <"$file" | sed -n 's/.*"epsilon": *"\([^"]*\)".*/\1/p')
  good export "$file" --format triangulation -o undecided.txt
  bad 2 "^epsnet: undecided.txt: UNDECIDED: $rule: " import-net undecided.txt --epsilon "$epsilon" -o undecided.json
  certified 2 "^UNDECIDED: $rule" undecided.json
done
"$epsnet" import-net t.txt --epsilon 0.26 -o - >piped.json 2>"$messages" || complain "import-net to standard output"
cmp -s piped.json imported.json || complain "standard output is another net"
grep -q '^verdict: VERIFIED$' "$messages" || complain "no report beside standard output"

# What is no triangulation of a surface is not written.
bad 1 'no-such.txt' import-net no-such.txt --epsilon 1 -o out/none.json
bad 1 'g2-seed-1.txt:.*a polygon is read by "surface import"' import-net "$data/octagons/g2-seed-1.txt" --epsilon 1 -o out/none.json
{ head -n -1 t.txt; echo 1/3; } >moved.txt
bad 1 '^epsnet: moved.txt: ' import-net moved.txt --epsilon 1 -o out/none.json
head -c 5000 t.txt >cut.txt
bad 1 '^epsnet: cut.txt:[0-9]*: ' import-net cut.txt --epsilon 1 -o out/none.json
bad 64 'epsilon' import-net t.txt --epsilon 0 -o out/none.json
bad 64 'epsilon' import-net t.txt -o out/none.json
bad 64 'FILE' import-net --epsilon 1 -o out/none.json
bad 1 'no directory' import-net t.txt --epsilon 1 -o out/no-such/none.json
good import-net --help
says 'Example'

# Octagons by their coordinates.
good surface octagon --coordinates 5/6,0,0.6,0.6,0,5/6,-3/5,0.6 -o o.json
good info o.json
says '^genus: 2$'
z=$(awk 'NR >= 10 && NR <= 13 {print $1 "," $2}' "$data/octagons/g2-seed-123.txt" | paste -sd ,)
good surface octagon --coordinates "$z" -o given.json
cmp -s given.json s.json || complain "the octagon of seed 123 by its coordinates is another one"
bad 64 'add up to .*, not to 2\*pi.*closes up for x3,y3 = ' surface octagon --coordinates 5/6,0,0.6,0.6,0,5/6,-0.6,0.59 -o out/none.json
z3=$(sed 's/.* for x3,y3 = //' "$messages")
good surface octagon --coordinates "5/6,0,0.6,0.6,0,5/6,$z3" -o closed.json
bad 64 'coordinates: 6 numbers found, expected 8' surface octagon --coordinates 5/6,0,0.6,0.6,0,5/6 -o out/none.json
bad 64 'coordinates: "half" found, expected y1' surface octagon --coordinates 5/6,0,0.6,half,0,5/6,-3/5,0.6 -o out/none.json
bad 64 'vertex 1 lies outside of the unit circle' surface octagon --coordinates 5/6,0,0.9,0.6,0,5/6,-3/5,0.6 -o out/none.json
bad 64 'not strictly convex at its vertex 1' surface octagon --coordinates 5/6,0,0.1,0.1,0,5/6,-3/5,0.6 -o out/none.json
bad 64 'clockwise' surface octagon --coordinates=-3/5,0.6,0,5/6,0.6,0.6,5/6,0 -o out/none.json
bad 64 'coordinates' surface octagon --seed 1 --coordinates 1,2 -o out/none.json
bad 64 'expected --seed or --coordinates' surface octagon -o out/none.json

[ $failures = 0 ] || { echo "$failures failures"; exit 1; }
echo "all as expected"
