Require Import Prelude. Open Scope R_scope.
Section Problem.
Variable n : R.
Hypothesis above'n : 0 < n.
Variable M : R.
Hypothesis above'M : 0 < M.
Variable m : R.
Hypothesis above'm : 0 < m.
Variable R_ : R.
Hypothesis above'R : 0 < R_.
Variable m_c : R.
Hypothesis above'm_c : 0 < m_c.
Variable b : R.
Hypothesis above'b : 0 < b.
Variables ta tb : R. Hypothesis Begin : ta < 0 < tb.
Variable I_wheel_1 : R.
Variable I_wheel_2 : R.
Variable I_wheel_2_all : R.
Variable I_wheel : R.
Variable y_cm_counterweight : R.
Variable I_counterweight_0 : R.
Variable I_counterweight : R.
Variable I_wheel_O : R.
Variable I_counterweight_O : R.
Variable I_wheel_bottom : R.
Variable I_counterweight_wheel_bottom : R.
Variable I_wheel_counterweight_left : R.
Variable I_counterweight_left : R.
Definition moment'wheel_1'd1 : Prop := forall t : R, ta < t < tb -> I_wheel_1 = ((M / (2 * PI * R_)) * (RInt (fun x : R => (R_ ^ 3)) 0 (2 * PI))).
Definition moment'wheel_1'1 : Prop := forall t : R, ta < t < tb -> I_wheel_1 = ((M / (2 * PI * R_)) * (RInt (fun x : R => (R_ ^ 3)) 0 (2 * PI))).
Definition moment'wheel_1'2 : Prop := forall t : R, ta < t < tb -> ((M / (2 * PI * R_)) * (RInt (fun x : R => (R_ ^ 3)) 0 (2 * PI))) = (M * (R_ ^ 2)).
Definition moment'wheel_2'd1 : Prop := forall t : R, ta < t < tb -> I_wheel_2 = ((m / R_) * (RInt (fun x : R => ((x + (- (R_ / 2))) ^ 2)) 0 R_)).
Definition moment'wheel_2'1 : Prop := forall t : R, ta < t < tb -> I_wheel_2 = ((m / R_) * (RInt (fun x : R => ((x + (- (R_ / 2))) ^ 2)) 0 R_)).
Definition moment'wheel_2'2 : Prop := forall t : R, ta < t < tb -> ((m / R_) * (RInt (fun x : R => ((x + (- (R_ / 2))) ^ 2)) 0 R_)) = ((m * (R_ ^ 2)) / 12).
Definition moment'wheel_2_all'd1 : Prop := forall t : R, ta < t < tb -> I_wheel_2_all = (n * (I_wheel_2 + (m * ((R_ / 2) ^ 2)))).
Definition moment'wheel_2_all'1 : Prop := forall t : R, ta < t < tb -> I_wheel_2_all = (n * (I_wheel_2 + (m * ((R_ / 2) ^ 2)))).
Definition moment'wheel_2_all'2 : Prop := forall t : R, ta < t < tb -> (n * (I_wheel_2 + (m * ((R_ / 2) ^ 2)))) = ((n * m * (R_ ^ 2)) / 3).
Definition moment'wheel'cm'd1 : Prop := forall t : R, ta < t < tb -> I_wheel = (I_wheel_1 + I_wheel_2_all).
Definition moment'wheel'cm'1 : Prop := forall t : R, ta < t < tb -> I_wheel = (I_wheel_1 + I_wheel_2_all).
Definition moment'wheel'cm'2 : Prop := forall t : R, ta < t < tb -> (I_wheel_1 + I_wheel_2_all) = ((M * (R_ ^ 2)) + ((n * m * (R_ ^ 2)) / 3)).
Definition moment'wheel'cm'3 : Prop := forall t : R, ta < t < tb -> ((M * (R_ ^ 2)) + ((n * m * (R_ ^ 2)) / 3)) = ((1 / 3) * (R_ ^ 2) * ((3 * M) + (n * m))).
Definition center'counterweight'd1 : Prop := forall t : R, ta < t < tb -> y_cm_counterweight = ((1 / m_c) * ((2 * m_c) / (PI * (b ^ 2))) * (RInt (fun x : R => (RInt (fun x1 : R => ((x ^ 2) * (sin x1))) 0 PI)) 0 b)).
Definition center'counterweight'1 : Prop := forall t : R, ta < t < tb -> y_cm_counterweight = ((1 / m_c) * ((2 * m_c) / (PI * (b ^ 2))) * (RInt (fun x : R => (RInt (fun x1 : R => ((x ^ 2) * (sin x1))) 0 PI)) 0 b)).
Definition center'counterweight'2 : Prop := forall t : R, ta < t < tb -> ((1 / m_c) * ((2 * m_c) / (PI * (b ^ 2))) * (RInt (fun x : R => (RInt (fun x1 : R => ((x ^ 2) * (sin x1))) 0 PI)) 0 b)) = ((4 * b) / (3 * PI)).
Definition moment'counterweight'origin'd1 : Prop := forall t : R, ta < t < tb -> I_counterweight_0 = (((2 * m_c) / (PI * (b ^ 2))) * (RInt (fun x : R => (RInt (fun x1 : R => (x ^ 3)) 0 PI)) 0 b)).
Definition moment'counterweight'origin'1 : Prop := forall t : R, ta < t < tb -> I_counterweight_0 = (((2 * m_c) / (PI * (b ^ 2))) * (RInt (fun x : R => (RInt (fun x1 : R => (x ^ 3)) 0 PI)) 0 b)).
Definition moment'counterweight'origin'2 : Prop := forall t : R, ta < t < tb -> (((2 * m_c) / (PI * (b ^ 2))) * (RInt (fun x : R => (RInt (fun x1 : R => (x ^ 3)) 0 PI)) 0 b)) = ((m_c * (b ^ 2)) / 2).
Definition moment'counterweight'd1 : Prop := forall t : R, ta < t < tb -> I_counterweight = (I_counterweight_0 + (- (m_c * ((16 * (b ^ 2)) / (9 * (PI ^ 2)))))).
Definition moment'counterweight'1 : Prop := forall t : R, ta < t < tb -> I_counterweight = (I_counterweight_0 + (- (m_c * ((16 * (b ^ 2)) / (9 * (PI ^ 2)))))).
Definition moment'counterweight'2 : Prop := forall t : R, ta < t < tb -> (I_counterweight_0 + (- (m_c * ((16 * (b ^ 2)) / (9 * (PI ^ 2)))))) = (m_c * (b ^ 2) * ((1 / 2) + (- (16 / (9 * (PI ^ 2)))))).
Definition moment'wheel'O'd1 : Prop := forall t : R, ta < t < tb -> I_wheel_O = (I_wheel_1 + I_wheel_2_all).
Definition moment'wheel'O'1 : Prop := forall t : R, ta < t < tb -> I_wheel_O = (I_wheel_1 + I_wheel_2_all).
Definition moment'wheel'O'2 : Prop := forall t : R, ta < t < tb -> (I_wheel_1 + I_wheel_2_all) = ((M * (R_ ^ 2)) + ((n * m * (R_ ^ 2)) / 3)).
Definition moment'wheel'O'3 : Prop := forall t : R, ta < t < tb -> ((M * (R_ ^ 2)) + ((n * m * (R_ ^ 2)) / 3)) = ((1 / 3) * (R_ ^ 2) * ((3 * M) + (n * m))).
Definition moment'counterweight'O'd1 : Prop := forall t : R, ta < t < tb -> I_counterweight_O = (I_counterweight + (m_c * ((((4 * b) / (3 * PI)) + (2 * R_)) ^ 2))).
Definition moment'counterweight'O'1 : Prop := forall t : R, ta < t < tb -> I_counterweight_O = (I_counterweight + (m_c * ((((4 * b) / (3 * PI)) + (2 * R_)) ^ 2))).
Definition moment'counterweight'O'2 : Prop := forall t : R, ta < t < tb -> (I_counterweight + (m_c * ((((4 * b) / (3 * PI)) + (2 * R_)) ^ 2))) = (m_c * (((16 * R_ * b) / (3 * PI)) + (4 * (R_ ^ 2)) + ((b ^ 2) / 2))).
Definition moment'wheel'wheel'bottom'd1 : Prop := forall t : R, ta < t < tb -> I_wheel_bottom = (I_wheel_1 + (M * (R_ ^ 2)) + I_wheel_2_all + (n * m * (R_ ^ 2))).
Definition moment'wheel'wheel'bottom'1 : Prop := forall t : R, ta < t < tb -> I_wheel_bottom = (I_wheel_1 + (M * (R_ ^ 2)) + I_wheel_2_all + (n * m * (R_ ^ 2))).
Definition moment'wheel'wheel'bottom'2 : Prop := forall t : R, ta < t < tb -> (I_wheel_1 + (M * (R_ ^ 2)) + I_wheel_2_all + (n * m * (R_ ^ 2))) = ((2 * M * (R_ ^ 2)) + ((4 * n * m * (R_ ^ 2)) / 3)).
Definition moment'wheel'wheel'bottom'3 : Prop := forall t : R, ta < t < tb -> ((2 * M * (R_ ^ 2)) + ((4 * n * m * (R_ ^ 2)) / 3)) = ((2 / 3) * (R_ ^ 2) * ((3 * M) + (2 * n * m))).
Definition moment'counterweight'wheel'bottom'd1 : Prop := forall t : R, ta < t < tb -> I_counterweight_wheel_bottom = (I_counterweight + (m_c * ((((4 * b) / (3 * PI)) + (3 * R_)) ^ 2))).
Definition moment'counterweight'wheel'bottom'1 : Prop := forall t : R, ta < t < tb -> I_counterweight_wheel_bottom = (I_counterweight + (m_c * ((((4 * b) / (3 * PI)) + (3 * R_)) ^ 2))).
Definition moment'counterweight'wheel'bottom'2 : Prop := forall t : R, ta < t < tb -> (I_counterweight + (m_c * ((((4 * b) / (3 * PI)) + (3 * R_)) ^ 2))) = (m_c * (((8 * R_ * b) / PI) + (9 * (R_ ^ 2)) + ((b ^ 2) / 2))).
Definition moment'wheel'counterweight'left'd1 : Prop := forall t : R, ta < t < tb -> I_wheel_counterweight_left = (I_wheel_1 + (M * ((4 * (R_ ^ 2)) + (b ^ 2))) + I_wheel_2_all + (m * n * ((4 * (R_ ^ 2)) + (b ^ 2)))).
Definition moment'wheel'counterweight'left'1 : Prop := forall t : R, ta < t < tb -> I_wheel_counterweight_left = (I_wheel_1 + (M * ((4 * (R_ ^ 2)) + (b ^ 2))) + I_wheel_2_all + (m * n * ((4 * (R_ ^ 2)) + (b ^ 2)))).
Definition moment'wheel'counterweight'left'2 : Prop := forall t : R, ta < t < tb -> (I_wheel_1 + (M * ((4 * (R_ ^ 2)) + (b ^ 2))) + I_wheel_2_all + (m * n * ((4 * (R_ ^ 2)) + (b ^ 2)))) = ((M * ((5 * (R_ ^ 2)) + (b ^ 2))) + ((1 / 3) * m * n * ((13 * (R_ ^ 2)) + (3 * (b ^ 2))))).
Definition moment'wheel'counterweight'left'3 : Prop := forall t : R, ta < t < tb -> ((M * ((5 * (R_ ^ 2)) + (b ^ 2))) + ((1 / 3) * m * n * ((13 * (R_ ^ 2)) + (3 * (b ^ 2))))) = ((5 * M * (R_ ^ 2)) + (M * (b ^ 2)) + ((13 * n * m * (R_ ^ 2)) / 3) + (n * m * (b ^ 2))).
Definition moment'counterweight'counterweight'left'd1 : Prop := forall t : R, ta < t < tb -> I_counterweight_left = (I_counterweight + ((16 * m_c * (b ^ 2)) / (9 * (PI ^ 2))) + (m_c * (b ^ 2))).
Definition moment'counterweight'counterweight'left'1 : Prop := forall t : R, ta < t < tb -> I_counterweight_left = (I_counterweight + ((16 * m_c * (b ^ 2)) / (9 * (PI ^ 2))) + (m_c * (b ^ 2))).
Definition moment'counterweight'counterweight'left'2 : Prop := forall t : R, ta < t < tb -> (I_counterweight + ((16 * m_c * (b ^ 2)) / (9 * (PI ^ 2))) + (m_c * (b ^ 2))) = ((3 * m_c * (b ^ 2)) / 2).
Lemma moment'wheel_1'1'holds : moment'wheel_1'd1 -> moment'wheel_1'1.
Proof. timeout 120 (unfold moment'wheel_1'1, moment'wheel_1'd1;
  intros p_moment'wheel_1'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel_1'd1 t Ht)); fld). Qed.
Lemma moment'wheel_1'2'holds : moment'wheel_1'2.
Proof. timeout 120 (unfold moment'wheel_1'2;
  assert (q1 : forall t : R, ta < t < tb -> (RInt (fun x : R => (R_ ^ 3)) 0 (2 * PI)) = (2 * PI * (R_ ^ 3))) by (intros t Ht; apply (RInt_by (fun x : R => ((R_ ^ 3) * x))); [intros; eapply D_eq; [der | fld] | intros; cont | cbv beta; fld]);
  intros t Ht; apply lin0; apply (less (((/ (PI ^ 1)) * M * (/ (R_ ^ 1))) / 2) _ _ (q1 t Ht)); fld). Qed.
Lemma moment'wheel_2'1'holds : moment'wheel_2'd1 -> moment'wheel_2'1.
Proof. timeout 120 (unfold moment'wheel_2'1, moment'wheel_2'd1;
  intros p_moment'wheel_2'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel_2'd1 t Ht)); fld). Qed.
Lemma moment'wheel_2'2'holds : moment'wheel_2'2.
Proof. timeout 120 (unfold moment'wheel_2'2;
  assert (q1 : forall t : R, ta < t < tb -> (RInt (fun x : R => ((x + (- (R_ / 2))) ^ 2)) 0 R_) = ((R_ ^ 3) / 12)) by (intros t Ht; apply (RInt_by (fun x : R => (((x ^ 3) / 3) + (- (((x ^ 2) * R_) / 2)) + ((x * (R_ ^ 2)) / 4)))); [intros; eapply D_eq; [der | fld] | intros; cont | cbv beta; fld]);
  intros t Ht; apply lin0; apply (less (m * (/ (R_ ^ 1))) _ _ (q1 t Ht)); fld). Qed.
Lemma moment'wheel_2_all'1'holds : moment'wheel_2_all'd1 -> moment'wheel_2_all'1.
Proof. timeout 120 (unfold moment'wheel_2_all'1, moment'wheel_2_all'd1;
  intros p_moment'wheel_2_all'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel_2_all'd1 t Ht)); fld). Qed.
Lemma moment'wheel_2_all'2'holds : moment'wheel_2'd1 -> moment'wheel_2'2 -> moment'wheel_2_all'2.
Proof. timeout 120 (unfold moment'wheel_2_all'2, moment'wheel_2'd1, moment'wheel_2'2;
  intros p_moment'wheel_2'd1;
  intros p_moment'wheel_2'2;
  intros t Ht; apply lin0; apply (less n _ _ (p_moment'wheel_2'd1 t Ht)); apply (less n _ _ (p_moment'wheel_2'2 t Ht)); fld). Qed.
Lemma moment'wheel'cm'1'holds : moment'wheel'cm'd1 -> moment'wheel'cm'1.
Proof. timeout 120 (unfold moment'wheel'cm'1, moment'wheel'cm'd1;
  intros p_moment'wheel'cm'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel'cm'd1 t Ht)); fld). Qed.
Lemma moment'wheel'cm'2'holds : moment'wheel_1'd1 -> moment'wheel_1'2 -> moment'wheel_2_all'd1 -> moment'wheel_2_all'2 -> moment'wheel'cm'2.
Proof. timeout 120 (unfold moment'wheel'cm'2, moment'wheel_1'd1, moment'wheel_1'2, moment'wheel_2_all'd1, moment'wheel_2_all'2;
  intros p_moment'wheel_1'd1;
  intros p_moment'wheel_1'2;
  intros p_moment'wheel_2_all'd1;
  intros p_moment'wheel_2_all'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel_2_all'd1 t Ht)); apply (less 1 _ _ (p_moment'wheel_2_all'2 t Ht)); apply (less 1 _ _ (p_moment'wheel_1'd1 t Ht)); apply (less 1 _ _ (p_moment'wheel_1'2 t Ht)); fld). Qed.
Lemma moment'wheel'cm'3'holds : moment'wheel'cm'3.
Proof. timeout 120 (unfold moment'wheel'cm'3;
  intros t Ht; apply lin0; fld). Qed.
Lemma center'counterweight'1'holds : center'counterweight'd1 -> center'counterweight'1.
Proof. timeout 120 (unfold center'counterweight'1, center'counterweight'd1;
  intros p_center'counterweight'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_center'counterweight'd1 t Ht)); fld). Qed.
Lemma center'counterweight'2'holds : center'counterweight'2.
Proof. timeout 120 (unfold center'counterweight'2;
  assert (q1 : forall t : R, ta < t < tb -> (RInt (fun x : R => (RInt (fun x1 : R => ((x ^ 2) * (sin x1))) 0 PI)) 0 b) = ((2 * (b ^ 3)) / 3)) by (intros t Ht; apply (RInt_on (fun x : R => (2 * (x ^ 2)))); [intros x; apply (RInt_by (fun y : R => (- ((x ^ 2) * (cos y))))); [intros; eapply D_eq; [der | fld] | intros; cont | cbv beta; fld] | apply (RInt_by (fun x : R => ((2 * (x ^ 3)) / 3))); [intros; eapply D_eq; [der | fld] | intros; cont | cbv beta; fld]]);
  intros t Ht; apply lin0; apply (less (2 * (/ (PI ^ 1)) * (/ (b ^ 2))) _ _ (q1 t Ht)); fld). Qed.
Lemma moment'counterweight'origin'1'holds : moment'counterweight'origin'd1 -> moment'counterweight'origin'1.
Proof. timeout 120 (unfold moment'counterweight'origin'1, moment'counterweight'origin'd1;
  intros p_moment'counterweight'origin'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'counterweight'origin'd1 t Ht)); fld). Qed.
Lemma moment'counterweight'origin'2'holds : moment'counterweight'origin'2.
Proof. timeout 120 (unfold moment'counterweight'origin'2;
  assert (q1 : forall t : R, ta < t < tb -> (RInt (fun x : R => (RInt (fun x1 : R => (x ^ 3)) 0 PI)) 0 b) = ((PI * (b ^ 4)) / 4)) by (intros t Ht; apply (RInt_on (fun x : R => (PI * (x ^ 3)))); [intros x; apply (RInt_by (fun y : R => ((x ^ 3) * y))); [intros; eapply D_eq; [der | fld] | intros; cont | cbv beta; fld] | apply (RInt_by (fun x : R => ((PI * (x ^ 4)) / 4))); [intros; eapply D_eq; [der | fld] | intros; cont | cbv beta; fld]]);
  intros t Ht; apply lin0; apply (less (2 * (/ (PI ^ 1)) * (/ (b ^ 2)) * m_c) _ _ (q1 t Ht)); fld). Qed.
Lemma moment'counterweight'1'holds : moment'counterweight'd1 -> moment'counterweight'1.
Proof. timeout 120 (unfold moment'counterweight'1, moment'counterweight'd1;
  intros p_moment'counterweight'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'counterweight'd1 t Ht)); fld). Qed.
Lemma moment'counterweight'2'holds : moment'counterweight'origin'd1 -> moment'counterweight'origin'2 -> moment'counterweight'2.
Proof. timeout 120 (unfold moment'counterweight'2, moment'counterweight'origin'd1, moment'counterweight'origin'2;
  intros p_moment'counterweight'origin'd1;
  intros p_moment'counterweight'origin'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'counterweight'origin'd1 t Ht)); apply (less 1 _ _ (p_moment'counterweight'origin'2 t Ht)); fld). Qed.
Lemma moment'wheel'O'1'holds : moment'wheel'O'd1 -> moment'wheel'O'1.
Proof. timeout 120 (unfold moment'wheel'O'1, moment'wheel'O'd1;
  intros p_moment'wheel'O'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel'O'd1 t Ht)); fld). Qed.
Lemma moment'wheel'O'2'holds : moment'wheel_1'd1 -> moment'wheel_1'2 -> moment'wheel_2_all'd1 -> moment'wheel_2_all'2 -> moment'wheel'O'2.
Proof. timeout 120 (unfold moment'wheel'O'2, moment'wheel_1'd1, moment'wheel_1'2, moment'wheel_2_all'd1, moment'wheel_2_all'2;
  intros p_moment'wheel_1'd1;
  intros p_moment'wheel_1'2;
  intros p_moment'wheel_2_all'd1;
  intros p_moment'wheel_2_all'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel_2_all'd1 t Ht)); apply (less 1 _ _ (p_moment'wheel_2_all'2 t Ht)); apply (less 1 _ _ (p_moment'wheel_1'd1 t Ht)); apply (less 1 _ _ (p_moment'wheel_1'2 t Ht)); fld). Qed.
Lemma moment'wheel'O'3'holds : moment'wheel'O'3.
Proof. timeout 120 (unfold moment'wheel'O'3;
  intros t Ht; apply lin0; fld). Qed.
Lemma moment'counterweight'O'1'holds : moment'counterweight'O'd1 -> moment'counterweight'O'1.
Proof. timeout 120 (unfold moment'counterweight'O'1, moment'counterweight'O'd1;
  intros p_moment'counterweight'O'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'counterweight'O'd1 t Ht)); fld). Qed.
Lemma moment'counterweight'O'2'holds : moment'counterweight'd1 -> moment'counterweight'2 -> moment'counterweight'O'2.
Proof. timeout 120 (unfold moment'counterweight'O'2, moment'counterweight'd1, moment'counterweight'2;
  intros p_moment'counterweight'd1;
  intros p_moment'counterweight'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'counterweight'd1 t Ht)); apply (less 1 _ _ (p_moment'counterweight'2 t Ht)); fld). Qed.
Lemma moment'wheel'wheel'bottom'1'holds : moment'wheel'wheel'bottom'd1 -> moment'wheel'wheel'bottom'1.
Proof. timeout 120 (unfold moment'wheel'wheel'bottom'1, moment'wheel'wheel'bottom'd1;
  intros p_moment'wheel'wheel'bottom'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel'wheel'bottom'd1 t Ht)); fld). Qed.
Lemma moment'wheel'wheel'bottom'2'holds : moment'wheel_1'd1 -> moment'wheel_1'2 -> moment'wheel_2_all'd1 -> moment'wheel_2_all'2 -> moment'wheel'wheel'bottom'2.
Proof. timeout 120 (unfold moment'wheel'wheel'bottom'2, moment'wheel_1'd1, moment'wheel_1'2, moment'wheel_2_all'd1, moment'wheel_2_all'2;
  intros p_moment'wheel_1'd1;
  intros p_moment'wheel_1'2;
  intros p_moment'wheel_2_all'd1;
  intros p_moment'wheel_2_all'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel_2_all'd1 t Ht)); apply (less 1 _ _ (p_moment'wheel_2_all'2 t Ht)); apply (less 1 _ _ (p_moment'wheel_1'd1 t Ht)); apply (less 1 _ _ (p_moment'wheel_1'2 t Ht)); fld). Qed.
Lemma moment'wheel'wheel'bottom'3'holds : moment'wheel'wheel'bottom'3.
Proof. timeout 120 (unfold moment'wheel'wheel'bottom'3;
  intros t Ht; apply lin0; fld). Qed.
Lemma moment'counterweight'wheel'bottom'1'holds : moment'counterweight'wheel'bottom'd1 -> moment'counterweight'wheel'bottom'1.
Proof. timeout 120 (unfold moment'counterweight'wheel'bottom'1, moment'counterweight'wheel'bottom'd1;
  intros p_moment'counterweight'wheel'bottom'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'counterweight'wheel'bottom'd1 t Ht)); fld). Qed.
Lemma moment'counterweight'wheel'bottom'2'holds : moment'counterweight'd1 -> moment'counterweight'2 -> moment'counterweight'wheel'bottom'2.
Proof. timeout 120 (unfold moment'counterweight'wheel'bottom'2, moment'counterweight'd1, moment'counterweight'2;
  intros p_moment'counterweight'd1;
  intros p_moment'counterweight'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'counterweight'd1 t Ht)); apply (less 1 _ _ (p_moment'counterweight'2 t Ht)); fld). Qed.
Lemma moment'wheel'counterweight'left'1'holds : moment'wheel'counterweight'left'd1 -> moment'wheel'counterweight'left'1.
Proof. timeout 120 (unfold moment'wheel'counterweight'left'1, moment'wheel'counterweight'left'd1;
  intros p_moment'wheel'counterweight'left'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel'counterweight'left'd1 t Ht)); fld). Qed.
Lemma moment'wheel'counterweight'left'2'holds : moment'wheel_1'd1 -> moment'wheel_1'2 -> moment'wheel_2_all'd1 -> moment'wheel_2_all'2 -> moment'wheel'counterweight'left'2.
Proof. timeout 120 (unfold moment'wheel'counterweight'left'2, moment'wheel_1'd1, moment'wheel_1'2, moment'wheel_2_all'd1, moment'wheel_2_all'2;
  intros p_moment'wheel_1'd1;
  intros p_moment'wheel_1'2;
  intros p_moment'wheel_2_all'd1;
  intros p_moment'wheel_2_all'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'wheel_2_all'd1 t Ht)); apply (less 1 _ _ (p_moment'wheel_2_all'2 t Ht)); apply (less 1 _ _ (p_moment'wheel_1'd1 t Ht)); apply (less 1 _ _ (p_moment'wheel_1'2 t Ht)); fld). Qed.
Lemma moment'wheel'counterweight'left'3'holds : moment'wheel'counterweight'left'3.
Proof. timeout 120 (unfold moment'wheel'counterweight'left'3;
  intros t Ht; apply lin0; fld). Qed.
Lemma moment'counterweight'counterweight'left'1'holds : moment'counterweight'counterweight'left'd1 -> moment'counterweight'counterweight'left'1.
Proof. timeout 120 (unfold moment'counterweight'counterweight'left'1, moment'counterweight'counterweight'left'd1;
  intros p_moment'counterweight'counterweight'left'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'counterweight'counterweight'left'd1 t Ht)); fld). Qed.
Lemma moment'counterweight'counterweight'left'2'holds : moment'counterweight'd1 -> moment'counterweight'2 -> moment'counterweight'counterweight'left'2.
Proof. timeout 120 (unfold moment'counterweight'counterweight'left'2, moment'counterweight'd1, moment'counterweight'2;
  intros p_moment'counterweight'd1;
  intros p_moment'counterweight'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'counterweight'd1 t Ht)); apply (less 1 _ _ (p_moment'counterweight'2 t Ht)); fld). Qed.
Theorem moment'wheel_1'2'result : moment'wheel_1'2.
Proof. exact (moment'wheel_1'2'holds). Qed.
Theorem moment'wheel_2'2'result : moment'wheel_2'2.
Proof. exact (moment'wheel_2'2'holds). Qed.
Theorem moment'wheel_2_all'2'result : moment'wheel_2'd1 -> moment'wheel_2_all'2.
Proof. intros h_moment'wheel_2'd1; exact (moment'wheel_2_all'2'holds h_moment'wheel_2'd1 (moment'wheel_2'2'result)). Qed.
Theorem moment'wheel'cm'1'result : moment'wheel'cm'd1 -> moment'wheel'cm'1.
Proof. intros h_moment'wheel'cm'd1; exact (moment'wheel'cm'1'holds h_moment'wheel'cm'd1). Qed.
Theorem moment'wheel'cm'2'result : moment'wheel_1'd1 -> moment'wheel_2_all'd1 -> moment'wheel_2'd1 -> moment'wheel'cm'2.
Proof. intros h_moment'wheel_1'd1 h_moment'wheel_2_all'd1 h_moment'wheel_2'd1; exact (moment'wheel'cm'2'holds h_moment'wheel_1'd1 (moment'wheel_1'2'result) h_moment'wheel_2_all'd1 (moment'wheel_2_all'2'result h_moment'wheel_2'd1)). Qed.
Theorem moment'wheel'cm'3'result : moment'wheel'cm'3.
Proof. exact (moment'wheel'cm'3'holds). Qed.
Theorem moment'counterweight'origin'2'result : moment'counterweight'origin'2.
Proof. exact (moment'counterweight'origin'2'holds). Qed.
Theorem moment'counterweight'1'result : moment'counterweight'd1 -> moment'counterweight'1.
Proof. intros h_moment'counterweight'd1; exact (moment'counterweight'1'holds h_moment'counterweight'd1). Qed.
Theorem moment'counterweight'2'result : moment'counterweight'origin'd1 -> moment'counterweight'2.
Proof. intros h_moment'counterweight'origin'd1; exact (moment'counterweight'2'holds h_moment'counterweight'origin'd1 (moment'counterweight'origin'2'result)). Qed.
Theorem moment'wheel'O'1'result : moment'wheel'O'd1 -> moment'wheel'O'1.
Proof. intros h_moment'wheel'O'd1; exact (moment'wheel'O'1'holds h_moment'wheel'O'd1). Qed.
Theorem moment'wheel'O'2'result : moment'wheel_1'd1 -> moment'wheel_2_all'd1 -> moment'wheel_2'd1 -> moment'wheel'O'2.
Proof. intros h_moment'wheel_1'd1 h_moment'wheel_2_all'd1 h_moment'wheel_2'd1; exact (moment'wheel'O'2'holds h_moment'wheel_1'd1 (moment'wheel_1'2'result) h_moment'wheel_2_all'd1 (moment'wheel_2_all'2'result h_moment'wheel_2'd1)). Qed.
Theorem moment'wheel'O'3'result : moment'wheel'O'3.
Proof. exact (moment'wheel'O'3'holds). Qed.
Theorem moment'counterweight'O'1'result : moment'counterweight'O'd1 -> moment'counterweight'O'1.
Proof. intros h_moment'counterweight'O'd1; exact (moment'counterweight'O'1'holds h_moment'counterweight'O'd1). Qed.
Theorem moment'counterweight'O'2'result : moment'counterweight'd1 -> moment'counterweight'origin'd1 -> moment'counterweight'O'2.
Proof. intros h_moment'counterweight'd1 h_moment'counterweight'origin'd1; exact (moment'counterweight'O'2'holds h_moment'counterweight'd1 (moment'counterweight'2'result h_moment'counterweight'origin'd1)). Qed.
Theorem moment'wheel'wheel'bottom'1'result : moment'wheel'wheel'bottom'd1 -> moment'wheel'wheel'bottom'1.
Proof. intros h_moment'wheel'wheel'bottom'd1; exact (moment'wheel'wheel'bottom'1'holds h_moment'wheel'wheel'bottom'd1). Qed.
Theorem moment'wheel'wheel'bottom'2'result : moment'wheel_1'd1 -> moment'wheel_2_all'd1 -> moment'wheel_2'd1 -> moment'wheel'wheel'bottom'2.
Proof. intros h_moment'wheel_1'd1 h_moment'wheel_2_all'd1 h_moment'wheel_2'd1; exact (moment'wheel'wheel'bottom'2'holds h_moment'wheel_1'd1 (moment'wheel_1'2'result) h_moment'wheel_2_all'd1 (moment'wheel_2_all'2'result h_moment'wheel_2'd1)). Qed.
Theorem moment'wheel'wheel'bottom'3'result : moment'wheel'wheel'bottom'3.
Proof. exact (moment'wheel'wheel'bottom'3'holds). Qed.
Theorem moment'counterweight'wheel'bottom'1'result : moment'counterweight'wheel'bottom'd1 -> moment'counterweight'wheel'bottom'1.
Proof. intros h_moment'counterweight'wheel'bottom'd1; exact (moment'counterweight'wheel'bottom'1'holds h_moment'counterweight'wheel'bottom'd1). Qed.
Theorem moment'counterweight'wheel'bottom'2'result : moment'counterweight'd1 -> moment'counterweight'origin'd1 -> moment'counterweight'wheel'bottom'2.
Proof. intros h_moment'counterweight'd1 h_moment'counterweight'origin'd1; exact (moment'counterweight'wheel'bottom'2'holds h_moment'counterweight'd1 (moment'counterweight'2'result h_moment'counterweight'origin'd1)). Qed.
Theorem moment'wheel'counterweight'left'1'result : moment'wheel'counterweight'left'd1 -> moment'wheel'counterweight'left'1.
Proof. intros h_moment'wheel'counterweight'left'd1; exact (moment'wheel'counterweight'left'1'holds h_moment'wheel'counterweight'left'd1). Qed.
Theorem moment'wheel'counterweight'left'2'result : moment'wheel_1'd1 -> moment'wheel_2_all'd1 -> moment'wheel_2'd1 -> moment'wheel'counterweight'left'2.
Proof. intros h_moment'wheel_1'd1 h_moment'wheel_2_all'd1 h_moment'wheel_2'd1; exact (moment'wheel'counterweight'left'2'holds h_moment'wheel_1'd1 (moment'wheel_1'2'result) h_moment'wheel_2_all'd1 (moment'wheel_2_all'2'result h_moment'wheel_2'd1)). Qed.
Theorem moment'wheel'counterweight'left'3'result : moment'wheel'counterweight'left'3.
Proof. exact (moment'wheel'counterweight'left'3'holds). Qed.
Theorem moment'counterweight'counterweight'left'1'result : moment'counterweight'counterweight'left'd1 -> moment'counterweight'counterweight'left'1.
Proof. intros h_moment'counterweight'counterweight'left'd1; exact (moment'counterweight'counterweight'left'1'holds h_moment'counterweight'counterweight'left'd1). Qed.
Theorem moment'counterweight'counterweight'left'2'result : moment'counterweight'd1 -> moment'counterweight'origin'd1 -> moment'counterweight'counterweight'left'2.
Proof. intros h_moment'counterweight'd1 h_moment'counterweight'origin'd1; exact (moment'counterweight'counterweight'left'2'holds h_moment'counterweight'd1 (moment'counterweight'2'result h_moment'counterweight'origin'd1)). Qed.
Definition all'of'it := (moment'wheel_1'1'holds, moment'wheel_1'2'holds, moment'wheel_2'1'holds, moment'wheel_2'2'holds, moment'wheel_2_all'1'holds, moment'wheel_2_all'2'holds, moment'wheel'cm'1'holds, moment'wheel'cm'2'holds, moment'wheel'cm'3'holds, center'counterweight'1'holds, center'counterweight'2'holds, moment'counterweight'origin'1'holds, moment'counterweight'origin'2'holds, moment'counterweight'1'holds, moment'counterweight'2'holds, moment'wheel'O'1'holds, moment'wheel'O'2'holds, moment'wheel'O'3'holds, moment'counterweight'O'1'holds, moment'counterweight'O'2'holds, moment'wheel'wheel'bottom'1'holds, moment'wheel'wheel'bottom'2'holds, moment'wheel'wheel'bottom'3'holds, moment'counterweight'wheel'bottom'1'holds, moment'counterweight'wheel'bottom'2'holds, moment'wheel'counterweight'left'1'holds, moment'wheel'counterweight'left'2'holds, moment'wheel'counterweight'left'3'holds, moment'counterweight'counterweight'left'1'holds, moment'counterweight'counterweight'left'2'holds).
Print Assumptions all'of'it.
End Problem.
