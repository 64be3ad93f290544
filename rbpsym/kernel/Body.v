(* Any rigid body, of which nothing is known but that sums over its particles by their mass are linear. *)
Require Export Prelude.
Require Import FunctionalExtensionality.

Definition total {particle : Type} (mean : (particle -> R) -> R) (f : particle -> R -> R) (t : R) : R := mean (fun p => f p t).
Definition rate {particle : Type} (f : particle -> R -> R) (p : particle) (t : R) : R := Derive (f p) t.
Definition moves (x v : R -> R) : Prop := forall t, is_derive x t (v t).
Definition turns (w x y : R -> R) : Prop := moves x (fun t => - (w t * y t)) /\ moves y (fun t => w t * x t).
Definition steady (f : R -> R) : Prop := forall t, continuous f t.

(* ∫ f dm is linear, and goes with continuity and with integrals over the time. *)
Definition sums {particle : Type} (mean : (particle -> R) -> R) : Prop :=
  (forall f g, mean (fun p => f p + g p) = mean f + mean g) /\ (forall c f, mean (fun p => c * f p) = c * mean f) /\
  (forall f, (forall p, steady (f p)) -> steady (total mean f)) /\
  (forall f t, (forall p, steady (f p)) -> mean (fun p => RInt (f p) 0 t) = RInt (total mean f) 0 t).
(* The motion is smooth, and all particles turn about the centre of mass alike. *)
Definition motion {particle : Type} (R_cm_x R_cm_y V_cm_x V_cm_y A_cm_x A_cm_y varphi omega alpha : R -> R)
    (r_x r_y F_ext_i_x F_ext_i_y : particle -> R -> R) : Prop :=
  (moves R_cm_x V_cm_x /\ moves R_cm_y V_cm_y /\ moves V_cm_x A_cm_x /\ moves V_cm_y A_cm_y /\ moves varphi omega
    /\ moves omega alpha) /\ (steady A_cm_x /\ steady A_cm_y /\ steady alpha) /\
  (forall p, moves (r_x p) (fun t => - (omega t * r_y p t))) /\ (forall p, moves (r_y p) (fun t => omega t * r_x p t)) /\
  (forall p, steady (F_ext_i_x p)) /\ (forall p, steady (F_ext_i_y p)).

(* Sums, rates and works of functions of the time; a formula below them is rewritten as a whole. *)
Lemma rates : forall f g, moves f g -> Derive f = g.
Proof. intros f g D. apply functional_extensionality. intros t. apply is_derive_unique, D. Qed.
Lemma rates_of : forall (particle : Type) (f g : particle -> R -> R), (forall p, moves (f p) (g p)) -> rate f = g.
Proof. intros particle f g D. apply functional_extensionality. intros p. apply rates, D. Qed.
Section Sums.
Context {particle : Type} {mean : (particle -> R) -> R} (S : sums mean).
Lemma total_plus : forall f g, total mean (fun p t => f p t + g p t) = fun t => total mean f t + total mean g t.
Proof. intros. apply functional_extensionality. intros t. apply (proj1 S). Qed.
Lemma total_times : forall c f, total mean (fun p t => c t * f p t) = fun t => c t * total mean f t.
Proof. intros. apply functional_extensionality. intros t. apply (proj1 (proj2 S)). Qed.
Lemma total_works : forall f, (forall p, steady (f p)) ->
  total mean (fun p t => RInt (f p) 0 t) = fun t => RInt (total mean f) 0 t.
Proof. intros f C. apply functional_extensionality. intros t. apply (proj2 (proj2 (proj2 S))), C. Qed.
Lemma total_steady : forall f, (forall p, steady (f p)) -> steady (total mean f).
Proof. apply (proj1 (proj2 (proj2 S))). Qed.
End Sums.
Lemma same_rates : forall f g d e, moves f d -> moves g e -> (forall t, d t = e t) -> f 0 = g 0 -> forall t, f t = g t.
Proof.
  intros f g d e F G E B t. apply Rminus_diag_uniq.
  apply (flat (Rmin 0 t - 1) (Rmax 0 t + 1) (fun u => f u - g u)); pose proof (Rmin_l 0 t); pose proof (Rmin_r 0 t);
    pose proof (Rmax_l 0 t); pose proof (Rmax_r 0 t); try lra.
  intros u _. apply D_eq with (d u - e u); [apply (D_minus f g) | rewrite E]; [apply F | apply G | ring].
Qed.
Lemma work_rate : forall g, steady g -> moves (fun t => RInt g 0 t) g.
Proof.
  intros g C t. apply (rate_time (Rmin 0 t - 1) (Rmax 0 t + 1)); [ | | intros; apply C];
    pose proof (Rmin_l 0 t); pose proof (Rmin_r 0 t); pose proof (Rmax_l 0 t); pose proof (Rmax_r 0 t); lra.
Qed.

(* Derivatives and continuity at all times. *)
Ltac differ := unfold moves in *; intros; cbv beta in *; repeat (
  lazymatch goal with
  | |- is_derive (fun _ => ?c) _ _ => apply D_const
  | |- is_derive (fun u => @?f u + @?g u) _ _ => eapply (D_plus f g)
  | |- is_derive (fun u => - @?f u) _ _ => eapply (D_opp f)
  | |- is_derive (fun u => @?f u / ?c) _ _ => eapply (D_div f c)
  | |- is_derive (fun u => @?f u * @?g u) _ _ => eapply (D_mult f g)
  | |- is_derive (fun u => @?f u ^ ?n) _ _ => eapply (D_pow f n)
  | |- is_derive (fun u => sin (@?f u)) _ _ => eapply (D_sin f)
  | |- is_derive (fun u => cos (@?f u)) _ _ => eapply (D_cos f)
  | |- is_derive (fun u => RInt ?g 0 u) _ _ => apply (work_rate g); remain
  | D : forall t, is_derive ?f t _ |- is_derive (fun u => ?f u) ?t _ => exact (D t)
  | D : forall p t, is_derive (?f p) t _ |- is_derive (fun u => ?f ?p u) ?t _ => exact (D p t)
  end; cbv beta)
with remain := unfold steady in *; intros; cbv beta in *; repeat (
  lazymatch goal with
  | |- continuous (fun _ => ?c) _ => apply continuous_const
  | |- continuous (fun u => @?f u + @?g u) _ => apply (C_plus f g)
  | |- continuous (fun u => - @?f u) _ => apply (C_opp f)
  | |- continuous (fun u => @?f u * @?g u) _ => apply (C_mult f g)
  | |- continuous (fun u => @?f u / ?c) _ => apply (C_div f c)
  | |- continuous (fun u => @?f u ^ ?n) _ => apply (C_pow f n)
  | C : forall t, continuous ?f t |- continuous (fun u => ?f u) ?t => exact (C t)
  | C : forall p t, continuous (?f p) t |- continuous (fun u => ?f ?p u) ?t => exact (C p t)
  | S : sums ?m |- continuous (fun u => total ?m ?f u) _ => apply (total_steady S f); intro; intro
  | |- _ => eapply C_der; solve [differ]
  end; cbv beta).

(* Formulas below sums, rates and works, one after the other. *)
Ltac derived := match goal with
  | |- context [Derive ?f] =>
    let H := constr:(ltac:(intros ?; eexists; differ) : forall t, {d | is_derive f t d}) in
    let g := eval lazy beta iota delta [proj1_sig] in (fun t => proj1_sig (H t)) in
    rewrite (rates f g (fun t => proj2_sig (H t)))
  | |- context [@rate ?particle ?f] =>
    let H := constr:(ltac:(intros ? ?; eexists; cbv beta; differ) : forall (p : particle) t, {d | is_derive (fun u => f p u) t d}) in
    let g := eval lazy beta iota delta [proj1_sig] in (fun p t => proj1_sig (H p t)) in
    rewrite (rates_of particle f g (fun p t => proj2_sig (H p t)))
  end; cbv beta.
Ltac formed m f g := replace (total m f) with (total m g) by
  (apply f_equal; do 2 (apply functional_extensionality; intro); cbv beta; field).
Ltac spread S := match goal with |- context [@total ?particle ?m ?f] => lazymatch f with
  | fun p t => 1 => fail
  | fun p t => @?c t => formed m f (fun (p : particle) t => c t * 1); rewrite (total_times S c (fun p t => 1))
  | fun p t => @?a p t + @?b p t => rewrite (total_plus S a b)
  | fun p t => - @?a p t => formed m f (fun p t => (-1) * a p t)
  | fun p t => @?a p t ^ 2 => formed m f (fun p t => a p t * a p t)
  | fun p t => RInt (fun u => @?g p u) 0 t => rewrite (total_works S g) by (intro; remain)
  | fun p t => @?c t * @?a p t => rewrite (total_times S c a)
  | fun p t => @?a p t * @?c t => formed m f (fun p t => c t * a p t)
  | fun p t => (@?a p t + @?b p t) * @?c p t => formed m f (fun p t => a p t * c p t + b p t * c p t)
  | fun p t => @?c p t * (@?a p t + @?b p t) => formed m f (fun p t => c p t * a p t + c p t * b p t)
  | fun p t => (- @?a p t) * @?c p t => formed m f (fun p t => (-1) * (a p t * c p t))
  | fun p t => @?c p t * (- @?a p t) => formed m f (fun p t => (-1) * (c p t * a p t))
  | fun p t => (@?k t * @?a p t) * @?c p t => formed m f (fun p t => k t * (a p t * c p t))
  | fun p t => @?c p t * (@?k t * @?a p t) => formed m f (fun p t => k t * (c p t * a p t))
  | fun p t => @?a p t * @?b p t => let g := eval cbv beta in (fun p t => b p t * a p t) in
    tryif constr_eq f g then fail else match goal with |- context [total m g] => formed m f g end
  end end; cbv beta.

(* What a letter or a sum is, put in its place everywhere. *)
Ltac put E := try rewrite E in *; clear E; cbv beta in *.
Ltac letters := repeat match goal with
  | H : forall t, ?L t = @?e t |- _ => is_var L; lazymatch e with context [L] => fail | _ => idtac end;
    let E := fresh in assert (E : L = e) by (apply functional_extensionality; exact H); clear H; put E
  | H : forall p t, ?L p t = @?e p t |- _ => is_var L; lazymatch e with context [L] => fail | _ => idtac end;
    let E := fresh in assert (E : L = e) by (do 2 (apply functional_extensionality; intro); apply H); clear H; put E
  | H : R -> ?L = ?e |- _ => is_var L; lazymatch e with context [L] => fail | _ => idtac end;
    let E := fresh in pose proof (H 0) as E; clear H; put E
  end.
Ltac oriented := repeat match goal with
  | H : forall t, @?c t = @?s t |- _ => lazymatch c with context [total] => fail | _ => idtac end;
    lazymatch s with context [total] => idtac end; let E := fresh in assert (E : forall t, s t = c t)
      by (let u := fresh in intro u; symmetry; apply H); clear H; cbv beta in E
  | H : forall t, total ?m ?f t = @?e t |- _ => lazymatch e with context [total] => fail | _ => idtac end;
    let E := fresh in assert (E : total m f = e) by (apply functional_extensionality; exact H); clear H; put E
  | H : forall t, total ?m ?f t + @?e t = @?c t |- _ => lazymatch constr:((e, c)) with context [f] => fail | _ => idtac end;
    let E := fresh in assert (E : total m f = fun t => c t + - e t)
      by (apply functional_extensionality; let u := fresh in intro u; pose proof (H u); cbv beta; lra); clear H; put E
  | H : forall t, ?L t + @?e t = @?c t |- _ => is_var L; lazymatch constr:((e, c)) with context [L] => fail | _ => idtac end;
    let E := fresh in assert (E : L = fun t => c t + - e t)
      by (apply functional_extensionality; let u := fresh in intro u; pose proof (H u); cbv beta; lra); clear H; put E
  end.
Ltac equations := repeat match goal with H : forall t : R, _ = _ |- _ => revert H end.
Ltac instance H := pose proof (H 0); match goal with t : R |- _ => pose proof (H t) end; clear H.
Ltac linear := rewrite ?RInt_none in *; cbn [INR pred] in *; lra.
Ltac closed := rewrite ?RInt_none; cbn [INR pred]; first [field | lra
  | match goal with H : forall t : R, _ = _ |- _ = _ => solve [instance H; linear] end
  | repeat match goal with H : forall t : R, _ = _ |- _ = _ => instance H end; linear].
Ltac alike := match goal with |- forall t, @?f t = @?g t =>
    let F := constr:(ltac:(intros ?; eexists; cbv beta; differ) : forall t, {d | is_derive (fun u => f u) t d}) in
    let G := constr:(ltac:(intros ?; eexists; cbv beta; differ) : forall t, {d | is_derive (fun u => g u) t d}) in
    let d := eval lazy beta iota delta [proj1_sig] in (fun t => proj1_sig (F t)) in
    let e := eval lazy beta iota delta [proj1_sig] in (fun t => proj1_sig (G t)) in
    apply (same_rates f g d e (fun t => proj2_sig (F t)) (fun t => proj2_sig (G t))); cbv beta; intros; closed
  end.
Ltac theory := intros; unfold motion, turns in *; repeat match goal with H : _ /\ _ |- _ => destruct H end;
  do 3 (letters; equations; repeat first [derived | match goal with S : sums _ |- _ => spread S end]; intros; oriented);
  first [solve [closed] | match goal with t : R |- _ => revert t end; first [alike
    | match goal with |- forall t, sqrt (@?f t) = sqrt ?c =>
        cut (forall t, f t = c); [let E := fresh in let u := fresh in intros E u; exact (f_equal sqrt (E u)) | cbv beta; alike] end]].

(* Constant distances of the particles are enough for it that all turn alike. *)
Lemma constant_rate : forall (f : R -> R) (c t d : R), (forall u, f u = c) -> is_derive f t d -> d = 0.
Proof.
  intros f c t d E D. apply (alone f t); [exact D |].
  apply (is_derive_ext (fun _ => c)); [intro; symmetry; apply E | apply D_const].
Qed.
Theorem all_turn_alike : forall (particle : Type) (x y v u : particle -> R -> R) (apart : particle -> particle -> R)
  (p q : particle), (forall i, moves (x i) (v i)) -> (forall i, moves (y i) (u i)) ->
  (forall i j t, (x i t + - x j t) ^ 2 + (y i t + - y j t) ^ 2 = apart i j) -> 0 < apart q p ->
  exists w : R -> R, forall i t,
    v i t + - v p t = - (w t * (y i t + - y p t)) /\ u i t + - u p t = w t * (x i t + - x p t).
Proof.
  intros particle x y v u apart p q Dx Dy A P.
  exists (fun t => ((x q t + - x p t) * (u q t + - u p t) + - ((y q t + - y p t) * (v q t + - v p t))) / apart q p).
  intros i t.
  assert (F : forall i j, (x i t + - x j t) * (v i t + - v j t) + (y i t + - y j t) * (u i t + - u j t) = 0).
  { intros k j.
    assert (2 * ((x k t + - x j t) * (v k t + - v j t) + (y k t + - y j t) * (u k t + - u j t)) = 0); [| lra].
    apply (constant_rate _ _ t _ (A k j)). eapply D_eq; [differ |]; cbn [INR pred]; ring. }
  pose (B := fun s => (x q s + - x p s) * (y i s + - y p s) + - ((y q s + - y p s) * (x i s + - x p s))).
  pose (c := apart i p * apart q p - ((apart q p + apart i p - apart i q) / 2) ^ 2).
  assert (C : forall s, B s ^ 2 = c) by (intro s; unfold B, c; rewrite <- (A i p s), <- (A q p s), <- (A i q s); field).
  assert (D : forall s, is_derive B s ((v q s + - v p s) * (y i s + - y p s) + (x q s + - x p s) * (u i s + - u p s)
    + - ((u q s + - u p s) * (x i s + - x p s) + (y q s + - y p s) * (v i s + - v p s)))) by (intro s; unfold B; differ).
  assert (Z : (v q t + - v p t) * (y i t + - y p t) + (x q t + - x p t) * (u i t + - u p t)
    + - ((u q t + - u p t) * (x i t + - x p t) + (y q t + - y p t) * (v i t + - v p t)) = 0).
  { destruct (Req_dec (B t) 0) as [N | N].
    - apply (constant_rate B 0 t); [| apply D]. intro s. apply Rsqr_0_uniq. unfold Rsqr.
      pose proof (C s). pose proof (C t). rewrite N in *. nra.
    - pose proof (constant_rate (fun s => B s ^ 2) c t _ C (D_pow B 2 t _ (D t))) as E. cbn [INR pred] in E.
      apply (Rmult_eq_reg_r (B t)); [lra | exact N]. }
  pose proof (F q p) as Q. pose proof (F i p) as I. pose proof (F i q) as J. pose proof (A q p t) as G.
  clear - P Q I J G Z. revert P Q I J G Z. generalize (apart q p). intros d P Q I J G Z.
  replace (x i t + - x q t) with (x i t + - x p t - (x q t + - x p t)) in J by ring.
  replace (y i t + - y q t) with (y i t + - y p t - (y q t + - y p t)) in J by ring.
  replace (v i t + - v q t) with (v i t + - v p t - (v q t + - v p t)) in J by ring.
  replace (u i t + - u q t) with (u i t + - u p t - (u q t + - u p t)) in J by ring.
  revert Q I J G Z. generalize (x q t + - x p t) (y q t + - y p t) (v q t + - v p t) (u q t + - u p t).
  generalize (x i t + - x p t) (y i t + - y p t) (v i t + - v p t) (u i t + - u p t). intros X Y V U ex ey eu ev Q I J G Z.
  assert (K : X * eu + Y * ev + ex * V + ey * U = 0) by lra.
  split; apply (Rmult_eq_reg_r d); try lra.
  - apply Rminus_diag_uniq. transitivity (ex * (X * eu + Y * ev + ex * V + ey * U)
      - ey * (eu * Y + ex * U + - (ev * X + ey * V)) - X * (ex * eu + ey * ev));
      [rewrite <- G; field; rewrite G | rewrite K, Z, Q]; lra.
  - apply Rminus_diag_uniq. transitivity (ey * (X * eu + Y * ev + ex * V + ey * U)
      + ex * (eu * Y + ex * U + - (ev * X + ey * V)) - Y * (ex * eu + ey * ev));
      [rewrite <- G; field; rewrite G | rewrite K, Z, Q]; lra.
Qed.
