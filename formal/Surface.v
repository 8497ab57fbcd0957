(** Structure, rule surface, rule map. *)

From Coq Require Import ZArith NArith Reals List Bool Lia Lra Psatz Permutation FunctionalExtensionality.
From Epsnet Require Import Document Arrays Statement Plane Integers Searches Convex Angles Circle.
Import ListNotations.
Module K := Checker.
Ltac Zify.zify_post_hook ::= Z.to_euclidean_division_equations.

Lemma size_indices : forall A (l : list A), size (indices l) = size l.
Proof. intros. unfold size, indices. now rewrite length_count. Qed.

Lemma in_at_index : forall A (l : list A) nothing i, (i < size l)%N -> In (at_index l nothing i) l.
Proof. intros. unfold at_index, size in *. apply nth_In. lia. Qed.

Lemma at_index_or : forall A (l : list A) nothing i, In (at_index l nothing i) l \/ at_index l nothing i = nothing.
Proof. intros. unfold at_index. destruct (nth_in_or_default (N.to_nat i) l nothing); auto. Qed.

Lemma in_combine_left : forall A B (l : list A) (l' : list B) x, length l = length l' -> In x l ->
  exists y, In (x, y) (combine l l').
Proof.
  induction l as [|a l IH]; intros [|b l'] x E H; simpl in *; try contradiction; try discriminate.
  destruct H as [->|H]; [eauto|]. destruct (IH l' x) as [y Hy]; eauto.
Qed.

Lemma in_combine_right : forall A B (l : list A) (l' : list B) y, length l = length l' -> In y l' ->
  exists x, In (x, y) (combine l l').
Proof.
  induction l as [|a l IH]; intros [|b l'] y E H; simpl in *; try contradiction; try discriminate.
  destruct H as [->|H]; [eauto|]. destruct (IH l' y) as [x Hx]; eauto.
Qed.

Lemma pairs_differ : forall (pairs : list (N * N)) ss,
  NoDup (flat_map (fun p : N * N => [fst p; snd p]) pairs) -> In ss pairs -> fst ss <> snd ss.
Proof.
  induction pairs as [|q pairs IH]; intros ss D H; [contradiction|].
  simpl in D. inversion_clear D. inversion_clear H1. destruct H as [->|H]; auto.
  intro E. apply H0. rewrite E. now left.
Qed.

Section Rules.
Variable d : document.
Variable p : N -> N.
Let n := net_of d p.
Let all_sides := indices (sides d).
Let all_triangles := indices (triangles d).
Let all_vertices := indices (vertices d).
Let all_darts := flat_map (fun t => [3 * t; 3 * t + 1; 3 * t + 2])%N all_triangles.
Variable pairs : list (N * N).
Hypothesis whole : K.structure d n all_sides pairs = true.

Lemma in_all_darts : forall x, In x all_darts <-> (x < dart_count d)%N.
Proof.
  intros x. unfold all_darts, all_triangles, dart_count. rewrite in_flat_map. split.
  - intros [t [H [<-|[<-|[<-|[]]]]]]; apply in_indices in H; lia.
  - intros H. exists (x / 3)%N. rewrite in_indices. split; [lia|].
    assert (x = 3 * (x / 3) \/ x = 3 * (x / 3) + 1 \/ x = 3 * (x / 3) + 2)%N as [E|[E|E]] by lia;
      rewrite E at 1; cbn [In]; auto.
Qed.

Lemma in_all_sides : forall s, In s all_sides <-> (s < side_count d)%N.
Proof. intros. apply in_indices. Qed.

Lemma in_all_triangles : forall t, In t all_triangles <-> (t < size (triangles d))%N.
Proof. intros. apply in_indices. Qed.

Lemma structure_parts :
  ((0 < epsilon_num d)%Z /\ (0 < epsilon_den d)%Z) /\
  (forall t, In t (tiles d) -> (3 <= length t)%nat /\ forall z, In z t -> (0 < den z)%Z) /\
  (forall r ss, In (r, ss) (combine (gluing d) pairs) -> K.glues n r (fst ss) (snd ss) = true) /\
  length (gluing d) = length pairs /\
  Permutation (flat_map (fun p : N * N => [fst p; snd p]) pairs) all_sides /\
  (forall c, In c (charts d) -> (tile_of_chart c < size (tiles d))%N /\ K.in_disk (centre c) = true) /\
  (forall l, In l (labels d) -> K.label_fits n (size (charts d)) (size (sides d)) l = true) /\
  (forall v, In v (vertices d) -> (chart_of v < size (charts d))%N /\ K.in_disk (place v) = true) /\
  (forall t, In t (triangles d) ->
     K.triangle_fits n (size (vertices d)) (3 * size (triangles d)) (size (labels d)) t = true).
Proof.
  pose proof whole as S. unfold K.structure in S. rewrite !andb_true_iff, !forallb_forall in S.
  destruct S as [[[[[[[[[[S1 S2] S3] S4] S5] S6] S7] S8] S9] S10] S11].
  unfold all_sides in *. rewrite !fast_size_size in *. rewrite size_indices in *. booleans.
  split; auto. split.
  { intros t Ht. apply S4 in Ht. booleans. rewrite fast_size_size in H. unfold size in H. split; [lia|].
    rewrite forallb_forall in H0. intros z Hz. apply H0 in Hz. now apply Z.ltb_lt. }
  split; [intros r ss H; apply (S6 (r, ss) H)|].
  split; [unfold size in S5; lia|].
  split; [apply exactly_once_permutation; [apply NoDup_indices|exact S7]|].
  split.
  { intros c Hc. apply S8 in Hc. now booleans. }
  split; auto. split; auto.
  intros v Hv. apply S10 in Hv. now booleans.
Qed.

Lemma corner_den : forall s, (0 < den (corner_at n s))%Z.
Proof.
  intros s. unfold n, net_of. cbn [corner_at].
  destruct (at_index_or _ (concat (tiles d)) origin s) as [H| ->]; [|simpl; lia].
  apply in_concat in H. destruct H as [t [Ht Hz]]. destruct structure_parts as [_ [S _]]. now apply (S t).
Qed.

Lemma glues_parts : forall r s s', K.glues n r s s' = true ->
  side_at n s = (t_one r, k_one r) /\ side_at n s' = (t_two r, k_two r) /\ partner n s = s' /\ partner n s' = s.
Proof.
  intros r s s' H. unfold K.glues in H. destruct (side_at n s), (side_at n s'). booleans. now subst.
Qed.

Lemma paired : sides_are_paired d n.
Proof.
  destruct structure_parts as [_ [_ [G [L [P _]]]]].
  assert (NoDup (flat_map (fun p : N * N => [fst p; snd p]) pairs)) as D.
  { eapply Permutation_NoDup; [apply Permutation_sym; exact P|]. apply NoDup_indices. }
  split.
  - intros s Hs. apply in_all_sides in Hs. apply (Permutation_in s (Permutation_sym P)) in Hs.
    apply in_flat_map in Hs. destruct Hs as [ss [I Hs]].
    pose proof (pairs_differ pairs ss D I) as N0.
    destruct (in_combine_right _ _ _ _ ss L I) as [r Hr]. apply G in Hr. apply glues_parts in Hr.
    destruct Hr as [_ [_ [E1 E2]]].
    assert (forall s', In s' [fst ss; snd ss] -> (s' < side_count d)%N) as B.
    { intros s' H. apply in_all_sides. eapply Permutation_in; [exact P|]. apply in_flat_map. eauto. }
    destruct Hs as [<-|[<-|[]]].
    + rewrite E1, E2. split; [apply B; simpl; auto|]. split; auto.
    + rewrite E2, E1. split; [apply B; simpl; auto|]. split; auto.
  - intros r Hr. destruct (in_combine_left _ _ _ _ r L Hr) as [ss I]. pose proof (in_combine_r _ _ _ _ I) as I'.
    apply G in I. apply glues_parts in I. destruct I as [E1 [E2 [E3 E4]]]. exists (fst ss). split.
    + apply in_all_sides. eapply Permutation_in; [exact P|]. apply in_flat_map. exists ss. simpl. auto.
    + rewrite E3. auto.
Qed.

(** ** Rule surface *)

Variable crossing_of_side : N -> K.iso.
Variable cycles : list (list N).
Hypothesis rule : K.surface d n all_sides crossing_of_side cycles = true.
Let crossing s := real (crossing_of_side s).
Let genus := (1 - K.euler_of_surface d cycles / 2)%Z.

Lemma surface_parts :
  (forall t, In t (tiles d) -> K.convex t = true) /\
  K.connected all_sides (fun s => [side_after n s; partner n s]) = true /\
  (forall s, (s < side_count d)%N -> K.equal_length n s = true) /\
  (forall s, (s < side_count d)%N -> K.crossing_fits n crossing_of_side s = true) /\
  Permutation (concat cycles) all_sides /\
  (forall c, In c cycles -> K.closes_up n crossing_of_side c = true) /\
  (K.euler_of_surface d cycles < 0)%Z /\ (K.euler_of_surface d cycles mod 2 = 0)%Z.
Proof.
  pose proof rule as S. unfold K.surface in S. rewrite !andb_true_iff, !forallb_forall in S.
  destruct S as [[[[[[[S1 S2] S3] S4] S5] S6] S7] S8]. booleans.
  repeat split; auto.
  - intros s H. now apply S3, in_all_sides.
  - intros s H. now apply S4, in_all_sides.
  - apply exactly_once_permutation; [apply NoDup_indices|exact S5].
Qed.

Lemma corner_plane : forall s, in_plane (to_C (corner_at n s)).
Proof.
  intros s. unfold n, net_of. cbn [corner_at].
  destruct (at_index_or _ (concat (tiles d)) origin s) as [H| ->].
  - apply in_concat in H. destruct H as [t [Ht Hz]]. destruct surface_parts as [S _]. apply S in Ht.
    unfold K.convex in Ht. apply andb_prop in Ht. destruct Ht as [Ht _]. rewrite forallb_forall in Ht.
    now apply in_disk_plane, Ht.
  - unfold in_plane, to_C, origin. coordinates. lra.
Qed.

Lemma equal_distance : forall u v u' v', in_plane (to_C u) -> in_plane (to_C v) -> in_plane (to_C u') ->
  in_plane (to_C v') -> (0 < den u)%Z -> (0 < den v)%Z -> (0 < den u')%Z -> (0 < den v')%Z ->
  (K.squared_difference u v * (K.gap u' * K.gap v') = K.squared_difference u' v' * (K.gap u * K.gap v))%Z ->
  distance (to_C u) (to_C v) = distance (to_C u') (to_C v').
Proof.
  intros u v u' v' Pu Pv Pu' Pv' Du Dv Du' Dv' E. apply distance_of_half.
  apply (f_equal IZR) in E. rewrite !mult_IZR in E.
  rewrite !squared_difference_real, !gap_real in E by lia. apply IZR_pos in Du, Dv, Du', Dv'.
  unfold half, in_plane in *.
  set (m := (IZR (den u) * IZR (den u) * (IZR (den v) * IZR (den v)) *
    ((IZR (den u') * IZR (den u')) * (IZR (den v') * IZR (den v'))))%R).
  assert (0 < m)%R by (unfold m; repeat apply Rmult_lt_0_compat; auto).
  set (x := abs2 (Csub (to_C u) (to_C v))) in *. set (x' := abs2 (Csub (to_C u') (to_C v'))) in *.
  set (g := (1 - abs2 (to_C u))%R) in *. set (h := (1 - abs2 (to_C v))%R) in *.
  set (g' := (1 - abs2 (to_C u'))%R) in *. set (h' := (1 - abs2 (to_C v'))%R) in *.
  assert (0 < g /\ 0 < h /\ 0 < g' /\ 0 < h')%R as [A [B [A' B']]] by (unfold g, h, g', h'; lra).
  assert (x * (g' * h') = x' * (g * h))%R as F.
  { apply Rmult_eq_reg_l with m; [|lra]. unfold m. lra. }
  apply Rmult_eq_reg_r with ((g * h) * (g' * h'))%R; [|apply Rgt_not_eq; repeat apply Rmult_lt_0_compat; auto].
  transitivity (x * (g' * h'))%R; [field; lra|]. rewrite F. field. lra.
Qed.

Lemma takes_act : forall f z w, (0 < den z)%Z -> (0 < den w)%Z -> K.takes f z w = true ->
  act (real f) (to_C z) = to_C w.
Proof.
  intros f z w Hz Hw H. unfold K.takes in H. booleans. rewrite <- image_act by lia. now apply same_point_eq.
Qed.

Lemma crossings : crossings_fit d n crossing.
Proof.
  intros s Hs. destruct surface_parts as [_ [_ [E [F _]]]].
  pose proof (E s Hs) as Es. pose proof (F s Hs) as Fs. unfold K.equal_length in Es. unfold K.crossing_fits in Fs.
  booleans. split; [|split; [now apply proper_real|split]].
  - apply equal_distance; try apply corner_plane; try apply corner_den. exact Es.
  - apply takes_act; try apply corner_den; auto.
  - apply takes_act; try apply corner_den; auto.
Qed.

Lemma product_word : forall c, product (map real (map crossing_of_side c)) = word_value crossing c.
Proof.
  induction c as [|s c IH]; [reflexivity|]. simpl. unfold product in *. simpl. now rewrite IH.
Qed.

Lemma angle_of_turn : forall s, K.turn_fits n s = true ->
  exists r, (0 < r)%R /\ (0 < interior_angle n s < PI)%R /\
  complex (K.turn n s) = ((r * cos (interior_angle n s))%R, (r * sin (interior_angle n s))%R).
Proof.
  intros s H. unfold K.turn_fits in H. booleans.
  set (g := K.inverse (K.translation (corner_at n s))) in *.
  assert (same (real g) (inverse (translation (to_C (corner_at n s))))) as Sg.
  { unfold g. rewrite real_inverse. apply same_inverse, real_translation, corner_den. }
  assert (proper (real g)) as Pg.
  { eapply same_proper; [apply same_sym; exact Sg|]. apply proper_inverse, proper_translation, corner_plane. }
  assert (forall z, (0 < den z)%Z -> in_plane (to_C z) -> (0 < den (K.image g z))%Z ->
    complex (K.num (K.image g z)) =
    Cmul (IZR (den (K.image g z)), 0%R) (act (inverse (translation (to_C (corner_at n s)))) (to_C z))) as A.
  { intros z Dz Pz Di. rewrite <- to_C_num by lia. rewrite image_act by lia. now rewrite (same_act _ _ _ Sg). }
  set (e := side_end n s) in *. set (f := corner_at n (side_before n s)) in *.
  pose proof (A e (corner_den _) (corner_plane _) H) as Ae.
  pose proof (A f (corner_den _) (corner_plane _) H1) as Af.
  set (q := act (inverse (translation (to_C (corner_at n s)))) (to_C e)) in *.
  set (r := act (inverse (translation (to_C (corner_at n s)))) (to_C f)) in *.
  set (m := (IZR (den (K.image g f)) * IZR (den (K.image g e)))%R).
  assert (0 < m)%R as Pm by (unfold m; apply Rmult_lt_0_compat; now apply IZR_pos).
  assert (complex (K.turn n s) = Cmul (m, 0%R) (Cmul r (Cconj q))) as T.
  { unfold K.turn. fold g e f. rewrite complex_mul, complex_conj, Ae, Af. unfold m.
    apply C_eq; coordinates; ring. }
  assert (0 < Im (complex (K.turn n s)))%R as I by (apply IZR_pos in H0; exact H0).
  assert (interior_angle n s = acos (Re (complex (K.turn n s)) / sqrt (abs2 (complex (K.turn n s))))) as A'.
  { rewrite T, acos_scale by auto. reflexivity. }
  destruct (polar _ I) as [P1 [P2 P3]]. rewrite <- A' in P1, P3.
  exists (sqrt (abs2 (complex (K.turn n s)))). split; [exact P2|]. split; [exact P1|exact P3].
Qed.

Lemma corners : corners_fit d n crossing cycles.
Proof.
  destruct surface_parts as [_ [_ [_ [_ [P [C _]]]]]]. split.
  - unfold all_sides in P. rewrite indices_seq in P. exact P.
  - intros c Hc. apply C in Hc. unfold K.closes_up in Hc. booleans.
    split; [now apply goes_round_next|]. split.
    + apply same_iso_same in H1.
      assert (same identity (word_value crossing c)) as S.
      { eapply same_trans; [exact H1|]. rewrite <- product_word. apply same_product. }
      intros z Hz. symmetry. apply same_act; auto. apply proper_identity.
    + apply (one_turn_sum n (interior_angle n) angle_of_turn c H0).
Qed.

Lemma euler : euler_characteristic d cycles = K.euler_of_surface d cycles.
Proof.
  unfold euler_characteristic, K.euler_of_surface. rewrite !fast_size_size. unfold size. lia.
Qed.

Theorem surface : is_surface d n crossing cycles genus.
Proof.
  destruct surface_parts as [S1 [S2 [_ [_ [_ [_ [S7 S8]]]]]]]. destruct structure_parts as [_ [T _]].
  split; [intros tile Ht; apply convex_strictly; [now apply T|now apply S1]|].
  split; [apply paired|]. split; [apply crossings|].
  split; [intros s Hs; apply connected_reaches with all_sides; auto; now apply in_all_sides|].
  split; [apply corners|]. rewrite euler. unfold genus. lia.
Qed.

(** ** Rule map *)

Lemma triangle_in : forall t, (t < size (triangles d))%N -> In (triangle_at n t) (triangles d).
Proof. intros. now apply in_at_index. Qed.

Lemma of_corner_in : forall A x (u v w : A), In (of_corner x u v w) [u; v; w].
Proof. intros. unfold of_corner. destruct (x mod 3)%N as [|[?|?|]]; simpl; auto. Qed.

Lemma dart_range : forall x, (x < dart_count d)%N ->
  (start n x < size (vertices d))%N /\ (opposite n x < dart_count d)%N.
Proof.
  intros x Hx. unfold dart_count in *. destruct structure_parts as [_ [_ [_ [_ [_ [_ [_ [_ T]]]]]]]].
  assert (x / 3 < size (triangles d))%N as Ht by lia. apply triangle_in in Ht. apply T in Ht.
  unfold K.triangle_fits in Ht. apply andb_prop in Ht. destruct Ht as [Ht _]. apply andb_prop in Ht.
  destruct Ht as [Ht _]. apply andb_prop in Ht. destruct Ht as [Hv Ho]. rewrite forallb_forall in Hv, Ho.
  split; apply N.ltb_lt; [apply Hv|apply Ho]; apply of_corner_in.
Qed.

Variable first : N -> N.
Hypothesis map_holds : K.map_rule d n all_darts all_vertices all_triangles first cycles = true.

Theorem map_of_triangles : is_map d n genus.
Proof.
  pose proof map_holds as S. unfold K.map_rule in S. cbv zeta in S. rewrite !andb_true_iff, !forallb_forall in S.
  destruct S as [[[[[[S1 S2] S3] S4] S5] S6] S7]. rewrite !fast_size_size in *. booleans.
  assert (darts_are_paired d n) as D.
  { intros x Hx. pose proof (dart_range x Hx) as [_ R]. apply in_all_darts in Hx. apply S3 in Hx. booleans. auto. }
  split; auto. split; auto. split; auto. split.
  { split; [intros x Hx; now apply dart_range|].
    assert (forall x, (x < dart_count d)%N -> (turn_left n x < dart_count d)%N /\ start n (turn_left n x) = start n x)
      as T.
    { intros x Hx. assert (previous x < dart_count d)%N as Hp.
      { unfold previous, dart_count in *. destruct (N.eqb_spec (x mod 3) 0); lia. }
      destruct (D _ Hp) as [R1 [_ [R2 _]]]. unfold turn_left. split; auto.
      destruct (D _ R1) as [_ [_ [_ R3]]]. rewrite R3, R2. f_equal.
      unfold next, previous. repeat match goal with |- context [N.eqb ?i ?j] => destruct (N.eqb_spec i j) end; lia. }
    assert (forall v, In v all_vertices -> (first v < dart_count d)%N /\ start n (first v) = v) as F.
    { intros v Hv. apply S4 in Hv. booleans. auto. }
    assert (forall v k, In v all_vertices ->
      (Nat.iter k (turn_left n) (first v) < dart_count d)%N /\ start n (Nat.iter k (turn_left n) (first v)) = v) as I.
    { intros v k Hv. induction k as [|k [IH1 IH2]]; [now apply F|]. simpl. destruct (T _ IH1) as [T1 T2].
      split; auto. now rewrite T2. }
    intros v Hv. assert (In v all_vertices) as Iv by now apply in_indices.
    exists (first v). destruct (F v Iv) as [F1 F2]. split; auto. split; auto.
    intros x Hx E. apply in_all_darts in Hx. apply S5 in Hx.
    apply (walks_reach (turn_left n) all_darts first all_vertices all_vertices nobody) in Hx; auto.
    - destruct Hx as [v' [k [Hv' ->]]]. destruct (I v' k Hv') as [_ E']. exists k. congruence.
    - intros y Hy. now rewrite mem_nobody in Hy. }
  split.
  - intros t Ht. apply connected_reaches with all_triangles.
    + rewrite <- S6. f_equal. apply functional_extensionality. intro i. cbn [map]. now rewrite N.add_0_r.
    + now apply in_all_triangles.
  - destruct surface_parts as [_ [_ [_ [_ [_ [_ [_ E]]]]]]]. unfold genus. lia.
Qed.
End Rules.
