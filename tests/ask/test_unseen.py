"""Problems of textbooks stated from the documentation alone, with answers worked out by hand before the engine was asked.

Kleppner & Kolenkow 3, 6, 10; Goldstein 1, 2; Landau & Lifshitz 5, 11, 15, 26; Morin 3, 6, 8; Beer & Johnston 13, 16, 17, 19;
Meriam & Kraige 5, 6, 8; Hibbeler 16-18, 22; Irodov 1.3; French 4, 5; Halliday & Resnick 10, 11.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from rbpsym.algebra.evaluate import scalar
from rbpsym.ask.asking import answered
from rbpsym.ask.moments import Asked
from rbpsym.equality.decide import scalars_equal
from rbpsym.notation.infix import read_infix
from rbpsym.statement.loader import load_text

HERE = Path(__file__).parent / "unseen"
ANSWERS = (
    ("inverted-spring", "frequency of theta", "sqrt(3*(k*a**2 - m*g*l/2)/(m*l**2))"),
    ("inverted-spring", "period of theta", "2*pi*sqrt(m*l**2/3/(k*a**2-m*g*l/2))"),
    ("inverted-spring", "smallest k for which theta = 0 is stable", "m*g*l/(2*a**2)"),
    ("hole", "S at the start", "m*M*(g + v_0**2/r_0)/(m+M)"),
    ("hole", "acceleration of r at the start", "(m*v_0**2/r_0 - M*g)/(m+M)"),
    ("hole", "v_0 for which acceleration of r at the start = 0", "sqrt(M*g*r_0/m)"),
    ("hole", "speed of theta as a function of r", "v_0*r_0/r**2"),
    ("hole", "angular momentum of puck about O", "m*v_0*r_0"),
    ("hole", "does angular momentum of puck about O depend on r", "no"),
    ("wedge", "acceleration of x", "-m*g*sin(beta)*cos(beta)/(M+m*sin(beta)**2)"),
    ("wedge", "N", "M*m*g*cos(beta)/(M+m*sin(beta)**2)"),
    ("wedge", "acceleration of s", "(M+m)*g*sin(beta)/(M+m*sin(beta)**2)"),
    ("wedge", "acceleration of s for M >> m", "g*sin(beta)"),
    ("wedge", "time until s = h/sin(beta)", "sqrt(2*h*(M+m*sin(beta)**2)/((M+m)*g))/sin(beta)"),
    ("wedge", "speed of wedge.cm where s = h/sin(beta)", "m*cos(beta)*sqrt(2*g*h/((M+m)*(M+m*sin(beta)**2)))"),
    ("peg", "tension T where theta = 0", "3*m*g"),
    ("peg", "tension where theta = 0", "3*m*g"),
    ("peg", "speed where theta = 0", "sqrt(2*g*L)"),
    ("peg", "speed of bob where theta = 0", "sqrt(2*g*L)"),
    ("peg", "theta for which T = m*g", "-acos(1/3)"),
    ("square-rule", "period of theta", "2*pi*sqrt(2*sqrt(2)*l/(3*g))"),
    ("square-rule", "moment of inertia of rule about O", "2*m*l**2/3"),
    ("square-rule", "moment of inertia of rule about rule.cm", "5*m*l**2/12"),
    ("square-rule", "distance from O to rule.cm", "sqrt(2)*l/4"),
    ("square-rule", "frequency of theta", "sqrt(3*g/(2*sqrt(2)*l))"),
    ("square-rule", "equilibrium of theta", "0"),
    ("plate-pins", "B at the start", "m*g/2"),
    ("plate-pins", "angular acceleration of plate when swinging begins", "-3*g*b/(2*(b**2+c**2))"),
    ("plate-pins", "A_y right after swinging", "m*g*(1 - 3*b**2/(4*(b**2+c**2)))"),
    ("plate-pins", "A_x when swinging begins", "-3*m*g*b*c/(4*(b**2+c**2))"),
    ("plate-pins", "magnitude of acceleration of plate.cm when swinging begins", "3*g*b/(4*sqrt(b**2+c**2))"),
    ("plate-pins", "A_y when swinging begins with c = b", "5*m*g/8"),
    ("crate-truck", "N_1", "m*g/2+m*A*h/(2*b)"),
    ("crate-truck", "N_2", "m*g/2-m*A*h/(2*b)"),
    ("crate-truck", "largest A for which it does not tip", "g*b/h"),
    ("crate-truck", "smallest A for which it tips", "g*b/h"),
    ("crate-truck", "A at which N_2 vanishes", "g*b/h"),
    ("flywheel", "phi where phi comes to rest", "I*omega_0**2/(2*tau)"),
    ("flywheel", "time until phi comes to rest", "I*omega_0/tau"),
    ("flywheel", "time until it comes to rest", "I*omega_0/tau"),
    ("flywheel", "energy lost until phi comes to rest", "I*omega_0**2/2"),
    ("flywheel", "phi as a function of t", "omega_0*t - tau*t**2/(2*I)"),
    ("flywheel", "speed of phi as a function of phi", "sqrt(omega_0**2-2*tau*phi/I)"),
    ("boat", "speed of x as a function of t", "v_0*exp(-b*t/m)"),
    ("boat", "x as a function of t", "m*v_0/b*(1-exp(-b*t/m))"),
    ("boat", "total way of x", "m*v_0/b"),
    ("boat", "speed of x as a function of x", "v_0 - b*x/m"),
    ("boat", "time until speed of x = v_0/2", "m*ln(2)/b"),
    ("boat", "x where speed of x = v_0/2", "m*v_0/(2*b)"),
    ("boat", "time until x = m*v_0/(2*b)", "m*ln(2)/b"),
    ("driven", "amplitude of x", "F_0/sqrt((k-m*Omega**2)**2+c**2*Omega**2)"),
    ("driven", "Omega for which amplitude of x is largest", "sqrt(k/m-c**2/(2*m**2))"),
    ("driven", "largest amplitude of x over Omega", "F_0/(c*sqrt(k/m-c**2/(4*m**2)))"),
    ("driven", "c for which x is critically damped", "2*sqrt(k*m)"),
    ("rod-and-spring", "angular acceleration of rod at the start", "-3*g/(2*L)"),
    ("rod-and-spring", "F_y at the start", "m*g/4"),
    ("sphere-bowl", "N where theta = 0", "m*g*(17-10*cos(theta_0))/7"),
    ("sphere-bowl", "period of theta", "2*pi*sqrt(7*(R-r)/(5*g))"),
    ("sphere-bowl", "speed of sphere.cm where theta = 0", "sqrt(10*g*(R-r)*(1-cos(theta_0))/7)"),
    ("struck-hinged", "angular velocity of rod when swing begins", "3*J*b/(M*L**2)"),
    ("struck-hinged", "impulse of F_x when swing begins", "J*(3*b/(2*L)-1)"),
    ("struck-hinged", "b for which impulse of F_x when swing begins vanishes", "2*L/3"),
    ("struck-hinged", "smallest J for which theta reaches pi", "M*L*sqrt(2*g*L/3)/b"),
    ("ballistic", "energy lost when stuck begins", "m*M*v_0**2/(2*(m+M))"),
    ("ballistic", "speed of theta when stuck begins", "m*v_0/((m+M)*L)"),
    ("pulley-spring", "period of theta", "2*pi*sqrt((m+M/2)/k)"),
    ("pulley-spring", "equilibrium of theta", "m*g/(k*R)"),
    ("pulley-spring", "amplitude of theta", "m*g/(k*R)"),
    ("pulley-spring", "largest theta", "2*m*g/(k*R)"),
    ("pulley-spring", "largest S", "m*g*(1+2*m/(2*m+M))"),
    ("pulley-spring", "theta as a function of t", "m*g/(k*R)*(1-cos(sqrt(2*k/(2*m+M))*t))"),
    ("cart-pendulum", "period of theta", "2*pi*sqrt(M*l/((m+M)*g))"),
    ("cart-pendulum", "speed of cart.cm where theta = 0", "m*sqrt(2*g*l*(1-cos(theta_0))/(M*(M+m)))"),
    ("cart-pendulum", "magnitude of speed of theta where theta = 0", "sqrt(2*g*(M+m)*(1-cos(theta_0))/(M*l))"),
    ("cart-pendulum", "x where theta = 0", "m*l*sin(theta_0)/(m+M)"),
    ("cart-pendulum", "magnitude of speed of theta as a function of theta",
     "sqrt(2*g*(M+m)*(cos(theta)-cos(theta_0))/(l*(M+m*sin(theta)**2)))"),
    ("three-springs", "lowest frequency of x_1", "sqrt(k/m)"),
    ("three-springs", "highest frequency of x_1", "sqrt((k+2*K)/m)"),
    ("three-springs", "ratio of x_2 to x_1 in the lowest mode", "1"),
    ("three-springs", "ratio of x_2 to x_1 in the highest mode", "-1"),
    ("large-swing", "period of theta", "2*pi*sqrt(l/g)"),
    ("large-swing", "largest T", "m*g*(3-2*cos(theta_0))"),
    ("large-swing", "T as a function of theta", "m*g*(3*cos(theta)-2*cos(theta_0))"),
    ("large-swing", "theta_0 for which T = 2*m*g where theta = 0", "pi/3"),
    ("bar-ends", "angular velocity of bar at the start", "v/(L*sin(theta_0))"),
    ("bar-ends", "speed of bar.end at the start", "v/tan(theta_0)"),
    ("bar-ends", "speed of bar.cm at the start", "v/(2*sin(theta_0))"),
    ("thread-incline", "acceleration of s", "2*g*(sin(beta)-2*mu*cos(beta))/3"),
    ("thread-incline", "S", "m*g*(sin(beta)+mu*cos(beta))/3"),
    ("thread-incline", "tension", "m*g*(sin(beta)+mu*cos(beta))/3"),
    ("thread-incline", "time until s = D", "sqrt(3*D/(g*(sin(beta)-2*mu*cos(beta))))"),
    ("thread-incline", "mu at which acceleration of s vanishes", "tan(beta)/2"),
    ("thread-incline", "acceleration of s with mu = 0", "2*g*sin(beta)/3"),
    ("plank-block", "speed of x when together begins", "m*v_0/(m+M)"),
    ("plank-block", "time until together", "M*v_0/(mu*g*(m+M))"),
    ("plank-block", "x - X when together begins", "M*v_0**2/(2*mu*g*(m+M))"),
    ("plank-block", "energy lost until together", "m*M*v_0**2/(2*(m+M))"),
    ("plank-block", "distance from plank.top to block.cm when together begins", "M*v_0**2/(2*mu*g*(m+M))"),
    ("hoist", "acceleration of y", "R*(tau-m*g*R)/(M*kappa**2+m*R**2)"),
    ("hoist", "S", "m*(g*M*kappa**2+tau*R)/(M*kappa**2+m*R**2)"),
    ("hoist", "tau for which acceleration of y = g/4 with kappa = R/2", "m*g*R + (M*R**2/4+m*R**2)*g/(4*R)"),
    ("hoist", "smallest tau for which acceleration of y > 0", "m*g*R"),
    ("car-braking", "acceleration of x", "-mu*g"),
    ("car-braking", "N_1", "m*g*(b+mu*h)/(a+b)"),
    ("car-braking", "N_2", "m*g*(a-mu*h)/(a+b)"),
    ("car-braking", "x where x comes to rest", "v_0**2/(2*mu*g)"),
    ("car-braking", "time until x comes to rest", "v_0/(mu*g)"),
    ("car-braking", "mu at which N_2 vanishes", "a/h"),
    ("rod-on-edge", "angular velocity of rod when bounced begins", "-3*(1+e)*v_0/(2*L)"),
    ("rod-on-edge", "impulse of J when bounced begins", "m*v_0*(1+e)/4"),
    ("rod-on-edge", "energy lost when bounced begins", "m*v_0**2*(1-e**2)/8"),
    ("rod-on-edge", "y component of velocity of rod.cm when bounced begins", "-v_0*(3-e)/4"),
    ("spring-orbit", "omega_0 for which acceleration of r at the start = 0", "sqrt(k*(r_0-l)/(m*r_0))"),
    ("spring-orbit", "speed of theta as a function of r", "omega_0*r_0**2/r**2"),
    ("spring-orbit", "acceleration of r at the start", "r_0*omega_0**2-k*(r_0-l)/m"),
    ("spring-orbit", "energy at the start", "m*r_0**2*omega_0**2/2+k*(r_0-l)**2/2"),
    ("toppling-rod", "N as a function of theta", "m*g*(1+9*cos(theta)**2-6*cos(theta)*cos(theta_0))/4"),
    ("toppling-rod", "f as a function of theta", "3*m*g*sin(theta)*(3*cos(theta)-2*cos(theta_0))/4"),
    ("toppling-rod", "theta where f vanishes", "acos(2*cos(theta_0)/3)"),
    ("toppling-rod", "speed of theta where theta = pi/2", "sqrt(3*g*cos(theta_0)/L)"),
    ("toppling-rod", "N where theta = pi/2", "m*g/4"),
    ("pulled-top", "acceleration of x", "2*F/(m*(1+c))"),
    ("pulled-top", "f", "F*(1-c)/(1+c)"),
    ("pulled-top", "acceleration of x with c = 1/2", "4*F/(3*m)"),
    ("pulled-top", "largest F for which it does not slip with c = 1/2", "3*mu*m*g"),
    ("pulled-top", "smallest mu for which it does not slip with c = 1/2", "F/(3*m*g)"),
    ("pulled-top", "c for which f vanishes", "1"),
    ("pulled-top", "F for which acceleration of x = g with c = 1/2", "3*m*g/4"),
    ("sphere-wall", "T", "m*g/cos(beta)"),
    ("sphere-wall", "N", "m*g*tan(beta)"),
    ("sphere-wall", "tension", "m*g/cos(beta)"),
    ("sphere-wall", "beta for which T = 2*m*g", "pi/3"),
    ("sphere-wall", "normal force", "m*g*tan(beta)"),
    ("sphere-wall", "T with beta = pi/6", "2*m*g/sqrt(3)"),
    ("sphere-wall", "for which beta is N = m*g", "pi/4"),
)  # fmt: skip


@cache
def asked(name: str) -> Asked:
    return Asked(load_text((HERE / f"{name}.toml").read_text(encoding="utf-8"), f"{name}.toml"))


@pytest.mark.parametrize(("name", "question", "worked_out"), ANSWERS, ids=lambda value: value[:60])
def test_it_finds_what_is_worked_out_by_hand(name: str, question: str, worked_out: str) -> None:
    found = answered(asked(name), question)
    assert found.verdict.is_proved, found.verdict
    if worked_out in ("yes", "no"):
        assert found.holds_so is (worked_out == "yes")
        return
    world = asked(name).world(0)
    wanted, given = scalar(read_infix(worked_out, [*world.names, "t"])), world.motion.assumptions
    assert any(scalars_equal(found, wanted, given).is_proved for found in found.values)
