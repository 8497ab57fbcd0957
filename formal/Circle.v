(** Rules covering and packing: circumcircles (docs/proof.md, Lemma 5) and lengths. *)

From Coq Require Import ZArith Reals List Bool Lia Lra Psatz.
From Epsnet Require Import Document Statement Plane Integers Bounds.
Open Scope R_scope.

(** h = sinh²(d/2). *)
Definition half (z w : C) : R := abs2 (Csub z w) / ((1 - abs2 z) * (1 - abs2 w)).

Lemma half_nonneg : forall z w, in_plane z -> in_plane w -> 0 <= half z w.
Proof.
  intros z w Hz Hw. unfold half, in_plane in *. pose proof (abs2_nonneg (Csub z w)).
  unfold Rdiv. apply Rmult_le_pos; auto. apply Rlt_le, Rinv_0_lt_compat. nra.
Qed.

Lemma sinh_pos : forall x, 0 <= x -> 0 <= sinh x.
Proof. intros x H. destruct H as [H|<-]; [apply Rlt_le; rewrite <- sinh_0; now apply sinh_lt|rewrite sinh_0; lra]. Qed.

Lemma distance_above : forall z w x, 0 <= x -> half z w <= sinh (x / 2) * sinh (x / 2) -> distance z w <= x.
Proof.
  intros z w x Hx H. unfold distance. fold (half z w).
  assert (sqrt (half z w) <= sinh (x / 2)) as S.
  { rewrite <- (sqrt_square (sinh (x / 2))) by (apply sinh_pos; lra). now apply sqrt_le_1_alt. }
  assert (arcsinh (sqrt (half z w)) <= arcsinh (sinh (x / 2))) as A by now apply arcsinh_le.
  rewrite arcsinh_sinh in A. lra.
Qed.

Lemma distance_below : forall z w x, 0 <= x -> sinh (x / 2) * sinh (x / 2) <= half z w -> x <= distance z w.
Proof.
  intros z w x Hx H. unfold distance. fold (half z w).
  assert (sinh (x / 2) <= sqrt (half z w)) as S.
  { rewrite <- (sqrt_square (sinh (x / 2))) by (apply sinh_pos; lra). now apply sqrt_le_1_alt. }
  assert (arcsinh (sinh (x / 2)) <= arcsinh (sqrt (half z w))) as A by now apply arcsinh_le.
  rewrite arcsinh_sinh in A. lra.
Qed.

Lemma distance_of_half : forall z w z' w', half z w = half z' w' -> distance z w = distance z' w'.
Proof. intros z w z' w' H. unfold distance. fold (half z w) (half z' w'). now rewrite H. Qed.

Lemma sinh_double : forall x, sinh x * sinh x = 4 * (sinh (x / 2) * sinh (x / 2)) * (1 + sinh (x / 2) * sinh (x / 2)).
Proof.
  intros x. unfold sinh. set (y := x / 2).
  replace x with (y + y) by (unfold y; field). rewrite exp_plus. replace (- (y + y)) with (- y + - y) by ring.
  rewrite exp_plus. pose proof (exp_opp y) as E.
  set (p := exp y) in *. set (q := exp (- y)) in *.
  replace (1 + (p - q) / 2 * ((p - q) / 2)) with (1 - p * q + (p + q) / 2 * ((p + q) / 2)) by field.
  rewrite E. field.
Qed.

(** * The hyperboloid *)

Record vector := Vector { vx : R; vy : R; vt : R }.
Definition dot (u v : vector) : R := vx u * vx v + vy u * vy v - vt u * vt v.
Definition is_unit (u : vector) : Prop := dot u u = -1.
Definition volume (u v w : vector) : R :=
  vx u * (vy v * vt w - vy w * vt v) - vy u * (vx v * vt w - vx w * vt v) + vt u * (vx v * vy w - vx w * vy v).

Definition lift (z : C) : vector :=
  Vector (2 * Re z / (1 - abs2 z)) (2 * Im z / (1 - abs2 z)) ((1 + abs2 z) / (1 - abs2 z)).

Lemma unit_lift : forall z, in_plane z -> is_unit (lift z).
Proof.
  intros [u v] H. unfold in_plane, is_unit, dot, lift in *. coordinates. field. lra.
Qed.

Lemma lift_future : forall z, in_plane z -> 0 < vt (lift z).
Proof.
  intros z H. unfold lift, in_plane in *. simpl. pose proof (abs2_nonneg z). apply Rdiv_lt_0_compat; lra.
Qed.

Lemma dot_lift : forall z w, in_plane z -> in_plane w -> half z w = - (1 + dot (lift z) (lift w)) / 2.
Proof.
  intros [u v] [p q] Hz Hw. unfold in_plane, half, dot, lift in *. coordinates. field. split; lra.
Qed.

Lemma volume_lift : forall u v w, in_plane u -> in_plane v -> in_plane w ->
  volume (lift u) (lift v) (lift w) * ((1 - abs2 u) * (1 - abs2 v) * (1 - abs2 w)) = det u v w.
Proof.
  intros u v w Hu Hv Hw. unfold in_plane, volume, lift, det in *. simpl. field. repeat split; lra.
Qed.

(** The point of the disk below a vector of the hyperboloid. *)
Definition project (c : vector) : C := (vx c / (1 + vt c), vy c / (1 + vt c)).

Lemma project_in_plane : forall c, is_unit c -> 0 < vt c -> in_plane (project c).
Proof.
  intros [x y t] H K. unfold is_unit, dot, in_plane, project in *. coordinates.
  apply Rmult_lt_reg_r with ((1 + t) * (1 + t)); [nra|]. field_simplify; nra.
Qed.

Lemma lift_project : forall c, is_unit c -> 0 < vt c -> lift (project c) = c.
Proof.
  intros [x y t] H K. unfold is_unit, dot, lift, project in *. coordinates.
  assert (x / (1 + t) * (x / (1 + t)) + y / (1 + t) * (y / (1 + t)) = (t - 1) / (1 + t)) as ->.
  { replace (x / (1 + t) * (x / (1 + t)) + y / (1 + t) * (y / (1 + t)))
      with ((x * x + y * y) / ((1 + t) * (1 + t))) by (field; lra).
    replace (x * x + y * y) with ((t - 1) * (1 + t)) by lra. field. lra. }
  f_equal; field; split; lra.
Qed.

(** * Three unit vectors *)

Section Three.
Variables u v w : vector.
Hypothesis Hu : is_unit u.
Hypothesis Hv : is_unit v.
Hypothesis Hw : is_unit w.
Hypothesis Fu : 0 < vt u.
Let a := - (1 + dot u v) / 2.
Let b := - (1 + dot v w) / 2.
Let c := - (1 + dot w u) / 2.
Let k := 2 * (a * b + b * c + c * a) - a * a - b * b - c * c.

(** v × w + w × u + u × v. *)
Definition sx := (vy v * vt w - vt v * vy w) + (vy w * vt u - vt w * vy u) + (vy u * vt v - vt u * vy v).
Definition sy := (vt v * vx w - vx v * vt w) + (vt w * vx u - vx w * vt u) + (vt u * vx v - vx u * vt v).
Definition st := (vx v * vy w - vy v * vx w) + (vx w * vy u - vy w * vx u) + (vx u * vy v - vy u * vx v).

Lemma gram_of_sum : st * st - sx * sx - sy * sy = 4 * k.
Proof.
  assert (st * st - sx * sx - sy * sy =
    (dot v v * dot w w - dot v w * dot v w) + (dot w w * dot u u - dot w u * dot w u) +
    (dot u u * dot v v - dot u v * dot u v) +
    2 * (dot v w * dot w u - dot v u * dot w w) + 2 * (dot w u * dot u v - dot w v * dot u u) +
    2 * (dot u v * dot v w - dot u w * dot v v)) as E by (unfold dot, st, sx, sy; ring).
  rewrite E. unfold is_unit in *. rewrite Hu, Hv, Hw. unfold k, a, b, c.
  replace (dot v u) with (dot u v) by (unfold dot; ring). replace (dot w v) with (dot v w) by (unfold dot; ring).
  replace (dot u w) with (dot w u) by (unfold dot; ring). field.
Qed.

Lemma gram_of_volume : volume u v w * volume u v w = 4 * k + 16 * (a * b * c).
Proof.
  assert (volume u v w * volume u v w =
    - (dot u u * (dot v v * dot w w - dot v w * dot v w) - dot u v * (dot u v * dot w w - dot v w * dot w u) +
       dot w u * (dot u v * dot v w - dot v v * dot w u))) as E by (unfold dot, volume; ring).
  rewrite E. unfold is_unit in *. rewrite Hu, Hv, Hw. unfold k, a, b, c. field.
Qed.

Lemma sum_dot : vx u * sx + vy u * sy + vt u * st = volume u v w /\
  vx v * sx + vy v * sy + vt v * st = volume u v w /\ vx w * sx + vy w * sy + vt w * st = volume u v w.
Proof. unfold sx, sy, st, volume. repeat split; ring. Qed.

Hypothesis left : 0 < volume u v w.
Hypothesis timelike : 0 < k.

Lemma sum_future : 0 < st.
Proof.
  pose proof gram_of_sum as G. destruct sum_dot as [S _].
  apply Rnot_le_lt. intro H.
  assert (is_unit u) as U by auto. unfold is_unit, dot in U.
  assert ((vx u * sx + vy u * sy) * (vx u * sx + vy u * sy) <=
    (vx u * vx u + vy u * vy u) * (sx * sx + sy * sy)) as CS.
  { pose proof (Rle_0_sqr (vx u * sy - vy u * sx)) as Q. unfold Rsqr in Q. lra. }
  set (p := vx u * sx + vy u * sy) in *. set (q := vt u * st) in *.
  assert (p * p < q * q).
  { unfold q. replace (vx u * vx u + vy u * vy u) with (vt u * vt u - 1) in CS by lra.
    replace (sx * sx + sy * sy) with (st * st - 4 * k) in CS by lra. nra. }
  assert (q <= 0) by (unfold q; nra). nra.
Qed.

Definition circumcentre : vector := let r := 2 * sqrt k in Vector (- sx / r) (- sy / r) (st / r).

Lemma root : 0 < sqrt k /\ sqrt k * sqrt k = k.
Proof. split; [now apply sqrt_lt_R0|apply sqrt_sqrt; lra]. Qed.

Lemma unit_centre : is_unit circumcentre.
Proof.
  destruct root as [P Q]. pose proof gram_of_sum as G. unfold is_unit, dot, circumcentre. simpl.
  set (r := sqrt k) in *.
  replace (- sx / (2 * r) * (- sx / (2 * r)) + - sy / (2 * r) * (- sy / (2 * r)) - st / (2 * r) * (st / (2 * r)))
    with (- (st * st - sx * sx - sy * sy) / (4 * (r * r))) by (field; lra).
  rewrite G, Q. field. lra.
Qed.

Lemma future_centre : 0 < vt circumcentre.
Proof. destruct root. pose proof sum_future. unfold circumcentre. simpl. apply Rdiv_lt_0_compat; lra. Qed.

Definition cosh_radius : R := volume u v w / (2 * sqrt k).

Lemma dot_centre :
  dot circumcentre u = - cosh_radius /\ dot circumcentre v = - cosh_radius /\ dot circumcentre w = - cosh_radius.
Proof.
  destruct root as [P _]. destruct sum_dot as [S1 [S2 S3]]. unfold dot, circumcentre, cosh_radius. simpl.
  set (r := sqrt k) in *.
  repeat split; [rewrite <- S1|rewrite <- S2|rewrite <- S3]; field; lra.
Qed.

(** sinh²R = 4abc/k. *)
Lemma sinh_radius : (cosh_radius * cosh_radius - 1) * k = 4 * (a * b * c).
Proof.
  destruct root as [P Q]. pose proof gram_of_volume as G. unfold cosh_radius.
  replace (volume u v w / (2 * sqrt k) * (volume u v w / (2 * sqrt k)))
    with (volume u v w * volume u v w / (4 * (sqrt k * sqrt k))) by (field; lra).
  rewrite Q, G. field. lra.
Qed.

Lemma cosh_radius_pos : 0 < cosh_radius.
Proof. destruct root as [P _]. unfold cosh_radius. apply Rdiv_lt_0_compat; lra. Qed.
End Three.

(** A counterclockwise triangle with 4abc ≤ sinh²ε · k, k > 0, has a circumcircle of radius at most ε. *)
Lemma circumcircle : forall p q r epsilon,
  in_plane p -> in_plane q -> in_plane r -> counterclockwise p q r -> 0 < epsilon ->
  let a := half p q in let b := half q r in let c := half r p in
  let k := 2 * (a * b + b * c + c * a) - a * a - b * b - c * c in
  0 < k -> 4 * (a * b * c) <= sinh epsilon * sinh epsilon * k ->
  exists circumcentre radius, in_plane circumcentre /\ radius <= epsilon /\
    distance circumcentre p = radius /\ distance circumcentre q = radius /\ distance circumcentre r = radius.
Proof.
  intros p q r e Hp Hq Hr Hl He a b c k Hk H.
  set (u := lift p) in *. set (v := lift q) in *. set (w := lift r) in *.
  assert (is_unit u) as Uu by now apply unit_lift.
  assert (is_unit v) as Uv by now apply unit_lift.
  assert (is_unit w) as Uw by now apply unit_lift.
  assert (0 < vt u) as Fu by now apply lift_future.
  assert (0 < volume u v w) as Hvol.
  { pose proof (volume_lift p q r Hp Hq Hr) as E. unfold counterclockwise, in_plane in *.
    assert (0 < (1 - abs2 p) * (1 - abs2 q) * (1 - abs2 r)) by (repeat apply Rmult_lt_0_compat; lra).
    fold u v w in E. nra. }
  assert (a = - (1 + dot u v) / 2) as Ea by now apply dot_lift.
  assert (b = - (1 + dot v w) / 2) as Eb by now apply dot_lift.
  assert (c = - (1 + dot w u) / 2) as Ec by now apply dot_lift.
  unfold k in Hk, H. rewrite Ea, Eb, Ec in Hk, H.
  pose proof (unit_centre u v w Uu Uv Uw Hk) as Uc.
  pose proof (future_centre u v w Uu Uv Uw Fu Hvol Hk) as Fc.
  pose proof (dot_centre u v w Hk) as [D1 [D2 D3]].
  pose proof (sinh_radius u v w Uu Uv Uw Hk) as S.
  pose proof (cosh_radius_pos u v w Hvol Hk) as P.
  set (cv := circumcentre u v w) in *. set (ch := cosh_radius u v w) in *.
  pose proof (project_in_plane cv Uc Fc) as Ic.
  assert (forall z, in_plane z -> dot cv (lift z) = - ch -> half (project cv) z = (ch - 1) / 2) as Dz.
  { intros z Hz E. rewrite dot_lift by auto. rewrite lift_project by auto. rewrite E. field. }
  exists (project cv), (distance (project cv) p). split; auto.
  assert (half (project cv) p = (ch - 1) / 2) as Ep by (apply Dz; auto).
  assert (half (project cv) q = (ch - 1) / 2) as Eq by (apply Dz; auto).
  assert (half (project cv) r = (ch - 1) / 2) as Er by (apply Dz; auto).
  split.
  - apply distance_above; [lra|]. rewrite Ep.
    pose proof (sinh_double e) as Sd. set (t := sinh (e / 2) * sinh (e / 2)) in *.
    assert (0 <= t) by (unfold t; nra).
    rewrite <- S in H.
    assert (ch * ch - 1 <= sinh e * sinh e) as L by (eapply Rmult_le_reg_r; [exact Hk|exact H]).
    rewrite Sd in L. nra.
  - repeat split; apply distance_of_half; congruence.
Qed.
