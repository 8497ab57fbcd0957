(** Triangles that tile the hyperbolic plane: if every edge is Delaunay, the triangulation is (docs/proof.md, Lemma 4),
    and the corners of triangles cover and pack (Sections 6 and 7). What is assumed are the hypotheses below, of the
    section Tiling; what is proved of them is [epsilon_net], at the end. *)

From Coq Require Import Reals List Lia Lra Psatz Classical.
From Epsnet Require Import Document Statement Plane Bounds Circle Geometry Walk.
Import ListNotations.
Open Scope R_scope.

(** * The triangulation *)

Section Tiling.
(** pqr is a lifted triangle. *)
Variable lifted : C -> C -> C -> Prop.
Definition is_vertex (v : C) : Prop := exists q r, lifted v q r.

Hypothesis turned : forall p q r, lifted p q r -> lifted q r p.
Hypothesis left : forall p q r, lifted p q r ->
  in_plane p /\ in_plane q /\ in_plane r /\ counterclockwise p q r.
(** Across every edge is another lifted triangle, and the edge is Delaunay. *)
Hypothesis neighbours : forall p q r, lifted p q r -> exists s, lifted q p s /\ cross_ratio_sign p s q r <= 0.
(** A smaller disk meets finitely many lifted triangles. *)
Hypothesis locally_finite : forall k, k < 1 -> exists l, forall p q r z,
  lifted p q r -> in_plane z -> in_triangle z p q r -> abs2 z <= k -> In (p, q, r) l.

Lemma lifted_left : forall p q r, lifted p q r -> 0 < volume (lift p) (lift q) (lift r).
Proof. intros p q r H. destruct (left p q r H) as [P [Q [R O]]]. now apply counterclockwise_volume. Qed.

Lemma height_above : forall u v w x, 0 < volume u v w ->
  1 <= height u v w x <-> volume u v w <= volume x v w + volume u x w + volume u v x.
Proof.
  intros u v w x V. unfold height.
  replace (volume x v w + volume u x w + volume u v x) with
    ((volume u v x + volume v w x + volume w u x) / volume u v w * volume u v w)
    by (replace (volume x v w) with (volume v w x) by (unfold volume; ring);
        replace (volume u x w) with (volume w u x) by (unfold volume; ring); field; lra).
  split; intro H.
  - rewrite <- (Rmult_1_l (volume u v w)) at 1. apply Rmult_le_compat_r; lra.
  - apply Rmult_le_reg_r with (volume u v w); lra.
Qed.

Lemma neighbour_high : forall p q r, lifted p q r ->
  exists s, lifted q p s /\ 1 <= height (lift p) (lift q) (lift r) (lift s).
Proof.
  intros p q r H. destruct (neighbours p q r H) as [s [L J]]. exists s. split; auto.
  destruct (left p q r H) as [P [Q [R _]]]. destruct (left q p s L) as [_ [_ [S _]]].
  pose proof (lifted_left p q r H) as V.
  pose proof (cross_ratio_volumes p s q r P S Q R) as E. unfold in_plane in *.
  assert (0 < (1 - abs2 p) * (1 - abs2 s) * ((1 - abs2 q) * (1 - abs2 r))) as M
    by (repeat apply Rmult_lt_0_compat; lra).
  apply height_above; auto. nra.
Qed.

(** The walk to z. *)
Lemma walk : forall z, in_plane z -> forall count l x p q r, (length l <= count)%nat ->
  lifted p q r -> inside (lift p) (lift q) (lift r) x ->
  (forall p q r t, lifted p q r -> 0 <= t < 1 -> inside (lift p) (lift q) (lift r) (between x (lift z) t) ->
     In (p, q, r) l) ->
  (forall p q r, lifted p q r -> In (p, q, r) l -> p <> z -> volume x (lift z) (lift p) <> 0) ->
  exists p' q' r', lifted p' q' r' /\ contains (lift p') (lift q') (lift r') (lift z) /\
    height (lift p') (lift q') (lift r') (lift z) <= height (lift p) (lift q) (lift r) (lift z).
Proof.
  intros z Hz. induction count as [|count IH]; intros l x p0 q0 r0 Hl L0 I0 ahead generic.
  { assert (In (p0, q0, r0) l) as I.
    { apply ahead with 0; auto; [lra|]. replace (between x (lift z) 0) with x; auto.
      destruct x. unfold between, combination. simpl. f_equal; ring. }
    destruct l; [contradiction|simpl in Hl; lia]. }
  destruct (leaves _ _ _ _ (lift z) I0) as [D|[u [v [w [T [N [A B]]]]]]].
  { exists p0, q0, r0. split; auto. split; auto. lra. }
  assert (exists p q r, lifted p q r /\ u = lift p /\ v = lift q /\ w = lift r /\ inside u v w x /\
    height (lift p0) (lift q0) (lift r0) (lift z) = height u v w (lift z)) as [p [q [r [L [-> [-> [-> [I E]]]]]]]].
  { destruct I0 as [I1 [I2 I3]].
    destruct T as [[-> [-> ->]]|[[-> [-> ->]]|[-> [-> ->]]]].
    - exists p0, q0, r0. repeat split; auto.
    - exists q0, r0, p0. repeat split; auto. apply height_turn.
    - exists r0, p0, q0. repeat split; auto. symmetry. apply height_turn. }
  rewrite E. clear E p0 q0 r0 L0 I0 T.
  assert (x = between x (lift z) 0) as X.
  { destruct x. unfold between, combination. simpl. f_equal; ring. }
  assert (In (p, q, r) l) as Ip by (apply ahead with 0; [auto|lra|now rewrite <- X]).
  assert (In (q, r, p) l) as Iq.
  { apply ahead with 0; [auto|lra|rewrite <- X]. destruct I as [I1 [I2 I3]]. repeat split; auto. }
  pose proof (lifted_left p q r L) as V.
  set (u := lift p) in *. set (v := lift q) in *. set (w := lift r) in *. set (y := lift z) in *.
  assert (volume x y u <> 0) as Gu.
  { apply generic with q r; auto. intros ->. fold y in u. unfold u, volume in N. lra. }
  assert (volume x y v <> 0) as Gv.
  { apply generic with r p; auto. intros ->. fold y in v. unfold v, volume in N. lra. }
  assert (volume u v x * volume v w y - volume u v y * volume v w x = volume u v w * volume x y v) as EA
    by (unfold volume; ring).
  assert (volume u v x * volume w u y - volume u v y * volume w u x = - (volume u v w * volume x y u)) as EB
    by (unfold volume; ring).
  assert (volume u v w * volume x y v <> 0) as NA by (apply Rmult_integral_contrapositive; split; [lra|auto]).
  assert (volume u v w * volume x y u <> 0) as NB by (apply Rmult_integral_contrapositive; split; [lra|auto]).
  destruct (neighbour_high p q r L) as [s [Ls H]]. fold u v w in H.
  pose proof (lifted_left q p s Ls) as Vs. fold u v in Vs.
  destruct (step u v w (lift s) x y) as [t [[T0 T1] [In' Out]]]; auto; [lra|lra|].
  pose proof (height_decreases u v w (lift s) y V Vs N H) as Dec.
  destruct (in_split _ _ Ip) as [l1 [l2 El]].
  destruct (IH (l1 ++ l2) (between x y t) q p s) as [p' [q' [r' [L' [C' H']]]]]; auto.
  - rewrite El in Hl. rewrite app_length in *. simpl in Hl. lia.
  - intros p' q' r' t' Lt' [T0' T1'] It'. fold y in It'. rewrite between_again in It'.
    assert (t <= t + t' - t * t' < 1) as [B1 B2] by (split; nra).
    assert (In (p', q', r') l) as J by (apply ahead with (t + t' - t * t'); auto; lra).
    rewrite El in J. apply in_app_or in J. apply in_or_app. destruct J as [J|[J|J]]; auto.
    exfalso. inversion J; subst p' q' r'. fold u v in It'. destruct It' as [It' _].
    specialize (Out (t + t' - t * t')). lra.
  - intros p' q' r' L' J Np. fold y.
    assert (In (p', q', r') l) as J'.
    { rewrite El. apply in_app_or in J. apply in_or_app. destruct J; [left|right; right]; auto. }
    apply (generic p' q' r') in Np; auto. fold y in Np.
    replace (volume (between x y t) y (lift p')) with ((1 - t) * volume x y (lift p'))
      by (unfold volume, between, combination; simpl; ring).
    apply Rmult_integral_contrapositive. split; [lra|auto].
  - exists p', q', r'. split; auto. split; auto. fold y in H'. fold u v in H'. lra.
Qed.

(** The points u + sv + s²w from which the walk to z may meet another corner. *)
Lemma quadratics : forall (l : list (C * C * C)) u v w z, 0 < volume u v w -> in_plane z ->
  exists quads, (forall a b c, In (a, b, c) quads -> ~ (a = 0 /\ b = 0 /\ c = 0)) /\
    forall p q r, in_plane p -> In (p, q, r) l -> p <> z ->
      In (volume u (lift z) (lift p), volume v (lift z) (lift p), volume w (lift z) (lift p)) quads.
Proof.
  intros l u v w z V Hz. induction l as [|[[p q] r] l [quads [Q1 Q2]]].
  { exists []. split; intros; contradiction. }
  destruct (classic (in_plane p /\ p <> z)) as [[P N]|N].
  - exists ((volume u (lift z) (lift p), volume v (lift z) (lift p), volume w (lift z) (lift p)) :: quads). split.
    + intros a b c [E|I]; [|now apply Q1]. inversion E as [[A B D]]. rewrite A, B, D. intros [-> [-> ->]].
      apply N. symmetry. apply same_line; auto. intros x.
      apply Rmult_eq_reg_l with (volume u v w); [|lra]. rewrite Rmult_0_r.
      replace (volume u v w * volume x (lift z) (lift p)) with (volume v w x * volume u (lift z) (lift p) +
        volume w u x * volume v (lift z) (lift p) + volume u v x * volume w (lift z) (lift p))
        by (unfold volume; ring).
      rewrite A, B, D. ring.
    + intros p' q' r' P' [E|I] N'; [|right; eauto]. left. inversion E. now subst.
  - exists quads. split; auto. intros p' q' r' P' [E|I] N'; [|eauto]. exfalso. inversion E. subst. auto.
Qed.

(** From every lifted triangle a walk leads to one that contains z, where z is not higher. *)
Lemma reach : forall p q r z, lifted p q r -> in_plane z ->
  exists p' q' r', lifted p' q' r' /\ contains (lift p') (lift q') (lift r') (lift z) /\
    height (lift p') (lift q') (lift r') (lift z) <= height (lift p) (lift q) (lift r) (lift z).
Proof.
  intros p q r z L Hz. destruct (left p q r L) as [P [Q [R _]]]. pose proof (lifted_left p q r L) as V.
  destruct (above_lift p P) as [kp [Kp Ap]]. destruct (above_lift q Q) as [kq [Kq Aq]].
  destruct (above_lift r R) as [kr [Kr Ar]]. destruct (above_lift z Hz) as [kz [Kz Az]].
  set (k := Rmax (Rmax kp kq) (Rmax kr kz)).
  assert (kp <= k /\ kq <= k /\ kr <= k /\ kz <= k) as [Lp [Lq [Lr Lz]]].
  { pose proof (Rmax_l kp kq). pose proof (Rmax_r kp kq). pose proof (Rmax_l kr kz). pose proof (Rmax_r kr kz).
    pose proof (Rmax_l (Rmax kp kq) (Rmax kr kz)). pose proof (Rmax_r (Rmax kp kq) (Rmax kr kz)).
    unfold k. repeat split; lra. }
  assert (k < 1) as K1 by (unfold k; repeat apply Rmax_lub_lt; lra).
  assert (0 <= k) as K0 by lra.
  apply (above_more _ k) in Ap; auto. apply (above_more _ k) in Aq; auto.
  apply (above_more _ k) in Ar; auto. apply (above_more _ k) in Az; auto.
  destruct (locally_finite k K1) as [l finite].
  set (u := lift p) in *. set (v := lift q) in *. set (w := lift r) in *. set (y := lift z) in *.
  destruct (quadratics l u v w z V Hz) as [quads [Q1 Q2]].
  destruct (avoid_roots quads Q1) as [s [[S0 S1] G]].
  set (x := combination 1 (combination 1 u s v) (s * s) w).
  assert (0 < s * s) as S2 by nra.
  assert (inside u v w x) as I.
  { unfold x. split; [|split]; rewrite !volume_combination.
    - replace (volume u v u) with 0 by (unfold volume; ring). replace (volume u v v) with 0 by (unfold volume; ring).
      nra.
    - replace (volume v w v) with 0 by (unfold volume; ring). replace (volume v w w) with 0 by (unfold volume; ring).
      rewrite <- volume_turn. lra.
    - replace (volume w u u) with 0 by (unfold volume; ring). replace (volume w u w) with 0 by (unfold volume; ring).
      rewrite volume_turn. nra. }
  assert (above k x) as Ax by (unfold x; repeat apply above_combination; auto; lra).
  apply (walk z Hz (length l) l x p q r); auto.
  - intros p' q' r' t L' [T0 T1] I'. fold y in I'.
    assert (above k (between x y t)) as [A1 A2] by (apply above_combination; auto; lra).
    destruct (point_below _ k A1 K1 A2) as [c [m [Hc [Lc [M E]]]]].
    destruct (left p' q' r' L') as [P' [Q' [R' _]]].
    apply finite with c; auto. apply in_triangle_contains; auto. rewrite E.
    destruct I' as [I1 [I2 I3]]. unfold contains. rewrite !volume_combination. repeat split; nra.
  - intros p' q' r' L' J Np. fold y.
    destruct (left p' q' r' L') as [P' _].
    specialize (G _ _ _ (Q2 p' q' r' P' J Np)).
    replace (volume x y (lift p')) with
      (volume u y (lift p') + volume v y (lift p') * s + volume w y (lift p') * (s * s)); auto.
    unfold x, volume, combination. simpl. ring.
Qed.

(** A lifted vertex in a lifted triangle is one of its corners. *)
Hypothesis corners_only : forall p q r v, lifted p q r -> is_vertex v -> in_triangle v p q r ->
  v = p \/ v = q \/ v = r.

Lemma vertex_in_plane : forall v, is_vertex v -> in_plane v.
Proof. intros v [q [r L]]. now destruct (left v q r L). Qed.

Lemma vertex_high : forall p q r v, lifted p q r -> is_vertex v -> 1 <= height (lift p) (lift q) (lift r) (lift v).
Proof.
  intros p q r v L Hv. pose proof (vertex_in_plane v Hv) as Pv.
  destruct (reach p q r v L Pv) as [p' [q' [r' [L' [I H]]]]].
  destruct (left p' q' r' L') as [P [Q [R _]]].
  pose proof (lifted_left p' q' r' L') as V.
  enough (height (lift p') (lift q') (lift r') (lift v) = 1) by lra.
  apply in_triangle_contains in I; auto.
  destruct (corners_only p' q' r' v L' Hv I) as [->|[->| ->]].
  - apply height_corner. lra.
  - rewrite height_turn. apply height_corner. rewrite <- volume_turn. lra.
  - rewrite <- height_turn. apply height_corner. rewrite volume_turn. lra.
Qed.

(** Lemma 4: no lifted vertex is in the open circumdisk of a lifted triangle. *)
Theorem delaunay : forall p q r centre radius v, lifted p q r -> is_vertex v -> in_plane centre ->
  distance centre p = radius -> distance centre q = radius -> distance centre r = radius ->
  radius <= distance centre v.
Proof.
  intros p q r c radius v L Hv Hc Dp Dq Dr. destruct (left p q r L) as [P [Q [R O]]].
  pose proof (vertex_in_plane v Hv) as Pv. subst radius.
  apply (far_corner_outside p q r v c); auto.
  pose proof (vertex_high p q r v L Hv) as H. pose proof (lifted_left p q r L) as V.
  pose proof (cross_ratio_volumes p v q r P Pv Q R) as E. unfold in_plane in *.
  assert (0 < (1 - abs2 p) * (1 - abs2 v) * ((1 - abs2 q) * (1 - abs2 r))) as M
    by (repeat apply Rmult_lt_0_compat; lra).
  apply (height_above _ _ _ _ V) in H. nra.
Qed.

(** Every point of the plane is in a lifted triangle. *)
Theorem tiled : forall z, (exists p q r, lifted p q r) -> in_plane z ->
  exists p q r, lifted p q r /\ in_triangle z p q r.
Proof.
  intros z [p [q [r L]]] Hz. destruct (reach p q r z L Hz) as [p' [q' [r' [L' [I _]]]]].
  destruct (left p' q' r' L') as [P [Q [R _]]]. exists p', q', r'. split; auto. now apply in_triangle_contains.
Qed.
(** * Covering (Section 6) *)

Lemma weights : forall u v w x, 0 < volume u v w -> let g := / volume u v w in
  x = Vector (g * volume v w x * vx u + g * volume w u x * vx v + g * volume u v x * vx w)
             (g * volume v w x * vy u + g * volume w u x * vy v + g * volume u v x * vy w)
             (g * volume v w x * vt u + g * volume w u x * vt v + g * volume u v x * vt w).
Proof.
  intros u v w x V g.
  assert (forall s t, volume u v w * s = t -> s = g * t) as D by (unfold g; intros s t <-; field; lra).
  destruct x as [x y t]. f_equal; rewrite !Rmult_assoc, <- !Rmult_plus_distr_l; apply D; unfold volume; simpl; ring.
Qed.

Variable epsilon : R.
Hypothesis small : forall p q r, lifted p q r -> exists centre radius, in_plane centre /\ radius <= epsilon /\
  distance centre p = radius /\ distance centre q = radius /\ distance centre r = radius.

(** Every point of the plane is within ε of a lifted vertex. *)
Theorem covering : forall z, (exists p q r, lifted p q r) -> in_plane z ->
  exists v, is_vertex v /\ distance z v <= epsilon.
Proof.
  intros z N Hz. destruct (tiled z N Hz) as [p [q [r [L I]]]].
  destruct (left p q r L) as [P [Q [R _]]]. pose proof (lifted_left p q r L) as V.
  apply in_triangle_contains in I; auto. destruct I as [I1 [I2 I3]].
  destruct (small p q r L) as [c [rho [Hc [E [D1 [D2 D3]]]]]].
  assert (0 <= / volume (lift p) (lift q) (lift r)) as G by now apply Rlt_le, Rinv_0_lt_compat.
  destruct (near_a_corner p q r z c _ _ _ P Q R Hz Hc (Rmult_le_pos _ _ G I2) (Rmult_le_pos _ _ G I3)
    (Rmult_le_pos _ _ G I1) (weights _ _ _ (lift z) V)) as [H|[H|H]]; try congruence; rewrite D1 in H.
  - exists p. split; [now exists q, r|lra].
  - exists q. split; [exists r, p; auto|lra].
  - exists r. split; [exists p, q; auto|lra].
Qed.

(** * Packing (Section 7) *)

Lemma half_symmetric : forall z w, half z w = half w z.
Proof.
  intros. unfold half. replace (abs2 (Csub w z)) with (abs2 (Csub z w)) by (coordinates; ring).
  now rewrite (Rmult_comm (1 - abs2 w)).
Qed.

Lemma half_self : forall z, half z z = 0.
Proof. intros z. unfold half. replace (abs2 (Csub z z)) with 0 by (coordinates; ring). unfold Rdiv. ring. Qed.

Lemma half_pos : forall z w, in_plane z -> in_plane w -> z <> w -> 0 < half z w.
Proof.
  intros z w Hz Hw N. unfold half, in_plane in *. apply Rdiv_lt_0_compat.
  - apply abs2_pos. intro E. apply N. destruct z as [x y], w as [x' y']. unfold Csub, C0 in E. simpl in E.
    inversion E. f_equal; lra.
  - apply Rmult_lt_0_compat; lra.
Qed.

(** x lies in the disk with the diameter uv if and only if half x u + half x v <= half u v. *)
Lemma edge_or_nearer : forall u v, is_vertex u -> is_vertex v -> u <> v ->
  (exists r, lifted u v r \/ lifted v u r) \/
  exists x, is_vertex x /\ x <> u /\ x <> v /\ half x u + half x v <= half u v.
Proof.
  intros u v Vu Vv N. pose proof (vertex_in_plane u Vu) as Pu. pose proof (vertex_in_plane v Vv) as Pv.
  destruct (classic (exists x, is_vertex x /\ x <> u /\ x <> v /\ half x u + half x v <= half u v)) as [|F]; auto.
  left.
  (* z is the midpoint. *)
  destruct (above_lift u Pu) as [ku [Ku Au]]. destruct (above_lift v Pv) as [kv [Kv Av]].
  assert (above (Rmax ku kv) (combination 1 (lift u) 1 (lift v))) as [A1 A2].
  { apply above_combination; try lra.
    - pose proof (Rmax_l ku kv). lra.
    - eapply above_more; [apply Rmax_l|auto].
    - eapply above_more; [apply Rmax_r|auto]. }
  destruct (point_below _ _ A1 (Rmax_lub_lt _ _ _ (proj2 Ku) (proj2 Kv)) A2) as [z [m [Hz [_ [M E]]]]].
  assert (lift z = combination m (lift u) m (lift v)) as Ez.
  { rewrite E. unfold combination. simpl. f_equal; ring. }
  clear E A1 A2 Au Av ku kv Ku Kv.
  assert (exists p q r, lifted p q r) as Ne by (destruct Vu as [q [r L]]; eauto).
  destruct (tiled z Ne Hz) as [p [q [r [L I]]]].
  destruct (left p q r L) as [P [Q [R _]]]. pose proof (lifted_left p q r L) as V.
  apply in_triangle_contains in I; auto. destruct I as [I1 [I2 I3]].
  pose proof (vertex_high p q r u L Vu) as Hu. pose proof (vertex_high p q r v L Vv) as Hv.
  assert (is_vertex p) as Vp by (now exists q, r). assert (is_vertex q) as Vq by (exists r, p; auto).
  assert (is_vertex r) as Vr by (exists p, q; auto).
  pose proof (weights _ _ _ (lift z) V) as W. cbv zeta in W.
  set (g := / volume (lift p) (lift q) (lift r)) in *.
  assert (0 < g) as G by now apply Rinv_0_lt_compat.
  set (lp := g * volume (lift q) (lift r) (lift z)) in *. set (lq := g * volume (lift r) (lift p) (lift z)) in *.
  set (lr := g * volume (lift p) (lift q) (lift z)) in *.
  assert (0 <= lp) as Lp by (apply Rmult_le_pos; lra). assert (0 <= lq) as Lq by (apply Rmult_le_pos; lra).
  assert (0 <= lr) as Lr by (apply Rmult_le_pos; lra).
  (* What a vertex is farther from u and v than they are from one another. *)
  set (f := fun x => half x u + half x v - half u v).
  assert (forall x, is_vertex x -> x = u \/ x = v \/ 0 < f x) as Fpos.
  { intros x Vx. destruct (classic (x = u)) as [|Nu]; auto. destruct (classic (x = v)) as [|Nv]; auto.
    right. right. apply Rnot_le_lt. intro D. apply F. exists x. repeat split; auto. unfold f in D. lra. }
  assert (forall x, is_vertex x -> 0 <= f x) as Fnonneg.
  { intros x Vx. destruct (Fpos x Vx) as [->|[->|D]]; [| |lra]; unfold f; rewrite half_self;
      [|rewrite (half_symmetric v u)]; lra. }
  pose proof (unit_lift z Hz) as U. unfold is_unit in U.
  assert (2 * m <= lp + lq + lr) as H2.
  { unfold height, Rdiv in Hu, Hv. fold g in Hu, Hv.
    unfold lp, lq, lr. rewrite Ez, !volume_combination.
    assert (m * 1 <= m * ((volume (lift p) (lift q) (lift u) + volume (lift q) (lift r) (lift u) +
      volume (lift r) (lift p) (lift u)) * g)) by (apply Rmult_le_compat_l; lra).
    assert (m * 1 <= m * ((volume (lift p) (lift q) (lift v) + volume (lift q) (lift r) (lift v) +
      volume (lift r) (lift p) (lift v)) * g)) by (apply Rmult_le_compat_l; lra).
    lra. }
  assert (forall x, in_plane x -> - dot (lift z) (lift x) = 2 * m * (1 + half u v + f x)) as Dx.
  { intros x Hx. unfold f. rewrite (half_symmetric x u), (half_symmetric x v).
    rewrite (dot_lift u x), (dot_lift v x) by auto. rewrite Ez.
    unfold dot, combination. cbn [vx vy vt]. field. }
  assert (4 * (m * m) * (1 + half u v) = 1) as M2.
  { rewrite Ez in U. pose proof (unit_lift u Pu) as U1. pose proof (unit_lift v Pv) as U2. unfold is_unit in *.
    rewrite dot_lift by auto.
    assert (dot (combination m (lift u) m (lift v)) (combination m (lift u) m (lift v)) =
      m * m * (dot (lift u) (lift u) + dot (lift v) (lift v) + 2 * dot (lift u) (lift v))) as D
      by (unfold dot, combination; simpl; ring).
    rewrite D, U1, U2 in U. lra. }
  assert (lp * f p + lq * f q + lr * f r <= 0) as Sum.
  { assert (- dot (lift z) (lift z) = lp * - dot (lift z) (lift p) + lq * - dot (lift z) (lift q) +
      lr * - dot (lift z) (lift r)) as D by (rewrite W at 2; unfold dot; simpl; ring).
    rewrite U, !Dx in D by auto.
    set (S := lp * f p + lq * f q + lr * f r) in *.
    assert (1 = 2 * m * (1 + half u v) * (lp + lq + lr) + 2 * m * S) as D' by (unfold S; lra).
    assert (0 < 1 + half u v) as K by (pose proof (half_nonneg u v Pu Pv); lra).
    assert (2 * m * (1 + half u v) * (2 * m) <= 2 * m * (1 + half u v) * (lp + lq + lr))
      by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|lra]).
    apply Rnot_lt_le. intro S0. assert (0 < m * S) by now apply Rmult_lt_0_compat. lra. }
  assert (0 <= lp * f p) as Np by (apply Rmult_le_pos; auto).
  assert (0 <= lq * f q) as Nq by (apply Rmult_le_pos; auto).
  assert (0 <= lr * f r) as Nr by (apply Rmult_le_pos; auto).
  assert (forall x l, is_vertex x -> l * f x = 0 -> l = 0 \/ x = u \/ x = v) as Zero.
  { intros x l Vx D. destruct (Fpos x Vx) as [?|[?|?]]; auto. apply Rmult_integral in D. left. lra. }
  assert (forall x, lift z = Vector (x * vx (lift u)) (x * vy (lift u)) (x * vt (lift u)) -> False) as Not_u.
  { intros x D. apply N. apply same_line; auto. intros y.
    apply Rmult_eq_reg_l with m; [|lra]. rewrite Rmult_0_r.
    replace (m * volume y (lift u) (lift v)) with (volume y (lift u) (combination m (lift u) m (lift v)))
      by (rewrite volume_combination; unfold volume; ring).
    rewrite <- Ez, D. unfold volume. simpl. ring. }
  assert (forall x, lift z = Vector (x * vx (lift v)) (x * vy (lift v)) (x * vt (lift v)) -> False) as Not_v.
  { intros x D. apply N. symmetry. apply same_line; auto. intros y.
    apply Rmult_eq_reg_l with m; [|lra]. rewrite Rmult_0_r.
    replace (m * volume y (lift v) (lift u)) with (volume y (lift v) (combination m (lift u) m (lift v)))
      by (rewrite volume_combination; unfold volume; ring).
    rewrite <- Ez, D. unfold volume. simpl. ring. }
  assert (p <> q /\ q <> r /\ r <> p) as [Dpq [Dqr Drp]].
  { repeat split; intro D; rewrite D in V; unfold volume in V; lra. }
  destruct (Zero p lp Vp) as [Zp|[Zp|Zp]]; [lra|..]; destruct (Zero q lq Vq) as [Zq|[Zq|Zq]]; try lra;
    destruct (Zero r lr Vr) as [Zr|[Zr|Zr]]; try lra; try congruence;
    try (rewrite Zp, ?Zq, ?Zr in W);  try (rewrite Zq, ?Zr in W);  try (rewrite Zr in W);
    try (exfalso; first
      [ apply (Not_u 0); rewrite W at 1; f_equal; ring
      | apply (Not_u lp); rewrite W at 1; f_equal; ring
      | apply (Not_v lp); rewrite W at 1; f_equal; ring
      | apply (Not_u lq); rewrite W at 1; f_equal; ring
      | apply (Not_v lq); rewrite W at 1; f_equal; ring
      | apply (Not_u lr); rewrite W at 1; f_equal; ring
      | apply (Not_v lr); rewrite W at 1; f_equal; ring ]);
    subst; eauto.
Qed.
(** Two points that lie over the same point of the surface: an isometry of the plane takes one to the other, and lifted
    triangles to lifted triangles. *)
Variable same_point : C -> C -> Prop.
Hypothesis same_refl : forall u, is_vertex u -> same_point u u.
Hypothesis same_sym : forall u v, same_point u v -> same_point v u.
Hypothesis same_trans : forall u v w, same_point u v -> same_point v w -> same_point u w.
Hypothesis moved : forall u v, same_point u v -> exists g, proper g /\ act g u = v /\
  forall p q r, lifted p q r -> lifted (act g p) (act g q) (act g r) /\ same_point p (act g p).
Hypothesis long : forall p q r, lifted p q r -> same_point p q \/ epsilon <= distance p q.

(** Lemma 6, by the vertices that are not farther from u than v is: an edge uv is long, and otherwise a vertex that is
    not over the same point as u is nearer. *)
Lemma far_apart : forall u, is_vertex u -> forall count l v, (length l <= count)%nat ->
  (forall x, is_vertex x -> half u x <= half u v -> In x l) ->
  is_vertex v -> ~ same_point u v -> u <> v -> epsilon <= distance u v.
Proof.
  intros u Vu. pose proof (vertex_in_plane u Vu) as Pu.
  induction count as [|count IH]; intros l v Hl all Vv S N.
  { assert (In v l) as I by (apply all; auto; lra). destruct l; [contradiction|simpl in Hl; lia]. }
  pose proof (vertex_in_plane v Vv) as Pv.
  assert (forall v', is_vertex v' -> ~ same_point u v' -> u <> v' -> half u v' < half u v ->
    epsilon <= distance u v) as nearer.
  { intros v' Vv' S' N' H. pose proof (vertex_in_plane v' Vv') as Pv'.
    apply Rle_trans with (distance u v'); [|apply distance_half; auto; lra].
    assert (In v l) as I by (apply all; auto; lra).
    destruct (in_split _ _ I) as [l1 [l2 E]].
    apply (IH (l1 ++ l2)); auto.
    - rewrite E in Hl. rewrite app_length in *. simpl in Hl. lia.
    - intros x Vx D. assert (In x l) as J by (apply all; auto; lra). rewrite E in J.
      apply in_app_or in J. apply in_or_app. destruct J as [J|[J|J]]; auto. subst x. lra. }
  destruct (edge_or_nearer u v Vu Vv N) as [[r [L|L]]|[x [Vx [Nu [Nv H]]]]].
  - destruct (long u v r L); [contradiction|auto].
  - rewrite distance_symmetric. destruct (long v u r L) as [H|H]; auto. exfalso. auto.
  - pose proof (vertex_in_plane x Vx) as Px.
    pose proof (half_pos x u Px Pu Nu) as Hu. pose proof (half_pos x v Px Pv Nv) as Hv.
    destruct (classic (same_point x u)) as [Sx|Sx].
    + destruct (moved x u Sx) as [g [G [E K]]].
      destruct Vv as [q [r Lv]]. destruct (K _ _ _ Lv) as [Lg Sg].
      assert (half u (act g v) = half x v) as Hg by (rewrite <- E; now apply half_act).
      apply (nearer (act g v)).
      * exists (act g q), (act g r). exact Lg.
      * intro D. apply S. apply same_trans with (act g v); auto.
      * intro D. apply S. rewrite D. now apply same_sym.
      * rewrite Hg. lra.
    + apply (nearer x); auto. rewrite half_symmetric. lra.
Qed.

(** Vertices over different points of the surface are at least ε apart. *)
Theorem packing : forall u v, is_vertex u -> is_vertex v -> ~ same_point u v -> epsilon <= distance u v.
Proof.
  intros u v Vu Vv S. pose proof (vertex_in_plane u Vu) as Pu. pose proof (vertex_in_plane v Vv) as Pv.
  assert (u <> v) as N by (intros <-; auto).
  set (rho := distance (0, 0) u + distance u v). set (s := sinh (rho / 2) * sinh (rho / 2)).
  assert (in_plane (0, 0)) as P0 by (unfold in_plane, abs2; simpl; lra).
  assert (0 <= s) as S0 by (unfold s; nra).
  assert (s / (1 + s) < 1) as K.
  { apply Rmult_lt_reg_r with (1 + s); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  destruct (locally_finite _ K) as [l finite].
  set (corners := map (fun t : C * C * C => fst (fst t)) l).
  apply (far_apart u Vu (length corners) corners); auto.
  intros x Vx H. pose proof (vertex_in_plane x Vx) as Px. destruct Vx as [q [r L]].
  destruct (left x q r L) as [_ [Q [R _]]].
  apply (in_map (fun t : C * C * C => fst (fst t)) l (x, q, r)). apply finite with x; auto.
  - apply in_triangle_contains; auto. pose proof (lifted_left _ _ _ L) as V. unfold contains.
    replace (volume (lift q) (lift r) (lift x)) with (volume (lift x) (lift q) (lift r)) by (unfold volume; ring).
    replace (volume (lift x) (lift q) (lift x)) with 0 by (unfold volume; ring).
    replace (volume (lift r) (lift x) (lift x)) with 0 by (unfold volume; ring). lra.
  - assert (distance (0, 0) x <= rho) as D.
    { apply Rle_trans with (distance (0, 0) u + distance u x); [now apply triangle_inequality|].
      unfold rho. apply Rplus_le_compat_l. now apply distance_half. }
    assert (half (0, 0) x <= s) as B.
    { rewrite <- sinh_of_distance by auto. unfold s. pose proof (distance_nonneg (0, 0) x) as D0.
      assert (0 <= sinh (distance (0, 0) x / 2)) by (apply sinh_pos; lra).
      assert (sinh (distance (0, 0) x / 2) <= sinh (rho / 2)).
      { destruct (Rle_lt_or_eq_dec _ _ D) as [D'|D']; [apply Rlt_le, sinh_lt; lra|rewrite D'; lra]. }
      now apply Rmult_le_compat. }
    unfold half in B. replace (abs2 (Csub (0, 0) x)) with (abs2 x) in B by (coordinates; ring).
    replace (abs2 (0, 0)) with 0 in B by (unfold abs2; simpl; ring). unfold in_plane in Px.
    apply Rmult_le_reg_r with (1 + s); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
    assert (abs2 x <= s * (1 - abs2 x)).
    { replace (abs2 x) with (abs2 x / ((1 - 0) * (1 - abs2 x)) * (1 - abs2 x)) at 1 by (field; lra).
      apply Rmult_le_compat_r; lra. }
    lra.
Qed.

(** Parts 3, 4 and 5 of Theorem 1. *)
Theorem epsilon_net : (exists p q r, lifted p q r) ->
  (forall p q r centre radius v, lifted p q r -> is_vertex v -> in_plane centre ->
     distance centre p = radius -> distance centre q = radius -> distance centre r = radius ->
     radius <= distance centre v) /\
  (forall z, in_plane z -> exists v, is_vertex v /\ distance z v <= epsilon) /\
  (forall u v, is_vertex u -> is_vertex v -> ~ same_point u v -> epsilon <= distance u v).
Proof. eauto 10 using delaunay, covering, packing. Qed.
End Tiling.

Print Assumptions epsilon_net.
