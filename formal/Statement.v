(** What is proved of a document that the checker verifies: [statement], in words of geometry, over the real numbers.
    Section and lemma numbers are those of docs/proof.md. Read Document.v first. *)

From Coq Require Import ZArith NArith Reals List Permutation Relations.
From Epsnet Require Import Document.
Import ListNotations.
Open Scope R_scope.

(** * The hyperbolic plane: the Poincaré disk *)

Definition C := (R * R)%type.
Definition Re (z : C) : R := fst z.
Definition Im (z : C) : R := snd z.
Definition Cadd (z w : C) : C := (Re z + Re w, Im z + Im w).
Definition Csub (z w : C) : C := (Re z - Re w, Im z - Im w).
Definition Cmul (z w : C) : C := (Re z * Re w - Im z * Im w, Re z * Im w + Im z * Re w).
Definition Cconj (z : C) : C := (Re z, - Im z).
Definition abs2 (z : C) : R := Re z * Re z + Im z * Im z.  (* |z|² *)
Definition Cinv (z : C) : C := (Re z / abs2 z, - Im z / abs2 z).
Definition Cdiv (z w : C) : C := Cmul z (Cinv w).

(** A point of a document as a complex number. *)
Definition to_C (p : point) : C := (IZR (re p) / IZR (den p), IZR (im p) / IZR (den p)).

Definition in_plane (z : C) : Prop := abs2 z < 1.

(** sinh²(d/2) = |z − w|²/((1 − |z|²)(1 − |w|²)). *)
Definition distance (z w : C) : R := 2 * arcsinh (sqrt (abs2 (Csub z w) / ((1 - abs2 z) * (1 - abs2 w)))).

(** The vector X(z) of the hyperboloid up to a factor, and the determinant of three of them. Hyperbolic lines are
    straight there, so its sign tells on which side of the line through u and v the point w lies. *)
Definition det (u v w : C) : R :=
  let t z := 1 + abs2 z in
  (2 * Re u) * ((2 * Im v) * t w - (2 * Im w) * t v) - (2 * Im u) * ((2 * Re v) * t w - (2 * Re w) * t v)
  + t u * ((2 * Re v) * (2 * Im w) - (2 * Re w) * (2 * Im v)).

Definition counterclockwise (u v w : C) : Prop := 0 < det u v w.

(** The isometry z ↦ (az + b)/(b̄z + ā), |a| > |b|, which preserves orientation. *)
Record isometry := Isometry { a : C; b : C }.
Definition proper (f : isometry) : Prop := abs2 (b f) < abs2 (a f).
Definition act (f : isometry) (z : C) : C :=
  Cdiv (Cadd (Cmul (a f) z) (b f)) (Cadd (Cmul (Cconj (b f)) z) (Cconj (a f))).
Definition compose (f g : isometry) : isometry :=
  Isometry (Cadd (Cmul (a f) (a g)) (Cmul (b f) (Cconj (b g)))) (Cadd (Cmul (a f) (b g)) (Cmul (b f) (Cconj (a g)))).
Definition inverse (f : isometry) : isometry := Isometry (Cconj (a f)) (- Re (b f), - Im (b f)).
Definition identity : isometry := Isometry (1, 0) (0, 0).
Definition same_map (f g : isometry) : Prop := forall z, in_plane z -> act f z = act g z.

(** z ↦ (z + c)/(1 + c̄z), which takes 0 to c. *)
Definition translation (c : C) : isometry := Isometry (1, 0) c.

(** The angle at p between the segments to q and to r, from 0 to π: seen from p, moved to 0, it is that of the
    directions of q and r. *)
Definition angle (p q r : C) : R :=
  let q' := act (inverse (translation p)) q in
  let r' := act (inverse (translation p)) r in
  acos (Re (Cmul r' (Cconj q')) / sqrt (abs2 (Cmul r' (Cconj q')))).

(** * Section 2: the surface *)

Section Statement.
Variable d : document.
Variable n : net.  (* the lists of the document by index, and the partners of sides *)
Variable crossing : N -> isometry.
Variable cycles : list (list N).
Variable genus : Z.

Definition side_count : N := size (sides d).
Definition first_of (s : N) : C := to_C (corner_at n s).
Definition last_of (s : N) : C := to_C (side_end n s).

(** (a) A tile is a strictly convex polygon, counterclockwise: any three corners in their order are so. *)
Definition strictly_convex (tile : list point) : Prop :=
  (3 <= length tile)%nat /\ (forall z, In z tile -> in_plane (to_C z)) /\
  forall i j k, (i < j)%nat -> (j < k)%nat -> (k < length tile)%nat ->
    counterclockwise (to_C (nth i tile origin)) (to_C (nth j tile origin)) (to_C (nth k tile origin)).

(** (b) Every side is glued to exactly one other side, as the rows say. *)
Definition sides_are_paired : Prop :=
  (forall s, (s < side_count)%N ->
     (partner n s < side_count)%N /\ partner n s <> s /\ partner n (partner n s) = s) /\
  (forall r, In r (gluing d) -> exists s,
     (s < side_count)%N /\ side_at n s = (t_one r, k_one r) /\ side_at n (partner n s) = (t_two r, k_two r)).

(** (c) Glued sides have equal length, and the crossing of a side takes it to its partner, turned round. *)
Definition crossings_fit : Prop :=
  forall s, (s < side_count)%N ->
    distance (first_of s) (last_of s) = distance (first_of (partner n s)) (last_of (partner n s)) /\
    proper (crossing s) /\
    act (crossing s) (first_of s) = last_of (partner n s) /\ act (crossing s) (last_of s) = first_of (partner n s).

(** (d) All is connected: from side 0 one comes to every side by going on in its tile and over to partners. *)
Definition reaches (steps : N -> list N) : N -> N -> Prop := clos_refl_trans N (fun i j => In j (steps i)).
Definition tiles_are_connected : Prop :=
  forall s, (s < side_count)%N -> reaches (fun s => [side_after n s; partner n s]) 0%N s.

(** The sides that start at the corners around one point of the surface, in their order. *)
Definition goes_round (c : list N) : Prop :=
  c <> [] /\ forall i, (i < length c)%nat -> around n (nth i c 0%N) = nth ((i + 1) mod length c) c 0%N.

(** g_(s_n) ∘ … ∘ g_(s_1), from the disk of the first tile to that of the last. *)
Fixpoint word_value (w : list N) : isometry :=
  match w with [] => identity | s :: w' => compose (word_value w') (crossing s) end.

Definition interior_angle (s : N) : R := angle (first_of s) (last_of s) (to_C (corner_at n (side_before n s))).

Definition sum (f : N -> R) (l : list N) : R := fold_right (fun s total => f s + total) 0 l.

(** Every corner is in exactly one cycle; (f) around each the crossings multiply to the identity, (g) the angles add up
    to 2π. *)
Definition corners_fit : Prop :=
  Permutation (concat cycles) (map N.of_nat (seq 0 (N.to_nat side_count))) /\
  forall c, In c cycles -> goes_round c /\ same_map (word_value c) identity /\ sum interior_angle c = 2 * PI.

(** (e) V − E + F = 2 − 2g. *)
Definition euler_characteristic : Z :=
  (Z.of_nat (length cycles) - Z.of_nat (length (gluing d)) + Z.of_nat (length (tiles d)))%Z.

Definition is_surface : Prop :=
  (forall tile, In tile (tiles d) -> strictly_convex tile) /\ sides_are_paired /\ crossings_fit /\
  tiles_are_connected /\ corners_fit /\ (2 <= genus)%Z /\ euler_characteristic = (2 - 2 * genus)%Z.

(** * Section 3: the abstract surface of the triangles *)

Definition dart_count : N := (3 * size (triangles d))%N.

Definition darts_are_paired : Prop :=
  forall x, (x < dart_count)%N ->
    (opposite n x < dart_count)%N /\ opposite n x <> x /\ opposite n (opposite n x) = x /\
    start n x = start n (next (opposite n x)).

(** The darts that leave a vertex are one cycle, and every vertex has one. *)
Definition vertices_have_one_cycle : Prop :=
  (forall x, (x < dart_count)%N -> (start n x < size (vertices d))%N) /\
  forall v, (v < size (vertices d))%N -> exists x, (x < dart_count)%N /\ start n x = v /\
    forall x', (x' < dart_count)%N -> start n x' = v -> exists k, x' = Nat.iter k (turn_left n) x.

Definition triangles_are_connected : Prop :=
  forall t, (t < size (triangles d))%N ->
    reaches (fun t => [opposite n (3 * t) / 3; opposite n (3 * t + 1) / 3; opposite n (3 * t + 2) / 3]%N) 0%N t.

Definition is_map : Prop :=
  (0 < size (vertices d))%N /\ (0 < size (triangles d))%N /\ darts_are_paired /\ vertices_have_one_cycle /\
  triangles_are_connected /\
  (* V − E + F = 2 − 2g, where E = 3F/2. *)
  (2 * (Z.of_N (size (vertices d)) + Z.of_N (size (triangles d))) - 3 * Z.of_N (size (triangles d))
   = 2 * (2 - 2 * genus))%Z.

(** * Section 4: the triangles lie on the surface *)

(** Words are paths from tile to tile. *)
Fixpoint leads (tile : N) (w : list N) (last : N) : Prop :=
  match w with
  | [] => tile = last
  | s :: w' => (s < side_count)%N /\ tile_of n s = tile /\ leads (tile_of n (partner n s)) w' last
  end.

(** The frame F of a chart, which takes its coordinates to those of its tile, and a label F_to⁻¹ ∘ word ∘ F_from. *)
Definition frame (c : N) : isometry := translation (to_C (centre (chart_at n c))).
Definition label_value (l : label) : isometry :=
  compose (inverse (frame (target l))) (compose (word_value (word l)) (frame (from l))).
Definition label_of (x : N) : isometry :=
  if (label_number n x =? 0)%N then identity else label_value (label_at n (label_number n x - 1)).

(** Charts, labels, vertices and triangles refer to what is there; a label leads from the chart of its corner's vertex
    to that of corner 0. *)
Definition chart_of_start (x : N) : N := chart_of (vertex_at n (start n x)).
Definition labels_fit : Prop :=
  (forall c, In c (charts d) -> (tile_of_chart c < size (tiles d))%N /\ in_plane (to_C (centre c))) /\
  (forall v, In v (vertices d) -> (chart_of v < size (charts d))%N /\ in_plane (to_C (place v))) /\
  (forall l, In l (labels d) -> (from l < size (charts d))%N /\ (target l < size (charts d))%N /\
     leads (tile_of_chart (chart_at n (from l))) (word l) (tile_of_chart (chart_at n (target l)))) /\
  (forall x, (x < dart_count)%N ->
     if (label_number n x =? 0)%N then chart_of_start x = chart_of_start (3 * (x / 3))
     else (label_number n x <= size (labels d))%N /\
          from (label_at n (label_number n x - 1)) = chart_of_start x /\
          target (label_at n (label_number n x - 1)) = chart_of_start (3 * (x / 3))).

(** An edge, by the first of its two darts. *)
Definition is_edge (x : N) : Prop := (x < dart_count)%N /\ (x < opposite n x)%N.

(** (∗): both ends of an edge are moved from the chart of one triangle to that of the other by the same isometry. *)
Definition edges_are_glued : Prop :=
  forall x, is_edge x ->
    same_map (compose (label_of x) (inverse (label_of (next (opposite n x)))))
             (compose (label_of (next x)) (inverse (label_of (opposite n x)))).

(** The corner at which a dart starts, lifted to the chart of its triangle. *)
Definition corner (x : N) : C := act (label_of x) (to_C (place (vertex_at n (start n x)))).

Definition triangles_are_counterclockwise : Prop :=
  forall t, (t < size (triangles d))%N ->
    in_plane (corner (3 * t)) /\ in_plane (corner (3 * t + 1)) /\ in_plane (corner (3 * t + 2)) /\
    counterclockwise (corner (3 * t)) (corner (3 * t + 1)) (corner (3 * t + 2)).

(** * Sections 5 to 7: Delaunay, covering, packing *)

(** The corner of the neighbour that is not on the edge of x, in the chart of the triangle of x. *)
Definition far_corner (x : N) : C :=
  act (compose (label_of x) (inverse (label_of (next (opposite n x))))) (corner (previous (opposite n x))).

(** Im [(z3 − z1)(z2 − z0)·conj((z3 − z0)(z2 − z1))], which has the sign of the imaginary part of the cross-ratio. *)
Definition cross_ratio_sign (z0 z1 z2 z3 : C) : R :=
  Im (Cmul (Cmul (Csub z3 z1) (Csub z2 z0)) (Cconj (Cmul (Csub z3 z0) (Csub z2 z1)))).

Definition edges_are_delaunay : Prop :=
  forall x, is_edge x -> cross_ratio_sign (corner x) (far_corner x) (corner (next x)) (corner (previous x)) <= 0.

Definition epsilon : R := IZR (epsilon_num d) / IZR (epsilon_den d).

(** Every triangle has a circumcircle, of radius at most ε. *)
Definition circumradii_are_small : Prop :=
  forall t, (t < size (triangles d))%N -> exists centre radius,
    in_plane centre /\ radius <= epsilon /\
    distance centre (corner (3 * t)) = radius /\ distance centre (corner (3 * t + 1)) = radius /\
    distance centre (corner (3 * t + 2)) = radius.

(** Every edge between different vertices is at least ε long. *)
Definition edges_are_long : Prop :=
  forall x, is_edge x -> start n x <> start n (next x) -> epsilon <= distance (corner x) (corner (next x)).

End Statement.

(** The hypotheses of Theorem 1. *)
Definition statement (d : document) : Prop :=
  exists partner crossing cycles genus,
    let n := net_of d partner in
    0 < epsilon d /\
    is_surface d n crossing cycles genus /\ is_map d n genus /\
    labels_fit d n /\ edges_are_glued d n crossing /\ triangles_are_counterclockwise d n crossing /\
    edges_are_delaunay d n crossing /\ circumradii_are_small d n crossing /\ edges_are_long d n crossing.
