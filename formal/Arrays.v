(** Arrays and sets of indices for the program, and what they are in terms of lists. *)

From Coq Require Import ZArith NArith List FMapPositive Lia.
From Epsnet Require Import Document.
Import ListNotations.
Open Scope N_scope.

Definition array := PositiveMap.t.

Fixpoint fill {A} (l : list A) (i : N) (a : array A) : array A :=
  match l with
  | [] => a
  | x :: l' => fill l' (i + 1) (PositiveMap.add (N.succ_pos i) x a)
  end.

Definition of_list {A} (l : list A) : array A := fill l 0 (PositiveMap.empty A).

Definition get {A} (a : array A) (nothing : A) (i : N) : A :=
  match PositiveMap.find (N.succ_pos i) a with Some x => x | None => nothing end.

Fixpoint count {A} (l : list A) (i : N) : list N :=
  match l with
  | [] => []
  | _ :: l' => i :: count l' (i + 1)
  end.

(** 0, 1, 2, ..., as many as there are elements. *)
Definition indices {A} (l : list A) : list N := count l 0.

Fixpoint length_from {A} (l : list A) (n : N) : N :=
  match l with
  | [] => n
  | _ :: l' => length_from l' (n + 1)
  end.

(** [size], without unary numbers. *)
Definition fast_size {A} (l : list A) : N := length_from l 0.

Definition set := PositiveMap.t unit.
Definition nobody : set := PositiveMap.empty unit.
Definition mem (i : N) (s : set) : bool := PositiveMap.mem (N.succ_pos i) s.
Definition insert (i : N) (s : set) : set := PositiveMap.add (N.succ_pos i) tt s.
Definition insert_all (l : list N) (s : set) : set := fold_left (fun s i => insert i s) l s.

Lemma succ_pos_injective : forall i j, N.succ_pos i = N.succ_pos j -> i = j.
Proof.
  intros i j H. apply N.succ_inj. rewrite <- !N.succ_pos_spec. now rewrite H.
Qed.

Lemma find_fill : forall A (l : list A) i a j,
  PositiveMap.find (N.succ_pos j) (fill l i a) =
  if (j <? i) then PositiveMap.find (N.succ_pos j) a
  else match nth_error l (N.to_nat (j - i)) with
       | Some x => Some x
       | None => PositiveMap.find (N.succ_pos j) a
       end.
Proof.
  induction l as [|x l IH]; intros i a j; simpl.
  - destruct (j <? i); auto. now destruct (N.to_nat (j - i)).
  - rewrite IH. destruct (N.ltb_spec j i) as [H|H].
    + destruct (N.ltb_spec j (i + 1)) as [H'|H']; [|lia].
      apply PositiveMap.gso. intro E. apply succ_pos_injective in E. lia.
    + destruct (N.eq_dec j i) as [->|D].
      * destruct (N.ltb_spec i (i + 1)) as [H'|H']; [|lia].
        rewrite PositiveMap.gss. now replace (N.to_nat (i - i)) with 0%nat by lia.
      * destruct (N.ltb_spec j (i + 1)) as [H'|H']; [lia|].
        replace (N.to_nat (j - i)) with (S (N.to_nat (j - (i + 1)))) by lia. simpl.
        destruct (nth_error l _); auto.
        apply PositiveMap.gso. intro E. apply succ_pos_injective in E. lia.
Qed.

Lemma get_of_list : forall A (l : list A) nothing i, get (of_list l) nothing i = at_index l nothing i.
Proof.
  intros. unfold get, of_list, at_index. rewrite find_fill.
  destruct (N.ltb_spec i 0); [lia|]. rewrite N.sub_0_r.
  destruct (nth_error l (N.to_nat i)) eqn:E.
  - symmetry. now apply nth_error_nth.
  - rewrite PositiveMap.gempty. symmetry. apply nth_overflow. now apply nth_error_None.
Qed.

Lemma in_count : forall A (l : list A) j i, In i (count l j) <-> j <= i < j + size l.
Proof.
  unfold size. induction l as [|x l IH]; intros j i; simpl; [lia|]. rewrite IH. lia.
Qed.

Lemma in_indices : forall A (l : list A) i, In i (indices l) <-> i < size l.
Proof.
  intros. unfold indices. rewrite in_count. lia.
Qed.

Lemma length_count : forall A (l : list A) j, length (count l j) = length l.
Proof.
  induction l; intros; simpl; auto.
Qed.

Lemma NoDup_count : forall A (l : list A) j, NoDup (count l j).
Proof.
  induction l as [|x l IH]; intros j; simpl; constructor; auto. rewrite in_count. lia.
Qed.

Lemma fast_size_size : forall A (l : list A), fast_size l = size l.
Proof.
  assert (forall A (l : list A) n, length_from l n = n + size l) as H.
  { unfold size. induction l as [|x l IH]; intros n; simpl; [lia|]. rewrite IH. lia. }
  intros. unfold fast_size. rewrite H. lia.
Qed.

Lemma mem_insert : forall i j s, mem i (insert j s) = true -> i = j \/ mem i s = true.
Proof.
  unfold mem, insert. intros i j s H. destruct (N.eq_dec i j) as [|D]; [now left|right].
  rewrite PositiveMap.mem_find in *. rewrite PositiveMap.gso in H; auto.
  intro E. apply succ_pos_injective in E. congruence.
Qed.

Lemma mem_nobody : forall i, mem i nobody = false.
Proof.
  intros. unfold mem, nobody. rewrite PositiveMap.mem_find. now rewrite PositiveMap.gempty.
Qed.

Lemma mem_insert_all : forall l i s, mem i (insert_all l s) = true -> In i l \/ mem i s = true.
Proof.
  induction l as [|x l IH]; intros i s H; simpl in *; auto.
  destruct (IH _ _ H) as [|H']; auto. destruct (mem_insert _ _ _ H'); auto.
Qed.
