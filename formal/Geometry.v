(** Geometry that is algebra: the distance is a metric and isometries preserve it; the far corner of a Delaunay edge
    lies outside of the circumdisk (docs/proof.md, Lemma 3.1); a point of a triangle is as near to a corner as the
    circumcentre is (Lemma 5.1). *)

From Coq Require Import NArith Reals Lra Psatz.
From Epsnet Require Import Document Statement Plane Bounds Circle.
Open Scope R_scope.

(** * Isometries *)

Lemma half_act : forall f z w, proper f -> in_plane z -> in_plane w -> half (act f z) (act f w) = half z w.
Proof.
  intros f z w Hf Hz Hw.
  pose proof (denominator_nonzero f z Hf Hz) as Dz. pose proof (denominator_nonzero f w Hf Hw) as Dw.
  apply proper_norm in Hf as N.
  assert (forall u, in_plane u -> denominator f u <> C0 ->
    1 - abs2 (act f u) = norm f * (1 - abs2 u) / abs2 (denominator f u)) as G.
  { intros u Hu Du. rewrite <- abs2_denominator. unfold act. fold (denominator f u). unfold Cdiv.
    rewrite abs2_mul, abs2_inv by auto. apply abs2_pos in Du. field. lra. }
  assert (Csub (act f z) (act f w) =
    Cmul (Cmul (norm f, 0) (Csub z w)) (Cinv (Cmul (denominator f z) (denominator f w)))) as E.
  { assert ((norm f, 0) = Csub (Cmul (a f) (Cconj (a f))) (Cmul (b f) (Cconj (b f)))) as ->
      by (unfold norm; apply C_eq; coordinates; ring).
    unfold act, denominator in *. field. auto. }
  assert (Cmul (denominator f z) (denominator f w) <> C0) as D.
  { apply abs2_nonzero. rewrite abs2_mul. apply abs2_pos in Dz, Dw. nra. }
  unfold half. rewrite E, !G, !abs2_mul, abs2_inv, abs2_mul by auto. apply abs2_pos in Dz, Dw. unfold in_plane in *.
  replace (abs2 (norm f, 0)) with (norm f * norm f) by (unfold abs2; simpl; ring).
  field. repeat split; lra.
Qed.

Theorem isometries_preserve_distance : forall f z w, proper f -> in_plane z -> in_plane w ->
  distance (act f z) (act f w) = distance z w.
Proof. intros. apply distance_of_half. now apply half_act. Qed.

(** * The distance is a metric *)

Lemma distance_nonneg : forall z w, 0 <= distance z w.
Proof.
  intros z w. unfold distance. fold (half z w). rewrite <- arcsinh_0.
  assert (arcsinh 0 <= arcsinh (sqrt (half z w))) by (apply arcsinh_le, sqrt_pos). rewrite arcsinh_0 in *. lra.
Qed.

Lemma sinh_of_distance : forall z w, in_plane z -> in_plane w ->
  sinh (distance z w / 2) * sinh (distance z w / 2) = half z w.
Proof.
  intros z w Hz Hw. unfold distance. fold (half z w).
  replace (2 * arcsinh (sqrt (half z w)) / 2) with (arcsinh (sqrt (half z w))) by field.
  rewrite sinh_arcsinh. apply sqrt_sqrt. now apply half_nonneg.
Qed.

Theorem distance_symmetric : forall z w, distance z w = distance w z.
Proof.
  intros z w. apply distance_of_half. unfold half.
  replace (abs2 (Csub w z)) with (abs2 (Csub z w)) by (coordinates; ring). now rewrite (Rmult_comm (1 - abs2 w)).
Qed.

Theorem distance_zero : forall z w, in_plane z -> in_plane w -> distance z w = 0 <-> z = w.
Proof.
  intros z w Hz Hw. pose proof (sinh_of_distance z w Hz Hw) as S. split.
  - intros E. rewrite E in S. unfold Rdiv in S. rewrite Rmult_0_l, sinh_0, Rmult_0_l in S.
    unfold half, in_plane in *. set (g := (1 - abs2 z) * (1 - abs2 w)) in *.
    assert (0 < g) by (unfold g; apply Rmult_lt_0_compat; lra).
    assert (abs2 (Csub z w) = 0) as A.
    { replace (abs2 (Csub z w)) with (abs2 (Csub z w) / g * g) by (field; lra). rewrite <- S. ring. }
    clear - A. destruct z as [z1 z2], w as [w1 w2]. coordinates.
    apply Rplus_sqr_eq_0 in A. f_equal; lra.
  - intros ->. unfold distance. replace (abs2 (Csub w w)) with 0 by (coordinates; ring).
    unfold Rdiv. rewrite Rmult_0_l, sqrt_0, arcsinh_0. ring.
Qed.

Lemma cosh_half : forall t, cosh t = 1 + 2 * (sinh (t / 2) * sinh (t / 2)).
Proof.
  intros t. unfold cosh, sinh. set (y := t / 2). replace t with (y + y) by (unfold y; field).
  rewrite exp_plus. replace (- (y + y)) with (- y + - y) by ring. rewrite exp_plus.
  pose proof (exp_opp y) as E.
  replace ((exp y - exp (- y)) / 2 * ((exp y - exp (- y)) / 2))
    with ((exp y * exp y + exp (- y) * exp (- y) - 2 * (exp y * exp (- y))) / 4) by field.
  rewrite E. field.
Qed.

Lemma cosh_plus : forall s t, cosh (s + t) = cosh s * cosh t + sinh s * sinh t.
Proof.
  intros. unfold cosh, sinh. rewrite Ropp_plus_distr, !exp_plus. field.
Qed.

Lemma cosh_sinh : forall t, cosh t * cosh t - 1 = sinh t * sinh t.
Proof.
  intros t. unfold cosh, sinh. pose proof (exp_opp t) as E.
  replace 1 with (exp t * exp (- t)) at 1. field.
Qed.

(** By the determinant of Gram of the three unit vectors, which is not positive. *)
Theorem triangle_inequality : forall z w v, in_plane z -> in_plane w -> in_plane v ->
  distance z v <= distance z w + distance w v.
Proof.
  intros z w v Hz Hw Hv.
  pose proof (gram_of_volume (lift z) (lift w) (lift v) (unit_lift z Hz) (unit_lift w Hw) (unit_lift v Hv)) as G.
  rewrite <- !dot_lift in G by auto.
  pose proof (distance_nonneg z w) as Nx. pose proof (distance_nonneg w v) as Ny.
  pose proof (distance_nonneg v z) as Nz.
  rewrite (distance_symmetric z v).
  set (x := distance z w) in *. set (y := distance w v) in *. set (t := distance v z) in *.
  pose proof (cosh_half x) as Cx. pose proof (cosh_half y) as Cy. pose proof (cosh_half t) as Ct.
  unfold x in Cx at 2 3. unfold y in Cy at 2 3. unfold t in Ct at 2 3. rewrite sinh_of_distance in Cx, Cy, Ct by auto.
  assert (half z w = (cosh x - 1) / 2) as Ex by lra. assert (half w v = (cosh y - 1) / 2) as Ey by lra.
  assert (half v z = (cosh t - 1) / 2) as Et by lra. rewrite Ex, Ey, Et in G.
  pose proof (Rle_0_sqr (volume (lift z) (lift w) (lift v))) as P. unfold Rsqr in P. rewrite G in P.
  assert ((cosh t - cosh x * cosh y) * (cosh t - cosh x * cosh y) <= (sinh x * sinh y) * (sinh x * sinh y)) as Q.
  { replace (sinh x * sinh y * (sinh x * sinh y)) with ((sinh x * sinh x) * (sinh y * sinh y)) by ring.
    rewrite <- !cosh_sinh. lra. }
  assert (0 <= sinh x * sinh y) as R by (apply Rmult_le_pos; now apply sinh_pos).
  assert (cosh t <= cosh (x + y)) as S by (rewrite cosh_plus; nra).
  rewrite (cosh_half t), (cosh_half (x + y)) in S.
  apply Rnot_lt_le. intro L.
  assert (sinh ((x + y) / 2) < sinh (t / 2)) by (apply sinh_lt; lra).
  assert (0 <= sinh ((x + y) / 2)) by (apply sinh_pos; lra). nra.
Qed.

(** * Circumcircles *)

Lemma distance_half : forall z w z' w', in_plane z -> in_plane w -> in_plane z' -> in_plane w' ->
  distance z w <= distance z' w' <-> half z w <= half z' w'.
Proof.
  intros z w z' w' Hz Hw Hz' Hw'. unfold distance. fold (half z w) (half z' w').
  pose proof (half_nonneg z w Hz Hw). pose proof (half_nonneg z' w' Hz' Hw'). split; intro H1.
  - apply Rnot_lt_le. intro L.
    assert (sqrt (half z' w') < sqrt (half z w)) as S by (apply sqrt_lt_1_alt; lra). apply arcsinh_lt in S. lra.
  - apply sqrt_le_1_alt in H1. apply arcsinh_le in H1. lra.
Qed.

Lemma equal_half : forall c z w, in_plane c -> in_plane z -> in_plane w ->
  distance c z = distance c w -> half c z = half c w.
Proof. intros c z w Hc Hz Hw E. apply Rle_antisym; apply distance_half; auto; lra. Qed.

(** vol · X in terms of three vectors. *)
Lemma cramer : forall u v w x c, volume u v w * dot c x =
  volume x v w * dot c u + volume u x w * dot c v + volume u v x * dot c w.
Proof. intros. unfold volume, dot. ring. Qed.

Lemma volumes_sum : forall u v w x,
  volume x v w + volume u x w + volume u v x = vx x * sx u v w + vy x * sy u v w + vt x * st u v w.
Proof. intros. unfold volume, sx, sy, st. ring. Qed.

(** The cross-ratio and the unit vectors. *)
Lemma cross_ratio_volumes : forall p far q r, in_plane p -> in_plane far -> in_plane q -> in_plane r ->
  cross_ratio_sign p far q r * 8 =
  (1 - abs2 p) * (1 - abs2 far) * ((1 - abs2 q) * (1 - abs2 r)) *
  (volume (lift p) (lift q) (lift r) -
   (volume (lift far) (lift q) (lift r) + volume (lift p) (lift far) (lift r) + volume (lift p) (lift q) (lift far))).
Proof.
  intros [p1 p2] [f1 f2] [q1 q2] [r1 r2] Hp Hf Hq Hr.
  unfold in_plane, cross_ratio_sign, volume, lift in *. coordinates. field. repeat split; lra.
Qed.

(** An edge pq of a counterclockwise triangle pqr that is Delaunay: the far corner is no nearer to the circumcentre. *)
Theorem far_corner_outside : forall p q r far centre,
  in_plane p -> in_plane q -> in_plane r -> in_plane far -> in_plane centre ->
  counterclockwise p q r -> cross_ratio_sign p far q r <= 0 ->
  distance centre p = distance centre q -> distance centre p = distance centre r ->
  distance centre p <= distance centre far.
Proof.
  intros p q r f c Hp Hq Hr Hf Hc O J E1 E2. apply distance_half; auto.
  assert (half c p = half c q) as H1 by now apply equal_half.
  assert (half c p = half c r) as H2 by now apply equal_half.
  pose proof (half_nonneg c p Hc Hp) as N.
  rewrite !dot_lift in * by auto.
  pose proof (cross_ratio_volumes p f q r Hp Hf Hq Hr) as V.
  pose proof (volume_lift p q r Hp Hq Hr) as W. unfold counterclockwise, in_plane in *.
  pose proof (cramer (lift p) (lift q) (lift r) (lift f) (lift c)) as K.
  set (u := lift p) in *. set (v := lift q) in *. set (w := lift r) in *. set (x := lift f) in *.
  assert (dot (lift c) v = dot (lift c) u) as Ev by lra. assert (dot (lift c) w = dot (lift c) u) as Ew by lra.
  rewrite Ev, Ew in K. set (g := dot (lift c) u) in *.
  set (s := volume x v w + volume u x w + volume u v x) in *.
  assert (0 < (1 - abs2 p) * (1 - abs2 f) * ((1 - abs2 q) * (1 - abs2 r))) as P
    by (repeat apply Rmult_lt_0_compat; lra).
  assert (0 < volume u v w) as Q.
  { assert (0 < (1 - abs2 p) * (1 - abs2 q) * (1 - abs2 r)) by (repeat apply Rmult_lt_0_compat; lra). nra. }
  assert (volume u v w <= s) as S by nra.
  assert (volume u v w * dot (lift c) x = s * g) as K' by (unfold s; lra).
  assert (g <= -1) as G by lra.
  assert (volume u v w * dot (lift c) x <= volume u v w * g) as L by nra.
  apply Rmult_le_reg_l in L; auto. lra.
Qed.

(** Lemma 5.1: a point of the triangle pqr, given by nonnegative weights, is as near to one of its corners as a point at
    equal distance from all three is to these. *)
Theorem near_a_corner : forall p q r z centre l m n,
  in_plane p -> in_plane q -> in_plane r -> in_plane z -> in_plane centre ->
  0 <= l -> 0 <= m -> 0 <= n ->
  lift z = Vector (l * vx (lift p) + m * vx (lift q) + n * vx (lift r))
                  (l * vy (lift p) + m * vy (lift q) + n * vy (lift r))
                  (l * vt (lift p) + m * vt (lift q) + n * vt (lift r)) ->
  distance centre p = distance centre q -> distance centre p = distance centre r ->
  distance z p <= distance centre p \/ distance z q <= distance centre p \/ distance z r <= distance centre p.
Proof.
  intros p q r z c l m n Hp Hq Hr Hz Hc Hl Hm Hn E E1 E2.
  assert (half c p = half c q) as H1 by now apply equal_half.
  assert (half c p = half c r) as H2 by now apply equal_half.
  rewrite !distance_half by auto.
  pose proof (half_nonneg c z Hc Hz) as N. pose proof (half_nonneg c p Hc Hp) as N'.
  pose proof (unit_lift z Hz) as U. unfold is_unit in U.
  rewrite !dot_lift in * by auto.
  set (u := lift p) in *. set (v := lift q) in *. set (w := lift r) in *.
  assert (forall x, dot x (lift z) = l * dot x u + m * dot x v + n * dot x w) as L
    by (intros; rewrite E; unfold dot; simpl; ring).
  pose proof (L (lift c)) as Lc. rewrite L in U.
  assert (dot (lift c) v = dot (lift c) u) as Ev by lra. assert (dot (lift c) w = dot (lift c) u) as Ew by lra.
  rewrite Ev, Ew in Lc. set (g := dot (lift c) u) in *.
  (* (l + m + n) cosh R >= 1, and l, m, n weigh cosh of the distances of z from the corners to 1. *)
  set (du := dot (lift z) u) in *. set (dv := dot (lift z) v) in *. set (dw := dot (lift z) w) in *.
  destruct (Rle_lt_dec (- (1 + du) / 2) (- (1 + g) / 2)) as [A|A]; auto.
  destruct (Rle_lt_dec (- (1 + dv) / 2) (- (1 + g) / 2)) as [B|B]; auto.
  destruct (Rle_lt_dec (- (1 + dw) / 2) (- (1 + g) / 2)) as [D|D]; auto.
  exfalso.
  assert (l * du <= l * g) by nra. assert (m * dv <= m * g) by nra. assert (n * dw <= n * g) by nra.
  assert (dot (lift c) (lift z) = (l + m + n) * g) as F by lra.
  assert ((l + m + n) * g <= -1) by lra.
  destruct (Rle_lt_or_eq_dec 0 l Hl) as [Pl|Pl]; [nra|].
  destruct (Rle_lt_or_eq_dec 0 m Hm) as [Pm|Pm]; [nra|].
  destruct (Rle_lt_or_eq_dec 0 n Hn) as [Pn|Pn]; [nra|].
  subst. lra.
Qed.

(** * In a document *)

Section Consequences.
Variables (d : document) (n : net) (crossing : N -> isometry).
Hypothesis left : triangles_are_counterclockwise d n crossing.
Hypothesis small : circumradii_are_small d n crossing.

(** Every point of a lifted triangle is within ε of one of its corners. *)
Theorem triangles_are_covered : forall t z l m k, (t < size (triangles d))%N -> in_plane z ->
  0 <= l -> 0 <= m -> 0 <= k ->
  let p := corner n crossing (3 * t) in
  let q := corner n crossing (3 * t + 1) in
  let r := corner n crossing (3 * t + 2) in
  lift z = Vector (l * vx (lift p) + m * vx (lift q) + k * vx (lift r))
                  (l * vy (lift p) + m * vy (lift q) + k * vy (lift r))
                  (l * vt (lift p) + m * vt (lift q) + k * vt (lift r)) ->
  distance z p <= epsilon d \/ distance z q <= epsilon d \/ distance z r <= epsilon d.
Proof.
  intros t z l m k Ht Hz Hl Hm Hk p q r E. destruct (left t Ht) as [Hp [Hq [Hr _]]].
  destruct (small t Ht) as [c [R [Hc [HR [E1 [E2 E3]]]]]]. fold p in Hp, E1. fold q in Hq, E2. fold r in Hr, E3.
  destruct (near_a_corner p q r z c l m k) as [H|[H|H]]; auto; try congruence; rewrite E1 in H; lra.
Qed.
End Consequences.

Print Assumptions triangles_are_covered.
