(** check d = true -> statement d. *)

From Coq Require Import ZArith NArith List Bool Lia FunctionalExtensionality.
From Epsnet Require Import Document Arrays Statement Integers Surface Net.
Module K := Checker.

(** The arrays of the program are the lists of the document. *)
Lemma fast_net_plain : forall d pairs, K.fast_net d pairs = net_of d (partner (K.fast_net d pairs)).
Proof.
  intros. unfold K.fast_net, net_of. cbn [partner].
  f_equal; apply functional_extensionality; intro; apply get_of_list.
Qed.

Lemma found_values : forall d n crossing k, (k <= size (labels d))%N ->
  get (K.find_values d n crossing) K.identity k =
  if (k =? 0)%N then K.identity else K.label_value n crossing (at_index (labels d) no_label (k - 1)).
Proof.
  intros d n crossing k H. unfold K.find_values. rewrite get_of_list. unfold at_index.
  destruct (N.eqb_spec k 0) as [->|E]; [reflexivity|].
  replace (N.to_nat k) with (S (N.to_nat (k - 1))) by lia. cbn [nth].
  unfold size in H.
  rewrite nth_indep with (d' := K.label_value n crossing no_label) by (rewrite map_length; lia).
  apply map_nth.
Qed.

Theorem check_is_right : forall d, K.check d = true -> statement d.
Proof.
  intros d H. unfold K.check, K.decide in H. cbv zeta in H.
  set (pairs := K.find_pairs d) in *. rewrite fast_net_plain in H.
  set (p := partner (K.fast_net d pairs)) in *. set (n := net_of d p) in *.
  destruct (K.structure d n (indices (sides d)) pairs) eqn:H0; [|discriminate].
  set (crossing := get (K.find_crossings n (indices (sides d))) K.identity) in *.
  set (cycles := K.cycles_of _ _ _ _) in *.
  destruct (K.surface d n _ crossing cycles) eqn:H1; [|discriminate].
  set (first := get (K.find_first _ _) _) in *.
  destruct (K.map_rule _ _ _ _ _ first cycles) eqn:H2; [|discriminate].
  set (value := get (K.find_values d n crossing) K.identity) in *.
  assert (forall k, (k <= size (labels d))%N -> value k =
    if (k =? 0)%N then K.identity else K.label_value n crossing (label_at n (k - 1))) as V
    by exact (found_values d n crossing).
  destruct (K.gluing_rule _ _ value) eqn:H3; [|discriminate].
  destruct (K.orientation_rule _ _ value) eqn:H4; [|discriminate].
  destruct (K.delaunay_rule _ _ value) eqn:H5; [|discriminate].
  destruct (K.covering_rule _ _ _ value) eqn:H6; try discriminate.
  destruct (K.packing_rule _ _ _ value) eqn:H7; try discriminate.
  exists p, (fun s => real (crossing s)), cycles, (1 - K.euler_of_surface d cycles / 2)%Z.
  cbv zeta. fold n.
  split; [eapply epsilon_pos; eauto|].
  split; [eapply surface; eauto|].
  split; [eapply map_of_triangles; eauto|].
  split; [eapply labels_are_fit; eauto|].
  split; [eapply gluing_holds; eauto|].
  split; [eapply orientation_holds; eauto|].
  split; [eapply delaunay_holds; eauto|].
  split; [eapply covering_holds; eauto|].
  eapply packing_holds; eauto.
Qed.

Print Assumptions check_is_right.
