(** The checker: integers, lists, arrays. The rules are those of certify/exact/checker.cpp, in the same order; where a
    value is found by a search or a formula (a crossing, the cycles), what it has to satisfy is checked on it, so that
    nothing need be proved about how it was found. *)

From Coq Require Import ZArith NArith List Bool FMapPositive.
From Epsnet Require Import Document Arrays.
Import ListNotations.
Open Scope Z_scope.

Inductive rule := Surface | Map | Gluing | Orientation | Delaunay | Covering | Packing.
Inductive answer := Yes | No | Unknown.
Inductive verdict := Verified | Refuted (r : rule) | Undecided (r : rule) | Malformed.

(** * Gaussian integers, points, isometries *)

Record gauss := Gauss { x : Z; y : Z }.

Definition add (z w : gauss) := Gauss (x z + x w) (y z + y w).
Definition sub (z w : gauss) := Gauss (x z - x w) (y z - y w).
Definition mul (z w : gauss) := Gauss (x z * x w - y z * y w) (x z * y w + y z * x w).
Definition scale (n : Z) (z : gauss) := Gauss (n * x z) (n * y z).
Definition conj (z : gauss) := Gauss (x z) (- y z).
Definition neg (z : gauss) := Gauss (- x z) (- y z).
Definition norm (z : gauss) := x z * x z + y z * y z.

Definition num (p : point) := Gauss (re p) (im p).

Definition lowest_terms (n : gauss) (m : Z) : point :=
  let g := Z.gcd (Z.gcd (x n) (y n)) m in
  if 1 <? g then Point (x n / g) (y n / g) (m / g) else Point (x n) (y n) m.

(** den² − |num|²: positive inside of the disk. *)
Definition gap (p : point) := den p * den p - norm (num p).

(** |z − w|² times the squares of both denominators. *)
Definition squared_difference (z w : point) := norm (sub (scale (den w) (num z)) (scale (den z) (num w))).

(** Has the sign of det(X(u), X(v), X(w)), X(z) = (2 Re z, 2 Im z, 1 + |z|²). *)
Definition orientation (u v w : point) : Z :=
  let last z := den z * den z + norm (num z) in
  let minor z z' := (re z * im z' - im z * re z') * (den z * den z') in
  minor u v * last w + minor v w * last u + minor w u * last v.

(** z ↦ (az + b)/(b̄z + ā). *)
Record iso := Iso { a : gauss; b : gauss }.

Definition identity := Iso (Gauss 1 0) (Gauss 0 0).
Definition compose (f g : iso) : iso :=
  Iso (add (mul (a f) (a g)) (mul (b f) (conj (b g)))) (add (mul (a f) (b g)) (mul (b f) (conj (a g)))).
Definition inverse (f : iso) : iso := Iso (conj (a f)) (neg (b f)).
Definition norm_iso (f : iso) : Z := norm (a f) - norm (b f).

Definition reduce (f : iso) : iso :=
  let g := Z.gcd (Z.gcd (x (a f)) (y (a f))) (Z.gcd (x (b f)) (y (b f))) in
  if 1 <? g then Iso (Gauss (x (a f) / g) (y (a f) / g)) (Gauss (x (b f) / g) (y (b f) / g)) else f.

Definition is_identity (f : iso) : bool := (y (a f) =? 0) && (x (b f) =? 0) && (y (b f) =? 0).

(** Whether f and g, neither of norm 0, are the same up to a real factor. *)
Definition same_iso (f g : iso) : bool :=
  negb (norm_iso f =? 0) && negb (norm_iso g =? 0) && is_identity (compose (inverse f) g).

(** z ↦ (z + c)/(1 + c̄z). *)
Definition translation (c : point) : iso := Iso (Gauss (den c) 0) (num c).

(** The denominator of an image is 0 if there is none. *)
Definition image (f : iso) (z : point) : point :=
  let n := add (mul (a f) (num z)) (scale (den z) (b f)) in
  let d := add (mul (conj (b f)) (num z)) (scale (den z) (conj (a f))) in
  lowest_terms (mul n (conj d)) (norm d).

Definition same_point (z w : point) : bool := (re z * den w =? re w * den z) && (im z * den w =? im w * den z).

Definition in_disk (z : point) : bool := (0 <? den z) && (0 <? gap z).

(** The last one after ... after the first one; neighbours first, so that most products are of small numbers. *)
Fixpoint neighbours (path : list iso) : list iso :=
  match path with
  | f :: g :: path' => reduce (compose g f) :: neighbours path'
  | _ => path
  end.

Fixpoint product (fuel path : list iso) : iso :=
  match path, fuel with
  | [], _ => identity
  | [f], _ => f
  | _, [] => fold_right (fun f g => compose g f) identity path
  | _, _ :: fuel' => product fuel' (neighbours path)
  end.

(** * Searches *)

(** Whether everything is reached from 0. *)
Fixpoint explore (fuel : list N) (neighbours_of : N -> list N) (open : list N) (seen : set) : set :=
  match fuel, open with
  | _ :: fuel', i :: rest =>
      let visit state j := let (o, s) := state : list N * set in if mem j s then state else (j :: o, insert j s) in
      let (open', seen') := fold_left visit (neighbours_of i) (rest, seen) in
      explore fuel' neighbours_of open' seen'
  | _, _ => seen
  end.

Definition connected (all : list N) (neighbours_of : N -> list N) : bool :=
  let seen := explore all neighbours_of [0%N] (insert 0 nobody) in
  forallb (fun i => mem i seen) all.

(** s, then what follows, until first comes again. *)
Fixpoint cycle (fuel : list N) (follow : N -> N) (first s : N) : list N :=
  match fuel with
  | [] => []
  | _ :: fuel' => s :: (if (follow s =? first)%N then [] else cycle fuel' follow first (follow s))
  end.

Fixpoint cycles_of (all : list N) (follow : N -> N) (starts : list N) (seen : set) : list (list N) :=
  match starts with
  | [] => []
  | s :: starts' =>
      if mem s seen then cycles_of all follow starts' seen
      else let c := cycle all follow s s in c :: cycles_of all follow starts' (insert_all c seen)
  end.

(** Whether each element follows the one before it, and the first one the last one. *)
Fixpoint goes_on (follow : N -> N) (first s : N) (c : list N) : bool :=
  match c with
  | [] => (follow s =? first)%N
  | s' :: c' => (follow s =? s')%N && goes_on follow first s' c'
  end.

Definition goes_round (follow : N -> N) (c : list N) : bool :=
  match c with
  | [] => false
  | s :: c' => goes_on follow s s c'
  end.

(** Whether a list has every element of another one, which has no element twice, exactly once, and no other. *)
Definition exactly_once (l all : list N) : bool :=
  let s := insert_all l nobody in
  (fast_size l =? fast_size all)%N && forallb (fun i => mem i s) all.

(** Marks what is reached from a dart. *)
Fixpoint walk (fuel : list N) (follow : N -> N) (d : N) (seen : set) : set :=
  match fuel with
  | [] => seen
  | _ :: fuel' => if mem d seen then seen else walk fuel' follow (follow d) (insert d seen)
  end.

(** * e^y between fractions *)

(** l/2^k ≤ e^(n/m) ≤ u/2^k for n/m ≥ 0: term i is at least t/2^k and at most u/2^k. *)
Fixpoint exp_terms (fuel : nat) (n m i t u lower upper : Z) : option (Z * Z) :=
  match fuel with
  | O => None
  | S fuel' =>
      let t' := t * n / (m * i) in
      let u' := u * n / (m * i) + 1 in
      if (t' =? 0) && (2 * n <=? m * (i + 1)) then Some (lower + t', upper + u' + u')
      else exp_terms fuel' n m (i + 1) t' u' (lower + t') (upper + u')
  end.

Definition bits (n : Z) : Z := Z.log2 n + 1.

(** Numbers l, u, s with l/s ≤ e^(2x) ≤ u/s, for x = n/m. *)
Definition exp_bounds (n m : Z) : option (Z * Z * Z) :=
  let k := 256 + 2 * Z.max (bits m - bits n) 0 in
  if (1000 * m <? n) || (100000 <? k) then None
  else
    let s := Z.shiftl 1 k in
    match exp_terms (N.to_nat 20000) (2 * n) m 1 s s s s with
    | Some (l, u) => Some (l, u, s)
    | None => None
    end.

(** * The net *)

Section Net.

Variable d : document.
Variable n : net.

(** The numbers of all sides, darts, vertices and triangles. *)
Variable all_sides all_darts all_vertices all_triangles : list N.

(** ** Structure *)

(** A word leads from one tile to another one. *)
Fixpoint leads (sides : N) (tile : N) (w : list N) (last : N) : bool :=
  match w with
  | [] => (tile =? last)%N
  | s :: w' => (s <? sides)%N && (tile_of n s =? tile)%N && leads sides (tile_of n (partner n s)) w' last
  end.

Definition label_fits (chart_count side_count : N) (l : label) : bool :=
  (from l <? chart_count)%N && (target l <? chart_count)%N &&
  leads side_count (tile_of_chart (chart_at n (from l))) (word l) (tile_of_chart (chart_at n (target l))).

Definition corner_fits (label_count own_vertex first_vertex l : N) : bool :=
  let own := chart_of (vertex_at n own_vertex) in
  let chart := chart_of (vertex_at n first_vertex) in
  if (l =? 0)%N then (own =? chart)%N
  else (l <? label_count + 1)%N && (from (label_at n (l - 1)) =? own)%N && (target (label_at n (l - 1)) =? chart)%N.

Definition triangle_fits (vertex_count dart_count label_count : N) (t : triangle) : bool :=
  forallb (fun v => v <? vertex_count)%N [v0 t; v1 t; v2 t] &&
  forallb (fun o => o <? dart_count)%N [o0 t; o1 t; o2 t] &&
  corner_fits label_count (v1 t) (v0 t) (l1 t) && corner_fits label_count (v2 t) (v0 t) (l2 t).

(** The row glues side s to side s'. *)
Definition glues (r : row) (s s' : N) : bool :=
  let (t, k) := side_at n s in
  let (t', k') := side_at n s' in
  (t =? t_one r)%N && (k =? k_one r)%N && (t' =? t_two r)%N && (k' =? k_two r)%N &&
  (partner n s =? s')%N && (partner n s' =? s)%N.

(** The pairs are the sides that each row glues, as found. *)
Definition structure (pairs : list (N * N)) : bool :=
  let side_count := fast_size all_sides in
  let chart_count := fast_size (charts d) in
  let label_count := fast_size (labels d) in
  let vertex_count := fast_size (vertices d) in
  let dart_count := (3 * fast_size (triangles d))%N in
  (0 <? epsilon_num d) && (0 <? epsilon_den d) &&
  (0 <? fast_size (tiles d))%N &&
  forallb (fun t => (3 <=? fast_size t)%N && forallb (fun z => 0 <? den z) t) (tiles d) &&
  (fast_size pairs =? fast_size (gluing d))%N &&
  forallb (fun p : row * (N * N) => let (r, ss) := p in glues r (fst ss) (snd ss)) (combine (gluing d) pairs) &&
  exactly_once (flat_map (fun p : N * N => [fst p; snd p]) pairs) all_sides &&
  forallb (fun c => (tile_of_chart c <? fast_size (tiles d))%N && in_disk (centre c)) (charts d) &&
  forallb (label_fits chart_count side_count) (labels d) &&
  forallb (fun v => (chart_of v <? chart_count)%N && in_disk (place v)) (vertices d) &&
  forallb (triangle_fits vertex_count dart_count label_count) (triangles d).

(** ** Rule surface *)

(** A left turn at every corner but the last two, *)
Fixpoint left_turns (l : list point) : bool :=
  match l with
  | u :: l' => match l' with v :: w :: _ => (0 <? orientation u v w) && left_turns l' | _ => true end
  | [] => true
  end.

(** and seen from a point in counterclockwise order. *)
Fixpoint in_order (z : point) (l : list point) : bool :=
  match l with
  | u :: l' => match l' with v :: _ => (0 <? orientation z u v) && in_order z l' | [] => true end
  | [] => true
  end.

Definition convex (l : list point) : bool :=
  forallb in_disk l &&
  match l with
  | z :: u :: l' => left_turns (l ++ [z; u]) && forallb (fun v => 0 <? orientation z u v) l' && in_order z (u :: l')
  | _ => false
  end.

Definition equal_length (s : N) : bool :=
  let p := corner_at n s in
  let q := side_end n s in
  let p' := corner_at n (partner n s) in
  let q' := side_end n (partner n s) in
  squared_difference p q * (gap p' * gap q') =? squared_difference p' q' * (gap p * gap q).

(** p ↦ q′ and q ↦ p′: p to 0, a turn, 0 to q′. *)
Definition crossing_of (s : N) : iso :=
  let first := inverse (translation (corner_at n s)) in
  let last := translation (side_end n (partner n s)) in
  let f := image first (side_end n s) in
  let t := image (inverse last) (corner_at n (partner n s)) in
  let root := mul (add (scale (den f) (num t)) (scale (den t) (num f))) (conj (num f)) in
  let root := if (x root =? 0) && (y root =? 0) then Gauss 0 1 else root in
  reduce (compose last (compose (Iso root (Gauss 0 0)) first)).

Definition takes (f : iso) (z w : point) : bool :=
  let z' := image f z in (0 <? den z') && same_point z' w.

Definition crossing_fits (crossing : N -> iso) (s : N) : bool :=
  let f := crossing s in
  (0 <? norm_iso f) && takes f (corner_at n s) (side_end n (partner n s)) &&
  takes f (side_end n s) (corner_at n (partner n s)).

(** A number whose argument, between 0 and π, is the interior angle where the side starts. *)
Definition turn (s : N) : gauss :=
  let to_origin := inverse (translation (corner_at n s)) in
  let f := image to_origin (side_end n s) in
  let t := image to_origin (corner_at n (side_before n s)) in
  mul (num t) (conj (num f)).

Definition turn_fits (s : N) : bool :=
  let to_origin := inverse (translation (corner_at n s)) in
  (0 <? den (image to_origin (side_end n s))) && (0 <? den (image to_origin (corner_at n (side_before n s)))) &&
  (0 <? y (turn s)).

Definition below (z : gauss) : bool := (y z <? 0) || ((y z =? 0) && (x z <? 0)).

(** A full turn is complete where the direction comes from the lower half-plane to the upper one. *)
Fixpoint full_turns (c : list N) (direction : gauss) (turns : Z) : gauss * Z :=
  match c with
  | [] => (direction, turns)
  | s :: c' =>
      let after := mul direction (turn s) in
      full_turns c' after (if below direction && negb (below after) then turns + 1 else turns)
  end.

Definition one_turn (c : list N) : bool :=
  forallb turn_fits c &&
  let (direction, turns) := full_turns c (Gauss 1 0) 0 in
  (turns =? 1) && (y direction =? 0) && (0 <? x direction).

Definition closes_up (crossing : N -> iso) (c : list N) : bool :=
  let path := map crossing c in
  goes_round (around n) c && same_iso identity (product path path) && one_turn c.

Definition euler_of_surface (cycles : list (list N)) : Z :=
  Z.of_N (fast_size cycles) - Z.of_N (fast_size (gluing d)) + Z.of_N (fast_size (tiles d)).

Definition surface (crossing : N -> iso) (cycles : list (list N)) : bool :=
  forallb convex (tiles d) &&
  connected all_sides (fun s => [side_after n s; partner n s]) &&
  forallb equal_length all_sides &&
  forallb (crossing_fits crossing) all_sides &&
  exactly_once (concat cycles) all_sides &&
  forallb (closes_up crossing) cycles &&
  (euler_of_surface cycles <? 0) && (euler_of_surface cycles mod 2 =? 0).

(** ** Rule map *)

(** Dart first v leaves vertex v. *)
Definition map_rule (first : N -> N) (cycles : list (list N)) : bool :=
  (0 <? fast_size (vertices d))%N && (0 <? fast_size (triangles d))%N &&
  forallb (fun e => negb (opposite n e =? e)%N && (opposite n (opposite n e) =? e)%N &&
                    (start n e =? start n (next (opposite n e)))%N) all_darts &&
  forallb (fun v => (first v <? 3 * fast_size (triangles d)) && (start n (first v) =? v))%N all_vertices &&
  (let seen := fold_left (fun s v => walk all_darts (turn_left n) (first v) s) all_vertices nobody in
   forallb (fun e => mem e seen) all_darts) &&
  connected all_triangles
    (fun t => map (fun i => opposite n (3 * t + i) / 3)%N [0; 1; 2]%N) &&
  (2 * (Z.of_N (fast_size (vertices d)) + Z.of_N (fast_size (triangles d))) - 3 * Z.of_N (fast_size (triangles d))
   =? 2 * euler_of_surface cycles).

(** ** Rules gluing and orientation *)

Definition frame (c : N) : iso := translation (centre (chart_at n c)).

(** F_to⁻¹ ∘ word ∘ F_from. *)
Definition label_value (crossing : N -> iso) (l : label) : iso :=
  let path := frame (from l) :: map crossing (word l) ++ [inverse (frame (target l))] in
  product path path.

(** The value of label number k. *)
Variable value : N -> iso.

(** Each edge once. *)
Definition for_edges (rule : N -> bool) : bool :=
  forallb (fun e => if (opposite n e <? e)%N then true else rule e) all_darts.

(** L_a L_b⁻¹ = L_c L_d⁻¹. *)
Definition labels_agree (e : N) : bool :=
  let k1 := label_number n e in
  let k2 := label_number n (next (opposite n e)) in
  let k3 := label_number n (next e) in
  let k4 := label_number n (opposite n e) in
  ((k1 =? k3) && (k2 =? k4))%N || ((k1 =? k2) && (k3 =? k4))%N ||
  same_iso (compose (value k1) (inverse (value k2))) (compose (value k3) (inverse (value k4))).

Definition gluing_rule : bool := for_edges labels_agree.

(** The corner where the dart starts, in the chart of its triangle. *)
Definition corner (e : N) : point :=
  let z := place (vertex_at n (start n e)) in
  if (label_number n e =? 0)%N then z else image (value (label_number n e)) z.

Definition triangle_is_left (t : N) : bool :=
  let p := corner (3 * t) in
  let q := corner (3 * t + 1) in
  let r := corner (3 * t + 2) in
  in_disk p && in_disk q && in_disk r && (0 <? orientation p q r).

Definition orientation_rule : bool := forallb triangle_is_left all_triangles.

(** ** Rule delaunay *)

(** The corner of the neighbour across the dart that is not on it, in the chart of the dart's triangle. *)
Definition far_corner (e : N) : point :=
  let here := label_number n e in
  let there := label_number n (next (opposite n e)) in
  let z := corner (previous (opposite n e)) in
  if (here =? there)%N then z
  else
    let z' := image (inverse (value there)) z in
    if 0 <? den z' then image (value here) z' else Point 0 0 0.

(** The determinant of Lemma 3.1 with the last point as origin, times squares of denominators. *)
Definition delaunay_sign (p q r far : point) : Z :=
  let difference z := sub (scale (den far) (num z)) (scale (den z) (num far)) in
  let place z := scale (den z * den far) (difference z) in
  let square z := norm (difference z) in
  let area z w := x (place z) * y (place w) - y (place z) * x (place w) in
  area p q * square r + area q r * square p + area r p * square q.

Definition is_delaunay (e : N) : bool :=
  let far := far_corner e in
  (0 <? den far) && (delaunay_sign (corner e) (corner (next e)) (corner (previous e)) far <=? 0).

Definition delaunay_rule : bool := for_edges is_delaunay.

(** ** Rules covering and packing *)

Fixpoint all_yes (question : N -> answer) (l : list N) : answer :=
  match l with
  | [] => Yes
  | i :: l' => match question i with Yes => all_yes question l' | other => other end
  end.

(** 4 d₀ d₁ d₂ < sinh²ε · discriminant, where (l − s)²/4ls ≤ sinh²ε ≤ (u − s)²/4us. *)
Definition is_covered (l u s : Z) (t : N) : answer :=
  let p := corner (3 * t) in
  let q := corner (3 * t + 1) in
  let r := corner (3 * t + 2) in
  let d0 := squared_difference p q in
  let d1 := squared_difference q r in
  let d2 := squared_difference r p in
  let g0 := d0 * gap r in
  let g1 := d1 * gap p in
  let g2 := d2 * gap q in
  let discriminant := 4 * g0 * g1 - (g0 + g1 - g2) * (g0 + g1 - g2) in
  let left := 4 * (d0 * d1 * d2) in
  if left * (4 * l * s) <? (l - s) * (l - s) * discriminant then Yes
  else if (discriminant <=? 0) || ((u - s) * (u - s) * discriminant <=? left * (4 * u * s)) then No
  else Unknown.

Definition covering_rule : answer :=
  match exp_bounds (epsilon_num d) (epsilon_den d) with
  | Some (l, u, s) => all_yes (is_covered l u s) all_triangles
  | None => Unknown
  end.

(** Here (l − s)²/4ls ≤ sinh²(ε/2) ≤ (u − s)²/4us. *)
Definition is_long (l u s : Z) (e : N) : answer :=
  if (opposite n e <? e)%N || (start n e =? start n (next e))%N then Yes
  else
    let p := corner e in
    let q := corner (next e) in
    let length := squared_difference p q in
    let gaps := gap p * gap q in
    if (u - s) * (u - s) * gaps <=? length * (4 * u * s) then Yes
    else if length * (4 * l * s) <? (l - s) * (l - s) * gaps then No
    else Unknown.

Definition packing_rule : answer :=
  match exp_bounds (epsilon_num d) (2 * epsilon_den d) with
  | Some (l, u, s) => all_yes (is_long l u s) all_darts
  | None => Unknown
  end.

End Net.

(** * The decision *)

Definition paired (pairs : list (N * N)) : array N :=
  fold_left (fun a p => PositiveMap.add (N.succ_pos (snd p)) (fst p) (PositiveMap.add (N.succ_pos (fst p)) (snd p) a))
    pairs (PositiveMap.empty N).

(** The side numbers of the rows: the number of the first side of each tile, and more. *)
Fixpoint first_sides (l : list (list point)) (s : N) : list N :=
  match l with
  | [] => []
  | t :: l' => s :: first_sides l' (s + fast_size t)%N
  end.

Definition find_pairs (d : document) : list (N * N) :=
  let first := of_list (first_sides (tiles d) 0%N) in
  map (fun r => (get first 0 (t_one r) + k_one r, get first 0 (t_two r) + k_two r)%N) (gluing d).

Definition fast_net (d : document) (pairs : list (N * N)) : net :=
  let tile_array := of_list (tiles d) in
  let corner_array := of_list (concat (tiles d)) in
  let side_array := of_list (sides d) in
  let chart_array := of_list (charts d) in
  let label_array := of_list (labels d) in
  let vertex_array := of_list (vertices d) in
  let triangle_array := of_list (triangles d) in
  let partner_array := paired pairs in
  {| tile_at := get tile_array [];
     corner_at := get corner_array origin;
     side_at := get side_array (0, 0)%N;
     partner := get partner_array 0%N;
     chart_at := get chart_array no_chart;
     label_at := get label_array no_label;
     vertex_at := get vertex_array no_vertex;
     triangle_at := get triangle_array no_triangle |}.

Definition find_crossings (n : net) (all_sides : list N) : array iso := of_list (map (crossing_of n) all_sides).

(** A dart that leaves each vertex. *)
Definition find_first (n : net) (all_darts : list N) : array N :=
  fold_left (fun a e => PositiveMap.add (N.succ_pos (start n e)) e a) all_darts (PositiveMap.empty N).

Definition find_values (d : document) (n : net) (crossing : N -> iso) : array iso :=
  of_list (identity :: map (label_value n crossing) (labels d)).

Definition and_then (r : rule) (a : answer) (rest : verdict) : verdict :=
  match a with Yes => rest | No => Refuted r | Unknown => Undecided r end.

Definition decide (d : document) : verdict :=
  let pairs := find_pairs d in
  let n := fast_net d pairs in
  let all_sides := indices (sides d) in
  let all_triangles := indices (triangles d) in
  let all_darts := flat_map (fun t => [3 * t; 3 * t + 1; 3 * t + 2])%N all_triangles in
  let all_vertices := indices (vertices d) in
  if structure d n all_sides pairs then
    let crossings := find_crossings n all_sides in
    let crossing := get crossings identity in
    let cycles := cycles_of all_sides (around n) all_sides nobody in
    if surface d n all_sides crossing cycles then
      let first := find_first n all_darts in
      if map_rule d n all_darts all_vertices all_triangles (get first 0%N) cycles then
        let values := find_values d n crossing in
        let value := get values identity in
        if gluing_rule n all_darts value then
          if orientation_rule n all_triangles value then
            if delaunay_rule n all_darts value then
              and_then Covering (covering_rule d n all_triangles value)
              (and_then Packing (packing_rule d n all_darts value) Verified)
            else Refuted Delaunay
          else Refuted Orientation
        else Refuted Gluing
      else Refuted Map
    else Refuted Surface
  else Malformed.

Definition check (d : document) : bool := match decide d with Verified => true | _ => false end.
