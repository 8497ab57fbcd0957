(** The checker's fractions enclose e^y (docs/proof.md, Sections 6 and 7: sinh² of the bounds). *)

From Coq Require Import ZArith Reals List Bool Lia Lra Psatz.
From Epsnet Require Import Integers.
Open Scope R_scope.

Section Series.
Variable y : R.
Hypothesis y_pos : 0 <= y.

Definition term (i : nat) : R := / INR (fact i) * y ^ i.
Definition partial (i : nat) : R := sum_f_R0 term i.

Lemma term_pos : forall i, 0 <= term i.
Proof.
  intros i. unfold term. apply Rmult_le_pos; [|now apply pow_le].
  apply Rlt_le, Rinv_0_lt_compat, INR_fact_lt_0.
Qed.

Lemma term_next : forall i, term (S i) * INR (S i) = term i * y.
Proof.
  intros i. unfold term. rewrite fact_simpl, mult_INR. simpl pow. field.
  split; [apply INR_fact_neq_0|apply not_0_INR; lia].
Qed.

Lemma exp_series : Un_cv partial (exp y).
Proof.
  unfold exp. destruct (exist_exp y) as [l H]. exact H.
Qed.

Lemma partial_below : forall i, partial i <= exp y.
Proof. intros i. apply (sum_incr term i (exp y) exp_series term_pos). Qed.

Lemma partial_above : forall i, 2 * y <= INR (S i) -> exp y <= partial i + term i.
Proof.
  intros i H.
  assert (forall k, partial (i + k) + term (i + k) <= partial i + term i) as A.
  { induction k as [|k IH]; [rewrite Nat.add_0_r; lra|].
    rewrite Nat.add_succ_r. change (partial (S (i + k))) with (partial (i + k) + term (S (i + k))).
    pose proof (term_next (i + k)) as E. pose proof (term_pos (S (i + k))). pose proof (term_pos (i + k)).
    assert (INR (S i) <= INR (S (i + k))) by (apply le_INR; lia).
    assert (2 * term (S (i + k)) <= term (i + k)); [|lra].
    destruct (Req_dec y 0) as [Z|Z].
    - rewrite Z, Rmult_0_r in E. assert (0 < INR (S (i + k))) by (apply lt_0_INR; lia). nra.
    - assert (2 * term (S (i + k)) * y <= term (S (i + k)) * INR (S (i + k))) by nra. nra. }
  apply Rnot_lt_le. intro L.
  destruct (exp_series (exp y - (partial i + term i))) as [m Hm]; [lra|].
  specialize (Hm (i + m)%nat ltac:(lia)). specialize (A m). pose proof (term_pos (i + m)).
  unfold R_dist in Hm. apply Rabs_def2 in Hm. lra.
Qed.
End Series.

(** Quotients of integers, rounded down. *)
Lemma div_below : forall p q, (0 < q)%Z -> IZR (p / q) * IZR q <= IZR p.
Proof. intros p q H. rewrite <- mult_IZR. apply IZR_le. pose proof (Z.mul_div_le p q H). lia. Qed.

Lemma div_above : forall p q, (0 < q)%Z -> IZR p <= IZR (p / q + 1) * IZR q.
Proof.
  intros p q H. rewrite <- mult_IZR. apply IZR_le. pose proof (Z.mul_succ_div_gt p q H). lia.
Qed.

Lemma exp_terms_enclose : forall fuel n m s i t u lower upper l v,
  (0 <= n)%Z -> (0 < m)%Z -> (0 < s)%Z ->
  let y := IZR n / IZR m in
  (0 <= t)%Z -> IZR t <= IZR s * term y i -> IZR s * term y i <= IZR u ->
  (s <= lower)%Z -> IZR lower <= IZR s * partial y i -> IZR s * partial y i <= IZR upper ->
  K.exp_terms fuel n m (Z.of_nat i + 1) t u lower upper = Some (l, v) ->
  (s <= l)%Z /\ IZR l <= IZR s * exp y /\ IZR s * exp y <= IZR v.
Proof.
  induction fuel as [|fuel IH]; intros n m s i t u lower upper l v Hn Hm Hs y Ht Lt Lu Hl Ll Lv E; [discriminate|].
  cbn [K.exp_terms] in E.
  set (j := (Z.of_nat i + 1)%Z) in *.
  assert (0 <= y) as Hy.
  { unfold y, Rdiv. apply Rmult_le_pos; [now apply IZR_le|]. apply Rlt_le, Rinv_0_lt_compat. now apply IZR_pos. }
  assert (IZR j = INR (S i)) as Ej by (unfold j; rewrite INR_IZR_INZ; f_equal; lia).
  assert (0 < m * j)%Z as Hmj by (unfold j; nia).
  pose proof (term_next y i) as T. pose proof (term_pos y Hy i) as Ti. pose proof (term_pos y Hy (S i)) as Tj.
  apply IZR_pos in Hm as Rm. apply IZR_pos in Hs as Rs. apply IZR_pos in Hmj as Rmj.
  assert (0 <= IZR n) as Rn by now apply (IZR_le 0).
  assert (IZR n = y * IZR m) as En by (unfold y; field; lra).
  assert (0 < INR (S i)) as Rj by (apply lt_0_INR; lia).
  assert (0 <= t * n / (m * j))%Z as Ht' by (apply Z.div_pos; nia).
  assert (IZR (t * n / (m * j)) <= IZR s * term y (S i)) as Lt'.
  { apply Rmult_le_reg_r with (IZR (m * j)); auto. eapply Rle_trans; [now apply div_below|].
    rewrite !mult_IZR, Ej, En.
    replace (IZR s * term y (S i) * (IZR m * INR (S i))) with (IZR s * IZR m * (term y (S i) * INR (S i))) by ring.
    rewrite T. assert (0 <= y * IZR m) by nra. nra. }
  assert (IZR s * term y (S i) <= IZR (u * n / (m * j) + 1)) as Lu'.
  { apply Rmult_le_reg_r with (IZR (m * j)); auto. eapply Rle_trans; [|now apply div_above].
    rewrite !mult_IZR, Ej, En.
    replace (IZR s * term y (S i) * (IZR m * INR (S i))) with (IZR s * IZR m * (term y (S i) * INR (S i))) by ring.
    rewrite T. assert (0 <= y * IZR m) by nra. nra. }
  set (t' := (t * n / (m * j))%Z) in *. set (u' := (u * n / (m * j) + 1)%Z) in *.
  assert (partial y (S i) = partial y i + term y (S i)) as P by reflexivity.
  destruct ((t' =? 0)%Z && (2 * n <=? m * (j + 1))%Z) eqn:C.
  - injection E as <- <-. apply andb_prop in C. destruct C as [_ C]. apply Z.leb_le in C.
    assert (2 * y <= INR (S (S i))) as B.
    { apply IZR_le in C. rewrite !mult_IZR, plus_IZR, Ej, En in C. rewrite (S_INR (S i)).
      apply Rmult_le_reg_r with (IZR m); auto. lra. }
    pose proof (partial_below y Hy (S i)). pose proof (partial_above y Hy (S i) B).
    split; [lia|]. rewrite !plus_IZR. split; nra.
  - replace (j + 1)%Z with (Z.of_nat (S i) + 1)%Z in E by (unfold j; lia).
    apply (IH n m s (S i) t' u' (lower + t')%Z (upper + u')%Z l v); auto; fold y; try lia; rewrite plus_IZR, P; lra.
Qed.

Lemma exp_bounds_enclose : forall n m l u s, (0 < n)%Z -> (0 < m)%Z -> K.exp_bounds n m = Some (l, u, s) ->
  let e := exp (2 * (IZR n / IZR m)) in
  (0 < s)%Z /\ (s <= l)%Z /\ IZR l <= IZR s * e /\ IZR s * e <= IZR u.
Proof.
  intros n m l u s Hn Hm E e. unfold K.exp_bounds in E.
  destruct (_ || _); [discriminate|].
  set (k := (256 + 2 * Z.max (K.bits m - K.bits n) 0)%Z) in *.
  assert (0 < Z.shiftl 1 k)%Z as P.
  { rewrite Z.shiftl_1_l. apply Z.pow_pos_nonneg; lia. }
  destruct (K.exp_terms _ _ _ _ _ _ _ _) as [[l' u']|] eqn:T; [|discriminate].
  injection E as <- <- <-. split; auto.
  assert (e = exp (IZR (2 * n) / IZR m)) as ->.
  { unfold e. f_equal. rewrite mult_IZR. field. apply not_0_IZR. lia. }
  apply IZR_pos in P as RP.
  eapply (exp_terms_enclose _ (2 * n) m _ 0); eauto; try lia; unfold partial, term; simpl; try lra; lia.
Qed.

Lemma exp_opp : forall x, exp x * exp (- x) = 1.
Proof. intros. rewrite <- exp_plus, Rplus_opp_r. apply exp_0. Qed.

(** (E − 1)²/4E = sinh²(x) for E = e^(2x). *)
Lemma sinh_exp : forall x, sinh x * sinh x * (4 * exp (2 * x)) = (exp (2 * x) - 1) * (exp (2 * x) - 1).
Proof.
  intros x. unfold sinh. replace (2 * x) with (x + x) by ring. rewrite exp_plus.
  pose proof (exp_opp x) as E.
  set (p := exp x) in *. set (q := exp (- x)) in *.
  replace ((p - q) / 2 * ((p - q) / 2) * (4 * (p * p))) with ((p * p - p * q) * (p * p - p * q)) by field.
  rewrite E. ring.
Qed.

(** The bounds of sinh²x that follow from those of e^(2x). *)
Lemma sinh_above : forall x l s, 0 < s -> s <= l -> l <= s * exp (2 * x) ->
  (l - s) * (l - s) <= sinh x * sinh x * (4 * l * s).
Proof.
  intros x l s Hs Hl H. pose proof (sinh_exp x) as E. pose proof (exp_pos (2 * x)) as P.
  set (e := exp (2 * x)) in *. set (q := sinh x * sinh x) in *.
  assert (1 <= e) by nra.
  apply Rmult_le_reg_r with e; auto.
  replace (q * (4 * l * s) * e) with (l * s * (q * (4 * e))) by ring. rewrite E.
  (* (l − s)² e ≤ l s (e − 1)², that is (s e − l)(l e − s) ≥ 0. *)
  assert (0 <= (s * e - l) * (l * e - s)) by (apply Rmult_le_pos; nra). nra.
Qed.

Lemma sinh_below : forall x u s, 0 < s -> s <= s * exp (2 * x) -> s * exp (2 * x) <= u ->
  sinh x * sinh x * (4 * u * s) <= (u - s) * (u - s).
Proof.
  intros x u s Hs He H. pose proof (sinh_exp x) as E. pose proof (exp_pos (2 * x)) as P.
  set (e := exp (2 * x)) in *. set (q := sinh x * sinh x) in *.
  assert (1 <= e) by nra.
  apply Rmult_le_reg_r with e; auto.
  replace (q * (4 * u * s) * e) with (u * s * (q * (4 * e))) by ring. rewrite E.
  assert (0 <= (u - s * e) * (u * e - s)) by (apply Rmult_le_pos; nra). nra.
Qed.
