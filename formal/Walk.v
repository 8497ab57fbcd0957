(** A step of a walk through a triangulation: from a triangle, straight to a point, across one edge after the other.
    At each Delaunay edge the height of the point decreases (docs/proof.md, Lemma 4). Then what the walk needs of points
    and lines. *)

From Coq Require Import Reals List Lia Lra Psatz Classical.
From Epsnet Require Import Document Statement Plane Bounds Circle Geometry.
Import ListNotations.
Open Scope R_scope.

(** * Vectors *)

Definition combination (l : R) (u : vector) (m : R) (v : vector) : vector :=
  Vector (l * vx u + m * vx v) (l * vy u + m * vy v) (l * vt u + m * vt v).

(** The point w of the segment from x, w = 0, to v, w = 1. *)
Definition between (x v : vector) (w : R) : vector := combination (1 - w) x w v.

Lemma volume_turn : forall u v w, volume u v w = volume v w u.
Proof. intros. unfold volume. ring. Qed.

Lemma volume_combination : forall u v l x m y, volume u v (combination l x m y) = l * volume u v x + m * volume u v y.
Proof. intros. unfold volume, combination. simpl. ring. Qed.

Lemma between_again : forall x v w w', between (between x v w) v w' = between x v (w + w' - w * w').
Proof. intros. unfold between, combination. simpl. f_equal; ring. Qed.

(** On the left of each side of the triangle u v w, or on it. *)
Definition inside (u v w x : vector) : Prop := 0 < volume u v x /\ 0 < volume v w x /\ 0 < volume w u x.
Definition contains (u v w x : vector) : Prop := 0 <= volume u v x /\ 0 <= volume v w x /\ 0 <= volume w u x.

(** The functional α of a triangle (docs/proof.md, Section 5): 1 at its corners, less in its open circumdisk. *)
Definition height (u v w x : vector) : R := (volume u v x + volume v w x + volume w u x) / volume u v w.

Lemma height_turn : forall u v w x, height u v w x = height v w u x.
Proof. intros. unfold height. rewrite (volume_turn u v w). f_equal. ring. Qed.

Lemma height_corner : forall u v w, volume u v w <> 0 -> height u v w u = 1.
Proof.
  intros u v w H. unfold height.
  replace (volume u v u + volume v w u + volume w u u) with (volume u v w) by (unfold volume; ring). now field.
Qed.

(** A step: x inside of the triangle u v w, z beyond its side u v, and the segment from x to z leaves the triangle there
    and not at a corner; v u s is the triangle beyond. *)
Section Step.
Variables u v w s x z : vector.
Hypothesis left : 0 < volume u v w.
Hypothesis left_beyond : 0 < volume v u s.
Hypothesis x_inside : inside u v w x.
Hypothesis z_beyond : volume u v z < 0.
Hypothesis leaves_v : 0 < volume u v x * volume v w z - volume u v z * volume v w x.
Hypothesis leaves_u : 0 < volume u v x * volume w u z - volume u v z * volume w u x.

Lemma small_step : forall f g f' g', 0 < f -> 0 < g ->
  exists t, 0 < t < 1 /\ 0 < (1 - t) * f + t * f' /\ 0 < (1 - t) * g + t * g'.
Proof.
  intros f g f' g' Hf Hg.
  assert (0 <= Rabs f' / f) as A by (apply Rmult_le_pos; [apply Rabs_pos|now apply Rlt_le, Rinv_0_lt_compat]).
  assert (0 <= Rabs g' / g) as B by (apply Rmult_le_pos; [apply Rabs_pos|now apply Rlt_le, Rinv_0_lt_compat]).
  set (k := 2 + Rabs f' / f + Rabs g' / g).
  assert (2 <= k) as K by (unfold k; lra).
  assert (0 < / k) as I by (apply Rinv_0_lt_compat; lra).
  assert (/ k < 1) as I' by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra).
  assert (forall h h', 0 < h -> Rabs h' / h <= k - 2 -> 0 < (1 - / k) * h + / k * h') as P.
  { intros h h' Hh L. replace ((1 - / k) * h + / k * h') with (/ k * ((k - 1) * h + h')) by (field; lra).
    apply Rmult_lt_0_compat; auto.
    assert (Rabs h' <= (k - 2) * h).
    { replace (Rabs h') with (Rabs h' / h * h) by (field; lra). apply Rmult_le_compat_r; lra. }
    pose proof (Rle_abs (- h')) as N. rewrite Rabs_Ropp in N. lra. }
  exists (/ k). split; auto. split; apply P; auto; unfold k; lra.
Qed.

Lemma step : exists t, 0 < t < 1 /\ inside v u s (between x z t) /\
  forall t', t <= t' <= 1 -> volume u v (between x z t') < 0.
Proof.
  destruct x_inside as [C0 [A0 B0]].
  set (c0 := volume u v x) in *. set (c1 := volume u v z) in *.
  set (r := c0 / (c0 - c1)).
  assert (0 < / (c0 - c1)) as I by (apply Rinv_0_lt_compat; lra).
  assert (1 - r = - c1 * / (c0 - c1)) as Er by (unfold r; field; lra).
  assert (0 < r) as R0 by (unfold r; apply Rmult_lt_0_compat; lra).
  assert (0 < 1 - r) as R1 by (rewrite Er; apply Rmult_lt_0_compat; lra).
  set (e := between x z r).
  assert (volume u v e = 0) as E0.
  { unfold e, between. rewrite volume_combination. fold c0 c1. unfold r. field. lra. }
  assert (0 < volume v w e) as E1.
  { unfold e, between. rewrite volume_combination, Er. unfold r.
    replace (- c1 * / (c0 - c1) * volume v w x + c0 / (c0 - c1) * volume v w z)
      with (/ (c0 - c1) * (c0 * volume v w z - c1 * volume v w x)) by (field; lra).
    now apply Rmult_lt_0_compat. }
  assert (0 < volume w u e) as E2.
  { unfold e, between. rewrite volume_combination, Er. unfold r.
    replace (- c1 * / (c0 - c1) * volume w u x + c0 / (c0 - c1) * volume w u z)
      with (/ (c0 - c1) * (c0 * volume w u z - c1 * volume w u x)) by (field; lra).
    now apply Rmult_lt_0_compat. }
  assert (0 < volume u s e) as S1.
  { apply Rmult_lt_reg_l with (volume u v w); auto. rewrite Rmult_0_r.
    replace (volume u v w * volume u s e) with (volume w u e * volume v u s + volume u v e * volume u s w)
      by (unfold volume; ring).
    rewrite E0. assert (0 < volume w u e * volume v u s) by now apply Rmult_lt_0_compat. lra. }
  assert (0 < volume s v e) as S2.
  { apply Rmult_lt_reg_l with (volume u v w); auto. rewrite Rmult_0_r.
    replace (volume u v w * volume s v e) with (volume v w e * volume v u s + volume u v e * volume s v w)
      by (unfold volume; ring).
    rewrite E0. assert (0 < volume v w e * volume v u s) by now apply Rmult_lt_0_compat. lra. }
  destruct (small_step _ _ (volume u s z) (volume s v z) S1 S2) as [t [[T0 T1] [P Q]]].
  assert (forall t', volume u v (between e z t') = t' * c1) as V.
  { intros. unfold between. rewrite volume_combination, E0. fold c1. ring. }
  exists (r + t - r * t).
  assert (between x z (r + t - r * t) = between e z t) as E by (unfold e; now rewrite between_again).
  split; [nra|]. split.
  - rewrite E. split; [|split].
    + replace (volume v u (between e z t)) with (- volume u v (between e z t)) by (unfold volume; ring).
      rewrite V. nra.
    + unfold between. now rewrite volume_combination.
    + unfold between. now rewrite volume_combination.
  - intros t' [L1 L2]. unfold between. rewrite volume_combination. fold c0 c1.
    assert (r < t') by nra.
    replace ((1 - t') * c0 + t' * c1) with ((r - t') * (c0 - c1)) by (unfold r; field; lra). nra.
Qed.

(** Lemma 4: beyond an edge of which the far corner is not lower, nothing is. *)
Lemma height_decreases : 1 <= height u v w s -> height v u s z <= height u v w z.
Proof.
  intros H. unfold height in *.
  set (f := volume u v w) in *. set (g := volume v u s) in *.
  assert (f <= volume u v s + volume v w s + volume w u s) as H'.
  { apply Rmult_le_reg_r with (/ f); [now apply Rinv_0_lt_compat|]. rewrite Rinv_r by lra. exact H. }
  apply Rmult_le_reg_l with (f * g); [now apply Rmult_lt_0_compat|].
  replace (f * g * ((volume v u z + volume u s z + volume s v z) / g))
    with (f * (volume v u z + volume u s z + volume s v z)) by (field; lra).
  replace (f * g * ((volume u v z + volume v w z + volume w u z) / f))
    with (g * (volume u v z + volume v w z + volume w u z)) by (field; lra).
  assert (g * (volume u v z + volume v w z + volume w u z) =
    f * (volume u s z + volume s v z) + volume v u z * (volume u v s + volume v w s + volume w u s)) as ->
    by (unfold f, g, volume; ring).
  replace (volume v u z) with (- volume u v z) by (unfold volume; ring).
  assert (- volume u v z * f <= - volume u v z * (volume u v s + volume v w s + volume w u s))
    by (apply Rmult_le_compat_l; lra).
  lra.
Qed.
End Step.

(** If the segment from x, inside, to z does not stay in the triangle, then it leaves across one of the sides first. *)
Lemma leaves : forall u v w x z, inside u v w x -> contains u v w z \/
  exists u' v' w', ((u' = u /\ v' = v /\ w' = w) \/ (u' = v /\ v' = w /\ w' = u) \/ (u' = w /\ v' = u /\ w' = v)) /\
    volume u' v' z < 0 /\
    0 <= volume u' v' x * volume v' w' z - volume u' v' z * volume v' w' x /\
    0 <= volume u' v' x * volume w' u' z - volume u' v' z * volume w' u' x.
Proof.
  intros u v w x z [A [B C]].
  set (a := volume u v x) in *. set (b := volume v w x) in *. set (c := volume w u x) in *.
  set (a' := volume u v z) in *. set (b' := volume v w z) in *. set (c' := volume w u z) in *.
  destruct (Rle_lt_dec 0 a') as [Na|Na], (Rle_lt_dec 0 b') as [Nb|Nb], (Rle_lt_dec 0 c') as [Nc|Nc];
    [left; repeat split; assumption|..]; right;
    destruct (Rle_lt_dec 0 (a * b' - a' * b)) as [Qab|Qab], (Rle_lt_dec 0 (b * c' - b' * c)) as [Qbc|Qbc],
      (Rle_lt_dec 0 (c * a' - c' * a)) as [Qca|Qca];
  first
  [ exists u, v, w; split; [now auto|fold a b c a' b' c'; split; [assumption|split; nra]]
  | exists v, w, u; split; [now auto|fold a b c a' b' c'; split; [assumption|split; nra]]
  | exists w, u, v; split; [now auto|fold a b c a' b' c'; split; [assumption|split; nra]]
  | exfalso; nra ].
Qed.

(** z lies in the closed triangle pqr: on the left of each side, or on it. *)
Definition in_triangle (z p q r : C) : Prop := 0 <= det p q z /\ 0 <= det q r z /\ 0 <= det r p z.

(** * Lines and points *)

Lemma det_scaled : forall u v w, in_plane u -> in_plane v -> in_plane w -> exists m, 0 < m /\
  det u v w = volume (lift u) (lift v) (lift w) * m.
Proof.
  intros u v w Hu Hv Hw. pose proof (volume_lift u v w Hu Hv Hw) as E. unfold in_plane in *.
  eexists. split; [|symmetry; exact E]. repeat apply Rmult_lt_0_compat; lra.
Qed.

Lemma counterclockwise_volume : forall u v w, in_plane u -> in_plane v -> in_plane w ->
  counterclockwise u v w <-> 0 < volume (lift u) (lift v) (lift w).
Proof.
  intros u v w Hu Hv Hw. unfold counterclockwise. destruct (det_scaled u v w Hu Hv Hw) as [m [M ->]]. split; nra.
Qed.

Lemma in_triangle_contains : forall z p q r, in_plane z -> in_plane p -> in_plane q -> in_plane r ->
  in_triangle z p q r <-> contains (lift p) (lift q) (lift r) (lift z).
Proof.
  intros z p q r Hz Hp Hq Hr. unfold in_triangle, contains.
  destruct (det_scaled p q z Hp Hq Hz) as [a [A ->]]. destruct (det_scaled q r z Hq Hr Hz) as [b [B ->]].
  destruct (det_scaled r p z Hr Hp Hz) as [c [C' ->]]. split; intros [H1 [H2 H3]]; repeat split; nra.
Qed.

Lemma project_lift : forall z, in_plane z -> project (lift z) = z.
Proof.
  intros [x y] H. unfold in_plane, project, lift in *. cbn [vx vy vt].
  assert (1 + (1 + abs2 (x, y)) / (1 - abs2 (x, y)) = 2 / (1 - abs2 (x, y))) as -> by (field; lra).
  apply C_eq; cbn [Re Im fst snd]; unfold Re, Im; cbn [fst snd]; field; lra.
Qed.

(** Vectors with z below them; |z|² is at most that of the point of the Klein model. *)
Lemma point_below : forall y k, 0 < vt y -> k < 1 -> vx y * vx y + vy y * vy y <= k * (vt y * vt y) ->
  exists z m, in_plane z /\ abs2 z <= k /\ 0 < m /\ lift z = combination m y 0 y.
Proof.
  intros y k T K H.
  set (g := vt y * vt y - (vx y * vx y + vy y * vy y)).
  assert (0 < vt y * vt y) as T2 by now apply Rmult_lt_0_compat.
  assert (0 < g) as G by (unfold g; nra).
  assert (0 < sqrt g) as S by now apply sqrt_lt_R0. assert (sqrt g * sqrt g = g) as S2 by (apply sqrt_sqrt; lra).
  set (m := / sqrt g). assert (0 < m) as M by now apply Rinv_0_lt_compat.
  assert (m * m * (sqrt g * sqrt g) = 1) as M2 by (unfold m; field; lra). rewrite S2 in M2.
  assert (exists u, u = combination m y 0 y) as [u Eu] by eauto.
  assert (vx u = m * vx y /\ vy u = m * vy y /\ vt u = m * vt y) as [Ux [Uy Ut]]
    by (rewrite Eu; unfold combination; simpl; repeat split; ring).
  assert (is_unit u) as U by (unfold is_unit, dot; rewrite Ux, Uy, Ut; unfold g in M2; lra).
  assert (0 < vt u) as F by (rewrite Ut; now apply Rmult_lt_0_compat).
  exists (project u), m. split; [now apply project_in_plane|].
  split; [|split; [auto|rewrite <- Eu; now apply lift_project]].
  unfold project, abs2, Re, Im. cbn [fst snd].
  assert (vx u * vx u + vy u * vy u <= k * (vt u * vt u)) as L.
  { rewrite Ux, Uy, Ut. replace (m * vx y * (m * vx y) + m * vy y * (m * vy y))
      with (m * m * (vx y * vx y + vy y * vy y)) by ring.
    replace (k * (m * vt y * (m * vt y))) with (m * m * (k * (vt y * vt y))) by ring.
    apply Rmult_le_compat_l; auto. nra. }
  assert (0 <= k) as K0 by nra.
  set (t := vt u) in *.
  apply Rmult_le_reg_r with ((1 + t) * (1 + t)); [nra|].
  replace ((vx u / (1 + t) * (vx u / (1 + t)) + vy u / (1 + t) * (vy u / (1 + t))) * ((1 + t) * (1 + t)))
    with (vx u * vx u + vy u * vy u) by (field; lra).
  apply Rle_trans with (k * (t * t)); auto. apply Rmult_le_compat_l; nra.
Qed.

(** The cone of vectors above a smaller disk is convex. *)
Definition above (k : R) (y : vector) : Prop := 0 < vt y /\ vx y * vx y + vy y * vy y <= k * (vt y * vt y).

Lemma above_combination : forall k u v l m, 0 <= k -> above k u -> above k v -> 0 < l -> 0 <= m ->
  above k (combination l u m v).
Proof.
  intros k u v l m K [T U] [T' V] L M. unfold above, combination. simpl. split; [nra|].
  set (i := vx u * vx v + vy u * vy v).
  assert (i * i <= (k * (vt u * vt v)) * (k * (vt u * vt v))) as Q.
  { apply Rle_trans with ((vx u * vx u + vy u * vy u) * (vx v * vx v + vy v * vy v)).
    - pose proof (Rle_0_sqr (vx u * vy v - vy u * vx v)) as P. unfold Rsqr in P. unfold i. lra.
    - replace (k * (vt u * vt v) * (k * (vt u * vt v))) with (k * (vt u * vt u) * (k * (vt v * vt v))) by ring.
      apply Rmult_le_compat; nra. }
  assert (0 <= k * (vt u * vt v)) as P by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
  assert (i <= k * (vt u * vt v)) as I by nra.
  assert (l * m * i <= l * m * (k * (vt u * vt v))) by (apply Rmult_le_compat_l; [nra|auto]).
  assert (l * l * (vx u * vx u + vy u * vy u) <= l * l * (k * (vt u * vt u))) by (apply Rmult_le_compat_l; [nra|auto]).
  assert (m * m * (vx v * vx v + vy v * vy v) <= m * m * (k * (vt v * vt v))) by (apply Rmult_le_compat_l; [nra|auto]).
  unfold i in *. lra.
Qed.

Lemma above_more : forall k k' y, k <= k' -> above k y -> above k' y.
Proof. intros k k' y L [T H]. split; auto. assert (0 <= vt y * vt y) by nra. nra. Qed.

Lemma above_lift : forall z, in_plane z -> exists k, 0 <= k < 1 /\ above k (lift z).
Proof.
  intros z H. pose proof (unit_lift z H) as U. pose proof (lift_future z H) as T. unfold is_unit, dot in U.
  set (u := lift z) in *. assert (0 < vt u * vt u) as P by now apply Rmult_lt_0_compat.
  assert (0 < / (vt u * vt u)) as I by now apply Rinv_0_lt_compat.
  assert (vx u * vx u + vy u * vy u = (1 - / (vt u * vt u)) * (vt u * vt u)) as E by (field_simplify; lra).
  exists (1 - / (vt u * vt u)). split; [|split; [auto|lra]]. split; [|lra].
  assert (0 <= vx u * vx u + vy u * vy u) by nra. apply Rnot_lt_le. intro L. nra.
Qed.

(** Different points have independent vectors. *)
Lemma same_line : forall z w, in_plane z -> in_plane w ->
  (forall x, volume x (lift z) (lift w) = 0) -> z = w.
Proof.
  intros z w Hz Hw H. rewrite <- (project_lift z), <- (project_lift w) by auto.
  pose proof (unit_lift z Hz) as U. pose proof (unit_lift w Hw) as V.
  pose proof (lift_future z Hz) as T. pose proof (lift_future w Hw) as S.
  set (u := lift z) in *. set (v := lift w) in *.
  pose proof (H (Vector 1 0 0)) as X. pose proof (H (Vector 0 1 0)) as Y.
  clearbody u v. unfold volume, is_unit, dot in *. cbn [vx vy vt] in X, Y.
  assert (vy u * vt v = vy v * vt u) as EY by lra. assert (vx u * vt v = vx v * vt u) as EX by lra.
  assert (vt u * vt u = vt v * vt v) as ET.
  { assert ((vt u * vt u - (vx u * vx u + vy u * vy u)) * (vt v * vt v) =
            (vt v * vt v - (vx v * vx v + vy v * vy v)) * (vt u * vt u)) as Q.
    { replace ((vt u * vt u - (vx u * vx u + vy u * vy u)) * (vt v * vt v))
        with (vt u * vt u * (vt v * vt v) - ((vx u * vt v) * (vx u * vt v) + (vy u * vt v) * (vy u * vt v))) by ring.
      rewrite EX, EY. ring. }
    replace (vt u * vt u - (vx u * vx u + vy u * vy u)) with 1 in Q by lra.
    replace (vt v * vt v - (vx v * vx v + vy v * vy v)) with 1 in Q by lra. lra. }
  assert (vt u = vt v) as E.
  { assert ((vt u - vt v) * (vt u + vt v) = 0) as Q by lra. apply Rmult_integral in Q. destruct Q; lra. }
  rewrite E in EX, EY. apply Rmult_eq_reg_r in EX; [|lra]. apply Rmult_eq_reg_r in EY; [|lra].
  unfold project. now rewrite E, EX, EY.
Qed.

(** * Avoiding lines *)

Lemma avoid_points : forall (l : list R) lo hi, lo < hi -> exists s, lo < s < hi /\ ~ In s l.
Proof.
  induction l as [|y l IH]; intros lo hi H.
  - exists ((lo + hi) / 2). split; [lra|]. intros [].
  - destruct (Rlt_le_dec lo y) as [A|A].
    + destruct (IH lo (Rmin y hi)) as [s [[S1 S2] N]]; [now apply Rmin_glb_lt|].
      assert (s < y /\ s < hi) as [L1 L2] by (split; eapply Rlt_le_trans; eauto using Rmin_l, Rmin_r).
      exists s. split; [lra|]. intros [E|I]; [lra|auto].
    + destruct (IH lo hi H) as [s [S N]]. exists s. split; auto. intros [E|I]; [lra|auto].
Qed.

Lemma two_roots : forall a b c, ~ (a = 0 /\ b = 0 /\ c = 0) ->
  exists l, forall s, a + b * s + c * (s * s) = 0 -> In s l.
Proof.
  intros a b c N.
  destruct (classic (exists y, a + b * y + c * (y * y) = 0)) as [[y Hy]|F].
  - destruct (Req_dec c 0) as [->|D].
    + exists [y]. intros s H. left. destruct (Req_dec b 0) as [->|B]; [exfalso; apply N; lra|].
      apply Rmult_eq_reg_l with b; auto. lra.
    + exists [y; - b / c - y]. intros s H.
      assert ((s - y) * (c * (s + y) + b) = 0) as P by lra.
      apply Rmult_integral in P. destruct P as [P|P]; [left; lra|right; left].
      apply Rmult_eq_reg_l with c; auto. replace (c * (- b / c - y)) with (- b - c * y) by (field; auto). lra.
  - exists []. intros s H. apply F. eauto.
Qed.

Lemma avoid_roots : forall l : list (R * R * R), (forall a b c, In (a, b, c) l -> ~ (a = 0 /\ b = 0 /\ c = 0)) ->
  exists s, 0 < s < 1 /\ forall a b c, In (a, b, c) l -> a + b * s + c * (s * s) <> 0.
Proof.
  intros l H.
  assert (exists roots, forall a b c, In (a, b, c) l -> forall s, a + b * s + c * (s * s) = 0 -> In s roots)
    as [roots R].
  { induction l as [|[[a b] c] l IH]; [exists []; intros a b c []|].
    destruct IH as [r1 R1]; [intros; apply H; now right|].
    destruct (two_roots a b c) as [r2 R2]; [apply H; now left|].
    exists (r2 ++ r1). intros a' b' c' [E|I] s Z; apply in_or_app; [left|right; eauto].
    inversion E; subst. auto. }
  destruct (avoid_points roots 0 1) as [s [S N]]; [lra|]. exists s. split; auto. intros a b c I Z. eauto.
Qed.
