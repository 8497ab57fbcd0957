(** What a net file on rational tiles says, as data (docs/format.md). Nothing in it is proved. *)

From Coq Require Import ZArith NArith List.

(** The point (re + i·im)/den of the complex plane. *)
Record point := Point { re : Z; im : Z; den : Z }.

Record chart := Chart { tile_of_chart : N; centre : point }.

(** The word is a list of side numbers. *)
Record label := Label { from : N; target : N; word : list N }.

Record vertex := Vertex { chart_of : N; place : point }.

(** Vertices, opposite darts, and the label numbers of corners 1 and 2. *)
Record triangle := Triangle { v0 : N; v1 : N; v2 : N; o0 : N; o1 : N; o2 : N; l1 : N; l2 : N }.

(** Side k of tile t is glued to side k' of tile t'. *)
Record row := Row { t_one : N; k_one : N; t_two : N; k_two : N }.

Record document := Document {
  tiles : list (list point);
  gluing : list row;
  epsilon_num : Z;
  epsilon_den : Z;
  charts : list chart;
  labels : list label;
  vertices : list vertex;
  triangles : list triangle }.

Definition origin := Point 0 0 1.
Definition no_chart := Chart 0 origin.
Definition no_label := Label 0 0 nil.
Definition no_vertex := Vertex 0 origin.
Definition no_triangle := Triangle 0 0 0 0 0 0 0 0.

(** Element i of a list, from 0; the second argument if there is none. *)
Definition at_index {A} (l : list A) (nothing : A) (i : N) : A := nth (N.to_nat i) l nothing.

Definition size {A} (l : list A) : N := N.of_nat (length l).

(** Sides of tiles are numbered through all tiles: tile and number in its tile of each. *)
Fixpoint sides_of_tile (t k : N) (tile : list point) : list (N * N) :=
  match tile with
  | nil => nil
  | _ :: tile' => (t, k) :: sides_of_tile t (k + 1) tile'
  end.

Fixpoint sides_from (t : N) (l : list (list point)) : list (N * N) :=
  match l with
  | nil => nil
  | tile :: l' => sides_of_tile t 0 tile ++ sides_from (t + 1) l'
  end.

Definition sides (d : document) : list (N * N) := sides_from 0 (tiles d).

(** What is asked of a document, by index. Side s starts at corner s of all corners of tiles, in the order of
    the file. *)
Record net := Net {
  tile_at : N -> list point;
  corner_at : N -> point;
  side_at : N -> N * N;
  partner : N -> N;  (* the side that a side is glued to *)
  chart_at : N -> chart;
  label_at : N -> label;
  vertex_at : N -> vertex;
  triangle_at : N -> triangle }.

Definition net_of (d : document) (partner : N -> N) : net := {|
  tile_at := at_index (tiles d) nil;
  corner_at := at_index (concat (tiles d)) origin;
  side_at := at_index (sides d) (0, 0)%N;
  partner := partner;
  chart_at := at_index (charts d) no_chart;
  label_at := at_index (labels d) no_label;
  vertex_at := at_index (vertices d) no_vertex;
  triangle_at := at_index (triangles d) no_triangle |}.

Definition tile_of (n : net) (s : N) : N := fst (side_at n s).

(** The sides of the same tile that follow and precede a side. *)
Definition side_after (n : net) (s : N) : N :=
  let (t, k) := side_at n s in (if k + 1 <? size (tile_at n t) then s + 1 else s - k)%N.

Definition side_before (n : net) (s : N) : N :=
  let (t, k) := side_at n s in (if 0 <? k then s - 1 else s + size (tile_at n t) - 1)%N.

Definition side_end (n : net) (s : N) : point := corner_at n (side_after n s).

(** Around a point where corners of tiles meet: from the side that starts at a corner to the one at the next corner. *)
Definition around (n : net) (s : N) : N := side_after n (partner n s).

(** Darts: dart 3t + i leaves corner i of triangle t. *)
Definition next (x : N) : N := (if x mod 3 =? 2 then x - 2 else x + 1)%N.
Definition previous (x : N) : N := (if x mod 3 =? 0 then x + 2 else x - 1)%N.

Definition of_corner {A} (x : N) (zero one two : A) : A :=
  match (x mod 3)%N with 0%N => zero | 1%N => one | _ => two end.

Definition start (n : net) (x : N) : N := let t := triangle_at n (x / 3) in of_corner x (v0 t) (v1 t) (v2 t).
Definition opposite (n : net) (x : N) : N := let t := triangle_at n (x / 3) in of_corner x (o0 t) (o1 t) (o2 t).

(** Label number 0 is the identity, number k > 0 element k - 1 of the list. *)
Definition label_number (n : net) (x : N) : N := let t := triangle_at n (x / 3) in of_corner x 0%N (l1 t) (l2 t).

(** From a dart that leaves a vertex to the next one that leaves it. *)
Definition turn_left (n : net) (x : N) : N := opposite n (previous x).
