(* Finitely many particles of positive masses, held rigidly, that move and turn in any smooth way under the forces that this takes:
   all that is assumed of a body holds for them. *)
Require Import FunctionalExtensionality.
Require Import Body.

Section Particles.
Variables (n : nat) (m a b : nat -> R) (X Y X1 Y1 X2 Y2 phi phi1 phi2 : R -> R).
Definition added (k : nat) (f : nat -> R) : R := sum_f_R0 (fun i => m i * f i) k.
Definition x (i : nat) (t : R) : R := a i * cos (phi t) + - (b i * sin (phi t)).
Definition y (i : nat) (t : R) : R := a i * sin (phi t) + b i * cos (phi t).
Definition f_x (i : nat) (t : R) : R := X2 t + - (phi2 t * y i t) + - (phi1 t * phi1 t * x i t).
Definition f_y (i : nat) (t : R) : R := Y2 t + phi2 t * x i t + - (phi1 t * phi1 t * y i t).

Lemma added_plus : forall k f g, added k (fun p => f p + g p) = added k f + added k g.
Proof. intros. unfold added. rewrite <- sum_plus. apply sum_eq. intros. ring. Qed.
Lemma added_times : forall k c f, added k (fun p => c * f p) = c * added k f.
Proof. intros. unfold added. rewrite scal_sum. apply sum_eq. intros. ring. Qed.
Lemma added_steady : forall k (f : nat -> R -> R), (forall p, steady (f p)) -> steady (total (added k) f).
Proof.
  intros k f C t. unfold total, added. induction k; simpl.
  - apply (C_mult (fun _ => m 0%nat) (f 0%nat)); [apply continuous_const | apply C].
  - apply (C_plus (fun u => sum_f_R0 (fun i => m i * f i u) k)); [exact IHk |].
    apply (C_mult (fun _ => m (S k)) (f (S k))); [apply continuous_const | apply C].
Qed.
Lemma has_integral : forall f t, steady f -> ex_RInt f 0 t.
Proof. intros f t C. apply (ex_RInt_continuous (V:=R_CompleteNormedModule)). intros u _. apply C. Qed.
Lemma added_works : forall k (f : nat -> R -> R) t, (forall p, steady (f p)) ->
  added k (fun p => RInt (f p) 0 t) = RInt (total (added k) f) 0 t.
Proof.
  intros k f t C. induction k.
  - symmetry. apply (RInt_scal (V:=R_CompleteNormedModule) (f 0%nat) 0 t (m 0%nat)), has_integral, C.
  - change (added k (fun p => RInt (f p) 0 t) + m (S k) * RInt (f (S k)) 0 t
      = RInt (fun u => plus (total (added k) f u) (scal (m (S k)) (f (S k) u))) 0 t).
    rewrite IHk, (RInt_plus (V:=R_CompleteNormedModule)), (RInt_scal (V:=R_CompleteNormedModule));
      [reflexivity | apply has_integral, C | apply has_integral, added_steady, C |].
    apply (ex_RInt_scal (V:=R_NormedModule)), has_integral, C.
Qed.

Theorem held_rigidly : (forall i, 0 < m i) -> added n a = 0 -> added n b = 0 ->
  moves X X1 /\ moves Y Y1 /\ moves X1 X2 /\ moves Y1 Y2 /\ moves phi phi1 /\ moves phi1 phi2 ->
  steady X2 /\ steady Y2 /\ steady phi2 ->
  let M := added n (fun _ => 1) in let I := added n (fun p => a p * a p + b p * b p) in
  0 < M /\ sums (added n) /\ motion X Y X1 Y1 X2 Y2 phi phi1 phi2 x y f_x f_y /\
  (forall t, total (added n) x t = 0 /\ total (added n) y t = 0 /\ total (added n) (fun p t => x p t * x p t + y p t * y p t) t = I) /\
  (forall t, total (added n) f_x t = M * X2 t /\ total (added n) f_y t = M * Y2 t) /\
  (forall t, total (added n) (fun p t => x p t * f_y p t + - (y p t * f_x p t)) t = I * phi2 t).
Proof.
  intros Pm A B Mo C M I.
  assert (L : sums (added n)) by (repeat split; intros;
    [apply added_plus | apply added_times | apply added_steady; assumption | apply added_works; assumption]).
  assert (Dx : forall p, moves (x p) (fun t => - (phi1 t * y p t))).
  { intros p. unfold x, y. destruct Mo as (_ & _ & _ & _ & D & _). intro t. eapply D_eq; [differ |]. cbv beta. ring. }
  assert (Dy : forall p, moves (y p) (fun t => phi1 t * x p t)).
  { intros p. unfold x, y. destruct Mo as (_ & _ & _ & _ & D & _). intro t. eapply D_eq; [differ |]. cbv beta. ring. }
  assert (TA : total (added n) (fun p _ => a p) = fun _ => 0) by (apply functional_extensionality; intro; exact A).
  assert (TB : total (added n) (fun p _ => b p) = fun _ => 0) by (apply functional_extensionality; intro; exact B).
  assert (T1 : total (added n) (fun _ _ => 1) = fun _ => M) by reflexivity.
  assert (Tx : total (added n) (fun p t => x p t) = fun _ => 0).
  { unfold x. repeat spread L. rewrite TA, TB. apply functional_extensionality. intro. ring. }
  assert (Ty : total (added n) (fun p t => y p t) = fun _ => 0).
  { unfold y. repeat spread L. rewrite TA, TB. apply functional_extensionality. intro. ring. }
  assert (Ti : total (added n) (fun p t => x p t * x p t + y p t * y p t) = fun _ => I).
  { replace (fun p t => x p t * x p t + y p t * y p t) with (fun p (_ : R) => a p * a p + b p * b p); [reflexivity |].
    do 2 (apply functional_extensionality; intro). unfold x, y. pose proof (trig (phi x1)). nra. }
  split; [| split; [exact L | split; [| split; [intro t; split; [| split] | split; [intro t; split |]]]]].
  - unfold M, added. clear - Pm. induction n; simpl; [| apply Rplus_lt_0_compat; [exact IHn0 |]]; rewrite Rmult_1_r; apply Pm.
  - unfold motion. split; [tauto | split; [tauto | split; [exact Dx | split; [exact Dy |]]]].
    destruct Mo as (D1 & D2 & D3 & D4 & D5 & D6), C as (C1 & C2 & C3). split; intro; unfold f_x, f_y; remain.
  - exact (equal_f Tx t).
  - exact (equal_f Ty t).
  - exact (equal_f Ti t).
  - unfold f_x; cbv beta. repeat spread L. rewrite T1, Tx, Ty. ring.
  - unfold f_y; cbv beta. repeat spread L. rewrite T1, Tx, Ty. ring.
  - intros t. unfold f_x, f_y. pose proof (equal_f Ti t) as E. revert E. repeat spread L. rewrite Tx, Ty. intros E. cbv beta in E. rewrite <- E. ring.
Qed.
End Particles.
