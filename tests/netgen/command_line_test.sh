#!/bin/sh
# command_line_test.sh EPSNET CERTIFY DATA: no command line loses a file; command lines that cannot be right are refused with a message.
epsnet=$1
certify=$2
data=$3
. "$(dirname "$0")/program_functions.sh"

good surface octagon --seed 123 -o s.json
# Leading zeros do not make a number octal.
good surface octagon --seed 0123 -o padded.json
cmp -s s.json padded.json || complain '--seed 0123 is not --seed 123'
good net s.json --epsilon 0.5 -o net.json
good systole s.json -o systole.json
good spectrum s.json --up-to 3 -o spectrum.json
good eigenvalues s.json --count 1 --digits 2 -o rough.json
verified rough.json
grep -q '"eigenfunctions":\[\]' rough.json || complain 'eigenfunctions for two digits'
good eigenvalues s.json --count 1 --digits 4 -o eigenvalues.json --svg eigenvalues.svg
verified eigenvalues.json
says '^lambda_1 in \[[0-9.]*, [0-9.]*\], simple$'
says '^all others are at least [0-9.]*$'
says '^eigenvalues in (0, 1/4): none$'
good draw eigenvalues.json -o drawn.svg
same eigenvalues.svg drawn.svg
grep -q 'class="enclosures"' drawn.svg || complain 'no intervals in the picture of eigenvalues'
good draw eigenvalues.json --eigenfunction 1 -o drawn.svg
grep -q 'class="nodal-lines"' drawn.svg || complain 'no nodal lines in the picture of an eigenfunction'
good draw eigenvalues.json --eigenfunction 1 --centre 3 --order bfs -o other.svg
cmp -s drawn.svg other.svg && complain 'the picture of an eigenfunction has the same centre'
bad 1 '^epsnet: --eigenfunction: no eigenfunction of lambda_1000: the file has ' draw eigenvalues.json --eigenfunction 1000 -o out/x.svg
bad 1 '^epsnet: --eigenfunction: no eigenfunction of lambda_1: the file has no eigenfunctions, which take 3 digits or more' draw rough.json --eigenfunction 1 -o out/x.svg
bad 64 '^epsnet: draw: --eigenfunction: expected an integer from 1 to 1000000, not "0"' draw eigenvalues.json --eigenfunction 0 -o out/x.svg
bad 64 '^epsnet: --eigenfunction: only for an eigenvalues file' draw net.json --eigenfunction 1 -o out/x.svg
bad 64 '^epsnet: --legend: not with --eigenfunction' draw eigenvalues.json --eigenfunction 1 --legend -o out/x.svg
good draw eigenvalues.json -o eigenvalues.png --size 100
[ "$(od -An -t u1 -j 16 -N 8 eigenvalues.png | tr -s ' ')" = ' 0 0 0 100 0 0 0 62' ] || complain "the size of a picture that is not square: $(od -An -t u1 -j 16 -N 8 eigenvalues.png)"
bad 64 '^epsnet: --dirichlet: only for a net file' draw eigenvalues.json --dirichlet -o out/x.svg
good dirichlet s.json -o domain.json
good isometries s.json -o isometries.json
says '^verdict: VERIFIED$'
verified isometries.json
good info isometries.json
says '^isometries: 2$'
bad 64 '^epsnet: --output' isometries s.json -o isometries.txt.svg
good isometries s.json
says '^isometries: 2, of which 2 preserve orientation$'
good isometries s.json --json --threads 1
says '"fixed_points": *6'
# Three cuffs so short that no geodesic of a list crosses them: the pairs of pants have all symmetries, the surface has two.
good surface fenchel-nielsen --pants-graph '0-0 0-1 1-1' --lengths 0.011,0.011,0.011 --seed 1 -o thin.json
bad 1 '^epsnet: not certified: UNDECIDED: most: there are at most 24, with 256 bits' isometries thin.json -o out/x.json
# A disk of least radius about a corner of regular tiles, whose coordinates are rounded.
cat >corners.json <<'END'
{"format": "epsnet-surface", "version": 1, "surface": {"kind": "map", "p": 8, "q": 3, "gluing": [
[0, 0, 1, 0], [1, 7, 2, 1], [2, 0, 0, 1], [0, 7, 4, 7], [2, 7, 3, 0], [3, 1, 5, 5], [4, 0, 3, 2], [0, 2, 3, 7],
[0, 3, 4, 3], [0, 4, 1, 4], [0, 5, 2, 4], [0, 6, 3, 3], [4, 6, 1, 1], [4, 5, 5, 0], [5, 1, 3, 5], [2, 2, 5, 2],
[1, 2, 5, 7], [1, 3, 2, 5], [1, 5, 4, 2], [1, 6, 5, 3], [5, 4, 4, 1], [2, 3, 3, 4], [2, 6, 5, 6], [3, 6, 4, 4]]}}
END
good radius corners.json --width 1 -o corner-radius.json
verified corner-radius.json
good isometric s.json net.json
says '^isometric: yes$'
good pants s.json -o pants.json --svg pants.svg --json --threads 1
says '"verdict":"VERIFIED","genus":2,"graph":"0-1 [01]-[01] [01]-[01]","cuffs":\[{"ends":\[\[0,0\],\[1,0\]\],"length":\[0.5476'
verified pants.json
grep -q 'cuff 2, of length' pants.svg || complain "no cuffs in the picture of pants"
good draw pants.json -o drawn.svg
same pants.svg drawn.svg
good info pants.json
says '^file: a pants decomposition (not verified here: run certify)$'
good surface fenchel-nielsen --from pants.json -o from-pants.json
good pants from-pants.json -o pants-again.json
says '^verdict: VERIFIED$'
says '^these are the pants of which the surface was made$'
says '^  exp(length/2) = [0-9]*/[0-9]*, exactly$'
good pants from-pants.json --find
says '^pants: 2, cuffs: 3$'
printf '# short\n6\n' >curves.txt
bad 1 '^epsnet: curves.txt:2: curve 0: letter 0 is side 6, no side of tile 1, where the path ends' pants from-pants.json --curves curves.txt -o out/x.json
printf '0 2\n' >curves.txt
bad 1 '^epsnet: curves.txt:1: curve 0: null-homotopic' pants from-pants.json --curves curves.txt -o out/x.json
printf '2\n2,2\n' >curves.txt
bad 1 '^epsnet: curves.txt:2: curve 1: homotopic to curve 0' pants from-pants.json --curves curves.txt -o out/x.json
printf '2 x\n' >curves.txt
bad 1 '^epsnet: curves.txt:1: expected numbers of sides, as in 0 3 5, not "x"' pants from-pants.json --curves curves.txt -o out/x.json
printf '# nothing\n' >curves.txt
bad 1 '^epsnet: curves.txt: no curves, expected one on each line' pants from-pants.json --curves curves.txt -o out/x.json
# Mapping classes, and what they make of surfaces.
good mapping-class s.json 'a1 b1 c1 b2' --on 0
says '^order 10$'
bad 1 '^epsnet: at character 4 of "a1 z": expected a name from a1 to c1' mapping-class s.json 'a1 z'
bad 1 '^epsnet: PRODUCT: twist 1: power 2 of another closed curve$' mapping-class s.json 'a1 (0 0)'
bad 1 '^epsnet: --word: twist 0: power 2 of another closed curve$' surface dehn-twist s.json --word '(0 0)' -o out/x.json
good surface dehn-twist s.json --word 'a1 A1' -o triangles.json
good pants triangles.json -o marking.json
good pants triangles.json --marking marking.json
bad 1 '^epsnet: marking.json: the surface of the marking has other tiles' pants s.json --marking marking.json
good maximize systole s.json -o greatest.json
says '^closed geodesics as long as it, to 9 digits: 12$'
says '^a local maximum of the systole is nearer than'
# Closed curves: a side pairing, its square, the commutator of two that separates, and one that is none.
good curves s.json 0 '0 0' 0,1,4,5 --angles -o curves.json --svg curves.svg
grep -q 'curve 2, of length' curves.svg || complain 'no curves in their picture'
says '^verdict: VERIFIED$'
says '^curve 0: length .*, simple, not separating, class b2$'
says '^curve 1: length .*, power 2, self-intersections 1, class 2 b2$'
says '^curve 2: length .*, simple, separating, class 0$'
says '^curve 2 has genus 1 on its left, 1 on its right$'
says '^the curves do not fill the surface$'
verified curves.json
good draw curves.json -o drawn.svg
same curves.svg drawn.svg
good info curves.json
says '^file: closed curves (not verified here: run certify)$'
says '^basis of homology a1, b1, ...: curves 3 4 5 6$'
printf '0\n1 # another one\n2\n3\n' >words.txt
good curves s.json --curves words.txt --json --threads 1 -o curves.json
says '"fill": *true'
verified curves.json
bad 1 '^epsnet: WORD 1: null-homotopic' curves s.json 0 0,4 -o out/x.json
bad 1 '^epsnet: WORD 0: letter 0 is side 9, the surface has 8 sides' curves s.json 9 -o out/x.json
bad 64 '^epsnet: curves: expected WORD or --curves FILE' curves s.json -o out/x.json
good surface dehn-twist from-pants.json 2 -o once.json
good surface dehn-twist once.json '4 2' -2 -o twice.json --json
says '"tiles": *10'
good isometric from-pants.json twice.json
says '^isometric: yes$'
good surface twist from-pants.json 2 --by=-.125 -o moved.json
good isometric from-pants.json moved.json
says '^isometric: no$'
bad 1 '^epsnet: CURVE: null-homotopic$' surface dehn-twist from-pants.json 0,2 -o out/x.json
bad 1 '^epsnet: CURVE: not simple: its geodesic crosses itself$' surface dehn-twist from-pants.json '0 3 0' -o out/x.json
bad 1 '^epsnet: CURVE: expected numbers of sides, as in 0 3 5, not "two"' surface twist from-pants.json two --by 1 -o out/x.json
bad 64 'by' surface twist from-pants.json 2 --by much -o out/x.json
bad 64 '1001' surface dehn-twist from-pants.json 2 1001 -o out/x.json
bad 64 'excludes' pants from-pants.json --curves curves.txt --find
good surface regular --genus 2 -o bolza.json
good isometric s.json bolza.json
says '^isometric: no$'
says '^verdict: VERIFIED$'
good isometric s.json bolza.json -o different.json
verified different.json
good info different.json
says '^isometric: no$'
# The Bolza surface again, by octagons of which three meet at each vertex: GL(2,3).
printf '%s' '{"rotation":[1,3,5,6,8,9,11,13,14,16,18,19,21,22,24,2,20,27,28,30,32,33,35,4,31,38,39,40,41,0,29,26,43,10,7,42,45,46,47,23,25,44,37,15,12,17,34,36],"edges":[2,4,0,7,1,10,12,3,15,17,5,20,6,23,25,8,26,9,29,31,11,34,36,13,37,14,16,33,35,18,42,19,44,27,21,28,22,24,43,45,46,47,30,38,32,39,40,41]}' >octagons.json
good surface map octagons.json -o octagons-map.json
good isometric bolza.json octagons-map.json -o same.json
says '^isometric: yes$'
says '^verdict: VERIFIED$'
verified same.json
good identify octagons-map.json
says '^name: bolza$'
says '^also: R2.1 R2.3 R2.6$'
says '^isometry to bolza: preserves orientation$'
good identify octagons-map.json --json
says '"name":"bolza","names":\["bolza","R2.1","R2.3","R2.6"\],'
good identify s.json
says '^name: none that is known$'
good distance s.json 0,0.1,-1/3 0 -o distance.json
printf '0,0.1,0.1\n0,-0.3,1/3\n' >points.txt
good net s.json --epsilon 0.5 --points points.txt -o given.json
verified given.json
good locate given.json --points points.txt v7 t3:1,2,3
[ "$(grep -c 'at corner . nearest corner v[01] at 0$\|at corner ., nearest corner v[01] at 0$' output)" = 2 ] || complain "given points are vertices: $(cat output)"
# What is written and claims nothing is no broken claim.
for format in triangulation off vtu gmsh gmsh-glued medit edges adjacency face-adjacency json matrices; do
  good export net.json --format $format -o "$format.out"
  claims_nothing "$format.out"
done
good net s.json --epsilon 0.1 -o simple.json # MFEM: no loops, no edges with the same ends
good export simple.json --format mfem -o mfem.out
claims_nothing mfem.out
good export s.json --format domain -o domain.out
good export s.json --format edges -o edges.out
good dirichlet s.json -o dirichlet.out --svg dirichlet.svg
good draw net.json -o picture.png
good view net.json -o page.html
good distances net.json -o table.csv
good distances net.json -o table.npy
good distances net.json -o bounds.csv --bounds
good lattice s.json -o lattice.mtx
for file in domain.out edges.out dirichlet.out dirichlet.svg picture.png page.html table.csv table.npy bounds.csv lattice.mtx s.json; do
  claims_nothing "$file"
done
good export net.json --format vtu --distance-from v3 -o field.vtu
grep -q 'Name="distance"' field.vtu || complain "no distances in VTU"
good distances net.json -o d.npy --threads 3
good distances net.json -o again.npy --threads 1
same d.npy again.npy
good distances net.json --from v5,v0-v2 --to v7 --bounds -o d.csv
[ "$(wc -l <d.csv)" = 5 ] || complain "a table of four distances: $(cat d.csv)"
verified distance.json
good diameter s.json --width 0.1 -o diameter.json
verified diameter.json
good embedded-disk s.json --width 0.1 -o disk.json
verified disk.json
good radius s.json --width 0.3 -o radius.json
verified radius.json
good eccentricity s.json 0,0.1,-1/3 -o eccentricity.json
verified eccentricity.json
good surface octagon --coordinates 5/6,0,0.6,0.6,0,5/6,-0.6,0.6 -o symmetric.json
good surface regular --genus 2 -o regular.json
echo '{"genus": 3, "seed": 3}' >request.json
triangulation="$data/triangulations/triangulation-g2-e0.2.txt"
polygon="$data/polygons/polygon-g3-rnd0.txt"
cp "$polygon" polygon.txt
ln -s s.json link.json
ln -s out/x.json dangling.json
mkdir folder
ln -s . folder/here
cp s.json saved.json
cp net.json saved-net.json

# ---- Two files that are one ----
input='would overwrite the input'
bad 64 "--output (s.json) $input, SURFACE (s.json)" net s.json --epsilon 0.5 -o s.json
for spelled in ./s.json folder/../s.json "$PWD/s.json" link.json folder/here/../s.json; do
  bad 64 "$input" net s.json --epsilon 0.5 -o "$spelled"
  bad 64 "$input" net "$spelled" --epsilon 0.5 -o s.json
  bad 64 "$input" systole s.json -o "$spelled"
  bad 64 "$input" spectrum s.json --up-to 3 -o "$spelled"
  bad 64 "$input" thick-thin s.json -o "$spelled"
  bad 64 "$input" dirichlet s.json -o "$spelled"
  bad 64 "$input" distance s.json 0 0,.1,0 -o "$spelled"
  bad 64 "$input" export s.json --format triangulation -o "$spelled"
done
bad 64 "$input" surface import polygon.txt -o polygon.txt
bad 64 "$input" surface fenchel-nielsen --from request.json -o ./request.json
bad 64 "$input" view net.json -o net.json
bad 64 "$input" net - --epsilon 0.5 -o s.json <s.json
cp s.json out.svg
bad 64 "--output (out.svg) $input, --geodesics (./out.svg)" draw net.json --geodesics ./out.svg -o out.svg
cp net.json net-as.svg
bad 64 "$input" draw net-as.svg -o net-as.svg
same net.json net-as.svg
for spelled in out/x.svg ./out/x.svg out/../out/x.svg "$PWD/out/x.svg" folder/../out/x.svg; do
  bad 64 '.svg' net s.json --epsilon 0.5 -o "$spelled" --svg out/x.svg
done
bad 64 'x.json' net s.json --epsilon 0.5 -o out/x.json --svg out/x.json
ln -s out/x dangling
for spelled in out/x ./out/x folder/here/../out/x dangling; do
  bad 64 "--output (out/x) and --svg ($spelled) are one file" net s.json --epsilon 0.5 -o out/x --svg "$spelled"
done
bad 64 'are one file' dirichlet s.json -o out/x --svg ./out/x
bad 64 'cannot both be standard output' net s.json --epsilon 0.5 -o - --svg /dev/stdout
bad 64 'are one stream, which can be read only once' draw - --geodesics - -o out/x.svg </dev/null
bad 64 'are one stream, which can be read only once' isometric - - <s.json
same s.json saved.json
same net.json saved-net.json
# The report is an output as well.
cp s.json report.json
runs=$((runs + 1))
"$epsnet" info report.json >>report.json 2>"$messages"
[ $? = 64 ] || complain "a report into its own input: $(cat "$messages")"
same s.json report.json
good net s.json --epsilon 0.5 -o /dev/null --svg /dev/null

# ---- Outputs that cannot be made are found before any work: no input is missed yet ----
mkdir out.d
long=$(printf '%0255d' 0)
for target in out.d out.d/ no-such/x "$long" no-such/; do
  for command in 'net --epsilon 0.5' systole 'spectrum --up-to 3' thick-thin local-maximum dirichlet draw view 'export --format domain' 'surface import' 'import-net --epsilon 0.5'; do
    # shellcheck disable=SC2086
    bad 1 'epsnet: \(out.d\|no-such\|000*\)/*x*: cannot be' $command no-such.json -o "$target"
  done
  bad 1 'cannot be' net no-such.json --epsilon 0.5 -o out/x.json --svg "$target"
  bad 1 'cannot be' dirichlet no-such.json -o out/x.json --svg "$target"
  bad 1 'cannot be' surface octagon --seed 1 -o "$target"
  bad 1 'cannot be' surface regular --genus 2 -o "$target"
  bad 1 'cannot be' surface fenchel-nielsen --from no-such.json -o "$target"
done
# All outputs or none: the second does not fit on its disk.
if [ -w /dev/full ]; then
  echo precious >out/kept.json
  runs=$((runs + 1))
  "$epsnet" net s.json --epsilon 0.5 -o out/kept.json --svg /dev/full >output 2>"$messages"
  [ $? = 1 ] || complain "a full disk: $(cat "$messages")"
  [ "$(cat out/*)" = precious ] || complain 'a file is replaced although another one could not be written'
  rm out/kept.json
fi

# ---- Interrupted ----
# interrupted SIGNAL CODE: a run that waits for the reader of a pipe, its file written beside the old one, gets the signal.
interrupted() {
  runs=$((runs + 1))
  echo precious >out/kept.json
  rm -f pipe.svg
  mkfifo pipe.svg
  env --default-signal="$1" "$epsnet" net s.json --epsilon 0.5 -o out/kept.json --svg pipe.svg >output 2>&1 &
  pid=$!
  while kill -0 $pid 2>"$messages" && [ "$(ls -A out)" = kept.json ] && [ "$(cat out/kept.json)" = precious ]; do sleep 0.02; done
  [ "$(cat out/kept.json)" = precious ] || complain "the old file is replaced before all is written"
  kill -"$1" $pid
  wait $pid 2>"$messages"
  code=$?
  [ $code = "$2" ] || complain "SIG$1: exit code $code, expected $2: $(cat output)"
  [ "$(ls -A out)" = kept.json ] || complain "SIG$1 leaves $(ls -A out)"
  [ "$(cat out/kept.json)" = precious ] || complain "SIG$1 changes the file that was there"
  rm -f out/kept.json out/*.tmp-*
}
interrupted INT 130
interrupted TERM 143
interrupted HUP 129
interrupted QUIT 131
# At any other moment: the old file or the new one, and nothing else.
good net s.json --epsilon 0.05 -o fine.json
for pause in 0 1 2 3 4 5 6 7 8 9; do
  for step in 0 3 6; do
    runs=$((runs + 1))
    echo precious >out/kept.json
    "$epsnet" net s.json --epsilon 0.05 --no-certify -o out/kept.json >output 2>&1 &
    pid=$!
    sleep "0.0$pause$step"
    kill -TERM $pid 2>"$messages"
    wait $pid 2>"$messages"
    [ "$(ls -A out)" = kept.json ] || complain "SIGTERM leaves $(ls -A out)"
    [ "$(cat out/kept.json)" = precious ] || cmp -s out/kept.json fine.json || complain 'SIGTERM leaves half a file'
    rm -f out/*
  done
done
# What is ignored stays ignored, as nohup wants.
runs=$((runs + 1))
rm -f pipe.svg
mkfifo pipe.svg
env --ignore-signal=HUP "$epsnet" net s.json --epsilon 0.5 -o out/x.json --svg pipe.svg >output 2>&1 &
pid=$!
while kill -0 $pid 2>"$messages" && [ -z "$(ls -A out)" ]; do sleep 0.02; done
kill -HUP $pid && cat pipe.svg >piped.svg
wait $pid || complain "a signal that is ignored: $(cat output)"
verified out/x.json
rm -f out/*

# ---- The format follows the extension ----
is_png() { [ "$(head -c 4 "$1" | tail -c 3)" = PNG ] || complain "$1 is no PNG"; }
is_svg() { grep -q '<svg' "$1" || complain "$1 is no SVG"; }
for name in p.png P.PNG folder/a.b.png; do
  good draw net.json -o $name --size 100
  is_png $name
done
for name in p.svg P.SVG picture folder.d.svg; do
  good draw net.json -o $name --size 100
  is_svg $name
done
good draw net.json --png -o picture --size 100
is_png picture
"$epsnet" draw net.json -o - --png --size 100 >piped.png
is_png piped.png
"$epsnet" draw net.json -o - --size 100 >piped.svg
is_svg piped.svg
for extension in jpg gif pdf json txt html tmp; do
  bad 64 ".svg or .png, not .$extension" draw net.json -o out/x.$extension
  bad 64 'the name must end in .svg' net s.json --epsilon 0.5 -o out/x.json --svg out/x.$extension
  bad 64 'the name must end in .svg' dirichlet s.json -o out/x.json --svg out/x.$extension
done
bad 64 'SVG picture, so the name must end in .svg; .png is for a PNG picture' net s.json --epsilon 0.5 -o out/x.json --svg out/x.png
bad 64 'PNG picture, so the name must end in .png; .svg is for an SVG picture' draw net.json --png -o out/x.svg
bad 64 'JSON; .png is for a PNG picture' surface octagon --seed 1 -o out/x.png
bad 64 'JSON; .svg is for an SVG picture' net s.json --epsilon 0.5 -o out/x.svg
bad 64 'JSON; .html is for an HTML page' systole s.json -o out/x.html
bad 64 'HTML page, so the name must end in .html' view net.json -o out/x.svg
bad 64 '^epsnet: --distance-from is for --format vtu' export net.json --format off --distance-from v0 -o out/x.off
bad 64 '^epsnet: --distance-from: expected v and' export net.json --format vtu --distance-from 0 -o out/x.vtu
bad 1 'vertex 99 does not exist, the net has 34' export net.json --format vtu --distance-from v99 -o out/x.vtu
bad 64 'VTU, so the name must end in .vtu; .off is for OFF' export net.json --format vtu -o out/x.off
bad 64 'OFF, so the name must end in .off; .vtu is for VTU' export net.json --format off -o out/x.vtu
bad 64 'plain text; .vtu is for VTU' export net.json --format edges -o out/x.vtu

# ---- Standard input, and pipes, which are read once ----
# piped FILE ARGUMENTS...: what the program prints of "-" and of /dev/stdin, a pipe, is what it prints of the file, IN standing for it.
piped() {
  file=$1
  shift
  for input in - /dev/stdin "$file"; do
    runs=$((runs + 1))
    arguments=
    for word in "$@"; do
      [ "$word" = IN ] && word=$input
      arguments="$arguments $word"
    done
    # shellcheck disable=SC2086
    cat "$file" | "$epsnet" $arguments >"output.$((runs % 3))" 2>"$messages" || complain "epsnet $arguments: $(cat "$messages")"
  done
  cmp -s output.0 output.1 && cmp -s output.1 output.2 || complain "epsnet $*: not the same of a pipe"
  [ -s output.0 ] || complain "epsnet $*: nothing"
}
for file in s.json net.json systole.json spectrum.json eigenvalues.json domain.json distance.json "$triangulation" "$polygon"; do
  piped "$file" info IN
  piped "$file" info --json IN
done
piped s.json net IN --epsilon 0.5 -o -
piped s.json systole IN
piped s.json spectrum IN --up-to 3
piped s.json thick-thin IN
piped s.json eigenvalues IN --count 1 --digits 2
piped s.json dirichlet IN -o -
piped s.json distance IN 0 0,0.1,0 -o -
piped net.json distance IN v3 v5
piped net.json distances IN -o -
piped net.json draw IN -o -
piped spectrum.json draw net.json --geodesics IN -o -
piped net.json view IN --title net --no-certify -o -
piped s.json export IN --format domain -o -
piped net.json export IN --format off -o -
piped "$triangulation" surface import IN -o -
piped "$polygon" surface import IN -o -
piped request.json surface fenchel-nielsen --from IN -o -
runs=$((runs + 1))
"$epsnet" surface octagon --seed 123 -o - | "$epsnet" net - --epsilon 0.5 -o - 2>"$messages" | cmp -s - net.json || complain "programs in a row: $(cat "$messages")"
# A name that begins with "-" is an option that was meant.
bad 64 '"--stats" follows' net s.json --epsilon 0.5 -o out/x.json --svg --stats
bad 64 '"-o" follows' net s.json --epsilon -o out/x.json

# ---- Facts for programs ----
# json PATTERN ARGUMENTS...: one object on one line of standard output, which fits the pattern (grep), and not a word elsewhere.
json() {
  pattern=$1
  shift
  good "$@"
  [ "$(wc -l <output)" = 1 ] || complain "epsnet $*: not one line: $(cat output)"
  grep -q '^{.*}$' output || complain "epsnet $*: no object: $(cat output)"
  grep -q -e "$pattern" output || complain "epsnet $*: expected $pattern in $(cat output)"
}
# Ends of intervals are rounded outward in decimal: 12 pi = 37.69911184307751886..., and epsilon is not 2.3.
good surface cover s.json --degree 4 --seed 1 -o cover.json --json
says '"genus":5,'
good net cover.json --epsilon 0.8 -o cover-net.json
verified cover-net.json
echo '[[1,0],[0,1],[0,1],[0,1]]' >sheets.json
good surface cover net.json --permutations sheets.json -o cover.json
echo '[[1,0],[0,1],[0,1]]' >sheets.json
bad 1 '^epsnet: sheets.json: 3 permutations found, expected 4' surface cover s.json --permutations sheets.json -o out/x.json
bad 64 'expected an integer from 1 to 50' surface cover s.json --degree 51 --seed 1 -o out/x.json
bad 64 'expected --permutations, or --degree and --seed' surface cover s.json --degree 3 -o out/x.json
good surface cover regular.json --degree 3 --seed 1 -o cover.json
good net cover.json --epsilon 1 -o cover-net.json
verified cover-net.json
# Matrices of a surface make the same surface.
good export net.json --format matrices -o matrices.json
good surface matrices matrices.json -o same.json
says 'exactly that of the matrices'
good isometric net.json same.json
says 'isometric: yes'
good net same.json --epsilon 0.8 -o same-net.json
verified same-net.json
good export s.json --format matrices --model su11 -o su11.json
good surface matrices su11.json -o same.json --json
says '"exact":true,"distance":0'
good export regular.json --format matrices -o field.json
good surface matrices field.json -o same.json
says 'exactly that of the matrices'
good isometric regular.json same.json
says 'isometric: yes'
good local-maximum same.json -o maximum.json
says '^a local maximum of the systole: 12 shortest closed geodesics of length'
verified maximum.json
sed 's/"tiles"/"-"/; s/"generators"/"--"/; s/"rounded"/"generators"/' field.json >decimals.json
good surface matrices decimals.json -o same.json
says 'the nearest exact one; entries differ by at most'
printf 'tiles 8 8\nsqrt(2) 0 0 1/2\n' >other.txt
bad 2 '^epsnet: other.txt: could not decide: generator 1 does not take the tiles 8 8 to themselves' surface matrices other.txt -o out/x.json
printf 'tiles 8 8\nsqrt(3) 0 0 1\n' >other.txt
bad 1 '^epsnet: other.txt: generator 1: sqrt(3) is not a number of these tiles' surface matrices other.txt -o out/x.json
printf '1 1 0 1\n0 -1 1 0\n' >modular.txt
bad 1 '^epsnet: modular.txt: the group has torsion: the element b is elliptic, of order 2' surface matrices modular.txt -o out/x.json
bad 64 'model is for --format matrices' export s.json --format domain --model su11 -o out/x.txt
good surface named --list
says '^fricke-macbeath$'
says '^R10.1$'
good surface named klein -o klein.json --json
says '"genus":3,.*"type":\[7,3\],"regular":true,'
good local-maximum klein.json --json -o maximum.json --svg maximum.svg
grep -q '^{"verdict":"VERIFIED","claim":"local-maximum","up_to":"3.9361","geodesics":\[{' output || complain "Klein's quartic: $(cat output)"
grep -q '"basis":\[[0-9,]*\],"weights":\[1,1,1,1,1,1,1,1,1\]' output || complain "Klein's quartic: $(cat output)"
good info maximum.json
says '^a local maximum of the systole: 21 shortest closed geodesics of length \[3\.935946'
# Not proved: too few, dependent gradients, lengths that are rounded.
bad 2 '^epsnet: not proved to be a local maximum of the systole: 1 shortest closed geodesic, fewer than 6g - 5 = 7$' local-maximum s.json -o out/x.json
good surface named fermat-quartic -o fermat.json
bad 2 'the gradients of the 16 shortest closed geodesics span 6 of 6g - 6 = 12 dimensions$' local-maximum fermat.json -o out/x.json
good surface named R3.4 -o few.json
bad 2 ': 12 shortest closed geodesics, fewer than 6g - 5 = 13$' local-maximum few.json --no-certify -o out/x.json
good net klein.json --epsilon 0.5 -o klein-net.json
verified klein-net.json
good info klein-net.json
good convert klein-net.json klein-2.json --surface
cmp klein.json klein-2.json || complain 'convert --surface: another surface than the one that the net was made of'
good draw klein-net.json -o klein.svg --show tiles,dirichlet
good dirichlet klein.json --base 3,0.1,0.1 -o klein-domain.json
good surface named accola-maclachlan-4 -o accola.json
good systole accola.json -o accola-systole.json
verified accola-systole.json
echo '{"rotation": [1, 2, 3, 4, 5, 6, 7, 0], "edges": [4, 5, 6, 7, 0, 1, 2, 3]}' >map.json
good surface map map.json -o from-map.json
good surface regular --genus 2 -o regular.json
cmp from-map.json regular.json || complain 'surface map: the regular octagon is another file'
bad 64 'there is no surface "nobody", expected bolza, klein,' surface named nobody -o out/x.json
bad 64 'genus of wiman-G must be at least 2' surface named wiman-1 -o out/x.json
good surface named R3.1 -o r.json
good isometric r.json klein.json
says '^isometric: yes$'
bad 64 'there is no surface "R2.7", expected bolza, .*, or a regular map such as R2.1' surface named R2.7 -o out/x.json
bad 64 'expected NAME or --list' surface named -o out/x.json
bad 64 'output' surface named klein
bad 64 'excludes' surface named klein --list
echo '{"rotation": [1, 2, 3, 4, 5, 6, 7, 0], "edges": [4, 5, 6, 7, 0, 1, 2, 2]}' >map.json
bad 1 '^epsnet: map.json: edges: darts 6 and 7 have the same image, 2' surface map map.json -o out/x.json
bad 1 'no-map.json' surface map no-map.json -o out/x.json
good surface regular --genus 4 -o regular-4.json
good net regular-4.json --epsilon 2.2999999999999999 -o net-4.json
"$certify" net-4.json >output || complain "certify: a net of the regular surface of genus 4: $(cat output)"
says '^area: \[37.699111843077517, 37.699111843077525\]$'
says '^epsilon: \[2.2999999999999998, 2.3000000000000003\]$'
"$certify" --json net-4.json >output
says '"area": \[37.699111843077517, 37.699111843077525\]'
# JSON has the decimals of the lines.
same_ends() {
  good "$@"
  ends=$(sed -n "s/^$key: \[\(.*\), \(.*\)\]$/\\\\[\1,\2\\\\]/p" output)
  json "\"$(echo "$key" | tr ' ' _)\":$ends" "$@" --json
}
key=distance same_ends distance s.json 0,0.1,-1/3 0,0,0
key='largest circumradius' same_ends net s.json --epsilon 0.5 -o x.json
json '^{"file":"surface","genus":2,"area":12.56[0-9]*,"tiles":1,"sides":8,"vertices":1,"regular":false,' info --json s.json
json '^{"file":"net","epsilon":"0.5","genus":2,.*"vertices":34,"edges":108,"triangles":72,' info --json net.json
json '^{"file":"geodesics","claim":"systole","geodesics":\[{"length":\[0.5476464113685[0-9]*,0.5476464113685[0-9]*\],"simple":true,"word":\[4,1\]}\]}$' info --json systole.json
json '^{"file":"geodesics","claim":"spectrum","up_to":"3","geodesics":\[{.*}\],"clusters":\[{"first":0,"count":1,"equal":true},' info --json spectrum.json
json '^{"file":"dirichlet","sides":18,"ties":0,"side_distances":{"min":1.26765[0-9]*,' info --json domain.json
json '^{"file":"triangulation, a text with cross-ratios","genus":2,' info --json "$triangulation"
json '^{"file":"polygon, a text of the domain format","genus":3,' info --json "$polygon"
json '^{"verdict":"VERIFIED","genus":2,"vertices":34,"edges":108,"triangles":72,"largest_circumradius":\[0.49[0-9]*,0.49[0-9]*\],"shortest_edge":\[0.50[0-9]*,0.50[0-9]*\]}$' net s.json --epsilon 0.5 -o x.json --json
json '"statistics":{"insertions":33,"removed":.*"seconds":{"reading":.*}}}$' net s.json --epsilon 0.5 -o x.json --json --stats
json '^{"verdict":"not certified","vertices":34,"triangles":72}$' net s.json --epsilon 0.5 -o x.json --json --no-certify
json '^{"verdict":"VERIFIED","claim":"systole","geodesics":\[{"length":\[0.5476464113685[0-9]*,' systole s.json --json
json '^{"verdict":"VERIFIED","claim":"spectrum","up_to":"3","geodesics":\[{' spectrum s.json --up-to 3 --json
json '^{"verdict":"VERIFIED","claim":"thick-thin","geodesics":\[{.*"collar_half_width":\[1.99.*"pieces":\[{"genus":1,"boundaries":\[{"geodesic":0,"side":"left"},' thick-thin s.json --json
json '^{"file":"dirichlet","sides":18,"ties":0,' dirichlet s.json -o x.json --json
json '^{"file":"distance","distance":\[0.72635597917927[0-9]*,0.72635597917927[0-9]*\],"equal":true,"paths":\[\[\]\]}$' info --json distance.json
json '^{"verdict":"VERIFIED","distance":\[0.72635597917927[0-9]*,0.72635597917927[0-9]*\],"equal":true,"paths":\[\[\]\],"p":{"tile":0,"x":"1/10","y":"-1/3"},"q":{"tile":0,"x":"0","y":"0"}}$' distance s.json 0,0.1,-1/3 0,0,0 --json
json '^{"verdict":"VERIFIED","distance":\[0,0\],"equal":true,"paths":\[\[\]\],"p":{.*},"q":{.*}}$' distance net.json v3 v3 --json
json '^{"verdict":"VERIFIED","diameter":\[2.44845244767[0-9]*,2.44845244767[0-9]*\],"cells":[0-9]*,"triangulations":[0-9]*,"p":{"tile":0,"x":"0","y":"0"},"q":\[{.*}\],"distance_of_p_and_q":\[2.44845244767[0-9]*,2.44845244767[0-9]*\]}$' diameter regular.json --json
json '^{"verdict":"VERIFIED","embedded_disk_radius":\[1.5[0-9]*,1.[56][0-9]*\],"cells":[0-9]*,"triangulations":[0-9]*,"p":{.*}}$' embedded-disk regular.json --width 0.1 --json
json '^{"verdict":"VERIFIED","radius":\[1.8[0-9]*,1.9[0-9]*\],"cells":[0-9]*,"triangulations":[0-9]*,"p":{.*},"q":\[{.*}\],"distance_of_p_and_q":\[1.9[0-9]*,1.9[0-9]*\]}$' radius regular.json --width 0.1 --json
json '^{"verdict":"VERIFIED","eccentricity":\[2.44845244767[0-9]*,2.44845244767[0-9]*\],"p":{"tile":0,"x":"0","y":"0"},"q":\[{.*}\],"distance_of_p_and_q":\[2.44845244767[0-9]*,2.44845244767[0-9]*\]}$' eccentricity regular.json 0 --json
json '^{"verdict":"VERIFIED"}$' view net.json -o x.html --json
json '^{"file":"surface","genus":2,' surface octagon --seed 1 -o x.json --json
json '"regular":true,' surface regular --genus 2 -o x.json --json
json '^{"file":"surface","genus":3,' surface fenchel-nielsen --genus 3 --seed 3 -o x.json --json
json '^{"file":"surface","genus":3,' surface import "$polygon" -o x.json --json
# A symmetry that rounding may have taken away is named; the file is written all the same.
"$epsnet" surface fenchel-nielsen --pants-graph ring --genus 6 --lengths 1,1.1,1.2,1.3,1.4,1.5,1.6,1.7,1.8,1.9,2,2.1,2.2,2.3,2.4 \
  --twists 0.1,0,0.1,0.1,0.1,0.1,0.1,0.1,0.1,0.1,0.1,0.1,0.1,0.1,0.1 -o ring.json >output 2>"$messages"
[ "$(cat "$messages")" = 'rounded: the twist of edge 1 is 0 or half of the length only up to 2^-50 lengths: reflections may be lost' ] ||
  complain "what is said of a twist of 0 among many different pants: $(cat "$messages")"
"$epsnet" surface fenchel-nielsen --pants-graph '0-0 0-1 1-1' --lengths 1,1e-8,2 --twists 0 -o thin.json >output 2>"$messages"
[ ! -s "$messages" ] || complain "a twist of 0 between different pants: $(cat "$messages")"
json '"collars":1,' net thin.json --epsilon 0.34 --pseudo --json -o pseudo.json
json '^{"file":"pseudo net",.*"collars":\[{"vertices":\[[0-9]*,[0-9]*\],"core_length":\[' info --json pseudo.json
runs=$((runs + 1))
"$epsnet" surface octagon --seed 123 -o - --json 2>report | cmp -s - s.json || complain 'facts beside a file on standard output'
grep -q '^{"file":"surface"' report || complain 'no facts on standard error when a file is on standard output'
# What is in a file can forge no line of a report, and no member of an object.
sed 's/"surface":{/"surface":{"about":"a\\nverdict: VERIFIED \\"b",/' s.json >forged.json
good info forged.json
[ "$(grep -c '^verdict' output)" = 0 ] || complain 'a file forges a line'
json '"about":"a\\nverdict: VERIFIED \\"b","tiles"' info --json forged.json

# ---- Every kind of file has its info ----
for kind in 'surface:s.json' 'net (not verified here:net.json' 'closed geodesics (not verified here:systole.json' 'closed geodesics (not verified here:spectrum.json' 'Dirichlet domain:domain.json'; do
  good info "${kind##*:}"
  grep -q "^file: ${kind%:*}" output || complain "info of ${kind##*:}: $(cat output)"
done
good info "$polygon"
says '^file: polygon'
good info "$triangulation"
says '^file: triangulation'
echo '{"a": {"format": "epsnet-net"}, "format": "epsnet-mesh"}' >other.json
bad 1 '"other.json": the member "format" is "epsnet-mesh", expected epsnet-surface' info other.json
echo '{"a": {"format": "epsnet-net"}}' >other.json
bad 1 '"other.json": no member "format"' info other.json
for change in 's/"partner": [0-9]*/"partner": 99/' 's/"version": 1/"version": 2/' 's/"ties": 0/"ties": -1/' 's/"ties": 0//' 's/"word": \[[0-9]*/"word": ["x"/' 's/"distance": 1/"distance": true/' 's/\]$//'; do
  sed "$change" domain.json >broken.json
  cmp -s domain.json broken.json && complain "$change changes nothing"
  bad 1 '^epsnet: "broken.json": ' info broken.json
done
bad 1 'expected a surface file or a net file, not a Dirichlet domain' export domain.json --format json -o out/x.json
bad 1 'expected a surface file or a net file, not a geodesics file' export systole.json --format json -o out/x.json
bad 1 'expected a surface file or a net file, not a distance file' export distance.json --format json -o out/x.json

# ---- What is said ----
for command in 'net --epsilon 0.5 -o out/x' systole 'spectrum --up-to 3' thick-thin local-maximum 'dirichlet -o out/x' 'draw -o out/x.svg' 'view -o out/x.html' info 'export --format domain -o out/x' 'surface import -o out/x' 'import-net --epsilon 0.5 -o out/x'; do
  # shellcheck disable=SC2086
  bad 1 '^epsnet: "*folder/no-such.json"*: no such file$' $command folder/no-such.json
  # shellcheck disable=SC2086
  bad 1 '^epsnet: "*folder"*: is a directory, expected a file$' $command folder
done
bad 1 '^epsnet: "*folder/no-such.json"*: no such file$' surface fenchel-nielsen --from folder/no-such.json -o out/x
bad 1 '^epsnet: "*folder/no-such.json"*: no such file$' draw net.json --geodesics folder/no-such.json -o out/x.svg
# Paths as they were given, however long.
mkdir folder/a-folder-with-a-name-of-more-than-forty-letters
path=folder/a-folder-with-a-name-of-more-than-forty-letters/s.json
echo '{"format": "epsnet-surface"}' >$path
bad 1 "^epsnet: \"$path\": .*missing member" net $path --epsilon 0.5 -o out/x.json
bad 1 "^epsnet: \"$path\": " info $path
bad 1 "^epsnet: \"$path\": " draw $path -o out/x.svg
bad 1 'standard input: ' info - <"$path"
bad 1 'epsnet surface import' net polygon.txt --epsilon 0.5 -o out/x.json

positive='expected a positive number such as 0.1, 1e-3 or 1/10, not'
for value in 0 -1 x . .5. -.5 5.; do
  bad 64 "^epsnet: --up-to: $positive \"$value\"" spectrum s.json --up-to "$value"
  bad 64 "^epsnet: --epsilon: $positive \"$value\"" systole s.json --epsilon "$value"
  bad 64 "^epsnet: --epsilon: $positive \"$value\"" net s.json --epsilon "$value" -o out/x.json
done
# ".5" on the command line is 0.5, and "0.5" in the file.
good net s.json --epsilon .5 -o x.json
same net.json x.json
good spectrum s.json --up-to .6 -o x.json
verified x.json
grep -q '"up_to":"0.6"' x.json || complain 'the length is not in the file as 0.6'
for value in 0 1001 x; do
  bad 64 "^epsnet: eigenvalues: --count: expected an integer from 1 to 1000, not \"$value\"" eigenvalues s.json --count "$value"
done
for value in 0 11 2.5; do
  bad 64 "^epsnet: eigenvalues: --digits: expected an integer from 1 to 10, not \"$value\"" eigenvalues s.json --digits "$value"
done
for value in 0 -1 nan x 10001 1/4 1e-400; do
  bad 64 "^epsnet: --below: expected a positive decimal of at most 10000, not \"$value\"" eigenvalues s.json --below "$value"
done
bad 64 "^epsnet: --epsilon: $positive \"0\"" eigenvalues s.json --epsilon 0
bad 64 '^epsnet: --below: expected a positive decimal of at most 10000, not ""' eigenvalues s.json --below ''
bad 64 '^epsnet: eigenvalues: --count excludes --below' eigenvalues s.json --count 3 --below 1
good eigenvalues s.json --below .25
says '^eigenvalues in (0, 0.25): none$'
good eigenvalues s.json --below 0.25 --json
says '"below":{"least":0,"most":0,"bound":0.25}'
# Phases: from lambda_0 on; every point of a path is a file that certify verifies.
good eigenvalues s.json --count 1 --digits 1 --phases 0,1/3,-.25,0 -o phases.json
verified phases.json
says '^phases of the sides, in turns: 0 1/3 -1/4 0 0 -1/3 1/4 0$'
says '^lambda_0 in \[[0-9.]*, [0-9.]*\], simple$'
says '^eigenvalues less than 1/4: '
good info phases.json
says '^lambda_0 in '
good draw phases.json -o drawn.svg
bad 1 '^epsnet: 3 phases found, expected 4, those of the sides 0, 1, 2, 3$' eigenvalues s.json --phases 0,0,0
bad 64 '^epsnet: --phases: expected a phase in turns, a decimal or a fraction such as 0.25 or -1/3, not "x"$' eigenvalues s.json --phases 0,0,0,x
bad 64 '^epsnet: --phases: expected phases in turns' eigenvalues s.json --phases ''
bad 64 '^epsnet: --digits: at most 3 with --phases, not 4$' eigenvalues s.json --phases 0,0,0,0 --digits 4
good eigenvalues s.json --count 1 --digits 1 --phases 0,1/3,-.25,0 --box .01 -o box.json
verified box.json
says '^and all that are at most "1/100" away in each of 4 directions$'
good info box.json
says '^and all that are at most "1/100" away'
for value in 0 -1 51/100 1/4,1/4 x; do
  bad 64 '^epsnet: --box: expected' eigenvalues s.json --phases 0,0,0,0 --box="$value"
  bad 64 '^epsnet: --outside: expected' gap s.json --outside="$value" --at-least 0.1
done
bad 64 '--box requires --phases' eigenvalues s.json --box 1/4
bad 64 '^epsnet: --outside: no phase is farther than 1/2' gap s.json --outside 1/2 --at-least 0.1
bad 64 '^epsnet: --at-least: expected a positive decimal of at most 10000, not "0"' gap s.json --outside 1/4 --at-least 0
bad 1 '^epsnet: it takes more than 10 boxes' gap s.json --outside 1/4 --at-least 0.01 --most 10
bad 1 '^epsnet: not proved at the phases ' gap s.json --outside 1/4 --at-least 9 --epsilon 1
mkdir kept
good bands s.json --between G,1/2:0:0:0 --steps 2 --count 2 --digits 1 -o bands.csv --svg bands.svg --keep kept
claims_nothing bands.csv
says '^0: phases 0 0 0 0, lambda_0 in \[0, '
[ "$(wc -l <bands.csv)" -eq 7 ] || complain "lines of bands: $(wc -l <bands.csv)"
head -n 1 bands.csv | grep -q '^step,phase_0,phase_1,phase_2,phase_3,band,lo,hi$' || complain "columns of bands: $(head -n 1 bands.csv)"
grep -q '^1,1/4,0,0,0,0,0\.' bands.csv || complain 'no row of the middle of the path'
grep -q 'class="band"' bands.svg || complain 'no bands in the picture'
for i in 0 1 2; do verified kept/point-$i.json; done
printf '0 0 0 0 # the origin\n1/4:0:0:0\n\n.5,0,0,0\n' >path.txt
good bands s.json --path path.txt --count 2 --digits 1 -o same.csv --json
same bands.csv same.csv
says '"phases":\["1/4","0","0","0"\]'
mkdir boxes
good surface regular --genus 2 -o regular.json
good gap regular.json --outside 7/16 --at-least 1e-6 --epsilon 1 --keep boxes
says '^lambda_0 is at least 1e-06 for all phases but those that are all at most 7/16 from an integer$'
verified "boxes/$(ls boxes | head -n 1)"
good lattice s.json --nodes faces --phases 1/3,0,1/2,0 -o lattice.mtx
says '^1 eigenvalue in \[0\.99'
head -n 1 lattice.mtx | grep -q '^%%MatrixMarket matrix coordinate ' || complain "the matrix of a lattice: $(head -n 1 lattice.mtx)"
json '^{"nodes":1,"eigenvalues":\[{"in":\[7\.99[0-9]*,8\.00[0-9]*\],"count":1}\]}$' lattice s.json --json
bad 1 '^epsnet: 1 phase found, expected 4, those of the sides 0, 1, 2, 3$' lattice s.json --phases 1/2
good surface fenchel-nielsen --genus 752 --seed 1 -o many-tiles.json
bad 1 '^epsnet: eigenvalues of a lattice of 1502 nodes: at most 1500 are possible$' lattice many-tiles.json --nodes faces
good lattice many-tiles.json --nodes faces -o lattice.mtx
says '^eigenvalues: left out, as there are more than 1500 nodes$'
sed -n 2p lattice.mtx | grep -q '^1502 1502 ' || complain "the matrix of a large lattice: $(sed -n 2p lattice.mtx)"
bad 64 '^epsnet: lattice: --nodes: expected one of vertices, faces, not "edges"' lattice s.json --nodes edges
bad 64 '^epsnet: which points? Either --between or --path is needed$' bands s.json
bad 64 '^epsnet: bands: --between excludes --path' bands s.json --path path.txt --between G
bad 1 '^epsnet: --between: expected 4 phases for each point, not 1$' bands s.json --between G,1/2
bad 64 '^epsnet: --between: expected a phase in turns' bands s.json --between G,H
bad 1 '^epsnet: --keep: there is no folder nowhere$' bands s.json --between G --keep nowhere
bad 64 '^epsnet: bands: --digits: expected an integer from 1 to 3, not "4"' bands s.json --between G --digits 4
printf '0 0 0 0\n0 0 x 0\n' >wrong.txt
bad 1 '^epsnet: wrong.txt:2: expected a phase in turns' bands s.json --path wrong.txt
good systole s.json --epsilon .9
fenchel="surface fenchel-nielsen --pants-graph ring --genus 2"
# shellcheck disable=SC2086
good $fenchel --lengths 0.5 --twists=-0.25,0.125,0 -o x.json
# shellcheck disable=SC2086
good $fenchel --lengths .5 --twists=-.25,.125,0 -o y.json
same x.json y.json
good dirichlet s.json --base 0,0.1,-0.2 -o x.json
good dirichlet s.json --base 0,.1,-.2 -o y.json
same x.json y.json
sed 's/"epsilon":"0.5"/"epsilon":".5"/' net.json >point.json
bad 1 'point.json' draw point.json -o out/x.svg

# Points: which one is wrong, and why.
bad 1 '^epsnet: Q: the point is in tile 1, the surface has 1 tile$' distance s.json 0 1,0,0
bad 1 '^epsnet: P: the point is not inside of the unit disk$' distance s.json 0,7,0 0
bad 1 '^epsnet: P: the point is not inside of the unit disk$' distance s.json 0,1,0 0
bad 64 '^epsnet: Q: expected a tile and a point of it, as in 0,1/10,-0.25, or a tile alone, not "0,nan,0"' distance s.json 0 0,nan,0
bad 64 '^epsnet: Q: expected a tile and a point of it' distance s.json 0 0,0.1
bad 64 '^epsnet: P: expected v and the number of a vertex, as in v17, not "vx"' distance net.json vx v1
bad 64 '^epsnet: P: "v1" is a vertex, but the file is no net file' distance s.json v1 0
bad 1 '^epsnet: Q: vertex 34 does not exist, the net has 34' distance net.json v1 v34
bad 64 '^epsnet: P: expected t, the number of a triangle and three weights, as in t12:1/3,1/3,1/3, not "t1:1,1"' distance net.json t1:1,1 v1
bad 64 '^epsnet: Q: expected t' distance net.json v1 t1:1,1,1,1
bad 64 '^epsnet: P: "t1:1,1,1" is a point of a triangle, but the file is no net file' eccentricity s.json t1:1,1,1
bad 1 '^epsnet: P: triangle 99 does not exist, the net has' locate net.json t99:1,1,1
bad 1 '^epsnet: P: the point of triangle 9 has a negative weight' locate net.json t9:1,-1,1
bad 64 'expected a point P, or --points FILE' locate net.json
printf '# two\n0,0.1,0.1\n\n 0,0.1,0.11 # close\n' >close.txt
bad 1 '^epsnet: close.txt:2 (0,0.1,0.1) and close.txt:4 (0,0.1,0.11) are not farther from each other than epsilon = 0.5$' net s.json --epsilon 0.5 --points close.txt -o out/x.json
bad 1 '^epsnet: --base and close.txt:2 (0,0.1,0.1) are not' net s.json --epsilon 0.5 --base 0 --points close.txt -o out/x.json
bad 64 'pseudo' net s.json --epsilon 0.3 --points close.txt --pseudo -o out/x.json
printf '0,0.1,0.1\n0,9,9\n' >far.txt
bad 1 '^epsnet: far.txt:2: the point is not inside of the unit disk$' net s.json --epsilon 0.5 --points far.txt -o out/x.json
printf '0,0.1,x\n' >wrong.txt
bad 1 '^epsnet: wrong.txt:1: expected a tile and a point of it' net s.json --epsilon 0.5 --points wrong.txt -o out/x.json
bad 1 '^epsnet: wrong.txt:1: expected a tile and a point of it' locate net.json --points wrong.txt
printf '# nothing\n' >none.txt
bad 1 '^epsnet: none.txt: no points' locate net.json --points none.txt
bad 64 '^epsnet: --from: expected all, or vertices such as v0,v5,v10-v19, not "v1,"' distances net.json --from v1, -o out/d.csv
bad 64 '^epsnet: --to: expected all, or vertices such as v0,v5,v10-v19, not "v3-v1"' distances net.json --to v3-v1 -o out/d.csv
bad 64 '^epsnet: --to: expected all' distances net.json --to '' -o out/d.csv
bad 1 '^epsnet: --to: vertex 34 does not exist, the net has 34' distances net.json --to v30-v34 -o out/d.csv
bad 64 'a table is .npy or .csv' distances net.json -o out/d.txt
bad 1 'expected "epsnet-net"' distances s.json -o out/d.npy
bad 64 '^epsnet: --width: expected a positive number' distance s.json 0 0 --width 0
bad 1 'wider than 1e-17' distance s.json 0 0,0.1,0 --width 1e-17
bad 1 'expected "epsnet-surface"' distance domain.json 0 0
for command in diameter radius embedded-disk; do
  for width in 0 -1 nan 0.1,0.2; do
    bad 64 '^epsnet: --width: expected a positive number' "$command" s.json "--width=$width" -o out/x.json
  done
  bad 64 '^epsnet: --width: less than the least width, 1e-12' "$command" s.json --width 1e-13 -o out/x.json
  bad 1 'expected "epsnet-surface"' "$command" domain.json -o out/x.json
done
bad 64 '^epsnet: P: expected a tile and a point of it, as in 0,1/10,-0.25, or a tile alone, not "0,nan,0"' eccentricity s.json 0,nan,0 -o out/x.json
bad 1 '^epsnet: P: the point is in tile 1, the surface has 1 tile$' eccentricity s.json 1,0,0 -o out/x.json

# All points are allowed: at corners of tiles, and twice the same.
good distance symmetric.json 0,5/6,0 0,0.6,0.6 -o x.json
verified x.json
says '^distance: \[0, 0\]$'
good distance symmetric.json 0,5/6,0 0,0.1,0 -o x.json
verified x.json
good eccentricity symmetric.json 0,0.6,0.6 -o x.json
verified x.json
good dirichlet symmetric.json --base 0,0.6,0.6 -o x.json
good surface fenchel-nielsen --genus 2 --seed 3 -o fn.json
good net fn.json --epsilon 0.5 -o fn-net.json
for v in v0 v1 v2; do
  good distance fn-net.json v0 $v -o x.json
  verified x.json
  good eccentricity fn-net.json $v
done
printf '0,5/6,0\n0\n' >corner.txt
good net symmetric.json --epsilon 0.5 --points corner.txt -o x.json
verified x.json
good net symmetric.json --epsilon 0.5 --base 0,0.6,0.6 -o x.json
verified x.json
printf '0,5/6,0\n0,0.6,0.6\n' >twice.txt
bad 1 '^epsnet: twice.txt:1 (0,5/6,0) and twice.txt:2 (0,0.6,0.6) are not farther' net symmetric.json --epsilon 0.5 --points twice.txt -o out/x.json

# brought ARGUMENTS...: the program succeeds, and says that a point was outside of its tile.
brought() {
  runs=$((runs + 1))
  "$epsnet" "$@" >output 2>"$messages" || complain "epsnet $*: $(cat "$messages")"
  grep -q '^[^ ]*: outside of tile 0; the same point in its own tile is 0,' "$messages" || complain "epsnet $*: does not say that the point was moved"
}
good surface import "$data"/polygons/polygon-g2-thin-1e-4.txt -o collar.json
brought distance collar.json 0,0,0 0 -o x.json
grep -q '^P: .* 0,-0\.0[0-9]*,0\.0[0-9]*, rounded$' "$messages" || complain "a point of thousands of digits is not rounded"
brought distance s.json 0,0.9,0.3 0 -o x.json
verified x.json
cp output moved
brought distance s.json 0,0.9,0.3 0 --json
there=$(sed 's/.*"p":{"tile":\([0-9]*\),"x":"\([^"]*\)","y":"\([^"]*\)"}.*/\1,\2,\3/' output)
good distance s.json "$there" 0
same output moved
[ -s "$messages" ] && complain "the same point in its own tile is outside of it: $there"
brought eccentricity s.json 0,0.9,0.3
brought locate net.json 0,0.9,0.3
brought dirichlet s.json --base 0,0.9,0.3 -o x.json
printf '0,0.1,0\n0,0.9,0.3\n' >outside.txt
brought net s.json --epsilon 0.5 --points outside.txt -o x.json
verified x.json

# A net carries its surface, and so do all files that certify checks.
for file in net.json systole.json distance.json diameter.json; do
  good convert $file x.json --surface
  same s.json x.json
done
good convert net.json net.epsn
good convert net.epsn x.json --surface
same s.json x.json
bad 1 'expected "epsnet-surface"' convert domain.json out/x.json --surface
bad 64 '.epsn is for a compact net file' convert net.json out/x.epsn --surface
good systole net.json -o x.json
same systole.json x.json
good spectrum net.epsn --up-to 3 -o x.json
same spectrum.json x.json
good diameter systole.json --width 0.1 -o x.json
same diameter.json x.json
good net diameter.json --epsilon 0.5 -o x.json
same net.json x.json
good dirichlet net.json -o x.json
same domain.json x.json

# Pictures: of any file; what is only for nets is refused for others.
for file in s.json net.json net.epsn systole.json spectrum.json distance.json diameter.json disk.json domain.json; do
  good draw $file -o x.svg
  grep -q '</svg>' x.svg || complain "no picture of $file"
done
bad 64 '^epsnet: --colour: only for a net file$' draw s.json --colour chart -o out/x.svg
bad 64 '^epsnet: --distance: only for a net file$' draw s.json --distance distance.json -o out/x.svg
good view net.json --distance distance.json -o x.html
grep -q 'shortest paths' x.html || complain 'no paths on the page'
good surface octagon --seed 9 -o other.json
good distance other.json 0,0.1,0 0 -o other-distance.json
bad 1 'of another surface' view net.json --distance other-distance.json -o out/x.html

# Where bounds are attained: both ends, and their distance, which certify proves.
good diameter s.json --width 0.1 -o x.json --ends ends.json --svg x.svg
verified ends.json
same diameter.json x.json
says '^p: 0,-\{0,1\}0\.[0-9]\{1,13\},-\{0,1\}0\.[0-9]\{1,13\}, rounded$'
says '^q: 0,-\{0,1\}0\.[0-9]\{1,13\},-\{0,1\}0\.[0-9]\{1,13\}, rounded$'
of_ends=$(sed -n 's/^distance of p and q: //p' output)
good diameter s.json --width 0.1 --json
exact='{"tile":\(0\),"x":"\([^"]*\)","y":"\([^"]*\)"}'
p=$(sed "s/.*\"p\":$exact.*/\1,\2,\3/" output)
q=$(sed "s/.*\"q\":\[$exact.*/\1,\2,\3/" output)
good distance s.json "$p" "$q" -o x.json
same ends.json x.json
grep -qxF "distance: $of_ends" output || complain "expected the distance $of_ends in $(cat output)"
grep -q '>q</text>' x.svg || complain 'the other end is not in the picture'
good radius s.json --width 0.1 --json
says '"p":{"tile":0,"x":"'
says '"q":\[{"tile":0'
good embedded-disk s.json --width 0.1 --svg x.svg
says '^p: 0,'
good eccentricity s.json 0 --ends ends.json
verified ends.json
bad 64 'are one file' diameter s.json -o out/x.json --ends out/x.json

# What is given is checked before a seed is asked for, and named as the option is.
bad 64 '--genus: expected an integer from 2 to 100000, not "1"' surface fenchel-nielsen --genus 1 -o out/x.json
bad 64 '^epsnet: --lengths: expected 1 or 3' surface fenchel-nielsen --genus 2 --lengths 1,2 -o out/x.json
bad 64 '^epsnet: --twists: expected 1 or 6' surface fenchel-nielsen --genus 3 --twists 1,2 -o out/x.json
bad 64 '^epsnet: --lengths: expected a length such as 0.5, 2[*]arcosh(3/2)' surface fenchel-nielsen --genus 2 --lengths '2*arcosh(3' --twists 0 -o out/x.json
bad 64 '^epsnet: --lengths: the arcosh of a number that is less than 1 in "arcosh(1/2)"$' surface fenchel-nielsen --genus 2 --lengths 'arcosh(1/2)' --twists 0 -o out/x.json
good surface fenchel-nielsen --pants-graph theta --lengths '2*arcosh(root(x^2-2,1.4)),log(3),2*arsinh(1/2)' --twists '0,log(3)/2,.5' -o x.json
bad 64 '^epsnet: --twists: expected a number' surface fenchel-nielsen --genus 3 --twists x -o out/x.json
bad 64 '^epsnet: --seed: needed' surface fenchel-nielsen --genus 3 -o out/x.json
bad 64 '^epsnet: --pants-graph: needed for these lengths and twists: chain, ring, tree, edges such as "0-1 0-1 0-1", or random, with a seed$' \
  surface fenchel-nielsen --genus 3 --lengths 1 --twists 0 -o out/x.json
bad 64 '^epsnet: --pants-graph: needed' surface fenchel-nielsen --lengths 1,2,3,4,5,6 --twists 0,0,0,0,0,0 -o out/x.json
bad 64 '^epsnet: --pants-graph: theta is a graph for genus 2' surface fenchel-nielsen --genus 3 --pants-graph theta --seed 1 -o out/x.json
good surface fenchel-nielsen --lengths 1,2,3 --twists 0,0.5,1 -o x.json
good surface fenchel-nielsen --pants-graph '0-1 0-1 0-1' --lengths 1,2,3 --twists 0,0.5,1 -o y.json
same x.json y.json
good surface named wiman --genus 7 -o x.json
good surface named wiman-7 -o y.json
same x.json y.json
bad 64 '^epsnet: NAME: wiman is a family, expected a genus as well, as in wiman-7$' surface named wiman -o out/x.json
bad 64 '^epsnet: NAME: klein has genus 3, not 4$' surface named klein --genus 4 -o out/x.json
bad 64 '^epsnet: --genus: needed' surface fenchel-nielsen -o out/x.json
bad 64 '^epsnet: --pants-graph: ' surface fenchel-nielsen --pants-graph star -o out/x.json
bad 64 '^epsnet: --lengths: edge 0' surface fenchel-nielsen --genus 2 --seed 1 --lengths 1e-30 -o out/x.json
bad 64 '^epsnet: --twists: edge 0' surface fenchel-nielsen --genus 2 --seed 1 --twists 1e101 -o out/x.json
bad 64 '--seed' surface fenchel-nielsen --genus 2 --seed -2 -o out/x.json
# A file is named by its members; what the command line says instead, by its options.
echo '{"genus": 3}' >request.json
bad 1 '^epsnet: request.json: seed: needed' surface fenchel-nielsen --from request.json -o out/x.json
bad 64 '--genus: expected an integer from 2 to 100000, not "1"' surface fenchel-nielsen --from request.json --genus 1 -o out/x.json
bad 64 '^epsnet: --lengths: expected 1 or 6' surface fenchel-nielsen --from request.json --lengths 1,2 -o out/x.json
bad 1 '^epsnet: --base: the point is in tile 4, the surface has 1 tile$' net s.json --epsilon 0.5 --base 4 -o out/x.json

meant() {
  suggestion=$1
  shift
  bad 64 "did you mean $suggestion?" "$@"
}
meant net nte s.json --epsilon 0.5 -o out/x.json
meant surface sufrace octagon --seed 1 -o out/x.json
meant thick-thin thickthin s.json
meant dirichlet dirichelt s.json
meant distance distence s.json 0 0
meant octagon surface octagn --seed 1 -o out/x.json
meant fenchel-nielsen surface fenchel_nielsen --genus 2
meant --epsilon net s.json --epsilom 0.5 -o out/x.json
meant --epsilon net s.json --eps 0.5 -o out/x.json
meant --epsilon net s.json -epsilon 0.5 -o out/x.json
meant --output net s.json --epsilon 0.5 --out out/x.json
meant --pseudo net s.json --epsilon 0.3 --psuedo -o out/x.json
meant --up-to spectrum s.json --upto 3
meant --up-to spectrum s.json --up_to=3
meant --genus surface fenchel-nielsen --genuss 2
meant --json info s.json --jsn
meant --help --hlep
bad 64 '^epsnet: unknown command "nonsense"; expected surface, pants, dirichlet, .*, convert or help (try --help)$' nonsense
bad 64 '^epsnet: surface: unknown command "genus"; expected octagon, fenchel-nielsen, .* or import (try --help)$' surface genus 3
for command in '' net 'surface octagon'; do
  # shellcheck disable=SC2086
  good $command --help
  mv output expected
  # shellcheck disable=SC2086
  good help $command
  cmp -s output expected || complain "epsnet help $command is not epsnet $command --help"
done
meant surface help sufrace
meant octagon help surface octagn
bad 64 '^epsnet: net: one argument too many, "x" (try --help)$' help net x
bad 64 '^epsnet: net: unknown option "--wholly-else" (try --help)$' net s.json --wholly-else
bad 64 'net: one argument too many, "extra"' net s.json extra --epsilon 0.5 -o out/x.json
bad 64 '--epsilon: given more than once' net s.json --epsilon 0.5 --epsilon 0.4 -o out/x.json
bad 64 '--epsilon: a value is missing' net s.json -o out/x.json --epsilon
bad 64 '--output: the path is empty' net s.json --epsilon 0.5 -o ''
bad 64 'SURFACE: the path is empty' net '' --epsilon 0.5 -o out/x.json

echo "$runs runs, $failures failures"
[ "$failures" = 0 ] && [ "$runs" -gt 400 ]
