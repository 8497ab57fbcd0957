(** The checker's integers stand for real numbers, points and isometries. *)

From Coq Require Import ZArith Reals List Bool Lia Lra Psatz.
From Epsnet Require Import Document Statement Plane.
From Epsnet Require Checker.
Import ListNotations.
Module K := Checker.
Open Scope R_scope.

Definition complex (z : K.gauss) : C := (IZR (K.x z), IZR (K.y z)).
Definition real (f : K.iso) : isometry := Isometry (complex (K.a f)) (complex (K.b f)).

Ltac booleans :=
  repeat match goal with
  | H : _ && _ = true |- _ => apply andb_prop in H; destruct H
  | H : Z.eqb _ _ = true |- _ => apply Z.eqb_eq in H
  | H : Z.ltb _ _ = true |- _ => apply Z.ltb_lt in H
  | H : Z.leb _ _ = true |- _ => apply Z.leb_le in H
  | H : N.eqb _ _ = true |- _ => apply N.eqb_eq in H
  | H : N.ltb _ _ = true |- _ => apply N.ltb_lt in H
  | H : N.leb _ _ = true |- _ => apply N.leb_le in H
  | H : negb _ = true |- _ => apply negb_true_iff in H
  | H : Z.eqb _ _ = false |- _ => apply Z.eqb_neq in H
  | H : N.eqb _ _ = false |- _ => apply N.eqb_neq in H
  | H : N.ltb _ _ = false |- _ => apply N.ltb_ge in H
  | H : Z.ltb _ _ = false |- _ => apply Z.ltb_ge in H
  end.

Ltac reals :=
  repeat first [rewrite plus_IZR | rewrite minus_IZR | rewrite opp_IZR | rewrite mult_IZR].

Lemma complex_add : forall z w, complex (K.add z w) = Cadd (complex z) (complex w).
Proof. intros. apply C_eq; unfold complex, K.add; coordinates; reals; ring. Qed.
Lemma complex_mul : forall z w, complex (K.mul z w) = Cmul (complex z) (complex w).
Proof. intros. apply C_eq; unfold complex, K.mul; coordinates; reals; ring. Qed.
Lemma complex_conj : forall z, complex (K.conj z) = Cconj (complex z).
Proof. intros. apply C_eq; unfold complex, K.conj; coordinates; reals; ring. Qed.
Lemma complex_scale : forall n z, complex (K.scale n z) = Cmul (IZR n, 0) (complex z).
Proof. intros. apply C_eq; unfold complex, K.scale; coordinates; reals; ring. Qed.
Lemma complex_norm : forall z, IZR (K.norm z) = abs2 (complex z).
Proof. intros. unfold complex, K.norm. coordinates. reals. ring. Qed.

Lemma real_compose : forall f g, real (K.compose f g) = compose (real f) (real g).
Proof.
  intros. unfold real, compose, K.compose. simpl.
  now rewrite !complex_add, !complex_mul, !complex_conj.
Qed.
Lemma real_inverse : forall f, real (K.inverse f) = inverse (real f).
Proof.
  intros. unfold real, inverse, K.inverse. simpl. rewrite complex_conj. f_equal.
  apply C_eq; unfold complex, K.neg; coordinates; reals; ring.
Qed.
Lemma real_norm : forall f, IZR (K.norm_iso f) = norm (real f).
Proof. intros. unfold K.norm_iso, norm. rewrite minus_IZR, !complex_norm. reflexivity. Qed.

Lemma IZR_pos : forall n, (0 < n)%Z -> 0 < IZR n.
Proof. intros. now apply (IZR_lt 0). Qed.

Lemma proper_real : forall f, (0 < K.norm_iso f)%Z -> proper (real f).
Proof. intros. apply proper_norm. rewrite <- real_norm. now apply IZR_pos. Qed.

(** * Quotients by common divisors *)

Lemma quotient : forall g n, (g | n)%Z -> (n = g * (n / g))%Z.
Proof.
  intros g n [k ->]. destruct (Z.eq_dec g 0) as [->|].
  - rewrite Zdiv_0_r. lia.
  - rewrite Z.div_mul; lia.
Qed.

Lemma same_reduce : forall f, same (real f) (real (K.reduce f)).
Proof.
  intros [[ax ay] [bx by_]]. unfold K.reduce. simpl.
  set (g1 := Z.gcd ax ay). set (g2 := Z.gcd bx by_). set (g := Z.gcd g1 g2).
  destruct (Z.ltb_spec 1 g) as [H|H]; [|apply same_refl].
  assert (g | g1)%Z as D1 by apply Z.gcd_divide_l.
  assert (g | g2)%Z as D2 by apply Z.gcd_divide_r.
  assert (g1 | ax)%Z as Dax by apply Z.gcd_divide_l.
  assert (g1 | ay)%Z as Day by apply Z.gcd_divide_r.
  assert (g2 | bx)%Z as Dbx by apply Z.gcd_divide_l.
  assert (g2 | by_)%Z as Dby by apply Z.gcd_divide_r.
  pose proof (quotient g ax (Z.divide_trans _ _ _ D1 Dax)). pose proof (quotient g ay (Z.divide_trans _ _ _ D1 Day)).
  pose proof (quotient g bx (Z.divide_trans _ _ _ D2 Dbx)). pose proof (quotient g by_ (Z.divide_trans _ _ _ D2 Dby)).
  exists (IZR g). split; [apply not_0_IZR; lia|].
  split; apply C_eq; unfold complex; coordinates; ring_simplify; rewrite <- mult_IZR; now f_equal.
Qed.

(** * Points *)

Lemma to_C_num : forall z, (den z <> 0)%Z -> Cmul (IZR (den z), 0) (to_C z) = complex (K.num z).
Proof.
  intros z H. apply not_0_IZR in H. unfold to_C, K.num, complex. apply C_eq; coordinates; field; auto.
Qed.

Lemma to_C_multiple : forall g x y m, g <> 0%Z -> m <> 0%Z -> to_C (Point (g * x) (g * y) (g * m)) = to_C (Point x y m).
Proof.
  intros g x y m H K. apply not_0_IZR in H, K. unfold to_C. simpl. rewrite !mult_IZR.
  apply C_eq; coordinates; field; auto.
Qed.

Lemma to_C_lowest_terms : forall n m,
  (0 < den (K.lowest_terms n m))%Z -> m <> 0%Z /\ to_C (K.lowest_terms n m) = to_C (Point (K.x n) (K.y n) m).
Proof.
  intros [nx ny] m. unfold K.lowest_terms. simpl.
  set (g1 := Z.gcd nx ny). set (g := Z.gcd g1 m).
  destruct (Z.ltb_spec 1 g) as [H|H]; simpl; intro P; [|split; [lia|reflexivity]].
  assert (g | g1)%Z as D1 by apply Z.gcd_divide_l.
  assert (g | m)%Z as D2 by apply Z.gcd_divide_r.
  assert (g1 | nx)%Z as Dx by apply Z.gcd_divide_l.
  assert (g1 | ny)%Z as Dy by apply Z.gcd_divide_r.
  pose proof (quotient g m D2) as Em.
  pose proof (quotient g nx (Z.divide_trans _ _ _ D1 Dx)) as Ex.
  pose proof (quotient g ny (Z.divide_trans _ _ _ D1 Dy)) as Ey.
  split; [intro Z; rewrite Z in P; rewrite Zdiv_0_l in P; lia|].
  rewrite <- (to_C_multiple g) by lia. now rewrite <- Em, <- Ex, <- Ey.
Qed.

Lemma to_C_quotient : forall n d, complex d <> C0 ->
  to_C (Point (K.x (K.mul n (K.conj d))) (K.y (K.mul n (K.conj d))) (K.norm d)) = Cdiv (complex n) (complex d).
Proof.
  intros [nx ny] [dx dy] H. apply abs2_pos in H. unfold to_C, complex, K.norm, K.mul, K.conj in *.
  apply C_eq; coordinates; rewrite ?minus_IZR, ?plus_IZR, ?mult_IZR, ?opp_IZR; field; lra.
Qed.

Lemma image_act : forall f z,
  (0 < den (K.image f z))%Z -> den z <> 0%Z -> to_C (K.image f z) = act (real f) (to_C z).
Proof.
  intros f z H K. unfold K.image in *. apply to_C_lowest_terms in H. destruct H as [M ->].
  set (n := K.add (K.mul (K.a f) (K.num z)) (K.scale (den z) (K.b f))) in *.
  set (d := K.add (K.mul (K.conj (K.b f)) (K.num z)) (K.scale (den z) (K.conj (K.a f)))) in *.
  assert (complex d <> C0) as D.
  { apply abs2_nonzero. rewrite <- complex_norm. now apply not_0_IZR. }
  rewrite to_C_quotient by auto.
  subst n d. rewrite !complex_add, !complex_mul, !complex_scale, !complex_conj in *. unfold act. simpl.
  rewrite <- to_C_num in * by auto.
  assert ((IZR (den z), 0) <> C0) as E.
  { intro E. apply (f_equal Re) in E. simpl in E. now apply not_0_IZR in K. }
  set (m := (IZR (den z), 0)) in *.
  assert (Cadd (Cmul (Cconj (complex (K.b f))) (Cmul m (to_C z))) (Cmul m (Cconj (complex (K.a f)))) =
          Cmul m (Cadd (Cmul (Cconj (complex (K.b f))) (to_C z)) (Cconj (complex (K.a f))))) as F by ring.
  field. split; auto. intro G. apply D. rewrite F, G. ring.
Qed.

Lemma in_disk_plane : forall z, K.in_disk z = true -> (0 < den z)%Z /\ in_plane (to_C z).
Proof.
  intros z H. unfold K.in_disk in H. booleans. split; auto.
  unfold in_plane, to_C. coordinates. apply IZR_pos in H. unfold K.gap, K.norm, K.num in H0. simpl in H0.
  assert (re z * re z + im z * im z < den z * den z)%Z as I by lia.
  apply IZR_lt in I. rewrite plus_IZR, !mult_IZR in I.
  apply Rmult_lt_reg_r with (IZR (den z) * IZR (den z)); [nra|].
  field_simplify; nra.
Qed.

Lemma gap_real : forall z, (den z <> 0)%Z -> IZR (K.gap z) = IZR (den z) * IZR (den z) * (1 - abs2 (to_C z)).
Proof.
  intros z H. apply not_0_IZR in H. unfold K.gap, K.norm, K.num, to_C. coordinates. reals. field. auto.
Qed.

Lemma squared_difference_real : forall z w, (den z <> 0)%Z -> (den w <> 0)%Z ->
  IZR (K.squared_difference z w) =
  IZR (den z) * IZR (den z) * (IZR (den w) * IZR (den w)) * abs2 (Csub (to_C z) (to_C w)).
Proof.
  intros z w H K. apply not_0_IZR in H, K. unfold K.squared_difference, K.norm, K.sub, K.scale, K.num, to_C.
  coordinates. reals. field. auto.
Qed.

Lemma orientation_counterclockwise : forall u v w,
  (0 < den u)%Z -> (0 < den v)%Z -> (0 < den w)%Z -> (0 < K.orientation u v w)%Z ->
  counterclockwise (to_C u) (to_C v) (to_C w).
Proof.
  intros u v w Hu Hv Hw H. apply IZR_pos in Hu, Hv, Hw, H. unfold counterclockwise.
  assert (IZR (K.orientation u v w) * 4 =
    (IZR (den u) * IZR (den u)) * (IZR (den v) * IZR (den v)) * (IZR (den w) * IZR (den w)) *
    det (to_C u) (to_C v) (to_C w)) as E.
  { unfold K.orientation, K.norm, K.num, det, to_C. coordinates. reals. field. lra. }
  set (p := (IZR (den u) * IZR (den u)) * (IZR (den v) * IZR (den v)) * (IZR (den w) * IZR (den w))) in *.
  assert (0 < p) by (unfold p; repeat apply Rmult_lt_0_compat; auto).
  apply Rmult_lt_reg_l with p; auto. rewrite Rmult_0_r, <- E. lra.
Qed.

Lemma same_point_eq : forall z w, (0 < den z)%Z -> (0 < den w)%Z -> K.same_point z w = true -> to_C z = to_C w.
Proof.
  intros z w Hz Hw H. unfold K.same_point in H. booleans. apply IZR_pos in Hz, Hw.
  apply (f_equal IZR) in H, H0. rewrite !mult_IZR in H, H0.
  apply C_eq; unfold to_C; coordinates; apply Rmult_eq_reg_r with (IZR (den z) * IZR (den w)); try nra;
    field_simplify; nra.
Qed.

Lemma same_iso_same : forall f g, K.same_iso f g = true -> same (real f) (real g).
Proof.
  intros f g H. unfold K.same_iso, K.is_identity in H. set (m := K.compose (K.inverse f) g) in *. booleans.
  apply same_of_quotient; rewrite <- ?real_norm, <- ?real_inverse, <- ?real_compose; try (now apply not_0_IZR).
  - change (IZR (K.y (K.a m)) = IZR 0). now f_equal.
  - apply C_eq; [change (IZR (K.x (K.b m)) = IZR 0)|change (IZR (K.y (K.b m)) = IZR 0)]; now f_equal.
Qed.

Lemma real_translation : forall c, (0 < den c)%Z -> same (real (K.translation c)) (translation (to_C c)).
Proof.
  intros c H. exists (IZR (den c)). split; [apply not_0_IZR; lia|]. unfold real, K.translation, translation. simpl.
  apply IZR_pos in H. split; apply C_eq; unfold complex, K.num, to_C; coordinates; field; lra.
Qed.

(** * Products *)

Definition product (path : list isometry) : isometry := fold_right (fun f g => compose g f) identity path.

Lemma same_neighbours : forall path,
  same (product (map real (K.neighbours path))) (product (map real path)) /\
  forall f, same (product (map real (K.neighbours (f :: path)))) (product (map real (f :: path))).
Proof.
  induction path as [|g path [IH1 IH2]]; split.
  - apply same_refl.
  - intros; apply same_refl.
  - apply IH2.
  - intros f. simpl K.neighbours.
    change (map real (K.reduce (K.compose g f) :: K.neighbours path))
      with (real (K.reduce (K.compose g f)) :: map real (K.neighbours path)).
    simpl product. rewrite compose_assoc. apply same_compose; [apply IH1|].
    rewrite <- real_compose. apply same_sym, same_reduce.
Qed.

Lemma same_product : forall fuel path, same (real (K.product fuel path)) (product (map real path)).
Proof.
  assert (forall path, real (fold_right (fun f g => K.compose g f) K.identity path) = product (map real path)) as F.
  { induction path as [|f path IH]; [reflexivity|]. simpl. now rewrite real_compose, IH. }
  assert (forall f, real f = product (map real [f])) as G by (intros; simpl; now rewrite compose_identity_l).
  induction fuel as [|h fuel IH]; intros [|f [|g path]]; try apply same_refl.
  - simpl K.product. rewrite <- G. apply same_refl.
  - rewrite <- F. apply same_refl.
  - simpl K.product. rewrite <- G. apply same_refl.
  - cbn [K.product]. eapply same_trans; [apply IH|]. apply same_neighbours.
Qed.
