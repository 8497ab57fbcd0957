(** Labels and the rules gluing, orientation, delaunay, covering, packing. *)

From Coq Require Import ZArith NArith Reals List Bool Lia Lra Psatz.
From Epsnet Require Import Document Arrays Statement Plane Integers Bounds Circle Surface.
Import ListNotations.
Module K := Checker.
Ltac Zify.zify_post_hook ::= Z.to_euclidean_division_equations.

(** * Delaunay: the determinant is the sign of the cross-ratio *)

Lemma point_coordinates : forall z, (0 < den z)%Z ->
  IZR (re z) = (IZR (den z) * Re (to_C z))%R /\ IZR (im z) = (IZR (den z) * Im (to_C z))%R.
Proof. intros z H. apply IZR_pos in H. unfold to_C. coordinates. split; field; lra. Qed.

Lemma delaunay_cross_ratio : forall u v w far,
  (0 < den u)%Z -> (0 < den v)%Z -> (0 < den w)%Z -> (0 < den far)%Z ->
  (K.delaunay_sign u v w far <= 0)%Z -> (cross_ratio_sign (to_C u) (to_C far) (to_C v) (to_C w) <= 0)%R.
Proof.
  intros u v w f Hu Hv Hw Hf H.
  destruct (point_coordinates u Hu) as [U1 U2]. destruct (point_coordinates v Hv) as [V1 V2].
  destruct (point_coordinates w Hw) as [W1 W2]. destruct (point_coordinates f Hf) as [F1 F2].
  apply IZR_pos in Hu, Hv, Hw, Hf. apply IZR_le in H.
  set (m := (IZR (den u) * IZR (den u) * (IZR (den v) * IZR (den v)) * (IZR (den w) * IZR (den w)) *
    (IZR (den f) * IZR (den f) * (IZR (den f) * IZR (den f)) * (IZR (den f) * IZR (den f))))%R).
  assert (0 < m)%R as Hm by (unfold m; repeat apply Rmult_lt_0_compat; auto).
  assert (IZR (K.delaunay_sign u v w f) = m * cross_ratio_sign (to_C u) (to_C f) (to_C v) (to_C w))%R as E.
  { unfold K.delaunay_sign, K.norm, K.sub, K.scale, K.num, cross_ratio_sign. cbn [K.x K.y]. reals.
    rewrite U1, U2, V1, V2, W1, W2, F1, F2. unfold m, Cmul, Csub, Cconj. cbn [Re Im fst snd].
    generalize (IZR (den u)) (IZR (den v)) (IZR (den w)) (IZR (den f)) (Re (to_C u)) (Im (to_C u)) (Re (to_C v))
      (Im (to_C v)) (Re (to_C w)) (Im (to_C w)) (Re (to_C f)) (Im (to_C f)).
    intros. unfold Re, Im. cbn [fst snd]. ring. }
  rewrite E in H. apply Rmult_le_reg_l with m; lra.
Qed.

Section Rules.
Variable d : document.
Variable p : N -> N.
Let n := net_of d p.
Let all_sides := indices (sides d).
Let all_triangles := indices (triangles d).
Let all_darts := flat_map (fun t => [3 * t; 3 * t + 1; 3 * t + 2])%N all_triangles.
Variable pairs : list (N * N).
Hypothesis whole : K.structure d n all_sides pairs = true.
Variable crossing_of_side : N -> K.iso.
Variable cycles : list (list N).
Hypothesis rule : K.surface d n all_sides crossing_of_side cycles = true.
Let crossing s := real (crossing_of_side s).
Variable value : N -> K.iso.
Hypothesis value_is : forall k, (k <= size (labels d))%N ->
  value k = if (k =? 0)%N then K.identity else K.label_value n crossing_of_side (label_at n (k - 1)).

Let parts := structure_parts d p pairs whole.

Lemma chart_good : forall c, (0 < den (centre (chart_at n c)))%Z /\ in_plane (to_C (centre (chart_at n c))).
Proof.
  intros c. unfold n, net_of. cbn [chart_at]. destruct (at_index_or _ (charts d) no_chart c) as [H| ->].
  - destruct parts as [_ [_ [_ [_ [_ [S _]]]]]]. destruct (S _ H) as [_ S']. now apply in_disk_plane.
  - simpl. split; [lia|]. unfold in_plane, to_C, origin. coordinates. lra.
Qed.

Lemma vertex_good : forall v, (0 < den (place (vertex_at n v)))%Z /\ in_plane (to_C (place (vertex_at n v))).
Proof.
  intros v. unfold n, net_of. cbn [vertex_at]. destruct (at_index_or _ (vertices d) no_vertex v) as [H| ->].
  - destruct parts as [_ [_ [_ [_ [_ [_ [_ [S _]]]]]]]]. destruct (S _ H) as [_ S']. now apply in_disk_plane.
  - simpl. split; [lia|]. unfold in_plane, to_C, origin. coordinates. lra.
Qed.

Lemma leads_leads : forall w tile last, K.leads n (size (sides d)) tile w last = true -> leads d n tile w last.
Proof.
  induction w as [|s w IH]; intros tile last H; simpl in *; booleans; auto.
Qed.

Lemma label_in : forall k, (k < size (labels d))%N ->
  let l := label_at n k in
  (from l < size (charts d))%N /\ (target l < size (charts d))%N /\
  leads d n (tile_of_chart (chart_at n (from l))) (word l) (tile_of_chart (chart_at n (target l))).
Proof.
  intros k H. assert (In (label_at n k) (labels d)) as I by now apply in_at_index.
  destruct parts as [_ [_ [_ [_ [_ [_ [S _]]]]]]]. apply S in I. unfold K.label_fits in I. booleans.
  split; auto. split; auto. now apply leads_leads.
Qed.

Lemma start_of_first : forall x, start n (3 * (x / 3)) = v0 (triangle_at n (x / 3)).
Proof.
  intros x. unfold start. replace ((3 * (x / 3)) / 3)%N with (x / 3)%N by lia. unfold of_corner.
  now replace ((3 * (x / 3)) mod 3)%N with 0%N by lia.
Qed.

Lemma label_number_fits : forall x, (x < dart_count d)%N ->
  if (label_number n x =? 0)%N then chart_of_start n x = chart_of_start n (3 * (x / 3))
  else (label_number n x <= size (labels d))%N /\
       from (label_at n (label_number n x - 1)) = chart_of_start n x /\
       target (label_at n (label_number n x - 1)) = chart_of_start n (3 * (x / 3)).
Proof.
  intros x Hx. unfold dart_count in *. assert (x / 3 < size (triangles d))%N as Ht by lia.
  apply (triangle_in d p) in Ht. destruct parts as [_ [_ [_ [_ [_ [_ [_ [_ T]]]]]]]]. apply T in Ht.
  unfold K.triangle_fits in Ht. apply andb_prop in Ht. destruct Ht as [Ht C2]. apply andb_prop in Ht.
  destruct Ht as [_ C1]. unfold chart_of_start. rewrite start_of_first. unfold label_number, start.
  unfold K.corner_fits in C1, C2. fold n in C1, C2. set (t := triangle_at n (x / 3)) in *.
  assert (x mod 3 = 0 \/ x mod 3 = 1 \/ x mod 3 = 2)%N as [E|[E|E]] by lia; unfold of_corner; rewrite E.
  - reflexivity.
  - destruct (l1 t =? 0)%N; booleans; auto. repeat split; auto. lia.
  - destruct (l2 t =? 0)%N; booleans; auto. repeat split; auto. lia.
Qed.

Theorem labels_are_fit : labels_fit d n.
Proof.
  destruct parts as [_ [_ [_ [_ [_ [S1 [S2 [S3 _]]]]]]]]. split.
  { intros c Hc. apply S1 in Hc. destruct Hc as [A B]. split; auto. now apply in_disk_plane. }
  split.
  { intros v Hv. apply S3 in Hv. destruct Hv as [A B]. split; auto. now apply in_disk_plane. }
  split; [|exact label_number_fits].
  intros l Hl. apply S2 in Hl. unfold K.label_fits in Hl. booleans. split; auto. split; auto. now apply leads_leads.
Qed.

(** * Values of labels *)

Lemma crossing_proper : forall s, (s < side_count d)%N -> proper (crossing s).
Proof.
  intros s Hs. destruct (crossings d p pairs whole crossing_of_side cycles rule s Hs) as [_ [H _]]. exact H.
Qed.

Lemma word_proper : forall w tile last, leads d n tile w last -> proper (word_value crossing w).
Proof.
  induction w as [|s w IH]; intros tile last H; simpl in *; [apply proper_identity|].
  destruct H as [H1 [_ H2]]. apply proper_compose; [eapply IH; eauto|now apply crossing_proper].
Qed.

Lemma frame_proper : forall c, proper (frame n c).
Proof. intros. apply proper_translation. now destruct (chart_good c). Qed.

Lemma frame_same : forall c, same (real (K.frame n c)) (frame n c).
Proof. intros. apply real_translation. now destruct (chart_good c). Qed.

Lemma product_end : forall l g, product (l ++ [g]) = compose g (product l).
Proof.
  induction l as [|h l IH]; intros g.
  - simpl. now rewrite compose_identity_l, compose_identity_r.
  - change (product ((h :: l) ++ [g])) with (compose (product (l ++ [g])) h). rewrite IH. apply compose_assoc.
Qed.

Lemma label_value_same : forall l, same (real (K.label_value n crossing_of_side l)) (label_value n crossing l).
Proof.
  intros l. unfold K.label_value. eapply same_trans; [apply same_product|].
  cbn [map]. rewrite map_app. cbn [map].
  set (back := real (K.inverse (K.frame n (target l)))).
  change (same (compose (product (map real (map crossing_of_side (word l)) ++ [back])) (real (K.frame n (from l))))
    (label_value n crossing l)).
  rewrite product_end, product_word, compose_assoc. unfold label_value, back. rewrite real_inverse.
  apply same_compose; [apply same_inverse, frame_same|].
  apply same_compose; [apply same_refl|apply frame_same].
Qed.

Lemma label_of_good : forall x, (x < dart_count d)%N ->
  same (real (value (label_number n x))) (label_of n crossing x) /\ proper (label_of n crossing x).
Proof.
  intros x Hx. pose proof (label_number_fits x Hx) as F. unfold label_of.
  destruct (N.eqb_spec (label_number n x) 0) as [E|E].
  - rewrite value_is by lia. rewrite E. simpl. split; [apply same_refl|apply proper_identity].
  - destruct F as [F _]. rewrite value_is by auto. apply N.eqb_neq in E. rewrite E. apply N.eqb_neq in E.
    split; [apply label_value_same|]. unfold label_value.
    apply proper_compose; [apply proper_inverse, frame_proper|].
    apply proper_compose; [|apply frame_proper].
    destruct (label_in (label_number n x - 1)) as [_ [_ L]]; [lia|]. eapply word_proper; exact L.
Qed.

Lemma label_of_equal : forall x x', label_number n x = label_number n x' ->
  label_of n crossing x = label_of n crossing x'.
Proof. intros x x' E. unfold label_of. now rewrite E. Qed.

(** * Rule gluing *)

Lemma next_range : forall x, (x < dart_count d)%N -> (next x < dart_count d)%N.
Proof. intros x H. unfold next, dart_count in *. destruct (N.eqb_spec (x mod 3) 2); lia. Qed.
Lemma previous_range : forall x, (x < dart_count d)%N -> (previous x < dart_count d)%N.
Proof. intros x H. unfold previous, dart_count in *. destruct (N.eqb_spec (x mod 3) 0); lia. Qed.
Lemma opposite_range : forall x, (x < dart_count d)%N -> (opposite n x < dart_count d)%N.
Proof. intros x H. now apply (dart_range d p pairs whole). Qed.

Lemma for_edges_all : forall question, K.for_edges n all_darts question = true ->
  forall x, is_edge d n x -> question x = true.
Proof.
  intros question H x [Hx L]. unfold K.for_edges in H. rewrite forallb_forall in H.
  apply (in_all_darts d) in Hx. apply H in Hx. destruct (N.ltb_spec (opposite n x) x); auto. lia.
Qed.

Theorem gluing_holds : K.gluing_rule n all_darts value = true -> edges_are_glued d n crossing.
Proof.
  intros H x E. apply (for_edges_all _ H) in E as G. destruct E as [Hx _].
  pose proof (opposite_range x Hx) as Ho.
  destruct (label_of_good x Hx) as [S1 P1].
  destruct (label_of_good _ (next_range _ Ho)) as [S2 P2].
  destruct (label_of_good _ (next_range _ Hx)) as [S3 P3].
  destruct (label_of_good _ Ho) as [S4 P4].
  apply same_same_map; [|apply proper_compose; auto; now apply proper_inverse].
  unfold K.labels_agree in G. rewrite !orb_true_iff in G. destruct G as [[G|G]|G].
  - booleans. rewrite (label_of_equal _ _ H0), (label_of_equal _ _ H1). apply same_refl.
  - booleans. rewrite (label_of_equal _ _ H0), (label_of_equal _ _ H1).
    apply proper_norm in P2, P4.
    eapply same_trans; [apply same_compose_inverse; lra|]. apply same_sym, same_compose_inverse. lra.
  - apply same_iso_same in G. rewrite !real_compose, !real_inverse in G.
    eapply same_trans; [apply same_compose; [apply same_sym; exact S1|apply same_inverse, same_sym; exact S2]|].
    eapply same_trans; [exact G|]. apply same_compose; [exact S3|now apply same_inverse].
Qed.

(** * Rule orientation *)

Lemma corner_is : forall x, (x < dart_count d)%N -> (0 < den (K.corner n value x))%Z ->
  to_C (K.corner n value x) = corner n crossing x.
Proof.
  intros x Hx H. destruct (label_of_good x Hx) as [S P]. destruct (vertex_good (start n x)) as [V1 V2].
  unfold K.corner in *. unfold corner. destruct (N.eqb_spec (label_number n x) 0) as [E|E].
  - unfold label_of. rewrite E. simpl. now rewrite act_identity.
  - rewrite image_act by lia. apply same_act; auto. eapply same_proper; [apply same_sym; exact S|exact P].
Qed.

Hypothesis left : K.orientation_rule n all_triangles value = true.

Lemma corner_in_disk : forall x, (x < dart_count d)%N -> K.in_disk (K.corner n value x) = true.
Proof.
  intros x Hx. unfold dart_count in Hx. pose proof left as L. unfold K.orientation_rule in L.
  rewrite forallb_forall in L. assert (In (x / 3)%N all_triangles) as I by (apply in_indices; lia).
  apply L in I. unfold K.triangle_is_left in I. cbv zeta in I. rewrite !andb_true_iff in I.
  destruct I as [[[I1 I2] I3] _].
  assert (x = 3 * (x / 3) \/ x = 3 * (x / 3) + 1 \/ x = 3 * (x / 3) + 2)%N as [E|[E|E]] by lia; rewrite E; auto.
Qed.

Lemma corner_good : forall x, (x < dart_count d)%N ->
  (0 < den (K.corner n value x))%Z /\ in_plane (corner n crossing x) /\
  to_C (K.corner n value x) = corner n crossing x.
Proof.
  intros x Hx. pose proof (corner_in_disk x Hx) as D. apply in_disk_plane in D. destruct D as [D1 D2].
  pose proof (corner_is x Hx D1) as E. rewrite E in D2. auto.
Qed.

Theorem orientation_holds : triangles_are_counterclockwise d n crossing.
Proof.
  intros t Ht.
  destruct (corner_good (3 * t)%N) as [A1 [A2 A3]]; [unfold dart_count; lia|].
  destruct (corner_good (3 * t + 1)%N) as [B1 [B2 B3]]; [unfold dart_count; lia|].
  destruct (corner_good (3 * t + 2)%N) as [C1 [C2 C3]]; [unfold dart_count; lia|].
  split; auto. split; auto. split; auto.
  pose proof left as L. unfold K.orientation_rule in L. rewrite forallb_forall in L.
  assert (In t all_triangles) as I by now apply in_indices.
  apply L in I. unfold K.triangle_is_left in I. cbv zeta in I. rewrite !andb_true_iff in I.
  destruct I as [_ I]. booleans. rewrite <- A3, <- B3, <- C3. now apply orientation_counterclockwise.
Qed.

(** * Rule delaunay *)

Lemma far_corner_is : forall x, (x < dart_count d)%N -> (0 < den (K.far_corner n value x))%Z ->
  to_C (K.far_corner n value x) = far_corner n crossing x.
Proof.
  intros x Hx H. pose proof (opposite_range x Hx) as Ho.
  destruct (label_of_good x Hx) as [S1 P1]. destruct (label_of_good _ (next_range _ Ho)) as [S2 P2].
  destruct (corner_good _ (previous_range _ Ho)) as [C1 [C2 C3]].
  unfold K.far_corner in *. unfold far_corner. cbv zeta in *.
  destruct (N.eqb_spec (label_number n x) (label_number n (next (opposite n x)))) as [E|E].
  - rewrite (label_of_equal _ _ E), C3.
    rewrite (same_act _ identity); auto; [now rewrite act_identity| |].
    + apply same_compose_inverse. apply proper_norm in P2. lra.
    + apply proper_compose; auto. now apply proper_inverse.
  - destruct (Z.ltb_spec 0 (den (K.image (K.inverse (value (label_number n (next (opposite n x)))))
      (K.corner n value (previous (opposite n x)))))) as [D|D]; [|simpl in H; lia].
    rewrite image_act by lia. rewrite image_act by lia. rewrite C3, real_inverse.
    assert (proper (real (value (label_number n x)))) as Q1 by (eapply same_proper; [apply same_sym; exact S1|auto]).
    assert (proper (real (value (label_number n (next (opposite n x)))))) as Q2
      by (eapply same_proper; [apply same_sym; exact S2|auto]).
    rewrite <- act_compose; auto using proper_inverse.
    apply same_act; auto using proper_compose, proper_inverse.
    apply same_compose; [exact S1|now apply same_inverse].
Qed.

Theorem delaunay_holds : K.delaunay_rule n all_darts value = true -> edges_are_delaunay d n crossing.
Proof.
  intros H x E. apply (for_edges_all _ H) in E as G. destruct E as [Hx _].
  unfold K.is_delaunay in G. cbv zeta in G. booleans.
  destruct (corner_good x Hx) as [A1 [A2 A3]]. destruct (corner_good _ (next_range _ Hx)) as [B1 [B2 B3]].
  destruct (corner_good _ (previous_range _ Hx)) as [C1 [C2 C3]].
  rewrite <- (far_corner_is x Hx H0), <- A3, <- B3, <- C3. now apply delaunay_cross_ratio.
Qed.

(** * Rules covering and packing *)

Lemma all_yes_all : forall question l, K.all_yes question l = K.Yes -> forall i, In i l -> question i = K.Yes.
Proof.
  induction l as [|j l IH]; intros H i Hi; [contradiction|]. cbn [K.all_yes] in H.
  destruct (question j) eqn:E; try discriminate. destruct Hi as [<-|Hi]; auto.
Qed.

Lemma half_real : forall z w, K.in_disk z = true -> K.in_disk w = true ->
  (IZR (K.squared_difference z w) = half (to_C z) (to_C w) * (IZR (K.gap z) * IZR (K.gap w)))%R /\
  (0 < IZR (K.gap z))%R /\ (0 < IZR (K.gap w))%R.
Proof.
  intros z w Hz Hw. apply in_disk_plane in Hz as [Dz Pz]. apply in_disk_plane in Hw as [Dw Pw].
  rewrite squared_difference_real, !gap_real by lia. apply IZR_pos in Dz, Dw. unfold half, in_plane in *.
  split; [field; lra|]. split; repeat apply Rmult_lt_0_compat; lra.
Qed.

Lemma epsilon_pos : (0 < epsilon d)%R.
Proof.
  destruct parts as [[E1 E2] _]. apply IZR_pos in E1, E2. unfold epsilon. now apply Rdiv_lt_0_compat.
Qed.

Theorem covering_holds : K.covering_rule d n all_triangles value = K.Yes -> circumradii_are_small d n crossing.
Proof.
  intros H t Ht. destruct (orientation_holds t Ht) as [Pp [Pq [Pr O]]].
  destruct parts as [[E1 E2] _]. unfold K.covering_rule in H.
  destruct (K.exp_bounds (epsilon_num d) (epsilon_den d)) as [[[l u] s]|] eqn:B; [|discriminate].
  apply exp_bounds_enclose in B; auto. cbv zeta in B. fold (epsilon d) in B. destruct B as [Bs [Bl [L U]]].
  assert (In t all_triangles) as Y by now apply in_indices.
  apply (all_yes_all _ _ H) in Y. clear H.
  unfold K.is_covered in Y. cbv zeta in Y.
  destruct (corner_good (3 * t)%N) as [_ [_ A]]; [unfold dart_count; lia|].
  destruct (corner_good (3 * t + 1)%N) as [_ [_ B]]; [unfold dart_count; lia|].
  destruct (corner_good (3 * t + 2)%N) as [_ [_ C]]; [unfold dart_count; lia|].
  assert (K.in_disk (K.corner n value (3 * t)) = true) as Dp by (apply corner_in_disk; unfold dart_count; lia).
  assert (K.in_disk (K.corner n value (3 * t + 1)) = true) as Dq by (apply corner_in_disk; unfold dart_count; lia).
  assert (K.in_disk (K.corner n value (3 * t + 2)) = true) as Dr by (apply corner_in_disk; unfold dart_count; lia).
  set (pp := K.corner n value (3 * t)) in *. set (qq := K.corner n value (3 * t + 1)) in *.
  set (rr := K.corner n value (3 * t + 2)) in *.
  destruct (half_real pp qq Dp Dq) as [Ea [Gp Gq]]. destruct (half_real qq rr Dq Dr) as [Eb [_ Gr]].
  destruct (half_real rr pp Dr Dp) as [Ec _].
  rewrite A, B in Ea. rewrite B, C in Eb. rewrite C, A in Ec.
  set (a := half (corner n crossing (3 * t)) (corner n crossing (3 * t + 1))) in *.
  set (b := half (corner n crossing (3 * t + 1)) (corner n crossing (3 * t + 2))) in *.
  set (c := half (corner n crossing (3 * t + 2)) (corner n crossing (3 * t))) in *.
  assert (0 <= a)%R as Na by now apply half_nonneg.
  assert (0 <= b)%R as Nb by now apply half_nonneg.
  assert (0 <= c)%R as Nc by now apply half_nonneg.
  match type of Y with (if (?x <? ?y)%Z then _ else _) = _ => destruct (Z.ltb_spec x y) as [Q|Q] end.
  2: { destruct (_ || _); discriminate. }
  apply IZR_lt in Q. revert Q. reals. rewrite Ea, Eb, Ec. intro Q.
  set (gp := IZR (K.gap pp)) in *. set (gq := IZR (K.gap qq)) in *. set (gr := IZR (K.gap rr)) in *.
  set (k := (2 * (a * b + b * c + c * a) - a * a - b * b - c * c)%R).
  set (m := (gp * gq * gr * (gp * gq * gr))%R).
  assert (0 < m)%R as Pm by (unfold m; repeat apply Rmult_lt_0_compat; auto).
  assert (4 * (a * b * c) * (4 * IZR l * IZR s) < (IZR l - IZR s) * (IZR l - IZR s) * k)%R as Q'.
  { apply Rmult_lt_reg_l with m; auto. unfold m, k. ring_simplify. ring_simplify in Q. lra. }
  apply IZR_pos in Bs. apply IZR_le in Bl.
  pose proof (sinh_above (epsilon d) (IZR l) (IZR s) Bs Bl L) as S.
  assert (0 <= a * b * c)%R as Nabc by (apply Rmult_le_pos; [apply Rmult_le_pos; auto|auto]).
  assert (0 < IZR l * IZR s)%R as Pls by (apply Rmult_lt_0_compat; lra).
  assert (0 <= (IZR l - IZR s) * (IZR l - IZR s))%R as Nq by apply Rle_0_sqr.
  assert (0 < k)%R as Pk.
  { apply Rnot_le_lt. intro Nk.
    assert (0 <= 4 * (a * b * c) * (4 * IZR l * IZR s))%R by nra. nra. }
  apply circumcircle; auto; [apply epsilon_pos|].
  fold a b c k. apply Rmult_le_reg_r with (4 * IZR l * IZR s)%R; [lra|].
  apply Rle_trans with ((IZR l - IZR s) * (IZR l - IZR s) * k)%R; [lra|].
  replace (sinh (epsilon d) * sinh (epsilon d) * k * (4 * IZR l * IZR s))%R
    with (sinh (epsilon d) * sinh (epsilon d) * (4 * IZR l * IZR s) * k)%R by ring.
  apply Rmult_le_compat_r; lra.
Qed.

Theorem packing_holds : K.packing_rule d n all_darts value = K.Yes -> edges_are_long d n crossing.
Proof.
  intros H x [Hx Lx] D.
  destruct parts as [[E1 E2] _]. unfold K.packing_rule in H.
  destruct (K.exp_bounds (epsilon_num d) (2 * epsilon_den d)) as [[[l u] s]|] eqn:B; [|discriminate].
  apply exp_bounds_enclose in B; auto; [|lia]. cbv zeta in B. destruct B as [Bs [Bl [L U]]].
  assert (IZR (epsilon_num d) / IZR (2 * epsilon_den d) = epsilon d / 2)%R as Ee.
  { unfold epsilon. rewrite mult_IZR. apply IZR_pos in E2. field. lra. }
  rewrite Ee in L, U.
  assert (In x all_darts) as I by now apply in_all_darts.
  apply (all_yes_all _ _ H) in I. unfold K.is_long in I. cbv zeta in I.
  destruct (N.ltb_spec (opposite n x) x); [lia|]. apply N.eqb_neq in D. rewrite D in I. simpl orb in I. cbv iota in I.
  pose proof (next_range x Hx) as Hn.
  destruct (corner_good x Hx) as [_ [P1 A]]. destruct (corner_good _ Hn) as [_ [P2 B]].
  destruct (half_real _ _ (corner_in_disk x Hx) (corner_in_disk _ Hn)) as [E [G1 G2]]. rewrite A, B in E.
  match type of I with (if (?x <=? ?y)%Z then _ else _) = _ => destruct (Z.leb_spec x y) as [Q|Q] end.
  2: { match type of I with (if ?x then _ else _) = _ => destruct x end; discriminate. }
  apply IZR_le in Q. revert Q. reals. rewrite E. intro Q.
  set (g1 := IZR (K.gap (K.corner n value x))) in *. set (g2 := IZR (K.gap (K.corner n value (next x)))) in *.
  set (h := half (corner n crossing x) (corner n crossing (next x))) in *.
  apply distance_below; [pose proof epsilon_pos; lra|]. fold h.
  apply IZR_pos in Bs as Ps. apply IZR_le in Bl as Pl.
  assert (IZR s <= IZR s * exp (2 * (epsilon d / 2)))%R as Le by lra.
  pose proof (sinh_below (epsilon d / 2) (IZR u) (IZR s) Ps Le U) as S.
  assert (0 < IZR u)%R as Pu by lra.
  assert (0 < 4 * IZR u * IZR s)%R as Pus by (repeat apply Rmult_lt_0_compat; lra).
  apply Rmult_le_reg_r with (4 * IZR u * IZR s)%R; auto.
  apply Rle_trans with ((IZR u - IZR s) * (IZR u - IZR s))%R; auto.
  assert (0 < g1 * g2)%R as Pg by now apply Rmult_lt_0_compat.
  apply Rmult_le_reg_r with (g1 * g2)%R; auto. lra.
Qed.
End Rules.
