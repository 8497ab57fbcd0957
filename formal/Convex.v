(** Rule surface, (a): turns to the left and the fan from corner 0 make a strictly convex polygon (docs/proof.md,
    Section 2). *)

From Coq Require Import ZArith Reals List Bool Lia Lra Psatz.
From Epsnet Require Import Document Statement Integers.
Import ListNotations.
Open Scope R_scope.

(** Two of three points on the same side of a line: the relation of Grassmann and Plücker. *)
Lemma pluecker : forall j a b c d,
  det j a b * det j c d - det j a c * det j b d + det j a d * det j b c = 0.
Proof.
  intros j a b c d. unfold det. cbv zeta.
  generalize (Re j) (Im j) (1 + abs2 j) (Re a) (Im a) (1 + abs2 a) (Re b) (Im b) (1 + abs2 b)
    (Re c) (Im c) (1 + abs2 c) (Re d) (Im d) (1 + abs2 d).
  intros. ring.
Qed.

Lemma det_turn : forall u v w, det u v w = det v w u.
Proof. intros. unfold det. ring. Qed.

Lemma det_swap : forall u v w, det u v w = - det v u w.
Proof. intros. unfold det. ring. Qed.

Section Polygon.
Variable n : nat.
Variable z : nat -> C.
Let o i j k := det (z i) (z j) (z k).
Hypothesis first_side : forall k, (2 <= k < n)%nat -> 0 < o 0 1 k.
Hypothesis fan : forall k, (1 <= k)%nat -> (k + 1 < n)%nat -> 0 < o 0 k (k + 1).
Hypothesis left_turn : forall k, (k + 2 < n)%nat -> 0 < o k (k + 1) (k + 2).

Lemma positive_quotient : forall p q r, 0 < p -> 0 < r -> p * q = r -> 0 < q.
Proof. intros p q r Hp Hr E. apply Rmult_lt_reg_l with p; lra. Qed.

Lemma from_first : forall j i, (1 <= i < j)%nat -> (j < n)%nat -> 0 < o 0 i j.
Proof.
  induction j as [|j IH]; intros i Hi Hj; [lia|].
  destruct (Nat.eq_dec i j) as [->|D].
  { replace (S j) with (j + 1)%nat by lia. apply fan; lia. }
  destruct (Nat.eq_dec i 1) as [->|D1]; [apply first_side; lia|].
  assert (0 < o 0 1 i) by (apply first_side; lia).
  assert (0 < o 0 1 j) by (apply first_side; lia).
  assert (0 < o 0 1 (S j)) by (apply first_side; lia).
  assert (0 < o 0 i j) by (apply IH; lia).
  assert (0 < o 0 j (S j)) by (replace (S j) with (j + 1)%nat by lia; apply fan; lia).
  pose proof (pluecker (z 0%nat) (z 1%nat) (z i) (z j) (z (S j))) as P.
  apply positive_quotient with (o 0 1 j) (o 0 1 i * o 0 j (S j) + o 0 1 (S j) * o 0 i j); auto; [nra|].
  unfold o. lra.
Qed.

Lemma all_left : forall s i j l, (l - i <= s)%nat -> (1 <= i < j)%nat -> (j < l < n)%nat -> 0 < o i j l.
Proof.
  induction s as [|s IH]; intros i j l Hs Hi Hl; [lia|].
  destruct (Nat.eq_dec l (i + 2)) as [->|D].
  { replace j with (i + 1)%nat by lia. apply left_turn. lia. }
  destruct (Nat.eq_dec j (l - 1)) as [E|E].
  - assert (0 < o i (i + 1) j) by (apply IH; lia).
    assert (0 < o (i + 1) j l) by (apply IH; lia).
    assert (0 < o 0 i j) by (apply from_first; lia).
    assert (0 < o 0 j l) by (apply from_first; lia).
    assert (0 < o 0 (i + 1) j) by (apply from_first; lia).
    pose proof (pluecker (z j) (z 0%nat) (z i) (z (i + 1)%nat) (z l)) as P.
    apply positive_quotient with (o 0 (i + 1) j) (o 0 j l * o i (i + 1) j + o 0 i j * o (i + 1) j l); auto; [nra|].
    unfold o in *.
    rewrite (det_turn (z j) (z 0%nat) (z i)), (det_turn (z j) (z (i + 1)%nat) (z l)),
      (det_swap (z (i + 1)%nat) (z l) (z j)), (det_turn (z l) (z (i + 1)%nat) (z j)),
      (det_turn (z j) (z 0%nat) (z (i + 1)%nat)), (det_turn (z j) (z i) (z l)),
      (det_swap (z i) (z l) (z j)), (det_turn (z l) (z i) (z j)),
      (det_swap (z j) (z 0%nat) (z l)), (det_turn (z j) (z i) (z (i + 1)%nat)) in P. lra.
  - assert (0 < o i j (l - 1)) by (apply IH; lia).
    assert (0 < o j (l - 1) l) by (apply IH; lia).
    assert (0 < o 0 i j) by (apply from_first; lia).
    assert (0 < o 0 j l) by (apply from_first; lia).
    assert (0 < o 0 j (l - 1)) by (apply from_first; lia).
    pose proof (pluecker (z j) (z 0%nat) (z i) (z (l - 1)%nat) (z l)) as P.
    apply positive_quotient with (o 0 j (l - 1)) (o 0 i j * o j (l - 1) l + o 0 j l * o i j (l - 1)); auto; [nra|].
    unfold o in *.
    rewrite (det_turn (z j) (z 0%nat) (z i)),
      (det_swap (z j) (z 0%nat) (z (l - 1)%nat)), (det_swap (z j) (z i) (z l)),
      (det_swap (z j) (z 0%nat) (z l)), (det_swap (z j) (z i) (z (l - 1)%nat)) in P. lra.
Qed.

Lemma all_counterclockwise : forall i j k, (i < j)%nat -> (j < k)%nat -> (k < n)%nat -> 0 < o i j k.
Proof.
  intros i j k Hi Hj Hk. destruct i; [apply from_first; lia|]. apply all_left with (k - S i)%nat; lia.
Qed.
End Polygon.

Lemma left_turns_nth : forall l i, K.left_turns l = true -> (i + 2 < length l)%nat ->
  (0 < K.orientation (nth i l origin) (nth (i + 1) l origin) (nth (i + 2) l origin))%Z.
Proof.
  induction l as [|u l IH]; intros i H Hi; [simpl in Hi; lia|].
  destruct l as [|v [|w l]]; [simpl in Hi; lia|simpl in Hi; lia|].
  cbn [K.left_turns] in H. apply andb_prop in H. destruct H as [H1 H2]. apply Z.ltb_lt in H1.
  destruct i; [exact H1|]. apply (IH i H2). simpl in *. lia.
Qed.

Lemma in_order_nth : forall z l i, K.in_order z l = true -> (i + 1 < length l)%nat ->
  (0 < K.orientation z (nth i l origin) (nth (i + 1) l origin))%Z.
Proof.
  induction l as [|u l IH]; intros i H Hi; [simpl in Hi; lia|].
  destruct l as [|v l]; [simpl in Hi; lia|].
  cbn [K.in_order] in H. apply andb_prop in H. destruct H as [H1 H2]. apply Z.ltb_lt in H1.
  destruct i; [exact H1|]. apply (IH i H2). simpl in *. lia.
Qed.

Lemma convex_strictly : forall tile, (3 <= length tile)%nat -> K.convex tile = true -> strictly_convex tile.
Proof.
  intros tile Hn H. unfold K.convex in H. apply andb_prop in H. destruct H as [D H].
  rewrite forallb_forall in D.
  assert (forall i, (0 < den (nth i tile origin))%Z) as M.
  { intros i. destruct (nth_in_or_default i tile origin) as [I|E]; [|rewrite E; simpl; lia].
    now apply in_disk_plane, D. }
  split; auto. split; [intros z Hz; now apply in_disk_plane, D|].
  destruct tile as [|z0 [|z1 rest]]; [discriminate|discriminate|].
  apply andb_prop in H. destruct H as [H H3]. apply andb_prop in H. destruct H as [H1 H2].
  rewrite forallb_forall in H2.
  apply (all_counterclockwise _ (fun i => to_C (nth i (z0 :: z1 :: rest) origin))).
  - intros k Hk. apply orientation_counterclockwise; try apply M.
    destruct k as [|[|k]]; try lia. simpl. apply Z.ltb_lt, H2, nth_In. simpl length in Hk. lia.
  - intros k Hk Hk'. apply orientation_counterclockwise; try apply M.
    destruct k as [|k]; [lia|]. replace (S k + 1)%nat with (S (k + 1)) by lia.
    change (nth (S k) (z0 :: z1 :: rest) origin) with (nth k (z1 :: rest) origin).
    change (nth (S (k + 1)) (z0 :: z1 :: rest) origin) with (nth (k + 1) (z1 :: rest) origin).
    apply (in_order_nth z0 (z1 :: rest) k H3). simpl length in *. lia.
  - intros k Hk. apply orientation_counterclockwise; try apply M.
    set (l := z0 :: z1 :: rest) in *.
    pose proof (left_turns_nth (l ++ [z0; z1]) k H1) as L.
    rewrite !app_nth1 in L by lia. apply L. rewrite app_length. apply Nat.lt_le_trans with (length l); [lia|].
    apply Nat.le_add_r.
Qed.
