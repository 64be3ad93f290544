(* What the written files stand on: derivatives by syntax, equality by rates, integrals, positivity. *)
Require Export Reals Lra Psatz.
From Coquelicot Require Export Coquelicot.
Open Scope R_scope.

(* Derivatives, dispatched on syntax; the rate of a letter is a hypothesis. *)
Lemma D_eq : forall (f : R -> R) (t d e : R), is_derive f t e -> e = d -> is_derive f t d.
Proof. intros; subst; assumption. Qed.
Lemma D_const : forall c t : R, is_derive (fun _ => c) t 0.
Proof. intros; apply @is_derive_const. Qed.
Lemma D_id : forall t : R, is_derive (fun u => u) t 1.
Proof. intros; apply @is_derive_id. Qed.
Lemma D_plus : forall (f g : R -> R) (t a b : R),
  is_derive f t a -> is_derive g t b -> is_derive (fun u => f u + g u) t (a + b).
Proof. intros; apply @is_derive_plus; assumption. Qed.
Lemma D_minus : forall (f g : R -> R) (t a b : R),
  is_derive f t a -> is_derive g t b -> is_derive (fun u => f u - g u) t (a - b).
Proof. intros; apply @is_derive_minus; assumption. Qed.
Lemma D_opp : forall (f : R -> R) (t a : R), is_derive f t a -> is_derive (fun u => - f u) t (- a).
Proof. intros; apply @is_derive_opp; assumption. Qed.
Lemma D_mult : forall (f g : R -> R) (t a b : R),
  is_derive f t a -> is_derive g t b -> is_derive (fun u => f u * g u) t (a * g t + f t * b).
Proof. intros; apply @is_derive_mult; [assumption | assumption | intros; apply Rmult_comm]. Qed.
Lemma D_div : forall (f : R -> R) (c t a : R), is_derive f t a -> is_derive (fun u => f u / c) t (a / c).
Proof.
  intros. unfold Rdiv. apply D_eq with (a * / c + f t * 0); [| ring].
  apply (D_mult f (fun _ => / c)); [assumption | apply D_const].
Qed.
Lemma D_pow : forall (f : R -> R) (n : nat) (t a : R),
  is_derive f t a -> is_derive (fun u => f u ^ n) t (INR n * a * f t ^ pred n).
Proof. intros; apply is_derive_pow; assumption. Qed.
Lemma D_sin : forall (f : R -> R) (t a : R), is_derive f t a -> is_derive (fun u => sin (f u)) t (a * cos (f t)).
Proof. intros. apply (is_derive_comp sin f); [apply is_derive_sin | assumption]. Qed.
Lemma D_cos : forall (f : R -> R) (t a : R), is_derive f t a -> is_derive (fun u => cos (f u)) t (a * - sin (f t)).
Proof. intros. apply (is_derive_comp cos f); [apply is_derive_cos | assumption]. Qed.
Lemma D_quot : forall (f g : R -> R) (t a b : R), is_derive f t a -> is_derive g t b -> g t <> 0 ->
  is_derive (fun u => f u / g u) t ((a * g t - f t * b) / g t ^ 2).
Proof. intros. apply (is_derive_div f g); assumption. Qed.
Lemma D_inv : forall (g : R -> R) (t b : R), is_derive g t b -> g t <> 0 -> is_derive (fun u => / g u) t (- b / g t ^ 2).
Proof. intros. apply (is_derive_inv g); assumption. Qed.
Lemma D_sqrt : forall (f : R -> R) (t a : R), is_derive f t a -> 0 < f t ->
  is_derive (fun u => sqrt (f u)) t (a * / (2 * sqrt (f t))).
Proof.
  intros f t a H P. apply (is_derive_comp sqrt f); [| assumption].
  apply is_derive_Reals, derivable_pt_lim_sqrt; assumption.
Qed.
Lemma D_exp : forall (f : R -> R) (t a : R), is_derive f t a -> is_derive (fun u => exp (f u)) t (a * exp (f t)).
Proof. intros. apply (is_derive_comp exp f); [apply is_derive_exp | assumption]. Qed.
Lemma D_ln : forall (f : R -> R) (t a : R), is_derive f t a -> 0 < f t -> is_derive (fun u => ln (f u)) t (a * / f t).
Proof. intros. apply (is_derive_comp ln f); [apply is_derive_ln; assumption | assumption]. Qed.

(* Continuity. *)
Lemma C_der : forall (f : R -> R) (t d : R), is_derive f t d -> continuous f t.
Proof. intros. apply @ex_derive_continuous. exists d; assumption. Qed.
Lemma C_plus : forall (f g : R -> R) t, continuous f t -> continuous g t -> continuous (fun u => f u + g u) t.
Proof. intros; apply @continuous_plus; assumption. Qed.
Lemma C_minus : forall (f g : R -> R) t, continuous f t -> continuous g t -> continuous (fun u => f u - g u) t.
Proof. intros; apply @continuous_minus; assumption. Qed.
Lemma C_opp : forall (f : R -> R) t, continuous f t -> continuous (fun u => - f u) t.
Proof. intros; apply @continuous_opp; assumption. Qed.
Lemma C_mult : forall (f g : R -> R) t, continuous f t -> continuous g t -> continuous (fun u => f u * g u) t.
Proof. intros; apply @continuous_mult; assumption. Qed.
Lemma C_div : forall (f : R -> R) c t, continuous f t -> continuous (fun u => f u / c) t.
Proof. intros; unfold Rdiv; apply C_mult; [assumption | apply continuous_const]. Qed.
Lemma C_quot : forall (f g : R -> R) t, continuous f t -> continuous g t -> g t <> 0 -> continuous (fun u => f u / g u) t.
Proof. intros; unfold Rdiv; apply C_mult; [assumption | apply continuous_Rinv_comp; assumption]. Qed.
Lemma C_pow : forall (f : R -> R) n t, continuous f t -> continuous (fun u => f u ^ n) t.
Proof.
  intros f n t H. induction n; [apply continuous_const | apply (C_mult f (fun u => f u ^ n)); assumption].
Qed.
Lemma C_sin : forall (f : R -> R) t, continuous f t -> continuous (fun u => sin (f u)) t.
Proof. intros; apply (continuous_comp f sin); [assumption | apply (C_der sin _ (cos (f t))), is_derive_sin]. Qed.
Lemma C_cos : forall (f : R -> R) t, continuous f t -> continuous (fun u => cos (f u)) t.
Proof. intros; apply (continuous_comp f cos); [assumption | apply (C_der cos _ (- sin (f t))), is_derive_cos]. Qed.
Lemma C_exp : forall (f : R -> R) t, continuous f t -> continuous (fun u => exp (f u)) t.
Proof. intros; apply (continuous_comp f exp); [assumption | apply (C_der exp _ (exp (f t))), is_derive_exp]. Qed.
(* Integrals: along time from the start, along a coordinate, between two numbers. *)
Lemma rate_time : forall (a b : R) (g : R -> R) (t : R), a < 0 < b -> a < t < b ->
  (forall u, a < u < b -> continuous g u) -> is_derive (fun t => RInt g 0 t) t (g t).
Proof.
  intros a b g t H0 Ht C. apply (@is_derive_RInt R_NormedModule g (fun t => RInt g 0 t) 0 t); [| auto].
  assert (P : 0 < Rmin (t - a) (b - t)) by (apply Rmin_glb_lt; lra).
  exists (mkposreal _ P). intros y Hy.
  apply (RInt_correct (V:=R_CompleteNormedModule) g 0 y), (ex_RInt_continuous (V:=R_CompleteNormedModule) g).
  intros z Hz. apply C.
  unfold ball in Hy; simpl in Hy; unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
  apply Rabs_lt_between in Hy.
  assert (Rmin (t - a) (b - t) <= t - a) by apply Rmin_l.
  assert (Rmin (t - a) (b - t) <= b - t) by apply Rmin_r.
  destruct Hz as [Z1 Z2]. split.
  - apply Rlt_le_trans with (2 := Z1). apply Rmin_glb_lt; lra.
  - apply Rle_lt_trans with (1 := Z2). apply Rmax_lub_lt; lra.
Qed.
Lemma rate_path : forall (f q : R -> R) (c t v : R), is_derive q t v -> (forall x : R, continuous f x) ->
  is_derive (fun t => RInt f c (q t)) t (v * f (q t)).
Proof.
  intros f q c t v Hq C. apply (is_derive_comp (fun x => RInt f c x) q); [| assumption].
  apply (@is_derive_RInt R_NormedModule f (fun x => RInt f c x) c); [| auto].
  exists (mkposreal 1 Rlt_0_1). intros y _.
  apply (RInt_correct (V:=R_CompleteNormedModule) f c y), (ex_RInt_continuous (V:=R_CompleteNormedModule) f). auto.
Qed.
Lemma RInt_by : forall (F f : R -> R) (a b v : R),
  (forall x : R, is_derive F x (f x)) -> (forall x : R, continuous f x) -> F b - F a = v -> RInt f a b = v.
Proof.
  intros F f a b v D C E. rewrite <- E. apply is_RInt_unique.
  apply (@is_RInt_derive R_CompleteNormedModule F f); auto.
Qed.
Lemma RInt_on : forall (g f : R -> R) (a b v : R), (forall x, f x = g x) -> RInt g a b = v -> RInt f a b = v.
Proof. intros g f a b v E G. rewrite <- G. apply RInt_ext. intros; apply E. Qed.
Lemma RInt_in : forall (g f : R -> R) (a b v : R),
  (forall x, Rmin a b < x < Rmax a b -> f x = g x) -> RInt g a b = v -> RInt f a b = v.
Proof. intros g f a b v E G. rewrite <- G. apply RInt_ext. exact E. Qed.
Lemma RInt_none : forall (f : R -> R) (a : R), RInt f a a = 0.
Proof. intros. rewrite RInt_point. reflexivity. Qed.
(* What does not change, and what vanishes on an interval, has the rate 0; and the other way round. *)
Lemma flat : forall (a b : R) (f : R -> R), a < 0 < b ->
  (forall t, a < t < b -> is_derive f t 0) -> f 0 = 0 -> forall t, a < t < b -> f t = 0.
Proof.
  intros a b f H0 D E t Ht. rewrite <- E. destruct (Rtotal_order t 0) as [L | [L | L]].
  - apply (eq_is_derive f t 0); [intros; apply D; lra | assumption].
  - rewrite L; reflexivity.
  - symmetry. apply (eq_is_derive f 0 t); [intros; apply D; lra | assumption].
Qed.
Lemma alike : forall (a b : R) (f g : R -> R) (t d : R),
  (forall u, a < u < b -> f u = g u) -> a < t < b -> is_derive g t d -> is_derive f t d.
Proof.
  intros a b f g t d E Ht. apply is_derive_ext_loc.
  assert (P : 0 < Rmin (t - a) (b - t)) by (apply Rmin_glb_lt; lra).
  exists (mkposreal _ P). intros y Hy. symmetry. apply E.
  unfold ball in Hy; simpl in Hy; unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
  apply Rabs_lt_between in Hy.
  assert (Rmin (t - a) (b - t) <= t - a) by apply Rmin_l.
  assert (Rmin (t - a) (b - t) <= b - t) by apply Rmin_r.
  lra.
Qed.
Lemma still : forall (a b : R) (f : R -> R) (t d : R),
  (forall u, a < u < b -> f u = 0) -> a < t < b -> is_derive f t d -> d = 0.
Proof.
  intros a b f t d E Ht D. rewrite <- (is_derive_unique _ _ _ D). apply is_derive_unique.
  apply (alike a b f (fun _ => 0) t 0 E Ht), D_const.
Qed.

Lemma alone : forall (f : R -> R) (t a b : R), is_derive f t a -> is_derive f t b -> a = b.
Proof. intros f t a b A B. rewrite <- (is_derive_unique _ _ _ A). apply is_derive_unique, B. Qed.

(* An integrand with even powers of roots, between the ends. *)
Lemma root2 : forall x, 0 <= x -> sqrt x ^ 2 = x.
Proof. intros x H. simpl. rewrite Rmult_1_r. apply sqrt_sqrt, H. Qed.
Lemma root4 : forall x, 0 <= x -> sqrt x ^ 4 = x ^ 2.
Proof. intros x H. replace (sqrt x ^ 4) with ((sqrt x ^ 2) ^ 2) by ring. rewrite root2; auto. Qed.
Ltac between := let x := fresh in let H := fresh in intros x H;
  first [rewrite Rmin_left, Rmax_right in H by lra | rewrite Rmin_right, Rmax_left in H by lra];
  rewrite ?root2, ?root4 by nra.

(* Algebra: an equation less multiples of known ones. *)
Lemma trig : forall x, sin x ^ 2 + cos x ^ 2 = 1.
Proof. intros x. assert (H := sin2_cos2 x). unfold Rsqr in H. simpl. lra. Qed.
Lemma sin_of : forall a b c, a = b + c -> sin a = sin b * cos c + cos b * sin c. Proof. intros; subst; apply sin_plus. Qed.
Lemma cos_of : forall a b c, a = b + c -> cos a = cos b * cos c + - (sin b * sin c). Proof. intros; subst; apply cos_plus. Qed.
Lemma sin_off : forall a b c, a = b - c -> sin a = sin b * cos c + - (cos b * sin c). Proof. intros; subst; apply sin_minus. Qed.
Lemma cos_off : forall a b c, a = b - c -> cos a = cos b * cos c + sin b * sin c. Proof. intros; subst; apply cos_minus. Qed.
Lemma lin0 : forall l r, l - r = 0 -> l = r.
Proof. intros; lra. Qed.
Lemma less : forall (c a b : R), a = b -> forall g, g - c * (a - b) = 0 -> g = 0.
Proof. intros; subst; lra. Qed.
Lemma cancel : forall k l r, k <> 0 -> k * (l - r) = 0 -> l = r.
Proof. intros k l r K E. apply Rmult_integral in E. destruct E; [contradiction | lra]. Qed.
Lemma above : forall l r s n, l - r = s + n -> 0 < s -> 0 <= n -> r < l.
Proof. intros; lra. Qed.
Lemma at_least : forall l r s n, l - r = s + n -> 0 <= s -> 0 <= n -> r <= l.
Proof. intros; lra. Qed.
Lemma beyond : forall d s n, d = s + n -> 0 < s -> 0 <= n -> d <> 0.
Proof. intros; lra. Qed.
Lemma below : forall d s n, - d = s + n -> 0 < s -> 0 <= n -> d <> 0.
Proof. intros; lra. Qed.
Lemma divisor : forall w q d, w <> 0 -> w - q * d = 0 -> d <> 0.
Proof. intros w q d W E Z. apply W. rewrite Z in E. lra. Qed.
Lemma root_is : forall a x, 0 <= x -> x ^ 2 = a -> sqrt a = x.
Proof. intros a x H E. rewrite <- E. apply sqrt_pow2, H. Qed.
Lemma over : forall a, 0 <= a -> a <> 0 -> 0 < a.
Proof. intros. lra. Qed.
Lemma root_nonzero : forall a, 0 <= a -> a <> 0 -> sqrt a <> 0.
Proof. intros a P N Q. apply N, sqrt_eq_0; assumption. Qed.
Lemma up1 : forall x, 0 <= 1 + cos x. Proof. intros x. pose proof (COS_bound x). lra. Qed.
Lemma up2 : forall x, 0 <= 1 + - cos x. Proof. intros x. pose proof (COS_bound x). lra. Qed.
Lemma up3 : forall x, 0 <= 1 + sin x. Proof. intros x. pose proof (SIN_bound x). lra. Qed.
Lemma up4 : forall x, 0 <= 1 + - sin x. Proof. intros x. pose proof (SIN_bound x). lra. Qed.
Ltac known_sign := match goal with
  | Q : forall t, ?a < t < ?b -> 0 < _, H : ?a < ?s < ?b |- 0 < _ => exact (Q s H)
  | Q : forall t, ?a < t < ?b -> 0 < t -> 0 < _, H : ?a < ?s < ?b, G : 0 < ?s |- 0 < _ => exact (Q s H G)
  end.
Ltac pos1 := first [assumption | known_sign | lra | solve [progress rewrite ?sin_0, ?cos_0; nra] | apply PI_RGT_0
  | apply Rplus_lt_0_compat | apply Rmult_lt_0_compat | apply Rdiv_lt_0_compat | apply pow_lt | apply Rinv_0_lt_compat
  | apply sqrt_lt_R0 | apply exp_pos].
Ltac least := first [exact (Rlt_le _ _ PI_RGT_0) | apply up1 | apply up2 | apply up3 | apply up4
  | apply pow2_ge_0 | apply sqrt_pos | apply Rplus_le_le_0_compat | apply Rmult_le_pos | apply Rdiv_le_0_compat; [| solve [repeat pos1]] | apply pow_le | lra | (apply Rlt_le; solve [repeat pos1])].
Ltac signs := repeat match goal with
  | Q : forall x : R, 0 < _ |- context [cos ?y] => let N := fresh in pose proof (Q y) as N; cbv beta in N; clear Q
  | Q : forall x : R, 0 < _ |- context [sin ?y] => let N := fresh in pose proof (Q y) as N; cbv beta in N; clear Q
  end; repeat match goal with Q : forall t, ?a < t < ?b -> 0 < _, H : ?a < ?s < ?b |- _ =>
  let N := fresh in pose proof (Q s H) as N; cbv beta in N; clear Q end.
Ltac nng := first [solve [repeat least] | signs; solve [repeat first [lra | least]]].
Ltac ang_in N := rewrite ?sin_minus, ?cos_minus, ?sin_plus, ?cos_plus, ?sin_neg, ?cos_neg, ?sin_2a, ?cos_2a in N.
(* An identity of polynomials: by the reader of lra, which is ten times as fast as that of ring. *)
Ltac poly := clear; lra.
Ltac same_nonzero x N := match type of N with ?d <> 0 =>
  first [exact N | solve [replace x with d by poly; exact N]
    | solve [replace x with (- d) by poly; apply Ropp_neq_0_compat; exact N]] end.
Ltac met N := repeat match type of N with ?P -> _ => match goal with G : P |- _ => specialize (N G) end end.
Ltac as_known x Q s H :=
  let N := fresh in pose proof (Q s H) as N; met N; cbv beta in N; first [same_nonzero x N | ang_in N; same_nonzero x N].
Ltac known_nonzero x := match goal with
  | Q : forall t, ?a < t < ?b -> _ <> 0, H : ?a < ?s < ?b |- _ => as_known x Q s H
  | Q : forall t, ?a < t < ?b -> _ -> _ <> 0, H : ?a < ?s < ?b |- _ => as_known x Q s H
  | Q : forall t, ?a < t < ?b -> _ -> _ -> _ <> 0, H : ?a < ?s < ?b |- _ => as_known x Q s H
  end.
Ltac nonzero := match goal with
  | |- PI <> 0 => exact PI_neq0
  | N : sqrt ?a <> 0 |- sqrt ?b <> 0 => let M := fresh in pose proof N as M; ang_in M;
    match type of M with sqrt ?c <> 0 => replace (sqrt b) with (sqrt c) by (f_equal; poly); exact M end
  | |- sqrt _ <> 0 => apply root_nonzero; [first [nng | nra] | nonzero]
  | |- ?x <> 0 => known_nonzero x
  | |- ?x <> 0 => apply Rgt_not_eq; unfold Rgt; solve [repeat pos1]
  | |- - _ <> 0 => apply Ropp_neq_0_compat; nonzero
  | |- _ * _ <> 0 => apply Rmult_integral_contrapositive_currified; nonzero
  | |- _ ^ _ <> 0 => apply pow_nonzero; nonzero
  | |- _ + _ <> 0 => apply Rgt_not_eq; unfold Rgt; first
    [apply Rplus_lt_le_0_compat; [solve [repeat pos1] | solve [nng]] | signs; nra]
  end.
Lemma asin_gt_0 : forall x, 0 < x -> 0 < asin x.
Proof.
  intros x P. destruct (Rle_dec 1 x) as [L | L].
  - unfold asin. destruct (Rle_dec x (-1)); [lra |]. destruct (Rle_dec 1 x); [pose proof PI_RGT_0 |]; lra.
  - rewrite asin_atan, <- atan_0 by lra. apply atan_increasing, Rdiv_lt_0_compat; [lra |].
    apply sqrt_lt_R0. unfold Rsqr. nra.
Qed.
(* π and the root of a number between numbers. *)
Ltac constant := first [pose proof PI2_3_2; lra
  | match goal with |- context [sqrt ?n] => pose proof (sqrt_pos n); pose proof (root2 n ltac:(lra)); nra end].
Ltac ends := try match goal with _ : asin ?x < _ |- _ => assert (0 < asin x) by (apply asin_gt_0; solve [repeat pos1]) end; lra.
Ltac over0 := first [solve [repeat pos1] | apply over; [nng | nonzero]].
Ltac pos := repeat split; try assumption; match goal with
  | |- _ <> 0 => nonzero
  | |- _ => first [solve [repeat pos1] | signs; solve [repeat pos1] | signs; nra]
  end.
Lemma part_of : forall a b, 0 < b -> - b <= a <= b -> -1 <= a / b <= 1.
Proof. intros a b P H. split; apply Rmult_le_reg_r with b; trivial; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. Qed.
Lemma inside : forall x, 0 < 1 + - x ^ 2 -> -1 <= x <= 1.
Proof. intros x P. nra. Qed.
Ltac inside_known := match goal with W : forall t, ?a < t < ?b -> 0 < 1 + - ?x ^ 2, H : ?a < ?s < ?b |- -1 <= ?y <= 1 =>
  first [constr_eq x y | replace y with x by (first [poly | field; pos])]; exact (inside x (W s H)) end.
Ltac within := first [lra | inside_known | apply part_of; [solve [repeat pos1] | split; nra]].
Lemma sin_5PI6 : sin (5 * PI / 6) = 1 / 2.
Proof. replace (5 * PI / 6) with (PI - PI / 6) by field. rewrite sin_minus, sin_PI, cos_PI, sin_PI6. field. Qed.
Lemma cos_5PI6 : cos (5 * PI / 6) = - (sqrt 3 / 2).
Proof. replace (5 * PI / 6) with (PI - PI / 6) by field. rewrite cos_minus, sin_PI, cos_PI, cos_PI6. field. Qed.
Ltac ang := rewrite ?Rmult_0_l, ?Rmult_0_r, ?Ropp_0, ?sin_minus, ?cos_minus, ?sin_plus, ?cos_plus, ?sin_neg, ?cos_neg, ?sin_PI2, ?cos_PI2,
  ?sin_PI, ?cos_PI, ?sin_PI6, ?cos_PI6, ?sin_5PI6, ?cos_5PI6, ?sin_0, ?cos_0, ?sin_2a, ?cos_2a, ?sin_atan, ?cos_atan, ?exp_0, ?ln_1;
  rewrite ?cos_acos, ?sin_acos, ?sin_asin, ?cos_asin by within; unfold Rsqr.
Ltac is_quotient := match goal with
  | |- context [_ / ?d] => lazymatch d with IZR _ => fail | _ => idtac end
  | |- context [/ ?d] => lazymatch d with IZR _ => fail | _ => idtac end
  end.
Ltac rational := first [poly | is_quotient; solve [field; pos]].
Ltac one_root := match goal with
  | |- context [sqrt ?a] => match goal with
    | |- context [sqrt ?b] => tryif constr_eq a b then fail else
        replace (sqrt b) with (sqrt a) by (f_equal; first [rational | ang; rational]) end end.
Ltac one_angle := match goal with
  | |- context [sin ?a] => match goal with
    | |- context [sin ?b] => tryif constr_eq a b then fail else replace (sin b) with (sin a) by (f_equal; rational)
    end
  | |- context [cos ?a] => match goal with
    | |- context [cos ?b] => tryif constr_eq a b then fail else replace (cos b) with (cos a) by (f_equal; rational)
    end
  | |- context [exp ?a] => match goal with
    | |- context [exp ?b] => tryif constr_eq a b then fail else replace (exp b) with (exp a) by (f_equal; rational)
    end
  end.
Ltac one_inverse := match goal with
  | |- context [atan ?a] => match goal with
    | |- context [atan ?b] => tryif constr_eq a b then fail else replace (atan b) with (atan a) by (f_equal; rational) end
  | |- context [acos ?a] => match goal with
    | |- context [acos ?b] => tryif constr_eq a b then fail else replace (acos b) with (acos a) by (f_equal; rational) end
  | |- context [asin ?a] => match goal with
    | |- context [asin ?b] => tryif constr_eq a b then fail else replace (asin b) with (asin a) by (f_equal; rational) end
  end.
Ltac fld := cbn [INR pred]; first [rational | ang; rational | repeat one_root; rational
  | repeat one_angle; first [rational | ang; repeat one_angle; rational] | solve [field; pos]
  | repeat one_inverse; ang; repeat one_root; rational].

(* A solution of a linear system with continuous coefficients that is 0 at the start is 0. *)
Lemma falls : forall (a b : R) (h dh : R -> R), a <= b -> (forall t, a <= t <= b -> is_derive h t (dh t)) ->
  (forall t, a <= t <= b -> dh t <= 0) -> h b <= h a.
Proof.
  intros a b h dh L D N. destruct (MVT_gen h a b dh) as [c [Hc E]];
    rewrite ?Rmin_left, ?Rmax_right in * by lra.
  - intros x Hx. apply D. lra.
  - intros x Hx. apply continuity_pt_filterlim, (C_der h x (dh x)), D. lra.
  - specialize (N c Hc). nra.
Qed.
Lemma only_one : forall (a b : R) (f g p q r s : R -> R), a < 0 < b ->
  (forall t, a < t < b -> is_derive f t (p t * f t + q t * g t)) ->
  (forall t, a < t < b -> is_derive g t (r t * f t + s t * g t)) ->
  (forall t, a < t < b -> continuous p t) -> (forall t, a < t < b -> continuous q t) ->
  (forall t, a < t < b -> continuous r t) -> (forall t, a < t < b -> continuous s t) ->
  f 0 = 0 -> g 0 = 0 -> forall t, a < t < b -> f t = 0.
Proof.
  intros a b f g p q r s H0 Df Dg Cp Cq Cr Cs Zf Zg t Ht.
  pose (K := fun u => 3 + (p u ^ 2 + q u ^ 2 + (r u ^ 2 + s u ^ 2))).
  pose (A := fun u => RInt K 0 u).
  assert (DA : forall u, a < u < b -> is_derive A u (K u)).
  { intros u Hu. apply (rate_time a b K u H0 Hu). intros v Hv. unfold K.
    apply C_plus; [apply continuous_const |].
    apply (C_plus (fun u => p u ^ 2 + q u ^ 2)); apply C_plus; apply C_pow; auto. }
  assert (DE : forall u, a < u < b -> is_derive (fun u => f u ^ 2 + g u ^ 2) u
    (2 * (p u * f u + q u * g u) * f u + 2 * (r u * f u + s u * g u) * g u)).
  { intros u Hu. eapply D_eq; [apply D_plus; apply D_pow; [apply Df | apply Dg]; exact Hu | simpl; ring]. }
  assert (B : forall u, let e := 2 * (p u * f u + q u * g u) * f u + 2 * (r u * f u + s u * g u) * g u in
    0 <= K u * (f u ^ 2 + g u ^ 2) + e /\ 0 <= K u * (f u ^ 2 + g u ^ 2) - e).
  { intros u. unfold K. cbv zeta. generalize (p u) (q u) (r u) (s u) (f u) (g u). clear. intros p q r s f g. split.
    - replace (_ + _) with ((f^2 + g^2) + (1 + p) ^ 2 * f ^ 2 + p ^ 2 * g ^ 2 + (1 + s) ^ 2 * g ^ 2 + s ^ 2 * f ^ 2
        + (q * g + f) ^ 2 + (r * f + g) ^ 2 + q ^ 2 * f ^ 2 + r ^ 2 * g ^ 2) by ring. nng.
    - replace (_ - _) with ((f^2 + g^2) + (1 - p) ^ 2 * f ^ 2 + p ^ 2 * g ^ 2 + (1 - s) ^ 2 * g ^ 2 + s ^ 2 * f ^ 2
        + (q * g - f) ^ 2 + (r * f - g) ^ 2 + q ^ 2 * f ^ 2 + r ^ 2 * g ^ 2) by ring. nng. }
  assert (Z : f t ^ 2 + g t ^ 2 <= 0).
  { assert (E0 : f 0 ^ 2 + g 0 ^ 2 = 0) by (rewrite Zf, Zg; ring). destruct (Rle_dec 0 t) as [P | P].
    - assert (M : (f t ^ 2 + g t ^ 2) * exp (- A t) <= (f 0 ^ 2 + g 0 ^ 2) * exp (- A 0)).
      { eapply (falls 0 t (fun u => (f u ^ 2 + g u ^ 2) * exp (- A u))); [exact P | |].
        - intros u Hu. eapply D_mult; [apply DE; lra | apply D_exp, D_opp, DA; lra].
        - intros u Hu. destruct (B u) as [_ Q]. pose proof (exp_pos (- A u)). nra. }
      rewrite E0, Rmult_0_l in M. pose proof (exp_pos (- A t)). nra.
    - assert (M : - ((f t ^ 2 + g t ^ 2) * exp (A t)) >= - ((f 0 ^ 2 + g 0 ^ 2) * exp (A 0))).
      { apply Rle_ge. eapply (falls t 0 (fun u => - ((f u ^ 2 + g u ^ 2) * exp (A u)))); [lra | |].
        - intros u Hu. eapply D_opp, D_mult; [apply DE; lra | apply D_exp, DA; lra].
        - intros u Hu. destruct (B u) as [Q _]. pose proof (exp_pos (A u)). nra. }
      rewrite E0, Rmult_0_l in M. pose proof (exp_pos (A t)). nra. }
  nra.
Qed.

Ltac nonzero_here := cbv beta; rewrite ?Rmult_0_l, ?Rplus_0_r; first [nonzero | ang; repeat apply Rmult_integral_contrapositive_currified;
  first [nonzero | apply Rgt_not_eq; lra | apply Rlt_not_eq; lra]].
Ltac letter_continuous f t :=
  match goal with
  | C : forall t, _ -> continuous f t, H : _ < t < _ |- _ => exact (C t H)
  | D : forall t, _ -> is_derive f t _, H : _ < t < _ |- _ => exact (C_der f t _ (D t H))
  end.
Ltac cont := repeat (
  lazymatch goal with
  | |- continuous (fun _ => ?c) _ => apply continuous_const
  | |- continuous (fun u => u) _ => apply continuous_id
  | |- continuous (fun u => @?f u + @?g u) _ => apply (C_plus f g)
  | |- continuous (fun u => @?f u - @?g u) _ => apply (C_minus f g)
  | |- continuous (fun u => - @?f u) _ => apply (C_opp f)
  | |- continuous (fun u => @?f u * @?g u) _ => apply (C_mult f g)
  | |- continuous (fun u => @?f u / @?g u) _ =>
    lazymatch g with fun _ => ?c => apply (C_div f c) | _ => apply (C_quot f g); [| | nonzero_here] end
  | |- continuous (fun u => / @?g u) _ => apply (continuous_Rinv_comp g); [| nonzero_here]
  | |- continuous (fun u => sqrt (@?f u)) _ => apply (continuous_sqrt_comp f)
  | |- continuous (fun u => @?f u ^ ?n) _ => apply (C_pow f n)
  | |- continuous (fun u => sin (@?f u)) _ => apply (C_sin f)
  | |- continuous (fun u => cos (@?f u)) _ => apply (C_cos f)
  | |- continuous (fun u => exp (@?f u)) _ => apply (C_exp f)
  | |- continuous (fun u => ?f u) ?t => letter_continuous f t
  end; cbv beta).
Ltac der := repeat (
  lazymatch goal with
  | |- is_derive (fun _ => ?c) _ _ => apply D_const
  | |- is_derive (fun u => u) _ _ => apply D_id
  | |- is_derive (fun u => @?f u + @?g u) _ _ => eapply (D_plus f g)
  | |- is_derive (fun u => @?f u - @?g u) _ _ => eapply (D_minus f g)
  | |- is_derive (fun u => - @?f u) _ _ => eapply (D_opp f)
  | |- is_derive (fun u => @?f u * @?g u) _ _ => eapply (D_mult f g)
  | |- is_derive (fun u => @?f u / @?g u) _ _ =>
    lazymatch g with fun _ => ?c => eapply (D_div f c) | _ => eapply (D_quot f g); [| | nonzero_here] end
  | |- is_derive (fun u => / @?g u) _ _ => eapply (D_inv g); [| nonzero_here]
  | |- is_derive (fun u => @?f u ^ ?n) _ _ => eapply (D_pow f n)
  | |- is_derive (fun u => sin (@?f u)) _ _ => eapply (D_sin f)
  | |- is_derive (fun u => cos (@?f u)) _ _ => eapply (D_cos f)
  | |- is_derive (fun u => exp (@?f u)) _ _ => eapply (D_exp f)
  | |- is_derive (fun u => ln (@?f u)) _ _ => eapply (D_ln f); [| cbv beta; rewrite ?Rmult_0_l, ?Rplus_0_r; over0]
  | |- is_derive (fun u => sqrt (@?f u)) _ _ => eapply (D_sqrt f); [| cbv beta; rewrite ?Rmult_0_l, ?Rplus_0_r; over0]
  | |- is_derive (fun u => RInt ?g 0 u) _ _ => eapply rate_time; [eassumption | eassumption | intros; cont]
  | |- is_derive (fun u => RInt ?f ?c (@?q u)) _ _ => eapply (rate_path f q c); [| intros; cont]
  | D : forall t, _ -> is_derive ?f t _, H : _ < ?t < _ |- is_derive (fun u => ?f u) ?t _ => exact (D t H)
  | D : forall t, _ -> is_derive ?f t _, H : _ < ?t < _ |- is_derive ?f ?t _ => exact (D t H)
  end; cbv beta).
