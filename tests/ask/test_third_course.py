"""Problems of kinds that were not tried before, worked out by hand before the engine was asked: what is driven and turns freely,
resistances the other way round, limits of equilibrium, gears, tapered and drilled bodies, conveyors, linkages at an instant.

Meriam & Kraige 3, 5, 6, 8; Beer & Johnston 8-10, 15-17, 19; Hibbeler 8, 12, 16-19; Kleppner & Kolenkow 3, 6, 7; Morin 3-5, 8;
French 4, 7; Irodov 1.2, 1.3, 1.5; Timoshenko & Young; Marion 2, 9.
"""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered
from rbpsym.errors import StatementError
from rbpsym.typeset.machine import to_machine
from tests.ask.test_unseen import asked
from tests.ask.test_unseen import test_it_finds_what_is_worked_out_by_hand as found

ANSWERS = (
    ("truss", "magnitude of T", "P*a/(2*h)"),
    ("truss", "magnitude of C", "P*sqrt(a**2 + h**2)/(2*h)"),
    ("truss", "N", "P/2"),
    ("brake-hoist", "smallest P for which s comes to rest", "m*g/mu"),
    ("brake-hoist", "largest m for which it stops", "mu*P/g"),
    ("brake-hoist", "energy lost until s comes to rest", "mu*P*v_0**2*(2*m + M)/(4*(mu*P - m*g))"),
    ("telescope", "speed of phi as a function of t", "omega_0*(I+m*r_0**2)/(I+m*(r_0+u*t)**2)"),
    ("telescope", "speed of phi where t = r_0/u", "omega_0*(I+m*r_0**2)/(I+4*m*r_0**2)"),
    ("telescope", "D as a function of t", "-m*(r_0+u*t)*omega_0**2*(I+m*r_0**2)**2/(I+m*(r_0+u*t)**2)**2"),
    ("telescope", "angular momentum of arm about O at the start", "I*omega_0"),
    ("telescope", "total angular momentum about O", "(I+m*r_0**2)*omega_0"),
    ("telescope", "kinetic energy where t = r_0/u", "(I+m*r_0**2)**2*omega_0**2/(2*(I+4*m*r_0**2)) + m*u**2/2"),
    ("telescope", "phi as a function of t",
     "omega_0*(I+m*r_0**2)/(u*sqrt(m*I))*(atan(sqrt(m/I)*(r_0+u*t))-atan(sqrt(m/I)*r_0))"),
    ("ball-up-drag", "y where y comes to rest", "m/(2*k)*ln(1+k*v_0**2/(m*g))"),
    ("ball-up-drag", "time until y comes to rest", "sqrt(m/(g*k))*atan(v_0*sqrt(k/(m*g)))"),
    ("ball-up-drag", "y where speed of y = v_0/2", "m/(2*k)*ln((m*g+k*v_0**2)/(m*g+k*v_0**2/4))"),
    ("ball-up-drag", "work of D until y comes to rest", "m**2*g/(2*k)*ln(1+k*v_0**2/(m*g)) - m*v_0**2/2"),
    ("ball-down-drag", "terminal speed of s", "sqrt(m*g/k)"),
    ("ball-down-drag", "s where speed of s = sqrt(m*g/k)/2", "m/(2*k)*ln(4/3)"),
    ("ball-down-drag", "time until speed of s = sqrt(m*g/k)/2", "sqrt(m/(g*k))*ln(3)/2"),
    ("roll-resist", "acceleration of s", "2*g*(sin(beta) - b*cos(beta)/R)/3"),
    ("roll-resist", "beta for which acceleration of s vanishes", "atan(b/R)"),
    ("roll-resist", "time until s = D", "sqrt(3*D/(g*(sin(beta)-b*cos(beta)/R)))"),
    ("roll-resist", "magnitude of f", "m*g*(sin(beta)+2*b*cos(beta)/R)/3"),
    ("roll-resist", "energy lost until s = D", "m*g*b*D*cos(beta)/R"),
    ("roll-resist", "mu for which it does not slip", "(tan(beta)+2*b/R)/3"),
    ("roll-resist", "smallest beta for which acceleration of s is positive", "atan(b/R)"),
    ("disk-from-disk", "acceleration of y", "-2*g*(M+m)/(3*M+2*m)"),
    ("disk-from-disk", "S", "m*g*M/(3*M+2*m)"),
    ("disk-from-disk", "angular acceleration of falling with m = M", "-2*g/(5*R)"),
    ("disk-from-disk", "acceleration of y for M >> m", "-2*g/3"),
    ("disk-from-disk", "speed of y where y = -h", "-2*sqrt(g*h*(M+m)/(3*M+2*m))"),
    ("disk-from-disk", "time until y = -h", "sqrt(h*(3*M+2*m)/(g*(M+m)))"),
    ("disk-from-disk", "ratio of kinetic energy of falling to kinetic energy of pulley with m = M", "9"),
    ("rod-drop", "magnitude of angular velocity of rod when bounced begins",
     "6*cos(theta_0)*(1+e)*v/(L*(1+3*cos(theta_0)**2))"),
    ("rod-drop", "magnitude of impulse of J when bounced begins", "(1+e)*m*v/(1+3*cos(theta_0)**2)"),
    ("rod-drop", "energy lost when bounced begins", "m*v**2*(1-e**2)/(2*(1+3*cos(theta_0)**2))"),
    ("rod-drop", "speed of y when bounced begins", "v*(e - 3*cos(theta_0)**2)/(1+3*cos(theta_0)**2)"),
    ("rod-drop", "e for which speed of y when bounced begins = 0", "3*cos(theta_0)**2"),
    ("rod-drop", "theta_0 for which magnitude of angular velocity of rod when bounced begins is largest", "acos(1/sqrt(3))"),
    ("conveyor", "time until carried", "u/(mu*g)"),
    ("conveyor", "x when carried begins", "u**2/(2*mu*g)"),
    ("conveyor", "work of f on crate until carried", "m*u**2/2"),
    ("conveyor", "kinetic energy of crate when carried begins", "m*u**2/2"),
    ("conveyor", "acceleration of x at the start", "mu*g"),
    ("conveyor", "minus work of D until carried", "-m*u**2"),
    ("conveyor", "mu for which x when carried begins = L", "u**2/(2*g*L)"),
    ("bead-spring-arm", "equilibrium of r", "k*ell/(k-m*Omega**2)"),
    ("bead-spring-arm", "frequency of r", "sqrt(k/m-Omega**2)"),
    ("bead-spring-arm", "largest Omega for which equilibrium of r is stable", "sqrt(k/m)"),
    ("bead-spring-arm", "r as a function of t", "ell*(k-m*Omega**2*cos(sqrt(k/m-Omega**2)*t))/(k-m*Omega**2)"),
    ("bead-spring-arm", "N as a function of t", "2*m*Omega**3*ell*sin(sqrt(k/m-Omega**2)*t)/sqrt(k/m-Omega**2)"),
    ("power-car", "x as a function of t", "m/(3*P)*((v_0**2+2*P*t/m)**(3/2)-v_0**3)"),
    ("power-car", "x where speed of x = 2*v_0", "7*m*v_0**3/(3*P)"),
    ("power-car", "time until speed of x = 2*v_0", "3*m*v_0**2/(2*P)"),
    ("motorboat", "time until s = D", "m/c*ln(1/(1-c*D/(m*v_0)))"),
    ("motorboat", "speed of s where s = D", "v_0-c*D/m"),
    ("best-bob", "d for which period of theta is least", "L*(-M + sqrt(M**2+4*m*M/3))/(2*m)"),
    ("best-bob", "d for which period of theta is least with m = M", "L*(sqrt(21)-3)/6"),
    ("best-bob", "period of theta in the limit m -> 0", "2*pi*sqrt(2*L/(3*g))"),
    ("spool", "f", "-P*(I_c+m*R*r)/(I_c+m*R**2)"),
    ("spool", "largest P for which it does not slip", "mu*m*g*(I_c+m*R**2)/(I_c+m*R*r)"),
    ("spool", "time until x = D", "sqrt(2*D*(I_c+m*R**2)/(P*(R-r)*R))"),
    ("spool", "r for which f = -P/2", "(m*R**2-I_c)/(2*m*R)"),
    ("geared-hoist", "acceleration of y", "r_3*(tau*r_2/r_1 - m*g*r_3)/(I_2 + I_1*r_2**2/r_1**2 + m*r_3**2)"),
    ("geared-hoist", "magnitude of F",
     "tau/r_1 - I_1*(r_2/r_1**2)*(tau*r_2/r_1 - m*g*r_3)/(I_2 + I_1*r_2**2/r_1**2 + m*r_3**2)"),
    ("geared-hoist", "r_2 for which acceleration of y is largest",
     "r_1*(I_1*m*g*r_3 + sqrt(I_1**2*m**2*g**2*r_3**2 + I_1*tau**2*(I_2+m*r_3**2)))/(I_1*tau)"),
    ("flywheel-rod", "frequency of theta", "Omega*sqrt(3*a/(2*L))"),
    ("flywheel-rod", "magnitude of speed of theta where theta = 0", "Omega*sqrt(3*a*(1-cos(theta_0))/L)"),
    ("flywheel-rod", "a for which frequency of theta = Omega", "2*L/3"),
    ("car-pendulum", "equilibrium of theta", "-atan(A/g)"),
    ("car-pendulum", "period of theta", "2*pi*sqrt(L/sqrt(g**2+A**2))"),
    ("car-pendulum", "theta where theta comes to rest", "-2*atan(A/g)"),
    ("fourbar", "angular velocity of rocker at the start", "a*Omega/c"),
    ("fourbar", "angular acceleration of coupler at the start", "a*Omega**2*(1-a/c)/b"),
    ("shaft", "highest frequency of alpha", "sqrt(kappa*(I_1+I_2)/(I_1*I_2))"),
    ("shaft", "beta as a function of t", "theta_0*I_1*(1-cos(sqrt(kappa*(I_1+I_2)/(I_1*I_2))*t))/(I_1+I_2)"),
    ("shaft", "largest beta", "2*theta_0*I_1/(I_1+I_2)"),
    ("disk-up", "time until rolling", "v_0/(g*(sin(beta)+3*mu*cos(beta)))"),
    ("disk-up", "speed of s when rolling begins", "2*mu*cos(beta)*v_0/(sin(beta)+3*mu*cos(beta))"),
    ("disk-up", "s where s comes to rest in phase rolling",
     "v_0**2/(2*g*(sin(beta) + 3*mu*cos(beta)))*(1 + 2*mu*cos(beta)/sin(beta))"),
    ("slope-drive", "largest beta for which it does not slip", "atan(mu*b/(L-mu*h))"),
    ("slope-drive", "beta at which N_f vanishes", "atan((L-b)/h)"),
    ("slope-drive", "h for which N_f = N_r", "L*(1-2*b/L)/(2*tan(beta))"),
    ("ladder2", "smallest theta for which it does not slip", "atan((1-mu_1*mu_2)/(2*mu_1))"),
    ("ladder2", "N_w", "m*g/(2*(tan(theta)+mu_2))"),
    ("ladder2", "mu_1 for which it does not slip", "1/(2*tan(theta)+mu_2)"),
    ("hauled-boat", "acceleration of x at the start", "-u**2*h**2/x_0**3"),
    ("hauled-boat", "N at the start", "m*g - m*u**2*h**3/x_0**4"),
    ("hoop-loop", "smallest v_0 for which theta reaches pi", "sqrt(3*g*(R-r))"),
    ("hoop-loop", "magnitude of f where theta = pi/2", "m*g/2"),
    ("hoop-off", "magnitude of f as a function of theta", "m*g*sin(theta)/2"),
    ("hoop-off", "N where theta = acos(4/5)", "3*m*g/5"),
    ("drilled", "moment of inertia of plate about corner", "M*(2*a**2/3 - pi*R**4/(2*a**2) - pi*R**2/2)"),
    ("tapered", "moment of inertia of rod about rod.cm", "13*M*ell**2/162"),
    ("wheel-step-top", "smallest P for which N vanishes", "m*g*sqrt(h/(2*R-h))"),
    ("wheel-step-top", "h for which N = 0", "2*P**2*R/(m**2*g**2+P**2)"),
    ("spinning-rod", "component of force N on outer along outer", "-m*Omega**2*(L**2-r**2)/(2*L)"),
    ("ball-block-slide", "X where X comes to rest in phase hit", "(1+e)**2*m**2*v**2/(2*mu*g*(m+M)**2)"),
    ("ball-block-slide", "e for which X where X comes to rest in phase hit = m**2*v**2/(mu*g*(m+M)**2)", "sqrt(2)-1"),
    ("cyl-string", "smallest mu for which it does not slip", "sin(beta)/(1+cos(beta))"),
    ("cyl-string", "largest beta for which it does not slip", "2*atan(mu)"),
    ("ladder-man", "largest x_m for which it does not slip", "L*(mu*(m+M)*tan(theta) - m/2)/M"),
    ("incline-force", "smallest P for which it does not slip", "m*g*(sin(beta)-mu*cos(beta))"),
    ("tip-or-slide", "largest P for which it does not tip", "m*g*b/(2*h)"),
    ("ball-down-drag", "time until s = h", "sqrt(m/(k*g))*ln(exp(k*h/m)+sqrt(exp(2*k*h/m)-1))"),
    ("hoop-off", "theta when N slips with mu = 1/2", "2*atan(1/3)"),
    ("bead-spring-arm", "is the equilibrium of r stable", "yes"),
    ("two-stones", "time until y_1 meets y_2", "h/v_0"),
)


@pytest.mark.parametrize(("name", "question", "worked_out"), ANSWERS, ids=lambda value: value[:60])
def test_it_finds_what_is_worked_out_by_hand(name: str, question: str, worked_out: str) -> None:
    found(name, question, worked_out)


def test_a_condition_of_several_quantities_is_known_of_what_it_is_a_factor_of() -> None:
    answer = answered(asked("roll-resist"), "time until s = D")
    assert [to_machine(node) for node in answer.valid] == ["R*sin(beta) - b*cos(beta) > 0"]


def test_conditions_on_inverse_functions_are_told_of_their_arguments_once() -> None:
    answer = answered(asked("ball-up-drag"), "y as a function of speed of y")
    assert [to_machine(node) for node in answer.valid] == ["v_0 - v > 0"] and answer.says == "v is the speed of y"


@pytest.mark.parametrize(
    ("name", "question", "text"),
    [
        ("ball-up-drag", "y as a function of speed of y", "m/(2*k)*log((m*g + k*v_0**2)/(m*g + k*v**2))"),
        ("power-car", "t as a function of speed of x", "m*(v**2 - v_0**2)/(2*P)"),
        ("power-car", "x as a function of speed of x", "m*(v - v_0)*(v_0**2 + v_0*v + v**2)/(3*P)"),
        ("motorboat", "t as a function of s", "m/c*log(m*v_0/(m*v_0 - c*s_1))"),
        ("motorboat", "s as a function of speed of s", "m*(v_0 - v)/c"),
        ("spool", "time until x = D", "sqrt(2*D*(m*R**2 + I_c)/(P*R*(R - r)))"),
        ("slope-drive", "largest beta for which it does not slip", "atan(mu*b/(L - mu*h))"),
        ("ball-down-drag", "terminal speed of s", "sqrt(m*g/k)"),
    ],
)
def test_the_text_is_as_neat_as_what_is_printed_and_inverse_functions_have_a_letter(name: str, question: str, text: str) -> None:
    assert answered(asked(name), question).text == text


def test_what_vanishes_beyond_the_limit_of_friction_is_refused_with_its_reason() -> None:
    with pytest.raises(StatementError, match="friction reaches its limit, before"):
        answered(asked("hoop-off"), "theta where N vanishes")


def test_the_case_that_swings_is_told_where_nothing_says_which_it_is() -> None:
    answer = answered(asked("bead-spring-arm"), "r as a function of t")
    assert [to_machine(node) for node in answer.valid] == ["k - m*Omega**2 > 0"]
