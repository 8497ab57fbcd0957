(* From JSON to the document that the checker is about, and back to text. *)

open Json

let fail what = raise (Malformed what)
let max_digits = 1_000_000

let member members name =
  match List.assoc_opt name members with
  | Some value -> value
  | None -> fail (Printf.sprintf "no member \"%s\"" name)

(* The members of an object that has no others than these. *)
let members names = function
  | Object found ->
    List.iter (fun (name, _) -> if not (List.mem name names) then fail "unknown member") found;
    found
  | _ -> fail "expected an object"

let elements what = function Array values -> values | _ -> fail (what ^ ": expected an array")
let wrong expected = fail ("expected " ^ expected)

let index = function
  | Number text when String.length text <= 10 && String.for_all is_digit text && int_of_string text < 1 lsl 32 ->
    Z.of_string_base 10 text
  | _ -> wrong "an index"

let integer digits = Z.of_string_base 10 digits
let signed negative n = if negative then Z.neg n else n

(* Numerator and denominator in lowest terms, the latter positive. *)
let fraction n m =
  let g = Z.gcd n m in
  (Z.divexact n g, Z.divexact m g)

let rational_of_text text =
  let slash = String.index_opt text '/' in
  let first = if text <> "" && text.[0] = '-' then 1 else 0 in
  let stop = Option.value slash ~default:(String.length text) in
  let numerator = if stop < first then "" else String.sub text first (stop - first) in
  let denominator = if slash = None then "1" else String.sub text (stop + 1) (String.length text - stop - 1) in
  let good digits = digits <> "" && String.for_all is_digit digits in
  let digits = String.length numerator + if slash = None then 0 else String.length denominator in
  if not (good numerator && good denominator) || digits > max_digits then wrong "a rational";
  let m = integer denominator in
  if Z.equal m Z.zero then wrong "a rational";
  fraction (signed (first = 1) (integer numerator)) m

let rational = function String text -> rational_of_text text | _ -> wrong "a rational in a string"

(* digits · 10^power as a fraction, not in lowest terms. *)
let scaled digits power =
  let ten = Z.pow (Z.of_int 10) (abs power) in
  if power < 0 then (digits, ten) else (Z.mul digits ten, Z.one)

let decimal = function
  | String text when String.contains text '/' -> rational_of_text text
  | String text -> (
    match as_written text with
    | Some w when String.length w.whole + String.length w.fraction <= max_digits
                  && String.length (Option.fold ~none:"" ~some:(fun e -> e) w.exponent)
                     - (if String.contains (Option.value w.exponent ~default:"") '-' then 1 else 0) <= 4 ->
      let power = Option.fold ~none:0 ~some:(fun e -> Z.to_int (Z.of_string_base 10 e)) w.exponent in
      let n, m = scaled (integer (w.whole ^ w.fraction)) (power - String.length w.fraction) in
      fraction (signed w.negative n) m
    | _ -> wrong "a decimal")
  | _ -> wrong "a decimal in a string"

(* The binary64 nearest to a number, ties to even, as a fraction in lowest terms. *)
let binary64 = function
  | Number text ->
    let w = Option.get (as_written text) in
    let digits = integer (w.whole ^ w.fraction) in
    let power = Option.fold ~none:Z.zero ~some:(fun e -> Z.of_string_base 10 e) w.exponent in
    let power = Z.sub power (Z.of_int (String.length w.fraction)) in
    (* The number is between 10^(order - 1) and 10^order, or 0. *)
    let order = Z.add power (Z.of_int (String.length (Z.to_string digits))) in
    if Z.equal digits Z.zero || Z.lt order (Z.of_int (-330)) then (Z.zero, Z.one)
    else if Z.gt order (Z.of_int 330) then wrong "a finite binary64 number"
    else begin
      let n, m = scaled digits (Z.to_int power) in
      (* The quotient by 2^k has at most 53 bits, and 53 if k is not that of the subnormal numbers. *)
      let rec rounded k =
        let n' = if k < 0 then Z.shift_left n (-k) else n in
        let m' = if k < 0 then m else Z.shift_left m k in
        let quotient, remainder = Z.div_rem n' m' in
        if Z.numbits quotient > 53 then rounded (k + 1)
        else
          let half = Z.compare (Z.shift_left remainder 1) m' in
          ((if half > 0 || (half = 0 && Z.is_odd quotient) then Z.succ quotient else quotient), k) in
      let quotient, k = rounded (max (Z.numbits n - Z.numbits m - 53) (-1074)) in
      if Z.numbits quotient + k > 1024 then wrong "a finite binary64 number";
      let quotient = signed w.negative quotient in
      if k < 0 then fraction quotient (Z.shift_left Z.one (-k)) else (Z.shift_left quotient k, Z.one)
    end
  | _ -> wrong "a number"

(* Two fractions with one denominator. *)
let point (re, re_den) (im, im_den) =
  let m = Z.lcm re_den im_den in
  { Checker.re = Z.mul re (Z.divexact m re_den); im = Z.mul im (Z.divexact m im_den); den = m }

(* [List.map] without recursion as deep as the list is long. *)
let map f values = List.rev (List.rev_map f values)

let row_of_tile = function
  | Array [ x; y ] ->
    let x = rational x in
    point x (rational y)
  | _ -> fail "a vertex of a tile"

let row_of_gluing = function
  | Array [ t; k; t'; k' ] -> { Checker.t_one = index t; k_one = index k; t_two = index t'; k_two = index k' }
  | _ -> fail "a row of the gluing"

let chart = function
  | Array [ t; x; y ] ->
    let tile_of_chart = index t in
    let x = rational x in
    { Checker.tile_of_chart; centre = point x (rational y) }
  | _ -> fail "a chart"

let label letters = function
  | Array [ from; target; word ] ->
    let word = elements "a word" word in
    letters := !letters + List.length word;
    if List.length word > 1_000_000 || !letters > 10_000_000 then fail "too many letters";
    { Checker.from = index from; target = index target; word = map index word }
  | _ -> fail "a label"

let vertex = function
  | Array [ c; x; y ] ->
    let x = binary64 x in
    { Checker.chart_of = index c; place = point x (binary64 y) }
  | _ -> fail "a vertex"

let triangle = function
  | Array [ v0; v1; v2; o0; o1; o2; l1; l2 ] ->
    { Checker.v0 = index v0; v1 = index v1; v2 = index v2; o0 = index o0; o1 = index o1; o2 = index o2;
      l1 = index l1; l2 = index l2 }
  | _ -> fail "a triangle"

let document root =
  let root =
    members [ "format"; "version"; "surface"; "epsilon"; "charts"; "labels"; "vertices"; "triangles" ] root in
  if not (Z.equal (index (member root "version")) Z.one) then fail "the version is not 1";
  let surface = members [ "kind"; "tiles"; "gluing"; "about" ] (member root "surface") in
  if member surface "kind" <> String "tiles" then fail "unexpected value for the kind of the surface";
  (match List.assoc_opt "about" surface with
   | None -> ()
   | Some (String text) when String.length text <= 1 lsl 20 -> ()
   | Some _ -> fail "about: expected a string of at most 1 MiB");
  let rows members name f = map f (elements name (member members name)) in
  let epsilon_num, epsilon_den = decimal (member root "epsilon") in
  { Checker.tiles = rows surface "tiles" (fun tile -> map row_of_tile (elements "a tile" tile));
    gluing = rows surface "gluing" row_of_gluing;
    epsilon_num; epsilon_den;
    charts = rows root "charts" chart;
    labels = rows root "labels" (label (ref 0));
    vertices = rows root "vertices" vertex;
    triangles = rows root "triangles" triangle }

(* Why a file is left to certify, if it is. *)
let not_for_this_checker = function
  | Object found -> (
    match member found "format" with
    | String
        (("epsnet-geodesics" | "epsnet-distance" | "epsnet-cover" | "epsnet-eigenvalues" | "epsnet-isometries"
         | "epsnet-pants" | "epsnet-comparison" | "epsnet-curves" | "epsnet-surface" | "epsnet-dirichlet" | "epsnet-matrices"
         | "epsnet-mesh") as format) ->
      Some ("a file of the format " ^ format)
    | String "epsnet-net" -> (
      if List.mem_assoc "collars" found then Some "a pseudo net"
      else
        match List.assoc_opt "surface" found with
        | Some (Object surface) -> (
          match List.assoc_opt "kind" surface with
          | Some (String "regular") -> Some "a regular surface"
          | Some (String "map") -> Some "a map of regular tiles"
          | Some (String "field") -> Some "a surface over a number field"
          | _ -> None)
        | _ -> None)
    | _ -> fail "unexpected value for the format")
  | _ -> fail "expected an object"

(* The document in JSON again, every coordinate as an exact fraction. *)
let print channel (d : Checker.document) =
  let text n = Z.to_string n in
  let fraction n m =
    let n, m = fraction n m in
    Printf.sprintf "\"%s/%s\"" (text n) (text m) in
  let coordinates (p : Checker.point) = fraction p.re p.den ^ "," ^ fraction p.im p.den in
  let row values = "[" ^ String.concat "," values ^ "]" in
  let rows name values f stop =
    Printf.fprintf channel "\"%s\":[" name;
    List.iteri (fun i value -> output_string channel ((if i = 0 then "\n" else ",\n") ^ f value)) values;
    output_string channel ("]" ^ stop ^ "\n") in
  output_string channel "{";
  rows "tiles" d.tiles (fun tile -> row (map (fun p -> row [ coordinates p ]) tile)) ",";
  rows "gluing" d.gluing (fun r -> row (map text [ r.Checker.t_one; r.k_one; r.t_two; r.k_two ])) ",";
  Printf.fprintf channel "\"epsilon\":%s,\n" (fraction d.epsilon_num d.epsilon_den);
  rows "charts" d.charts (fun c -> row [ text c.Checker.tile_of_chart; coordinates c.centre ]) ",";
  rows "labels" d.labels
    (fun l -> row [ text l.Checker.from; text l.target; row (map text l.word) ]) ",";
  rows "vertices" d.vertices (fun v -> row [ text v.Checker.chart_of; coordinates v.place ]) ",";
  rows "triangles" d.triangles
    (fun t -> row (map text [ t.Checker.v0; t.v1; t.v2; t.o0; t.o1; t.o2; t.l1; t.l2 ])) "}"
