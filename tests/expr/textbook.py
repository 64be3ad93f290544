"""Formulas as physics texts write them, each with the expression that is meant (infix).

The names have dimensions, as those of a problem have. REFUSED holds what is open even so, or has an unknown name.
"""

from rbpsym.quantities import DIMENSIONS, Dimension

_NAMES = {
    "mass": "m M m_1 m_2 m_A m_B",
    "acceleration": "g a a_1 a_cm",
    "stiffness": "k k_1 k_2",
    "torsion stiffness": "kappa",
    "length": "ell L R r b d x y z h h_0 x_0 R_cm r_0 s q ell_1 ell_2 A B D",
    "time": "t t_0 T_0",
    "number": "n mu mu_s mu_k nu V_n",
    "angle": "theta theta_0 theta_1 theta_2 theta_max phi beta psi phi_0 delta epsilon varphi",
    "force": "T F N F_net N_w N_f P S W Q f T_1 T_2 F_x F_y F_0",
    "energy": "U E K U_0 tau tau_net W_T",
    "angular speed": "omega omega_0 omega_1 Omega theta_dot phi_dot gamma omega_d",
    "angular acceleration": "alpha theta_ddot phi_ddot",
    "speed": "v v_0 V V_cm x_dot y_dot r_dot v_1 v_2",
    "moment of inertia": "I I_cm I_O J I_1 I_2",
    "linear density": "lambda",
    "surface density": "sigma",
    "density": "rho",
    "damping": "c",
    "angular momentum": "L_O L_z",
    "momentum": "p p_x",
    "impulse": "J_0",
}
DIMENSION_OF: dict[str, Dimension] = {
    name: DIMENSIONS[kind] for kind, names in _NAMES.items() for name in names.split()
} | {"x_ddot": DIMENSIONS["acceleration"], "y_ddot": DIMENSIONS["acceleration"], "r_ddot": DIMENSIONS["acceleration"]}
NAMES = set(DIMENSION_OF)

ROWS = [
    line.split(" := ")
    for line in r"""
\frac12 m v^2 := m*v**2/2
\tfrac12 m v^2 := m*v**2/2
\dfrac{1}{2}mv^2 := m*v**2/2
\frac{1}{2}I_{cm}\omega^2 := I_cm*omega**2/2
\frac{1}{2}I_{\text{cm}}\omega^{2} := I_cm*omega**2/2
\frac12 I_{\mathrm{cm}}\dot\theta^2 := I_cm*theta_dot**2/2
\frac12 m\dot{x}^2+\frac12 k x^2 := m*x_dot**2/2 + k*x**2/2
m g \ell \cos\theta := m*g*ell*cos(theta)
mg\ell(1-\cos\theta) := m*g*ell*(1-cos(theta))
-mg\ell\sin\theta := -m*g*ell*sin(theta)
m\ell^2\ddot\theta := m*ell**2*theta_ddot
m\ell^{2}\ddot{\theta}+mg\ell\sin\theta := m*ell**2*theta_ddot + m*g*ell*sin(theta)
\ddot{\theta}+\frac{g}{\ell}\sin\theta := theta_ddot + g/ell*sin(theta)
\omega^2 r := omega**2*r
\frac{v^2}{R} := v**2/R
\frac{mv^2}{R} := m*v**2/R
\sqrt{\frac{g}{\ell}} := sqrt(g/ell)
\sqrt{g/\ell} := sqrt(g/ell)
2\pi\sqrt{\frac{\ell}{g}} := 2*pi*sqrt(ell/g)
2\pi\sqrt{\frac{I_O}{mgd}} := 2*pi*sqrt(I_O/(m*g*d))
\frac{2}{5}MR^2 := 2*M*R**2/5
\frac{2}{3} M R^{2} := 2*M*R**2/3
\frac{1}{12}ML^2 := M*L**2/12
\frac{1}{3}ML^2 := M*L**2/3
\frac{ML^2}{12}+M\left(\frac{L}{2}\right)^2 := M*L**2/12 + M*L**2/4
I_{cm}+Md^2 := I_cm + M*d**2
\frac{1}{2}M\left(a^2+b^2\right) := M*(a**2+b**2)/2
\frac{M}{12}(a^2+b^2) := M*(a**2+b**2)/12
\sin^2\theta+\cos^2\theta := sin(theta)**2+cos(theta)**2
\sin 2\theta := sin(2*theta)
\cos 2\theta := cos(2*theta)
\cos(\theta_1-\theta_2) := cos(theta_1-theta_2)
\sin(\theta_1 - \theta_2) := sin(theta_1-theta_2)
2\sin\theta\cos\theta := 2*sin(theta)*cos(theta)
A\cos(\omega t+\phi) := A*cos(omega*t+phi)
\theta_0\cos(\omega_0 t) := theta_0*cos(omega_0*t)
\tan\theta := tan(theta)
\frac{\sin\theta}{\cos\theta} := tan(theta)
\sin\frac{\theta}{2} := sin(theta/2)
2\sin^2\frac{\theta}{2} := 1-cos(theta)
\cos^2\frac{\theta}{2} := (1+cos(theta))/2
\sin^{2}\theta := sin(theta)**2
\left(\sin\theta\right)^2 := sin(theta)**2
\mu N := mu*N
\mu_s mg\cos\beta := mu_s*m*g*cos(beta)
g(\sin\beta-\mu\cos\beta) := g*(sin(beta)-mu*cos(beta))
g\left(\sin\beta - \mu\cos\beta\right) := g*(sin(beta)-mu*cos(beta))
\frac{2}{3}g\sin\beta := 2*g*sin(beta)/3
\frac{g\sin\beta}{1+\frac{I_{cm}}{MR^2}} := g*sin(beta)/(1+I_cm/(M*R**2))
\frac{m_1-m_2}{m_1+m_2}g := (m_1-m_2)*g/(m_1+m_2)
\frac{2m_1m_2}{m_1+m_2}g := 2*m_1*m_2*g/(m_1+m_2)
\frac{m_1 m_2}{m_1+m_2} := m_1*m_2/(m_1+m_2)
-kx := -k*x
-k(x-x_0) := -k*(x-x_0)
\frac{1}{2}k(x-x_0)^2 := k*(x-x_0)**2/2
\sqrt{\frac{k}{m}} := sqrt(k/m)
\frac{k}{m}x := k*x/m
v_0t+\frac12 at^2 := v_0*t+a*t**2/2
x_0+v_0 t+\tfrac{1}{2}a t^2 := x_0+v_0*t+a*t**2/2
v_0^2+2a(x-x_0) := v_0**2+2*a*(x-x_0)
\omega_0+\alpha t := omega_0+alpha*t
\omega_0^2+2\alpha\theta := omega_0**2+2*alpha*theta
\frac{\omega^2-\omega_0^2}{2} := (omega**2-omega_0**2)/2
M V_{cm}^2/2 := M*V_cm**2/2
MV_{\text{cm}}^2 := M*V_cm**2
F_{\text{net}} := F_net
F_{\mathrm{net}}-\mu N := F_net-mu*N
3\cos\theta-2\cos\theta_0 := 3*cos(theta)-2*cos(theta_0)
Mg(3\cos\theta-2\cos\theta_0) := M*g*(3*cos(theta)-2*cos(theta_0))
\frac{3g}{2\ell}(\sin\theta_0-\sin\theta) := 3*g*(sin(theta_0)-sin(theta))/(2*ell)
\frac{Mg}{4}\left(1-6\sin\theta\sin\theta_0+9\sin^2\theta\right) := M*g*(1-6*sin(theta)*sin(theta_0)+9*sin(theta)**2)/4
(a+b)(a-b) := a**2-b**2
(a+b)^2 := (a+b)**2
\left(a+b\right)^{2}-4ab := (a-b)**2
\frac{a}{b}+\frac{c}{d} := (a*d+b*c)/(b*d)
\frac{\frac{a}{b}}{\frac{c}{d}} := a*d/(b*c)
\frac{a+b}{c} := (a+b)/c
a^{-1} := 1/a
a^{1/2} := sqrt(a)
a^{-1/2} := 1/sqrt(a)
a^{3/2} := a*sqrt(a)
2^{3}a := 8*a
3.5a := 7*a/2
9.81 := 981/100
0.25\,m := m/4
a\cdot b := a*b
a\,b\,c := a*b*c
a\;b\quad c := a*b*c
{a}{b} := a*b
\lambda\mu\nu := lambda*mu*nu
\frac{\tau}{I_O} := tau/I_O
\rho\pi R^2 := rho*pi*R**2
\frac{M}{\pi R^2} := M/(pi*R**2)
\frac{4}{3}\pi R^3 := 4*pi*R**3/3
\pi(b^2-a^2) := pi*(b**2-a**2)
\exp(-\gamma t) := exp(-gamma*t)
\ln\frac{a}{b} := ln(a/b)
\arcsin\frac{2}{3} := asin(2/3)
\arccos x := acos(x)
\arctan\mu := atan(mu)
\sqrt{a^2+b^2-2ab\cos\theta} := sqrt(a**2+b**2-2*a*b*cos(theta))
\sqrt{x^2+y^2} := sqrt(x**2+y**2)
|x| := abs(x)
\left|x-y\right| := abs(x-y)
\dot\theta\dot\phi := theta_dot*phi_dot
\dot{\theta}^2+\dot{\phi}^2 := theta_dot**2+phi_dot**2
m\ddot x+kx := m*x_ddot+k*x
\ell\ddot\theta\cos\theta-\ell\dot\theta^2\sin\theta := ell*theta_ddot*cos(theta)-ell*theta_dot**2*sin(theta)
(M+m)\ddot{x} := (M+m)*x_ddot
\ddot x\cos\theta+\ell\ddot\theta+g\sin\theta := x_ddot*cos(theta)+ell*theta_ddot+g*sin(theta)
R\dot\phi-\dot x := R*phi_dot-x_dot
(R-r)\dot\theta := (R-r)*theta_dot
\frac{R-r}{r}\dot\theta := (R-r)*theta_dot/r
\left(1+\frac{r}{R}\right)\omega := (1+r/R)*omega
\left[1+\frac{a}{b}\right]c := (1+a/b)*c
\bigl(a+b\bigr)c := (a+b)*c
\Bigl[a-b\Bigr]^2 := (a-b)**2
\frac{MgR}{I_O}\sin\theta := M*g*R*sin(theta)/I_O
T\cos\theta-mg := T*cos(theta)-m*g
N-mg\cos\beta := N-m*g*cos(beta)
E-U := E-U
\frac{2(E-U)}{m} := 2*(E-U)/m
\sqrt{\frac{2}{m}(E-U)} := sqrt(2*(E-U)/m)
I\alpha-\tau := I*alpha-tau
\Omega^2-\omega_0^2 := Omega**2-omega_0**2
\frac{\kappa}{I} := kappa/I
\sqrt{\kappa/I} := sqrt(kappa/I)
\psi+\delta := psi+delta
\frac{P}{M+m} := P/(M+m)
Q\,S-\frac{J}{K} := Q*S-J/K
\left(\frac{a}{b}\right)^{2} := a**2/b**2
\frac{1}{\sqrt{2}} := sqrt(2)/2
\frac{\sqrt3}{2}a := sqrt(3)*a/2
\sqrt{3}\,a := sqrt(3)*a
\frac{\pi}{2}-\theta := pi/2-theta
\cos\left(\frac{\pi}{2}-\theta\right) := sin(theta)
\sin(\pi-\theta) := sin(theta)
m(\ell-x)g := m*(ell-x)*g
\frac{x}{\ell}mg := m*g*x/ell
\frac{\ell-x}{\ell}\,W := W*(ell-x)/ell
z\beta\gamma := z*beta*gamma
\cos\omega t := cos(omega*t)
A\sin\omega t+B\cos\omega t := A*sin(omega*t) + B*cos(omega*t)
A\cos\omega_0 t := A*cos(omega_0*t)
A\cos\omega_{0}t := A*cos(omega_0*t)
\theta_0\cos\omega t := theta_0*cos(omega*t)
\theta_{\text{max}}\cos\Omega t := theta_max*cos(Omega*t)
A e^{-\gamma t}\cos\omega_d t := A*exp(-gamma*t)*cos(omega_d*t)
e^{-ct/2m} := exp(-c*t/(2*m))
e^{x/L} := exp(x/L)
\mathrm{e}^{\mu\theta} := exp(mu*theta)
F_0\cos\Omega t/m := F_0*cos(Omega*t)/m
\frac{F_0}{m}\cos\Omega t := F_0*cos(Omega*t)/m
\sin\frac{2\pi}{T_0}t := sin(2*pi*t/T_0)
A\sin\frac{2\pi x}{L} := A*sin(2*pi*x/L)
\sin\pi x/L := sin(pi*x/L)
A\sin\pi x/L := A*sin(pi*x/L)
\cos\sqrt{\frac{g}{\ell}}t := cos(sqrt(g/ell)*t)
\cos\sqrt{k/m}\,t := cos(sqrt(k/m)*t)
\cos\omega(t-t_0) := cos(omega*(t-t_0))
A\cos\left[\omega(t-t_0)\right] := A*cos(omega*(t-t_0))
\sin\omega\,t := sin(omega*t)
\cos 2\omega t := cos(2*omega*t)
\cos 2\pi n := cos(2*pi*n)
\frac{3}{4}Mg\cos\theta(3\sin\theta-2\sin\theta_0) := 3*M*g*cos(theta)*(3*sin(theta)-2*sin(theta_0))/4
\frac{3}{4}Mg\cos\theta\left(3\sin\theta-2\sin\theta_0\right) := 3*M*g*cos(theta)*(3*sin(theta)-2*sin(theta_0))/4
mg\sin\theta(1+\cos\theta) := m*g*sin(theta)*(1+cos(theta))
\ell^2\left(\dot\theta^2+\sin^2\theta\,\dot\phi^2\right) := ell**2*(theta_dot**2+sin(theta)**2*phi_dot**2)
\sin\theta\,\dot\phi := sin(theta)*phi_dot
\sin\theta\dot\phi := sin(theta)*phi_dot
\dot\phi\cos\theta\dot\theta := phi_dot*cos(theta)*theta_dot
\sin\theta\,\cos\phi := sin(theta)*cos(phi)
\cos\theta mg := cos(theta)*m*g
\sin\beta\;mg := sin(beta)*m*g
\mu\cos\beta\,mg := mu*cos(beta)*m*g
\cos\theta_{0}\,\ell := cos(theta_0)*ell
\cos\theta_{0}\ell := cos(theta_0)*ell
\ell\sin\theta/R := ell*sin(theta)/R
g\sin\beta/R := g*sin(beta)/R
\cos^2\theta/r^2 := cos(theta)**2/r**2
\left\{a+b\right\}c := (a+b)*c
m\{\ell\omega-v\} := m*(ell*omega-v)
\frac{g\sin\beta}{1+I_{cm}/MR^2} := g*sin(beta)/(1+I_cm/(M*R**2))
\frac{g\sin\beta}{1+I_{cm}/(MR^2)} := g*sin(beta)/(1+I_cm/(M*R**2))
\frac{2gh}{1+I/mr^2} := 2*g*h/(1+I/(m*r**2))
\sqrt{2gh/(1+I/mr^2)} := sqrt(2*g*h/(1+I/(m*r**2)))
v+F_0t/m_1 := v + F_0*t/m_1
a+F_0/m\ell\omega_0^2\,g := a+F_0/(m*ell*omega_0**2)*g
\omega^2-3g/2\ell := omega**2-3*g/(2*ell)
1/2mv^2+mgh := m*v**2/2+m*g*h
1/2\,k\,x^2 := k*x**2/2
\frac{1}{2\pi}\sqrt{\frac{k}{m}} := sqrt(k/m)/(2*pi)
\omega_0/2\pi := omega_0/(2*pi)
mgh_0 := m*g*h_0
\frac{1}{2}(I_1+I_2) := (I_1+I_2)/2
e^{-\gamma t} := exp(-gamma*t)
R_{\mathrm{cm}} := R_cm
V_{\rm cm}^2 := V_cm**2
V^2_{cm} := V_cm**2
v_0^{2}/2g := v_0**2/(2*g)
h-v_0^2/2g := h-v_0**2/(2*g)
|v| := abs(v)
|\dot x| := abs(x_dot)
\mu_k m|g|\cos\beta := mu_k*m*abs(g)*cos(beta)
2(m_A+m_B)g := 2*(m_A+m_B)*g
\frac{m_A-m_B}{m_A+m_B+I/R^2}\,g := (m_A-m_B)*g/(m_A+m_B+I/R**2)
\tfrac{7}{10}mv^2 := 7*m*v**2/10
\tfrac 25 m r^2 := 2*m*r**2/5
\frac25mr^2 := 2*m*r**2/5
\frac 1{12}m\ell^2 := m*ell**2/12
\frac{\ell}2 := ell/2
\frac\ell2\cos\theta := ell*cos(theta)/2
\sqrt2\,\ell := sqrt(2)*ell
\sqrt{3g(1-\cos\theta_0)/\ell} := sqrt(3*g*(1-cos(theta_0))/ell)
\left(\frac{\ell}{2}\dot\theta\right)^2 := ell**2*theta_dot**2/4
{\textstyle\frac12}mv^2 := m*v**2/2
m\ell^2\dot\theta\dot\phi\cos(\theta-\phi) := m*ell**2*theta_dot*phi_dot*cos(theta-phi)
T-mg\cos\theta-m\ell\dot\theta^2 := T-m*g*cos(theta)-m*ell*theta_dot**2
\varphi+\phi := varphi+phi
2\times 3.5\times 10^{2}\,m := 700*m
1{,}5\,m := 3*m/2
\frac{L_{O}}{I_O} := L_O/I_O
m\,\mathrm{g} := m*g
""".strip().splitlines()
]

REFUSED = r"""
\omega^2-g/\ell\sin\theta
\alpha+3g/2\ell\cos\theta
1/2\pi
\sin\theta/2
\cos n\theta
\sin\theta^2
\sin^{-1}\mu
mgx\sin\theta+
e^{2}
""".strip().splitlines()

CALCULUS = [  # where no d is a symbol
    line.split(" := ")
    for line in r"""
\frac{d\theta}{dt} := theta_dot
\frac{\mathrm{d}\theta}{\mathrm{d}t} := theta_dot
\frac{d^2\theta}{dt^2} := theta_ddot
\frac{\mathrm d^2 x}{\mathrm d t^2} := x_ddot
m\frac{d^2x}{dt^2}+kx := m*x_ddot+k*x
\frac{d}{dt}(x^2) := 2*x*x_dot
d\theta/dt := theta_dot
\frac{\partial}{\partial x}\left(\frac12kx^2\right) := k*x
\int_0^{L}\frac{M}{L}x^2\,dx := M*L**2/3
\int_0^R 2\pi\rho r^3\,dr := pi*rho*R**4/2
\int_{-L/2}^{L/2}x^2\lambda\,\mathrm dx := lambda*L**3/12
\int_{0}^{\theta_0}mg\ell\sin\theta\,d\theta := m*g*ell*(1-cos(theta_0))
\int_{\theta_0}^{\theta}d\theta\,mg\ell\sin\theta := m*g*ell*(cos(theta_0)-cos(theta))
""".strip().splitlines()
]
