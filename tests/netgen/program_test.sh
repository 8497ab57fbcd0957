#!/bin/sh
# program_test.sh EPSNET CERTIFY DATA: drives the programs end to end.
epsnet=$1
certify=$2
data=$3
. "$(dirname "$0")/program_functions.sh"

# ---- The main job ----
for seed in 1 123 -7; do
  good surface octagon --seed $seed -o s.json
  for epsilon in 0.5 3/10 1e-1 30; do
    good net s.json --epsilon $epsilon -o net.json --svg net.svg --stats
    grep -q '^verdict: VERIFIED$' output || complain "no verdict for seed $seed, epsilon $epsilon"
    grep -q '^lower bound' output || complain "no statistics for seed $seed, epsilon $epsilon"
    verified net.json
    good draw net.json -o again.svg
    same net.svg again.svg
    good info net.json
    grep -q '^vertices: [1-9]' output || complain "info does not count vertices"
    good draw net.json -o d.svg --dirichlet --order bfs --size 400
    grep -q 'Dirichlet domain' d.svg || complain "no Dirichlet domain"
  done
done
good surface octagon --seed 123 -o s.json
good info s.json
says '^genus: 2$'
good net s.json --epsilon 0.1 -o sparse.json --sparse --stats
verified sparse.json
says '^lower bound.* ratio 1\.4'
good net s.json --epsilon 0.1 -o sparse-again.json --sparse --threads 1
same sparse.json sparse-again.json
good net s.json --epsilon 0.4 -o sparse-base.json --sparse --base 0
verified sparse-base.json
good --version
says '^epsnet [0-9.]*$'
good net s.json --epsilon 0.2 -o unproved.json --no-certify
says 'not certified'
verified unproved.json
good surface fenchel-nielsen --pants-graph "0-0 0-1 1-1" --lengths 1e-8,2,1 --seed 1 -o thin.json
good net thin.json --epsilon 0.34 --pseudo -o pseudo.json
says '^pseudo net, collars: 1$'
verified pseudo.json
good info pseudo.json
says '^collar at vertices'
good surface import "$data/polygons/polygon-g3-rnd0.txt" -o g3.json
good net g3.json --epsilon 0.5 -o net.json
verified net.json

# Closed geodesics, each list with its certificate.
good surface regular --genus 2 -o bolza.json
good systole bolza.json -o systole.json
grep -qE '^systole: \[3\.05714183896199(5[0-9]*|6), 3\.05714183896199[78][0-9]*\]$' output || complain "the systole of the Bolza surface: $(cat output)"
verified systole.json
good spectrum bolza.json --up-to 3.1 -o spectrum.json
[ "$(grep -c 'simple, one of 12 of equal length' output)" = 12 ] || complain "the twelve systoles of the Bolza surface: $(cat output)"
verified spectrum.json
good spectrum bolza.json --up-to 3
says '^closed geodesics: 0'
good local-maximum bolza.json -o maximum.json
says '^a local maximum of the systole: 12 shortest closed geodesics of length \[3\.0571'
verified maximum.json
good surface fenchel-nielsen --pants-graph '0-1 0-1 0-1' --lengths 1e-3,1e-8,0.5 --twists 0.2 -o thin.json
good thick-thin thin.json -o thick.json
[ "$(grep -c '^piece .: genus 0, 3 boundaries' output)" = 2 ] || complain "two pairs of pants: $(cat output)"
verified thick.json
"$epsnet" thick-thin thin.json --epsilon 0.4 -o - >output 2>"$messages" || complain "thick-thin to standard output: $(cat "$messages")"
verified output
good systole s.json --no-certify
says '^verdict: not certified'
# The coarsest net serves as well as any other.
grep '^systole: ' output >systole.txt
good systole s.json --epsilon 200 --no-certify
grep -qxFf systole.txt output || complain "the systole depends on the net: $(cat output)"

# There and back through the texts of CGAL.
good surface import "$data/triangulations/triangulation-g3-e0.01.txt" -o t.json
good info t.json
says '^genus: 3$'
good export t.json --format triangulation -o t.txt
same "$data/triangulations/triangulation-g3-e0.01.txt" t.txt
good surface import --format triangulation /dev/stdin -o t2.json <t.txt
same t.json t2.json
good export g3.json --format domain -o polygon.txt
good surface import polygon.txt --format domain -o again.json
same g3.json again.json
good export net.json --format triangulation -o net.txt
good surface import net.txt -o as-surface.json
good export as-surface.json --format triangulation -o again.txt
same net.txt again.txt
"$epsnet" export t.json --format triangulation -o - | cmp -s - t.txt || complain "a triangulation on standard output"

# The same bytes again, whatever the number of threads, and on standard output.
good net s.json --epsilon 0.2 -o once.json --threads 1
good net s.json --epsilon 0.2 -o twice.json --threads 3
same once.json twice.json
"$epsnet" surface octagon --seed 123 -o - >piped.json || complain "a surface on standard output"
same s.json piped.json
"$epsnet" net s.json --epsilon 0.2 -o - 2>report >piped.json || complain "a net on standard output"
same once.json piped.json
grep -q '^verdict: VERIFIED$' report || complain "the report is not on standard error when the net is on standard output"
"$epsnet" draw once.json -o - >piped.svg && "$epsnet" draw once.json -o file.svg && same piped.svg file.svg
good surface import "$data/octagons/g2-seed-123.txt" -o imported.json
same s.json imported.json

# Surfaces of every genus and by name, base points, Dirichlet domains.
good surface fenchel-nielsen --genus 3 --seed 3 -o fn.json
good surface fenchel-nielsen --genus 3 --seed 3 -o again.json
same fn.json again.json
grep -q 'r=' fn.json || complain 'the surface does not say what it is'
echo '{"genus": 3, "seed": 3}' >request.json
good surface fenchel-nielsen --from request.json -o again.json
same fn.json again.json
good surface fenchel-nielsen --pants-graph '0-0 0-1 1-1' --lengths 1,1e-6,30 --twists=-0.25,1e-7,40 -o thin.json
good surface regular --genus 2 -o bolza.json
for surface in fn thin bolza; do
  good info "$surface.json"
  good net "$surface.json" --epsilon 0.5 -o net.json --svg net.svg --stats
  verified net.json
  good info net.json
  good draw net.json -o d.svg
  good net "$surface.json" --epsilon 0.5 --base 0 -o net.json
  verified net.json
  good dirichlet "$surface.json" --base 0 -o domain.json
  grep -q '"partner"' domain.json || complain "no sides in the Dirichlet domain of $surface"
done
good net bolza.json --epsilon 0.5 --base 0,0.1,1/7 -o net.json
verified net.json
good dirichlet bolza.json -o - --svg domain.svg
grep -q 'path' domain.svg || complain 'no picture of the Dirichlet domain'

# Pictures, pages, meshes.
good net s.json --epsilon 0.3 -o net.json
good draw net.json -o all.svg --show triangles,vertices,dirichlet,combinatorial-dirichlet,tiles,disks,half-disks --colour circumradius --legend --centre 3
grep -q 'Dirichlet domain of vertex 3' all.svg || complain 'no Dirichlet domain of the centre'
good draw net.json -o chart.svg --color chart --show vertices
grep -q 'class="edges"' chart.svg && complain 'triangles that were not asked for'
good draw net.json -o net.png --png --size 300 --legend
[ "$(head -c 4 net.png | tail -c 3)" = PNG ] || complain 'no PNG'
good view net.json -o view.html --title '<b> & "c"</script>'
says '^verdict: VERIFIED$'
grep -q '<title>&lt;b&gt; &amp; &quot;c&quot;&lt;/script&gt;</title>' view.html || complain 'the title is not escaped'
good view net.json -o plain.html --title plain
[ "$(grep -c '</script>' view.html)" = "$(grep -c '</script>' plain.html)" ] || complain 'a title ends a script'
grep -q '"verdict": "VERIFIED"' view.html || complain 'the page has no verdict'
grep -q -e 'https*:' -e 'src=' view.html && complain 'the page needs something else'
good view net.json -o again.html --title '<b> & "c"</script>' --threads 1
same view.html again.html
good view net.json -o unproved.html --no-certify
grep -q '"verdict": "not certified"' unproved.html || complain 'a page of a net that was not certified'
good view "$data/certify/refuted/covering-epsilon-too-small.json" -o refuted.html
says '^verdict: REFUTED$'
grep -q '"verdict": "REFUTED"' refuted.html || complain 'a page of a refuted net'
"$epsnet" view net.json -o - 2>report >piped.html && [ -s piped.html ] || complain 'a page on standard output'
good surface fenchel-nielsen --pants-graph '0-0 0-1 1-1' --lengths 1,1e-6,2 --twists 0,1e-7,0 -o pinched.json
good net pinched.json --epsilon 0.3 --pseudo -o pinched-net.json
good draw pinched-net.json -o pinched.svg --legend
grep -q '<title>triangles of collars</title>' pinched.svg || complain 'no collars in the picture of a pseudo net'
grep -q '<title>epsilon-collars</title>' pinched.svg || complain 'no boundaries of collars in the picture of a pseudo net'
good view pinched-net.json -o pinched.html
grep -q '"name": "epsilon-collars"' pinched.html || complain 'no collars in the page of a pseudo net'
# However thin: every layer, and nothing is left out.
good surface fenchel-nielsen --pants-graph '0-0 0-1 1-1' --lengths 1,1e-8,2 --twists 0,1e-9,0.5 -o thinnest.json
good net thinnest.json --epsilon 0.25 --pseudo -o thinnest-net.json
good draw thinnest-net.json -o thinnest.svg --legend --show triangles,vertices,tiles,dirichlet,combinatorial-dirichlet,disks
good view thinnest-net.json -o thinnest.html
grep -q '^left out' output && complain "the page of a thin net leaves out: $(cat output)"
good spectrum s.json --up-to 3 -o spectrum.json
good draw net.json -o geodesics.svg --geodesics spectrum.json
grep -q '<title>closed geodesics</title>' geodesics.svg || complain 'no geodesics in the picture'
good net g3.json --epsilon 0.5 -o g3.json.net
good view net.json -o geodesics.html --geodesics spectrum.json
grep -q '"name": "closed geodesics"' geodesics.html || complain 'no geodesics in the page'
for format in off vtu gmsh gmsh-glued medit edges adjacency face-adjacency json; do
  good export net.json --format $format -o mesh.$format
  "$epsnet" export net.json --format $format -o - | cmp -s - mesh.$format || complain "$format on standard output"
done

bad 1 'two edges of the net have the same ends; for MFEM they are one: take a smaller epsilon' export net.json --format mfem -o out/mesh.mesh
good net s.json --epsilon 0.1 -o fine.json
good export fine.json --format mfem -o mfem.mesh

# Compact net files, both ways, and wherever a net file is read.
good convert net.json net.epsn
[ "$(head -c 7 net.epsn | tail -c 6)" = EPSNET ] || complain "a compact file begins otherwise"
good convert net.epsn back.json
cmp -s net.json back.json || complain "a net that was converted and back is another"
good convert net.epsn again.epsn
cmp -s net.epsn again.epsn || complain "a compact file that was converted is another"
"$epsnet" convert net.epsn - | cmp -s - net.json || complain "a net on standard output"
"$epsnet" convert - from-pipe.json <net.epsn || complain "a compact file from a pipe"
cmp -s net.json from-pipe.json || complain "a compact file from a pipe is another"
good info net.epsn
cp output info-of-compact
good info net.json
cmp -s output info-of-compact || complain "info of a compact file says something else"
good draw net.epsn -o compact.svg
"$certify" --json net.epsn | sed 's/"sha256": *"[^"]*"//; s/net.epsn//g' >compact-certificate
"$certify" --json net.json | sed 's/"sha256": *"[^"]*"//; s/net.json//g' >json-certificate
cmp -s compact-certificate json-certificate || complain "certify says something else of a compact file"
bad 64 '.epsn is for a compact net file' surface octagon --seed 1 -o out/s.epsn
bad 1 'expected a net file' convert polygon.txt out/x.epsn
head -c 500 net.epsn >cut.epsn
bad 1 'checksum' convert cut.epsn out/x.json
bad 64 'TO' convert net.json
# Files of more than 4 MB are read in pieces, and threads share the work: the output is the same.
good net s.json --epsilon 0.01 --no-certify -o large.json
good convert large.json large.epsn
head -c 7000000 large.json >cut.json
for file in large.json large.epsn cut.json; do
  for threads in 1 2 5; do
    "$certify" --threads $threads $file >certificate-$threads
    cmp -s certificate-1 certificate-$threads || complain "certify --threads $threads $file says something else"
  done
  grep -q "^sha256: $(sha256sum <$file | cut -d ' ' -f 1)$" certificate-1 || complain "$file: not the sum of sha256sum"
done

for command in '' surface 'surface octagon' 'surface fenchel-nielsen' 'surface regular' 'surface import' net import-net systole spectrum \
  thick-thin local-maximum dirichlet distance locate distances eccentricity diameter radius embedded-disk draw view info export convert help; do
  # shellcheck disable=SC2086
  good $command --help
  grep -q 'Example' output || complain "epsnet $command --help has no example"
  awk 'length($0) > 80' output | grep . && complain "epsnet $command --help has lines of more than 80 columns"
done

# ---- Wrong usage ----
bad 64 'which command'
bad 64 'ln sqrt(2)' net thin.json --epsilon 0.35 --pseudo -o out/net.json
bad 64 'nonsense' nonsense
bad 64 'octagon, fenchel-nielsen, regular, cover, dehn-twist, twist, named, map, matrices or import' surface
bad 64 'nonsense' surface nonsense
bad 64 'seed' surface octagon -o out/s.json
bad 64 '^epsnet: --sparse and --pseudo: a pseudo net cannot be sparse' net thin.json --epsilon 0.3 --sparse --pseudo -o out/net.json
bad 64 'genus: needed' surface fenchel-nielsen --seed 1 -o out/s.json
bad 64 'seed: needed' surface fenchel-nielsen --genus 2 -o out/s.json
bad 64 'from 2 to 100000, not "1"' surface fenchel-nielsen --genus 1 --seed 1 -o out/s.json
bad 64 'from 2 to 100000, not "4000000000"' surface fenchel-nielsen --genus 4000000000 --seed 1 -o out/s.json
bad 64 'node 0 has more than three' surface fenchel-nielsen --seed 1 --pants-graph '0-0 0-0 1-1' -o out/s.json
bad 64 'not connected' surface fenchel-nielsen --seed 1 --pants-graph '0-1 0-1 0-1 2-3 2-3 2-3' -o out/s.json
bad 64 'expected 1 or 3' surface fenchel-nielsen --seed 1 --genus 2 --lengths 1,2 -o out/s.json
bad 64 'lengths' surface fenchel-nielsen --seed 1 --genus 2 --lengths nan -o out/s.json
bad 64 'genus' surface regular -o out/s.json
bad 64 'base' net fn.json --epsilon 1 --base x -o out/n.json
bad 64 'base' dirichlet fn.json --base 0,1 -o out/n.json
bad 64 'standard output' dirichlet fn.json -o - --svg -
bad 64 'seed' surface octagon --seed x -o out/s.json
bad 64 'seed' surface octagon --seed 99999999999 -o out/s.json
bad 64 'output' surface octagon --seed 1
bad 64 'epsilon' net s.json -o out/n.json
bad 64 'standard output' net s.json --epsilon 1 -o - --svg -
bad 64 'threads' net s.json --epsilon 1 -o out/n.json --threads -1
bad 64 'format' export s.json -o out/x.txt
bad 64 'format' export s.json --format magic -o out/x.txt
bad 64 'format' export s.json --format auto -o out/x.txt
bad 64 'output' export s.json --format domain
bad 64 'format' surface import t.txt --format magic -o out/s.json
bad 64 'size' draw once.json -o out/x.svg --size 10
bad 64 'show' draw once.json -o out/x.svg --show magic
bad 64 'colour' draw once.json -o out/x.svg --colour magic
bad 64 'output' view once.json
bad 64 'threads' view once.json -o out/x.html --threads -1
bad 64 'order' draw once.json -o out/x.svg --order magic
bad 64 'up-to' spectrum s.json
for length in 0 -1 nan inf 1/0 x '' 1e99999; do
  bad 64 'up-to' spectrum s.json --up-to "$length" -o out/x.json
done
bad 64 'psilon' systole s.json --epsilon 0 -o out/x.json
bad 64 'SURFACE' systole
bad 1 'more than the limit' spectrum s.json --up-to 100 -o out/x.json
bad 1 'no-such' thick-thin no-such.json -o out/x.json
bad 1 'no directory' thick-thin s.json -o no-such/x.json
for epsilon in 0 -1 0.0 -0.5 nan NaN inf infinity 1/0 0/5 -1/2 '' ' ' 0,1 1e 0x1 '1 ' 1e99999; do
  bad 64 'psilon' net s.json --epsilon "$epsilon" -o out/n.json
done
line='two
lines'
bad 64 'psilon' net s.json --epsilon "$line" -o out/n.json

# ---- Files ----
bad 64 '--lengths: edge 0 .*a length must be at least' surface fenchel-nielsen --seed 1 --genus 2 --lengths 0 -o out/s.json
bad 64 '--lengths: edge 0 .*a length must be at least' surface fenchel-nielsen --seed 1 --genus 2 --lengths=-1 -o out/s.json
for command in 'net --epsilon 0.5' 'net --epsilon 0.3 --pseudo' 'net --epsilon 0.5 --base 0' dirichlet systole; do
  bad 1 'tile 0 is too thin: closed geodesics through it may be as short as' $command "$data/surfaces/cuff-1e-28.json" -o out/x.json
done
bad 1 'no-such' surface fenchel-nielsen --from no-such.json -o out/s.json
echo '{"graph": "0-1 0-1 0-1", "lengths": [1, 0, 1], "twists": [0]}' >short.json
bad 1 'short.json: edge 1 (0-1): a length must be at least' surface fenchel-nielsen --from short.json -o out/s.json
echo '{"graph": "0-1 0-1 0-1", "lengths": [1, Infinity, 1], "twists": [0]}' >infinite.json
bad 1 'infinite.json: lengths: expected a number.*"Infinity"' surface fenchel-nielsen --from infinite.json -o out/s.json
bad 64 '--genus: expected an integer from 2 to 1000, not "1001"' surface regular --genus 1001 -o out/s.json
bad 1 'not inside of the unit disk' net fn.json --epsilon 1 --base 0,1,0 -o out/n.json
bad 1 'the surface has 4 tiles' net fn.json --epsilon 1 --base 4 -o out/n.json
bad 64 'expected one of domain, triangulation, off, vtu, gmsh, gmsh-glued, medit, mfem, edges, adjacency, face-adjacency, json, matrices, not "obj"' export fn.json --format obj -o out/e
bad 64 '--genus: expected an integer from 2 to 1000, not "three"' surface regular --genus three
bad 64 '--seed: expected an integer from -2147483648 to 2147483647, not "three"' surface octagon --seed three -o out/s.json
bad 64 'to 18446744073709551615, not "18446744073709551616"' surface fenchel-nielsen --genus 2 --seed 18446744073709551616 -o out/s.json
bad 64 'to 18446744073709551615, not "-1"' surface fenchel-nielsen --genus 2 --seed -1 -o out/s.json
bad 64 'excludes' surface named --list --json
bad 64 'not "1001"' surface dehn-twist bolza.json 0 1001 -o out/s.json
bad 64 '--on needs PRODUCT' mapping-class bolza.json --on 0
bad 1 'not inside of the unit disk' net bolza.json --epsilon 1 --base 0,1.1,0 -o out/n.json
bad 1 'no-such' dirichlet no-such.json -o out/d.json
bad 1 'no rational' export bolza.json --format domain -o out/x.txt
bad 1 'no rational' export bolza.json --format triangulation -o out/x.txt
bad 1 'no-such' net no-such.json --epsilon 1 -o out/n.json
bad 1 'no-such' info no-such.json
bad 1 'no-such' draw no-such.json -o out/x.svg
bad 1 'no-such' view no-such.json -o out/x.html
bad 1 'no-dir' view once.json -o no-dir/x.html
bad 1 'no vertex 100000' draw once.json -o out/x.svg --centre 100000
bad 1 'of another surface' draw g3.json.net -o out/x.svg --geodesics spectrum.json
bad 1 'net.json' draw net.json -o out/x.svg --geodesics net.json
bad 1 'takes a net' export s.json --format vtu -o out/x.vtu
bad 1 'no-such' surface import no-such.txt -o out/s.json
bad 1 'no-such' export no-such.json --format domain -o out/x.txt
bad 1 'no-dir' export s.json --format domain -o no-dir/x.txt
bad 1 'not a net; use --format triangulation' export once.json --format domain -o out/x.txt
bad 1 'one polygon, the surface has 20 tiles' export t.json --format domain -o out/x.txt
bad 1 't.txt:2: "yes" found' surface import t.txt --format domain -o out/s.json
bad 1 '8 darts found' surface import "$data/octagons/g2-seed-1.txt" --format triangulation -o out/s.json
bad 1 'neither "yes" nor "no"' surface import s.json -o out/s.json
bad 1 'no-such' info "no-such
file"
bad 1 'no-dir' net s.json --epsilon 1 -o no-dir/n.json
bad 1 'no-dir' net s.json --epsilon 1 -o out/n.json --svg no-dir/n.svg
bad 1 'out' surface octagon --seed 1 -o out
bad 1 'out' info out
bad 1 'out' net out --epsilon 1 -o n.json
bad 1 'psilon' net s.json --epsilon 1e-9 -o out/n.json
if [ -w /dev/full ]; then
  bad 1 '/dev/full' surface octagon --seed 1 -o /dev/full
  runs=$((runs + 1))
  "$epsnet" info s.json >/dev/full 2>"$messages"
  [ $? = 1 ] || complain "a full disk under standard output"
fi
# A file size limit is a full disk for the temporary file.
(ulimit -f 8 && "$epsnet" net s.json --epsilon 0.05 -o out/n.json >output 2>"$messages")
[ $? = 1 ] || complain "a file too large: exit code, $(cat "$messages")"
[ -z "$(ls -A out)" ] || complain "a file too large leaves $(ls -A out)"
# What was there before stays.
echo precious >out/kept.json
(ulimit -f 8 && "$epsnet" net s.json --epsilon 0.05 -o out/kept.json >output 2>"$messages")
[ "$(cat out/*)" = precious ] || complain "a failed job changes the file that was there"
rm -f out/kept.json

# ---- Files that are not what they should be ----
: >empty
head -c 300 s.json >truncated.json
head -c 3000 once.json >truncated-net.json
printf '{"format": "epsnet-surface", "version": 9, "surface": {}}' >version.json
sed 's/\[0,0,0,4\]/[0,0,1000000000,4]/' s.json >claims.json
head -c 100000 /dev/zero | tr '\0' '[' >nested.json
head -c 5000 /dev/urandom >random
for file in empty truncated.json version.json claims.json nested.json random; do
  bad 1 "$file" net $file --epsilon 1 -o out/n.json
  bad 1 "$file" info $file
  bad 1 "$file" draw $file -o out/x.svg
  bad 1 "$file" view $file -o out/x.html
  bad 1 "$file" surface import $file -o out/s.json
  bad 1 "$file" export $file --format triangulation -o out/x.txt
done
bad 1 truncated-net.json export truncated-net.json --format triangulation -o out/x.txt
bad 1 truncated-net.json draw truncated-net.json -o out/x.svg
bad 1 truncated-net.json info truncated-net.json
for file in "$data"/certify/malformed/*; do bad 1 "$(basename "$file")" draw "$file" -o out/x.svg; done
# Nets of which only the geometry is wrong are drawn, perhaps without a layer that is named, or refused; the same with what they say.
for file in "$data"/certify/refuted/* "$data"/certify/undecided/*; do
  for command in "draw -o x.svg" "draw -o x.svg --dirichlet" "draw -o x.png --png --show tiles,disks" "view -o x.html --no-certify" "export --format json -o x.json" info; do
    runs=$((runs + 1))
    # shellcheck disable=SC2086
    timeout 60 "$epsnet" $command "$file" >output 2>"$messages"
    code=$?
    case $code$(grep -cv '^left out: ' "$messages") in 00 | 11) ;; 641) says 'only for a net file' ;; *) complain "epsnet $command $file: exit code $code: $(cat "$messages")" ;; esac
  done
done

# ---- Polygons that are no surface ----
octagon="$data/octagons/g2-seed-123.txt"
polygon() { printf '%s\n' "$@" >polygon.txt; }
{ echo 1000000000; tail -n +2 "$octagon"; } >polygon.txt
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json
# The octagon with z3 moved (line 13) off the area condition: sides still pair, angles do not add up.
awk 'NR==13 || NR==17 {sub(/[0-9]\//, "1/")} {print}' "$octagon" >polygon.txt
cmp -s "$octagon" polygon.txt && complain "the octagon was not changed"
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json
awk 'NR==11 {$1 = "3/4"} {print}' "$octagon" >polygon.txt  # unequal sides
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json
awk 'NR==10 {$1 = "1"} {print}' "$octagon" >polygon.txt  # on the circle
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json
awk 'NR==10 {$1 = "3/2"} {print}' "$octagon" >polygon.txt  # outside of the disk
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json
awk 'NR==2 {$1 = "0"} {print}' "$octagon" >polygon.txt  # glued to itself
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json
awk 'NR==2 {$1 = "5"} {print}' "$octagon" >polygon.txt  # not symmetric
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json
{ head -n 9 "$octagon"; tail -n 8 "$octagon" | tac; } >polygon.txt  # clockwise
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json
polygon 4 1 0 3 2 '1/2 0' '0 1/2' '-1/2 0' '0 -1/2'  # a sphere
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json
polygon 4 2 3 0 1 '1/2 0' '0 1/2' '-1/2 0' '0 -1/2'  # a torus
bad 1 'polygon.txt' surface import polygon.txt -o out/s.json

# ---- Triangulations that are no surface ----
triangulation="$data/triangulations/triangulation-g2-e0.2.txt"
wrong() {
  awk "$2" "$triangulation" >wrong.txt
  bad 1 "$1" surface import wrong.txt -o out/s.json
}
wrong 'wrong.txt:1: the text claims 1000000002 darts' 'NR==1 {$1 = "1000000002"} {print}'
wrong 'wrong.txt:1: 31 darts found' 'NR==1 {$1 = "31"} {print}'
wrong 'wrong.txt: there is no anchor, and the cross-ratios keep no circle' 'NR==2 {$1 = "no"} NR==40 {$1 = "7"} NR<3 || NR>6 {print}'
# Without an anchor it is the same surface.
awk 'NR==2 {$1 = "no"} NR<3 || NR>6 {print}' "$triangulation" >bare.txt
good surface import bare.txt -o bare.json
wrong 'wrong.txt:12: dart 2 belongs to triangle 0 and to triangle 1' 'NR==12 {$1 = "2"} {print}'
wrong 'wrong.txt:41: dart 7 belongs to edge 0 and to edge 1' 'NR==41 {$1 = "7"} {print}'
wrong 'wrong.txt:39: "1/0" found' 'NR==39 {$1 = "1/0"} {print}'
wrong 'wrong.txt: the edge of darts 1 and 8 has length .*not those of a closed' 'NR==39 {$1 = "1"} {print}'
wrong 'wrong.txt:97: "7" follows the last edge' '{print} END {printf "7"}'
head -c 700 "$triangulation" >truncated.txt
bad 1 'truncated.txt:.*expected the ' surface import truncated.txt -o out/s.json

echo "$runs runs, $failures failures"
[ "$failures" = 0 ] && [ "$runs" -gt 150 ]
