(** The lifted triangles of a document, along all words to the tile of triangle 0, satisfy the hypotheses of Tiling.v,
    except for two that are assumed: if they are locally finite and no vertex lies in a triangle but at a corner, then
    [check d = true] proves an ε-net. *)

From Coq Require Import ZArith NArith Reals List Bool Lia Lra Psatz.
From Epsnet Require Import Document Statement Plane Integers Convex Bounds Circle Geometry Walk Surface Tiling.
Require Import Epsnet.Theorem.
Import ListNotations.
Open Scope R_scope.
Ltac Zify.zify_post_hook ::= Z.to_euclidean_division_equations.

(** * Isometries *)

Lemma same_compose_l : forall f, norm f <> 0 -> same (compose (inverse f) f) identity.
Proof.
  intros f H. exists (norm f). split; auto. unfold compose, inverse, identity, norm in *.
  split; apply C_eq; coordinates; ring.
Qed.

Lemma proper_nonzero : forall f, proper f -> norm f <> 0.
Proof. intros f H. apply proper_norm in H. lra. Qed.

Lemma act_inverse : forall f z, proper f -> in_plane z -> act (inverse f) (act f z) = z.
Proof.
  intros f z Hf Hz. rewrite <- act_compose; auto using proper_inverse.
  rewrite (same_act _ identity); auto using act_identity, proper_compose, proper_inverse.
  apply same_compose_l. now apply proper_nonzero.
Qed.

Lemma act_inverse_r : forall f z, proper f -> in_plane z -> act f (act (inverse f) z) = z.
Proof.
  intros f z Hf Hz. rewrite <- act_compose; auto using proper_inverse.
  rewrite (same_act _ identity); auto using act_identity, proper_compose, proper_inverse.
  apply same_compose_inverse. now apply proper_nonzero.
Qed.

(** The vector of the image of a point. *)
Definition lorentz (f : isometry) (u : vector) : vector :=
  let p := Re (a f) in let q := Im (a f) in let r := Re (b f) in let s := Im (b f) in
  Vector ((p * p - q * q + r * r - s * s) * vx u + 2 * (r * s - p * q) * vy u + 2 * (p * r - q * s) * vt u)
         (2 * (p * q + r * s) * vx u + (p * p - q * q - r * r + s * s) * vy u + 2 * (p * s + q * r) * vt u)
         (2 * (p * r + q * s) * vx u + 2 * (p * s - q * r) * vy u + (p * p + q * q + r * r + s * s) * vt u).

Lemma volume_lorentz : forall f u v w, volume (lorentz f u) (lorentz f v) (lorentz f w) =
  norm f * norm f * norm f * volume u v w.
Proof.
  intros [[p q] [r s]] [x y t] [x' y' t'] [x'' y'' t'']. unfold volume, lorentz, norm. coordinates. ring.
Qed.

Lemma lift_act : forall f z, proper f -> in_plane z ->
  let u := lorentz f (lift z) in lift (act f z) = Vector (vx u / norm f) (vy u / norm f) (vt u / norm f).
Proof.
  intros f z Hf Hz u. pose proof (denominator_nonzero f z Hf Hz) as D. apply abs2_pos in D.
  pose proof (abs2_denominator f z) as E. apply proper_norm in Hf. unfold in_plane in Hz.
  set (k := Cadd (Cmul (a f) z) (b f)) in *. set (m := abs2 (denominator f z)) in *.
  assert (0 < norm f * (1 - abs2 z)) as P by (apply Rmult_lt_0_compat; lra).
  set (h := Cmul k (Cconj (denominator f z))).
  assert (act f z = (Re h / m, Im h / m)) as A.
  { unfold act. fold k (denominator f z). unfold Cdiv, Cinv. fold m. unfold h. apply C_eq; coordinates; field; lra. }
  assert (abs2 (act f z) = abs2 k / m) as B.
  { rewrite A. unfold abs2 at 1. cbn [Re Im fst snd].
    replace (Re h / m * (Re h / m) + Im h / m * (Im h / m)) with (abs2 h / (m * m)) by (unfold abs2; field; lra).
    unfold h. rewrite abs2_mul. replace (abs2 (Cconj (denominator f z))) with m by (unfold m; coordinates; ring).
    field. lra. }
  assert (m - abs2 k <> 0) as M by lra.
  assert (1 - abs2 k / m <> 0) as M'.
  { intro Q. apply M. replace (m - abs2 k) with ((1 - abs2 k / m) * m) by (field; lra). rewrite Q. ring. }
  assert (vx u * (1 - abs2 z) = 2 * Re h /\ vy u * (1 - abs2 z) = 2 * Im h /\ vt u * (1 - abs2 z) = m + abs2 k)
    as [X [Y T]].
  { unfold u, lorentz, lift. cbn [vx vy vt]. unfold h, m, k, denominator.
    destruct f as [[p q] [r s]], z as [x y]. coordinates. repeat split; field; lra. }
  unfold lift. rewrite B, A. clear B A.
  change (Re (Re h / m, Im h / m)) with (Re h / m). change (Im (Re h / m, Im h / m)) with (Im h / m).
  assert (forall g, g / norm f = g * (1 - abs2 z) / (m - abs2 k)) as F by (intros; rewrite E; field; lra).
  rewrite !F, X, Y, T. f_equal; field; repeat split; lra.
Qed.

Lemma act_counterclockwise : forall f u v w, proper f -> in_plane u -> in_plane v -> in_plane w ->
  counterclockwise u v w -> counterclockwise (act f u) (act f v) (act f w).
Proof.
  intros f u v w Hf Hu Hv Hw H. apply counterclockwise_volume; auto using act_in_plane.
  apply counterclockwise_volume in H; auto. rewrite !lift_act by auto. cbv zeta.
  apply proper_norm in Hf. pose proof (volume_lorentz f (lift u) (lift v) (lift w)) as V.
  set (u' := lorentz f (lift u)) in *. set (v' := lorentz f (lift v)) in *. set (w' := lorentz f (lift w)) in *.
  replace (volume (Vector (vx u' / norm f) (vy u' / norm f) (vt u' / norm f))
    (Vector (vx v' / norm f) (vy v' / norm f) (vt v' / norm f))
    (Vector (vx w' / norm f) (vy w' / norm f) (vt w' / norm f))) with (volume u' v' w' / (norm f * norm f * norm f))
    by (unfold volume; cbn [vx vy vt]; field; lra).
  rewrite V. replace (norm f * norm f * norm f * volume (lift u) (lift v) (lift w) / (norm f * norm f * norm f))
    with (volume (lift u) (lift v) (lift w)) by (field; lra).
  auto.
Qed.

Lemma act_difference : forall f z w, proper f -> in_plane z -> in_plane w -> Csub (act f z) (act f w) =
  Cmul (Cmul (norm f, 0) (Csub z w)) (Cinv (Cmul (denominator f z) (denominator f w))).
Proof.
  intros f z w Hf Hz Hw.
  pose proof (denominator_nonzero f z Hf Hz) as Dz. pose proof (denominator_nonzero f w Hf Hw) as Dw.
  assert ((norm f, 0) = Csub (Cmul (a f) (Cconj (a f))) (Cmul (b f) (Cconj (b f)))) as ->
    by (unfold norm; apply C_eq; coordinates; ring).
  unfold act, denominator in *. field. auto.
Qed.

Lemma act_cross_ratio : forall f z0 z1 z2 z3, proper f ->
  in_plane z0 -> in_plane z1 -> in_plane z2 -> in_plane z3 ->
  cross_ratio_sign z0 z1 z2 z3 <= 0 -> cross_ratio_sign (act f z0) (act f z1) (act f z2) (act f z3) <= 0.
Proof.
  intros f z0 z1 z2 z3 Hf H0 H1 H2 H3 J. unfold cross_ratio_sign in *. rewrite !act_difference by auto.
  pose proof (denominator_nonzero f z0 Hf H0) as D0. pose proof (denominator_nonzero f z1 Hf H1) as D1.
  pose proof (denominator_nonzero f z2 Hf H2) as D2. pose proof (denominator_nonzero f z3 Hf H3) as D3.
  apply proper_norm in Hf. set (n := norm f) in *.
  set (d0 := denominator f z0) in *. set (d1 := denominator f z1) in *. set (d2 := denominator f z2) in *.
  set (d3 := denominator f z3) in *.
  set (j := Cmul (Cmul (Csub z3 z1) (Csub z2 z0)) (Cconj (Cmul (Csub z3 z0) (Csub z2 z1)))) in *.
  assert (forall x y, x <> C0 -> y <> C0 -> Cmul x y <> C0) as NZ.
  { intros x y X Y. apply abs2_nonzero. rewrite abs2_mul. apply abs2_pos in X, Y. nra. }
  set (e := Cinv (Cmul (Cmul d3 d1) (Cmul d2 d0))).
  set (e' := Cinv (Cmul (Cmul d3 d0) (Cmul d2 d1))).
  assert (e' = e) as Ee by (unfold e, e'; f_equal; ring).
  match goal with |- Im ?x <= 0 => assert (x = Cmul (n * n * n * n * abs2 e, 0) j) as -> end.
  { transitivity (Cmul (Cmul (Cmul (Cmul (n, 0) (n, 0)) (Cmul (Cconj (n, 0)) (Cconj (n, 0)))) (Cmul e (Cconj e'))) j).
    - unfold j. rewrite !conj_mul. unfold e, e'.
      replace (Cinv (Cmul (Cmul d3 d1) (Cmul d2 d0))) with (Cmul (Cinv (Cmul d3 d1)) (Cinv (Cmul d2 d0)))
        by (field; auto).
      replace (Cinv (Cmul (Cmul d3 d0) (Cmul d2 d1))) with (Cmul (Cinv (Cmul d3 d0)) (Cinv (Cmul d2 d1)))
        by (field; auto).
      rewrite !conj_mul. ring.
    - rewrite Ee. replace (Cmul e (Cconj e)) with ((abs2 e, 0) : C) by (apply C_eq; coordinates; ring).
      f_equal. apply C_eq; coordinates; ring. }
  replace (Im (Cmul (n * n * n * n * abs2 e, 0) j)) with (n * n * n * n * abs2 e * Im j) by (coordinates; ring).
  assert (0 <= n * n * n * n * abs2 e) as P.
  { apply Rmult_le_pos; [|apply abs2_nonneg]. repeat apply Rmult_le_pos; lra. }
  nra.
Qed.

Lemma cross_ratio_turned : forall z0 z1 z2 z3, cross_ratio_sign z2 z3 z0 z1 = cross_ratio_sign z0 z1 z2 z3.
Proof. intros. unfold cross_ratio_sign. coordinates. ring. Qed.

(** * Lifted triangles *)

Section Lifts.
Variable d : document.
Variable pairing : N -> N.
Let n := net_of d pairing.
Variable crossing : N -> isometry.
Hypothesis crossings_proper : forall s, (s < side_count d)%N -> proper (crossing s).
Hypothesis paired : darts_are_paired d n.
Hypothesis starts : forall x, (x < dart_count d)%N -> (start n x < size (vertices d))%N.
Hypothesis fit : labels_fit d n.
Hypothesis glued : edges_are_glued d n crossing.
Hypothesis left : triangles_are_counterclockwise d n crossing.
Hypothesis edges_delaunay : edges_are_delaunay d n crossing.
Hypothesis small : circumradii_are_small d n crossing.
Hypothesis long : edges_are_long d n crossing.

(** The maps from the disk of a tile to that of another by crossing sides, in both directions. *)
Inductive develops : N -> N -> isometry -> Prop :=
| stay : forall t, develops t t identity
| cross : forall s, (s < side_count d)%N -> develops (tile_of n s) (tile_of n (partner n s)) (crossing s)
| go : forall t t' t'' f g, develops t t' f -> develops t' t'' g -> develops t t'' (compose g f)
| back : forall t t' f, develops t t' f -> develops t' t (inverse f).

(** The chart of the triangle of a dart, and its tile. *)
Definition home (x : N) : N := chart_of_start n (3 * (x / 3)).
Definition home_tile (x : N) : N := tile_of_chart (chart_at n (home x)).

(** The plane is the disk of the tile of triangle 0. A triangle is lifted from its chart to its tile, and on to this. *)
Definition root : N := home_tile 0.
Definition lifted (p q r : C) : Prop := exists x h, (x < dart_count d)%N /\ develops (home_tile x) root h /\
  let f := compose h (frame n (home x)) in
  p = act f (corner n crossing x) /\ q = act f (corner n crossing (next x)) /\
  r = act f (corner n crossing (previous x)).

(** To lie over the same point of the surface. *)
Definition same_point (u v : C) : Prop := in_plane u /\ exists g, develops root root g /\ act g u = v.

Lemma develops_proper : forall t t' f, develops t t' f -> proper f.
Proof. intros t t' f H. induction H; auto using proper_identity, proper_compose, proper_inverse. Qed.

Lemma leads_develops : forall w t last, leads d n t w last -> develops t last (word_value crossing w).
Proof.
  induction w as [|s w IH]; intros t last H; simpl in H.
  - subst. apply stay.
  - destruct H as [H1 [<- H2]]. simpl. eapply go; [apply cross; auto|auto].
Qed.

Lemma next_range : forall x, (x < dart_count d)%N -> (next x < dart_count d)%N.
Proof. intros x H. unfold next, dart_count in *. destruct (N.eqb_spec (x mod 3) 2); lia. Qed.
Lemma previous_range : forall x, (x < dart_count d)%N -> (previous x < dart_count d)%N.
Proof. intros x H. unfold previous, dart_count in *. destruct (N.eqb_spec (x mod 3) 0); lia. Qed.
Lemma dart_parts : forall x, exists t, (x = 3 * t \/ x = 3 * t + 1 \/ x = 3 * t + 2)%N.
Proof. intros x. exists (x / 3)%N. lia. Qed.
Lemma dart_triangle : forall t i, (i < 3)%N -> ((3 * t + i) / 3 = t)%N.
Proof. intros t i H. symmetry. apply N.div_unique with i; lia. Qed.
Lemma dart_remainder : forall t i, (i < 3)%N -> ((3 * t + i) mod 3 = i)%N.
Proof. intros t i H. symmetry. apply N.mod_unique with t; lia. Qed.
Lemma next_of : forall t, next (3 * t + 0)%N = (3 * t + 1)%N /\ next (3 * t + 1)%N = (3 * t + 2)%N /\
  next (3 * t + 2)%N = (3 * t + 0)%N.
Proof. intros t. unfold next. rewrite !dart_remainder by lia. cbn [N.eqb Pos.eqb]. lia. Qed.
Lemma previous_of : forall t, previous (3 * t + 0)%N = (3 * t + 2)%N /\ previous (3 * t + 1)%N = (3 * t + 0)%N /\
  previous (3 * t + 2)%N = (3 * t + 1)%N.
Proof. intros t. unfold previous. rewrite !dart_remainder by lia. cbn [N.eqb Pos.eqb]. lia. Qed.

Lemma dart_cases : forall P : N -> Prop, (forall t, P (3 * t + 0)%N) -> (forall t, P (3 * t + 1)%N) ->
  (forall t, P (3 * t + 2)%N) -> forall x, P x.
Proof.
  intros P H0 H1 H2 x. destruct (dart_parts x) as [t [->|[->| ->]]]; auto. rewrite <- (N.add_0_r (3 * t)). apply H0.
Qed.

Lemma next_facts : forall x, (next x / 3 = x / 3)%N /\ (previous x / 3 = x / 3)%N /\ next (next x) = previous x /\
  previous (next x) = x.
Proof.
  apply dart_cases; intro t; destruct (next_of t) as [E1 [E2 E3]]; destruct (previous_of t) as [F1 [F2 F3]];
    rewrite ?E1, ?E2, ?E3, ?F1, ?F2, ?F3, ?E1, ?E2, ?E3, ?F1, ?F2, ?F3, ?dart_triangle by lia; auto.
Qed.

Lemma home_next : forall x, home (next x) = home x.
Proof. intros x. unfold home. destruct (next_facts x) as [E _]. now rewrite E. Qed.

Lemma vertex_good : forall x, (x < dart_count d)%N ->
  (chart_of_start n x < size (charts d))%N /\ in_plane (to_C (place (vertex_at n (start n x)))).
Proof. intros x Hx. destruct fit as [_ [V _]]. apply V. unfold n. cbn. now apply in_at_index, starts. Qed.

Lemma frame_proper : forall c, (c < size (charts d))%N -> proper (frame n c).
Proof.
  intros c H. apply proper_translation. destruct fit as [S _]. apply S. unfold n. cbn. now apply in_at_index.
Qed.

Lemma first_range : forall x, (x < dart_count d)%N -> (3 * (x / 3) < dart_count d)%N.
Proof. intros x H. unfold dart_count in *. lia. Qed.

Lemma home_proper : forall x, (x < dart_count d)%N -> proper (frame n (home x)).
Proof. intros x H. apply frame_proper. unfold home. now apply vertex_good, first_range. Qed.

(** A label is a way from the chart of a vertex to that of the triangle. *)
Lemma label_develops : forall x, (x < dart_count d)%N -> proper (label_of n crossing x) /\
  exists f, develops (tile_of_chart (chart_at n (chart_of_start n x))) (home_tile x) f /\
    forall z, in_plane z ->
      act (frame n (home x)) (act (label_of n crossing x) z) = act f (act (frame n (chart_of_start n x)) z).
Proof.
  intros x Hx. destruct fit as [_ [_ [W X]]]. specialize (X x Hx).
  destruct (vertex_good x Hx) as [Hc _]. pose proof (frame_proper _ Hc) as Fs. pose proof (home_proper x Hx) as Fh.
  unfold label_of. destruct (N.eqb_spec (label_number n x) 0) as [E|E].
  - split; [apply proper_identity|]. exists identity. split.
    + unfold home_tile, home. rewrite <- X. apply stay.
    + intros z Hz. rewrite !act_identity. unfold home. now rewrite X.
  - destruct X as [X1 [X2 X3]]. set (l := label_at n (label_number n x - 1)) in *.
    assert (In l (labels d)) as I by (apply (in_at_index _ (labels d) no_label (label_number n x - 1)); lia).
    destruct (W l I) as [_ [_ L]]. rewrite X2, X3 in L. apply leads_develops in L.
    pose proof (develops_proper _ _ _ L) as P. fold (home x) in X3, L. unfold label_value. rewrite X2, X3.
    split; [auto using proper_compose, proper_inverse|].
    exists (word_value crossing (word l)). split; [exact L|]. intros z Hz.
    rewrite !act_compose; auto using proper_compose, proper_inverse, act_in_plane.
    rewrite act_inverse_r; auto using act_in_plane.
Qed.

Lemma corner_in_plane : forall x, (x < dart_count d)%N -> in_plane (corner n crossing x).
Proof.
  intros x Hx. unfold corner. apply act_in_plane; [now apply label_develops|now apply vertex_good].
Qed.

Lemma place_of_corner : forall x, (x < dart_count d)%N ->
  act (inverse (label_of n crossing x)) (corner n crossing x) = to_C (place (vertex_at n (start n x))).
Proof. intros x Hx. apply act_inverse; [now apply label_develops|now apply vertex_good]. Qed.

(** From the chart of the triangle beyond the edge of x. *)
Definition beyond (x : N) (z : C) : C :=
  act (label_of n crossing x) (act (inverse (label_of n crossing (next (opposite n x)))) z).

Lemma opposite_range : forall x, (x < dart_count d)%N -> (opposite n x < dart_count d)%N.
Proof. intros x Hx. now apply paired. Qed.

Lemma beyond_start : forall x, (x < dart_count d)%N ->
  beyond x (corner n crossing (next (opposite n x))) = corner n crossing x.
Proof.
  intros x Hx. unfold beyond. rewrite place_of_corner by auto using next_range, opposite_range.
  destruct (paired x Hx) as [_ [_ [_ E]]]. now rewrite <- E.
Qed.

(** The equation of labels, for both darts of an edge. *)
Lemma beyond_glued : forall x z, (x < dart_count d)%N -> (opposite n x < x)%N -> in_plane z ->
  beyond x (beyond (opposite n x) z) = z.
Proof.
  intros x z Hx L Hz. destruct (paired x Hx) as [Ho [_ [E _]]]. set (o := opposite n x) in *.
  assert (is_edge d n o) as Eo by (split; [auto|now rewrite E]).
  pose proof (glued o Eo z Hz) as G. rewrite E in G.
  destruct (label_develops x Hx) as [P1 _]. destruct (label_develops o Ho) as [P2 _].
  destruct (label_develops _ (next_range _ Hx)) as [P3 _]. destruct (label_develops _ (next_range _ Ho)) as [P4 _].
  rewrite !act_compose in G by auto using proper_inverse.
  unfold beyond. fold o. rewrite E, G. rewrite act_inverse by auto using act_in_plane, proper_inverse.
  now rewrite act_inverse_r.
Qed.

Lemma beyond_end : forall x, (x < dart_count d)%N ->
  beyond x (corner n crossing (opposite n x)) = corner n crossing (next x).
Proof.
  intros x Hx. destruct (paired x Hx) as [Ho [D [E _]]]. destruct (paired _ Ho) as [_ [_ [_ E']]]. rewrite E in E'.
  destruct (N.lt_total x (opposite n x)) as [L|[L|L]]; [|congruence|].
  - assert (is_edge d n x) as Ex by now split.
    pose proof (glued x Ex _ (corner_in_plane _ Ho)) as G.
    destruct (label_develops x Hx) as [P1 _]. destruct (label_develops _ Ho) as [P2 _].
    destruct (label_develops _ (next_range _ Hx)) as [P3 _].
    destruct (label_develops _ (next_range _ Ho)) as [P4 _].
    rewrite !act_compose in G by auto using proper_inverse, corner_in_plane.
    unfold beyond. rewrite G, place_of_corner by auto. unfold corner. now rewrite E'.
  - rewrite <- (beyond_glued x (corner n crossing (next x))) by auto using corner_in_plane, next_range.
    f_equal. rewrite <- (beyond_start (opposite n x)) by auto. now rewrite E.
Qed.

Lemma beyond_delaunay : forall x, (x < dart_count d)%N -> cross_ratio_sign (corner n crossing x)
  (beyond x (corner n crossing (previous (opposite n x)))) (corner n crossing (next x)) (corner n crossing (previous x))
  <= 0.
Proof.
  intros x Hx. destruct (paired x Hx) as [Ho [D [E _]]].
  assert (forall y, (y < dart_count d)%N -> proper (label_of n crossing y)) as P by (intros; now apply label_develops).
  assert (forall y z, (y < dart_count d)%N -> in_plane z -> beyond y z =
    act (compose (label_of n crossing y) (inverse (label_of n crossing (next (opposite n y))))) z) as B.
  { intros. unfold beyond. rewrite act_compose; auto using proper_inverse, next_range, opposite_range. }
  destruct (N.lt_total x (opposite n x)) as [L|[L|L]]; [|congruence|].
  - assert (is_edge d n x) as Ex by now split. pose proof (edges_delaunay x Ex) as J. unfold far_corner in J.
    rewrite B by auto using corner_in_plane, previous_range. exact J.
  - assert (is_edge d n (opposite n x)) as Eo by (split; [auto|now rewrite E]).
    pose proof (edges_delaunay _ Eo) as J. unfold far_corner in J. rewrite E in J.
    assert (forall z, in_plane z -> beyond (opposite n x) z =
      act (compose (label_of n crossing (opposite n x)) (inverse (label_of n crossing (next x)))) z) as Bo.
    { intros. rewrite B by auto. now rewrite E. }
    rewrite <- Bo in J by auto using corner_in_plane, previous_range.
    assert (in_plane (beyond (opposite n x) (corner n crossing (previous x)))) as Pf.
    { rewrite Bo by auto using corner_in_plane, previous_range.
      auto 10 using act_in_plane, proper_compose, proper_inverse, next_range, corner_in_plane, previous_range. }
    apply (act_cross_ratio (compose (label_of n crossing x) (inverse (label_of n crossing (next (opposite n x))))))
      in J; auto 10 using corner_in_plane, previous_range, next_range, proper_compose, proper_inverse.
    rewrite <- !B in J by auto using corner_in_plane, previous_range, next_range.
    rewrite beyond_glued, beyond_start, beyond_end in J by auto using corner_in_plane, previous_range.
    now rewrite <- cross_ratio_turned.
Qed.

(** The triangle beyond, in the plane. *)
Lemma beyond_lifted : forall x h, (x < dart_count d)%N -> develops (home_tile x) root h ->
  let o := opposite n x in exists h', develops (home_tile o) root h' /\
  forall z, in_plane z -> act (compose h' (frame n (home o))) z = act (compose h (frame n (home x))) (beyond x z).
Proof.
  intros x h Hx Hh o. destruct (paired x Hx) as [Ho [_ [_ Es]]]. fold o in Ho, Es.
  destruct (label_develops x Hx) as [P1 [f1 [D1 E1]]].
  destruct (label_develops _ (next_range _ Ho)) as [P2 [f2 [D2 E2]]].
  unfold home_tile in D2. rewrite home_next in D2, E2. fold (home_tile o) in D2.
  assert (chart_of_start n (next o) = chart_of_start n x) as Ec by (unfold chart_of_start; now rewrite Es).
  rewrite Ec in D2, E2.
  pose proof (develops_proper _ _ _ D1) as Q1. pose proof (develops_proper _ _ _ D2) as Q2.
  pose proof (develops_proper _ _ _ Hh) as Qh. pose proof (home_proper x Hx) as Fx. pose proof (home_proper o Ho) as Fo.
  assert (proper (frame n (chart_of_start n x))) as Fs by now apply frame_proper, vertex_good.
  exists (compose h (compose f1 (inverse f2))). split.
  { eapply go; [|exact Hh]. eapply go; [apply back; exact D2|exact D1]. }
  intros z Hz. set (y := act (inverse (label_of n crossing (next o))) z).
  assert (in_plane y) as Hy by (apply act_in_plane; auto using proper_inverse).
  assert (act (label_of n crossing (next o)) y = z) as Ez by now apply act_inverse_r.
  pose proof (E2 y Hy) as G. rewrite Ez in G.
  unfold beyond. fold o. fold y.
  rewrite !act_compose by auto using proper_compose, proper_inverse, act_in_plane.
  rewrite E1 by auto. rewrite G. rewrite act_inverse by auto using act_in_plane. reflexivity.
Qed.

Lemma lifted_turned : forall p q r, lifted p q r -> lifted q r p.
Proof.
  intros p q r [x [h [Hx [Hh [E1 [E2 E3]]]]]]. destruct (next_facts x) as [_ [_ [N1 N2]]].
  exists (next x), h. unfold home_tile. rewrite home_next, N1, N2. split; [now apply next_range|]. auto.
Qed.

Lemma corners_left : forall x, (x < dart_count d)%N ->
  counterclockwise (corner n crossing x) (corner n crossing (next x)) (corner n crossing (previous x)).
Proof.
  intro x. pattern x. apply dart_cases; clear x; intros t Ht; unfold dart_count in Ht;
    destruct (next_of t) as [E1 [E2 E3]]; destruct (previous_of t) as [F1 [F2 F3]];
    rewrite ?E1, ?E2, ?E3, ?F1, ?F2, ?F3, ?N.add_0_r;
    (destruct (left t) as [_ [_ [_ L]]]; [lia|]); unfold counterclockwise in *; auto.
  - now rewrite <- det_turn.
  - now rewrite det_turn.
Qed.

Lemma lift_proper : forall x h, (x < dart_count d)%N -> develops (home_tile x) root h ->
  proper (compose h (frame n (home x))).
Proof. intros x h Hx Hh. apply proper_compose; [eapply develops_proper; eauto|now apply home_proper]. Qed.

Lemma lifted_left : forall p q r, lifted p q r -> in_plane p /\ in_plane q /\ in_plane r /\ counterclockwise p q r.
Proof.
  intros p q r [x [h [Hx [Hh [-> [-> ->]]]]]]. pose proof (lift_proper x h Hx Hh) as P.
  repeat split; auto using act_in_plane, corner_in_plane, next_range, previous_range.
  apply act_counterclockwise; auto using corner_in_plane, next_range, previous_range, corners_left.
Qed.

Lemma beyond_in_plane : forall x z, (x < dart_count d)%N -> in_plane z -> in_plane (beyond x z).
Proof.
  intros x z Hx Hz. unfold beyond.
  destruct (label_develops x Hx) as [P1 _].
  destruct (label_develops _ (next_range _ (opposite_range x Hx))) as [P2 _].
  auto using act_in_plane, proper_inverse.
Qed.

Lemma lifted_neighbours : forall p q r, lifted p q r -> exists s, lifted q p s /\ cross_ratio_sign p s q r <= 0.
Proof.
  intros p q r [x [h [Hx [Hh [-> [-> ->]]]]]]. pose proof (lift_proper x h Hx Hh) as P.
  pose proof (opposite_range x Hx) as Ho.
  destruct (beyond_lifted x h Hx Hh) as [h' [Hh' E]].
  exists (act (compose h (frame n (home x))) (beyond x (corner n crossing (previous (opposite n x))))). split.
  - exists (opposite n x), h'. split; [auto|]. split; [auto|]. cbv zeta.
    rewrite !E by auto using corner_in_plane, next_range, previous_range.
    now rewrite beyond_end, beyond_start.
  - apply act_cross_ratio; auto using beyond_in_plane, corner_in_plane, next_range, previous_range.
    now apply beyond_delaunay.
Qed.

Lemma corners_small : forall x, (x < dart_count d)%N -> exists c radius, in_plane c /\ radius <= epsilon d /\
  distance c (corner n crossing x) = radius /\ distance c (corner n crossing (next x)) = radius /\
  distance c (corner n crossing (previous x)) = radius.
Proof.
  intro x. pattern x. apply dart_cases; clear x; intros t Ht; unfold dart_count in Ht;
    destruct (next_of t) as [E1 [E2 E3]]; destruct (previous_of t) as [F1 [F2 F3]];
    rewrite ?E1, ?E2, ?E3, ?F1, ?F2, ?F3, ?N.add_0_r;
    (destruct (small t) as [c [radius [H1 [H2 [H3 [H4 H5]]]]]]; [lia|]); exists c, radius; auto 6.
Qed.

Lemma lifted_small : forall p q r, lifted p q r -> exists c radius, in_plane c /\ radius <= epsilon d /\
  distance c p = radius /\ distance c q = radius /\ distance c r = radius.
Proof.
  intros p q r [x [h [Hx [Hh [-> [-> ->]]]]]]. pose proof (lift_proper x h Hx Hh) as P.
  destruct (corners_small x Hx) as [c [radius [H1 [H2 [H3 [H4 H5]]]]]].
  exists (act (compose h (frame n (home x))) c), radius. split; [now apply act_in_plane|]. split; auto.
  rewrite !isometries_preserve_distance; auto using corner_in_plane, next_range, previous_range.
Qed.

Lemma same_refl : forall u, is_vertex lifted u -> same_point u u.
Proof.
  intros u [q [r L]]. split; [now apply lifted_left in L|]. exists identity. split; [apply stay|apply act_identity].
Qed.

Lemma same_sym : forall u v, same_point u v -> same_point v u.
Proof.
  intros u v [Hu [g [G <-]]]. pose proof (develops_proper _ _ _ G) as P. split; [now apply act_in_plane|].
  exists (inverse g). split; [now apply back|now apply act_inverse].
Qed.

Lemma same_trans : forall u v w, same_point u v -> same_point v w -> same_point u w.
Proof.
  intros u v w [Hu [g [G <-]]] [_ [g' [G' <-]]]. split; auto. exists (compose g' g). split; [now apply go with root|].
  apply act_compose; auto; eapply develops_proper; eauto.
Qed.

Lemma moved : forall u v, same_point u v -> exists g, proper g /\ act g u = v /\
  forall p q r, lifted p q r -> lifted (act g p) (act g q) (act g r) /\ same_point p (act g p).
Proof.
  intros u v [Hu [g [G <-]]]. pose proof (develops_proper _ _ _ G) as P. exists g. split; auto. split; auto.
  intros p q r L. split.
  - destruct L as [x [h [Hx [Hh [-> [-> ->]]]]]]. pose proof (lift_proper x h Hx Hh) as Q.
    exists x, (compose g h). split; auto. split; [now apply go with root|]. cbv zeta. rewrite compose_assoc.
    rewrite !(act_compose g) by auto using corner_in_plane, next_range, previous_range. auto.
  - split; [now apply lifted_left in L|]. eauto.
Qed.

Lemma edge_long : forall x h, (x < dart_count d)%N -> (x < opposite n x)%N -> develops (home_tile x) root h ->
  start n x <> start n (next x) -> let f := compose h (frame n (home x)) in
  epsilon d <= distance (act f (corner n crossing x)) (act f (corner n crossing (next x))).
Proof.
  intros x h Hx L Hh D f. pose proof (lift_proper x h Hx Hh) as P. fold f in P.
  rewrite isometries_preserve_distance by auto using corner_in_plane, next_range.
  apply long; auto. now split.
Qed.

Lemma lifted_long : forall p q r, lifted p q r -> same_point p q \/ epsilon d <= distance p q.
Proof.
  intros p q r [x [h [Hx [Hh [-> [-> ->]]]]]]. pose proof (lift_proper x h Hx Hh) as P.
  pose proof (next_range x Hx) as Hn.
  destruct (N.eq_dec (start n x) (start n (next x))) as [E|E].
  - left. split; [auto using act_in_plane, corner_in_plane|].
    destruct (label_develops x Hx) as [P1 [f1 [D1 E1]]]. destruct (label_develops _ Hn) as [P2 [f2 [D2 E2]]].
    assert (chart_of_start n (next x) = chart_of_start n x) as Ec by (unfold chart_of_start; now rewrite E).
    unfold home_tile in D2. rewrite home_next in D2, E2. rewrite Ec in D2, E2. fold (home_tile x) in D2.
    pose proof (develops_proper _ _ _ D1) as Q1. pose proof (develops_proper _ _ _ D2) as Q2.
    pose proof (develops_proper _ _ _ Hh) as Qh. pose proof (home_proper x Hx) as Fx.
    destruct (vertex_good x Hx) as [Hc Hv]. pose proof (frame_proper _ Hc) as Fs.
    exists (compose (compose h f2) (inverse (compose h f1))). split.
    + eapply go; [apply back|]; eapply go; eauto.
    + unfold corner. rewrite <- E. set (v := to_C (place (vertex_at n (start n x)))) in *.
      assert (forall l f, proper l -> proper f -> act (frame n (home x)) (act l v) =
        act f (act (frame n (chart_of_start n x)) v) ->
        act (compose h (frame n (home x))) (act l v) = act (compose h f) (act (frame n (chart_of_start n x)) v)) as A.
      { intros l f Hl Hf G.
        rewrite (act_compose h (frame n (home x))), (act_compose h f) by auto using act_in_plane. now rewrite G. }
      rewrite (A _ f1), (A _ f2) by auto.
      assert (proper (compose h f1)) as R1 by auto using proper_compose.
      assert (proper (compose h f2)) as R2 by auto using proper_compose.
      rewrite (act_compose (compose h f2)) by auto using proper_inverse, act_in_plane.
      now rewrite act_inverse by auto using act_in_plane.
  - right. destruct (paired x Hx) as [Ho [D [Eo Es]]]. destruct (paired _ Ho) as [_ [_ [_ Eo']]]. rewrite Eo in Eo'.
    destruct (N.lt_total x (opposite n x)) as [L|[L|L]]; [now apply edge_long|congruence|].
    destruct (beyond_lifted x h Hx Hh) as [h' [Hh' B]].
    rewrite <- (beyond_start x), <- (beyond_end x) by auto.
    rewrite <- !B by auto using corner_in_plane, next_range. rewrite distance_symmetric.
    apply edge_long; auto; [now rewrite Eo|]. rewrite Eo', <- Es. now apply not_eq_sym.
Qed.
End Lifts.

(** * The theorem *)

(** A smaller disk meets finitely many lifted triangles. *)
Definition locally_finite (lifted : C -> C -> C -> Prop) : Prop := forall k, k < 1 -> exists l, forall p q r z,
  lifted p q r -> in_plane z -> in_triangle z p q r -> abs2 z <= k -> In (p, q, r) l.

(** A lifted vertex in a lifted triangle is one of its corners. *)
Definition vertices_are_corners (lifted : C -> C -> C -> Prop) : Prop := forall p q r v,
  lifted p q r -> is_vertex lifted v -> in_triangle v p q r -> v = p \/ v = q \/ v = r.

(** Parts 3, 4 and 5 of Theorem 1. *)
Definition is_epsilon_net (lifted : C -> C -> C -> Prop) (same_point : C -> C -> Prop) (epsilon : R) : Prop :=
  (forall p q r centre radius v, lifted p q r -> is_vertex lifted v -> in_plane centre ->
     distance centre p = radius -> distance centre q = radius -> distance centre r = radius ->
     radius <= distance centre v) /\
  (forall z, in_plane z -> exists v, is_vertex lifted v /\ distance z v <= epsilon) /\
  (forall u v, is_vertex lifted u -> is_vertex lifted v -> ~ same_point u v -> epsilon <= distance u v).

(** Partners and crossings are those of the surface. *)
Theorem check_proves_net : forall d, Checker.check d = true -> exists partner crossing cycles genus,
  is_surface d (net_of d partner) crossing cycles genus /\ (
  locally_finite (lifted d partner crossing) -> vertices_are_corners (lifted d partner crossing) ->
  is_epsilon_net (lifted d partner crossing) (same_point d partner crossing) (epsilon d)).
Proof.
  intros d H. destruct (check_is_right d H) as [partner [crossing [cycles [genus S]]]]. cbv zeta in S.
  destruct S as [_ [surface [[_ [nonempty [paired [[starts _] _]]]] [labels [glued [left [delaunay [small
    long]]]]]]]].
  pose proof surface as [_ [_ [fit _]]].
  assert (forall s, (s < side_count d)%N -> proper (crossing s)) as proper_crossings by (intros s Hs; now apply fit).
  exists partner, crossing, cycles, genus. split; auto. intros finite corners.
  apply (epsilon_net (lifted d partner crossing)); auto.
  - eapply lifted_turned; eauto.
  - eapply lifted_left; eauto.
  - eapply lifted_neighbours; eauto.
  - eapply lifted_small; eauto.
  - eapply same_refl; eauto.
  - eapply same_sym; eauto.
  - eapply same_trans; eauto.
  - eapply moved; eauto.
  - eapply lifted_long; eauto.
  - do 3 eexists. exists 0%N, identity. split; [unfold dart_count; lia|]. split; [apply stay|]. cbv zeta. auto.
Qed.

Print Assumptions check_proves_net.
