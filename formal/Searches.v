(** What the checker's searches have found when they say so. *)

From Coq Require Import ZArith NArith List Bool Lia Permutation Relations.
From Epsnet Require Import Document Arrays.
From Epsnet Require Checker Statement.
Import ListNotations.
Module K := Checker.

Section Connected.
Variable steps : N -> list N.
Let reached := Statement.reaches steps 0%N.

Lemma visit_reaches : forall l o s,
  (forall j, In j l -> reached j) -> (forall j, In j o -> reached j) -> (forall j, mem j s = true -> reached j) ->
  let visit state j := let (o, s) := state : list N * set in if mem j s then state else (j :: o, insert j s) in
  let (o', s') := fold_left visit l (o, s) in
  (forall j, In j o' -> reached j) /\ (forall j, mem j s' = true -> reached j).
Proof.
  intros l. induction l as [|i l IH]; intros o s Hl Ho Hs visit; simpl; [auto|].
  destruct (mem i s) eqn:E.
  - apply IH; auto. intros; apply Hl; simpl; auto.
  - apply IH.
    + intros; apply Hl; simpl; auto.
    + intros j [<-|]; auto. apply Hl; simpl; auto.
    + intros j H. destruct (mem_insert _ _ _ H) as [->|]; auto. apply Hl; simpl; auto.
Qed.

Lemma explore_reaches : forall fuel o s,
  (forall j, In j o -> reached j) -> (forall j, mem j s = true -> reached j) ->
  forall j, mem j (K.explore fuel steps o s) = true -> reached j.
Proof.
  induction fuel as [|x fuel IH]; intros [|i o] s Ho Hs j H; cbn [K.explore] in H; auto.
  pose proof (visit_reaches (steps i) o s) as V. cbv zeta in V.
  destruct (fold_left _ (steps i) (o, s)) as [o' s'].
  destruct V as [V1 V2]; auto.
  - intros k Hk. eapply rt_trans; [apply Ho; simpl; eauto|]. now apply rt_step.
  - intros k Hk. apply Ho. now right.
  - eapply IH; eauto.
Qed.

Lemma connected_reaches : forall all, K.connected all steps = true -> forall i, In i all -> reached i.
Proof.
  intros all H i Hi. unfold K.connected in H. rewrite forallb_forall in H.
  eapply explore_reaches; [| |now apply H].
  - intros j [<-|[]]. apply rt_refl.
  - intros j Hj. destruct (mem_insert _ _ _ Hj) as [->|E]; [apply rt_refl|]. now rewrite mem_nobody in E.
Qed.
End Connected.

Lemma exactly_once_permutation : forall l all,
  NoDup all -> K.exactly_once l all = true -> Permutation l all.
Proof.
  intros l all D H. unfold K.exactly_once in H. apply andb_prop in H. destruct H as [H1 H2].
  apply N.eqb_eq in H1. rewrite !fast_size_size in H1. unfold size in H1. rewrite forallb_forall in H2.
  apply Permutation_sym. apply NoDup_Permutation_bis; auto; [lia|].
  intros i Hi. apply H2 in Hi. destruct (mem_insert_all _ _ _ Hi) as [|E]; auto. now rewrite mem_nobody in E.
Qed.

Lemma count_seq : forall A (l : list A) j, count l (N.of_nat j) = map N.of_nat (seq j (length l)).
Proof.
  induction l as [|x l IH]; intros j; simpl; auto. f_equal. rewrite <- IH. f_equal. lia.
Qed.

Lemma indices_seq : forall A (l : list A), indices l = map N.of_nat (seq 0 (N.to_nat (size l))).
Proof.
  intros. unfold indices, size. rewrite Nnat.Nat2N.id. apply (count_seq A l 0).
Qed.

Lemma NoDup_indices : forall A (l : list A), NoDup (indices l).
Proof. intros. apply NoDup_count. Qed.

Section Rounds.
Variable follow : N -> N.

Lemma goes_on_next : forall first c s, K.goes_on follow first s c = true ->
  forall i, (i < length (s :: c))%nat -> follow (nth i (s :: c) 0%N) = nth (i + 1) ((s :: c) ++ [first]) 0%N.
Proof.
  induction c as [|s' c IH]; intros s H i Hi.
  - simpl in *. apply N.eqb_eq in H. destruct i; [auto|lia].
  - cbn [K.goes_on] in H. apply andb_prop in H. destruct H as [H1 H2]. apply N.eqb_eq in H1.
    destruct i; [auto|]. simpl. apply (IH s' H2 i). simpl in *. lia.
Qed.

Lemma goes_round_next : forall c, K.goes_round follow c = true ->
  c <> [] /\ forall i, (i < length c)%nat -> follow (nth i c 0%N) = nth ((i + 1) mod length c) c 0%N.
Proof.
  intros [|s c] H; [discriminate|]. split; [discriminate|]. intros i Hi. unfold K.goes_round in H.
  rewrite (goes_on_next s c s H i Hi).
  destruct (Nat.eq_dec (i + 1) (length (s :: c))) as [E|E].
  - rewrite E, Nat.mod_same by (simpl; lia). rewrite app_nth2 by lia. now rewrite Nat.sub_diag.
  - rewrite Nat.mod_small by lia. now rewrite app_nth1 by lia.
Qed.

Lemma walk_invariant : forall (P : N -> Prop), (forall x, P x -> P (follow x)) ->
  forall fuel x s, P x -> (forall y, mem y s = true -> P y) -> forall y, mem y (K.walk fuel follow x s) = true -> P y.
Proof.
  intros P Hf. induction fuel as [|z fuel IH]; intros x s Hx Hs y H; cbn [K.walk] in H; auto.
  destruct (mem x s); auto.
  eapply IH; [|  |exact H]; auto.
  intros w Hw. destruct (mem_insert _ _ _ Hw) as [->|]; auto.
Qed.

Lemma walks_reach : forall fuel (first : N -> N) all l s,
  (forall v, In v l -> In v all) ->
  (forall y, mem y s = true -> exists v k, In v all /\ y = Nat.iter k follow (first v)) ->
  forall y, mem y (fold_left (fun s v => K.walk fuel follow (first v) s) l s) = true ->
  exists v k, In v all /\ y = Nat.iter k follow (first v).
Proof.
  intros fuel first all. induction l as [|v l IH]; intros s Hl Hs y H; simpl in H; auto.
  apply IH in H; auto; [intros; apply Hl; simpl; auto|].
  apply walk_invariant.
  - intros x [v' [k [Hv ->]]]. exists v', (S k). now split.
  - exists v, 0%nat. split; [apply Hl; simpl; auto|reflexivity].
  - exact Hs.
Qed.
End Rounds.
