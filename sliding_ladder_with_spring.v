Require Import Prelude. Open Scope R_scope.
Section Problem.
Variable M : R.
Hypothesis above'M : 0 < M.
Variable ell : R.
Hypothesis above'ell : 0 < ell.
Variable g : R.
Hypothesis above'g : 0 < g.
Variable k : R.
Hypothesis above'k : 0 < k.
Variable theta_0 : R.
Variable t_ : R.
Variables ta tb : R. Hypothesis Begin : ta < 0 < tb.
Variables theta theta_dot theta_ddot : R -> R.
Hypothesis rate'theta : forall t : R, ta < t < tb -> is_derive theta t (theta_dot t).
Hypothesis rate'theta_dot : forall t : R, ta < t < tb -> is_derive theta_dot t (theta_ddot t).
Hypothesis steady'theta_ddot : forall t : R, ta < t < tb -> continuous theta_ddot t.
Variable N_w : R -> R.
Hypothesis steady'N_w : forall t : R, ta < t < tb -> continuous N_w t.
Variable N_f : R -> R.
Hypothesis steady'N_f : forall t : R, ta < t < tb -> continuous N_f t.
Variable R_cm_x : R -> R.
Variable R_cm_y : R -> R.
Variable y_cm : R -> R.
Variable x_cm : R -> R.
Variable omega_ladder : R -> R.
Variable V_cm_x : R -> R.
Variable V_cm_y : R -> R.
Variable I_cm : R.
Variable L : R -> R.
Variable P_cm_x : R -> R.
Variable P_cm_y : R -> R.
Variable W_x : R -> R.
Variable W_y : R -> R.
Variable tau_cm_W : R -> R.
Variable tau_O_W : R -> R.
Variable F_s_x : R -> R.
Variable F_s_y : R -> R.
Variable tau_cm_F_s : R -> R.
Variable tau_O_F_s : R -> R.
Variable N_w_x : R -> R.
Variable N_w_y : R -> R.
Variable tau_cm_N_w : R -> R.
Variable tau_O_N_w : R -> R.
Variable N_f_x : R -> R.
Variable N_f_y : R -> R.
Variable tau_cm_N_f : R -> R.
Variable tau_O_N_f : R -> R.
Variable tau_C : R -> R.
Variable R_cm_x' : R -> R.
Variable R_cm_y' : R -> R.
Variable cal_W_T_W : R -> R.
Variable cal_W_theta_W : R -> R.
Variable varphi_ladder' : R -> R.
Variable cal_W_T_F_s : R -> R.
Variable varphi_ladder : R -> R.
Variable cal_W_theta_F_s : R -> R.
Variable cal_W_T_N_w : R -> R.
Variable cal_W_theta_N_w : R -> R.
Variable cal_W_T_N_f : R -> R.
Variable cal_W_theta_N_f : R -> R.
Variable l_0 : R.
Variable cal_W_T : R -> R.
Variable cal_w_c : R -> R.
Variable cal_W_theta : R -> R.
Variable E_ : R -> R.
Variable K : R -> R.
Variable U_W : R -> R.
Variable U_F_s : R -> R.
Definition condition'N_w'1 : Prop := forall t : R, ta < t < tb -> ((ell * (cos (theta t))) + (ell * (cos (PI + (- (theta t)))))) = 0.
Definition condition'N_f'1 : Prop := forall t : R, ta < t < tb -> ((ell * (sin (theta t))) + (- (ell * (sin (PI + (- (theta t))))))) = 0.
Definition position'ladder'd1 : Prop := forall t : R, ta < t < tb -> (R_cm_x t) = (ell * (cos (theta t))).
Definition position'ladder'1 : Prop := forall t : R, ta < t < tb -> (R_cm_x t) = (ell * (cos (theta t))).
Definition position'ladder'd2 : Prop := forall t : R, ta < t < tb -> (R_cm_y t) = (ell * (sin (theta t))).
Definition position'ladder'2 : Prop := forall t : R, ta < t < tb -> (R_cm_y t) = (ell * (sin (theta t))).
Definition def'y_cm'd1 : Prop := forall t : R, ta < t < tb -> (y_cm t) = (ell * (sin (theta t))).
Definition def'x_cm'd1 : Prop := forall t : R, ta < t < tb -> (x_cm t) = (ell * (cos (theta t))).
Definition circle'ladder'1 : Prop := forall t : R, ta < t < tb -> (((x_cm t) ^ 2) + ((y_cm t) ^ 2)) = (ell ^ 2).
Definition turning'ladder'd1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (PI + (- (theta t)))) t ((omega_ladder t)).
Definition turning'ladder'1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (PI + (- (theta t)))) t ((omega_ladder t)).
Definition turning'ladder'2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (PI + (- (theta t)))) t ((- (theta_dot t))).
Definition turning'ladder'3 : Prop := forall t : R, ta < t < tb -> (omega_ladder t) = (- (theta_dot t)).
Definition velocity'ladder'd1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_x t)) t ((V_cm_x t)).
Definition velocity'ladder'1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_x t)) t ((V_cm_x t)).
Definition velocity'ladder'd2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_y t)) t ((V_cm_y t)).
Definition velocity'ladder'2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_y t)) t ((V_cm_y t)).
Definition velocity'ladder'3 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_x t)) t ((- (ell * (theta_dot t) * (sin (theta t))))).
Definition velocity'ladder'4 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_y t)) t ((ell * (theta_dot t) * (cos (theta t)))).
Definition velocity'ladder'5 : Prop := forall t : R, ta < t < tb -> (V_cm_x t) = (- (ell * (theta_dot t) * (sin (theta t)))).
Definition velocity'ladder'6 : Prop := forall t : R, ta < t < tb -> (V_cm_y t) = (ell * (theta_dot t) * (cos (theta t))).
Definition speed'ladder'1 : Prop := forall t : R, ta < t < tb -> (((V_cm_x t) * (V_cm_x t)) + ((V_cm_y t) * (V_cm_y t))) = ((ell ^ 2) * ((theta_dot t) ^ 2)).
Definition moment'ladder'd1 : Prop := forall t : R, ta < t < tb -> I_cm = ((M / (2 * ell)) * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell))).
Definition moment'ladder'1 : Prop := forall t : R, ta < t < tb -> I_cm = ((M / (2 * ell)) * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell))).
Definition moment'ladder'2 : Prop := forall t : R, ta < t < tb -> ((M / (2 * ell)) * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell))) = ((M * (ell ^ 2)) / 3).
Definition momentum'ladder'O'd1 : Prop := forall t : R, ta < t < tb -> (L t) = (((R_cm_x t) * (P_cm_y t)) + (- ((R_cm_y t) * (P_cm_x t))) + (I_cm * (omega_ladder t))).
Definition momentum'ladder'O'1 : Prop := forall t : R, ta < t < tb -> (L t) = (((R_cm_x t) * (P_cm_y t)) + (- ((R_cm_y t) * (P_cm_x t))) + (I_cm * (omega_ladder t))).
Definition def'P_cm'd1 : Prop := forall t : R, ta < t < tb -> (P_cm_x t) = (- (ell * M * (sin (theta t)) * (theta_dot t))).
Definition def'P_cm'd2 : Prop := forall t : R, ta < t < tb -> (P_cm_y t) = (ell * M * (cos (theta t)) * (theta_dot t)).
Definition momentum'ladder'O'2 : Prop := forall t : R, ta < t < tb -> (((R_cm_x t) * (P_cm_y t)) + (- ((R_cm_y t) * (P_cm_x t))) + (I_cm * (omega_ladder t))) = ((M * (ell ^ 2) * (theta_dot t)) + (- (((M * (ell ^ 2)) / 3) * (theta_dot t)))).
Definition momentum'ladder'O'3 : Prop := forall t : R, ta < t < tb -> ((M * (ell ^ 2) * (theta_dot t)) + (- (((M * (ell ^ 2)) / 3) * (theta_dot t)))) = (((2 * M * (ell ^ 2)) / 3) * (theta_dot t)).
Definition force'W'ladder'd1 : Prop := forall t : R, ta < t < tb -> (W_x t) = 0.
Definition force'W'ladder'1 : Prop := forall t : R, ta < t < tb -> (W_x t) = 0.
Definition force'W'ladder'd2 : Prop := forall t : R, ta < t < tb -> (W_y t) = (- (M * g)).
Definition force'W'ladder'2 : Prop := forall t : R, ta < t < tb -> (W_y t) = (- (M * g)).
Definition force'W'ladder'd3 : Prop := forall t : R, ta < t < tb -> (tau_cm_W t) = (0 + ((((ell * (cos (theta t))) + (- (ell * (cos (theta t))))) * (- (M * g))) + (- (((ell * (sin (theta t))) + (- (ell * (sin (theta t))))) * 0)) + 0)).
Definition force'W'ladder'3 : Prop := forall t : R, ta < t < tb -> (tau_cm_W t) = 0.
Definition force'W'ladder'd4 : Prop := forall t : R, ta < t < tb -> (tau_O_W t) = (0 + ((((ell * (cos (theta t))) + (- 0)) * (- (M * g))) + (- (((ell * (sin (theta t))) + (- 0)) * 0)) + 0)).
Definition force'W'ladder'4 : Prop := forall t : R, ta < t < tb -> (tau_O_W t) = (- (M * g * ell * (cos (theta t)))).
Definition force'F_s'ladder'd1 : Prop := forall t : R, ta < t < tb -> (F_s_x t) = ((- (2 * ell * (cos (theta t)) * k)) + (2 * ell * (cos theta_0) * k)).
Definition force'F_s'ladder'1 : Prop := forall t : R, ta < t < tb -> (F_s_x t) = (2 * k * ell * ((cos theta_0) + (- (cos (theta t))))).
Definition force'F_s'ladder'd2 : Prop := forall t : R, ta < t < tb -> (F_s_y t) = 0.
Definition force'F_s'ladder'2 : Prop := forall t : R, ta < t < tb -> (F_s_y t) = 0.
Definition force'F_s'ladder'd3 : Prop := forall t : R, ta < t < tb -> (tau_cm_F_s t) = (0 + ((((2 * ell * (cos (theta t))) + (- (ell * (cos (theta t))))) * 0) + (- ((0 + (- (ell * (sin (theta t))))) * ((- (2 * ell * (cos (theta t)) * k)) + (2 * ell * (cos theta_0) * k)))) + 0)).
Definition force'F_s'ladder'3 : Prop := forall t : R, ta < t < tb -> (tau_cm_F_s t) = (2 * k * (ell ^ 2) * ((cos theta_0) + (- (cos (theta t)))) * (sin (theta t))).
Definition force'F_s'ladder'd4 : Prop := forall t : R, ta < t < tb -> (tau_O_F_s t) = (0 + ((((2 * ell * (cos (theta t))) + (- 0)) * 0) + (- ((0 + (- 0)) * ((- (2 * ell * (cos (theta t)) * k)) + (2 * ell * (cos theta_0) * k)))) + 0)).
Definition force'F_s'ladder'4 : Prop := forall t : R, ta < t < tb -> (tau_O_F_s t) = 0.
Definition force'N_w'ladder'd1 : Prop := forall t : R, ta < t < tb -> (N_w_x t) = (N_w t).
Definition force'N_w'ladder'1 : Prop := forall t : R, ta < t < tb -> (N_w_x t) = (N_w t).
Definition force'N_w'ladder'd2 : Prop := forall t : R, ta < t < tb -> (N_w_y t) = 0.
Definition force'N_w'ladder'2 : Prop := forall t : R, ta < t < tb -> (N_w_y t) = 0.
Definition force'N_w'ladder'd3 : Prop := forall t : R, ta < t < tb -> (tau_cm_N_w t) = (0 + (((0 + (- (ell * (cos (theta t))))) * 0) + (- (((2 * ell * (sin (theta t))) + (- (ell * (sin (theta t))))) * (N_w t))) + 0)).
Definition force'N_w'ladder'3 : Prop := forall t : R, ta < t < tb -> (tau_cm_N_w t) = (- (ell * (N_w t) * (sin (theta t)))).
Definition force'N_w'ladder'd4 : Prop := forall t : R, ta < t < tb -> (tau_O_N_w t) = (0 + (((0 + (- 0)) * 0) + (- (((2 * ell * (sin (theta t))) + (- 0)) * (N_w t))) + 0)).
Definition force'N_w'ladder'4 : Prop := forall t : R, ta < t < tb -> (tau_O_N_w t) = (- (2 * ell * (N_w t) * (sin (theta t)))).
Definition force'N_f'ladder'd1 : Prop := forall t : R, ta < t < tb -> (N_f_x t) = 0.
Definition force'N_f'ladder'1 : Prop := forall t : R, ta < t < tb -> (N_f_x t) = 0.
Definition force'N_f'ladder'd2 : Prop := forall t : R, ta < t < tb -> (N_f_y t) = (N_f t).
Definition force'N_f'ladder'2 : Prop := forall t : R, ta < t < tb -> (N_f_y t) = (N_f t).
Definition force'N_f'ladder'd3 : Prop := forall t : R, ta < t < tb -> (tau_cm_N_f t) = (0 + ((((2 * ell * (cos (theta t))) + (- (ell * (cos (theta t))))) * (N_f t)) + (- ((0 + (- (ell * (sin (theta t))))) * 0)) + 0)).
Definition force'N_f'ladder'3 : Prop := forall t : R, ta < t < tb -> (tau_cm_N_f t) = (ell * (N_f t) * (cos (theta t))).
Definition force'N_f'ladder'd4 : Prop := forall t : R, ta < t < tb -> (tau_O_N_f t) = (0 + ((((2 * ell * (cos (theta t))) + (- 0)) * (N_f t)) + (- ((0 + (- 0)) * 0)) + 0)).
Definition force'N_f'ladder'4 : Prop := forall t : R, ta < t < tb -> (tau_O_N_f t) = (2 * ell * (N_f t) * (cos (theta t))).
Definition torque'crossing'ladder'd1 : Prop := forall t : R, ta < t < tb -> (tau_C t) = (0 + ((((ell * (cos (theta t))) + (- (2 * ell * (cos (theta t))))) * (- (M * g))) + (- (((ell * (sin (theta t))) + (- (2 * ell * (sin (theta t))))) * 0)) + 0) + ((((2 * ell * (cos (theta t))) + (- (2 * ell * (cos (theta t))))) * 0) + (- ((0 + (- (2 * ell * (sin (theta t))))) * ((- (2 * ell * (cos (theta t)) * k)) + (2 * ell * (cos theta_0) * k)))) + 0) + (((0 + (- (2 * ell * (cos (theta t))))) * 0) + (- (((2 * ell * (sin (theta t))) + (- (2 * ell * (sin (theta t))))) * (N_w t))) + 0) + ((((2 * ell * (cos (theta t))) + (- (2 * ell * (cos (theta t))))) * (N_f t)) + (- ((0 + (- (2 * ell * (sin (theta t))))) * 0)) + 0)).
Definition torque'crossing'ladder'1 : Prop := forall t : R, ta < t < tb -> (tau_C t) = ((M * g * ell * (cos (theta t))) + (4 * k * (ell ^ 2) * ((cos theta_0) + (- (cos (theta t)))) * (sin (theta t)))).
Definition law'force'ladder'd1 : Prop := forall t : R, ta < t < tb -> ((- (ell * M * (sin (theta t)) * (theta_ddot t))) + (- (ell * M * (cos (theta t)) * ((theta_dot t) ^ 2))) + (2 * ell * (cos (theta t)) * k) + (- (2 * ell * (cos theta_0) * k)) + (- (N_w t))) = 0.
Definition law'force'ladder'd2 : Prop := forall t : R, ta < t < tb -> ((ell * M * (cos (theta t)) * (theta_ddot t)) + (- (ell * M * (sin (theta t)) * ((theta_dot t) ^ 2))) + (M * g) + (- (N_f t))) = 0.
Definition law'torque'ladder'd1 : Prop := forall t : R, ta < t < tb -> ((- (((ell ^ 2) * M * (theta_ddot t)) / 3)) + (2 * (ell ^ 2) * (cos (theta t)) * (sin (theta t)) * k) + (- (2 * (ell ^ 2) * (cos theta_0) * (sin (theta t)) * k)) + (ell * (sin (theta t)) * (N_w t)) + (- (ell * (cos (theta t)) * (N_f t)))) = 0.
Definition balance'ladder'1 : Prop := forall t : R, ta < t < tb -> ((- (M * (ell ^ 2) * (theta_ddot t))) + (- (((M * (ell ^ 2)) / 3) * (theta_ddot t)))) = (ell * ((M * g * (cos (theta t))) + (4 * k * ell * ((cos theta_0) + (- (cos (theta t)))) * (sin (theta t))))).
Definition motion'theta'1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (theta_dot t)) t ((theta_ddot t)).
Definition motion'theta'2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (theta_dot t)) t (((((3 * k) / M) * ((cos (theta t)) + (- (cos theta_0))) * (sin (theta t))) + (- (((3 * g) / (4 * ell)) * (cos (theta t)))))).
Definition motion'theta'3 : Prop := forall t : R, ta < t < tb -> (theta_ddot t) = ((((3 * k) / M) * ((cos (theta t)) + (- (cos theta_0))) * (sin (theta t))) + (- (((3 * g) / (4 * ell)) * (cos (theta t))))).
Definition free_body'ladder'1 : Prop := forall t : R, ta < t < tb -> (- (M * ell * (((theta_ddot t) * (sin (theta t))) + (((theta_dot t) ^ 2) * (cos (theta t)))))) = ((2 * k * ell * ((cos theta_0) + (- (cos (theta t))))) + (N_w t)).
Definition free_body'ladder'2 : Prop := forall t : R, ta < t < tb -> (M * ell * (((theta_ddot t) * (cos (theta t))) + (- (((theta_dot t) ^ 2) * (sin (theta t)))))) = ((N_f t) + (- (M * g))).
Definition free_body'ladder'3 : Prop := forall t : R, ta < t < tb -> (- (((M * (ell ^ 2)) / 3) * (theta_ddot t))) = ((2 * k * (ell ^ 2) * ((cos theta_0) + (- (cos (theta t)))) * (sin (theta t))) + (- (ell * (N_w t) * (sin (theta t)))) + (ell * (N_f t) * (cos (theta t)))).
Definition reaction'N_w'1 : Prop := forall t : R, ta < t < tb -> (N_w t) = ((3 * k * ell * ((sin (theta t)) ^ 2) * (cos theta_0)) + (- (M * ell * ((theta_dot t) ^ 2) * (cos (theta t)))) + (- (3 * k * ell * ((sin (theta t)) ^ 2) * (cos (theta t)))) + (((3 * M * g) / 4) * (sin (theta t)) * (cos (theta t))) + (2 * k * ell * (cos (theta t))) + (- (2 * k * ell * (cos theta_0)))).
Definition reaction'N_f'1 : Prop := forall t : R, ta < t < tb -> (N_f t) = ((M * g) + (- (M * ell * ((theta_dot t) ^ 2) * (sin (theta t)))) + (3 * k * ell * (sin (theta t)) * ((cos (theta t)) ^ 2)) + (- (3 * k * ell * (sin (theta t)) * (cos (theta t)) * (cos theta_0))) + (- (((3 * M * g) / 4) * ((cos (theta t)) ^ 2)))).
Definition motion'from_newton'theta'1 : Prop := forall t : R, ta < t < tb -> (theta_ddot t) = ((((3 * k) / M) * ((cos (theta t)) + (- (cos theta_0))) * (sin (theta t))) + (- (((3 * g) / (4 * ell)) * (cos (theta t))))).
Definition work'W'ladder'd1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_x t)) t ((R_cm_x' t)).
Definition work'W'ladder'd2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_y t)) t ((R_cm_y' t)).
Definition work'W'ladder'd3 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_W_T_W t)) t ((((W_x t) * (R_cm_x' t)) + ((W_y t) * (R_cm_y' t)))).
Definition work'W'ladder'd4 : Prop := (cal_W_T_W 0) = 0.
Definition start'theta'd1 : Prop := (theta 0) = theta_0.
Definition work'W'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_W t) = (- (RInt (fun x : R => (M * g * ell * (cos x))) theta_0 (theta t))).
Definition work'W'ladder'd6 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_W_theta_W t)) t (((tau_cm_W t) * (varphi_ladder' t))).
Definition work'W'ladder'd7 : Prop := (cal_W_theta_W 0) = 0.
Definition work'W'ladder'2 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_W t) = 0.
Definition work'F_s'ladder'd1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_x t)) t ((R_cm_x' t)).
Definition work'F_s'ladder'd2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_y t)) t ((R_cm_y' t)).
Definition work'F_s'ladder'd3 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_W_T_F_s t)) t ((((F_s_x t) * (R_cm_x' t)) + ((F_s_y t) * (R_cm_y' t)))).
Definition work'F_s'ladder'd4 : Prop := (cal_W_T_F_s 0) = 0.
Definition work'F_s'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_F_s t) = (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)).
Definition work'F_s'ladder'd5 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (varphi_ladder t)) t ((varphi_ladder' t)).
Definition work'F_s'ladder'd6 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_W_theta_F_s t)) t (((tau_cm_F_s t) * (varphi_ladder' t))).
Definition work'F_s'ladder'd7 : Prop := (cal_W_theta_F_s 0) = 0.
Definition def'varphi_ladder'd1 : Prop := forall t : R, ta < t < tb -> (varphi_ladder t) = (PI + (- (theta t))).
Definition work'F_s'ladder'2 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_F_s t) = (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)).
Definition work'N_w'ladder'd1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_x t)) t ((R_cm_x' t)).
Definition work'N_w'ladder'd2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_y t)) t ((R_cm_y' t)).
Definition work'N_w'ladder'd3 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_W_T_N_w t)) t ((((N_w_x t) * (R_cm_x' t)) + ((N_w_y t) * (R_cm_y' t)))).
Definition work'N_w'ladder'd4 : Prop := (cal_W_T_N_w 0) = 0.
Definition work'N_w'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_N_w t) = (- (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t)).
Definition work'N_w'ladder'd5 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (varphi_ladder t)) t ((varphi_ladder' t)).
Definition work'N_w'ladder'd6 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_W_theta_N_w t)) t (((tau_cm_N_w t) * (varphi_ladder' t))).
Definition work'N_w'ladder'd7 : Prop := (cal_W_theta_N_w 0) = 0.
Definition work'N_w'ladder'2 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_N_w t) = (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t).
Definition work'N_f'ladder'd1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_x t)) t ((R_cm_x' t)).
Definition work'N_f'ladder'd2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_y t)) t ((R_cm_y' t)).
Definition work'N_f'ladder'd3 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_W_T_N_f t)) t ((((N_f_x t) * (R_cm_x' t)) + ((N_f_y t) * (R_cm_y' t)))).
Definition work'N_f'ladder'd4 : Prop := (cal_W_T_N_f 0) = 0.
Definition work'N_f'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_N_f t) = (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t).
Definition work'N_f'ladder'd5 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (varphi_ladder t)) t ((varphi_ladder' t)).
Definition work'N_f'ladder'd6 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_W_theta_N_f t)) t (((tau_cm_N_f t) * (varphi_ladder' t))).
Definition work'N_f'ladder'd7 : Prop := (cal_W_theta_N_f 0) = 0.
Definition work'N_f'ladder'2 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_N_f t) = (- (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t)).
Definition workless'N_w'1 : Prop := forall t : R, ta < t < tb -> ((cal_W_T_N_w t) + (cal_W_theta_N_w t)) = 0.
Definition workless'N_f'1 : Prop := forall t : R, ta < t < tb -> ((cal_W_T_N_f t) + (cal_W_theta_N_f t)) = 0.
Definition spring'F_s'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_F_s t) = (cal_W_theta_F_s t).
Definition def'l_0'd1 : Prop := forall t : R, ta < t < tb -> l_0 = (2 * ell * (cos theta_0)).
Definition spring'F_s'2 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_F_s t) = (RInt (fun x : R => (k * ((2 * ell * (cos x)) + (- l_0)) * ell * (sin x))) theta_0 (theta t)).
Definition spring'done'F_s'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_F_s t) = (cal_W_theta_F_s t).
Definition spring'done'F_s'2 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_F_s t) = (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2))).
Definition theorem'T'ladder'1 : Prop := forall t : R, ta < t < tb -> ((cal_W_T_W t) + (cal_W_T_F_s t) + (cal_W_T_N_w t) + (cal_W_T_N_f t)) = (((1 / 2) * M * (((V_cm_x t) * (V_cm_x t)) + ((V_cm_y t) * (V_cm_y t)))) + (- ((1 / 2) * M * (((V_cm_x 0) * (V_cm_x 0)) + ((V_cm_y 0) * (V_cm_y 0)))))).
Definition theorem'theta'ladder'1 : Prop := forall t : R, ta < t < tb -> ((cal_W_theta_F_s t) + (cal_W_theta_N_w t) + (cal_W_theta_N_f t)) = (((1 / 2) * I_cm * ((omega_ladder t) ^ 2)) + (- ((1 / 2) * I_cm * ((omega_ladder 0) ^ 2)))).
Definition theorem'whole'1 : Prop := forall t : R, ta < t < tb -> ((cal_W_T_W t) + (cal_W_T_F_s t) + (cal_W_theta_F_s t)) = (((2 / 3) * M * (ell ^ 2) * ((theta_dot t) ^ 2)) + (- ((2 / 3) * M * (ell ^ 2) * ((theta_dot 0) ^ 2)))).
Definition together'T'd1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_x t)) t ((R_cm_x' t)).
Definition together'T'd2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (R_cm_y t)) t ((R_cm_y' t)).
Definition together'T'd3 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_W_T t)) t (((((N_w_x t) + (N_f_x t) + (W_x t) + (F_s_x t)) * (R_cm_x' t)) + (((N_w_y t) + (N_f_y t) + (W_y t) + (F_s_y t)) * (R_cm_y' t)))).
Definition together'T'd4 : Prop := (cal_W_T 0) = 0.
Definition together'T'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T t) = (RInt (fun u : R => ((((ell * ((N_w u) + (2 * k * ell * ((cos theta_0) + (- (cos (theta u))))))) * (- (sin (theta u)))) + ((ell * ((N_f u) + (- (M * g)))) * (cos (theta u)))) * (theta_dot u))) 0 t).
Definition together'T'2 : Prop := forall t : R, ta < t < tb -> (RInt (fun u : R => ((((ell * ((N_w u) + (2 * k * ell * ((cos theta_0) + (- (cos (theta u))))))) * (- (sin (theta u)))) + ((ell * ((N_f u) + (- (M * g)))) * (cos (theta u)))) * (theta_dot u))) 0 t) = ((RInt (fun u : R => ((ell * ((- ((N_w u) * (sin (theta u)))) + ((N_f u) * (cos (theta u))))) * (theta_dot u))) 0 t) + (- (M * g * ell * ((sin (theta t)) + (- (sin theta_0))))) + (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))).
Definition def'cal_w_c'd1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (cal_w_c t)) t (((- (ell * (sin (theta t)) * (theta_dot t) * (N_w t))) + (ell * (cos (theta t)) * (theta_dot t) * (N_f t)))).
Definition def'cal_w_c'd2 : Prop := (cal_w_c 0) = 0.
Definition together'T'3 : Prop := forall t : R, ta < t < tb -> ((RInt (fun u : R => ((ell * ((- ((N_w u) * (sin (theta u)))) + ((N_f u) * (cos (theta u))))) * (theta_dot u))) 0 t) + (- (M * g * ell * ((sin (theta t)) + (- (sin theta_0))))) + (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))) = ((cal_w_c t) + (- (M * g * ell * ((sin (theta t)) + (- (sin theta_0))))) + (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))).
Definition start'theta'd2 : Prop := (theta_dot 0) = 0.
Definition together'T'4 : Prop := forall t : R, ta < t < tb -> ((cal_w_c t) + (- (M * g * ell * ((sin (theta t)) + (- (sin theta_0))))) + (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))) = ((1 / 2) * M * (((V_cm_x t) * (V_cm_x t)) + ((V_cm_y t) * (V_cm_y t)))).
Definition together'solved'1 : Prop := forall t : R, ta < t < tb -> (cal_w_c t) = (((1 / 2) * M * (((V_cm_x t) * (V_cm_x t)) + ((V_cm_y t) * (V_cm_y t)))) + (M * g * ell * ((sin (theta t)) + (- (sin theta_0)))) + (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2))).
Definition together'theta'd1 : Prop := forall t : R, ta < t < tb -> (cal_W_theta t) = ((RInt (fun u : R => ((ell * (((N_w u) * (sin (theta u))) + (- ((N_f u) * (cos (theta u)))))) * (theta_dot u))) 0 t) + (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))).
Definition together'theta'1 : Prop := forall t : R, ta < t < tb -> (cal_W_theta t) = ((RInt (fun u : R => ((ell * (((N_w u) * (sin (theta u))) + (- ((N_f u) * (cos (theta u)))))) * (theta_dot u))) 0 t) + (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))).
Definition together'theta'2 : Prop := forall t : R, ta < t < tb -> ((RInt (fun u : R => ((ell * (((N_w u) * (sin (theta u))) + (- ((N_f u) * (cos (theta u)))))) * (theta_dot u))) 0 t) + (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))) = ((- (cal_w_c t)) + (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))).
Definition together'turned'1 : Prop := forall t : R, ta < t < tb -> ((- (cal_w_c t)) + (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))) = ((1 / 6) * M * (ell ^ 2) * ((theta_dot t) ^ 2)).
Definition def'E'd1 : Prop := forall t : R, ta < t < tb -> (E_ t) = (((2 * (ell ^ 2) * M * ((theta_dot t) ^ 2)) / 3) + (ell * M * (sin (theta t)) * g) + (2 * (ell ^ 2) * ((cos (theta t)) ^ 2) * k) + (- (4 * (ell ^ 2) * (cos theta_0) * (cos (theta t)) * k)) + (2 * (ell ^ 2) * ((cos theta_0) ^ 2) * k)).
Definition together'energy'1 : Prop := forall t : R, ta < t < tb -> (((1 / 6) * M * (ell ^ 2) * ((theta_dot t) ^ 2)) + ((1 / 2) * M * (((V_cm_x t) * (V_cm_x t)) + ((V_cm_y t) * (V_cm_y t)))) + (M * g * ell * (sin (theta t))) + (2 * k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2))) = (E_ t).
Definition together'energy'2 : Prop := forall t : R, ta < t < tb -> (E_ t) = (E_ 0).
Definition motion'from_work'1 : Prop := forall t : R, ta < t < tb -> (theta_dot t) <> 0 -> (theta_ddot t) = ((((3 * k) / M) * ((cos (theta t)) + (- (cos theta_0))) * (sin (theta t))) + (- (((3 * g) / (4 * ell)) * (cos (theta t))))).
Definition kinetic'd1 : Prop := forall t : R, ta < t < tb -> (K t) = (((1 / 2) * M * (((V_cm_x t) * (V_cm_x t)) + ((V_cm_y t) * (V_cm_y t)))) + ((1 / 2) * I_cm * ((omega_ladder t) ^ 2))).
Definition kinetic'1 : Prop := forall t : R, ta < t < tb -> (K t) = (((1 / 2) * M * (((V_cm_x t) * (V_cm_x t)) + ((V_cm_y t) * (V_cm_y t)))) + ((1 / 2) * I_cm * ((omega_ladder t) ^ 2))).
Definition kinetic'2 : Prop := forall t : R, ta < t < tb -> (((1 / 2) * M * (((V_cm_x t) * (V_cm_x t)) + ((V_cm_y t) * (V_cm_y t)))) + ((1 / 2) * I_cm * ((omega_ladder t) ^ 2))) = (((1 / 2) * M * (ell ^ 2) * ((theta_dot t) ^ 2)) + ((1 / 6) * M * (ell ^ 2) * ((theta_dot t) ^ 2))).
Definition kinetic'3 : Prop := forall t : R, ta < t < tb -> (((1 / 2) * M * (ell ^ 2) * ((theta_dot t) ^ 2)) + ((1 / 6) * M * (ell ^ 2) * ((theta_dot t) ^ 2))) = ((2 / 3) * M * (ell ^ 2) * ((theta_dot t) ^ 2)).
Definition potential'W'd1 : Prop := forall t : R, ta < t < tb -> (U_W t) = (ell * M * (sin (theta t)) * g).
Definition potential'W'1 : Prop := forall t : R, ta < t < tb -> (U_W t) = (M * g * ell * (sin (theta t))).
Definition potential'W'2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (U_W t)) t ((ell * M * (cos (theta t)) * (theta_dot t) * g)).
Definition potential'F_s'd1 : Prop := forall t : R, ta < t < tb -> (U_F_s t) = ((2 * (ell ^ 2) * ((cos (theta t)) ^ 2) * k) + (- (4 * (ell ^ 2) * (cos theta_0) * (cos (theta t)) * k)) + (2 * (ell ^ 2) * ((cos theta_0) ^ 2) * k)).
Definition potential'F_s'1 : Prop := forall t : R, ta < t < tb -> (U_F_s t) = (2 * k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)).
Definition potential'F_s'2 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (U_F_s t)) t (((- (4 * (ell ^ 2) * (cos (theta t)) * (sin (theta t)) * (theta_dot t) * k)) + (4 * (ell ^ 2) * (cos theta_0) * (sin (theta t)) * (theta_dot t) * k))).
Definition split'F_s'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_F_s t) = (cal_W_theta_F_s t).
Definition split'F_s'2 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_F_s t) = (- ((1 / 2) * ((U_F_s t) + (- (U_F_s 0))))).
Definition energy'1 : Prop := forall t : R, ta < t < tb -> (E_ t) = ((K t) + (U_W t) + (U_F_s t)).
Definition energy'2 : Prop := forall t : R, ta < t < tb -> ((K t) + (U_W t) + (U_F_s t)) = (((2 / 3) * M * (ell ^ 2) * ((theta_dot t) ^ 2)) + (M * g * ell * (sin (theta t))) + (2 * k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2))).
Definition energy'3 : Prop := forall t : R, ta < t < tb -> (E_ t) = (E_ 0).
Definition square'theta'1 : Prop := forall t : R, ta < t < tb -> ((theta_dot t) ^ 2) = ((((3 * g) / (2 * ell)) * ((sin theta_0) + (- (sin (theta t))))) + (- (((3 * k) / M) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))).
Definition energy'rate'1 : Prop := forall t : R, ta < t < tb -> is_derive (fun t : R => (E_ t)) t (((theta_dot t) * ((((4 * M * (ell ^ 2)) / 3) * (theta_ddot t)) + (ell * ((M * g * (cos (theta t))) + (4 * k * ell * ((cos theta_0) + (- (cos (theta t)))) * (sin (theta t)))))))).
Definition energy'rate'2 : Prop := forall t : R, ta < t < tb -> ((theta_dot t) * ((((4 * M * (ell ^ 2)) / 3) * (theta_ddot t)) + (ell * ((M * g * (cos (theta t))) + (4 * k * ell * ((cos theta_0) + (- (cos (theta t)))) * (sin (theta t))))))) = 0.
Definition motion'from_energy'1 : Prop := forall t : R, ta < t < tb -> (theta_dot t) <> 0 -> (theta_ddot t) = ((((3 * k) / M) * ((cos (theta t)) + (- (cos theta_0))) * (sin (theta t))) + (- (((3 * g) / (4 * ell)) * (cos (theta t))))).
Definition along'N_w'1 : Prop := forall t : R, ta < t < tb -> (N_w t) = ((((3 * M * g) / 4) * ((3 * (sin (theta t))) + (- (2 * (sin theta_0)))) * (cos (theta t))) + (k * ell * ((cos theta_0) + (- (cos (theta t)))) * (1 + (- (6 * ((cos (theta t)) ^ 2))) + (3 * (cos (theta t)) * (cos theta_0))))).
Definition along'N_f'1 : Prop := forall t : R, ta < t < tb -> (N_f t) = ((((M * g) / 4) * (10 + (- (6 * (sin (theta t)) * (sin theta_0))) + (- (9 * ((cos (theta t)) ^ 2))))) + (3 * k * ell * ((cos theta_0) + (- (2 * (cos (theta t))))) * ((cos theta_0) + (- (cos (theta t)))) * (sin (theta t)))).
Definition asks'N_w'1 : Prop := forall t : R, ta < t < tb -> (N_w t) = ((1 / 4) * ((3 * M * g * ((3 * (sin (theta t))) + (- (2 * (sin theta_0)))) * (cos (theta t))) + (4 * k * ell * ((cos theta_0) + (- (cos (theta t)))) * (1 + (- (6 * ((cos (theta t)) ^ 2))) + (3 * (cos (theta t)) * (cos theta_0)))))).
Definition asks'N_w'2 : Prop := forall t : R, ta < t < tb -> 0 < (1 / 4).
Definition asks'N_f'1 : Prop := forall t : R, ta < t < tb -> (N_f t) = ((1 / 4) * ((M * g * (10 + (- (6 * (sin (theta t)) * (sin theta_0))) + (- (9 * ((cos (theta t)) ^ 2))))) + (12 * k * ell * ((cos theta_0) + (- (2 * (cos (theta t))))) * ((cos theta_0) + (- (cos (theta t)))) * (sin (theta t))))).
Definition asks'N_f'2 : Prop := forall t : R, ta < t < tb -> 0 < (1 / 4).
Definition done'T'W'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_W t) = (M * g * ell * ((sin theta_0) + (- (sin (theta t))))).
Definition done'T'F_s'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_F_s t) = (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2))).
Definition done'theta'F_s'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_F_s t) = (- (k * (ell ^ 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2))).
Definition done'T'N_w'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_N_w t) = (ell * ((((3 * M * g) / 4) * ((sin theta_0) + (- (sin (theta t)))) * ((sin (theta t)) ^ 2)) + (((k * ell) / 2) * ((3 * ((cos (theta t)) ^ 2)) + (- 1)) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))).
Definition done'theta'N_w'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_N_w t) = (ell * ((((3 * M * g) / 4) * ((sin (theta t)) + (- (sin theta_0))) * ((sin (theta t)) ^ 2)) + (((k * ell) / 2) * (1 + (- (3 * ((cos (theta t)) ^ 2)))) * (((cos (theta t)) + (- (cos theta_0))) ^ 2)))).
Definition done'T'N_f'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_T_N_f t) = (ell * ((((M * g) / 4) * ((3 * ((cos (theta t)) ^ 2)) + (- 4)) * ((sin theta_0) + (- (sin (theta t))))) + (- (((3 * k * ell) / 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2) * ((cos (theta t)) ^ 2))))).
Definition done'theta'N_f'ladder'1 : Prop := forall t : R, ta < t < tb -> (cal_W_theta_N_f t) = (ell * ((((M * g) / 4) * (4 + (- (3 * ((cos (theta t)) ^ 2)))) * ((sin theta_0) + (- (sin (theta t))))) + (((3 * k * ell) / 2) * (((cos (theta t)) + (- (cos theta_0))) ^ 2) * ((cos (theta t)) ^ 2)))).
Definition law'motion'd1 : Prop := forall t : R, ta < t < tb -> ((- (ell * M * (sin (theta t)) * (theta_ddot t))) + (- (ell * M * (cos (theta t)) * ((theta_dot t) ^ 2))) + (2 * ell * (cos (theta t)) * k) + (- (2 * ell * (cos theta_0) * k)) + (- (N_w t))) = 0.
Definition law'motion'd2 : Prop := forall t : R, ta < t < tb -> ((ell * M * (cos (theta t)) * (theta_ddot t)) + (- (ell * M * (sin (theta t)) * ((theta_dot t) ^ 2))) + (M * g) + (- (N_f t))) = 0.
Definition law'motion'd3 : Prop := forall t : R, ta < t < tb -> ((- (((ell ^ 2) * M * (theta_ddot t)) / 3)) + (2 * (ell ^ 2) * (cos (theta t)) * (sin (theta t)) * k) + (- (2 * (ell ^ 2) * (cos theta_0) * (sin (theta t)) * k)) + (ell * (sin (theta t)) * (N_w t)) + (- (ell * (cos (theta t)) * (N_f t)))) = 0.
Definition balance'1 : Prop := forall t : R, ta < t < tb -> (theta_ddot t) = 0 -> ((4 * k * ell * (sin (theta t)) * (cos theta_0)) + (M * g * (cos (theta t)))) = (4 * k * ell * (sin (theta t)) * (cos (theta t))).
Lemma condition'N_w'1'holds : condition'N_w'1.
Proof. unfold condition'N_w'1;
  intros t Ht; apply lin0; fld. Qed.
Lemma condition'N_f'1'holds : condition'N_f'1.
Proof. unfold condition'N_f'1;
  intros t Ht; apply lin0; fld. Qed.
Lemma position'ladder'1'holds : position'ladder'd1 -> position'ladder'1.
Proof. unfold position'ladder'1, position'ladder'd1;
  intros p_position'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_position'ladder'd1 t Ht)); fld. Qed.
Lemma position'ladder'2'holds : position'ladder'd2 -> position'ladder'2.
Proof. unfold position'ladder'2, position'ladder'd2;
  intros p_position'ladder'd2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_position'ladder'd2 t Ht)); fld. Qed.
Lemma circle'ladder'1'holds : def'y_cm'd1 -> def'x_cm'd1 -> circle'ladder'1.
Proof. unfold circle'ladder'1, def'y_cm'd1, def'x_cm'd1;
  intros p_def'y_cm'd1;
  intros p_def'x_cm'd1;
  intros t Ht; apply lin0; apply (less ((y_cm t) + (ell * (sin (theta t)))) _ _ (p_def'y_cm'd1 t Ht)); apply (less ((x_cm t) + (ell * (cos (theta t)))) _ _ (p_def'x_cm'd1 t Ht)); apply (less (ell ^ 2) _ _ (trig (theta t))); fld. Qed.
Lemma turning'ladder'1'holds : turning'ladder'd1 -> turning'ladder'1.
Proof. unfold turning'ladder'1, turning'ladder'd1;
  intros p_turning'ladder'd1;
  assert (q1 : forall t : R, ta < t < tb -> (omega_ladder t) = (- (theta_dot t))) by (intros t Ht; apply (alone _ t _ _ (p_turning'ladder'd1 t Ht)); clear p_turning'ladder'd1; eapply D_eq; [der | fld]);
  clear p_turning'ladder'd1;
  intros t Ht; apply (alike ta tb _ (fun t : R => (PI + (- (theta t))))); [intros u Hu; apply lin0; fld | exact Ht |]; eapply D_eq; [der | apply lin0; apply (less (- 1) _ _ (q1 t Ht)); fld]. Qed.
Lemma turning'ladder'2'holds : turning'ladder'2.
Proof. unfold turning'ladder'2;
  intros t Ht; apply (alike ta tb _ (fun t : R => (PI + (- (theta t))))); [intros u Hu; apply lin0; fld | exact Ht |]; eapply D_eq; [der | apply lin0; fld]. Qed.
Lemma turning'ladder'3'holds : turning'ladder'd1 -> turning'ladder'3.
Proof. unfold turning'ladder'3, turning'ladder'd1;
  intros p_turning'ladder'd1;
  assert (q1 : forall t : R, ta < t < tb -> (omega_ladder t) = (- (theta_dot t))) by (intros t Ht; apply (alone _ t _ _ (p_turning'ladder'd1 t Ht)); clear p_turning'ladder'd1; eapply D_eq; [der | fld]);
  clear p_turning'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (q1 t Ht)); fld. Qed.
Lemma velocity'ladder'1'holds : velocity'ladder'd1 -> position'ladder'd1 -> velocity'ladder'1.
Proof. unfold velocity'ladder'1, velocity'ladder'd1, position'ladder'd1;
  intros p_velocity'ladder'd1;
  intros p_position'ladder'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((V_cm_x t) + (ell * (theta_dot t) * (sin (theta t)))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_x u) + (- (ell * (cos (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd1 u Hu)); fld | exact Ht | eapply D_eq; [der | fld]]);
  intros t Ht; apply (alike ta tb _ (fun t : R => (ell * (cos (theta t))))); [intros u Hu; apply lin0; apply (less 1 _ _ (p_position'ladder'd1 u Hu)); fld | exact Ht |]; eapply D_eq; [der | apply lin0; apply (less (- 1) _ _ (q1 t Ht)); fld]. Qed.
Lemma velocity'ladder'2'holds : velocity'ladder'd2 -> position'ladder'd2 -> velocity'ladder'2.
Proof. unfold velocity'ladder'2, velocity'ladder'd2, position'ladder'd2;
  intros p_velocity'ladder'd2;
  intros p_position'ladder'd2;
  assert (q2 : forall t : R, ta < t < tb -> ((V_cm_y t) + (- (ell * (theta_dot t) * (cos (theta t))))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_y u) + (- (ell * (sin (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd2 u Hu)); fld | exact Ht | eapply D_eq; [der | fld]]);
  intros t Ht; apply (alike ta tb _ (fun t : R => (ell * (sin (theta t))))); [intros u Hu; apply lin0; apply (less 1 _ _ (p_position'ladder'd2 u Hu)); fld | exact Ht |]; eapply D_eq; [der | apply lin0; apply (less (- 1) _ _ (q2 t Ht)); fld]. Qed.
Lemma velocity'ladder'3'holds : position'ladder'd1 -> velocity'ladder'3.
Proof. unfold velocity'ladder'3, position'ladder'd1;
  intros p_position'ladder'd1;
  intros t Ht; apply (alike ta tb _ (fun t : R => (ell * (cos (theta t))))); [intros u Hu; apply lin0; apply (less 1 _ _ (p_position'ladder'd1 u Hu)); fld | exact Ht |]; eapply D_eq; [der | apply lin0; fld]. Qed.
Lemma velocity'ladder'4'holds : position'ladder'd2 -> velocity'ladder'4.
Proof. unfold velocity'ladder'4, position'ladder'd2;
  intros p_position'ladder'd2;
  intros t Ht; apply (alike ta tb _ (fun t : R => (ell * (sin (theta t))))); [intros u Hu; apply lin0; apply (less 1 _ _ (p_position'ladder'd2 u Hu)); fld | exact Ht |]; eapply D_eq; [der | apply lin0; fld]. Qed.
Lemma velocity'ladder'5'holds : velocity'ladder'd1 -> position'ladder'd1 -> velocity'ladder'5.
Proof. unfold velocity'ladder'5, velocity'ladder'd1, position'ladder'd1;
  intros p_velocity'ladder'd1;
  intros p_position'ladder'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((V_cm_x t) + (ell * (theta_dot t) * (sin (theta t)))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_x u) + (- (ell * (cos (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd1 u Hu)); fld | exact Ht | eapply D_eq; [der | fld]]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q1 t Ht)); fld. Qed.
Lemma velocity'ladder'6'holds : velocity'ladder'd2 -> position'ladder'd2 -> velocity'ladder'6.
Proof. unfold velocity'ladder'6, velocity'ladder'd2, position'ladder'd2;
  intros p_velocity'ladder'd2;
  intros p_position'ladder'd2;
  assert (q2 : forall t : R, ta < t < tb -> ((V_cm_y t) + (- (ell * (theta_dot t) * (cos (theta t))))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_y u) + (- (ell * (sin (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd2 u Hu)); fld | exact Ht | eapply D_eq; [der | fld]]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q2 t Ht)); fld. Qed.
Lemma speed'ladder'1'holds : velocity'ladder'5 -> velocity'ladder'6 -> speed'ladder'1.
Proof. unfold speed'ladder'1, velocity'ladder'5, velocity'ladder'6;
  intros p_velocity'ladder'5;
  intros p_velocity'ladder'6;
  intros t Ht; apply lin0; apply (less ((V_cm_y t) + (ell * (theta_dot t) * (cos (theta t)))) _ _ (p_velocity'ladder'6 t Ht)); apply (less ((V_cm_x t) + (- (ell * (theta_dot t) * (sin (theta t))))) _ _ (p_velocity'ladder'5 t Ht)); apply (less ((ell ^ 2) * ((theta_dot t) ^ 2)) _ _ (trig (theta t))); fld. Qed.
Lemma moment'ladder'1'holds : moment'ladder'd1 -> moment'ladder'1.
Proof. unfold moment'ladder'1, moment'ladder'd1;
  intros p_moment'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_moment'ladder'd1 t Ht)); fld. Qed.
Lemma moment'ladder'2'holds : moment'ladder'2.
Proof. unfold moment'ladder'2;
  assert (q1 : forall t : R, ta < t < tb -> (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell)) = ((2 * (ell ^ 3)) / 3)) by (intros t Ht; apply (RInt_by (fun x : R => (((x ^ 3) / 3) + (- (ell * (x ^ 2))) + ((ell ^ 2) * x)))); [intros; eapply D_eq; [der | fld] | intros; cont | cbv beta; fld]);
  intros t Ht; apply lin0; apply (less (((/ (ell ^ 1)) * M) / 2) _ _ (q1 t Ht)); fld. Qed.
Lemma momentum'ladder'O'1'holds : momentum'ladder'O'd1 -> momentum'ladder'O'1.
Proof. unfold momentum'ladder'O'1, momentum'ladder'O'd1;
  intros p_momentum'ladder'O'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_momentum'ladder'O'd1 t Ht)); fld. Qed.
Lemma momentum'ladder'O'2'holds : position'ladder'd1 -> position'ladder'd2 -> moment'ladder'd1 -> moment'ladder'2 -> turning'ladder'3 -> def'P_cm'd1 -> def'P_cm'd2 -> momentum'ladder'O'2.
Proof. unfold momentum'ladder'O'2, position'ladder'd1, position'ladder'd2, moment'ladder'd1, moment'ladder'2, turning'ladder'3, def'P_cm'd1, def'P_cm'd2;
  intros p_position'ladder'd1;
  intros p_position'ladder'd2;
  intros p_moment'ladder'd1;
  intros p_moment'ladder'2;
  intros p_turning'ladder'3;
  intros p_def'P_cm'd1;
  intros p_def'P_cm'd2;
  intros t Ht; apply lin0; apply (less (R_cm_x t) _ _ (p_def'P_cm'd2 t Ht)); apply (less (- (R_cm_y t)) _ _ (p_def'P_cm'd1 t Ht)); apply (less (omega_ladder t) _ _ (p_moment'ladder'd1 t Ht)); apply (less (((/ (ell ^ 1)) * M * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell))) / 2) _ _ (p_turning'ladder'3 t Ht)); apply (less (ell * M * (theta_dot t) * (sin (theta t))) _ _ (p_position'ladder'd2 t Ht)); apply (less (ell * M * (theta_dot t) * (cos (theta t))) _ _ (p_position'ladder'd1 t Ht)); apply (less (- (theta_dot t)) _ _ (p_moment'ladder'2 t Ht)); apply (less ((ell ^ 2) * M * (theta_dot t)) _ _ (trig (theta t))); fld. Qed.
Lemma momentum'ladder'O'3'holds : momentum'ladder'O'3.
Proof. unfold momentum'ladder'O'3;
  intros t Ht; apply lin0; fld. Qed.
Lemma force'W'ladder'1'holds : force'W'ladder'd1 -> force'W'ladder'1.
Proof. unfold force'W'ladder'1, force'W'ladder'd1;
  intros p_force'W'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'W'ladder'd1 t Ht)); fld. Qed.
Lemma force'W'ladder'2'holds : force'W'ladder'd2 -> force'W'ladder'2.
Proof. unfold force'W'ladder'2, force'W'ladder'd2;
  intros p_force'W'ladder'd2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'W'ladder'd2 t Ht)); fld. Qed.
Lemma force'W'ladder'3'holds : force'W'ladder'd3 -> force'W'ladder'3.
Proof. unfold force'W'ladder'3, force'W'ladder'd3;
  intros p_force'W'ladder'd3;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'W'ladder'd3 t Ht)); fld. Qed.
Lemma force'W'ladder'4'holds : force'W'ladder'd4 -> force'W'ladder'4.
Proof. unfold force'W'ladder'4, force'W'ladder'd4;
  intros p_force'W'ladder'd4;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'W'ladder'd4 t Ht)); fld. Qed.
Lemma force'F_s'ladder'1'holds : force'F_s'ladder'd1 -> force'F_s'ladder'1.
Proof. unfold force'F_s'ladder'1, force'F_s'ladder'd1;
  intros p_force'F_s'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'F_s'ladder'd1 t Ht)); fld. Qed.
Lemma force'F_s'ladder'2'holds : force'F_s'ladder'd2 -> force'F_s'ladder'2.
Proof. unfold force'F_s'ladder'2, force'F_s'ladder'd2;
  intros p_force'F_s'ladder'd2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'F_s'ladder'd2 t Ht)); fld. Qed.
Lemma force'F_s'ladder'3'holds : force'F_s'ladder'd3 -> force'F_s'ladder'3.
Proof. unfold force'F_s'ladder'3, force'F_s'ladder'd3;
  intros p_force'F_s'ladder'd3;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'F_s'ladder'd3 t Ht)); fld. Qed.
Lemma force'F_s'ladder'4'holds : force'F_s'ladder'd4 -> force'F_s'ladder'4.
Proof. unfold force'F_s'ladder'4, force'F_s'ladder'd4;
  intros p_force'F_s'ladder'd4;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'F_s'ladder'd4 t Ht)); fld. Qed.
Lemma force'N_w'ladder'1'holds : force'N_w'ladder'd1 -> force'N_w'ladder'1.
Proof. unfold force'N_w'ladder'1, force'N_w'ladder'd1;
  intros p_force'N_w'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'N_w'ladder'd1 t Ht)); fld. Qed.
Lemma force'N_w'ladder'2'holds : force'N_w'ladder'd2 -> force'N_w'ladder'2.
Proof. unfold force'N_w'ladder'2, force'N_w'ladder'd2;
  intros p_force'N_w'ladder'd2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'N_w'ladder'd2 t Ht)); fld. Qed.
Lemma force'N_w'ladder'3'holds : force'N_w'ladder'd3 -> force'N_w'ladder'3.
Proof. unfold force'N_w'ladder'3, force'N_w'ladder'd3;
  intros p_force'N_w'ladder'd3;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'N_w'ladder'd3 t Ht)); fld. Qed.
Lemma force'N_w'ladder'4'holds : force'N_w'ladder'd4 -> force'N_w'ladder'4.
Proof. unfold force'N_w'ladder'4, force'N_w'ladder'd4;
  intros p_force'N_w'ladder'd4;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'N_w'ladder'd4 t Ht)); fld. Qed.
Lemma force'N_f'ladder'1'holds : force'N_f'ladder'd1 -> force'N_f'ladder'1.
Proof. unfold force'N_f'ladder'1, force'N_f'ladder'd1;
  intros p_force'N_f'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'N_f'ladder'd1 t Ht)); fld. Qed.
Lemma force'N_f'ladder'2'holds : force'N_f'ladder'd2 -> force'N_f'ladder'2.
Proof. unfold force'N_f'ladder'2, force'N_f'ladder'd2;
  intros p_force'N_f'ladder'd2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'N_f'ladder'd2 t Ht)); fld. Qed.
Lemma force'N_f'ladder'3'holds : force'N_f'ladder'd3 -> force'N_f'ladder'3.
Proof. unfold force'N_f'ladder'3, force'N_f'ladder'd3;
  intros p_force'N_f'ladder'd3;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'N_f'ladder'd3 t Ht)); fld. Qed.
Lemma force'N_f'ladder'4'holds : force'N_f'ladder'd4 -> force'N_f'ladder'4.
Proof. unfold force'N_f'ladder'4, force'N_f'ladder'd4;
  intros p_force'N_f'ladder'd4;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_force'N_f'ladder'd4 t Ht)); fld. Qed.
Lemma torque'crossing'ladder'1'holds : torque'crossing'ladder'd1 -> torque'crossing'ladder'1.
Proof. unfold torque'crossing'ladder'1, torque'crossing'ladder'd1;
  intros p_torque'crossing'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_torque'crossing'ladder'd1 t Ht)); fld. Qed.
Lemma balance'ladder'1'holds : law'force'ladder'd1 -> law'force'ladder'd2 -> law'torque'ladder'd1 -> balance'ladder'1.
Proof. unfold balance'ladder'1, law'force'ladder'd1, law'force'ladder'd2, law'torque'ladder'd1;
  intros p_law'force'ladder'd1;
  intros p_law'force'ladder'd2;
  intros p_law'torque'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_law'torque'ladder'd1 t Ht)); apply (less (- (ell * (cos (theta t)))) _ _ (p_law'force'ladder'd2 t Ht)); apply (less (ell * (sin (theta t))) _ _ (p_law'force'ladder'd1 t Ht)); apply (less ((ell ^ 2) * M * (theta_ddot t)) _ _ (trig (theta t))); fld. Qed.
Lemma motion'theta'1'holds : motion'theta'1.
Proof. unfold motion'theta'1;
  intros t Ht; apply (alike ta tb _ (fun t : R => (theta_dot t))); [intros u Hu; apply lin0; fld | exact Ht |]; eapply D_eq; [der | apply lin0; fld]. Qed.
Lemma motion'theta'2'holds : balance'ladder'1 -> motion'theta'2.
Proof. unfold motion'theta'2, balance'ladder'1;
  intros p_balance'ladder'1;
  intros t Ht; apply (alike ta tb _ (fun t : R => (theta_dot t))); [intros u Hu; apply lin0; fld | exact Ht |]; eapply D_eq; [der | apply lin0; apply (less (- ((3 * (/ (ell ^ 2)) * (/ (M ^ 1))) / 4)) _ _ (p_balance'ladder'1 t Ht)); fld]. Qed.
Lemma motion'theta'3'holds : balance'ladder'1 -> motion'theta'3.
Proof. unfold motion'theta'3, balance'ladder'1;
  intros p_balance'ladder'1;
  intros t Ht; apply lin0; apply (less (- ((3 * (/ (ell ^ 2)) * (/ (M ^ 1))) / 4)) _ _ (p_balance'ladder'1 t Ht)); fld. Qed.
Lemma free_body'ladder'1'holds : law'force'ladder'd1 -> free_body'ladder'1.
Proof. unfold free_body'ladder'1, law'force'ladder'd1;
  intros p_law'force'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_law'force'ladder'd1 t Ht)); fld. Qed.
Lemma free_body'ladder'2'holds : law'force'ladder'd2 -> free_body'ladder'2.
Proof. unfold free_body'ladder'2, law'force'ladder'd2;
  intros p_law'force'ladder'd2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_law'force'ladder'd2 t Ht)); fld. Qed.
Lemma free_body'ladder'3'holds : law'torque'ladder'd1 -> free_body'ladder'3.
Proof. unfold free_body'ladder'3, law'torque'ladder'd1;
  intros p_law'torque'ladder'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_law'torque'ladder'd1 t Ht)); fld. Qed.
Lemma reaction'N_w'1'holds : free_body'ladder'1 -> free_body'ladder'2 -> free_body'ladder'3 -> reaction'N_w'1.
Proof. unfold reaction'N_w'1, free_body'ladder'1, free_body'ladder'2, free_body'ladder'3;
  intros p_free_body'ladder'1;
  intros p_free_body'ladder'2;
  intros p_free_body'ladder'3;
  intros t Ht; apply lin0; apply (less ((- 1) + ((3 * ((sin (theta t)) ^ 2)) / 4)) _ _ (p_free_body'ladder'1 t Ht)); apply (less ((3 * (/ (ell ^ 1)) * (sin (theta t))) / 4) _ _ (p_free_body'ladder'3 t Ht)); apply (less (- ((3 * (cos (theta t)) * (sin (theta t))) / 4)) _ _ (p_free_body'ladder'2 t Ht)); apply (less ((3 * ell * M * (theta_ddot t) * (sin (theta t))) / 4) _ _ (trig (theta t))); fld. Qed.
Lemma reaction'N_f'1'holds : free_body'ladder'1 -> free_body'ladder'2 -> free_body'ladder'3 -> reaction'N_f'1.
Proof. unfold reaction'N_f'1, free_body'ladder'1, free_body'ladder'2, free_body'ladder'3;
  intros p_free_body'ladder'1;
  intros p_free_body'ladder'2;
  intros p_free_body'ladder'3;
  intros t Ht; apply lin0; apply (less ((- 1) + ((3 * ((cos (theta t)) ^ 2)) / 4)) _ _ (p_free_body'ladder'2 t Ht)); apply (less (- ((3 * (/ (ell ^ 1)) * (cos (theta t))) / 4)) _ _ (p_free_body'ladder'3 t Ht)); apply (less (- ((3 * (cos (theta t)) * (sin (theta t))) / 4)) _ _ (p_free_body'ladder'1 t Ht)); apply (less (- ((3 * ell * M * (theta_ddot t) * (cos (theta t))) / 4)) _ _ (trig (theta t))); fld. Qed.
Lemma motion'from_newton'theta'1'holds : free_body'ladder'1 -> free_body'ladder'2 -> free_body'ladder'3 -> motion'from_newton'theta'1.
Proof. unfold motion'from_newton'theta'1, free_body'ladder'1, free_body'ladder'2, free_body'ladder'3;
  intros p_free_body'ladder'1;
  intros p_free_body'ladder'2;
  intros p_free_body'ladder'3;
  intros t Ht; apply lin0; apply (less (- ((3 * (/ (ell ^ 2)) * (/ (M ^ 1))) / 4)) _ _ (p_free_body'ladder'3 t Ht)); apply (less ((3 * (/ (ell ^ 1)) * (/ (M ^ 1)) * (cos (theta t))) / 4) _ _ (p_free_body'ladder'2 t Ht)); apply (less (- ((3 * (/ (ell ^ 1)) * (/ (M ^ 1)) * (sin (theta t))) / 4)) _ _ (p_free_body'ladder'1 t Ht)); apply (less (- ((3 * (theta_ddot t)) / 4)) _ _ (trig (theta t))); fld. Qed.
Lemma work'W'ladder'1'holds : work'W'ladder'd1 -> work'W'ladder'd2 -> work'W'ladder'd3 -> work'W'ladder'd4 -> force'W'ladder'd1 -> force'W'ladder'd2 -> position'ladder'd1 -> position'ladder'd2 -> start'theta'd1 -> work'W'ladder'1.
Proof. unfold work'W'ladder'1, work'W'ladder'd1, work'W'ladder'd2, work'W'ladder'd3, work'W'ladder'd4, force'W'ladder'd1, force'W'ladder'd2, position'ladder'd1, position'ladder'd2, start'theta'd1;
  intros p_work'W'ladder'd1;
  intros p_work'W'ladder'd2;
  intros p_work'W'ladder'd3;
  intros p_work'W'ladder'd4;
  intros p_force'W'ladder'd1;
  intros p_force'W'ladder'd2;
  intros p_position'ladder'd1;
  intros p_position'ladder'd2;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((R_cm_x' t) + (ell * (theta_dot t) * (sin (theta t)))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_x u) + (- (ell * (cos (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd1 u Hu)); cbv beta; rewrite ?p_work'W'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q2 : forall t : R, ta < t < tb -> ((R_cm_y' t) + (- (ell * (theta_dot t) * (cos (theta t))))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_y u) + (- (ell * (sin (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd2 u Hu)); cbv beta; rewrite ?p_work'W'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q3 : forall t : R, ta < t < tb -> ((cal_W_T_W t) + (RInt (fun x : R => (M * g * ell * (cos x))) theta_0 (theta t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((cal_W_T_W t) + (RInt (fun x : R => (M * g * ell * (cos x))) theta_0 (theta t)))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (W_y u) _ _ (q2 u Hu)); apply (less (W_x u) _ _ (q1 u Hu)); apply (less (ell * (theta_dot u) * (cos (theta u))) _ _ (p_force'W'ladder'd2 u Hu)); apply (less (- (ell * (theta_dot u) * (sin (theta u)))) _ _ (p_force'W'ladder'd1 u Hu)); cbv beta; rewrite ?p_work'W'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_work'W'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q3 t Ht)); cbv beta; rewrite ?p_work'W'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma work'W'ladder'2'holds : work'W'ladder'd6 -> work'W'ladder'd7 -> force'W'ladder'd3 -> work'W'ladder'2.
Proof. unfold work'W'ladder'2, work'W'ladder'd6, work'W'ladder'd7, force'W'ladder'd3;
  intros p_work'W'ladder'd6;
  intros p_work'W'ladder'd7;
  intros p_force'W'ladder'd3;
  assert (q1 : forall t : R, ta < t < tb -> (cal_W_theta_W t) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => (cal_W_theta_W t)) Begin); [intros u Hu; eapply D_eq; [der | apply (less (varphi_ladder' u) _ _ (p_force'W'ladder'd3 u Hu)); cbv beta; rewrite ?p_work'W'ladder'd7; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_work'W'ladder'd7; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_work'W'ladder'd7; rewrite ?RInt_none; fld. Qed.
Lemma work'F_s'ladder'1'holds : work'F_s'ladder'd1 -> work'F_s'ladder'd2 -> work'F_s'ladder'd3 -> work'F_s'ladder'd4 -> force'F_s'ladder'd1 -> force'F_s'ladder'd2 -> position'ladder'd1 -> position'ladder'd2 -> start'theta'd1 -> work'F_s'ladder'1.
Proof. unfold work'F_s'ladder'1, work'F_s'ladder'd1, work'F_s'ladder'd2, work'F_s'ladder'd3, work'F_s'ladder'd4, force'F_s'ladder'd1, force'F_s'ladder'd2, position'ladder'd1, position'ladder'd2, start'theta'd1;
  intros p_work'F_s'ladder'd1;
  intros p_work'F_s'ladder'd2;
  intros p_work'F_s'ladder'd3;
  intros p_work'F_s'ladder'd4;
  intros p_force'F_s'ladder'd1;
  intros p_force'F_s'ladder'd2;
  intros p_position'ladder'd1;
  intros p_position'ladder'd2;
  intros p_start'theta'd1;
  assert (q2 : forall t : R, ta < t < tb -> ((R_cm_x' t) + (ell * (theta_dot t) * (sin (theta t)))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_x u) + (- (ell * (cos (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd1 u Hu)); cbv beta; rewrite ?p_work'F_s'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q3 : forall t : R, ta < t < tb -> ((R_cm_y' t) + (- (ell * (theta_dot t) * (cos (theta t))))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_y u) + (- (ell * (sin (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd2 u Hu)); cbv beta; rewrite ?p_work'F_s'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q4 : forall t : R, ta < t < tb -> ((cal_W_T_F_s t) + (- (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((cal_W_T_F_s t) + (- (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t))))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (F_s_y u) _ _ (q3 u Hu)); apply (less (F_s_x u) _ _ (q2 u Hu)); apply (less (ell * (theta_dot u) * (cos (theta u))) _ _ (p_force'F_s'ladder'd2 u Hu)); apply (less (- (ell * (theta_dot u) * (sin (theta u)))) _ _ (p_force'F_s'ladder'd1 u Hu)); cbv beta; rewrite ?p_work'F_s'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_work'F_s'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q4 t Ht)); cbv beta; rewrite ?p_work'F_s'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma work'F_s'ladder'2'holds : work'F_s'ladder'd5 -> work'F_s'ladder'd6 -> work'F_s'ladder'd7 -> force'F_s'ladder'd3 -> def'varphi_ladder'd1 -> start'theta'd1 -> work'F_s'ladder'2.
Proof. unfold work'F_s'ladder'2, work'F_s'ladder'd5, work'F_s'ladder'd6, work'F_s'ladder'd7, force'F_s'ladder'd3, def'varphi_ladder'd1, start'theta'd1;
  intros p_work'F_s'ladder'd5;
  intros p_work'F_s'ladder'd6;
  intros p_work'F_s'ladder'd7;
  intros p_force'F_s'ladder'd3;
  intros p_def'varphi_ladder'd1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((varphi_ladder' t) + (theta_dot t)) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((varphi_ladder u) + (- PI) + (theta u))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_def'varphi_ladder'd1 u Hu)); cbv beta; rewrite ?p_work'F_s'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q4 : forall t : R, ta < t < tb -> ((cal_W_theta_F_s t) + (- (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((cal_W_theta_F_s t) + (- (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t))))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (tau_cm_F_s u) _ _ (q1 u Hu)); apply (less (- (theta_dot u)) _ _ (p_force'F_s'ladder'd3 u Hu)); cbv beta; rewrite ?p_work'F_s'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_work'F_s'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q4 t Ht)); cbv beta; rewrite ?p_work'F_s'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma work'N_w'ladder'1'holds : work'N_w'ladder'd1 -> work'N_w'ladder'd2 -> work'N_w'ladder'd3 -> work'N_w'ladder'd4 -> force'N_w'ladder'd1 -> force'N_w'ladder'd2 -> position'ladder'd1 -> position'ladder'd2 -> start'theta'd1 -> work'N_w'ladder'1.
Proof. unfold work'N_w'ladder'1, work'N_w'ladder'd1, work'N_w'ladder'd2, work'N_w'ladder'd3, work'N_w'ladder'd4, force'N_w'ladder'd1, force'N_w'ladder'd2, position'ladder'd1, position'ladder'd2, start'theta'd1;
  intros p_work'N_w'ladder'd1;
  intros p_work'N_w'ladder'd2;
  intros p_work'N_w'ladder'd3;
  intros p_work'N_w'ladder'd4;
  intros p_force'N_w'ladder'd1;
  intros p_force'N_w'ladder'd2;
  intros p_position'ladder'd1;
  intros p_position'ladder'd2;
  intros p_start'theta'd1;
  assert (q2 : forall t : R, ta < t < tb -> ((R_cm_x' t) + (ell * (theta_dot t) * (sin (theta t)))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_x u) + (- (ell * (cos (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd1 u Hu)); cbv beta; rewrite ?p_work'N_w'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q3 : forall t : R, ta < t < tb -> ((R_cm_y' t) + (- (ell * (theta_dot t) * (cos (theta t))))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_y u) + (- (ell * (sin (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd2 u Hu)); cbv beta; rewrite ?p_work'N_w'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q4 : forall t : R, ta < t < tb -> ((cal_W_T_N_w t) + (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t)) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((cal_W_T_N_w t) + (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (N_w_y u) _ _ (q3 u Hu)); apply (less (N_w_x u) _ _ (q2 u Hu)); apply (less (ell * (theta_dot u) * (cos (theta u))) _ _ (p_force'N_w'ladder'd2 u Hu)); apply (less (- (ell * (theta_dot u) * (sin (theta u)))) _ _ (p_force'N_w'ladder'd1 u Hu)); cbv beta; rewrite ?p_work'N_w'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_work'N_w'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q4 t Ht)); cbv beta; rewrite ?p_work'N_w'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma work'N_w'ladder'2'holds : work'N_w'ladder'd5 -> work'N_w'ladder'd6 -> work'N_w'ladder'd7 -> force'N_w'ladder'd3 -> def'varphi_ladder'd1 -> start'theta'd1 -> work'N_w'ladder'2.
Proof. unfold work'N_w'ladder'2, work'N_w'ladder'd5, work'N_w'ladder'd6, work'N_w'ladder'd7, force'N_w'ladder'd3, def'varphi_ladder'd1, start'theta'd1;
  intros p_work'N_w'ladder'd5;
  intros p_work'N_w'ladder'd6;
  intros p_work'N_w'ladder'd7;
  intros p_force'N_w'ladder'd3;
  intros p_def'varphi_ladder'd1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((varphi_ladder' t) + (theta_dot t)) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((varphi_ladder u) + (- PI) + (theta u))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_def'varphi_ladder'd1 u Hu)); cbv beta; rewrite ?p_work'N_w'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q4 : forall t : R, ta < t < tb -> ((cal_W_theta_N_w t) + (- (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((cal_W_theta_N_w t) + (- (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t)))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (tau_cm_N_w u) _ _ (q1 u Hu)); apply (less (- (theta_dot u)) _ _ (p_force'N_w'ladder'd3 u Hu)); cbv beta; rewrite ?p_work'N_w'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_work'N_w'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q4 t Ht)); cbv beta; rewrite ?p_work'N_w'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma work'N_f'ladder'1'holds : work'N_f'ladder'd1 -> work'N_f'ladder'd2 -> work'N_f'ladder'd3 -> work'N_f'ladder'd4 -> force'N_f'ladder'd1 -> force'N_f'ladder'd2 -> position'ladder'd1 -> position'ladder'd2 -> start'theta'd1 -> work'N_f'ladder'1.
Proof. unfold work'N_f'ladder'1, work'N_f'ladder'd1, work'N_f'ladder'd2, work'N_f'ladder'd3, work'N_f'ladder'd4, force'N_f'ladder'd1, force'N_f'ladder'd2, position'ladder'd1, position'ladder'd2, start'theta'd1;
  intros p_work'N_f'ladder'd1;
  intros p_work'N_f'ladder'd2;
  intros p_work'N_f'ladder'd3;
  intros p_work'N_f'ladder'd4;
  intros p_force'N_f'ladder'd1;
  intros p_force'N_f'ladder'd2;
  intros p_position'ladder'd1;
  intros p_position'ladder'd2;
  intros p_start'theta'd1;
  assert (q2 : forall t : R, ta < t < tb -> ((R_cm_x' t) + (ell * (theta_dot t) * (sin (theta t)))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_x u) + (- (ell * (cos (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd1 u Hu)); cbv beta; rewrite ?p_work'N_f'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q3 : forall t : R, ta < t < tb -> ((R_cm_y' t) + (- (ell * (theta_dot t) * (cos (theta t))))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((R_cm_y u) + (- (ell * (sin (theta u)))))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_position'ladder'd2 u Hu)); cbv beta; rewrite ?p_work'N_f'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q4 : forall t : R, ta < t < tb -> ((cal_W_T_N_f t) + (- (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((cal_W_T_N_f t) + (- (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t)))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (N_f_y u) _ _ (q3 u Hu)); apply (less (N_f_x u) _ _ (q2 u Hu)); apply (less (ell * (theta_dot u) * (cos (theta u))) _ _ (p_force'N_f'ladder'd2 u Hu)); apply (less (- (ell * (theta_dot u) * (sin (theta u)))) _ _ (p_force'N_f'ladder'd1 u Hu)); cbv beta; rewrite ?p_work'N_f'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_work'N_f'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q4 t Ht)); cbv beta; rewrite ?p_work'N_f'ladder'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma work'N_f'ladder'2'holds : work'N_f'ladder'd5 -> work'N_f'ladder'd6 -> work'N_f'ladder'd7 -> force'N_f'ladder'd3 -> def'varphi_ladder'd1 -> start'theta'd1 -> work'N_f'ladder'2.
Proof. unfold work'N_f'ladder'2, work'N_f'ladder'd5, work'N_f'ladder'd6, work'N_f'ladder'd7, force'N_f'ladder'd3, def'varphi_ladder'd1, start'theta'd1;
  intros p_work'N_f'ladder'd5;
  intros p_work'N_f'ladder'd6;
  intros p_work'N_f'ladder'd7;
  intros p_force'N_f'ladder'd3;
  intros p_def'varphi_ladder'd1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((varphi_ladder' t) + (theta_dot t)) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((varphi_ladder u) + (- PI) + (theta u))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_def'varphi_ladder'd1 u Hu)); cbv beta; rewrite ?p_work'N_f'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht | eapply D_eq; [der | fld]]);
  assert (q4 : forall t : R, ta < t < tb -> ((cal_W_theta_N_f t) + (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t)) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((cal_W_theta_N_f t) + (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (tau_cm_N_f u) _ _ (q1 u Hu)); apply (less (- (theta_dot u)) _ _ (p_force'N_f'ladder'd3 u Hu)); cbv beta; rewrite ?p_work'N_f'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_work'N_f'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q4 t Ht)); cbv beta; rewrite ?p_work'N_f'ladder'd7, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma workless'N_w'1'holds : work'N_w'ladder'1 -> work'N_w'ladder'2 -> workless'N_w'1.
Proof. unfold workless'N_w'1, work'N_w'ladder'1, work'N_w'ladder'2;
  intros p_work'N_w'ladder'1;
  intros p_work'N_w'ladder'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'N_w'ladder'2 t Ht)); apply (less 1 _ _ (p_work'N_w'ladder'1 t Ht)); fld. Qed.
Lemma workless'N_f'1'holds : work'N_f'ladder'1 -> work'N_f'ladder'2 -> workless'N_f'1.
Proof. unfold workless'N_f'1, work'N_f'ladder'1, work'N_f'ladder'2;
  intros p_work'N_f'ladder'1;
  intros p_work'N_f'ladder'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'N_f'ladder'2 t Ht)); apply (less 1 _ _ (p_work'N_f'ladder'1 t Ht)); fld. Qed.
Lemma spring'F_s'1'holds : work'F_s'ladder'1 -> work'F_s'ladder'2 -> spring'F_s'1.
Proof. unfold spring'F_s'1, work'F_s'ladder'1, work'F_s'ladder'2;
  intros p_work'F_s'ladder'1;
  intros p_work'F_s'ladder'2;
  intros t Ht; apply lin0; apply (less (- 1) _ _ (p_work'F_s'ladder'2 t Ht)); apply (less 1 _ _ (p_work'F_s'ladder'1 t Ht)); fld. Qed.
Lemma spring'F_s'2'holds : work'F_s'ladder'2 -> def'l_0'd1 -> start'theta'd1 -> spring'F_s'2.
Proof. unfold spring'F_s'2, work'F_s'ladder'2, def'l_0'd1, start'theta'd1;
  intros p_work'F_s'ladder'2;
  intros p_def'l_0'd1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((- (RInt (fun x : R => (k * ((2 * ell * (cos x)) + (- l_0)) * ell * (sin x))) theta_0 (theta t))) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((- (RInt (fun x : R => (k * ((2 * ell * (cos x)) + (- l_0)) * ell * (sin x))) theta_0 (theta t))) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (ell * (theta_dot u) * k * (sin (theta u))) _ _ (p_def'l_0'd1 u Hu)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'F_s'ladder'2 t Ht)); apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma spring'done'F_s'1'holds : work'F_s'ladder'1 -> work'F_s'ladder'2 -> spring'done'F_s'1.
Proof. unfold spring'done'F_s'1, work'F_s'ladder'1, work'F_s'ladder'2;
  intros p_work'F_s'ladder'1;
  intros p_work'F_s'ladder'2;
  intros t Ht; apply lin0; apply (less (- 1) _ _ (p_work'F_s'ladder'2 t Ht)); apply (less 1 _ _ (p_work'F_s'ladder'1 t Ht)); fld. Qed.
Lemma spring'done'F_s'2'holds : work'F_s'ladder'2 -> start'theta'd1 -> spring'done'F_s'2.
Proof. unfold spring'done'F_s'2, work'F_s'ladder'2, start'theta'd1;
  intros p_work'F_s'ladder'2;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)))) Begin); [intros u Hu; eapply D_eq; [der | cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'F_s'ladder'2 t Ht)); apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma theorem'T'ladder'1'holds : work'W'ladder'd4 -> work'W'ladder'1 -> work'F_s'ladder'd4 -> work'F_s'ladder'1 -> work'N_w'ladder'1 -> work'N_f'ladder'1 -> velocity'ladder'5 -> velocity'ladder'6 -> law'force'ladder'd1 -> law'force'ladder'd2 -> theorem'T'ladder'1.
Proof. unfold theorem'T'ladder'1, work'W'ladder'd4, work'W'ladder'1, work'F_s'ladder'd4, work'F_s'ladder'1, work'N_w'ladder'1, work'N_f'ladder'1, velocity'ladder'5, velocity'ladder'6, law'force'ladder'd1, law'force'ladder'd2;
  intros p_work'W'ladder'd4;
  intros p_work'W'ladder'1;
  intros p_work'F_s'ladder'd4;
  intros p_work'F_s'ladder'1;
  intros p_work'N_w'ladder'1;
  intros p_work'N_f'ladder'1;
  intros p_velocity'ladder'5;
  intros p_velocity'ladder'6;
  intros p_law'force'ladder'd1;
  intros p_law'force'ladder'd2;
  assert (q7 : forall t : R, ta < t < tb -> ((RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t) + (- (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)) + (- (RInt (fun x : R => (M * g * ell * (cos x))) theta_0 (theta t))) + (- (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2)) + (((ell ^ 2) * M * ((theta_dot 0) ^ 2)) / 2)) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t) + (- (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)) + (- (RInt (fun x : R => (M * g * ell * (cos x))) theta_0 (theta t))) + (- (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2)) + (((ell ^ 2) * M * ((theta_dot 0) ^ 2)) / 2))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (- (ell * (theta_dot u) * (cos (theta u)))) _ _ (p_law'force'ladder'd2 u Hu)); apply (less (ell * (theta_dot u) * (sin (theta u))) _ _ (p_law'force'ladder'd1 u Hu)); apply (less ((ell ^ 2) * M * (theta_dot u) * (theta_ddot u)) _ _ (trig (theta u))); cbv beta; rewrite ?p_work'W'ladder'd4, ?p_work'F_s'ladder'd4; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; apply (less (- 1) _ _ (p_work'W'ladder'1 0 Begin)); apply (less (- 1) _ _ (p_work'F_s'ladder'1 0 Begin)); cbv beta; rewrite ?p_work'W'ladder'd4, ?p_work'F_s'ladder'd4; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'N_f'ladder'1 t Ht)); apply (less 1 _ _ (p_work'N_w'ladder'1 t Ht)); apply (less 1 _ _ (p_work'F_s'ladder'1 t Ht)); apply (less 1 _ _ (p_work'W'ladder'1 t Ht)); apply (less ((- ((M * (V_cm_y t)) / 2)) + (- ((ell * M * (theta_dot t) * (cos (theta t))) / 2))) _ _ (p_velocity'ladder'6 t Ht)); apply (less (((M * (V_cm_y 0)) / 2) + ((ell * M * (theta_dot 0) * (cos (theta 0))) / 2)) _ _ (p_velocity'ladder'6 0 Begin)); apply (less ((- ((M * (V_cm_x t)) / 2)) + ((ell * M * (theta_dot t) * (sin (theta t))) / 2)) _ _ (p_velocity'ladder'5 t Ht)); apply (less (((M * (V_cm_x 0)) / 2) + (- ((ell * M * (theta_dot 0) * (sin (theta 0))) / 2))) _ _ (p_velocity'ladder'5 0 Begin)); apply (less 1 _ _ (q7 t Ht)); apply (less (- (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2)) _ _ (trig (theta t))); apply (less (((ell ^ 2) * M * ((theta_dot 0) ^ 2)) / 2) _ _ (trig (theta 0))); cbv beta; rewrite ?p_work'W'ladder'd4, ?p_work'F_s'ladder'd4; rewrite ?RInt_none; fld. Qed.
Lemma theorem'theta'ladder'1'holds : work'F_s'ladder'd4 -> work'F_s'ladder'1 -> work'F_s'ladder'2 -> work'N_w'ladder'2 -> work'N_f'ladder'2 -> turning'ladder'3 -> moment'ladder'd1 -> moment'ladder'2 -> law'torque'ladder'd1 -> theorem'theta'ladder'1.
Proof. unfold theorem'theta'ladder'1, work'F_s'ladder'd4, work'F_s'ladder'1, work'F_s'ladder'2, work'N_w'ladder'2, work'N_f'ladder'2, turning'ladder'3, moment'ladder'd1, moment'ladder'2, law'torque'ladder'd1;
  intros p_work'F_s'ladder'd4;
  intros p_work'F_s'ladder'1;
  intros p_work'F_s'ladder'2;
  intros p_work'N_w'ladder'2;
  intros p_work'N_f'ladder'2;
  intros p_turning'ladder'3;
  intros p_moment'ladder'd1;
  intros p_moment'ladder'2;
  intros p_law'torque'ladder'd1;
  assert (q3 : forall t : R, ta < t < tb -> ((- (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t)) + (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)) + (- ((((theta_dot t) ^ 2) * I_cm) / 2)) + ((I_cm * ((theta_dot 0) ^ 2)) / 2)) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((- (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t)) + (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)) + (- ((((theta_dot t) ^ 2) * I_cm) / 2)) + ((I_cm * ((theta_dot 0) ^ 2)) / 2))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (- ((theta_dot u) * (theta_ddot u))) _ _ (p_moment'ladder'd1 u Hu)); apply (less ((3 * (/ (ell ^ 3)) * (theta_dot u) * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell))) / 2) _ _ (p_law'torque'ladder'd1 u Hu)); apply (less ((- (6 * (/ (M ^ 1)) * (theta_dot u) * k * (cos (theta u)) * (sin (theta u)))) + (6 * (/ (M ^ 1)) * (theta_dot u) * k * (sin (theta u)) * (cos theta_0)) + (- (3 * (/ (ell ^ 1)) * (/ (M ^ 1)) * (theta_dot u) * (N_w u) * (sin (theta u)))) + (3 * (/ (ell ^ 1)) * (/ (M ^ 1)) * (theta_dot u) * (N_f u) * (cos (theta u)))) _ _ (p_moment'ladder'2 u Hu)); cbv beta; rewrite ?p_work'F_s'ladder'd4; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; apply (less (- 1) _ _ (p_work'F_s'ladder'1 0 Begin)); cbv beta; rewrite ?p_work'F_s'ladder'd4; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'N_f'ladder'2 t Ht)); apply (less 1 _ _ (p_work'N_w'ladder'2 t Ht)); apply (less 1 _ _ (p_work'F_s'ladder'2 t Ht)); apply (less ((- ((I_cm * (omega_ladder t)) / 2)) + (((theta_dot t) * I_cm) / 2)) _ _ (p_turning'ladder'3 t Ht)); apply (less (((I_cm * (omega_ladder 0)) / 2) + (- ((I_cm * (theta_dot 0)) / 2))) _ _ (p_turning'ladder'3 0 Begin)); apply (less 1 _ _ (q3 t Ht)); cbv beta; rewrite ?p_work'F_s'ladder'd4; rewrite ?RInt_none; fld. Qed.
Lemma theorem'whole'1'holds : workless'N_w'1 -> workless'N_f'1 -> theorem'T'ladder'1 -> theorem'theta'ladder'1 -> velocity'ladder'5 -> velocity'ladder'6 -> turning'ladder'3 -> moment'ladder'd1 -> moment'ladder'2 -> theorem'whole'1.
Proof. unfold theorem'whole'1, workless'N_w'1, workless'N_f'1, theorem'T'ladder'1, theorem'theta'ladder'1, velocity'ladder'5, velocity'ladder'6, turning'ladder'3, moment'ladder'd1, moment'ladder'2;
  intros p_workless'N_w'1;
  intros p_workless'N_f'1;
  intros p_theorem'T'ladder'1;
  intros p_theorem'theta'ladder'1;
  intros p_velocity'ladder'5;
  intros p_velocity'ladder'6;
  intros p_turning'ladder'3;
  intros p_moment'ladder'd1;
  intros p_moment'ladder'2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_theorem'theta'ladder'1 t Ht)); apply (less (- 1) _ _ (p_workless'N_f'1 t Ht)); apply (less 1 _ _ (p_theorem'T'ladder'1 t Ht)); apply (less (- 1) _ _ (p_workless'N_w'1 t Ht)); apply (less ((((omega_ladder t) ^ 2) / 2) + (- (((omega_ladder 0) ^ 2) / 2))) _ _ (p_moment'ladder'd1 t Ht)); apply (less (((M * (V_cm_y t)) / 2) + ((ell * M * (theta_dot t) * (cos (theta t))) / 2)) _ _ (p_velocity'ladder'6 t Ht)); apply (less ((- ((M * (V_cm_y 0)) / 2)) + (- ((ell * M * (theta_dot 0) * (cos (theta 0))) / 2))) _ _ (p_velocity'ladder'6 0 Begin)); apply (less (((M * (V_cm_x t)) / 2) + (- ((ell * M * (theta_dot t) * (sin (theta t))) / 2))) _ _ (p_velocity'ladder'5 t Ht)); apply (less ((- ((M * (V_cm_x 0)) / 2)) + ((ell * M * (theta_dot 0) * (sin (theta 0))) / 2)) _ _ (p_velocity'ladder'5 0 Begin)); apply (less ((((/ (ell ^ 1)) * M * (omega_ladder t) * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell))) / 4) + (- (((/ (ell ^ 1)) * M * (theta_dot t) * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell))) / 4))) _ _ (p_turning'ladder'3 t Ht)); apply (less ((- (((/ (ell ^ 1)) * M * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell)) * (omega_ladder 0)) / 4)) + (((/ (ell ^ 1)) * M * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell)) * (theta_dot 0)) / 4)) _ _ (p_turning'ladder'3 0 Begin)); apply (less ((((theta_dot t) ^ 2) / 2) + (- (((theta_dot 0) ^ 2) / 2))) _ _ (p_moment'ladder'2 t Ht)); apply (less (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2) _ _ (trig (theta t))); apply (less (- (((ell ^ 2) * M * ((theta_dot 0) ^ 2)) / 2)) _ _ (trig (theta 0))); fld. Qed.
Lemma together'T'1'holds : together'T'd1 -> together'T'd2 -> together'T'd3 -> together'T'd4 -> force'W'ladder'd1 -> force'W'ladder'd2 -> velocity'ladder'd1 -> velocity'ladder'd2 -> velocity'ladder'5 -> velocity'ladder'6 -> force'N_w'ladder'd1 -> force'N_w'ladder'd2 -> force'N_f'ladder'd1 -> force'N_f'ladder'd2 -> force'F_s'ladder'd1 -> force'F_s'ladder'd2 -> start'theta'd1 -> together'T'1.
Proof. unfold together'T'1, together'T'd1, together'T'd2, together'T'd3, together'T'd4, force'W'ladder'd1, force'W'ladder'd2, velocity'ladder'd1, velocity'ladder'd2, velocity'ladder'5, velocity'ladder'6, force'N_w'ladder'd1, force'N_w'ladder'd2, force'N_f'ladder'd1, force'N_f'ladder'd2, force'F_s'ladder'd1, force'F_s'ladder'd2, start'theta'd1;
  intros p_together'T'd1;
  intros p_together'T'd2;
  intros p_together'T'd3;
  intros p_together'T'd4;
  intros p_force'W'ladder'd1;
  intros p_force'W'ladder'd2;
  intros p_velocity'ladder'd1;
  intros p_velocity'ladder'd2;
  intros p_velocity'ladder'5;
  intros p_velocity'ladder'6;
  intros p_force'N_w'ladder'd1;
  intros p_force'N_w'ladder'd2;
  intros p_force'N_f'ladder'd1;
  intros p_force'N_f'ladder'd2;
  intros p_force'F_s'ladder'd1;
  intros p_force'F_s'ladder'd2;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> (V_cm_x t) = (R_cm_x' t)) by (intros t Ht; apply (alone _ t _ _ (p_velocity'ladder'd1 t Ht)); clear p_velocity'ladder'd1; eapply D_eq; [der | fld]);
  assert (q2 : forall t : R, ta < t < tb -> (V_cm_y t) = (R_cm_y' t)) by (intros t Ht; apply (alone _ t _ _ (p_velocity'ladder'd2 t Ht)); clear p_velocity'ladder'd2; eapply D_eq; [der | fld]);
  assert (q7 : forall t : R, ta < t < tb -> ((cal_W_T t) + (- (RInt (fun u : R => ((((ell * ((N_w u) + (2 * k * ell * ((cos theta_0) + (- (cos (theta u))))))) * (- (sin (theta u)))) + ((ell * ((N_f u) + (- (M * g)))) * (cos (theta u)))) * (theta_dot u))) 0 t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((cal_W_T t) + (- (RInt (fun u : R => ((((ell * ((N_w u) + (2 * k * ell * ((cos theta_0) + (- (cos (theta u))))))) * (- (sin (theta u)))) + ((ell * ((N_f u) + (- (M * g)))) * (cos (theta u)))) * (theta_dot u))) 0 t)))) Begin); [intros u Hu; eapply D_eq; [der | apply (less ((- (N_w_y u)) + (- (N_f_y u)) + (- (W_y u)) + (- (F_s_y u))) _ _ (q2 u Hu)); apply (less ((- (N_w_x u)) + (- (N_f_x u)) + (- (W_x u)) + (- (F_s_x u))) _ _ (q1 u Hu)); apply (less (V_cm_y u) _ _ (p_force'N_f'ladder'd2 u Hu)); apply (less (V_cm_x u) _ _ (p_force'N_f'ladder'd1 u Hu)); apply (less (V_cm_y u) _ _ (p_force'N_w'ladder'd2 u Hu)); apply (less (V_cm_x u) _ _ (p_force'N_w'ladder'd1 u Hu)); apply (less (V_cm_y u) _ _ (p_force'F_s'ladder'd2 u Hu)); apply (less (V_cm_x u) _ _ (p_force'F_s'ladder'd1 u Hu)); apply (less (V_cm_y u) _ _ (p_force'W'ladder'd2 u Hu)); apply (less (V_cm_x u) _ _ (p_force'W'ladder'd1 u Hu)); apply (less ((N_f u) + (- (M * g))) _ _ (p_velocity'ladder'6 u Hu)); apply (less ((N_w u) + (- (2 * ell * k * (cos (theta u)))) + (2 * ell * k * (cos theta_0))) _ _ (p_velocity'ladder'5 u Hu)); cbv beta; rewrite ?p_together'T'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_together'T'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  clear p_velocity'ladder'd1;
  clear p_velocity'ladder'd2;
  intros t Ht; apply lin0; apply (less 1 _ _ (q7 t Ht)); cbv beta; rewrite ?p_together'T'd4, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma together'T'2'holds : start'theta'd1 -> together'T'2.
Proof. unfold together'T'2, start'theta'd1;
  intros p_start'theta'd1;
  assert (q7 : forall t : R, ta < t < tb -> ((RInt (fun u : R => ((((ell * ((N_w u) + (2 * k * ell * ((cos theta_0) + (- (cos (theta u))))))) * (- (sin (theta u)))) + ((ell * ((N_f u) + (- (M * g)))) * (cos (theta u)))) * (theta_dot u))) 0 t) + (- (RInt (fun u : R => ((ell * ((- ((N_w u) * (sin (theta u)))) + ((N_f u) * (cos (theta u))))) * (theta_dot u))) 0 t)) + (ell * M * g * (sin (theta t))) + (- (ell * M * g * (sin theta_0))) + ((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((RInt (fun u : R => ((((ell * ((N_w u) + (2 * k * ell * ((cos theta_0) + (- (cos (theta u))))))) * (- (sin (theta u)))) + ((ell * ((N_f u) + (- (M * g)))) * (cos (theta u)))) * (theta_dot u))) 0 t) + (- (RInt (fun u : R => ((ell * ((- ((N_w u) * (sin (theta u)))) + ((N_f u) * (cos (theta u))))) * (theta_dot u))) 0 t)) + (ell * M * g * (sin (theta t))) + (- (ell * M * g * (sin theta_0))) + ((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2)))) Begin); [intros u Hu; eapply D_eq; [der | cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q7 t Ht)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma together'T'3'holds : def'cal_w_c'd1 -> def'cal_w_c'd2 -> start'theta'd1 -> together'T'3.
Proof. unfold together'T'3, def'cal_w_c'd1, def'cal_w_c'd2, start'theta'd1;
  intros p_def'cal_w_c'd1;
  intros p_def'cal_w_c'd2;
  intros p_start'theta'd1;
  assert (q7 : forall t : R, ta < t < tb -> ((RInt (fun u : R => ((ell * ((- ((N_w u) * (sin (theta u)))) + ((N_f u) * (cos (theta u))))) * (theta_dot u))) 0 t) + (- (cal_w_c t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((RInt (fun u : R => ((ell * ((- ((N_w u) * (sin (theta u)))) + ((N_f u) * (cos (theta u))))) * (theta_dot u))) 0 t) + (- (cal_w_c t)))) Begin); [intros u Hu; eapply D_eq; [der | cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q7 t Ht)); cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma together'T'4'holds : def'cal_w_c'd1 -> def'cal_w_c'd2 -> velocity'ladder'5 -> velocity'ladder'6 -> start'theta'd1 -> start'theta'd2 -> law'force'ladder'd1 -> law'force'ladder'd2 -> together'T'4.
Proof. unfold together'T'4, def'cal_w_c'd1, def'cal_w_c'd2, velocity'ladder'5, velocity'ladder'6, start'theta'd1, start'theta'd2, law'force'ladder'd1, law'force'ladder'd2;
  intros p_def'cal_w_c'd1;
  intros p_def'cal_w_c'd2;
  intros p_velocity'ladder'5;
  intros p_velocity'ladder'6;
  intros p_start'theta'd1;
  intros p_start'theta'd2;
  intros p_law'force'ladder'd1;
  intros p_law'force'ladder'd2;
  assert (q7 : forall t : R, ta < t < tb -> ((cal_w_c t) + (- (ell * M * g * (sin (theta t)))) + (ell * M * g * (sin theta_0)) + (- ((ell ^ 2) * k * ((cos (theta t)) ^ 2))) + (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0)) + (- ((ell ^ 2) * k * ((cos theta_0) ^ 2))) + (- (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((cal_w_c t) + (- (ell * M * g * (sin (theta t)))) + (ell * M * g * (sin theta_0)) + (- ((ell ^ 2) * k * ((cos (theta t)) ^ 2))) + (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0)) + (- ((ell ^ 2) * k * ((cos theta_0) ^ 2))) + (- (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2)))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (- (ell * (theta_dot u) * (cos (theta u)))) _ _ (p_law'force'ladder'd2 u Hu)); apply (less (ell * (theta_dot u) * (sin (theta u))) _ _ (p_law'force'ladder'd1 u Hu)); apply (less ((ell ^ 2) * M * (theta_dot u) * (theta_ddot u)) _ _ (trig (theta u))); cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1, ?p_start'theta'd2; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1, ?p_start'theta'd2; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less ((- ((M * (V_cm_y t)) / 2)) + (- ((ell * M * (theta_dot t) * (cos (theta t))) / 2))) _ _ (p_velocity'ladder'6 t Ht)); apply (less ((- ((M * (V_cm_x t)) / 2)) + ((ell * M * (theta_dot t) * (sin (theta t))) / 2)) _ _ (p_velocity'ladder'5 t Ht)); apply (less 1 _ _ (q7 t Ht)); apply (less (- (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2)) _ _ (trig (theta t))); cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1, ?p_start'theta'd2; rewrite ?RInt_none; fld. Qed.
Lemma together'solved'1'holds : together'T'4 -> together'solved'1.
Proof. unfold together'solved'1, together'T'4;
  intros p_together'T'4;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_together'T'4 t Ht)); fld. Qed.
Lemma together'theta'1'holds : together'theta'd1 -> together'theta'1.
Proof. unfold together'theta'1, together'theta'd1;
  intros p_together'theta'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_together'theta'd1 t Ht)); fld. Qed.
Lemma together'theta'2'holds : def'cal_w_c'd1 -> def'cal_w_c'd2 -> start'theta'd1 -> together'theta'2.
Proof. unfold together'theta'2, def'cal_w_c'd1, def'cal_w_c'd2, start'theta'd1;
  intros p_def'cal_w_c'd1;
  intros p_def'cal_w_c'd2;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((RInt (fun u : R => ((ell * (((N_w u) * (sin (theta u))) + (- ((N_f u) * (cos (theta u)))))) * (theta_dot u))) 0 t) + (cal_w_c t)) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((RInt (fun u : R => ((ell * (((N_w u) * (sin (theta u))) + (- ((N_f u) * (cos (theta u)))))) * (theta_dot u))) 0 t) + (cal_w_c t))) Begin); [intros u Hu; eapply D_eq; [der | cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma together'turned'1'holds : def'cal_w_c'd1 -> def'cal_w_c'd2 -> start'theta'd1 -> start'theta'd2 -> law'torque'ladder'd1 -> together'turned'1.
Proof. unfold together'turned'1, def'cal_w_c'd1, def'cal_w_c'd2, start'theta'd1, start'theta'd2, law'torque'ladder'd1;
  intros p_def'cal_w_c'd1;
  intros p_def'cal_w_c'd2;
  intros p_start'theta'd1;
  intros p_start'theta'd2;
  intros p_law'torque'ladder'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((- (cal_w_c t)) + (- ((ell ^ 2) * k * ((cos (theta t)) ^ 2))) + (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0)) + (- ((ell ^ 2) * k * ((cos theta_0) ^ 2))) + (- (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 6))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((- (cal_w_c t)) + (- ((ell ^ 2) * k * ((cos (theta t)) ^ 2))) + (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0)) + (- ((ell ^ 2) * k * ((cos theta_0) ^ 2))) + (- (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 6)))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (theta_dot u) _ _ (p_law'torque'ladder'd1 u Hu)); cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1, ?p_start'theta'd2; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1, ?p_start'theta'd2; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_def'cal_w_c'd2, ?p_start'theta'd1, ?p_start'theta'd2; rewrite ?RInt_none; fld. Qed.
Lemma together'energy'1'holds : velocity'ladder'5 -> velocity'ladder'6 -> def'E'd1 -> together'energy'1.
Proof. unfold together'energy'1, velocity'ladder'5, velocity'ladder'6, def'E'd1;
  intros p_velocity'ladder'5;
  intros p_velocity'ladder'6;
  intros p_def'E'd1;
  intros t Ht; apply lin0; apply (less (((M * (V_cm_y t)) / 2) + ((ell * M * (theta_dot t) * (cos (theta t))) / 2)) _ _ (p_velocity'ladder'6 t Ht)); apply (less (((M * (V_cm_x t)) / 2) + (- ((ell * M * (theta_dot t) * (sin (theta t))) / 2))) _ _ (p_velocity'ladder'5 t Ht)); apply (less (- 1) _ _ (p_def'E'd1 t Ht)); apply (less (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2) _ _ (trig (theta t))); fld. Qed.
Lemma together'energy'2'holds : together'T'4 -> together'turned'1 -> velocity'ladder'5 -> velocity'ladder'6 -> def'E'd1 -> start'theta'd1 -> start'theta'd2 -> together'energy'2.
Proof. unfold together'energy'2, together'T'4, together'turned'1, velocity'ladder'5, velocity'ladder'6, def'E'd1, start'theta'd1, start'theta'd2;
  intros p_together'T'4;
  intros p_together'turned'1;
  intros p_velocity'ladder'5;
  intros p_velocity'ladder'6;
  intros p_def'E'd1;
  intros p_start'theta'd1;
  intros p_start'theta'd2;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_def'E'd1 t Ht)); apply (less (- 1) _ _ (p_together'T'4 t Ht)); apply (less ((- ((M * (V_cm_y t)) / 2)) + (- ((ell * M * (theta_dot t) * (cos (theta t))) / 2))) _ _ (p_velocity'ladder'6 t Ht)); apply (less ((- ((M * (V_cm_x t)) / 2)) + ((ell * M * (theta_dot t) * (sin (theta t))) / 2)) _ _ (p_velocity'ladder'5 t Ht)); apply (less (- 1) _ _ (p_together'turned'1 t Ht)); apply (less (- 1) _ _ (p_def'E'd1 0 Begin)); apply (less (- (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2)) _ _ (trig (theta t))); cbv beta; rewrite ?p_start'theta'd1, ?p_start'theta'd2; rewrite ?RInt_none; fld. Qed.
Lemma motion'from_work'1'holds : theorem'whole'1 -> work'F_s'ladder'1 -> work'F_s'ladder'2 -> work'W'ladder'1 -> motion'from_work'1.
Proof. unfold motion'from_work'1, theorem'whole'1, work'F_s'ladder'1, work'F_s'ladder'2, work'W'ladder'1;
  intros p_theorem'whole'1;
  intros p_work'F_s'ladder'1;
  intros p_work'F_s'ladder'2;
  intros p_work'W'ladder'1;
  assert (q6 : forall t : R, ta < t < tb -> ((ell * M * (theta_dot t) * g * (cos (theta t))) + (- (4 * (ell ^ 2) * (theta_dot t) * k * (cos (theta t)) * (sin (theta t)))) + (4 * (ell ^ 2) * (theta_dot t) * k * (sin (theta t)) * (cos theta_0)) + ((4 * (ell ^ 2) * M * (theta_dot t) * (theta_ddot t)) / 3)) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((RInt (fun x : R => (M * g * ell * (cos x))) theta_0 (theta u)) + (- (2 * (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta u)))) + ((2 * (ell ^ 2) * M * ((theta_dot u) ^ 2)) / 3) + (- ((2 * (ell ^ 2) * M * ((theta_dot 0) ^ 2)) / 3)))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_work'W'ladder'1 u Hu)); apply (less 1 _ _ (p_work'F_s'ladder'2 u Hu)); apply (less (- 1) _ _ (p_theorem'whole'1 u Hu)); apply (less 1 _ _ (p_work'F_s'ladder'1 u Hu)); fld | exact Ht | eapply D_eq; [der | fld]]);
  intros t Ht; intros g1; apply lin0; apply (less ((3 * (/ (ell ^ 2)) * (/ (M ^ 1)) * (/ ((theta_dot t) ^ 1))) / 4) _ _ (q6 t Ht)); fld. Qed.
Lemma kinetic'1'holds : kinetic'd1 -> kinetic'1.
Proof. unfold kinetic'1, kinetic'd1;
  intros p_kinetic'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_kinetic'd1 t Ht)); fld. Qed.
Lemma kinetic'2'holds : moment'ladder'd1 -> moment'ladder'2 -> turning'ladder'3 -> velocity'ladder'5 -> velocity'ladder'6 -> kinetic'2.
Proof. unfold kinetic'2, moment'ladder'd1, moment'ladder'2, turning'ladder'3, velocity'ladder'5, velocity'ladder'6;
  intros p_moment'ladder'd1;
  intros p_moment'ladder'2;
  intros p_turning'ladder'3;
  intros p_velocity'ladder'5;
  intros p_velocity'ladder'6;
  intros t Ht; apply lin0; apply (less (((omega_ladder t) ^ 2) / 2) _ _ (p_moment'ladder'd1 t Ht)); apply (less (((M * (V_cm_y t)) / 2) + ((ell * M * (theta_dot t) * (cos (theta t))) / 2)) _ _ (p_velocity'ladder'6 t Ht)); apply (less (((M * (V_cm_x t)) / 2) + (- ((ell * M * (theta_dot t) * (sin (theta t))) / 2))) _ _ (p_velocity'ladder'5 t Ht)); apply (less ((((/ (ell ^ 1)) * M * (omega_ladder t) * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell))) / 4) + (- (((/ (ell ^ 1)) * M * (theta_dot t) * (RInt (fun x : R => ((x + (- ell)) ^ 2)) 0 (2 * ell))) / 4))) _ _ (p_turning'ladder'3 t Ht)); apply (less (((theta_dot t) ^ 2) / 2) _ _ (p_moment'ladder'2 t Ht)); apply (less (((ell ^ 2) * M * ((theta_dot t) ^ 2)) / 2) _ _ (trig (theta t))); fld. Qed.
Lemma kinetic'3'holds : kinetic'3.
Proof. unfold kinetic'3;
  intros t Ht; apply lin0; fld. Qed.
Lemma potential'W'1'holds : potential'W'd1 -> potential'W'1.
Proof. unfold potential'W'1, potential'W'd1;
  intros p_potential'W'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_potential'W'd1 t Ht)); fld. Qed.
Lemma potential'W'2'holds : potential'W'd1 -> potential'W'2.
Proof. unfold potential'W'2, potential'W'd1;
  intros p_potential'W'd1;
  intros t Ht; apply (alike ta tb _ (fun t : R => (ell * M * g * (sin (theta t))))); [intros u Hu; apply lin0; apply (less 1 _ _ (p_potential'W'd1 u Hu)); fld | exact Ht |]; eapply D_eq; [der | apply lin0; fld]. Qed.
Lemma potential'F_s'1'holds : potential'F_s'd1 -> potential'F_s'1.
Proof. unfold potential'F_s'1, potential'F_s'd1;
  intros p_potential'F_s'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_potential'F_s'd1 t Ht)); fld. Qed.
Lemma potential'F_s'2'holds : potential'F_s'd1 -> potential'F_s'2.
Proof. unfold potential'F_s'2, potential'F_s'd1;
  intros p_potential'F_s'd1;
  intros t Ht; apply (alike ta tb _ (fun t : R => ((2 * (ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (4 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + (2 * (ell ^ 2) * k * ((cos theta_0) ^ 2))))); [intros u Hu; apply lin0; apply (less 1 _ _ (p_potential'F_s'd1 u Hu)); fld | exact Ht |]; eapply D_eq; [der | apply lin0; fld]. Qed.
Lemma split'F_s'1'holds : work'F_s'ladder'1 -> work'F_s'ladder'2 -> split'F_s'1.
Proof. unfold split'F_s'1, work'F_s'ladder'1, work'F_s'ladder'2;
  intros p_work'F_s'ladder'1;
  intros p_work'F_s'ladder'2;
  intros t Ht; apply lin0; apply (less (- 1) _ _ (p_work'F_s'ladder'2 t Ht)); apply (less 1 _ _ (p_work'F_s'ladder'1 t Ht)); fld. Qed.
Lemma split'F_s'2'holds : potential'F_s'd1 -> work'F_s'ladder'2 -> start'theta'd1 -> split'F_s'2.
Proof. unfold split'F_s'2, potential'F_s'd1, work'F_s'ladder'2, start'theta'd1;
  intros p_potential'F_s'd1;
  intros p_work'F_s'ladder'2;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)))) Begin); [intros u Hu; eapply D_eq; [der | cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less (1 / 2) _ _ (p_potential'F_s'd1 t Ht)); apply (less (- (1 / 2)) _ _ (p_potential'F_s'd1 0 Begin)); apply (less 1 _ _ (p_work'F_s'ladder'2 t Ht)); apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma energy'1'holds : kinetic'd1 -> kinetic'2 -> potential'W'd1 -> potential'F_s'd1 -> def'E'd1 -> energy'1.
Proof. unfold energy'1, kinetic'd1, kinetic'2, potential'W'd1, potential'F_s'd1, def'E'd1;
  intros p_kinetic'd1;
  intros p_kinetic'2;
  intros p_potential'W'd1;
  intros p_potential'F_s'd1;
  intros p_def'E'd1;
  intros t Ht; apply lin0; apply (less (- 1) _ _ (p_potential'F_s'd1 t Ht)); apply (less (- 1) _ _ (p_potential'W'd1 t Ht)); apply (less (- 1) _ _ (p_kinetic'd1 t Ht)); apply (less (- 1) _ _ (p_kinetic'2 t Ht)); apply (less 1 _ _ (p_def'E'd1 t Ht)); fld. Qed.
Lemma energy'2'holds : kinetic'd1 -> kinetic'2 -> potential'W'd1 -> potential'F_s'd1 -> energy'2.
Proof. unfold energy'2, kinetic'd1, kinetic'2, potential'W'd1, potential'F_s'd1;
  intros p_kinetic'd1;
  intros p_kinetic'2;
  intros p_potential'W'd1;
  intros p_potential'F_s'd1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_potential'F_s'd1 t Ht)); apply (less 1 _ _ (p_potential'W'd1 t Ht)); apply (less 1 _ _ (p_kinetic'd1 t Ht)); apply (less 1 _ _ (p_kinetic'2 t Ht)); fld. Qed.
Lemma energy'3'holds : def'E'd1 -> law'force'ladder'd1 -> law'force'ladder'd2 -> law'torque'ladder'd1 -> energy'3.
Proof. unfold energy'3, def'E'd1, law'force'ladder'd1, law'force'ladder'd2, law'torque'ladder'd1;
  intros p_def'E'd1;
  intros p_law'force'ladder'd1;
  intros p_law'force'ladder'd2;
  intros p_law'torque'ladder'd1;
  assert (q1 : forall t : R, ta < t < tb -> (((2 * (ell ^ 2) * M * ((theta_dot t) ^ 2)) / 3) + (ell * M * g * (sin (theta t))) + (2 * (ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (4 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + (- ((2 * (ell ^ 2) * M * ((theta_dot 0) ^ 2)) / 3)) + (- (ell * M * g * (sin (theta 0)))) + (- (2 * (ell ^ 2) * k * ((cos (theta 0)) ^ 2))) + (4 * (ell ^ 2) * k * (cos theta_0) * (cos (theta 0)))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => (((2 * (ell ^ 2) * M * ((theta_dot t) ^ 2)) / 3) + (ell * M * g * (sin (theta t))) + (2 * (ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (4 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + (- ((2 * (ell ^ 2) * M * ((theta_dot 0) ^ 2)) / 3)) + (- (ell * M * g * (sin (theta 0)))) + (- (2 * (ell ^ 2) * k * ((cos (theta 0)) ^ 2))) + (4 * (ell ^ 2) * k * (cos theta_0) * (cos (theta 0))))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (- (theta_dot u)) _ _ (p_law'torque'ladder'd1 u Hu)); apply (less (ell * (theta_dot u) * (cos (theta u))) _ _ (p_law'force'ladder'd2 u Hu)); apply (less (- (ell * (theta_dot u) * (sin (theta u)))) _ _ (p_law'force'ladder'd1 u Hu)); apply (less (- ((ell ^ 2) * M * (theta_dot u) * (theta_ddot u))) _ _ (trig (theta u))); fld] | cbv beta; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_def'E'd1 t Ht)); apply (less (- 1) _ _ (p_def'E'd1 0 Begin)); apply (less 1 _ _ (q1 t Ht)); fld. Qed.
Lemma square'theta'1'holds : energy'1 -> energy'2 -> energy'3 -> start'theta'd1 -> start'theta'd2 -> square'theta'1.
Proof. unfold square'theta'1, energy'1, energy'2, energy'3, start'theta'd1, start'theta'd2;
  intros p_energy'1;
  intros p_energy'2;
  intros p_energy'3;
  intros p_start'theta'd1;
  intros p_start'theta'd2;
  intros t Ht; apply lin0; apply (less (- ((3 * (/ (ell ^ 2)) * (/ (M ^ 1))) / 2)) _ _ (p_energy'2 t Ht)); apply (less (- ((3 * (/ (ell ^ 2)) * (/ (M ^ 1))) / 2)) _ _ (p_energy'1 t Ht)); apply (less ((3 * (/ (ell ^ 2)) * (/ (M ^ 1))) / 2) _ _ (p_energy'2 0 Begin)); apply (less ((3 * (/ (ell ^ 2)) * (/ (M ^ 1))) / 2) _ _ (p_energy'1 0 Begin)); apply (less ((3 * (/ (ell ^ 2)) * (/ (M ^ 1))) / 2) _ _ (p_energy'3 t Ht)); cbv beta; rewrite ?p_start'theta'd1, ?p_start'theta'd2; rewrite ?RInt_none; fld. Qed.
Lemma energy'rate'1'holds : energy'1 -> energy'2 -> energy'rate'1.
Proof. unfold energy'rate'1, energy'1, energy'2;
  intros p_energy'1;
  intros p_energy'2;
  intros t Ht; apply (alike ta tb _ (fun t : R => (((2 * (ell ^ 2) * M * ((theta_dot t) ^ 2)) / 3) + (ell * M * g * (sin (theta t))) + (2 * (ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (4 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + (2 * (ell ^ 2) * k * ((cos theta_0) ^ 2))))); [intros u Hu; apply lin0; apply (less 1 _ _ (p_energy'2 u Hu)); apply (less 1 _ _ (p_energy'1 u Hu)); fld | exact Ht |]; eapply D_eq; [der | apply lin0; fld]. Qed.
Lemma energy'rate'2'holds : energy'1 -> energy'2 -> energy'3 -> energy'rate'2.
Proof. unfold energy'rate'2, energy'1, energy'2, energy'3;
  intros p_energy'1;
  intros p_energy'2;
  intros p_energy'3;
  assert (q1 : forall t : R, ta < t < tb -> (((4 * (ell ^ 2) * M * (theta_dot t) * (theta_ddot t)) / 3) + (ell * M * (theta_dot t) * g * (cos (theta t))) + (- (4 * (ell ^ 2) * (theta_dot t) * k * (cos (theta t)) * (sin (theta t)))) + (4 * (ell ^ 2) * (theta_dot t) * k * (sin (theta t)) * (cos theta_0))) = 0) by (intros t Ht; apply (still ta tb (fun u : R => ((- (E_ 0)) + ((2 * (ell ^ 2) * M * ((theta_dot u) ^ 2)) / 3) + (ell * M * g * (sin (theta u))) + (2 * (ell ^ 2) * k * ((cos (theta u)) ^ 2)) + (- (4 * (ell ^ 2) * k * (cos (theta u)) * (cos theta_0))) + (2 * (ell ^ 2) * k * ((cos theta_0) ^ 2)))) t); [intros u Hu; cbv beta; apply (less 1 _ _ (p_energy'3 u Hu)); apply (less (- 1) _ _ (p_energy'2 u Hu)); apply (less (- 1) _ _ (p_energy'1 u Hu)); fld | exact Ht | eapply D_eq; [der | fld]]);
  intros t Ht; apply lin0; apply (less 1 _ _ (q1 t Ht)); fld. Qed.
Lemma motion'from_energy'1'holds : energy'rate'2 -> motion'from_energy'1.
Proof. unfold motion'from_energy'1, energy'rate'2;
  intros p_energy'rate'2;
  intros t Ht; intros g1; apply lin0; apply (less ((3 * (/ (ell ^ 2)) * (/ (M ^ 1)) * (/ ((theta_dot t) ^ 1))) / 4) _ _ (p_energy'rate'2 t Ht)); fld. Qed.
Lemma along'N_w'1'holds : reaction'N_w'1 -> square'theta'1 -> along'N_w'1.
Proof. unfold along'N_w'1, reaction'N_w'1, square'theta'1;
  intros p_reaction'N_w'1;
  intros p_square'theta'1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_reaction'N_w'1 t Ht)); apply (less (- (ell * M * (cos (theta t)))) _ _ (p_square'theta'1 t Ht)); apply (less ((3 * ell * k * (cos theta_0)) + (- (3 * ell * k * (cos (theta t))))) _ _ (trig (theta t))); fld. Qed.
Lemma along'N_f'1'holds : reaction'N_f'1 -> square'theta'1 -> along'N_f'1.
Proof. unfold along'N_f'1, reaction'N_f'1, square'theta'1;
  intros p_reaction'N_f'1;
  intros p_square'theta'1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_reaction'N_f'1 t Ht)); apply (less (- (ell * M * (sin (theta t)))) _ _ (p_square'theta'1 t Ht)); apply (less ((3 * M * g) / 2) _ _ (trig (theta t))); fld. Qed.
Lemma asks'N_w'1'holds : along'N_w'1 -> asks'N_w'1.
Proof. unfold asks'N_w'1, along'N_w'1;
  intros p_along'N_w'1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_along'N_w'1 t Ht)); fld. Qed.
Lemma asks'N_w'2'holds : asks'N_w'2.
Proof. unfold asks'N_w'2;
  intros t Ht; apply (above _ _ 1 0 (1 / 4)); [apply lin0; fld | pos | pos]. Qed.
Lemma asks'N_f'1'holds : along'N_f'1 -> asks'N_f'1.
Proof. unfold asks'N_f'1, along'N_f'1;
  intros p_along'N_f'1;
  intros t Ht; apply lin0; apply (less 1 _ _ (p_along'N_f'1 t Ht)); fld. Qed.
Lemma asks'N_f'2'holds : asks'N_f'2.
Proof. unfold asks'N_f'2;
  intros t Ht; apply (above _ _ 1 0 (1 / 4)); [apply lin0; fld | pos | pos]. Qed.
Lemma done'T'W'ladder'1'holds : work'W'ladder'1 -> start'theta'd1 -> done'T'W'ladder'1.
Proof. unfold done'T'W'ladder'1, work'W'ladder'1, start'theta'd1;
  intros p_work'W'ladder'1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((- (ell * M * g * (sin theta_0))) + (ell * M * g * (sin (theta t))) + (- (RInt (fun x : R => (M * g * ell * (cos x))) theta_0 (theta t)))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((- (ell * M * g * (sin theta_0))) + (ell * M * g * (sin (theta t))) + (- (RInt (fun x : R => (M * g * ell * (cos x))) theta_0 (theta t))))) Begin); [intros u Hu; eapply D_eq; [der | cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'W'ladder'1 t Ht)); apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma done'T'F_s'ladder'1'holds : work'F_s'ladder'1 -> start'theta'd1 -> done'T'F_s'ladder'1.
Proof. unfold done'T'F_s'ladder'1, work'F_s'ladder'1, start'theta'd1;
  intros p_work'F_s'ladder'1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)))) Begin); [intros u Hu; eapply D_eq; [der | cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'F_s'ladder'1 t Ht)); apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma done'theta'F_s'ladder'1'holds : work'F_s'ladder'2 -> start'theta'd1 -> done'theta'F_s'ladder'1.
Proof. unfold done'theta'F_s'ladder'1, work'F_s'ladder'2, start'theta'd1;
  intros p_work'F_s'ladder'2;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) + (- (2 * (ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + ((ell ^ 2) * k * ((cos theta_0) ^ 2)) + (RInt (fun x : R => (2 * k * (ell ^ 2) * ((cos x) + (- (cos theta_0))) * (sin x))) theta_0 (theta t)))) Begin); [intros u Hu; eapply D_eq; [der | cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'F_s'ladder'2 t Ht)); apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma done'T'N_w'ladder'1'holds : work'N_w'ladder'1 -> along'N_w'1 -> start'theta'd1 -> done'T'N_w'ladder'1.
Proof. unfold done'T'N_w'ladder'1, work'N_w'ladder'1, along'N_w'1, start'theta'd1;
  intros p_work'N_w'ladder'1;
  intros p_along'N_w'1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((- ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 4)) / 2)) + (3 * (ell ^ 2) * k * ((cos (theta t)) ^ 3) * (cos theta_0)) + (- ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 2) * ((cos theta_0) ^ 2)) / 2)) + (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) / 2) + (- ((ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + (((ell ^ 2) * k * ((cos theta_0) ^ 2)) / 2) + (- ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin (theta t))) / 4)) + ((3 * ell * M * g * (sin (theta t))) / 4) + ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin theta_0)) / 4) + (- ((3 * ell * M * g * (sin theta_0)) / 4)) + (- (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((- ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 4)) / 2)) + (3 * (ell ^ 2) * k * ((cos (theta t)) ^ 3) * (cos theta_0)) + (- ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 2) * ((cos theta_0) ^ 2)) / 2)) + (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) / 2) + (- ((ell ^ 2) * k * (cos (theta t)) * (cos theta_0))) + (((ell ^ 2) * k * ((cos theta_0) ^ 2)) / 2) + (- ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin (theta t))) / 4)) + ((3 * ell * M * g * (sin (theta t))) / 4) + ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin theta_0)) / 4) + (- ((3 * ell * M * g * (sin theta_0)) / 4)) + (- (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t)))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (- (ell * (theta_dot u) * (sin (theta u)))) _ _ (p_along'N_w'1 u Hu)); apply (less (- ((3 * ell * M * (theta_dot u) * g * (cos (theta u))) / 4)) _ _ (trig (theta u))); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'N_w'ladder'1 t Ht)); apply (less 1 _ _ (q1 t Ht)); apply (less (((3 * ell * M * g * (sin (theta t))) / 4) + (- ((3 * ell * M * g * (sin theta_0)) / 4))) _ _ (trig (theta t))); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma done'theta'N_w'ladder'1'holds : work'N_w'ladder'2 -> along'N_w'1 -> start'theta'd1 -> done'theta'N_w'ladder'1.
Proof. unfold done'theta'N_w'ladder'1, work'N_w'ladder'2, along'N_w'1, start'theta'd1;
  intros p_work'N_w'ladder'2;
  intros p_along'N_w'1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((- (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) / 2)) + ((ell ^ 2) * k * (cos (theta t)) * (cos theta_0)) + (- (((ell ^ 2) * k * ((cos theta_0) ^ 2)) / 2)) + ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 4)) / 2) + (- (3 * (ell ^ 2) * k * ((cos (theta t)) ^ 3) * (cos theta_0))) + ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 2) * ((cos theta_0) ^ 2)) / 2) + ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin (theta t))) / 4) + (- ((3 * ell * M * g * (sin (theta t))) / 4)) + (- ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin theta_0)) / 4)) + ((3 * ell * M * g * (sin theta_0)) / 4) + (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t)) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((- (((ell ^ 2) * k * ((cos (theta t)) ^ 2)) / 2)) + ((ell ^ 2) * k * (cos (theta t)) * (cos theta_0)) + (- (((ell ^ 2) * k * ((cos theta_0) ^ 2)) / 2)) + ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 4)) / 2) + (- (3 * (ell ^ 2) * k * ((cos (theta t)) ^ 3) * (cos theta_0))) + ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 2) * ((cos theta_0) ^ 2)) / 2) + ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin (theta t))) / 4) + (- ((3 * ell * M * g * (sin (theta t))) / 4)) + (- ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin theta_0)) / 4)) + ((3 * ell * M * g * (sin theta_0)) / 4) + (RInt (fun u : R => ((ell * (N_w u) * (sin (theta u))) * (theta_dot u))) 0 t))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (ell * (theta_dot u) * (sin (theta u))) _ _ (p_along'N_w'1 u Hu)); apply (less ((3 * ell * M * (theta_dot u) * g * (cos (theta u))) / 4) _ _ (trig (theta u))); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'N_w'ladder'2 t Ht)); apply (less 1 _ _ (q1 t Ht)); apply (less ((- ((3 * ell * M * g * (sin (theta t))) / 4)) + ((3 * ell * M * g * (sin theta_0)) / 4)) _ _ (trig (theta t))); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma done'T'N_f'ladder'1'holds : work'N_f'ladder'1 -> along'N_f'1 -> start'theta'd1 -> done'T'N_f'ladder'1.
Proof. unfold done'T'N_f'ladder'1, work'N_f'ladder'1, along'N_f'1, start'theta'd1;
  intros p_work'N_f'ladder'1;
  intros p_along'N_f'1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((- ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin theta_0)) / 4)) + ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin (theta t))) / 4) + (ell * M * g * (sin theta_0)) + (- (ell * M * g * (sin (theta t)))) + ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 4)) / 2) + (- (3 * (ell ^ 2) * k * ((cos (theta t)) ^ 3) * (cos theta_0))) + ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 2) * ((cos theta_0) ^ 2)) / 2) + (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t)) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((- ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin theta_0)) / 4)) + ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin (theta t))) / 4) + (ell * M * g * (sin theta_0)) + (- (ell * M * g * (sin (theta t)))) + ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 4)) / 2) + (- (3 * (ell ^ 2) * k * ((cos (theta t)) ^ 3) * (cos theta_0))) + ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 2) * ((cos theta_0) ^ 2)) / 2) + (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (ell * (theta_dot u) * (cos (theta u))) _ _ (p_along'N_f'1 u Hu)); apply (less (- ((3 * ell * M * (theta_dot u) * g * (cos (theta u))) / 2)) _ _ (trig (theta u))); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'N_f'ladder'1 t Ht)); apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma done'theta'N_f'ladder'1'holds : work'N_f'ladder'2 -> along'N_f'1 -> start'theta'd1 -> done'theta'N_f'ladder'1.
Proof. unfold done'theta'N_f'ladder'1, work'N_f'ladder'2, along'N_f'1, start'theta'd1;
  intros p_work'N_f'ladder'2;
  intros p_along'N_f'1;
  intros p_start'theta'd1;
  assert (q1 : forall t : R, ta < t < tb -> ((- (ell * M * g * (sin theta_0))) + (ell * M * g * (sin (theta t))) + ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin theta_0)) / 4) + (- ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin (theta t))) / 4)) + (- ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 4)) / 2)) + (3 * (ell ^ 2) * k * ((cos (theta t)) ^ 3) * (cos theta_0)) + (- ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 2) * ((cos theta_0) ^ 2)) / 2)) + (- (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t))) = 0) by (intros t Ht; apply (flat ta tb (fun t : R => ((- (ell * M * g * (sin theta_0))) + (ell * M * g * (sin (theta t))) + ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin theta_0)) / 4) + (- ((3 * ell * M * g * ((cos (theta t)) ^ 2) * (sin (theta t))) / 4)) + (- ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 4)) / 2)) + (3 * (ell ^ 2) * k * ((cos (theta t)) ^ 3) * (cos theta_0)) + (- ((3 * (ell ^ 2) * k * ((cos (theta t)) ^ 2) * ((cos theta_0) ^ 2)) / 2)) + (- (RInt (fun u : R => ((ell * (N_f u) * (cos (theta u))) * (theta_dot u))) 0 t)))) Begin); [intros u Hu; eapply D_eq; [der | apply (less (- (ell * (theta_dot u) * (cos (theta u)))) _ _ (p_along'N_f'1 u Hu)); apply (less ((3 * ell * M * (theta_dot u) * g * (cos (theta u))) / 2) _ _ (trig (theta u))); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld] | cbv beta; rewrite ?RInt_none; cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld | exact Ht]);
  intros t Ht; apply lin0; apply (less 1 _ _ (p_work'N_f'ladder'2 t Ht)); apply (less 1 _ _ (q1 t Ht)); cbv beta; rewrite ?p_start'theta'd1; rewrite ?RInt_none; fld. Qed.
Lemma balance'1'holds : law'motion'd1 -> law'motion'd2 -> law'motion'd3 -> balance'1.
Proof. unfold balance'1, law'motion'd1, law'motion'd2, law'motion'd3;
  intros p_law'motion'd1;
  intros p_law'motion'd2;
  intros p_law'motion'd3;
  intros t Ht; intros g1; apply lin0; apply (less (- ((4 * ell * M) / 3)) _ _ (g1)); apply (less (- (/ (ell ^ 1))) _ _ (p_law'motion'd3 t Ht)); apply (less (cos (theta t)) _ _ (p_law'motion'd2 t Ht)); apply (less (- (sin (theta t))) _ _ (p_law'motion'd1 t Ht)); apply (less (- (ell * M * (theta_ddot t))) _ _ (trig (theta t))); fld. Qed.
Definition all'of'it := (condition'N_w'1'holds, condition'N_f'1'holds, position'ladder'1'holds, position'ladder'2'holds, circle'ladder'1'holds, turning'ladder'1'holds, turning'ladder'2'holds, turning'ladder'3'holds, velocity'ladder'1'holds, velocity'ladder'2'holds, velocity'ladder'3'holds, velocity'ladder'4'holds, velocity'ladder'5'holds, velocity'ladder'6'holds, speed'ladder'1'holds, moment'ladder'1'holds, moment'ladder'2'holds, momentum'ladder'O'1'holds, momentum'ladder'O'2'holds, momentum'ladder'O'3'holds, force'W'ladder'1'holds, force'W'ladder'2'holds, force'W'ladder'3'holds, force'W'ladder'4'holds, force'F_s'ladder'1'holds, force'F_s'ladder'2'holds, force'F_s'ladder'3'holds, force'F_s'ladder'4'holds, force'N_w'ladder'1'holds, force'N_w'ladder'2'holds, force'N_w'ladder'3'holds, force'N_w'ladder'4'holds, force'N_f'ladder'1'holds, force'N_f'ladder'2'holds, force'N_f'ladder'3'holds, force'N_f'ladder'4'holds, torque'crossing'ladder'1'holds, balance'ladder'1'holds, motion'theta'1'holds, motion'theta'2'holds, motion'theta'3'holds, free_body'ladder'1'holds, free_body'ladder'2'holds, free_body'ladder'3'holds, reaction'N_w'1'holds, reaction'N_f'1'holds, motion'from_newton'theta'1'holds, work'W'ladder'1'holds, work'W'ladder'2'holds, work'F_s'ladder'1'holds, work'F_s'ladder'2'holds, work'N_w'ladder'1'holds, work'N_w'ladder'2'holds, work'N_f'ladder'1'holds, work'N_f'ladder'2'holds, workless'N_w'1'holds, workless'N_f'1'holds, spring'F_s'1'holds, spring'F_s'2'holds, spring'done'F_s'1'holds, spring'done'F_s'2'holds, theorem'T'ladder'1'holds, theorem'theta'ladder'1'holds, theorem'whole'1'holds, together'T'1'holds, together'T'2'holds, together'T'3'holds, together'T'4'holds, together'solved'1'holds, together'theta'1'holds, together'theta'2'holds, together'turned'1'holds, together'energy'1'holds, together'energy'2'holds, motion'from_work'1'holds, kinetic'1'holds, kinetic'2'holds, kinetic'3'holds, potential'W'1'holds, potential'W'2'holds, potential'F_s'1'holds, potential'F_s'2'holds, split'F_s'1'holds, split'F_s'2'holds, energy'1'holds, energy'2'holds, energy'3'holds, square'theta'1'holds, energy'rate'1'holds, energy'rate'2'holds, motion'from_energy'1'holds, along'N_w'1'holds, along'N_f'1'holds, asks'N_w'1'holds, asks'N_w'2'holds, asks'N_f'1'holds, asks'N_f'2'holds, done'T'W'ladder'1'holds, done'T'F_s'ladder'1'holds, done'theta'F_s'ladder'1'holds, done'T'N_w'ladder'1'holds, done'theta'N_w'ladder'1'holds, done'T'N_f'ladder'1'holds, done'theta'N_f'ladder'1'holds, balance'1'holds).
Print Assumptions all'of'it.
End Problem.
