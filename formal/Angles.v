(** Rule surface, (g): full turns counted by half-planes add up angles. *)

From Coq Require Import ZArith Reals List Bool Lia Lra Psatz.
From Epsnet Require Import Document Statement Plane Integers.
Import ListNotations.
Open Scope R_scope.

(** A number in the open upper half-plane in polar coordinates. *)
Lemma polar : forall w : C, 0 < Im w ->
  let t := acos (Re w / sqrt (abs2 w)) in
  0 < t < PI /\ 0 < sqrt (abs2 w) /\ w = (sqrt (abs2 w) * cos t, sqrt (abs2 w) * sin t).
Proof.
  intros [u v] H. cbn [Im Re fst snd] in *. simpl in H. cbv zeta.
  assert (0 < abs2 (u, v)) as A by (coordinates; nra).
  set (r := sqrt (abs2 (u, v))).
  assert (0 < r) as P by now apply sqrt_lt_R0.
  assert (r * r = u * u + v * v) as E by (unfold r; rewrite sqrt_sqrt; [reflexivity|lra]).
  assert (-1 < u / r < 1) as B.
  { split; apply Rmult_lt_reg_r with r; auto; unfold Rdiv; rewrite ?Rmult_assoc, ?Rinv_l, ?Rmult_1_r by lra; nra. }
  split; [now apply acos_bound_lt|]. split; auto.
  rewrite cos_acos, sin_acos by lra. apply C_eq; simpl; [field; lra|].
  assert (sqrt (1 - (u / r)²) = v / r) as ->; [|field; lra].
  apply sqrt_lem_1; unfold Rsqr.
  - assert (u / r * (u / r) <= 1) by nra. lra.
  - apply Rlt_le, Rdiv_lt_0_compat; auto.
  - field_simplify; [|lra|lra]. apply Rmult_eq_reg_r with (r * r); [|nra]. field_simplify; [nra|lra|lra].
Qed.

(** The angle does not change with positive real factors. *)
Lemma acos_scale : forall r (w : C), 0 < r ->
  Re (Cmul (r, 0) w) / sqrt (abs2 (Cmul (r, 0) w)) = Re w / sqrt (abs2 w).
Proof.
  intros r w H. rewrite abs2_mul.
  assert (sqrt (abs2 (r, 0) * abs2 w) = r * sqrt (abs2 w)) as ->.
  { rewrite sqrt_mult by apply abs2_nonneg. f_equal. unfold abs2. simpl.
    replace (r * r + 0 * 0) with (r * r) by ring. apply sqrt_square. lra. }
  replace (Re (Cmul (r, 0) w)) with (r * Re w) by (coordinates; ring).
  destruct (Req_dec (sqrt (abs2 w)) 0) as [E|E].
  - rewrite E, Rmult_0_r. unfold Rdiv. rewrite Rinv_0. ring.
  - field. lra.
Qed.

Section Turns.
Variable n : net.
Variable angle_of : N -> R.
Hypothesis angle_of_turn : forall s, K.turn_fits n s = true ->
  exists r, 0 < r /\ 0 < angle_of s < PI /\
  complex (K.turn n s) = (r * cos (angle_of s), r * sin (angle_of s)).

Definition has_direction (z : K.gauss) (t : R) : Prop :=
  exists r, 0 < r /\ complex z = (r * cos t, r * sin t) /\ 0 <= t < 2 * PI.

Lemma below_iff : forall z t, has_direction z t -> K.below z = true <-> PI <= t.
Proof.
  intros z t [r [Hr [E Ht]]]. unfold complex in E. injection E as Ex Ey.
  unfold K.below. rewrite orb_true_iff, andb_true_iff, !Z.ltb_lt, Z.eqb_eq.
  assert ((K.y z < 0)%Z <-> sin t < 0) as Hy.
  { split; intro H.
    - apply IZR_lt in H. rewrite Ey in H. nra.
    - apply lt_IZR. rewrite Ey. nra. }
  assert ((K.x z < 0)%Z <-> cos t < 0) as Hx.
  { split; intro H.
    - apply IZR_lt in H. rewrite Ex in H. nra.
    - apply lt_IZR. rewrite Ex. nra. }
  assert ((K.y z = 0)%Z <-> sin t = 0) as H0.
  { split; intro H.
    - apply (f_equal IZR) in H. rewrite Ey in H. nra.
    - apply eq_IZR. rewrite Ey, H. ring. }
  rewrite Hy, Hx, H0. split.
  - intros [H|[H1 H2]]; apply Rnot_lt_le; intro L.
    + assert (0 <= sin t) by (apply sin_ge_0; lra). lra.
    + destruct (Req_dec t 0) as [->|]; [rewrite cos_0 in H2; lra|].
      assert (0 < sin t) by (apply sin_gt_0; lra). lra.
  - intros [H|<-].
    + left. apply sin_lt_0; lra.
    + right. rewrite sin_PI, cos_PI. lra.
Qed.

Lemma full_turns_sum : forall c z t turns, has_direction z t -> forallb (K.turn_fits n) c = true ->
  let (z', turns') := K.full_turns n c z turns in
  exists t', has_direction z' t' /\
    t' + 2 * PI * IZR turns' = t + 2 * PI * IZR turns + sum angle_of c.
Proof.
  induction c as [|s c IH]; intros z t turns H F; cbn [K.full_turns sum fold_right].
  - exists t. split; auto. unfold sum. simpl. ring.
  - cbn [forallb] in F. apply andb_prop in F. destruct F as [Fs F].
    destruct (angle_of_turn s Fs) as [q [Hq [Ha Eq]]].
    pose proof (below_iff z t H) as B.
    destruct H as [r [Hr [E Ht]]].
    assert (forall u, cos u = cos (t + angle_of s) -> sin u = sin (t + angle_of s) ->
      complex (K.mul z (K.turn n s)) = (r * q * cos u, r * q * sin u)) as P.
    { intros u -> ->. rewrite complex_mul, E, Eq, cos_plus, sin_plus. apply C_eq; coordinates; ring. }
    assert (0 < r * q) as Hrq by nra.
    destruct (Rlt_le_dec (t + angle_of s) (2 * PI)) as [L|L].
    + assert (has_direction (K.mul z (K.turn n s)) (t + angle_of s)) as D.
      { exists (r * q). split; auto. split; [now apply P|lra]. }
      assert (K.below z && negb (K.below (K.mul z (K.turn n s))) = false) as ->.
      { pose proof (below_iff _ _ D) as B'. destruct (K.below z); auto. simpl.
        assert (K.below (K.mul z (K.turn n s)) = true) as ->; auto.
        apply B'. assert (PI <= t) by now apply B. lra. }
      specialize (IH _ _ turns D F). destruct (K.full_turns n c _ _) as [z' turns'].
      destruct IH as [t' [D' S]]. exists t'. split; auto. rewrite S. unfold sum. simpl. ring.
    + assert (has_direction (K.mul z (K.turn n s)) (t + angle_of s - 2 * PI)) as D.
      { exists (r * q). split; auto. split; [|lra].
        set (u := t + angle_of s - 2 * PI).
        apply P; [rewrite <- (cos_period u 1)|rewrite <- (sin_period u 1)]; unfold u; f_equal; simpl; ring. }
      assert (K.below z && negb (K.below (K.mul z (K.turn n s))) = true) as ->.
      { pose proof (below_iff _ _ D) as B'.
        assert (K.below z = true) as -> by (apply B; lra). simpl.
        destruct (K.below (K.mul z (K.turn n s))); auto.
        assert (PI <= t + angle_of s - 2 * PI) by now apply B'. lra. }
      specialize (IH _ _ (turns + 1)%Z D F). destruct (K.full_turns n c _ _) as [z' turns'].
      destruct IH as [t' [D' S]]. exists t'. split; auto. rewrite S, plus_IZR. unfold sum. simpl. ring.
Qed.

Lemma one_turn_sum : forall c, K.one_turn n c = true -> sum angle_of c = 2 * PI.
Proof.
  intros c H. unfold K.one_turn in H. apply andb_prop in H. destruct H as [F H].
  assert (has_direction (K.Gauss 1 0) 0) as D.
  { exists 1. pose proof PI_RGT_0. rewrite cos_0, sin_0. split; [lra|]. split; [|lra].
    apply C_eq; simpl; ring. }
  pose proof (full_turns_sum c _ _ 0 D F) as S. destruct (K.full_turns n c _ _) as [z turns].
  booleans. subst turns. destruct S as [t [[r [Hr [E Ht]]] S]].
  unfold complex in E. injection E as Ex Ey.
  assert (sin t = 0) as Z by (apply (f_equal IZR) in H1; rewrite Ey in H1; nra).
  assert (0 < cos t) as P by (apply IZR_pos in H0; rewrite Ex in H0; nra).
  assert (t = 0) as ->.
  { destruct (Req_dec t 0) as [|N0]; auto. exfalso.
    destruct (Rtotal_order t PI) as [L|[->|L]].
    - assert (0 < sin t) by (apply sin_gt_0; lra). lra.
    - rewrite cos_PI in P. lra.
    - assert (sin t < 0) by (apply sin_lt_0; lra). lra. }
  lra.
Qed.
End Turns.
