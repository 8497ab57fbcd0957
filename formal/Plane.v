(** Lemmas about complex numbers, isometries and points of the disk. *)

From Coq Require Import Reals Lra Psatz Field.
From Epsnet Require Import Document Statement.
Open Scope R_scope.

(** * Complex numbers are a field *)

Definition C0 : C := (0, 0).
Definition C1 : C := (1, 0).
Definition Copp (z : C) : C := (- Re z, - Im z).

Lemma C_eq : forall z w : C, Re z = Re w -> Im z = Im w -> z = w.
Proof. intros [] [] H K. cbv in H, K. now subst. Qed.

Ltac coordinates :=
  unfold Cdiv, Cinv, Cmul, Cadd, Csub, Copp, Cconj, C0, C1, abs2, Re, Im in *; simpl in *.

Lemma abs2_pos : forall z, z <> C0 -> 0 < abs2 z.
Proof.
  intros [u v] H. coordinates.
  destruct (Req_dec u 0) as [->|]; [destruct (Req_dec v 0) as [->|]; [now destruct H|nra]|nra].
Qed.

Lemma abs2_nonneg : forall z, 0 <= abs2 z.
Proof. intros [u v]. coordinates. nra. Qed.

Lemma abs2_nonzero : forall z, abs2 z <> 0 -> z <> C0.
Proof. intros z H ->. apply H. coordinates. ring. Qed.

Lemma C_field : field_theory C0 C1 Cadd Cmul Csub Copp Cdiv Cinv eq.
Proof.
  constructor.
  - constructor; intros; apply C_eq; coordinates; ring.
  - intro H. apply (f_equal Re) in H. coordinates. lra.
  - reflexivity.
  - intros z H. apply abs2_pos in H. destruct z as [u v].
    apply C_eq; coordinates; field; lra.
Qed.
Add Field C_field_instance : C_field.

Lemma conj_add : forall z w, Cconj (Cadd z w) = Cadd (Cconj z) (Cconj w).
Proof. intros. apply C_eq; coordinates; ring. Qed.
Lemma conj_mul : forall z w, Cconj (Cmul z w) = Cmul (Cconj z) (Cconj w).
Proof. intros. apply C_eq; coordinates; ring. Qed.
Lemma conj_conj : forall z, Cconj (Cconj z) = z.
Proof. intros. apply C_eq; coordinates; ring. Qed.
Lemma abs2_mul : forall z w, abs2 (Cmul z w) = abs2 z * abs2 w.
Proof. intros [] []. coordinates. ring. Qed.
Lemma abs2_inv : forall z, z <> C0 -> abs2 (Cinv z) = / abs2 z.
Proof. intros [u v] H. apply abs2_pos in H. coordinates. field. nra. Qed.

(** * Isometries *)

Definition denominator (f : isometry) (z : C) : C := Cadd (Cmul (Cconj (b f)) z) (Cconj (a f)).
Definition norm (f : isometry) : R := abs2 (a f) - abs2 (b f).

Lemma proper_norm : forall f, proper f <-> 0 < norm f.
Proof. intros. unfold proper, norm. lra. Qed.

(** |b̄z + ā|² − |az + b|² = (|a|² − |b|²)(1 − |z|²). *)
Lemma abs2_denominator : forall f z,
  abs2 (denominator f z) - abs2 (Cadd (Cmul (a f) z) (b f)) = norm f * (1 - abs2 z).
Proof. intros [[] []] []. unfold denominator, norm. coordinates. simpl. ring. Qed.

Lemma denominator_nonzero : forall f z, proper f -> in_plane z -> denominator f z <> C0.
Proof.
  intros f z H K. apply abs2_nonzero. apply proper_norm in H. unfold in_plane in K.
  pose proof (abs2_denominator f z). pose proof (abs2_nonneg (Cadd (Cmul (a f) z) (b f))). nra.
Qed.

Lemma act_in_plane : forall f z, proper f -> in_plane z -> in_plane (act f z).
Proof.
  intros f z H K. pose proof (denominator_nonzero f z H K) as D. pose proof (abs2_denominator f z).
  apply proper_norm in H. unfold in_plane, act in *. fold (denominator f z). unfold Cdiv.
  rewrite abs2_mul, abs2_inv by auto. apply abs2_pos in D.
  apply Rmult_lt_reg_r with (abs2 (denominator f z)); [lra|].
  rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.

Lemma norm_compose : forall f g, norm (compose f g) = norm f * norm g.
Proof. intros [[] []] [[] []]. unfold norm, compose. coordinates. ring. Qed.

Lemma norm_inverse : forall f, norm (inverse f) = norm f.
Proof. intros [[] []]. unfold norm, inverse. coordinates. ring. Qed.

Lemma proper_compose : forall f g, proper f -> proper g -> proper (compose f g).
Proof.
  intros f g H K. apply proper_norm in H, K. apply proper_norm. rewrite norm_compose. nra.
Qed.

Lemma proper_inverse : forall f, proper f -> proper (inverse f).
Proof. intros f H. apply proper_norm. rewrite norm_inverse. now apply proper_norm. Qed.

Lemma proper_identity : proper identity.
Proof. unfold proper, identity. coordinates. lra. Qed.

Lemma proper_translation : forall c, in_plane c -> proper (translation c).
Proof. intros [u v] H. unfold in_plane, proper, translation in *. coordinates. lra. Qed.

Lemma act_compose : forall f g z, proper f -> proper g -> in_plane z -> act (compose f g) z = act f (act g z).
Proof.
  intros f g z Hf Hg Hz.
  pose proof (denominator_nonzero g z Hg Hz) as D.
  pose proof (denominator_nonzero f (act g z) Hf (act_in_plane g z Hg Hz)) as E.
  pose proof (denominator_nonzero (compose f g) z (proper_compose f g Hf Hg) Hz) as F.
  unfold act, denominator, compose in *. simpl in *.
  rewrite !conj_add, !conj_mul, !conj_conj in *.
  field. repeat split; auto.
  intro G. apply F. rewrite <- G. ring.
Qed.

Lemma act_identity : forall z, act identity z = z.
Proof. intros [u v]. unfold act, identity. apply C_eq; coordinates; field; lra. Qed.

(** Isometries that are equal up to a real factor. *)
Definition same (f g : isometry) : Prop :=
  exists r, r <> 0 /\ a f = Cmul (r, 0) (a g) /\ b f = Cmul (r, 0) (b g).

Lemma same_refl : forall f, same f f.
Proof. intros. exists 1. repeat split; try lra; apply C_eq; coordinates; ring. Qed.

Lemma same_sym : forall f g, same f g -> same g f.
Proof.
  intros f g [r [H [Ha Hb]]]. exists (/ r). split; [now apply Rinv_neq_0_compat|].
  rewrite Ha, Hb. split; apply C_eq; coordinates; field; auto.
Qed.

Lemma same_trans : forall f g h, same f g -> same g h -> same f h.
Proof.
  intros f g h [r [H [Ha Hb]]] [r' [H' [Ha' Hb']]]. exists (r * r'). split; [nra|].
  rewrite Ha, Hb, Ha', Hb'. split; apply C_eq; coordinates; ring.
Qed.

Lemma same_compose : forall f f' g g', same f f' -> same g g' -> same (compose f g) (compose f' g').
Proof.
  intros f f' g g' [r [H [Ha Hb]]] [r' [H' [Ha' Hb']]]. exists (r * r'). split; [nra|].
  unfold compose. simpl. rewrite Ha, Hb, Ha', Hb'. split; apply C_eq; coordinates; ring.
Qed.

Lemma same_inverse : forall f g, same f g -> same (inverse f) (inverse g).
Proof.
  intros f g [r [H [Ha Hb]]]. exists r. split; auto. unfold inverse. simpl. rewrite Ha, Hb.
  split; apply C_eq; coordinates; ring.
Qed.

Lemma same_norm : forall f g, same f g -> exists r, 0 < r /\ norm f = r * norm g.
Proof.
  intros f g [r [H [Ha Hb]]]. exists (r * r). split; [nra|]. unfold norm. rewrite Ha, Hb, !abs2_mul.
  unfold abs2 at 1 3. simpl. ring.
Qed.

Lemma same_proper : forall f g, same f g -> proper f -> proper g.
Proof.
  intros f g H K. apply proper_norm in K. apply proper_norm.
  destruct (same_norm f g H) as [r [P E]]. rewrite E in K. nra.
Qed.

Lemma same_act : forall f g z, same f g -> proper f -> in_plane z -> act f z = act g z.
Proof.
  intros f g z H K I. pose proof (same_proper f g H K) as L.
  pose proof (denominator_nonzero g z L I) as D. pose proof (denominator_nonzero f z K I) as E.
  destruct H as [r [H [Ha Hb]]].
  assert ((r, 0) <> C0) as F by (intro G; apply (f_equal Re) in G; simpl in G; auto).
  unfold act, denominator in *. rewrite Ha, Hb in *. rewrite !conj_mul in *.
  replace (Cconj (r, 0)) with ((r, 0) : C) in * by (apply C_eq; coordinates; ring).
  field. auto.
Qed.

Lemma same_same_map : forall f g, same f g -> proper f -> same_map f g.
Proof. intros f g H K z I. now apply same_act. Qed.

Lemma compose_assoc : forall f g h, compose (compose f g) h = compose f (compose g h).
Proof.
  intros. unfold compose. simpl. rewrite !conj_add, !conj_mul, !conj_conj. f_equal; ring.
Qed.

Lemma compose_identity_l : forall f, compose identity f = f.
Proof. intros [a b]. unfold compose, identity. simpl. f_equal; apply C_eq; coordinates; ring. Qed.

Lemma compose_identity_r : forall f, compose f identity = f.
Proof. intros [a b]. unfold compose, identity. simpl. f_equal; apply C_eq; coordinates; ring. Qed.

Lemma same_compose_inverse : forall f, norm f <> 0 -> same (compose f (inverse f)) identity.
Proof.
  intros f H. exists (norm f). split; auto. unfold compose, inverse, identity, norm in *.
  split; apply C_eq; coordinates; ring.
Qed.

(** f⁻¹g real and not 0, then f and g are the same. *)
Lemma same_of_quotient : forall f g,
  norm f <> 0 -> norm g <> 0 ->
  Im (a (compose (inverse f) g)) = 0 -> b (compose (inverse f) g) = C0 -> same f g.
Proof.
  intros f g Hf Hg H K.
  set (m := Re (a (compose (inverse f) g))).
  assert (compose (inverse f) g = Isometry (m, 0) C0) as E.
  { destruct (compose (inverse f) g) as [u v] eqn:E. simpl in *. subst m v. f_equal. apply C_eq; auto. }
  assert (m <> 0) as M.
  { intro M. pose proof (norm_compose (inverse f) g) as P. rewrite E, norm_inverse, M in P.
    unfold norm at 1, C0 in P. coordinates. nra. }
  apply same_sym. exists (m / norm f). split.
  { unfold Rdiv. apply Rmult_integral_contrapositive. split; auto. now apply Rinv_neq_0_compat. }
  assert (compose (compose f (inverse f)) g = compose f (Isometry (m, 0) C0)) as P.
  { now rewrite compose_assoc, E. }
  assert (forall z, z = Cmul (/ norm f, 0) (Cmul (norm f, 0) z)) as Q.
  { intros. apply C_eq; coordinates; field; auto. }
  assert (a (compose (compose f (inverse f)) g) = Cmul (norm f, 0) (a g) /\
          b (compose (compose f (inverse f)) g) = Cmul (norm f, 0) (b g)) as [Pa Pb].
  { unfold norm, compose, inverse. split; apply C_eq; coordinates; ring. }
  rewrite P in Pa, Pb. unfold compose in Pa, Pb. simpl in Pa, Pb.
  split; [rewrite (Q (a g)), <- Pa|rewrite (Q (b g)), <- Pb]; apply C_eq; coordinates; unfold C0; simpl; field; auto.
Qed.
